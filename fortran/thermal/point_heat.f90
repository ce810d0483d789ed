!> Temperature of the film of a point contact, swept line by line with the oil (`thermal_step`).
!>
!> A sweep solves the columns line after line in the direction of the oil, upwind by the velocity of each level; values
!> of later lines, and along a line, lag behind. Where oil flows back, a sweep in the other direction precedes it.
module point_heat
  use column_sources, only: set_heat, carried_away
  use film_column, only: film_strip, new_film_strip, solve_columns
  use film_newton, only: film_contact
  use heated_surface, only: heated_body
  use kinds, only: wp
  use oil_convection, only: carry_level
  use omp_lib, only: omp_get_max_threads, omp_get_thread_num
  use point_film, only: point_contact
  use shear_fields, only: shear_columns
  use shear_profile, only: film_shear_rate
  use strip_of_points, only: shear_strip, new_shear_strip
  use status, only: status_ok, status_bad_argument, status_no_memory
  use sweep_order, only: sweep_frame, new_sweep_frame, to_sweep, from_sweep
  use thermal_properties, only: oil_heat_law
  use thermal_step, only: film_heat, thermal_contact, new_film_heat, set_walls
  implicit none(type, external)
  private

  public :: point_film_heat, new_point_heat, heat_point_contact, swept_shear

  !> Columns treated together, whatever the number of threads.
  integer, parameter :: most_columns = 32
  !> Change of the columns with backflow, over the largest rise, above which they are swept against the oil too.
  real(wp), parameter :: lagging = 0.01_wp
  !> Fraction of the largest pressure above which temperatures must converge; reduction of the walls' imbalance by a
  !> sweep, and its largest number of Krylov iterations.
  real(wp), parameter :: judged_pressure = 0.02_wp, wall_tolerance = 0.1_wp
  integer, parameter :: most_wall_iterations = 8

  !> Scratch of a thread: columns and their shear, and at their levels the derivative of the fluidity by temperature
  !> [1/(Pa s K)], velocities along and across the line [m/s], the rate of shear [1/s], and the heat of compression and
  !> convection [W/m3].
  type :: column_work
    type(film_strip) :: columns
    type(shear_strip) :: shear
    real(wp), dimension(:, :), allocatable :: softening, u, v, rate, compression, inflow
  end type column_work

  !> Fields are in the order of the sweep, (length, lines).
  type, extends(film_heat) :: point_film_heat
    type(sweep_frame) :: way
    !> Velocity of body 1's surface and of body 2 relative to it [m/s].
    real(wp), allocatable :: u1(:, :), v1(:, :), us(:, :), vs(:, :)
    !> Pressure [Pa] and film [m].
    real(wp), allocatable :: p(:, :), h(:, :)
    !> Stress at the middle of the film [Pa], the initial guess of the next sweep.
    real(wp), allocatable :: stress_x(:, :), stress_y(:, :)
    !> Heat of shearing, and heat convected by the oil less that of its compression [W/m2]; the largest shear rate across
    !> the film [1/s].
    real(wp), allocatable :: friction(:, :), carried(:, :), rate(:, :)
    !> Temperature, (0:length + 1, lines, levels), with padding at the ends of a line; that of the present line and of the
    !> next before the sweep, line k at mod(k, 2).
    real(wp), allocatable :: rise(:, :, :), old(:, :, :)
    !> Whether oil flows against the sweep in the columns of a cut, (cuts, lines), and their change by a sweep [K].
    logical, allocatable :: returns(:, :)
    real(wp) :: returned = 0
    !> Flux into the walls and its derivatives (`wall_balance`), (length, lines, wall) and (length, lines, wall, wall).
    real(wp), allocatable :: flux(:, :, :), admittance(:, :, :, :)
    !> Scratch of each thread.
    type(column_work), allocatable :: threads(:)
  contains
    procedure :: sweep_columns
    procedure :: cool
    procedure :: unsolved
    procedure :: carried_heat
  end type point_film_heat

