!> Flow factors D along and C across the sliding of a film of known shear stress (Sharif, Kong, Evans and Snidle 2001,
!> eqs 13a and 14a).
module sharif_flow_factors
  use flow_laws, only: flow_law, thinning
  use gauss_lobatto, only: levels_across
  use kinds, only: wp
  use strip_of_points, only: shear_strip
  implicit none(type, external)
  private

  public :: flow_factors

contains

  !> Flow factors [m3/(Pa s)] along the sliding, `factor_s`, and across it, `factor_r`, and the lag (lag_s, lag_r)
  !> [m/s] of the entrainment behind the mean velocity of the bodies by viscosity varying across the film, such that
  !> the flow is (u - lag) h - factor dp along each direction (Sharif et al., eqs 13a to 16).
  !> Direction s is (cosine, sine), that of the sliding or, without it, that of the pressure gradient.
  !>
  !> The flows without one gradient are those at the same stress halfway, as in the arguments of eqs 13a to
  !> 16.
  pure subroutine flow_factors(law, levels, strip, cosine, sine, factor_s, factor_r, lag_s, lag_r)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(in) :: strip
    real(wp), contiguous, intent(out) :: cosine(:), sine(:), factor_s(:), factor_r(:), lag_s(:), lag_r(:)
    real(wp) :: stress(2), drop(2)
    integer :: i

    do i = 1, strip%points
      call unit_vector(strip%us(i), strip%vs(i), strip%px(i), strip%py(i), cosine(i), sine(i))
      stress = [cosine(i)*strip%tau_x(i) + sine(i)*strip%tau_y(i), cosine(i)*strip%tau_y(i) - sine(i)*strip%tau_x(i)]
      drop = [cosine(i)*strip%px(i) + sine(i)*strip%py(i), cosine(i)*strip%py(i) - sine(i)*strip%px(i)]*strip%film(i)
      call flow_factor(law, levels, strip, i, stress(1), drop(1), stress(2), drop(2), factor_s(i), lag_s(i))
      call flow_factor(law, levels, strip, i, stress(2), drop(2), stress(1), drop(1), factor_r(i), lag_r(i))
    end do
  end subroutine flow_factors

  !> Direction of the first of two vectors that is not zero, or x.
  pure subroutine unit_vector(us, vs, px, py, cosine, sine)
    real(wp), intent(in) :: us, vs, px, py
    real(wp), intent(out) :: cosine, sine

    cosine = 1
    sine = 0
    if (hypot(us, vs) > 0) then
      cosine = us/hypot(us, vs)
      sine = vs/hypot(us, vs)
    else if (hypot(px, py) > 0) then
      cosine = px/hypot(px, py)
      sine = py/hypot(px, py)
    end if
  end subroutine unit_vector

  !> Flow factor and lag of point i along the direction of `stress` and of the `drop` h dp [Pa] of stress
  !> across the film; `stress_across` and `drop_across` are those in the other direction.
  pure subroutine flow_factor(law, levels, strip, i, stress, drop, stress_across, drop_across, factor, lag)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(in) :: strip
    integer, intent(in) :: i
    real(wp), intent(in) :: stress, drop, stress_across, drop_across
    real(wp), intent(out) :: factor, lag
    !> Least drop, over the stress halfway, that a difference resolves; below it the factor at that drop is
    !> taken.
    real(wp), parameter :: least_drop = 1e-4_wp
    real(wp) :: across(levels%count), with(levels%count), without(levels%count), weight(levels%count), resolved
    real(wp), dimension(levels%count) :: per_reference, per_limit, g, g_without, slope

    per_reference = 1/strip%reference(i)**2
    per_limit = 1/strip%limit(i)**2
    resolved = sign(max(abs(drop), least_drop*hypot(stress, stress_across), sqrt(tiny(drop))), drop)
    across = (stress_across + levels%z*drop_across)**2
    with = stress + levels%z*resolved
    without = stress
    call thinning(law, levels%count, with**2 + across, per_reference, per_limit, g, slope)
    call thinning(law, levels%count, without**2 + across, per_reference, per_limit, g_without, slope)
    weight = levels%weight*levels%z*strip%film(i)*strip%fluidity(i, :)
    lag = sum(weight*g_without*without)
    factor = sum(weight*(g*with - g_without*without))*strip%film(i)**2/resolved
  end subroutine flow_factor

end module sharif_flow_factors
