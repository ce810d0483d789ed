!> Surface temperature of a fast body along the curved paths of its points.
!>
!> Heat flows into depth while a point of the surface crosses the contact (Sharif et al. 2001, eq. 19):
!>   rise(t) = int q(t') / sqrt(pi k rho c (t - t')) dt'  along the point's path, from where it enters the window.
!> Meanwhile it spreads to both sides of the path: a slender contact crossed along its length is cooled by it
!> long before conduction along the path, which is neglected, matters.
!>
!> The square root is a sum of exponentials of the age t - t', the trapezoidal rule for
!>   1/sqrt(t) = 1/sqrt(pi) int exp(y/2 - t exp(y)) dy,
!> whose integrals need only the line of the grid before: lines are taken one after another with the motion,
!> the integrals of each node start from the departure point of its path on the line before, and the flux in
!> between is linear in time. Diffusion along the line is an implicit step of exact variance.
module pyworm_surface_path
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: pp, wp
  use pyworm_sweep_order, only: sweep_frame, new_sweep_frame, to_sweep, from_sweep
  use pyworm_status, only: status_ok, status_bad_argument, status_not_finite, status_no_memory
  implicit none(type, external)
  private

  public :: fast_body, new_fast_body

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Ratio of successive rates of decay. The sum's relative error oscillates by 2 |Gamma(1/2 + 2 pi
  !> i/ln(ratio))|/sqrt(pi), 3.5e-4 for this ratio, and averages out.
  integer, parameter :: ratio = 3
  !> Least rate of decay over that of the longest age, slower ones being merged into one, and largest over that
  !> of the shortest age, faster ones having decayed.
  real(wp), parameter :: slowest = 0.1_wp, fastest = 9.0_wp
  !> Largest number of iterations for the foot of a path, whose error falls by the turn of the path in a step, and
  !> the move of the foot, in nodes, at which they end.
  integer, parameter :: foot_iterations = 8
  real(wp), parameter :: foot_settled = 1e-7_wp
  !> Exponentials of a group, a vector register in single precision, whose rounding is far below the error of the sum. Each
  !> group is advanced over all lines independently, so that threads with different groups need not wait for each other.
  integer, parameter :: lanes = 8

  type, extends(heated_body) :: fast_body
    !> Order of the lines.
    type(sweep_frame) :: way
    !> Nodes of a line, lines, and groups of exponentials.
    integer :: nodes = 0, lines = 0, groups = 0
    !> Rise under a unit of int q dt/sqrt(t) [K m2/(W sqrt(s))].
    real(wp) :: effusion = 0
    !> Persistence [s], one over the rate of decay, and weights [1/sqrt(s)] of the exponentials, slowest
    !> first, (lanes, groups); the first stands for all slower ones.
    real(pp), allocatable :: persistence(:, :), weight(:, :)
    !> First of the four nodes around a path's foot on the line before, (nodes, lines), their weights over the pivot of the
    !> implicit step along the line, zero if the foot is outside, (4, nodes, lines), and the time from the foot [s] and its
    !> root, (nodes, lines).
    integer, allocatable :: foot(:, :)
    real(pp), allocatable :: stencil(:, :, :)
    real(wp), allocatable :: duration(:, :), root(:, :)
    !> Loss of the exponentials in that time, one less their decay, (lanes, nodes, lines, groups).
    real(pp), allocatable :: loss(:, :, :, :)
    !> Coupling to the next node in the implicit step along a line, (nodes, lines).
    real(pp), allocatable :: passed(:, :)
    !> Flux at the nodes and at the feet of their paths, and rise, (nodes, lines); contribution of earlier steps to
    !> int q dt/sqrt(t) [W sqrt(s)/m2], (nodes, lines, groups).
    real(wp), allocatable :: flux(:, :), before(:, :), risen(:, :)
    real(pp), allocatable :: history(:, :, :)
  contains
    procedure :: rise
    procedure :: rise_transposed
  end type fast_body