contains

  !> Makes the heat of a point contact whose film is already sheared.
  !>
  !> u1 and v1 are the nodal velocity of body 1's surface [m/s]; the bodies move into it, `bulk` being their
  !> temperature far below the surface, above the inlet's [K].
  subroutine new_point_heat(self, film, law, u1, v1, body_1, body_2, bulk, stat)
    type(point_film_heat), intent(inout) :: self
    type(point_contact), intent(inout) :: film
    type(oil_heat_law), intent(in) :: law
    real(wp), intent(in) :: u1(:, :), v1(:, :), bulk(2)
    class(heated_body), allocatable, intent(inout) :: body_1, body_2
    integer, intent(out) :: stat
    real(wp) :: change
    integer :: levels, err

    self%judged_pressure = judged_pressure
    self%wall_tolerance = wall_tolerance
    call new_film_heat(self, film, law, body_1, body_2, bulk, most_wall_iterations, stat)
    if (stat /= status_ok) return
    associate (grid => film%grid, nodes => film%shear%nodes)
      levels = nodes%levels%count
      self%way = new_sweep_frame(grid%nx, grid%ny, grid%dx, grid%dy, film%cycles%transposed, .not. film%cycles%rising)
      associate (n => self%way%length, lines => self%way%lines)
        allocate (self%u1(n, lines), self%v1(n, lines), self%us(n, lines), self%vs(n, lines), self%p(n, lines), &
          self%h(n, lines), self%stress_x(n, lines), self%stress_y(n, lines), self%friction(n, lines), &
          self%carried(n, lines), self%rate(n, lines), self%rise(0:n + 1, lines, levels), self%old(0:n + 1, 0:1, levels), &
          self%flux(n, lines, 2), self%admittance(n, lines, 2, 2), source=0.0_wp, stat=err)
        if (err == 0) allocate (self%returns((n - 3)/most_columns + 1, lines), source=.false., stat=err)
      end associate
      stat = merge(status_ok, status_no_memory, err == 0)
      if (stat /= status_ok) return
      call to_sweep(self%way, u1, self%u1)
      call to_sweep(self%way, v1, self%v1)
      call to_sweep(self%way, nodes%sliding_x, self%us)
      call to_sweep(self%way, nodes%sliding_y, self%vs)
    end associate
    call new_column_work(self, film, stat)
    if (stat == status_ok) call set_walls(film, self, 0.0_wp, change)
  end subroutine new_point_heat

  !> Adds heat to a point contact whose film is already sheared; arguments as of `new_point_heat`.
  subroutine heat_point_contact(contact, law, u1, v1, body_1, body_2, bulk, stat)
    type(thermal_contact), intent(inout) :: contact
    type(oil_heat_law), intent(in) :: law
    real(wp), intent(in) :: u1(:, :), v1(:, :), bulk(2)
    class(heated_body), allocatable, intent(inout) :: body_1, body_2
    integer, intent(out) :: stat
    type(point_film_heat), allocatable :: heat

    stat = status_bad_argument
    allocate (heat)
    select type (film => contact%film)
    type is (point_contact)
      call new_point_heat(heat, film, law, u1, v1, body_1, body_2, bulk, stat)
    end select
    if (stat == status_ok) call move_alloc(heat, contact%heat)
  end subroutine heat_point_contact

  !> Scratch of each thread.
  subroutine new_column_work(self, film, stat)
    type(point_film_heat), intent(inout) :: self
    class(film_contact), intent(in) :: film
    integer, intent(out) :: stat
    integer :: thread, err

    allocate (self%threads(0:omp_get_max_threads() - 1), stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
    if (stat /= status_ok) return
    associate (levels => film%shear%nodes%levels%count)
      do thread = 0, ubound(self%threads, 1)
        associate (own => self%threads(thread))
          if (stat == status_ok) call new_film_strip(own%columns, most_columns, film%shear%nodes%levels, stat)
          if (stat == status_ok) call new_shear_strip(most_columns, levels, own%shear, stat)
          allocate (own%softening(most_columns, levels), own%u(most_columns, levels), own%v(most_columns, levels), &
            own%rate(most_columns, levels), own%compression(most_columns, levels), own%inflow(most_columns, levels), stat=err)
          if (err /= 0) stat = status_no_memory
        end associate
      end do
    end associate
  end subroutine new_column_work

  !> Number of columns whose shear stress did not converge in the last sweep.
  pure integer function unsolved(self)
    class(point_film_heat), intent(in) :: self

    unsolved = sum(self%threads%shear%unsolved)
  end function unsolved

  !> Resets the initial stresses of sweeps and the marks of backflow.
  subroutine cool(self)
    class(point_film_heat), intent(inout) :: self

    self%stress_x = 0
    self%stress_y = 0
    self%returned = 0
  end subroutine cool

  !> Heat convected by the oil, less that of its compression, at the nodes at the last sweep [W/m2].
  subroutine carried_heat(self, carried)
    class(point_film_heat), intent(in) :: self
    real(wp), intent(out) :: carried(:, :)

    call from_sweep(self%way, self%carried, carried)
  end subroutine carried_heat

  !> Stress at the middle of the film [Pa], heat of shearing [W/m2] and the largest shear rate across the film [1/s] at the
  !> nodes, as of the last sweep.
  subroutine swept_shear(heat, stress_x, stress_y, friction, rate)
    class(film_heat), intent(in) :: heat
    real(wp), intent(out) :: stress_x(:, :), stress_y(:, :), friction(:, :), rate(:, :)

    select type (heat)
    type is (point_film_heat)
      call from_sweep(heat%way, heat%stress_x, stress_x)
      call from_sweep(heat%way, heat%stress_y, stress_y)
      call from_sweep(heat%way, heat%friction, friction)
      call from_sweep(heat%way, heat%rate, rate)
    end select
  end subroutine swept_shear

  !> Makes one sweep over the columns with fixed walls: with the oil, after one against it where columns with backflow have
  !> not converged.
  !>
  !> `change` is the largest change of temperature [K] where the pressure exceeds `least` [Pa].
  subroutine sweep_columns(self, film, least, change)
    class(point_film_heat), intent(inout) :: self
    class(film_contact), intent(inout) :: film
    real(wp), intent(in) :: least
    real(wp), intent(out) :: change
    real(wp) :: settling, returned

    self%threads%shear%unsolved = 0
    call enter_sweep(self, film)
    returned = 0
    if (self%returned > lagging*maxval(self%rise)) then
      call sweep_lines(self, film, least, self%way%lines - 1, 2, -1, settling, returned)
    end if
    call sweep_lines(self, film, least, 2, self%way%lines - 1, 1, change, returned)
    self%returned = returned
    call leave_sweep(self, film)
  end subroutine sweep_columns

  !> Sweeps the lines from..to, one after another; against the oil only columns with backflow.
  !>
  !> `returned` is raised to the largest change of columns with backflow [K].
  subroutine sweep_lines(self, film, least, from, to, onward, change, returned)
    class(point_film_heat), intent(inout) :: self
    class(film_contact), intent(in) :: film
    real(wp), intent(in) :: least
    integer, intent(in) :: from, to, onward
    real(wp), intent(out) :: change
    real(wp), intent(inout) :: returned
    integer :: line, cut, thread

    self%old(:, mod(from, 2), :) = self%rise(:, from, :)
    change = 0
    !$omp parallel private(line, thread) reduction(max:change, returned)
    thread = omp_get_thread_num()
    do line = from, to, onward
      !$omp do schedule(static)
      do cut = 1, size(self%returns, 1)
        if (onward > 0 .or. self%returns(cut, line)) then
          call heat_cut(self, film, line, cut, least, self%threads(thread), change, returned)
        end if
        call keep_line(self, line + onward, cut)
      end do
    end do
    !$omp end parallel
  end subroutine sweep_lines

  !> Copies a cut of a line before it is solved, with the ends of the line and their padding.
  subroutine keep_line(self, line, cut)
    class(point_film_heat), intent(inout) :: self
    integer, intent(in) :: line, cut
    integer :: first, last

    first = merge(0, 2 + (cut - 1)*most_columns, cut == 1)
    last = merge(self%way%length + 1, 1 + cut*most_columns, cut == size(self%returns, 1))
    self%old(first:last, mod(line, 2), :) = self%rise(first:last, line, :)
  end subroutine keep_line

  !> Gathers the input of the columns from the nodes.
  subroutine enter_sweep(self, film)
    class(point_film_heat), intent(inout) :: self
    class(film_contact), intent(in) :: film
    integer :: k

    call to_sweep(self%way, film%fields%p, self%p)
    call to_sweep(self%way, film%fields%h, self%h)
    do k = 1, film%shear%nodes%levels%count
      call to_sweep(self%way, film%shear%nodes%rise(:, :, k), self%rise(1:self%way%length, :, k))
    end do
  end subroutine enter_sweep

  !> Scatters the results of the columns to the nodes and the walls.
  subroutine leave_sweep(self, film)
    class(point_film_heat), intent(inout) :: self
    class(film_contact), intent(inout) :: film
    integer :: i, k

    do k = 1, film%shear%nodes%levels%count
      call from_sweep(self%way, self%rise(1:self%way%length, :, k), film%shear%nodes%rise(:, :, k))
    end do
    do k = 1, 2
      call from_sweep(self%way, self%flux(:, :, k), self%walls%flux(:, :, k))
      do i = 1, 2
        call from_sweep(self%way, self%admittance(:, :, i, k), self%walls%admittance(:, :, i, k))
      end do
    end do
  end subroutine leave_sweep

  !> Solves the columns of a cut of a line.
  subroutine heat_cut(self, film, line, cut, least, work, change, returned)
    class(point_film_heat), intent(inout) :: self
    class(film_contact), intent(in) :: film
    integer, intent(in) :: line, cut
    real(wp), intent(in) :: least
    type(column_work), intent(inout) :: work
    real(wp), intent(inout) :: change, returned
    real(wp), dimension(most_columns) :: mean, capacity, carried, warmed, fastest, friction
    integer :: first, last, m, k, i

    first = 2 + (cut - 1)*most_columns
    last = min(1 + cut*most_columns, self%way%length - 1)
    m = last - first + 1
    associate (nodes => film%shear%nodes, p => self%p(first:last, line), u1 => self%u1(first:last, line), &
        v1 => self%v1(first:last, line), shear => work%shear, columns => work%columns)
      shear%points = m
      shear%film(:m) = max(self%h(first:last, line), film%floor)
      shear%us(:m) = self%us(first:last, line)
      shear%vs(:m) = self%vs(first:last, line)
      shear%tau_x(:m) = self%stress_x(first:last, line)
      shear%tau_y(:m) = self%stress_y(first:last, line)
      if (self%way%along_x) then
        call take_gradient(self, line, first, last, shear%py, shear%px)
      else
        call take_gradient(self, line, first, last, shear%px, shear%py)
      end if
      do k = 1, nodes%levels%count
        columns%known(:m, k) = self%rise(first:last, line, k)
      end do
      call shear_columns(film%oil, nodes, p, columns%known, shear, mean, work%softening)
      call set_heat(self%law, film%oil, nodes, shear, p, mean, u1, v1, work%softening, columns, capacity, work%u, work%v, &
        work%compression)
      call film_shear_rate(nodes%levels, shear, work%rate)
      self%stress_x(first:last, line) = shear%tau_x(:m)
      self%stress_y(first:last, line) = shear%tau_y(:m)
      if (self%way%along_x) then
        call carry(self, line, first, last, capacity, work%v, work%u, columns%absorption, work%inflow)
        self%returns(cut, line) = any(work%u(:m, :)*self%way%per_line < 0)
      else
        call carry(self, line, first, last, capacity, work%u, work%v, columns%absorption, work%inflow)
        self%returns(cut, line) = any(work%v(:m, :)*self%way%per_line < 0)
      end if
      fastest = 0
      friction = 0
      do k = 1, nodes%levels%count
        fastest(:m) = max(fastest(:m), work%rate(:m, k))
        friction(:m) = friction(:m) + shear%film(:m)*nodes%levels%weight(k)*columns%source(:m, k)
        work%inflow(:m, k) = work%inflow(:m, k) + work%compression(:m, k)
        columns%source(:m, k) = columns%source(:m, k) + work%inflow(:m, k)
      end do
      call solve_columns(columns)
      call carried_away(columns, work%inflow, carried)
      self%rate(first:last, line) = fastest(:m)
      self%friction(first:last, line) = friction(:m)
      self%carried(first:last, line) = carried(:m)
      warmed = 0
      do k = 1, nodes%levels%count
        warmed(:m) = max(warmed(:m), abs(columns%temperature(:m, k) - columns%known(:m, k)))
        self%rise(first:last, line, k) = columns%temperature(:m, k)
      end do
      change = max(change, maxval(warmed(:m), mask=p > least))
      if (self%returns(cut, line)) returned = max(returned, maxval(warmed(:m)))
      do k = 1, 2
        self%flux(first:last, line, k) = columns%flux(:m, k)
        do i = 1, 2
          self%admittance(first:last, line, i, k) = columns%admittance(:m, i, k)
        end do
      end do
    end associate
  end subroutine heat_cut

  !> Pressure gradient at nodes of a line, along it and from line to line [Pa/m].
  pure subroutine take_gradient(self, line, first, last, along, across)
    class(point_film_heat), intent(in) :: self
    integer, intent(in) :: line, first, last
    real(wp), intent(inout) :: along(:), across(:)
    integer :: m

    m = last - first + 1
    along(:m) = (self%p(first + 1:last + 1, line) - self%p(first - 1:last - 1, line))*(self%way%per_node/2)
    across(:m) = (self%p(first:last, line + 1) - self%p(first:last, line - 1))*(self%way%per_line/2)
  end subroutine take_gradient

  !> Computes the heat convected from the levels of a line's columns per kelvin, `absorption` [W/(m3 K)], and to them,
  !> `inflow` [W/m3]. Oil moves with (along, across) the line [m/s].
  subroutine carry(self, line, first, last, capacity, along, across, absorption, inflow)
    class(point_film_heat), intent(in) :: self
    integer, intent(in) :: line, first, last
    real(wp), contiguous, intent(in) :: capacity(:), along(:, :), across(:, :)
    real(wp), contiguous, intent(inout) :: absorption(:, :), inflow(:, :)
    integer :: k, before

    ! the first line solved has only one before it
    before = max(line - 2, 1)
    do k = 1, size(along, 2)
      call carry_level(last - first + 1, first == 2, last == self%way%length - 1, line > 2, &
        self%rise(first - 2:last + 2, before, k), self%rise(first - 1:last + 1, line - 1, k), &
        self%old(first - 1:last + 1, mod(line, 2), k), self%rise(first - 1:last + 1, line + 1, k), capacity, &
        self%way%per_node, self%way%per_line, along(:, k), across(:, k), absorption(:, k), inflow(:, k))
    end do
  end subroutine carry

end module point_heat
