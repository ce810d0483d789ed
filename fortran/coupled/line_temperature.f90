!> Temperature of the film of a line contact and of the surfaces beside it, at a given pressure and film.
!>
!> The equations and columns are those of `film_temperature` (Sharif et al. 2001, eqs 18, 19 and 21). A sweep marches
!> once against the entrainment, over the columns in which some oil flows back, and once with it, over all: each
!> column sees what has just reached its neighbours, whichever way its levels flow. Derivatives along the film are
!> upwind differences of second order. The walls are balanced over the whole contact at the end.
module line_temperature
  use column_heat, only: hottest, set_heat, carried_away
  use film_column, only: film_strip, new_film_strip, solve_column
  use heated_surface, only: heated_body
  use kinds, only: wp
  use line_film, only: line_contact, line_step, line_residual
  use line_nodal_shear, only: shear_line_nodes
  use oil_heat, only: oil_heat_law
  use omp_lib, only: omp_get_max_threads, omp_get_thread_num
  use shear_flow, only: shear_strip, new_shear_strip
  use status, only: status_ok, status_not_finite, status_no_descent, status_no_memory
  use wall_balance, only: wall_pair, new_wall_pair, balance_walls
  implicit none(type, external)
  private

  public :: heated_line, heat_line, heated_line_step, line_heat_sweep, set_line_temperature

  !> Columns treated together.
  integer, parameter :: most_columns = 64
  !> Share of the largest pressure above which temperatures must settle; elsewhere they move little oil.
  real(wp), parameter :: judged_pressure = 0.005_wp
  !> Share of the walls' imbalance that a sweep leaves, and the Krylov iterations that it may take.
  real(wp), parameter :: wall_tolerance = 0.01_wp
  integer, parameter :: most_wall_iterations = 20
  !> Share of the faster body's velocity below which oil is slow.
  real(wp), parameter :: slow_share = 0.2_wp

  !> Temperatures are those above the inlet's.
  type :: line_heat
    type(oil_heat_law) :: law
    !> Velocity of body 1's surface at the nodes [m/s].
    real(wp), allocatable :: u1(:)
    type(wall_pair) :: walls
    !> Stress at the middle of the film [Pa], from which the next sweep starts.
    real(wp), allocatable :: stress(:)
    !> What oil carries away, less what compression gives it [W/m2].
    real(wp), allocatable :: carried(:)
    !> Of the levels at the nodes: what a kelvin takes along x [W/(m3 K)], heat of shearing and of compression [W/m3].
    real(wp), allocatable :: flow(:, :), dissipation(:, :), compression(:, :)
    !> Columns of the inner nodes, strip by strip, and each thread's shear.
    type(film_strip), allocatable :: columns(:)
    type(shear_strip), allocatable :: shear(:)
  end type line_heat

  !> A line contact and its temperature, which is there where heat is simulated.
  type, extends(line_contact) :: heated_line
    type(line_heat), allocatable :: heat
  end type heated_line