contains

  !> Body of `conductivity` [W/(m K)] and `heat_capacity` rho c [J/(m3 K)] whose surface moves with (u, v)
  !> [m/s], (nx, ny). One component must have the same sign all over the window.
  subroutine new_fast_body(self, dx, dy, u, v, conductivity, heat_capacity, stat)
    type(fast_body), intent(inout) :: self
    real(wp), intent(in) :: dx, dy, conductivity, heat_capacity
    real(wp), contiguous, intent(in) :: u(:, :), v(:, :)
    integer, intent(out) :: stat
    real(wp), allocatable :: ahead(:, :), aside(:, :)
    logical :: by_x, by_y
    integer :: err

    stat = status_bad_argument
    if (any(shape(u) < 4) .or. any(shape(v) /= shape(u))) return
    if (.not. (dx > 0 .and. dy > 0 .and. conductivity > 0 .and. heat_capacity > 0)) return
    stat = status_not_finite
    if (.not. all(abs(u) + abs(v) <= huge(1.0_wp))) return
    by_x = all(u > 0) .or. all(u < 0)
    by_y = all(v > 0) .or. all(v < 0)
    stat = status_bad_argument
    if (.not. (by_x .or. by_y)) return
    ! the direction in which lines lie more squarely across the paths
    if (by_x .and. by_y) by_y = maxval(abs(u/v)) < maxval(abs(v/u))

    self%nx = size(u, 1)
    self%ny = size(u, 2)
    self%way = new_sweep_frame(self%nx, self%ny, dx, dy, .not. by_y, merge(v(1, 1), u(1, 1), by_y) < 0)
    self%nodes = self%way%length
    self%lines = self%way%lines
    self%effusion = 1/sqrt(pi*conductivity*heat_capacity)
    allocate (self%foot(self%nodes, self%lines), self%stencil(4, self%nodes, self%lines), &
      self%duration(self%nodes, self%lines), self%passed(self%nodes, self%lines), &
      self%flux(self%nodes, self%lines), self%before(self%nodes, self%lines), self%risen(self%nodes, self%lines), &
      ahead(self%nodes, self%lines), aside(self%nodes, self%lines), stat=err)
    stat = status_no_memory
    if (err /= 0) return
    if (by_y) then
      call to_sweep(self%way, v, ahead)
      call to_sweep(self%way, u, aside)
      call find_feet(self, abs(ahead), aside, dy, dx)
      call factor_spread(self, conductivity/heat_capacity/dx**2*(1 + (aside/ahead)**2))
    else
      call to_sweep(self%way, u, ahead)
      call to_sweep(self%way, v, aside)
      call find_feet(self, abs(ahead), aside, dx, dy)
      call factor_spread(self, conductivity/heat_capacity/dy**2*(1 + (aside/ahead)**2))
    end if
    self%root = sqrt(self%duration)
    call choose_rates(self, stat)
    self%own = self%effusion*4/3*sqrt(sum(self%duration(:, 2:))/size(self%duration(:, 2:)))
  end subroutine new_fast_body

  !> Finds the feet of the nodes' paths on the line before, and the time from there.
  !>
  !> Simpson's rule along the path, with the velocity halfway from the mean of both lines: exact velocities if
  !> the body is rigid. `ahead` is the speed from line to line, `aside` along them [m/s], `apart` and
  !> `spacing` the distances [m] of lines and of nodes.
  subroutine find_feet(self, ahead, aside, apart, spacing)
    type(fast_body), intent(inout) :: self
    real(wp), intent(in) :: ahead(:, :), aside(:, :), apart, spacing
    real(wp) :: slope(3), slowness(3), stencil(4), at, halfway, last, move, last_move
    integer :: line, node, iteration, first

    self%foot(:, 1) = 1
    self%stencil(:, :, 1) = 0
    self%duration(:, 1) = 0
    !$omp parallel do private(node, slope, slowness, stencil, at, halfway, last, move, last_move, iteration, first) &
    !$omp& schedule(static)
    do line = 2, self%lines
      associate (ahead_here => ahead(:, line), aside_here => aside(:, line), &
          ahead_before => ahead(:, line - 1), aside_before => aside(:, line - 1))
        do node = 1, self%nodes
          slope(1) = aside_here(node)/ahead_here(node)
          slowness(1) = 1/ahead_here(node)
          ! initial guess: the slope at the node nearest to the foot of a straight path
          first = nint(within(node - apart/spacing*slope(1), self%nodes))
          slope(3) = aside_before(first)/ahead_before(first)
          slope(2) = (slope(1) + slope(3))/2
          at = node
          move = 0
          do iteration = 1, foot_iterations
            last = at
            last_move = move
            at = node - apart/spacing*(slope(1) + 4*slope(2) + slope(3))/6
            move = at - last
            if (iteration > 1 .and. move**2 <= foot_settled*abs(last_move)) exit
            halfway = (node + at)/2 + apart/spacing*(slope(3) - slope(1))/8
            call around(within(at, self%nodes), self%nodes, first, stencil)
            slowness(3) = 1/dot_product(stencil, ahead_before(first:first + 3))
            slope(3) = dot_product(stencil, aside_before(first:first + 3))*slowness(3)
            call around(within(halfway, self%nodes), self%nodes, first, stencil)
            slowness(2) = 2/dot_product(stencil, ahead_before(first:first + 3) + ahead_here(first:first + 3))
            slope(2) = dot_product(stencil, aside_before(first:first + 3) + aside_here(first:first + 3))/2*slowness(2)
          end do
          self%duration(node, line) = apart*(slowness(1) + 4*slowness(2) + slowness(3))/6
          self%stencil(:, node, line) = 0
          self%foot(node, line) = 1
          if (at < 1 .or. at > self%nodes) cycle
          call around(at, self%nodes, self%foot(node, line), stencil)
          self%stencil(:, node, line) = real(stencil, pp)
        end do
      end associate
    end do
  end subroutine find_feet

  !> The four nodes around a place on a line of n nodes, from `first` on, and their weights in cubic
  !> interpolation.
  pure subroutine around(at, n, first, stencil)
    real(wp), intent(in) :: at
    integer, intent(in) :: n
    integer, intent(out) :: first
    real(wp), intent(out) :: stencil(4)
    real(wp) :: s

    first = min(max(int(at) - 1, 1), n - 3)
    s = at - first
    stencil = [-(s - 1)*(s - 2)*(s - 3)/6, s*(s - 2)*(s - 3)/2, -s*(s - 1)*(s - 3)/2, s*(s - 1)*(s - 2)/6]
  end subroutine around

  !> Clips a place to a line of n nodes.
  pure real(wp) function within(at, n)
    real(wp), intent(in) :: at
    integer, intent(in) :: n

    within = min(max(at, 1.0_wp), real(n, wp))
  end function within

  !> Sets the exponentials for all ages between the shortest step and the longest stay, and their decay in each step.
  subroutine choose_rates(self, stat)
    type(fast_body), intent(inout) :: self
    integer, intent(out) :: stat
    real(wp), allocatable :: rate(:, :), weight(:, :)
    real(wp) :: stay, slow, step, decay
    integer :: mode, group, node, line, err

    stay = sum(maxval(self%duration, dim=1))
    step = log(real(ratio, wp))
    slow = slowest/stay
    self%groups = ceiling((1 + log(fastest/minval(self%duration(:, 2:))/slow)/step)/lanes)
    allocate (rate(lanes, self%groups), weight(lanes, self%groups), &
      self%loss(lanes, self%nodes, self%lines, self%groups), self%history(self%nodes, self%lines, self%groups), stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
    if (err /= 0) return
    rate = reshape([(slow*real(ratio, wp)**(mode - 2), mode=1, lanes*self%groups)], shape(rate))
    weight = step*sqrt(rate/pi)
    ! slower ones, in geometric sums: their weight, and the rate that keeps their first moment
    weight(1, 1) = step*sqrt(slow/pi)/(sqrt(real(ratio, wp)) - 1)
    rate(1, 1) = step*sqrt(slow/pi)*slow/(sqrt(real(ratio, wp))**3 - 1)/weight(1, 1)
    self%weight = real(weight, pp)
    self%persistence = real(1/rate, pp)
    !$omp parallel do private(node, group, mode, decay) schedule(static)
    do line = 1, self%lines
      do node = 1, self%nodes
        decay = exp(-slow*self%duration(node, line))
        do group = 1, self%groups
          do mode = 1, lanes
            if (mode == 1 .and. group == 1) then
              self%loss(mode, node, line, group) = real(1 - exp(-rate(1, 1)*self%duration(node, line)), pp)
            else
              self%loss(mode, node, line, group) = real(1 - decay, pp)
              decay = decay**ratio
            end if
          end do
        end do
      end do
    end do
  end subroutine choose_rates

  !> Sets the factors of an implicit step of diffusion along the lines, in squared nodes per second. On a line
  !> crossed obliquely distances are longer than across the paths.
  subroutine factor_spread(self, rate)
    type(fast_body), intent(inout) :: self
    real(wp), intent(in) :: rate(:, :)
    real(wp) :: number, pivot, passed
    integer :: line, node

    do line = 1, self%lines
      passed = 0
      do node = 1, self%nodes
        ! the temperature is even about the first and last node
        number = rate(node, line)*self%duration(node, line)*merge(2, 1, node == 1 .or. node == self%nodes)
        pivot = 1/(1 + number*(merge(1, 2, node == 1 .or. node == self%nodes) - passed))
        passed = number*pivot
        self%passed(node, line) = real(passed, pp)
        self%stencil(:, node, line) = real(self%stencil(:, node, line)*pivot, pp)
      end do
    end do
  end subroutine factor_spread

  !> Temperature rise [K] under the flux `q` [W/m2].
  subroutine rise(self, q, temperature_rise)
    class(fast_body), intent(inout) :: self
    real(wp), intent(in) :: q(self%nx, self%ny)
    real(wp), intent(out) :: temperature_rise(self%nx, self%ny)
    integer :: line, group

    call to_sweep(self%way, q, self%flux)
    self%before(:, 1) = 0
    !$omp parallel do schedule(static)
    do line = 2, self%lines
      call flux_at_feet(self, line)
    end do
    !$omp parallel do schedule(static)
    do group = 1, self%groups
      call remember(self, group)
    end do
    !$omp parallel do private(group) schedule(static)
    do line = 1, self%lines
      ! integral of a flux linear in time over the root of its age, in the last step
      self%risen(:, line) = self%root(:, line)*(4*self%flux(:, line) + 2*self%before(:, line))/3
      do group = 1, self%groups
        self%risen(:, line) = self%risen(:, line) + self%history(:, line, group)
      end do
      self%risen(:, line) = self%effusion*self%risen(:, line)
    end do
    call from_sweep(self%way, self%risen, temperature_rise)
  end subroutine rise

  !> Computes the flux at the feet of a line's paths, diffused along the line in the step.
  subroutine flux_at_feet(self, line)
    class(fast_body), intent(inout) :: self
    integer, intent(in) :: line
    real(wp) :: spread
    integer :: node

    ! the implicit step of `factor_spread`, forward and back along the line
    associate (before => self%before(:, line), passed => self%passed(:, line))
      spread = 0
      do node = 1, self%nodes
        associate (foot => self%foot(node, line))
          spread = dot_product(self%stencil(:, node, line), self%flux(foot:foot + 3, line - 1)) &
            + passed(node)*spread
        end associate
        before(node) = spread
      end do
      spread = 0
      do node = self%nodes, 1, -1
        spread = before(node) + passed(node)*spread
        before(node) = spread
      end do
    end associate
  end subroutine flux_at_feet

  !> Advances a group of exponentials over all lines, for the contribution of earlier steps.
  subroutine remember(self, group)
    class(fast_body), intent(inout) :: self
    integer, intent(in) :: group
    !> Integrals of the exponentials with the flux up to a line, and those convected along the paths to the next line.
    real(pp) :: past(lanes, self%nodes), brought(lanes, self%nodes)
    real(pp), dimension(lanes) :: spread, loss, whole, early, product
    real(pp) :: stencil(4), here, there, pace
    integer :: line, node, foot

    past = 0
    self%history(:, 1, group) = 0
    do line = 2, self%lines
      spread = 0
      do node = 1, self%nodes
        foot = self%foot(node, line)
        stencil = self%stencil(:, node, line)
        spread = (1 - self%loss(:, node, line, group))*(stencil(1)*past(:, foot) + stencil(2)*past(:, foot + 1) &
          + stencil(3)*past(:, foot + 2) + stencil(4)*past(:, foot + 3)) + self%passed(node, line)*spread
        brought(:, node) = spread
      end do

      spread = 0
      do node = self%nodes, 1, -1
        spread = brought(:, node) + self%passed(node, line)*spread
        product = self%weight(:, group)*spread
        self%history(node, line, group) = sum_of_lanes(product)
        ! integrals of exp(-rate age) over the step, and with the fraction of the flux at its beginning
        here = real(self%flux(node, line), pp)
        there = real(self%before(node, line), pp)
        pace = real(1/self%duration(node, line), pp)
        loss = self%loss(:, node, line, group)
        whole = loss*self%persistence(:, group)
        early = (whole*pace - (1 - loss))*self%persistence(:, group)
        past(:, node) = spread + here*(whole - early) + there*early
      end do
    end do
  end subroutine remember

  !> Transposed product of `rise` (`heated_surface`): lines are taken against the motion.
  subroutine rise_transposed(self, weight, by_flux)
    class(fast_body), intent(inout) :: self
    real(wp), intent(in) :: weight(self%nx, self%ny)
    real(wp), intent(out) :: by_flux(self%nx, self%ny)
    !> Derivatives by the flux at the nodes and at the feet of their paths through each group, (nodes, lines, groups).
    real(pp), allocatable :: by_here(:, :, :), by_there(:, :, :)
    integer :: line, group

    allocate (by_here(self%nodes, self%lines, self%groups), by_there(self%nodes, self%lines, self%groups))
    call to_sweep(self%way, weight, self%risen)
    self%risen = self%effusion*self%risen
    !$omp parallel do schedule(static)
    do group = 1, self%groups
      call recall(self, group, by_here(:, :, group), by_there(:, :, group))
    end do
    !$omp parallel do private(group) schedule(static)
    do line = 1, self%lines
      self%flux(:, line) = 4*self%root(:, line)*self%risen(:, line)/3
      self%before(:, line) = 2*self%root(:, line)*self%risen(:, line)/3
      do group = 1, self%groups
        self%flux(:, line) = self%flux(:, line) + by_here(:, line, group)
        self%before(:, line) = self%before(:, line) + by_there(:, line, group)
      end do
    end do
    do line = 2, self%lines
      call flux_from_feet(self, line)
    end do
    call from_sweep(self%way, self%flux, by_flux)
  end subroutine rise_transposed

  !> Derivatives of a group's contributions, weighted by `risen`, by the flux at the nodes and at the feet: `remember`
  !> transposed, line after line against the motion.
  subroutine recall(self, group, by_here, by_there)
    class(fast_body), intent(in) :: self
    integer, intent(in) :: group
    real(pp), intent(out) :: by_here(:, :), by_there(:, :)
    !> Derivatives by the integrals up to a line and by those convected to it.
    real(pp) :: past(lanes, self%nodes), brought(lanes, self%nodes)
    real(pp), dimension(lanes) :: spread, loss, whole, early, product
    real(pp) :: pace
    integer :: line, node, foot, k

    past = 0
    by_here(:, 1) = 0
    by_there(:, 1) = 0
    do line = self%lines, 2, -1
      spread = 0
      do node = 1, self%nodes
        pace = real(1/self%duration(node, line), pp)
        loss = self%loss(:, node, line, group)
        whole = loss*self%persistence(:, group)
        early = (whole*pace - (1 - loss))*self%persistence(:, group)
        product = past(:, node)*(whole - early)
        by_here(node, line) = sum_of_lanes(product)
        product = past(:, node)*early
        by_there(node, line) = sum_of_lanes(product)
        spread = past(:, node) + self%weight(:, group)*real(self%risen(node, line), pp) + spread
        brought(:, node) = spread
        spread = self%passed(node, line)*spread
      end do

      past = 0
      spread = 0
      do node = self%nodes, 1, -1
        spread = brought(:, node) + spread
        product = (1 - self%loss(:, node, line, group))*spread
        foot = self%foot(node, line)
        do k = 1, 4
          past(:, foot + k - 1) = past(:, foot + k - 1) + self%stencil(k, node, line)*product
        end do
        spread = self%passed(node, line)*spread
      end do
    end do
  end subroutine recall

  !> Adds to the derivatives by the flux on the line before those through the flux at the feet of a line's paths:
  !> `flux_at_feet` transposed.
  subroutine flux_from_feet(self, line)
    class(fast_body), intent(inout) :: self
    integer, intent(in) :: line
    real(wp) :: spread
    integer :: node

    associate (before => self%before(:, line), passed => self%passed(:, line), flux => self%flux(:, line - 1))
      spread = 0
      do node = 1, self%nodes
        before(node) = before(node) + spread
        spread = passed(node)*before(node)
      end do
      spread = 0
      do node = self%nodes, 1, -1
        spread = before(node) + spread
        associate (foot => self%foot(node, line))
          flux(foot:foot + 3) = flux(foot:foot + 3) + self%stencil(:, node, line)*spread
        end associate
        spread = passed(node)*spread
      end do
    end associate
  end subroutine flux_from_feet

  !> Sum over a group, by halves.
  pure real(pp) function sum_of_lanes(a)
    real(pp), intent(in) :: a(lanes)

    sum_of_lanes = ((a(1) + a(5)) + (a(3) + a(7))) + ((a(2) + a(6)) + (a(4) + a(8)))
  end function sum_of_lanes

end module pyworm_surface_path
