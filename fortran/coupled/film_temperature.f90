!> Temperature of the film of a point contact and of the surfaces beside it, at a given pressure and film.
!>
!> Sharif et al. (2001), eqs 18, 19 and 21: heat is conducted across the film, carried along it, made by shearing and
!> by compression. A sweep solves the columns line after line in the direction in which oil moves, upwind by the
!> velocity of each level; what comes from later lines, or along a line, is as it was. Walls are as they were too, but
!> the columns' answer to a change of the walls is kept, with which the balance of the walls is solved
!> for the whole contact at the end: in a thin film the flux follows the walls so closely that taking turns diverges.
!>
!> Conduction along the film is left out: against that across it, it is as the square of film over contact length.
module film_temperature
  use column_heat, only: hottest, set_heat, carried_away
  use film_column, only: film_strip, new_film_strip, solve_columns
  use heated_surface, only: heated_body
  use interruption, only: interrupted
  use kinds, only: wp
  use march_layout, only: march, new_march, to_march, from_march
  use nodal_shear, only: shear_columns
  use oil_heat, only: oil_heat_law
  use omp_lib, only: omp_get_max_threads, omp_get_thread_num
  use point_film, only: point_contact, film_direction, move_film, film_balance, bearable, search_step
  use shear_flow, only: shear_strip, new_shear_strip, film_shear_rate
  use status, only: status_ok, status_interrupted, status_not_finite, status_no_memory
  use tally, only: work_tally
  use wall_balance, only: wall_pair, new_wall_pair, balance_walls
  implicit none(type, external)
  private

  public :: heated_contact, heat_contact, heated_step, heat_sweep, set_temperature

  !> Columns treated together, whatever the number of threads.
  integer, parameter :: most_columns = 32
  !> Share of the largest pressure above which temperatures must settle; elsewhere they move little oil.
  real(wp), parameter :: judged_pressure = 0.02_wp
  !> Change of the columns in which oil flows against the march, over the largest rise, from which they are swept so too.
  real(wp), parameter :: lagging = 0.01_wp
  !> Share of the walls' imbalance that a sweep leaves, and the Krylov iterations that it may take.
  real(wp), parameter :: wall_tolerance = 0.1_wp
  integer, parameter :: most_wall_iterations = 8
  !> Least share of a sweep's change that is taken.
  real(wp), parameter :: least_share = 0.125_wp

  !> What a thread works on: columns and their shear, and of their levels the derivative of the fluidity by temperature
  !> [1/(Pa s K)], velocities along and across the line [m/s], the rate of shear [1/s], and the heat that compression and
  !> oil bring [W/m3].
  type :: column_work
    type(film_strip) :: columns
    type(shear_strip) :: shear
    real(wp), dimension(:, :), allocatable :: softening, u, v, rate, compression, inflow
  end type column_work

  !> Temperatures are those above the inlet's. Fields are as the march meets them, (length, lines).
  type :: film_heat
    type(oil_heat_law) :: law
    type(march) :: way
    !> Velocity of body 1's surface and of body 2 relative to it [m/s].
    real(wp), allocatable :: u1(:, :), v1(:, :), us(:, :), vs(:, :)
    !> Pressure [Pa] and film [m].
    real(wp), allocatable :: p(:, :), h(:, :)
    type(wall_pair) :: walls
    !> Stress at the middle of the film [Pa], from which the next sweep starts.
    real(wp), allocatable :: stress_x(:, :), stress_y(:, :)
    !> Heat of shearing, and what oil carries away less what compression gives it [W/m2]; the largest shear rate across
    !> the film [1/s].
    real(wp), allocatable :: friction(:, :), carried(:, :), rate(:, :)
    !> Temperature, (0:length + 1, lines, levels), with room for what would lie beside the ends of a line; that of the
    !> line in work, and of the next, before the sweep, line k at mod(k, 2).
    real(wp), allocatable :: rise(:, :, :), old(:, :, :)
    !> Whether oil flows against the march in the columns of a cut, (cuts, lines), and by how much a sweep changed them [K].
    logical, allocatable :: returns(:, :)
    real(wp) :: returned = 0
    !> Flux into the walls and its derivatives (`wall_balance`), (length, lines, wall) and (length, lines, wall, wall).
    real(wp), allocatable :: flux(:, :, :), admittance(:, :, :, :)
    !> Temperature at the nodes of the grid before a step.
    real(wp), allocatable :: before(:, :, :)
    !> Share of a sweep's change that is taken, now and in the step before (nought if there was none), and the whole
    !> change of the sweep in the step before [K].
    real(wp) :: share = 1, last_share = 0
    real(wp), allocatable :: wanted(:, :, :)
    !> Scratch of each thread.
    type(column_work), allocatable :: threads(:)
    type(work_tally) :: work
  end type film_heat

  !> A point contact and its temperature, which is there where heat is simulated.
  type, extends(point_contact) :: heated_contact
    type(film_heat), allocatable :: heat
  end type heated_contact