contains

  !> Gives a contact whose film is already sheared its heat.
  !>
  !> u1 is the nodal velocity of body 1's surface [m/s]; the bodies move into the contact, `bulk` being their temperature
  !> far below the surface, above the inlet's [K].
  subroutine heat_line(self, law, u1, body_1, body_2, bulk, stat)
    type(heated_line), intent(inout) :: self
    type(oil_heat_law), intent(in) :: law
    real(wp), intent(in) :: u1(:), bulk(2)
    class(heated_body), allocatable, intent(inout) :: body_1, body_2
    integer, intent(out) :: stat
    integer :: n, levels, i, err

    n = self%grid%n
    levels = self%shear%nodes%levels%count
    allocate (self%heat)
    associate (heat => self%heat)
      heat%law = law
      heat%u1 = u1
      call new_wall_pair(heat%walls, body_1, bulk(1), body_2, bulk(2), most_wall_iterations, stat)
      if (stat /= status_ok) return
      allocate (heat%stress(n), heat%carried(n), heat%flow(n, levels), heat%dissipation(n, levels), &
        heat%compression(n, levels), source=0.0_wp, stat=err)
      if (err == 0) allocate (heat%columns((n - 2 + most_columns - 1)/most_columns), &
        heat%shear(0:omp_get_max_threads() - 1), stat=err)
      stat = merge(status_ok, status_no_memory, err == 0)
      do i = 1, size(heat%columns)
        if (stat == status_ok) call new_film_strip(heat%columns(i), most_columns, self%shear%nodes%levels, stat)
      end do
      do i = 0, ubound(heat%shear, 1)
        if (stat == status_ok) call new_shear_strip(most_columns, levels, heat%shear(i), stat)
      end do
    end associate
    if (stat == status_ok) call set_walls(self)
  end subroutine heat_line

  !> One Newton step of the film from (p, h0), about which it was last evaluated, one sweep of heat at the new film, and
  !> the film's balance there. For the arguments see `line_step`, for `change` `line_heat_sweep`. Heat is swept even if no
  !> step of the film helps.
  subroutine heated_line_step(self, forcing, p, h0, residual, load_error, krylov, step, change, stat)
    type(heated_line), intent(inout) :: self
    real(wp), intent(in) :: forcing
    real(wp), contiguous, intent(inout) :: p(:)
    real(wp), intent(inout) :: h0, residual, load_error
    integer, intent(out) :: krylov, stat
    real(wp), intent(out) :: step, change
    integer :: heat_stat

    change = hottest
    call line_step(self%line_contact, forcing, p, h0, residual, load_error, krylov, step, stat)
    if (stat /= status_ok .and. stat /= status_no_descent) return
    call line_heat_sweep(self, change, heat_stat)
    if (heat_stat == status_ok) then
      call line_residual(self%line_contact, p, h0, residual, load_error)
    else
      stat = heat_stat
      change = hottest
    end if
  end subroutine heated_line_step

  !> One sweep over the columns, then the balance of the walls.
  !>
  !> `change` is the largest change of temperature [K] where pressure counts; a temperature that no oil bears is told.
  subroutine line_heat_sweep(self, change, stat)
    type(heated_line), intent(inout) :: self
    real(wp), intent(out) :: change
    integer, intent(out) :: stat
    real(wp) :: missed, reduction
    integer :: strip, first, iterations

    associate (heat => self%heat, n => self%grid%n, judged => judged_pressure*maxval(self%fields%p))
      heat%shear%unsolved = 0
      !$omp parallel do private(first) schedule(dynamic)
      do strip = 1, size(heat%columns)
        first = 2 + (strip - 1)*most_columns
        call set_strip(self, first, min(first + most_columns, n) - 1, heat, heat%columns(strip), &
          heat%shear(omp_get_thread_num()))
      end do
      if (sum(self%grid%u) > 0) then
        call march(self, heat, n - 1, 2, -1)
        call march(self, heat, 2, n - 1, 1)
      else
        call march(self, heat, 2, n - 1, 1)
        call march(self, heat, n - 1, 2, -1)
      end if
      ! heat of a stress that was not found is not to count as settled
      change = merge(hottest, 0.0_wp, sum(heat%shear%unsolved) > 0)
      do strip = 1, size(heat%columns)
        call take_up(self, heat, strip, judged, change)
      end do
      call balance_walls(heat%walls, wall_tolerance, missed, iterations, reduction)
      associate (rise => self%shear%nodes%rise)
        change = max(change, &
          maxval(abs(heat%walls%wall(:, 1, 1) - rise(:, 1, 1)), mask=self%fields%p(:, 1) > judged), &
          maxval(abs(heat%walls%wall(:, 1, 2) - rise(:, 1, size(rise, 3))), mask=self%fields%p(:, 1) > judged))
      end associate
    end associate
    call set_walls(self)
    stat = status_ok
    associate (rise => self%shear%nodes%rise)
      if (.not. all(rise > -self%oil%temperature .and. rise < hottest)) stat = status_not_finite
    end associate
  end subroutine line_heat_sweep

  !> Takes up a temperature above the inlet's [K], at the levels.
  subroutine set_line_temperature(self, rise)
    type(heated_line), intent(inout) :: self
    real(wp), intent(in) :: rise(:, :)

    self%shear%nodes%rise(:, 1, :) = rise
    self%heat%walls%wall(:, 1, 1) = rise(:, 1)
    self%heat%walls%wall(:, 1, 2) = rise(:, size(rise, 2))
  end subroutine set_line_temperature

  !> Gives the film the walls' temperature; what lies between follows as by conduction alone. At both ends it keeps the
  !> inlet's.
  subroutine set_walls(self)
    type(heated_line), intent(inout) :: self
    real(wp) :: change(2)
    integer :: i, last

    associate (rise => self%shear%nodes%rise, z => self%shear%nodes%levels%z, wall => self%heat%walls%wall)
      last = size(z)
      do i = 1, self%grid%n
        change = wall(i, 1, :) - rise(i, 1, [1, last])
        rise(i, 1, [1, last]) = wall(i, 1, :)
        if (i == 1 .or. i == self%grid%n) cycle
        rise(i, 1, 2:last - 1) = rise(i, 1, 2:last - 1) + (0.5_wp - z(2:last - 1))*change(1) &
          + (0.5_wp + z(2:last - 1))*change(2)
      end do
    end associate
  end subroutine set_walls

  !> Shear and heat of the columns at nodes first..last; what oil brings along is left out.
  subroutine set_strip(self, first, last, heat, columns, shear)
    type(heated_line), intent(in) :: self
    integer, intent(in) :: first, last
    type(line_heat), intent(inout) :: heat
    type(film_strip), intent(inout) :: columns
    type(shear_strip), intent(inout) :: shear
    real(wp), dimension(most_columns) :: p, mean, u1, v1, capacity
    real(wp), dimension(most_columns, self%shear%nodes%levels%count) :: softening, u, v, compression
    integer :: m, k

    m = last - first + 1
    shear%tau_x(:m) = heat%stress(first:last)
    shear%tau_y(:m) = 0
    call shear_line_nodes(self, first, last, shear, mean, columns%known, softening)
    heat%stress(first:last) = shear%tau_x(:m)
    p(:m) = self%fields%p(first:last, 1)
    u1(:m) = heat%u1(first:last)
    v1(:m) = 0
    call set_heat(heat%law, self%oil, self%shear%nodes, shear, p, mean, u1, v1, softening, columns, capacity, u, v, &
      compression)
    do k = 1, size(u, 2)
      heat%flow(first:last, k) = capacity(:m)*u(:m, k)/self%grid%dx
      heat%dissipation(first:last, k) = columns%source(:m, k)
      heat%compression(first:last, k) = compression(:m, k)
    end do
  end subroutine set_strip

  !> Solves the columns at the inner nodes from..to one after another; against the entrainment only those where some oil
  !> flows along.
  subroutine march(self, heat, from, to, along)
    type(heated_line), intent(inout) :: self
    type(line_heat), intent(inout) :: heat
    integer, intent(in) :: from, to, along
    integer :: i, strip, column, levels

    levels = size(heat%flow, 2)
    associate (rise => self%shear%nodes%rise)
      do i = from, to, along
        if (along*sum(self%grid%u) < 0 .and. all(along*heat%flow(i, :) <= 0)) cycle
        strip = (i - 2)/most_columns + 1
        column = i - 1 - (strip - 1)*most_columns
        associate (columns => heat%columns(strip))
          call bring(rise(:, 1, :), heat%flow(i, :), i, columns%absorption(column, :), columns%source(column, :))
          columns%source(column, :) = columns%source(column, :) + heat%compression(i, :) + heat%dissipation(i, :)
          call solve_column(columns, column)
          rise(i, 1, 2:levels - 1) = columns%temperature(column, 2:levels - 1)
        end associate
      end do
    end associate
  end subroutine march

  !> What convection takes from the levels at node i for each kelvin, `absorption` [W/(m3 K)], and brings them, `inflow`
  !> [W/m3], by differences to the one or two nodes from where oil comes.
  !>
  !> Where oil flows both ways, levels of little velocity have it from both sides: else one that turns from sweep to
  !> sweep would have it now from the inlet, now from the contact.
  pure subroutine bring(rise, flow, i, absorption, inflow)
    real(wp), intent(in) :: rise(:, :), flow(:)
    integer, intent(in) :: i
    real(wp), intent(out) :: absorption(:), inflow(:)
    real(wp) :: slow, from_before
    integer :: k

    slow = 0
    if (minval(flow) < 0 .and. maxval(flow) > 0) slow = slow_share*maxval(abs(flow([1, size(flow)])))
    do k = 1, size(flow)
      if (abs(flow(k)) < slow) then
        from_before = (1 + flow(k)/slow)/2
      else
        from_before = merge(1, 0, flow(k) > 0)
      end if
      absorption(k) = 0
      inflow(k) = 0
      call bring_from(-1, rise(:, k), i, from_before*abs(flow(k)), from_before >= 1, absorption(k), inflow(k))
      call bring_from(1, rise(:, k), i, (1 - from_before)*abs(flow(k)), from_before <= 0, absorption(k), inflow(k))
    end do
  end subroutine bring

  !> Adds what a `rate` [W/(m3 K)] of oil takes and brings from one side of node i, by a difference of `second` order or of
  !> first, with which errors of values that lag behind do not grow from sweep to sweep.
  pure subroutine bring_from(side, rise, i, rate, second, absorption, inflow)
    integer, intent(in) :: side, i
    real(wp), intent(in) :: rise(:), rate
    logical, intent(in) :: second
    real(wp), intent(inout) :: absorption, inflow

    if (second .and. i + 2*side >= 1 .and. i + 2*side <= size(rise)) then
      absorption = absorption + 1.5_wp*rate
      inflow = inflow + rate*(2*rise(i + side) - 0.5_wp*rise(i + 2*side))
    else
      absorption = absorption + rate
      inflow = inflow + rate*rise(i + side)
    end if
  end subroutine bring_from

  !> Fluxes and admittances of a strip's columns for the walls, what oil carries away, and the largest change of
  !> temperature [K] at nodes of more than a `judged` pressure [Pa].
  subroutine take_up(self, heat, strip, judged, change)
    type(heated_line), intent(in) :: self
    type(line_heat), intent(inout) :: heat
    integer, intent(in) :: strip
    real(wp), intent(in) :: judged
    real(wp), intent(inout) :: change
    real(wp), dimension(most_columns, self%shear%nodes%levels%count) :: inflow
    real(wp) :: carried(most_columns)
    integer :: i, c, k, m

    associate (columns => heat%columns(strip), before => 1 + (strip - 1)*most_columns)
      m = columns%columns
      do k = 1, size(inflow, 2)
        inflow(:m, k) = columns%source(:m, k) - heat%dissipation(before + 1:before + m, k)
      end do
      call carried_away(columns, inflow, carried)
      heat%carried(before + 1:before + m) = carried(:m)
      do c = 1, m
        i = before + c
        heat%walls%flux(i, 1, :) = columns%flux(c, :)
        heat%walls%admittance(i, 1, :, :) = columns%admittance(c, :, :)
        if (self%fields%p(i, 1) > judged) change = max(change, maxval(abs(columns%temperature(c, :) - columns%known(c, :))))
      end do
    end associate
  end subroutine take_up

end module line_temperature
