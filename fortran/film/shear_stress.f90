!> Shear stress of an oil between two sliding walls under a pressure gradient.
!>
!> Shear stress is linear across the film, tau = tau_m + z h grad p with z from -1/2 at body 1 to 1/2 at body
!> 2, and the rate of shear f g(tau^2) tau with the fluidity f and the thinning g of the flow law (Sharif,
!> Kong, Evans and Snidle 2001, eqs 3-9). The stress tau_m halfway makes the rates add up to the sliding. It
!> is the least point of a strictly convex potential, so that it exists, is unique, and Newton's method has a
!> positive definite matrix: with K = f (g I + 2 g' tau tau^T), of which all derivatives here are made,
!>
!>   A = int K dz',  B = int z' K dz',  C = int z'^2 K dz',  z' = h z.
!>
!> Points are solved a strip at a time, so that loops are over points. Fluidity is constant in all derivatives
!> by film, gradient and stresses.
module pyworm_shear_stress
  use pyworm_flow_laws, only: flow_law, law_newton, has_limit, slip_stress, thinning, stress_guess
  use pyworm_gauss_lobatto, only: levels_across
  use pyworm_kinds, only: wp
  use pyworm_strip_of_points, only: shear_strip, slip_at_body_1, slip_at_body_2
  implicit none(type, external)
  private

  public :: solve_shear, square_stress

  !> Missing velocity, relative to the summed rates of shear, before the last Newton step. Convergence is
  !> quadratic: the errors of stresses, flow and heat are then of its square, those of their derivatives of its
  !> first power.
  real(wp), parameter :: tolerance = 1e-5_wp
  !> Largest numbers of Newton steps of all points together, and then of each remaining one with a line search.
  integer, parameter :: steps_together = 8, steps_alone = 50, search_steps = 60
  !> Fraction of points, one over this, that is solved one by one: a step of all points costs about as much.
  integer, parameter :: few = 16

contains

  !> Solves for stress halfway, thinning and slip of a strip; `failures` counts the points where Newton's method did
  !> not converge.
  pure subroutine solve_shear(law, levels, strip, failures)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    integer, intent(out) :: failures
    logical :: converged
    integer :: i, step, left

    failures = 0
    if (law%law == law_newton) then
      call solve_newtonian(levels, strip)
      return
    end if
    strip%per_reference = 1/strip%reference**2
    strip%per_limit = 1/strip%limit**2
    call guess_stress(law, levels, strip)
    do step = 1, steps_together
      call sum_rates(law, levels, strip, 1, strip%points)
      call newton_step(strip, 1, strip%points)
      left = count(.not. strip%excess(:strip%points) <= 0)
      if (left*few <= strip%points .or. step == steps_together) exit
      call bounded_move(law, strip)
    end do
    do i = 1, strip%points
      if (strip%excess(i) <= 0) cycle
      call solve_alone(law, levels, strip, i, converged)
      if (.not. converged) failures = failures + 1
    end do
    call finish(levels, strip)
    call find_slip(law, strip)
  end subroutine solve_shear

  !> A Newtonian oil's stress in closed form.
  pure subroutine solve_newtonian(levels, strip)
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    integer :: i, k

    associate (s => strip, mean => strip%a_xx, moment => strip%a_xy)
      mean = 0
      moment = 0
      do k = 1, levels%count
        do i = 1, s%points
          mean(i) = mean(i) + levels%weight(k)*s%fluidity(i, k)
          moment(i) = moment(i) + levels%weight(k)*levels%z(k)*s%fluidity(i, k)
        end do
      end do
      do i = 1, s%points
        s%inverse_xx(i) = 1/(s%film(i)*mean(i))
        s%tau_x(i) = s%inverse_xx(i)*(s%us(i) - s%film(i)**2*moment(i)*s%px(i))
        s%tau_y(i) = s%inverse_xx(i)*(s%vs(i) - s%film(i)**2*moment(i)*s%py(i))
      end do
      s%inverse_yy = s%inverse_xx
      s%inverse_xy = 0
      s%g = 1
      s%g_slope = 0
      s%slip = 0
    end associate
  end subroutine solve_newtonian

  !> Sets the initial stress where none is given, from the film's mean fluidity without gradient.
  pure subroutine guess_stress(law, levels, strip)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    real(wp) :: sliding, newtonian
    integer :: i

    do i = 1, strip%points
      if (abs(strip%tau_x(i)) + abs(strip%tau_y(i)) > 0) cycle
      sliding = hypot(strip%us(i), strip%vs(i))
      if (.not. sliding > 0) cycle
      newtonian = sliding/(strip%film(i)*sum(levels%weight*strip%fluidity(i, :)))
      newtonian = stress_guess(law, newtonian, strip%reference(i), strip%limit(i))
      strip%tau_x(i) = newtonian*strip%us(i)/sliding
      strip%tau_y(i) = newtonian*strip%vs(i)/sliding
    end do
  end subroutine guess_stress

  !> Computes thinning of some points, the missing velocity, A, the power of shear [W/m2], and int f g dz'
  !> [m/(Pa s)].
  pure subroutine sum_rates(law, levels, strip, first, last)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    integer, intent(in) :: first, last
    integer :: k

    associate (s => strip)
      s%rest_x(first:last) = s%us(first:last)
      s%rest_y(first:last) = s%vs(first:last)
      s%a_xx(first:last) = 0
      s%a_xy(first:last) = 0
      s%a_yy(first:last) = 0
      s%power(first:last) = 0
      s%ease(first:last) = 0
      do k = 1, levels%count
        call square_stress(last - first + 1, levels%z(k), s%film(first:last), s%px(first:last), s%py(first:last), &
          s%tau_x(first:last), s%tau_y(first:last), s%square(first:last))
        call thinning(law, last - first + 1, s%square(first:last), s%per_reference(first:last), &
          s%per_limit(first:last), s%g(first:last, k), s%g_slope(first:last, k))
        call add_rate(levels, k, s, first, last)
      end do
    end associate
  end subroutine sum_rates

  !> Square of the stress at a level.
  pure subroutine square_stress(count, z, film, px, py, tau_x, tau_y, square)
    integer, intent(in) :: count
    real(wp), intent(in) :: z, film(count), px(count), py(count), tau_x(count), tau_y(count)
    real(wp), intent(out) :: square(count)

    square = (tau_x + z*film*px)**2 + (tau_y + z*film*py)**2
  end subroutine square_stress

  !> Adds a level to the sums over the film.
  pure subroutine add_rate(levels, level, strip, first, last)
    type(levels_across), intent(in) :: levels
    integer, intent(in) :: level, first, last
    type(shear_strip), intent(inout) :: strip
    real(wp) :: z, weight, x, y, along, across
    integer :: i

    z = levels%z(level)
    weight = levels%weight(level)
    associate (s => strip)
      do i = first, last
        x = s%tau_x(i) + z*s%film(i)*s%px(i)
        y = s%tau_y(i) + z*s%film(i)*s%py(i)
        ! A = int f (g I + 2 g' tau tau^T) dz', g' by the square of the stress tau
        along = weight*s%film(i)*s%fluidity(i, level)*s%g(i, level)
        across = 2*weight*s%film(i)*s%fluidity(i, level)*s%g_slope(i, level)
        s%rest_x(i) = s%rest_x(i) - along*x
        s%rest_y(i) = s%rest_y(i) - along*y
        s%a_xx(i) = s%a_xx(i) + along + across*x*x
        s%a_xy(i) = s%a_xy(i) + across*x*y
        s%a_yy(i) = s%a_yy(i) + along + across*y*y
        s%power(i) = s%power(i) + along*(x*x + y*y)
        s%ease(i) = s%ease(i) + along
      end do
    end associate
  end subroutine add_rate

  !> Inverse of A of some points.
  pure subroutine invert(strip, first, last)
    type(shear_strip), intent(inout) :: strip
    integer, intent(in) :: first, last
    real(wp) :: determinant
    integer :: i

    do i = first, last
      determinant = strip%a_xx(i)*strip%a_yy(i) - strip%a_xy(i)**2
      strip%inverse_xx(i) = strip%a_yy(i)/determinant
      strip%inverse_xy(i) = -strip%a_xy(i)/determinant
      strip%inverse_yy(i) = strip%a_xx(i)/determinant
    end do
  end subroutine invert

  !> Computes the Newton step of some points, and the excess of their squared missing velocity over that at which the
  !> step is the last.
  pure subroutine newton_step(strip, first, last)
    type(shear_strip), intent(inout) :: strip
    integer, intent(in) :: first, last
    integer :: i

    call invert(strip, first, last)
    do i = first, last
      strip%step_x(i) = strip%inverse_xx(i)*strip%rest_x(i) + strip%inverse_xy(i)*strip%rest_y(i)
      strip%step_y(i) = strip%inverse_xy(i)*strip%rest_x(i) + strip%inverse_yy(i)*strip%rest_y(i)
      ! Schwarz: the sum of the rates' magnitudes is at most the root of power times ease
      strip%excess(i) = strip%rest_x(i)**2 + strip%rest_y(i)**2 - tolerance**2*strip%power(i)*strip%ease(i)
    end do
  end subroutine newton_step

  !> Moves all points along their Newton steps.
  !>
  !> A step far beyond the present stresses is shortened, since rates grow exponentially, and walls approach the
  !> limiting stress, if there is one, by fractions of their distance to it (Sharif et al., text to
  !> fig. 4).
  pure subroutine bounded_move(law, strip)
    type(flow_law), intent(in) :: law
    type(shear_strip), intent(inout) :: strip
    !> Fraction of the distance to slip. The least move is that in which the slip grows e-fold.
    real(wp), parameter :: approach = 0.8_wp
    real(wp) :: half_x, half_y, extreme, room, length, bound
    integer :: i

    do i = 1, strip%points
      half_x = strip%film(i)*strip%px(i)/2
      half_y = strip%film(i)*strip%py(i)/2
      extreme = sqrt(max((strip%tau_x(i) + half_x)**2 + (strip%tau_y(i) + half_y)**2, &
        (strip%tau_x(i) - half_x)**2 + (strip%tau_y(i) - half_y)**2))
      bound = merge(slip_stress(strip%limit(i)), huge(bound), has_limit(law))
      room = min(extreme + 2*strip%reference(i), max(approach*(bound - extreme), law%slip_step*bound))
      length = sqrt(strip%step_x(i)**2 + strip%step_y(i)**2)
      strip%tau_x(i) = strip%tau_x(i) + room/max(length, room)*strip%step_x(i)
      strip%tau_y(i) = strip%tau_y(i) + room/max(length, room)*strip%step_y(i)
    end do
  end subroutine bounded_move

  !> Solves one point by Newton's method with a line search, from the sums and the step at its stress.
  !>
  !> Along a path the slope of the potential is minus the path's direction times the missing velocity: a step is
  !> accepted when the slope is halved, and shortened when it has overshot.
  pure subroutine solve_alone(law, levels, strip, i, converged)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    integer, intent(in) :: i
    logical, intent(out) :: converged
    real(wp) :: centre(2)
    logical :: turns
    integer :: newton

    call find_centre(law, strip, i, centre, turns)
    if (turns .and. hypot(strip%rest_x(i), strip%rest_y(i)) > hypot(strip%us(i), strip%vs(i))) then
      ! a wall slips too fast and Newton steps are short: return to the origin, where both walls of a film that
      ! bears its gradient are below the limit
      strip%tau_x(i) = 0
      strip%tau_y(i) = 0
      call sum_rates(law, levels, strip, i, i)
      call newton_step(strip, i, i)
    end if
    do newton = 1, steps_alone
      converged = strip%excess(i) <= 0
      if (converged) return
      call search_along(law, levels, strip, i)
      call newton_step(strip, i, i)
    end do
    converged = strip%excess(i) <= 0
    if (converged) return
    strip%step_x(i) = 0
    strip%step_y(i) = 0
  end subroutine solve_alone

  !> Moves one point along its Newton step, by the fraction at which the slope of the potential is halved, found by halving.
  pure subroutine search_along(law, levels, strip, i)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    integer, intent(in) :: i
    real(wp) :: from(2), step(2), centre(2), to(2), direction(2), fraction, longest, low, high, descent, slope
    logical :: turns
    integer :: search

    from = [strip%tau_x(i), strip%tau_y(i)]
    step = [strip%step_x(i), strip%step_y(i)]
    descent = strip%rest_x(i)*step(1) + strip%rest_y(i)*step(2)
    call find_centre(law, strip, i, centre, turns)
    fraction = 1
    if (has_limit(law)) then
      ! not less than an e-fold of the slip
      longest = max(1.0_wp, law%slip_step)*strip%limit(i)
      fraction = longest/max(norm2(step), longest)
    end if
    low = 0
    high = 0
    do search = 1, search_steps
      if (turns) then
        call turn(from - centre, step, fraction, to, direction)
        to = to + centre
      else
        to = from + fraction*step
        direction = step
      end if
      strip%tau_x(i) = to(1)
      strip%tau_y(i) = to(2)
      call sum_rates(law, levels, strip, i, i)
      slope = -(strip%rest_x(i)*direction(1) + strip%rest_y(i)*direction(2))
      if (abs(slope) <= descent/2) exit
      if (slope > 0) then
        high = fraction
      else
        low = fraction
        if (.not. high > 0) exit
      end if
      fraction = low + (high - low)*merge(0.5_wp, 0.1_wp, low > 0)
    end do
  end subroutine search_along

  !> Finds the stress halfway at which the more stressed wall has no stress; `turns` if that wall is near slip, where
  !> stresses can only rotate about it.
  pure subroutine find_centre(law, strip, i, centre, turns)
    type(flow_law), intent(in) :: law
    type(shear_strip), intent(in) :: strip
    integer, intent(in) :: i
    real(wp), intent(out) :: centre(2)
    logical, intent(out) :: turns
    !> Fraction of the stress at slip above which a wall is near slip.
    real(wp), parameter :: near = 0.9_wp
    real(wp) :: middle(2), half(2)

    middle = [strip%tau_x(i), strip%tau_y(i)]
    half = [strip%px(i), strip%py(i)]*strip%film(i)/2
    centre = sign(1.0_wp, -dot_product(middle, half))*half
    turns = has_limit(law) .and. norm2(middle - centre) > near*slip_stress(strip%limit(i))
  end subroutine find_centre

  !> End `to` of a fraction of a step whose part along `from` is straight and whose other part turns about the
  !> origin, and its derivative `direction` by the fraction.
  pure subroutine turn(from, step, fraction, to, direction)
    real(wp), intent(in) :: from(2), step(2), fraction
    real(wp), intent(out) :: to(2), direction(2)
    real(wp) :: radius, along, across, angle, radial(2), tangent(2)

    radius = norm2(from)
    along = dot_product(from, step)/radius
    across = (from(1)*step(2) - from(2)*step(1))/radius
    angle = fraction*across/radius
    radial = [from(1)*cos(angle) - from(2)*sin(angle), from(2)*cos(angle) + from(1)*sin(angle)]/radius
    tangent = [-radial(2), radial(1)]
    to = (radius + fraction*along)*radial
    direction = along*radial + (radius + fraction*along)*across/radius*tangent
  end subroutine turn

  !> Makes the last Newton step, with thinning to first order, after which the rates add up to the sliding. A is
  !> summed again, since in the mobility of a film that slips it cancels against B and C to a few digits.
  pure subroutine finish(levels, strip)
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    real(wp) :: x, y, weight, along, across
    integer :: i, k

    associate (s => strip)
      do i = 1, s%points
        s%tau_x(i) = s%tau_x(i) + s%step_x(i)
        s%tau_y(i) = s%tau_y(i) + s%step_y(i)
      end do
      s%a_xx = 0
      s%a_xy = 0
      s%a_yy = 0
      do k = 1, levels%count
        do i = 1, s%points
          x = s%tau_x(i) + levels%z(k)*s%film(i)*s%px(i)
          y = s%tau_y(i) + levels%z(k)*s%film(i)*s%py(i)
          s%g(i, k) = s%g(i, k) &
            + 2*s%g_slope(i, k)*((x - s%step_x(i))*s%step_x(i) + (y - s%step_y(i))*s%step_y(i))
          weight = levels%weight(k)*s%film(i)*s%fluidity(i, k)
          along = weight*s%g(i, k)
          across = 2*weight*s%g_slope(i, k)
          s%a_xx(i) = s%a_xx(i) + along + across*x*x
          s%a_xy(i) = s%a_xy(i) + across*x*y
          s%a_yy(i) = s%a_yy(i) + along + across*y*y
        end do
      end do
    end associate
    call invert(strip, 1, strip%points)
  end subroutine finish

  !> Marks the walls beyond the stress at slip.
  pure subroutine find_slip(law, strip)
    type(flow_law), intent(in) :: law
    type(shear_strip), intent(inout) :: strip
    real(wp) :: half_x, half_y, bound
    integer :: i

    strip%slip = 0
    if (.not. has_limit(law)) return
    do i = 1, strip%points
      half_x = strip%film(i)*strip%px(i)/2
      half_y = strip%film(i)*strip%py(i)/2
      bound = slip_stress(strip%limit(i))**2
      if ((strip%tau_x(i) - half_x)**2 + (strip%tau_y(i) - half_y)**2 > bound) strip%slip(i) = slip_at_body_1
      if ((strip%tau_x(i) + half_x)**2 + (strip%tau_y(i) + half_y)**2 > bound) then
        strip%slip(i) = strip%slip(i) + slip_at_body_2
      end if
    end do
  end subroutine find_slip

end module pyworm_shear_stress
