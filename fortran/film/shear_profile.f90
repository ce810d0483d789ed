!> Velocity, slip, rate of shear and heat across a film whose shear stress is known.
module pyworm_shear_profile
  use pyworm_flow_laws, only: flow_law, slip_stress, thinning
  use pyworm_gauss_lobatto, only: levels_across
  use pyworm_kinds, only: wp
  use pyworm_strip_of_points, only: shear_strip, slip_at_body_1
  implicit none(type, external)
  private

  public :: film_velocity, film_shear_rate, film_heat, wall_slip

contains

  !> Velocity (u, v) [m/s] of the oil at the levels, from that of body 1 (u1, v1); at the walls that of the
  !> bodies, even where the oil next to them slips.
  pure subroutine film_velocity(law, levels, strip, u1, v1, u, v)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    real(wp), contiguous, intent(in) :: u1(:), v1(:)
    real(wp), contiguous, intent(out) :: u(:, :), v(:, :)
    real(wp) :: weight, slip_x, slip_y
    integer :: i, k, l, n

    n = levels%count
    do k = 1, n
      u(:strip%points, k) = u1(:strip%points)
      v(:strip%points, k) = v1(:strip%points)
    end do
    do i = 1, strip%points
      if (iand(strip%slip(i), slip_at_body_1) == 0) cycle
      call wall_slip(law, levels, strip, i, 1, slip_x, slip_y)
      u(i, 2:) = u(i, 2:) + slip_x
      v(i, 2:) = v(i, 2:) + slip_y
    end do
    do l = 1, n
      do i = 1, strip%points
        weight = strip%film(i)*strip%fluidity(i, l)*strip%g(i, l)
        strip%step_x(i) = weight*(strip%tau_x(i) + levels%z(l)*strip%film(i)*strip%px(i))
        strip%step_y(i) = weight*(strip%tau_y(i) + levels%z(l)*strip%film(i)*strip%py(i))
      end do
      if (l == 1 .or. l == n) call take_slip(law, levels, strip, l)
      do k = 2, n - 1
        do i = 1, strip%points
          u(i, k) = u(i, k) + levels%integral(k, l)*strip%step_x(i)
          v(i, k) = v(i, k) + levels%integral(k, l)*strip%step_y(i)
        end do
      end do
    end do
    u(:strip%points, n) = u1(:strip%points) + strip%us(:strip%points)
    v(:strip%points, n) = v1(:strip%points) + strip%vs(:strip%points)
  end subroutine film_velocity

  !> Subtracts slip from the velocities across the film, where a wall's rate of shear includes it.
  pure subroutine take_slip(law, levels, strip, wall)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    integer, intent(in) :: wall
    real(wp) :: slip_x, slip_y
    integer :: i

    do i = 1, strip%points
      if (strip%slip(i) == 0) cycle
      call wall_slip(law, levels, strip, i, wall, slip_x, slip_y)
      strip%step_x(i) = strip%step_x(i) - slip_x/levels%weight(wall)
      strip%step_y(i) = strip%step_y(i) - slip_y/levels%weight(wall)
    end do
  end subroutine take_slip

  !> Slip velocity [m/s] of point i at the wall whose level is given, by the excess of its rate over that at the
  !> stress of slip. Its product with the wall's shear stress is heat [W/m2] that `film_heat` counts
  !> at that level.
  pure subroutine wall_slip(law, levels, strip, i, wall, slip_x, slip_y)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(in) :: strip
    integer, intent(in) :: i, wall
    real(wp), intent(out) :: slip_x, slip_y
    real(wp) :: bound, x, y, stress, g(1), slope(1), excess

    slip_x = 0
    slip_y = 0
    if (strip%slip(i) == 0) return
    bound = slip_stress(strip%limit(i))
    x = strip%tau_x(i) + levels%z(wall)*strip%film(i)*strip%px(i)
    y = strip%tau_y(i) + levels%z(wall)*strip%film(i)*strip%py(i)
    stress = hypot(x, y)
    if (stress <= bound) return
    call thinning(law, 1, [bound**2], strip%per_reference(i:i), strip%per_limit(i:i), g, slope)
    excess = levels%weight(wall)*strip%film(i)*strip%fluidity(i, wall)*(strip%g(i, wall) - g(1)*bound/stress)
    slip_x = excess*x
    slip_y = excess*y
  end subroutine wall_slip

  !> Rate of shear [1/s] at the levels.
  pure subroutine film_shear_rate(levels, strip, rate)
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(in) :: strip
    real(wp), contiguous, intent(out) :: rate(:, :)
    integer :: i, k

    do k = 1, levels%count
      do i = 1, strip%points
        rate(i, k) = strip%fluidity(i, k)*strip%g(i, k)*sqrt( &
          (strip%tau_x(i) + levels%z(k)*strip%film(i)*strip%px(i))**2 &
          + (strip%tau_y(i) + levels%z(k)*strip%film(i)*strip%py(i))**2)
      end do
    end do
  end subroutine film_shear_rate

  !> Heat of shear f g tau^2 [W/m3] at the levels, a mean over the area, and its derivatives by their fluidity f at given sliding:
  !> at level k by that at level l, own(k) where k = l, less response_x(k) stress_x(l) + response_y(k)
  !> stress_y(l).
  !>
  !> `own` [Pa2], `response` = 2 f (g + g' tau^2) tau [1/s], and `stress` [Pa2 s], the decrease of the
  !> stress halfway.
  pure subroutine film_heat(levels, strip, heat, own, response_x, response_y, stress_x, stress_y)
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(in) :: strip
    real(wp), contiguous, intent(out) :: heat(:, :), own(:, :), response_x(:, :), response_y(:, :), stress_x(:, :), &
      stress_y(:, :)
    real(wp) :: x, y, square, response, weight
    integer :: i, k

    do k = 1, levels%count
      do i = 1, strip%points
        x = strip%tau_x(i) + levels%z(k)*strip%film(i)*strip%px(i)
        y = strip%tau_y(i) + levels%z(k)*strip%film(i)*strip%py(i)
        square = x*x + y*y
        own(i, k) = strip%wetted(i)*strip%g(i, k)*square
        heat(i, k) = strip%fluidity(i, k)*own(i, k)
        response = 2*strip%wetted(i)*strip%fluidity(i, k)*(strip%g(i, k) + strip%g_slope(i, k)*square)
        response_x(i, k) = response*x
        response_y(i, k) = response*y
        weight = levels%weight(k)*strip%film(i)*strip%g(i, k)
        stress_x(i, k) = weight*(strip%inverse_xx(i)*x + strip%inverse_xy(i)*y)
        stress_y(i, k) = weight*(strip%inverse_xy(i)*x + strip%inverse_yy(i)*y)
      end do
    end do
  end subroutine film_heat

end module pyworm_shear_profile
