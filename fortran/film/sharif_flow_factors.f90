!> Flow factors D along and C across the sliding of a film of known shear stress (Sharif, Kong, Evans and Snidle 2001,
!> eqs 13a and 14a).
module pyworm_sharif_flow_factors
  use pyworm_flow_laws, only: flow_law, thinning
  use pyworm_gauss_lobatto, only: levels_across
  use pyworm_kinds, only: wp
  use pyworm_strip_of_points, only: shear_strip
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
    real(wp), dimension(strip%points) :: stress_s, stress_r, drop_s, drop_r
    integer :: i

    do i = 1, strip%points
      call unit_vector(strip%us(i), strip%vs(i), strip%px(i), strip%py(i), cosine(i), sine(i))
      stress_s(i) = cosine(i)*strip%tau_x(i) + sine(i)*strip%tau_y(i)
      stress_r(i) = cosine(i)*strip%tau_y(i) - sine(i)*strip%tau_x(i)
      drop_s(i) = (cosine(i)*strip%px(i) + sine(i)*strip%py(i))*strip%film(i)
      drop_r(i) = (cosine(i)*strip%py(i) - sine(i)*strip%px(i))*strip%film(i)
    end do
    call flow_factor(law, levels, strip, strip%points, stress_s, drop_s, stress_r, drop_r, factor_s, lag_s)
    call flow_factor(law, levels, strip, strip%points, stress_r, drop_r, stress_s, drop_s, factor_r, lag_r)
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

  !> Flow factors and lags of `m` points along the direction of `stress` and of the `drop` h dp [Pa] of stress
  !> across the film; `stress_across` and `drop_across` are those in the other direction.
  pure subroutine flow_factor(law, levels, strip, m, stress, drop, stress_across, drop_across, factor, lag)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(in) :: strip
    integer, intent(in) :: m
    real(wp), intent(in) :: stress(m), drop(m), stress_across(m), drop_across(m)
    real(wp), intent(out) :: factor(m), lag(m)
    !> Least drop, over the stress halfway, that a difference resolves; below it the factor at that drop is
    !> taken.
    real(wp), parameter :: least_drop = 1e-4_wp
    real(wp), dimension(m) :: resolved, per_reference, per_limit, with, square, square_without, g, g_without, slope
    real(wp) :: across, weight
    integer :: i, k

    do i = 1, m
      per_reference(i) = 1/strip%reference(i)**2
      per_limit(i) = 1/strip%limit(i)**2
      resolved(i) = sign(max(abs(drop(i)), least_drop*sqrt(stress(i)**2 + stress_across(i)**2), sqrt(tiny(drop))), drop(i))
    end do
    factor = 0
    lag = 0
    do k = 1, levels%count
      do i = 1, m
        with(i) = stress(i) + levels%z(k)*resolved(i)
        across = (stress_across(i) + levels%z(k)*drop_across(i))**2
        square(i) = with(i)**2 + across
        square_without(i) = stress(i)**2 + across
      end do
      call thinning(law, m, square, per_reference, per_limit, g, slope)
      call thinning(law, m, square_without, per_reference, per_limit, g_without, slope)
      do i = 1, m
        weight = levels%weight(k)*levels%z(k)*strip%film(i)*strip%fluidity(i, k)
        lag(i) = lag(i) + weight*g_without(i)*stress(i)
        factor(i) = factor(i) + weight*(g(i)*with(i) - g_without(i)*stress(i))
      end do
    end do
    do i = 1, m
      factor(i) = factor(i)*strip%film(i)**2/resolved(i)
    end do
  end subroutine flow_factor

end module pyworm_sharif_flow_factors
