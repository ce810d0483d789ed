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
  use kinds, only: wp
  use oil_heat, only: oil_heat_law
  use nodal_shear, only: line_cut, take, put, shear_cut
  use omp_lib, only: omp_get_max_threads, omp_get_thread_num
  use point_film, only: point_contact, film_direction, move_film, film_balance, bearable, search_step
  use shear_flow, only: shear_strip, new_shear_strip, film_shear_rate
  use status, only: status_ok, status_not_finite, status_no_memory
  use tally, only: work_tally
  use wall_balance, only: wall_pair, new_wall_pair, balance_walls
  implicit none(type, external)
  private

  public :: heated_contact, heat_contact, heated_step, heat_sweep, set_temperature

  !> Columns treated together.
  integer, parameter :: most_columns = 64
  !> Share of the largest pressure above which temperatures must settle; elsewhere they move little oil.
  real(wp), parameter :: judged_pressure = 0.02_wp
  !> Share of the walls' imbalance that a sweep leaves, and the Krylov iterations that it may take.
  real(wp), parameter :: wall_tolerance = 0.1_wp
  integer, parameter :: most_wall_iterations = 8

  !> Temperatures are those above the inlet's.
  type :: film_heat
    type(oil_heat_law) :: law
    !> Velocities of body 1's surface at the nodes [m/s].
    real(wp), allocatable :: u1(:, :), v1(:, :)
    type(wall_pair) :: walls
    !> Stress at the middle of the film [Pa], from which the next sweep starts.
    real(wp), allocatable :: stress_x(:, :), stress_y(:, :)
    !> Heat of shearing, and what oil carries away less what compression gives it [W/m2]; the largest shear rate across
    !> the film [1/s].
    real(wp), allocatable :: friction(:, :), carried(:, :), rate(:, :)
    !> Temperature of the line in work and of two on either side, as they stand, line k at mod(k, 5); what the line in
    !> work becomes, which its own columns are not to see before all are done. (columns, levels).
    real(wp), allocatable :: lines(:, :, :), renewed(:, :)
    !> Temperature before a step.
    real(wp), allocatable :: before(:, :, :)
    !> Scratch of each thread.
    type(film_strip), allocatable :: columns(:)
    type(shear_strip), allocatable :: shear(:)
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
    integer :: nx, ny, levels, thread, err

    nx = self%grid%nx
    ny = self%grid%ny
    levels = self%shear%nodes%levels%count
    allocate (self%heat)
    associate (heat => self%heat)
      heat%law = law
      call new_wall_pair(heat%walls, body_1, bulk(1), body_2, bulk(2), most_wall_iterations, stat)
      if (stat /= status_ok) return
      allocate (heat%u1(nx, ny), heat%v1(nx, ny), heat%stress_x(nx, ny), heat%stress_y(nx, ny), heat%friction(nx, ny), &
        heat%carried(nx, ny), heat%rate(nx, ny), heat%lines(merge(ny, nx, self%cycles%transposed), levels, 0:4), &
        heat%renewed(merge(ny, nx, self%cycles%transposed), levels), heat%before(nx, ny, levels), source=0.0_wp, stat=err)
      if (err == 0) allocate (heat%columns(0:omp_get_max_threads() - 1), heat%shear(0:omp_get_max_threads() - 1), stat=err)
      stat = merge(status_ok, status_no_memory, err == 0)
      if (stat /= status_ok) return
      heat%u1(:, :) = u1
      heat%v1(:, :) = v1
      do thread = 0, ubound(heat%columns, 1)
        if (stat == status_ok) call new_film_strip(heat%columns(thread), most_columns, self%shear%nodes%levels, stat)
        if (stat == status_ok) call new_shear_strip(most_columns, levels, heat%shear(thread), stat)
      end do
    end associate
    call set_walls(self)
  end subroutine heat_contact

  !> One Newton step of the film from (p, h0), about which it was last evaluated, one sweep of heat at the new film, and
  !> the film's balance there.
  !>
  !> For the arguments see `film_step`, for `change` `heat_sweep`. The whole of Newton's step is judged after the heat
  !> that follows it, so that flows are evaluated once. Where that is too much, by the step or by the heat, the step
  !> is sought at the temperature before. Heat is swept even if no step helps.
  subroutine heated_step(self, forcing, p, h0, residual, load_error, krylov, step, change, stat)
    type(heated_contact), intent(inout) :: self
    real(wp), intent(in) :: forcing
    real(wp), contiguous, intent(inout) :: p(:, :)
    real(wp), intent(inout) :: h0, residual, load_error
    integer, intent(out) :: krylov, stat
    real(wp), intent(out) :: step, change
    real(wp) :: merit
    integer :: heat_stat

    step = 0
    change = hottest
    merit = residual + abs(load_error)
    call film_direction(self%point_contact, forcing, p, h0, load_error, krylov, stat)
    if (stat /= status_ok) return
    self%heat%before(:, :, :) = self%shear%nodes%rise
    step = 1
    call move_film(self%point_contact, step, p, h0)
    call heat_sweep(self, change, stat)
    if (stat == status_ok) then
      call film_balance(self%point_contact, residual, load_error)
      if (bearable(merit, residual, load_error)) return
    end if
    call set_temperature(self, self%heat%before)
    call search_step(self%point_contact, merit, p, h0, residual, load_error, step, stat)
    call heat_sweep(self, change, heat_stat)
    if (heat_stat == status_ok) then
      call film_balance(self%point_contact, residual, load_error)
    else
      stat = heat_stat
      change = hottest
    end if
  end subroutine heated_step

  !> One sweep over the columns, with the entrainment, then the balance of the walls.
  !>
  !> `change` is the largest change of temperature [K] where pressure counts. If it leaves all sense, the contact is
  !> given back as cold as its bodies.
  subroutine heat_sweep(self, change, stat)
    type(heated_contact), intent(inout) :: self
    real(wp), intent(out) :: change
    integer, intent(out) :: stat
    real(wp) :: missed, reduction
    integer :: iterations

    call self%heat%work%start()
    self%heat%shear%unsolved = 0
    call heat_columns(self, self%heat, change)
    ! nor is heat of a stress that was not found to count as settled
    if (sum(self%heat%shear%unsolved) > 0) change = hottest
    call balance_walls(self%heat%walls, wall_tolerance, missed, iterations, reduction)
    associate (rise => self%shear%nodes%rise)
      change = max(change, &
        maxval(abs(self%heat%walls%wall(:, :, 1) - rise(:, :, 1)), mask=self%fields%p > judged(self)), &
        maxval(abs(self%heat%walls%wall(:, :, 2) - rise(:, :, size(rise, 3))), mask=self%fields%p > judged(self)))
    end associate
    call set_walls(self)
    call judge_temperature(self, stat)
    call self%heat%work%finish()
  end subroutine heat_sweep

  !> Whether the film is between absolute zero and what no oil bears; if not it is cooled down.
  subroutine judge_temperature(self, stat)
    type(heated_contact), intent(inout) :: self
    integer, intent(out) :: stat
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
      do i = 1, 2
        walls%wall(:, :, i) = walls%body(i)%bulk
      end do
    end associate
    call set_walls(self)
  end subroutine judge_temperature

  !> Takes up a temperature above the inlet's [K], at the levels.
  subroutine set_temperature(self, rise)
    type(heated_contact), intent(inout) :: self
    real(wp), intent(in) :: rise(:, :, :)

    self%shear%nodes%rise(:, :, :) = rise
    self%heat%walls%wall(:, :, 1) = rise(:, :, 1)
    self%heat%walls%wall(:, :, 2) = rise(:, :, size(rise, 3))
  end subroutine set_temperature

  !> Pressure [Pa] above which temperatures must settle.
  pure real(wp) function judged(self)
    type(heated_contact), intent(in) :: self

    judged = judged_pressure*maxval(self%fields%p)
  end function judged

  !> Gives the film the walls' temperature; what lies between follows as by conduction alone. On the outline it keeps
  !> the inlet's.
  subroutine set_walls(self)
    type(heated_contact), intent(inout) :: self
    real(wp) :: change_1, change_2
    integer :: i, j, k

    associate (rise => self%shear%nodes%rise, levels => self%shear%nodes%levels, wall => self%heat%walls%wall)
      !$omp parallel do private(i, k, change_1, change_2) schedule(static)
      do j = 1, self%grid%ny
        do i = 1, self%grid%nx
          change_1 = wall(i, j, 1) - rise(i, j, 1)
          change_2 = wall(i, j, 2) - rise(i, j, levels%count)
          rise(i, j, 1) = wall(i, j, 1)
          rise(i, j, levels%count) = wall(i, j, 2)
          if (i == 1 .or. i == self%grid%nx .or. j == 1 .or. j == self%grid%ny) cycle
          do k = 2, levels%count - 1
            rise(i, j, k) = rise(i, j, k) + (0.5_wp - levels%z(k))*change_1 + (0.5_wp + levels%z(k))*change_2
          end do
        end do
      end do
    end associate
  end subroutine set_walls

  !> One sweep over the columns, with walls as they are.
  subroutine heat_columns(contact, heat, change)
    type(heated_contact), intent(inout) :: contact
    type(film_heat), intent(inout) :: heat
    real(wp), intent(out) :: change
    type(line_cut) :: cut
    integer :: step, first, thread, downstream
    real(wp) :: least

    cut%transposed = contact%cycles%transposed
    cut%lines = merge(contact%grid%nx, contact%grid%ny, cut%transposed)
    cut%length = merge(contact%grid%ny, contact%grid%nx, cut%transposed)
    least = judged(contact)
    change = 0
    downstream = merge(1, -1, contact%cycles%rising)
    do step = 1, 3
      call read_line(contact, cut, merge(step, cut%lines + 1 - step, downstream > 0), heat%lines)
    end do
    do step = 2, cut%lines - 1
      cut%line = merge(step, cut%lines + 1 - step, downstream > 0)
      if (step < cut%lines - 1) call read_line(contact, cut, cut%line + 2*downstream, heat%lines)
      heat%renewed(:, :) = heat%lines(:, :, mod(cut%line, 5))
      !$omp parallel do private(thread) firstprivate(cut) reduction(max:change) schedule(static)
      do first = 2, cut%length - 1, most_columns
        cut%first = first
        cut%last = min(first + most_columns - 1, cut%length - 1)
        thread = omp_get_thread_num()
        call heat_cut(contact, cut, downstream, least, heat, heat%columns(thread), heat%shear(thread), change)
      end do
      heat%lines(:, :, mod(cut%line, 5)) = heat%renewed
    end do
  end subroutine heat_columns

  !> Temperature of a line as it stands.
  subroutine read_line(contact, cut, line, lines)
    type(heated_contact), intent(in) :: contact
    type(line_cut), intent(in) :: cut
    integer, intent(in) :: line
    real(wp), intent(inout) :: lines(:, :, 0:)

    if (cut%transposed) then
      lines(:, :, mod(line, 5)) = contact%shear%nodes%rise(line, :, :)
    else
      lines(:, :, mod(line, 5)) = contact%shear%nodes%rise(:, line, :)
    end if
  end subroutine read_line

  !> The columns of a cut.
  subroutine heat_cut(contact, cut, downstream, least, heat, columns, shear, change)
    type(heated_contact), intent(inout) :: contact
    type(line_cut), intent(in) :: cut
    integer, intent(in) :: downstream
    real(wp), intent(in) :: least
    type(film_heat), intent(inout) :: heat
    type(film_strip), intent(inout) :: columns
    type(shear_strip), intent(inout) :: shear
    real(wp), intent(inout) :: change
    real(wp), dimension(most_columns) :: p, u1, v1, mean, capacity, friction, carried
    real(wp), dimension(most_columns, contact%shear%nodes%levels%count) :: softening, u, v, rate, compression, inflow
    integer :: m, k, n, c

    m = cut%last - cut%first + 1
    n = contact%shear%nodes%levels%count
    columns%columns = m
    associate (nodes => contact%shear%nodes)
      call take(heat%stress_x, cut, shear%tau_x)
      call take(heat%stress_y, cut, shear%tau_y)
      call take(heat%u1, cut, u1)
      call take(heat%v1, cut, v1)
      call shear_cut(contact%point_contact, cut, shear, p, mean, columns%known, softening)
      call set_heat(heat%law, contact%oil, nodes, shear, p, mean, u1, v1, softening, columns, capacity, u, v, compression)
      call film_shear_rate(nodes%levels, shear, rate)
      friction(:m) = shear%film(:m)*matmul(columns%source(:m, :), nodes%levels%weight)
      call carry(contact, cut, m, downstream, heat%lines, capacity, u, v, columns%absorption, inflow)
      inflow(:m, :) = inflow(:m, :) + compression(:m, :)
      columns%source(:m, :) = columns%source(:m, :) + inflow(:m, :)
      call solve_columns(columns)
      do k = 1, n
        do c = 1, m
          if (p(c) > least) change = max(change, abs(columns%temperature(c, k) - columns%known(c, k)))
        end do
        heat%renewed(cut%first:cut%last, k) = columns%temperature(:m, k)
        call put(columns%temperature(:, k), cut, nodes%rise(:, :, k))
      end do
      do c = 1, m
        carried(c) = carried_away(columns, c, inflow(c, :))
      end do
    end associate
    call put(shear%tau_x, cut, heat%stress_x)
    call put(shear%tau_y, cut, heat%stress_y)
    call put(friction, cut, heat%friction)
    call put(carried, cut, heat%carried)
    call put(maxval(rate(:m, :), dim=2), cut, heat%rate)
    do k = 1, 2
      call put(columns%flux(:, k), cut, heat%walls%flux(:, :, k))
      do n = 1, 2
        call put(columns%admittance(:, n, k), cut, heat%walls%admittance(:, :, n, k))
      end do
    end do
  end subroutine heat_cut

  !> What convection takes from a level for each kelvin, `absorption` [W/(m3 K)], and brings it, `inflow` [W/m3].
  !>
  !> Oil comes from the foot of its path on the square of the eight nodes about its own; where that lies on the line
  !> before, a second foot two lines back makes the difference along the path one of second order. Elsewhere values
  !> lag behind, and only a first-order difference is sure not to let their errors grow from sweep to sweep.
  subroutine carry(contact, cut, m, downstream, lines, capacity, u, v, absorption, inflow)
    type(heated_contact), intent(in) :: contact
    type(line_cut), intent(in) :: cut
    integer, intent(in) :: m, downstream
    real(wp), intent(in) :: lines(:, :, 0:), capacity(:), u(:, :), v(:, :)
    real(wp), intent(out) :: absorption(:, :), inflow(:, :)
    real(wp) :: across, along, rate, skew, foot, second, share
    integer :: k, c, column, up, side, whole, far, here, next, second_next

    here = mod(cut%line, 5)
    do k = 1, size(u, 2)
      do c = 1, m
        column = cut%first + c - 1
        across = merge(u(c, k)/contact%grid%dx, v(c, k)/contact%grid%dy, cut%transposed)
        along = merge(v(c, k)/contact%grid%dy, u(c, k)/contact%grid%dx, cut%transposed)
        up = merge(-1, 1, across > 0)
        side = merge(-1, 1, along > 0)
        rate = max(abs(across), abs(along), tiny(rate))
        skew = min(abs(across), abs(along))/rate
        next = mod(cut%line + up, 5)
        if (abs(across) < abs(along)) then
          foot = (1 - skew)*lines(column + side, k, here) + skew*lines(column + side, k, next)
        else
          foot = (1 - skew)*lines(column, k, next) + skew*lines(column + side, k, next)
        end if
        absorption(c, k) = capacity(c)*rate
        inflow(c, k) = capacity(c)*rate*foot
        if (abs(across) < abs(along) .or. up == downstream) cycle
        whole = int(2*skew)
        far = column + side*(whole + 1)
        if (cut%line + 2*up < 1 .or. cut%line + 2*up > cut%lines .or. far < 1 .or. far > cut%length) cycle
        share = 2*skew - whole
        second_next = mod(cut%line + 2*up, 5)
        second = (1 - share)*lines(far - side, k, second_next) + share*lines(far, k, second_next)
        absorption(c, k) = 1.5_wp*capacity(c)*rate
        inflow(c, k) = capacity(c)*rate*(2*foot - 0.5_wp*second)
      end do
    end do
  end subroutine carry

end module film_temperature