contains

  !> Gives a contact whose film is already sheared its heat.
  !>
  !> u1 and v1 are the nodal velocity of body 1's surface [m/s]; the bodies move into the contact, `bulk` being their
  !> temperature far below the surface, above the inlet's [K].
  subroutine heat_contact(self, law, u1, v1, body_1, body_2, bulk, stat)
    type(heated_contact), intent(inout) :: self
    type(oil_heat_law), intent(in) :: law
    real(wp), intent(in) :: u1(:, :), v1(:, :), bulk(2)
    class(heated_body), allocatable, intent(inout) :: body_1, body_2
    integer, intent(out) :: stat
    real(wp) :: change
    integer :: nx, ny, levels, thread, err

    nx = self%grid%nx
    ny = self%grid%ny
    levels = self%shear%nodes%levels%count
    allocate (self%heat)
    associate (heat => self%heat, grid => self%grid, nodes => self%shear%nodes)
      heat%law = law
      heat%way = new_march(nx, ny, grid%dx, grid%dy, self%cycles%transposed, .not. self%cycles%rising)
      call new_wall_pair(heat%walls, body_1, bulk(1), body_2, bulk(2), most_wall_iterations, stat)
      if (stat /= status_ok) return
      associate (n => heat%way%length, lines => heat%way%lines)
        allocate (heat%u1(n, lines), heat%v1(n, lines), heat%us(n, lines), heat%vs(n, lines), heat%p(n, lines), &
          heat%h(n, lines), heat%stress_x(n, lines), heat%stress_y(n, lines), heat%friction(n, lines), &
          heat%carried(n, lines), heat%rate(n, lines), heat%rise(0:n + 1, lines, levels), heat%old(0:n + 1, 0:1, levels), &
          heat%flux(n, lines, 2), heat%admittance(n, lines, 2, 2), heat%before(nx, ny, levels), &
          heat%wanted(nx, ny, levels), source=0.0_wp, stat=err)
        if (err == 0) allocate (heat%returns((n - 3)/most_columns + 1, lines), source=.false., stat=err)
      end associate
      if (err == 0) allocate (heat%threads(0:omp_get_max_threads() - 1), stat=err)
      stat = merge(status_ok, status_no_memory, err == 0)
      if (stat /= status_ok) return
      call to_march(heat%way, u1, heat%u1)
      call to_march(heat%way, v1, heat%v1)
      call to_march(heat%way, nodes%sliding_x, heat%us)
      call to_march(heat%way, nodes%sliding_y, heat%vs)
      do thread = 0, ubound(heat%threads, 1)
        associate (own => heat%threads(thread))
          if (stat == status_ok) call new_film_strip(own%columns, most_columns, nodes%levels, stat)
          if (stat == status_ok) call new_shear_strip(most_columns, levels, own%shear, stat)
          allocate (own%softening(most_columns, levels), own%u(most_columns, levels), own%v(most_columns, levels), &
            own%rate(most_columns, levels), own%compression(most_columns, levels), own%inflow(most_columns, levels), stat=err)
          if (err /= 0) stat = status_no_memory
        end associate
      end do
    end associate
    call set_walls(self, 0.0_wp, change)
  end subroutine heat_contact

  !> One Newton step of the film from (p, h0), about which it was last evaluated, one sweep of heat at the new film, and
  !> the film's balance there.
  !>
  !> For the arguments see `film_step`, for `change` `heat_sweep`. The whole of Newton's step is judged after the heat
  !> that follows it, so that flows are evaluated once. Where that is too much, by the step or by the heat, the step
  !> is sought at the temperature before, and heat follows by half at most: a film that has thinned under pressure from
  !> before makes heat without bound. Heat is swept even if no step helps.
  subroutine heated_step(self, forcing, p, h0, residual, load_error, krylov, step, change, stat)
    type(heated_contact), intent(inout) :: self
    real(wp), intent(in) :: forcing
    real(wp), contiguous, intent(inout) :: p(:, :)
    real(wp), intent(inout) :: h0, residual, load_error
    integer, intent(out) :: krylov, stat
    real(wp), intent(out) :: step, change
    real(wp) :: merit, most
    integer :: heat_stat

    step = 0
    change = hottest
    merit = residual + abs(load_error)
    call film_direction(self%point_contact, forcing, p, h0, load_error, krylov, stat)
    if (stat /= status_ok) return
    self%heat%before(:, :, :) = self%shear%nodes%rise
    step = 1
    call move_film(self%point_contact, step, p, h0)
    call warm_film(self, 1.0_wp, residual, load_error, change, heat_stat)
    if (heat_stat == status_interrupted) stat = heat_stat
    if (stat /= status_ok) return
    if (heat_stat /= status_ok .or. .not. bearable(merit, residual, load_error)) then
      call set_temperature(self, self%heat%before)
      call search_step(self%point_contact, merit, p, h0, residual, load_error, step, stat)
      most = merge(0.5_wp, 1.0_wp, self%heat%last_share > 0)
      call warm_film(self, most, residual, load_error, change, heat_stat)
      if (heat_stat /= status_ok) then
        stat = heat_stat
        change = hottest
        return
      end if
    end if
    self%heat%last_share = self%heat%share
    self%heat%wanted(:, :, :) = (self%shear%nodes%rise - self%heat%before)/self%heat%share
  end subroutine heated_step

  !> A sweep of heat, of whose change the share that settles is taken, `most` of it at most, and the balance of the film
  !> that it leaves.
  subroutine warm_film(self, most, residual, load_error, change, stat)
    type(heated_contact), intent(inout) :: self
    real(wp), intent(in) :: most
    real(wp), intent(inout) :: residual, load_error
    real(wp), intent(out) :: change
    integer, intent(out) :: stat

    self%heat%share = 1
    call heat_sweep(self, change, stat)
    if (stat /= status_ok) return
    associate (heat => self%heat, rise => self%shear%nodes%rise)
      heat%share = min(settling_share(self), most)
      if (heat%share < 1) call set_temperature(self, heat%before + heat%share*(rise - heat%before))
    end associate
    call film_balance(self%point_contact, residual, load_error)
  end subroutine warm_film

  !> Share of a sweep's change to be taken: less than all where sweeps undo or redouble what those before did, by
  !> Aitken's extrapolation over the nodes where pressure counts (Kuettler and Wall 2008).
  real(wp) function settling_share(self) result(share)
    type(heated_contact), intent(in) :: self
    real(wp) :: turn, length, least, bend
    integer :: i, j, k

    turn = 0
    length = 0
    least = judged_pressure*maxval(self%fields%p)
    associate (heat => self%heat, rise => self%shear%nodes%rise)
      do k = 1, size(rise, 3)
        do j = 1, size(rise, 2)
          do i = 1, size(rise, 1)
            if (.not. self%fields%p(i, j) > least) cycle
            bend = rise(i, j, k) - heat%before(i, j, k) - heat%wanted(i, j, k)
            turn = turn - bend*heat%wanted(i, j, k)
            length = length + bend**2
          end do
        end do
      end do
      share = 1
      if (heat%last_share > 0 .and. length > 0) share = min(max(heat%last_share*turn/length, least_share), 1.0_wp)
    end associate
  end function settling_share

  !> One sweep over the columns, with the entrainment, then the balance of the walls.
  !>
  !> `change` is the largest change of temperature [K] where pressure counts. If it leaves all sense, the contact is
  !> given back as cold as its bodies.
  subroutine heat_sweep(self, change, stat)
    type(heated_contact), intent(inout) :: self
    real(wp), intent(out) :: change
    integer, intent(out) :: stat
    real(wp) :: least, missed, reduction, walls_change
    integer :: iterations

    change = hottest
    stat = status_interrupted
    if (interrupted()) return
    call self%heat%work%start()
    least = judged_pressure*maxval(self%fields%p)
    self%heat%threads%shear%unsolved = 0
    call heat_columns(self, self%heat, least, change)
    ! nor is heat of a stress that was not found to count as settled
    if (sum(self%heat%threads%shear%unsolved) > 0) change = hottest
    ! the walls of a film that has left all sense may not even be numbers in single precision
    call judge_temperature(self, stat)
    if (stat == status_ok) then
      call balance_walls(self%heat%walls, wall_tolerance, missed, iterations, reduction)
      call set_walls(self, least, walls_change)
      change = max(change, walls_change)
      call judge_temperature(self, stat)
    end if
    call self%heat%work%finish()
  end subroutine heat_sweep

  !> Whether the film is between absolute zero and what no oil bears; if not it is cooled down.
  subroutine judge_temperature(self, stat)
    type(heated_contact), intent(inout) :: self
    integer, intent(out) :: stat
    real(wp) :: change
    integer :: i

    stat = status_ok
    associate (rise => self%shear%nodes%rise, walls => self%heat%walls)
      if (all(rise > -self%oil%temperature .and. rise < hottest)) return
      stat = status_not_finite
      rise = 0
      self%heat%stress_x = 0
      self%heat%stress_y = 0
      walls%flux = 0
      walls%admittance = 0
      self%heat%returned = 0
      self%heat%last_share = 0
      do i = 1, 2
        walls%wall(:, :, i) = walls%body(i)%bulk
      end do
    end associate
    call set_walls(self, 0.0_wp, change)
  end subroutine judge_temperature

  !> Takes up a temperature above the inlet's [K], at the levels.
  subroutine set_temperature(self, rise)
    type(heated_contact), intent(inout) :: self
    real(wp), intent(in) :: rise(:, :, :)

    self%shear%nodes%rise(:, :, :) = rise
    self%heat%walls%wall(:, :, 1) = rise(:, :, 1)
    self%heat%walls%wall(:, :, 2) = rise(:, :, size(rise, 3))
  end subroutine set_temperature

  !> Gives the film the walls' temperature; what lies between follows as by conduction alone. On the outline it keeps
  !> the inlet's. `change` is the largest of a wall [K] at more than a pressure of `least` [Pa].
  subroutine set_walls(self, least, change)
    type(heated_contact), intent(inout) :: self
    real(wp), intent(in) :: least
    real(wp), intent(out) :: change
    real(wp) :: change_1(self%grid%nx), change_2(self%grid%nx)
    integer :: j, k, inner

    change = 0
    inner = self%grid%nx - 1
    associate (rise => self%shear%nodes%rise, levels => self%shear%nodes%levels, wall => self%heat%walls%wall)
      !$omp parallel do private(k, change_1, change_2) reduction(max:change) schedule(static)
      do j = 1, self%grid%ny
        change_1 = wall(:, j, 1) - rise(:, j, 1)
        change_2 = wall(:, j, 2) - rise(:, j, levels%count)
        change = max(change, maxval(max(abs(change_1), abs(change_2)), mask=self%fields%p(:, j) > least))
        rise(:, j, 1) = wall(:, j, 1)
        rise(:, j, levels%count) = wall(:, j, 2)
        if (j == 1 .or. j == self%grid%ny) cycle
        do k = 2, levels%count - 1
          rise(2:inner, j, k) = rise(2:inner, j, k) + (0.5_wp - levels%z(k))*change_1(2:inner) &
            + (0.5_wp + levels%z(k))*change_2(2:inner)
        end do
      end do
    end associate
  end subroutine set_walls

  !> One sweep over the columns, with walls as they are: with the march, after one against it where oil that flows so has
  !> not settled.
  !>
  !> `change` is the largest of temperature [K] at more than a pressure of `least` [Pa].
  subroutine heat_columns(self, heat, least, change)
    type(heated_contact), intent(inout) :: self
    type(film_heat), intent(inout) :: heat
    real(wp), intent(in) :: least
    real(wp), intent(out) :: change
    real(wp) :: settling, returned

    call enter_march(self, heat)
    returned = 0
    if (heat%returned > lagging*maxval(heat%rise)) call heat_lines(self, heat, least, heat%way%lines - 1, 2, -1, settling, returned)
    call heat_lines(self, heat, least, 2, heat%way%lines - 1, 1, change, returned)
    heat%returned = returned
    call leave_march(self, heat)
  end subroutine heat_columns

  !> The lines from..to, one after another; against the march only where oil flows so.
  !>
  !> `returned` grows to the largest change where it does [K].
  subroutine heat_lines(self, heat, least, from, to, onward, change, returned)
    type(heated_contact), intent(in) :: self
    type(film_heat), intent(inout) :: heat
    real(wp), intent(in) :: least
    integer, intent(in) :: from, to, onward
    real(wp), intent(out) :: change
    real(wp), intent(inout) :: returned
    integer :: line, cut, thread

    heat%old(:, mod(from, 2), :) = heat%rise(:, from, :)
    change = 0
    !$omp parallel private(line, thread) reduction(max:change, returned)
    thread = omp_get_thread_num()
    do line = from, to, onward
      !$omp do schedule(static)
      do cut = 1, size(heat%returns, 1)
        if (onward > 0 .or. heat%returns(cut, line)) then
          call heat_cut(self, line, cut, least, heat, heat%threads(thread), change, returned)
        end if
        call keep_line(heat, line + onward, cut)
      end do
    end do
    !$omp end parallel
  end subroutine heat_lines

  !> Keeps a cut of a line as it is before it is worked on, with the ends of the line and the room beside them.
  subroutine keep_line(heat, line, cut)
    type(film_heat), intent(inout) :: heat
    integer, intent(in) :: line, cut
    integer :: first, last

    first = merge(0, 2 + (cut - 1)*most_columns, cut == 1)
    last = merge(heat%way%length + 1, 1 + cut*most_columns, cut == size(heat%returns, 1))
    heat%old(first:last, mod(line, 2), :) = heat%rise(first:last, line, :)
  end subroutine keep_line

  !> What the columns need from the nodes of the grid.
  subroutine enter_march(self, heat)
    type(heated_contact), intent(in) :: self
    type(film_heat), intent(inout) :: heat
    integer :: k

    call to_march(heat%way, self%fields%p, heat%p)
    call to_march(heat%way, self%fields%h, heat%h)
    do k = 1, self%shear%nodes%levels%count
      call to_march(heat%way, self%shear%nodes%rise(:, :, k), heat%rise(1:heat%way%length, :, k))
    end do
  end subroutine enter_march

  !> What the columns give to the nodes and to the walls.
  subroutine leave_march(self, heat)
    type(heated_contact), intent(inout) :: self
    type(film_heat), intent(inout) :: heat
    integer :: i, k

    do k = 1, self%shear%nodes%levels%count
      call from_march(heat%way, heat%rise(1:heat%way%length, :, k), self%shear%nodes%rise(:, :, k))
    end do
    do k = 1, 2
      call from_march(heat%way, heat%flux(:, :, k), heat%walls%flux(:, :, k))
      do i = 1, 2
        call from_march(heat%way, heat%admittance(:, :, i, k), heat%walls%admittance(:, :, i, k))
      end do
    end do
  end subroutine leave_march

  !> The columns of a cut of a line.
  subroutine heat_cut(self, line, cut, least, heat, work, change, returned)
    type(heated_contact), intent(in) :: self
    integer, intent(in) :: line, cut
    real(wp), intent(in) :: least
    type(film_heat), intent(inout) :: heat
    type(column_work), intent(inout) :: work
    real(wp), intent(inout) :: change, returned
    real(wp), dimension(most_columns) :: mean, capacity, carried, warmed, fastest, friction
    integer :: first, last, m, k, i

    first = 2 + (cut - 1)*most_columns
    last = min(1 + cut*most_columns, heat%way%length - 1)
    m = last - first + 1
    associate (nodes => self%shear%nodes, p => heat%p(first:last, line), u1 => heat%u1(first:last, line), &
        v1 => heat%v1(first:last, line), shear => work%shear, columns => work%columns)
      shear%points = m
      shear%film(:m) = max(heat%h(first:last, line), self%floor)
      shear%us(:m) = heat%us(first:last, line)
      shear%vs(:m) = heat%vs(first:last, line)
      shear%tau_x(:m) = heat%stress_x(first:last, line)
      shear%tau_y(:m) = heat%stress_y(first:last, line)
      if (heat%way%along_x) then
        call take_gradient(heat, line, first, last, shear%py, shear%px)
      else
        call take_gradient(heat, line, first, last, shear%px, shear%py)
      end if
      do k = 1, nodes%levels%count
        columns%known(:m, k) = heat%rise(first:last, line, k)
      end do
      call shear_columns(self%oil, nodes, p, columns%known, shear, mean, work%softening)
      call set_heat(heat%law, self%oil, nodes, shear, p, mean, u1, v1, work%softening, columns, capacity, work%u, work%v, &
        work%compression)
      call film_shear_rate(nodes%levels, shear, work%rate)
      heat%stress_x(first:last, line) = shear%tau_x(:m)
      heat%stress_y(first:last, line) = shear%tau_y(:m)
      if (heat%way%along_x) then
        call carry(heat, line, first, last, capacity, work%v, work%u, columns%absorption, work%inflow)
        heat%returns(cut, line) = any(work%u(:m, :)*heat%way%per_line < 0)
      else
        call carry(heat, line, first, last, capacity, work%u, work%v, columns%absorption, work%inflow)
        heat%returns(cut, line) = any(work%v(:m, :)*heat%way%per_line < 0)
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
      heat%rate(first:last, line) = fastest(:m)
      heat%friction(first:last, line) = friction(:m)
      heat%carried(first:last, line) = carried(:m)
      warmed = 0
      do k = 1, nodes%levels%count
        warmed(:m) = max(warmed(:m), abs(columns%temperature(:m, k) - columns%known(:m, k)))
        heat%rise(first:last, line, k) = columns%temperature(:m, k)
      end do
      change = max(change, maxval(warmed(:m), mask=p > least))
      if (heat%returns(cut, line)) returned = max(returned, maxval(warmed(:m)))
      do k = 1, 2
        heat%flux(first:last, line, k) = columns%flux(:m, k)
        do i = 1, 2
          heat%admittance(first:last, line, i, k) = columns%admittance(:m, i, k)
        end do
      end do
    end associate
  end subroutine heat_cut

  !> Pressure gradient at nodes of a line, along it and from line to line [Pa/m].
  pure subroutine take_gradient(heat, line, first, last, along, across)
    type(film_heat), intent(in) :: heat
    integer, intent(in) :: line, first, last
    real(wp), intent(inout) :: along(:), across(:)
    integer :: m

    m = last - first + 1
    along(:m) = (heat%p(first + 1:last + 1, line) - heat%p(first - 1:last - 1, line))*(heat%way%per_node/2)
    across(:m) = (heat%p(first:last, line + 1) - heat%p(first:last, line - 1))*(heat%way%per_line/2)
  end subroutine take_gradient

  !> What convection takes from the levels of a line's columns for each kelvin, `absorption` [W/(m3 K)], and brings them,
  !> `inflow` [W/m3]. Oil moves with (along, across) the line [m/s].
  subroutine carry(heat, line, first, last, capacity, along, across, absorption, inflow)
    type(film_heat), intent(in) :: heat
    integer, intent(in) :: line, first, last
    real(wp), contiguous, intent(in) :: capacity(:), along(:, :), across(:, :)
    real(wp), contiguous, intent(inout) :: absorption(:, :), inflow(:, :)
    integer :: k, before

    ! the first line in work has but one before it
    before = max(line - 2, 1)
    do k = 1, size(along, 2)
      call carry_level(last - first + 1, first == 2, last == heat%way%length - 1, line > 2, &
        heat%rise(first - 2:last + 2, before, k), heat%rise(first - 1:last + 1, line - 1, k), &
        heat%old(first - 1:last + 1, mod(line, 2), k), heat%rise(first - 1:last + 1, line + 1, k), capacity, &
        heat%way%per_node, heat%way%per_line, along(:, k), across(:, k), absorption(:, k), inflow(:, k))
    end do
  end subroutine carry

  !> The same for one level of m columns, with the temperature of its own line and of those about it, at so many nodes and
  !> lines per metre.
  !>
  !> Oil comes from the foot of its path on the square of the eight nodes about its own; where that lies on the line
  !> before, a second foot two lines back makes the difference along the path one of second order, unless there is no
  !> such line (`two_back`) or the foot lies beyond its end (`at_first`, `at_last`). Elsewhere values lag behind, and
  !> only a first-order difference is sure not to let their errors grow from sweep to sweep.
  pure subroutine carry_level(m, at_first, at_last, two_back, far, back, here, ahead, capacity, per_node, per_line, u, v, &
    absorption, inflow)
    integer, intent(in) :: m
    logical, intent(in) :: at_first, at_last, two_back
    real(wp), intent(in) :: far(-1:m + 2), back(0:m + 1), here(0:m + 1), ahead(0:m + 1), capacity(m), per_node, per_line, &
      u(m), v(m)
    real(wp), intent(out) :: absorption(m), inflow(m)
    !> One or nought: oil comes from the left, from the line before, and rather from a line than along it; its second foot
    !> is to be had.
    real(wp) :: left, behind, crossing, reached
    real(wp) :: along, across, rate, skew, beside, foot, second, order
    integer :: c, low, high

    low = merge(1, 0, at_first)
    high = merge(m, m + 1, at_last)
    ! weights instead of branches let the loop be vectorised
    do c = 1, m
      along = u(c)*per_node
      across = v(c)*per_line
      left = merge(1.0_wp, 0.0_wp, along > 0)
      behind = merge(1.0_wp, 0.0_wp, across > 0)
      crossing = merge(1.0_wp, 0.0_wp, abs(across) >= abs(along))
      rate = max(abs(across), abs(along), tiny(rate))
      skew = min(abs(across), abs(along))/rate
      reached = left*merge(1.0_wp, 0.0_wp, c > low) + (1 - left)*merge(1.0_wp, 0.0_wp, c < high)
      reached = max(reached, merge(1.0_wp, 0.0_wp, skew < 0.5_wp))
      order = 0.5_wp*merge(1.0_wp, 0.0_wp, two_back)*behind*crossing*reached
      beside = left*(behind*back(c - 1) + (1 - behind)*ahead(c - 1)) &
        + (1 - left)*(behind*back(c + 1) + (1 - behind)*ahead(c + 1))
      foot = skew*beside + (1 - skew)*(crossing*(behind*back(c) + (1 - behind)*ahead(c)) &
        + (1 - crossing)*(left*here(c - 1) + (1 - left)*here(c + 1)))
      second = max(1 - 2*skew, 0.0_wp)*far(c) + (1 - abs(2*skew - 1))*(left*far(c - 1) + (1 - left)*far(c + 1)) &
        + max(2*skew - 1, 0.0_wp)*(left*far(c - 2) + (1 - left)*far(c + 2))
      absorption(c) = (1 + order)*capacity(c)*rate
      inflow(c) = capacity(c)*rate*((1 + 2*order)*foot - order*second)
    end do
  end subroutine carry_level

end module film_temperature
