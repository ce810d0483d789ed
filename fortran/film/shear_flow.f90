!> Flow of an oil between two sliding walls under a pressure gradient, with its exact derivatives.
!>
!> Shear stress is linear across the film, tau = tau_m + z h grad p with z from -1/2 at body 1 to 1/2 at body
!> 2, and the rate of shear f g(tau^2) tau with the fluidity f and the thinning g of the flow law (Sharif,
!> Kong, Evans and Snidle 2001, eqs 3-9). The stress tau_m halfway makes the rates add up to the sliding. It
!> is the least point of a strictly convex potential, so that it exists, is unique, and Newton's method has a
!> positive definite matrix: with K = f (g I + 2 g' tau tau^T), of which all derivatives here are made,
!>
!>   A = int K dz',  B = int z' K dz',  C = int z'^2 K dz',  z' = h z.
!>
!> Points are worked on a strip at a time, so that loops run over points. Fluidity is held in all derivatives
!> by film, gradient and stresses.
module shear_flow
  use kinds, only: wp
  use gauss_lobatto, only: levels_across
  use flow_laws, only: flow_law, law_newton, has_limit, slip_stress, thinning, thinning_by_stresses, stress_guess
  use status, only: status_ok, status_no_memory
  implicit none(type, external)
  private

  public :: shear_strip, new_shear_strip, solve_shear, flow_deficit, flow_change, flow_change_by_stresses, &
    film_velocity, film_shear_rate, film_heat, wall_slip, flow_factors

  !> Bits of a point's slip.
  integer, parameter, public :: slip_at_body_1 = 1, slip_at_body_2 = 2

  !> Velocity that a film may lack, relative to the rates of shear summed over it, before the last Newton
  !> step. Convergence is quadratic: stresses, flow and heat are then right to its square, their derivatives
  !> to itself.
  real(wp), parameter :: tolerance = 1e-5_wp
  !> Newton steps of all points together, and then of each one that is left, with a line search.
  integer, parameter :: steps_together = 8, steps_alone = 50, search_steps = 60
  !> One point of so many may be left to be solved alone: a step of all costs about as much.
  integer, parameter :: few = 16

  !> Points of a film, and its levels as second index.
  type :: shear_strip
    !> Points in use, at most as many as there is space for.
    integer :: points = 0
    !> Points whose stress was not found, counted by the callers, who also begin anew.
    integer :: unsolved = 0
    !> To be set: film [m], pressure gradient [Pa/m], velocity of body 2 over body 1 [m/s], reference and
    !> limiting stress [Pa] of the flow law, and fluidity 1/eta [1/(Pa s)] at the levels.
    real(wp), allocatable :: film(:), px(:), py(:), us(:), vs(:), reference(:), limit(:), fluidity(:, :)
    !> Stress halfway [Pa]: a guess, or zero for none, and then the solution.
    real(wp), allocatable :: tau_x(:), tau_y(:)
    !> Where the film slips: 0, slip_at_body_1, slip_at_body_2, or their sum.
    integer, allocatable :: slip(:)
    !> Thinning [-] at the levels and its derivative by the square of the stress [1/Pa2].
    real(wp), allocatable :: g(:, :), g_slope(:, :)
    !> Inverse of the kinematic matrix A [Pa s/m].
    real(wp), allocatable :: inverse_xx(:), inverse_xy(:), inverse_yy(:)
    !> B A^-1 [m], how the flow follows the lacking velocity; set by `flow_change`.
    real(wp), allocatable :: arm_xx(:), arm_xy(:), arm_yx(:), arm_yy(:)
    !> For the callers' use: fields of the levels.
    real(wp), allocatable :: level_x(:, :), level_y(:, :)
    !> Scratch: reciprocal squares of the law's stresses, squares of the stress, sums over the film, a step.
    real(wp), allocatable :: per_reference(:), per_limit(:), square(:), rest_x(:), rest_y(:), power(:), ease(:), a_xx(:), a_xy(:), &
      a_yy(:), step_x(:), step_y(:), excess(:)
  end type shear_strip

contains

  !> Space for strips of up to `points` points with `levels` levels.
  subroutine new_shear_strip(points, levels, strip, stat)
    integer, intent(in) :: points, levels
    type(shear_strip), intent(out) :: strip
    integer, intent(out) :: stat
    integer :: err

    allocate (strip%film(points), strip%px(points), strip%py(points), strip%us(points), strip%vs(points), &
      strip%reference(points), strip%limit(points), strip%fluidity(points, levels), strip%tau_x(points), &
      strip%tau_y(points), strip%slip(points), strip%g(points, levels), strip%g_slope(points, levels), &
      strip%inverse_xx(points), strip%inverse_xy(points), strip%inverse_yy(points), strip%arm_xx(points), &
      strip%arm_xy(points), strip%arm_yx(points), strip%arm_yy(points), strip%square(points), &
      strip%rest_x(points), strip%rest_y(points), strip%power(points), strip%ease(points), strip%a_xx(points), strip%a_xy(points), &
      strip%a_yy(points), strip%step_x(points), strip%step_y(points), strip%excess(points), &
      strip%per_reference(points), strip%per_limit(points), strip%level_x(points, levels), strip%level_y(points, levels), &
      stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
    if (stat /= status_ok) return
    strip%points = points
    strip%tau_x = 0
    strip%tau_y = 0
    strip%reference = 1
    strip%limit = 1
  end subroutine new_shear_strip

  !> Stress halfway, thinning and slip of a strip; `failures` counts the points where Newton's method did not
  !> converge.
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
      call bounded_move(has_limit(law), strip)
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

  !> Where no stress is given: that of the film's mean fluidity without gradient.
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

  !> Thinning of some points, the velocity that the film lacks, A, the power of shear [W/m2], and int f g dz'
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
        call add_rate(last - first + 1, levels%z(k), levels%weight(k), s%film(first:last), s%px(first:last), &
          s%py(first:last), s%tau_x(first:last), s%tau_y(first:last), s%fluidity(first:last, k), s%g(first:last, k), &
          s%g_slope(first:last, k), s%rest_x(first:last), s%rest_y(first:last), s%a_xx(first:last), s%a_xy(first:last), &
          s%a_yy(first:last), s%power(first:last), s%ease(first:last))
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

  !> What a level adds to the sums over the film.
  pure subroutine add_rate(count, z, weight, film, px, py, tau_x, tau_y, fluidity, g, slope, rest_x, rest_y, a_xx, a_xy, &
    a_yy, power, ease)
    integer, intent(in) :: count
    real(wp), intent(in) :: z, weight, film(count), px(count), py(count), tau_x(count), tau_y(count), fluidity(count), &
      g(count), slope(count)
    real(wp), intent(inout) :: rest_x(count), rest_y(count), a_xx(count), a_xy(count), a_yy(count), power(count), &
      ease(count)
    real(wp) :: x, y, along, across
    integer :: i

    do i = 1, count
      x = tau_x(i) + z*film(i)*px(i)
      y = tau_y(i) + z*film(i)*py(i)
      along = weight*film(i)*fluidity(i)*g(i)
      across = 2*weight*film(i)*fluidity(i)*slope(i)
      rest_x(i) = rest_x(i) - along*x
      rest_y(i) = rest_y(i) - along*y
      a_xx(i) = a_xx(i) + along + across*x*x
      a_xy(i) = a_xy(i) + across*x*y
      a_yy(i) = a_yy(i) + along + across*y*y
      power(i) = power(i) + along*(x*x + y*y)
      ease(i) = ease(i) + along
    end do
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

  !> Newton's step of some points, and by what the velocity they lack, squared, is too much for the step to be
  !> the last.
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
  !> A step much beyond the stresses met so far would overshoot where rates grow exponentially, and walls
  !> approach the limiting stress, if there is one, in shares of their distance to it (Sharif et al., text to
  !> fig. 4).
  pure subroutine bounded_move(limited, strip)
    logical, intent(in) :: limited
    type(shear_strip), intent(inout) :: strip
    !> Share of the distance to slip, and least move in shares of the stress there.
    real(wp), parameter :: approach = 0.8_wp, least = 1e-3_wp
    real(wp) :: half_x, half_y, extreme, room, length, bound
    integer :: i

    do i = 1, strip%points
      half_x = strip%film(i)*strip%px(i)/2
      half_y = strip%film(i)*strip%py(i)/2
      extreme = sqrt(max((strip%tau_x(i) + half_x)**2 + (strip%tau_y(i) + half_y)**2, &
        (strip%tau_x(i) - half_x)**2 + (strip%tau_y(i) - half_y)**2))
      bound = merge(slip_stress(strip%limit(i)), huge(bound), limited)
      room = min(extreme + 2*strip%reference(i), max(approach*(bound - extreme), least*bound))
      length = sqrt(strip%step_x(i)**2 + strip%step_y(i)**2)
      strip%tau_x(i) = strip%tau_x(i) + room/max(length, room)*strip%step_x(i)
      strip%tau_y(i) = strip%tau_y(i) + room/max(length, room)*strip%step_y(i)
    end do
  end subroutine bounded_move

  !> Newton's method with a line search, of a point whose sums and step are those at its stress.
  !>
  !> Along a path the slope of the potential is minus the path's direction times the lacking velocity: a move
  !> is taken when the slope has shrunk to half, and one that has overshot is drawn back.
  pure subroutine solve_alone(law, levels, strip, i, converged)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    integer, intent(in) :: i
    logical, intent(out) :: converged
    real(wp) :: from(2), step(2), centre(2), to(2), direction(2), share, low, high, descent, slope
    logical :: turns
    integer :: newton, search

    call find_centre(law, strip, i, centre, turns)
    if (turns .and. hypot(strip%rest_x(i), strip%rest_y(i)) > hypot(strip%us(i), strip%vs(i))) then
      ! a wall slips too fast, from where Newton's steps are short: back to the middle of the circle, where a
      ! film that can bear its gradient has both walls within
      strip%tau_x(i) = 0
      strip%tau_y(i) = 0
      call sum_rates(law, levels, strip, i, i)
      call newton_step(strip, i, i)
    end if
    do newton = 1, steps_alone
      converged = strip%excess(i) <= 0
      if (converged) return
      from = [strip%tau_x(i), strip%tau_y(i)]
      step = [strip%step_x(i), strip%step_y(i)]
      descent = strip%rest_x(i)*step(1) + strip%rest_y(i)*step(2)
      call find_centre(law, strip, i, centre, turns)
      share = 1
      if (has_limit(law)) share = strip%limit(i)/max(norm2(step), strip%limit(i))
      low = 0
      high = 0
      do search = 1, search_steps
        if (turns) then
          call turn(from - centre, step, share, to, direction)
          to = to + centre
        else
          to = from + share*step
          direction = step
        end if
        strip%tau_x(i) = to(1)
        strip%tau_y(i) = to(2)
        call sum_rates(law, levels, strip, i, i)
        slope = -(strip%rest_x(i)*direction(1) + strip%rest_y(i)*direction(2))
        if (abs(slope) <= descent/2) exit
        if (slope > 0) then
          high = share
        else
          low = share
          if (.not. high > 0) exit
        end if
        share = low + (high - low)*merge(0.5_wp, 0.1_wp, low > 0)
      end do
      call newton_step(strip, i, i)
    end do
    converged = strip%excess(i) <= 0
    if (converged) return
    strip%step_x(i) = 0
    strip%step_y(i) = 0
  end subroutine solve_alone

  !> Stress halfway that leaves the more stressed wall without stress; `turns` if that wall is near slip,
  !> where stresses can only move round it.
  pure subroutine find_centre(law, strip, i, centre, turns)
    type(flow_law), intent(in) :: law
    type(shear_strip), intent(in) :: strip
    integer, intent(in) :: i
    real(wp), intent(out) :: centre(2)
    logical, intent(out) :: turns
    !> Share of the stress at slip that is near it.
    real(wp), parameter :: near = 0.9_wp
    real(wp) :: middle(2), half(2)

    middle = [strip%tau_x(i), strip%tau_y(i)]
    half = [strip%px(i), strip%py(i)]*strip%film(i)/2
    centre = sign(1.0_wp, -dot_product(middle, half))*half
    turns = has_limit(law) .and. norm2(middle - centre) > near*slip_stress(strip%limit(i))
  end subroutine find_centre

  !> Where a share of a step leads, `to`, that keeps its part along `from` and bends the other round the
  !> origin; and the derivative `direction` by the share.
  pure subroutine turn(from, step, share, to, direction)
    real(wp), intent(in) :: from(2), step(2), share
    real(wp), intent(out) :: to(2), direction(2)
    real(wp) :: radius, along, across, angle, radial(2), tangent(2)

    radius = norm2(from)
    along = dot_product(from, step)/radius
    across = (from(1)*step(2) - from(2)*step(1))/radius
    angle = share*across/radius
    radial = [from(1)*cos(angle) - from(2)*sin(angle), from(2)*cos(angle) + from(1)*sin(angle)]/radius
    tangent = [-radial(2), radial(1)]
    to = (radius + share*along)*radial
    direction = along*radial + (radius + share*along)*across/radius*tangent
  end subroutine turn

  !> Takes the last Newton step, with thinning to first order, by which the rates add up to the sliding. A is
  !> summed anew: in the mobility of a film that slips it cancels against B and C to a few digits.
  pure subroutine finish(levels, strip)
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    real(wp) :: x, y, share, along, across
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
          share = levels%weight(k)*s%film(i)*s%fluidity(i, k)
          along = share*s%g(i, k)
          across = 2*share*s%g_slope(i, k)
          s%a_xx(i) = s%a_xx(i) + along + across*x*x
          s%a_xy(i) = s%a_xy(i) + across*x*y
          s%a_yy(i) = s%a_yy(i) + along + across*y*y
        end do
      end do
    end associate
    call invert(strip, 1, strip%points)
  end subroutine finish

  !> Which walls are beyond the stress at slip.
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

  !> Flow [m2/s] that shear takes from the entrainment, S = int z' f g tau dz': the film carries u h - S, with
  !> u the mean velocity of the bodies (Sharif et al., eqs 10 and 11).
  pure subroutine flow_deficit(levels, strip, deficit_x, deficit_y)
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(in) :: strip
    real(wp), contiguous, intent(out) :: deficit_x(:), deficit_y(:)
    real(wp) :: share
    integer :: i, k

    deficit_x = 0
    deficit_y = 0
    do k = 1, levels%count
      do i = 1, strip%points
        share = levels%weight(k)*levels%z(k)*strip%film(i)**2*strip%fluidity(i, k)*strip%g(i, k)
        deficit_x(i) = deficit_x(i) + share*(strip%tau_x(i) + levels%z(k)*strip%film(i)*strip%px(i))
        deficit_y(i) = deficit_y(i) + share*(strip%tau_y(i) + levels%z(k)*strip%film(i)*strip%py(i))
      end do
    end do
  end subroutine flow_deficit

  !> The deficit S [m2/s] with its derivatives at given sliding: the mobility dS/d(grad p) = C - B A^-1 B
  !> [m3/(Pa s)], symmetric and positive definite; by the film [m/s]; and by the fluidity at each level [Pa
  !> m2].
  pure subroutine flow_change(levels, strip, deficit_x, deficit_y, mobility_xx, mobility_xy, mobility_yy, by_film_x, &
    by_film_y, by_fluidity_x, by_fluidity_y)
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    real(wp), contiguous, intent(out) :: deficit_x(:), deficit_y(:), mobility_xx(:), mobility_xy(:), mobility_yy(:), &
      by_film_x(:), by_film_y(:), by_fluidity_x(:, :), by_fluidity_y(:, :)
    real(wp) :: x, y, height, share, along, across
    integer :: i, k

    associate (s => strip, b_xx => strip%a_xx, b_xy => strip%a_xy, b_yy => strip%a_yy)
      deficit_x = 0
      deficit_y = 0
      mobility_xx = 0
      mobility_xy = 0
      mobility_yy = 0
      b_xx = 0
      b_xy = 0
      b_yy = 0
      do k = 1, levels%count
        do i = 1, s%points
          height = levels%z(k)*s%film(i)
          x = s%tau_x(i) + height*s%px(i)
          y = s%tau_y(i) + height*s%py(i)
          share = levels%weight(k)*s%film(i)*s%fluidity(i, k)*height
          along = share*s%g(i, k)
          across = 2*share*s%g_slope(i, k)
          deficit_x(i) = deficit_x(i) + along*x
          deficit_y(i) = deficit_y(i) + along*y
          b_xx(i) = b_xx(i) + along + across*x*x
          b_xy(i) = b_xy(i) + across*x*y
          b_yy(i) = b_yy(i) + along + across*y*y
          mobility_xx(i) = mobility_xx(i) + height*(along + across*x*x)
          mobility_xy(i) = mobility_xy(i) + height*across*x*y
          mobility_yy(i) = mobility_yy(i) + height*(along + across*y*y)
        end do
      end do
      do i = 1, s%points
        s%arm_xx(i) = b_xx(i)*s%inverse_xx(i) + b_xy(i)*s%inverse_xy(i)
        s%arm_xy(i) = b_xx(i)*s%inverse_xy(i) + b_xy(i)*s%inverse_yy(i)
        s%arm_yx(i) = b_xy(i)*s%inverse_xx(i) + b_yy(i)*s%inverse_xy(i)
        s%arm_yy(i) = b_xy(i)*s%inverse_xy(i) + b_yy(i)*s%inverse_yy(i)
        mobility_xx(i) = mobility_xx(i) - s%arm_xx(i)*b_xx(i) - s%arm_xy(i)*b_xy(i)
        mobility_xy(i) = mobility_xy(i) - s%arm_xx(i)*b_xy(i) - s%arm_xy(i)*b_yy(i)
        mobility_yy(i) = mobility_yy(i) - s%arm_yx(i)*b_xy(i) - s%arm_yy(i)*b_yy(i)
        by_film_x(i) = (2*deficit_x(i) - s%arm_xx(i)*s%us(i) - s%arm_xy(i)*s%vs(i) + mobility_xx(i)*s%px(i) &
          + mobility_xy(i)*s%py(i))/s%film(i)
        by_film_y(i) = (2*deficit_y(i) - s%arm_yx(i)*s%us(i) - s%arm_yy(i)*s%vs(i) + mobility_xy(i)*s%px(i) &
          + mobility_yy(i)*s%py(i))/s%film(i)
      end do
      do k = 1, levels%count
        do i = 1, s%points
          height = levels%z(k)*s%film(i)
          share = levels%weight(k)*s%film(i)*s%g(i, k)
          x = share*(s%tau_x(i) + height*s%px(i))
          y = share*(s%tau_y(i) + height*s%py(i))
          by_fluidity_x(i, k) = (height - s%arm_xx(i))*x - s%arm_xy(i)*y
          by_fluidity_y(i, k) = (height - s%arm_yy(i))*y - s%arm_yx(i)*x
        end do
      end do
    end associate
  end subroutine flow_change

  !> Derivatives of the deficit by the reference and the limiting stress [m2/(Pa s)], after `flow_change`.
  pure subroutine flow_change_by_stresses(law, levels, strip, by_reference_x, by_reference_y, by_limit_x, by_limit_y)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    real(wp), contiguous, intent(out) :: by_reference_x(:), by_reference_y(:), by_limit_x(:), by_limit_y(:)
    real(wp) :: x, y, height, share, to_x, to_y
    integer :: i, k

    by_reference_x = 0
    by_reference_y = 0
    by_limit_x = 0
    by_limit_y = 0
    associate (s => strip, by_reference => strip%step_x, by_limit => strip%step_y)
      do k = 1, levels%count
        call square_stress(s%points, levels%z(k), s%film, s%px, s%py, s%tau_x, s%tau_y, s%square)
        call thinning_by_stresses(law, s%points, s%square, s%reference, s%limit, s%g(:, k), s%g_slope(:, k), &
          by_reference, by_limit)
        do i = 1, s%points
          height = levels%z(k)*s%film(i)
          x = s%tau_x(i) + height*s%px(i)
          y = s%tau_y(i) + height*s%py(i)
          share = levels%weight(k)*s%film(i)*s%fluidity(i, k)
          to_x = share*((height - s%arm_xx(i))*x - s%arm_xy(i)*y)
          to_y = share*((height - s%arm_yy(i))*y - s%arm_yx(i)*x)
          by_reference_x(i) = by_reference_x(i) + by_reference(i)*to_x
          by_reference_y(i) = by_reference_y(i) + by_reference(i)*to_y
          by_limit_x(i) = by_limit_x(i) + by_limit(i)*to_x
          by_limit_y(i) = by_limit_y(i) + by_limit(i)*to_y
        end do
      end do
    end associate
  end subroutine flow_change_by_stresses

  !> Velocity (u, v) [m/s] of the oil at the levels, from that of body 1 (u1, v1); at the walls that of the
  !> bodies, from which the oil next to them differs where it slips.
  pure subroutine film_velocity(law, levels, strip, u1, v1, u, v)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    real(wp), contiguous, intent(in) :: u1(:), v1(:)
    real(wp), contiguous, intent(out) :: u(:, :), v(:, :)
    real(wp) :: share, slip_x, slip_y
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
        share = strip%film(i)*strip%fluidity(i, l)*strip%g(i, l)
        strip%step_x(i) = share*(strip%tau_x(i) + levels%z(l)*strip%film(i)*strip%px(i))
        strip%step_y(i) = share*(strip%tau_y(i) + levels%z(l)*strip%film(i)*strip%py(i))
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

  !> Takes slip from the velocities across the film that a wall's rate of shear stands for.
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

  !> Slip velocity [m/s] of point i at the wall whose level is given: what the rate there exceeds that at the
  !> stress where slip begins. Its product with the wall's shear stress is heat [W/m2] that `film_heat` counts
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

  !> Heat of shear f g tau^2 [W/m3] at the levels, and its derivatives by their fluidity f at given sliding:
  !> at level k by that at level l, own(k) where k = l, less response_x(k) stress_x(l) + response_y(k)
  !> stress_y(l).
  !>
  !> `own` [Pa2], `response` = 2 f (g + g' tau^2) tau [1/s], and `stress` [Pa2 s]: how much the stress halfway
  !> sinks.
  pure subroutine film_heat(levels, strip, heat, own, response_x, response_y, stress_x, stress_y)
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(in) :: strip
    real(wp), contiguous, intent(out) :: heat(:, :), own(:, :), response_x(:, :), response_y(:, :), stress_x(:, :), &
      stress_y(:, :)
    real(wp) :: x, y, square, response, share
    integer :: i, k

    do k = 1, levels%count
      do i = 1, strip%points
        x = strip%tau_x(i) + levels%z(k)*strip%film(i)*strip%px(i)
        y = strip%tau_y(i) + levels%z(k)*strip%film(i)*strip%py(i)
        square = x*x + y*y
        own(i, k) = strip%g(i, k)*square
        heat(i, k) = strip%fluidity(i, k)*own(i, k)
        response = 2*strip%fluidity(i, k)*(strip%g(i, k) + strip%g_slope(i, k)*square)
        response_x(i, k) = response*x
        response_y(i, k) = response*y
        share = levels%weight(k)*strip%film(i)*strip%g(i, k)
        stress_x(i, k) = share*(strip%inverse_xx(i)*x + strip%inverse_xy(i)*y)
        stress_y(i, k) = share*(strip%inverse_xy(i)*x + strip%inverse_yy(i)*y)
      end do
    end do
  end subroutine film_heat

  !> Flow factors [m3/(Pa s)] along the sliding, `factor_s`, and across it, `factor_r`, and the entrainment
  !> [m/s] that viscosity varying across the film takes from the mean velocity of the bodies, (lag_s, lag_r),
  !> such that the flow is (u - lag) h - factor dp along each direction (Sharif et al., eqs 13a to 16).
  !> Direction s is (cosine, sine), that of the sliding or, without it, that of the pressure gradient.
  !>
  !> The flows without one gradient are those at the same stress halfway, as the arguments in eqs 13a to 16
  !> say.
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
    !> Least drop, in stresses halfway, that a difference resolves; below it the factor is the one at that
    !> drop.
    real(wp), parameter :: least_drop = 1e-4_wp
    real(wp) :: across(levels%count), with(levels%count), without(levels%count), share(levels%count), resolved
    real(wp), dimension(levels%count) :: per_reference, per_limit, g, g_without, slope

    per_reference = 1/strip%reference(i)**2
    per_limit = 1/strip%limit(i)**2
    resolved = sign(max(abs(drop), least_drop*hypot(stress, stress_across), sqrt(tiny(drop))), drop)
    across = (stress_across + levels%z*drop_across)**2
    with = stress + levels%z*resolved
    without = stress
    call thinning(law, levels%count, with**2 + across, per_reference, per_limit, g, slope)
    call thinning(law, levels%count, without**2 + across, per_reference, per_limit, g_without, slope)
    share = levels%weight*levels%z*strip%film(i)*strip%fluidity(i, :)
    lag = sum(share*g_without*without)
    factor = sum(share*(g*with - g_without*without))*strip%film(i)**2/resolved
  end subroutine flow_factor

end module shear_flow
