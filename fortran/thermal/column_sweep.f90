!> Columns of a point contact's film, solved line after line in the direction in which oil moves.
!>
!> Lines lie across the direction of a sweep. The temperature of a column takes its upwind values, by the velocity of each
!> level, from the lines before; values of later lines, and along a line, lag behind.
module pyworm_column_sweep
  use pyworm_column_sources, only: set_heat, carried_away
  use pyworm_column_work, only: column_work
  use pyworm_film_column, only: film_strip, solve_columns
  use pyworm_film_newton, only: film_contact
  use pyworm_gauss_lobatto, only: levels_across
  use pyworm_kinds, only: wp
  use pyworm_oil_convection, only: line_cut, carry_level, most_columns
  use omp_lib, only: omp_get_thread_num
  use pyworm_shear_fields, only: shear_columns
  use pyworm_shear_profile, only: film_shear_rate
  use pyworm_status, only: status_ok, status_no_memory
  use pyworm_sweep_order, only: sweep_frame, to_sweep, from_sweep
  use pyworm_thermal_properties, only: oil_heat_law
  implicit none(type, external)
  private

  public :: swept_columns, new_swept_columns, change_swept, enter_sweep, gather, set_sources, cut_of_line, sweep_lines, &
    swept_rise

  !> Heat capacity flow that holds the temperature of a level [W/(m3 K)], far above any other.
  real(wp), parameter :: fixed_capacity = 1e30_wp

  !> Fields of the columns in the order of a sweep, (length, lines).
  type :: swept_columns
    type(sweep_frame) :: way
    !> Velocity of body 1's surface and of body 2 relative to it [m/s].
    real(wp), allocatable :: u1(:, :), v1(:, :), us(:, :), vs(:, :)
    !> Of a transient film: rates of change of temperature at the levels [K/s] and of pressure [Pa/s].
    real(wp), allocatable :: warming(:, :, :), pressing(:, :)
    !> Pressure [Pa] and film [m]; of rough surfaces the share of the area that oil covers.
    real(wp), allocatable :: p(:, :), h(:, :), wetted(:, :)
    !> Stress at the middle of the film [Pa], the initial guess of the next sweep.
    real(wp), allocatable :: stress_x(:, :), stress_y(:, :)
    !> Temperature, (0:length + 1, lines, levels), with padding at the ends of a line; that of the present line and of the
    !> next before the sweep, line k at mod(k, 2).
    real(wp), allocatable :: rise(:, :, :), old(:, :, :)
    !> Whether sweeps go across the entrainment: they solve the levels only at which oil moves from line to line rather than
    !> along the lines, and hold the others.
    logical :: aside = .false.
    !> Whether some oil in the columns of a cut flows with the sweep, or against it, (cuts, lines).
    logical, allocatable :: onward(:, :), backward(:, :)
    !> Of sweeps with the entrainment only: heat of shearing, and heat convected by the oil less that of its compression
    !> [W/m2]; the largest shear rate across the film [1/s].
    real(wp), allocatable :: friction(:, :), carried(:, :), rate(:, :)
    !> And flux into the walls and its derivatives (`wall_balance`), (length, lines, wall) and (length, lines, wall, wall).
    real(wp), allocatable :: flux(:, :, :), admittance(:, :, :, :)
    !> Largest change of temperature [K] in the last sweep: in the cuts in which oil flows backward, and at the levels
    !> at which it moves along the lines rather than from line to line.
    real(wp) :: change_backward = 0, change_along = 0
  end type swept_columns

contains

  !> Columns of a film that is already sheared, to be swept a way; u1 and v1 are the nodal velocity of body 1's surface
  !> [m/s], `aside` as of `swept_columns`.
  subroutine new_swept_columns(self, film, way, aside, u1, v1, stat)
    type(swept_columns), allocatable, intent(out) :: self
    class(film_contact), intent(in) :: film
    type(sweep_frame), intent(in) :: way
    logical, intent(in) :: aside
    real(wp), intent(in) :: u1(:, :), v1(:, :)
    integer, intent(out) :: stat
    integer :: cuts, err

    allocate (self, stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
    if (stat /= status_ok) return
    self%way = way
    self%aside = aside
    associate (n => way%length, lines => way%lines, levels => film%model%shear%nodes%levels%count)
      cuts = (n - 3)/most_columns + 1
      allocate (self%u1(n, lines), self%v1(n, lines), self%us(n, lines), self%vs(n, lines), self%p(n, lines), &
        self%h(n, lines), self%stress_x(n, lines), self%stress_y(n, lines), self%rise(0:n + 1, lines, levels), &
        self%old(0:n + 1, 0:1, levels), source=0.0_wp, stat=err)
      if (err == 0 .and. .not. aside) allocate (self%friction(n, lines), self%carried(n, lines), self%rate(n, lines), &
        self%flux(n, lines, 2), self%admittance(n, lines, 2, 2), source=0.0_wp, stat=err)
      if (err == 0) allocate (self%onward(cuts, lines), self%backward(cuts, lines), source=aside, stat=err)
    end associate
    stat = merge(status_ok, status_no_memory, err == 0)
    if (stat /= status_ok) return
    if (film%model%is_rough()) allocate (self%wetted(way%length, way%lines), stat=err)
    if (err /= 0) stat = status_no_memory
    call to_sweep(way, u1, self%u1)
    call to_sweep(way, v1, self%v1)
    call to_sweep(way, film%model%shear%nodes%sliding_x, self%us)
    call to_sweep(way, film%model%shear%nodes%sliding_y, self%vs)
  end subroutine new_swept_columns

  !> Sets rates of change of temperature and pressure; the arguments are those of `change_with_time` of `thermal_step`.
  subroutine change_swept(self, warming, pressing, stat)
    type(swept_columns), intent(inout) :: self
    real(wp), intent(in) :: warming(:, :, :), pressing(:, :)
    integer, intent(out) :: stat
    integer :: k, err

    if (allocated(self%warming)) deallocate (self%warming, self%pressing)
    associate (n => self%way%length, lines => self%way%lines)
      allocate (self%warming(n, lines, size(warming, 3)), self%pressing(n, lines), stat=err)
    end associate
    stat = merge(status_ok, status_no_memory, err == 0)
    if (stat /= status_ok) return
    call to_sweep(self%way, pressing, self%pressing)
    do k = 1, size(warming, 3)
      call to_sweep(self%way, warming(:, :, k), self%warming(:, :, k))
    end do
  end subroutine change_swept

  !> Copies pressure, film and temperature of the nodes into the order of the sweep.
  subroutine enter_sweep(self, film)
    type(swept_columns), intent(inout) :: self
    class(film_contact), intent(in) :: film
    integer :: k

    call to_sweep(self%way, film%model%fields%p, self%p)
    call to_sweep(self%way, film%model%fields%h, self%h)
    if (film%model%is_rough()) call to_sweep(self%way, 1 - film%model%fields%rough%area, self%wetted)
    do k = 1, film%model%shear%nodes%levels%count
      call to_sweep(self%way, film%model%shear%nodes%rise(:, :, k), self%rise(1:self%way%length, :, k))
    end do
  end subroutine enter_sweep

  !> Copies the temperature after a sweep to the nodes of the grid.
  subroutine swept_rise(self, film)
    type(swept_columns), intent(in) :: self
    class(film_contact), intent(inout) :: film
    integer :: k

    do k = 1, film%model%shear%nodes%levels%count
      call from_sweep(self%way, self%rise(1:self%way%length, :, k), film%model%shear%nodes%rise(:, :, k))
    end do
  end subroutine swept_rise

  !> Sweeps all lines one after another, onward or backward, in the cuts in which oil flows so; with the entrainment in all.
  !>
  !> `change` is the largest of temperature [K] at more than a pressure of `least` [Pa].
  subroutine sweep_lines(self, film, law, threads, backward, least, change)
    type(swept_columns), intent(inout) :: self
    class(film_contact), intent(in) :: film
    type(oil_heat_law), intent(in) :: law
    type(column_work), allocatable, intent(inout) :: threads(:)
    logical, intent(in) :: backward
    real(wp), intent(in) :: least
    real(wp), intent(out) :: change
    logical :: wanted
    real(wp) :: change_backward, change_along
    integer :: line, cut, thread, from, to, onward

    onward = merge(-1, 1, backward)
    from = merge(self%way%lines - 1, 2, backward)
    to = merge(2, self%way%lines - 1, backward)
    self%old(:, mod(from, 2), :) = self%rise(:, from, :)
    change = 0
    change_backward = 0
    change_along = 0
    !$omp parallel private(line, thread, wanted) reduction(max:change, change_backward, change_along)
    thread = omp_get_thread_num()
    do line = from, to, onward
      !$omp do schedule(static)
      do cut = 1, size(self%onward, 1)
        wanted = merge(self%backward(cut, line), self%onward(cut, line) .or. .not. self%aside, backward)
        if (wanted) call heat_cut(self, film, law, line, cut, least, threads(thread), change, change_backward, change_along)
        call keep_line(self, line + onward, cut)
      end do
    end do
    !$omp end parallel
    self%change_backward = change_backward
    self%change_along = change_along
  end subroutine sweep_lines

  !> Stores the temperature of a cut of a line before it is solved, with the ends of the line and their padding.
  subroutine keep_line(self, line, cut)
    type(swept_columns), intent(inout) :: self
    integer, intent(in) :: line, cut
    integer :: first, last

    first = merge(0, 2 + (cut - 1)*most_columns, cut == 1)
    last = merge(self%way%length + 1, 1 + cut*most_columns, cut == size(self%onward, 1))
    self%old(first:last, mod(line, 2), :) = self%rise(first:last, line, :)
  end subroutine keep_line

  !> Solves the columns of a cut of a line.
  subroutine heat_cut(self, film, law, line, cut, least, work, change, change_backward, change_along)
    type(swept_columns), intent(inout) :: self
    class(film_contact), intent(in) :: film
    type(oil_heat_law), intent(in) :: law
    integer, intent(in) :: line, cut
    real(wp), intent(in) :: least
    type(column_work), intent(inout) :: work
    real(wp), intent(inout) :: change, change_backward, change_along
    integer :: first, last, m, k

    first = 2 + (cut - 1)*most_columns
    last = min(1 + cut*most_columns, self%way%length - 1)
    m = last - first + 1
    associate (nodes => film%model%shear%nodes, shear => work%shear, columns => work%columns, oil => work%oil)
      call gather(self, film, line, first, last, work)
      call set_sources(self, film, law, line, cut, self%old(first - 1:last + 1, mod(line, 2), :), work)
      self%stress_x(first:last, line) = shear%tau_x(:m)
      self%stress_y(first:last, line) = shear%tau_y(:m)
      call solve_columns(columns)
      if (self%way%along_x) then
        call take_changes(self, columns, oil%v, oil%u, self%backward(cut, line), oil%p(:m) > least, change, change_backward, &
          change_along)
      else
        call take_changes(self, columns, oil%u, oil%v, self%backward(cut, line), oil%p(:m) > least, change, change_backward, &
          change_along)
      end if
      do k = 1, nodes%levels%count
        self%rise(first:last, line, k) = columns%temperature(:m, k)
      end do
      if (.not. self%aside) call keep_heat(self, line, first, nodes%levels, work)
    end associate
  end subroutine heat_cut

  !> Computes shear, absorption and sources of the gathered columns of a cut of a line; `here` is the temperature of the line
  !> at the nodes from the one before the cut to the one after it.
  subroutine set_sources(self, film, law, line, cut, here, work)
    type(swept_columns), intent(inout) :: self
    class(film_contact), intent(in) :: film
    type(oil_heat_law), intent(in) :: law
    integer, intent(in) :: line, cut
    real(wp), intent(in) :: here(0:, :)
    type(column_work), intent(inout) :: work

    associate (nodes => film%model%shear%nodes, shear => work%shear, columns => work%columns, oil => work%oil)
      call shear_columns(film%oil, nodes, oil%p, columns%known, shear, oil%mean, oil%softening)
      call set_heat(law, film%oil, nodes, shear, oil, columns)
      if (self%way%along_x) then
        call carry(self, line, cut, here, oil%capacity, oil%v, oil%u, columns%absorption, work%inflow)
      else
        call carry(self, line, cut, here, oil%capacity, oil%u, oil%v, columns%absorption, work%inflow)
      end if
      call add_sources(self, line, 2 + (cut - 1)*most_columns, nodes%levels, work)
    end associate
  end subroutine set_sources

  !> Sets film, gradient, sliding and last stress, temperature and pressure of the columns at nodes first..last of a line.
  pure subroutine gather(self, film, line, first, last, work)
    type(swept_columns), intent(in) :: self
    class(film_contact), intent(in) :: film
    integer, intent(in) :: line, first, last
    type(column_work), intent(inout) :: work
    integer :: m, k

    m = last - first + 1
    associate (shear => work%shear, oil => work%oil)
      shear%points = m
      shear%film(:m) = max(self%h(first:last, line), film%floor)
      shear%us(:m) = self%us(first:last, line)
      shear%vs(:m) = self%vs(first:last, line)
      if (allocated(self%wetted)) shear%wetted(:m) = self%wetted(first:last, line)
      shear%tau_x(:m) = self%stress_x(first:last, line)
      shear%tau_y(:m) = self%stress_y(first:last, line)
      if (self%way%along_x) then
        call take_gradient(self, line, first, last, shear%py, shear%px)
      else
        call take_gradient(self, line, first, last, shear%px, shear%py)
      end if
      do k = 1, size(self%rise, 3)
        work%columns%known(:m, k) = self%rise(first:last, line, k)
      end do
      oil%p(:m) = self%p(first:last, line)
      oil%u1(:m) = self%u1(first:last, line)
      oil%v1(:m) = self%v1(first:last, line)
      oil%pressing(:m) = 0
      if (allocated(self%pressing)) oil%pressing(:m) = self%pressing(first:last, line)
    end associate
  end subroutine gather

  !> Adds to the heat of shearing what the oil brings, by convection and compression, less what it stores.
  pure subroutine add_sources(self, line, first, levels, work)
    type(swept_columns), intent(in) :: self
    integer, intent(in) :: line, first
    type(levels_across), intent(in) :: levels
    type(column_work), intent(inout) :: work
    integer :: m, k, last

    m = work%shear%points
    last = first + m - 1
    associate (friction => work%friction, columns => work%columns, capacity => work%oil%capacity)
      friction = 0
      do k = 1, levels%count
        friction(:m) = friction(:m) + work%shear%film(:m)*levels%weight(k)*columns%source(:m, k)
        if (allocated(self%warming)) then
          work%inflow(:m, k) = work%inflow(:m, k) - capacity(:m)*self%warming(first:last, line, k)
        end if
        work%inflow(:m, k) = work%inflow(:m, k) + work%oil%compression(:m, k)
        columns%source(:m, k) = columns%source(:m, k) + work%inflow(:m, k)
      end do
    end associate
  end subroutine add_sources

  !> Keeps heat, largest rate of shear and flux into the walls of the solved columns from node `first` of a line on.
  subroutine keep_heat(self, line, first, levels, work)
    type(swept_columns), intent(inout) :: self
    integer, intent(in) :: line, first
    type(levels_across), intent(in) :: levels
    type(column_work), intent(inout) :: work
    integer :: m, k, i, last

    m = work%shear%points
    last = first + m - 1
    self%friction(first:last, line) = work%friction(:m)
    call carried_away(work%columns, work%inflow, self%carried(first:last, line))
    call film_shear_rate(levels, work%shear, work%rate)
    self%rate(first:last, line) = maxval(work%rate(:m, :), dim=2)
    do k = 1, 2
      self%flux(first:last, line, k) = work%columns%flux(:m, k)
      do i = 1, 2
        self%admittance(first:last, line, i, k) = work%columns%admittance(:m, i, k)
      end do
    end do
  end subroutine keep_heat

  !> Largest changes of the columns' temperature [K]: where they are `judged`, of columns in which oil flows backward, and
  !> of levels at which it moves along the line rather than across it. Oil moves with (along, across) the line [m/s].
  pure subroutine take_changes(self, columns, along, across, backward, judged, change, change_backward, change_along)
    type(swept_columns), intent(in) :: self
    type(film_strip), intent(in) :: columns
    real(wp), contiguous, intent(in) :: along(:, :), across(:, :)
    logical, intent(in) :: backward, judged(:)
    real(wp), intent(inout) :: change, change_backward, change_along
    real(wp), dimension(most_columns) :: warmed, warmed_along
    real(wp) :: by, turned
    integer :: c, k

    warmed = 0
    warmed_along = 0
    do k = 1, columns%levels%count
      do c = 1, columns%columns
        by = abs(columns%temperature(c, k) - columns%known(c, k))
        turned = merge(1.0_wp, 0.0_wp, abs(along(c, k))*self%way%per_node > abs(across(c, k)*self%way%per_line))
        warmed(c) = max(warmed(c), by)
        warmed_along(c) = max(warmed_along(c), turned*by)
      end do
    end do
    change = max(change, maxval(warmed(:columns%columns), mask=judged))
    change_along = max(change_along, maxval(warmed_along(:columns%columns), mask=judged))
    if (backward) change_backward = max(change_backward, maxval(warmed(:columns%columns)))
  end subroutine take_changes

  !> Pressure gradient at nodes of a line, along it and from line to line [Pa/m]; that of ruptured oil is none (Reynolds'
  !> condition). Differences across a node between pressures that have not settled would heat it without bound.
  pure subroutine take_gradient(self, line, first, last, along, across)
    type(swept_columns), intent(in) :: self
    integer, intent(in) :: line, first, last
    real(wp), intent(inout) :: along(:), across(:)
    integer :: m

    m = last - first + 1
    along(:m) = (self%p(first + 1:last + 1, line) - self%p(first - 1:last - 1, line))*(self%way%per_node/2)
    across(:m) = (self%p(first:last, line + 1) - self%p(first:last, line - 1))*(self%way%per_line/2)
    where (.not. self%p(first:last, line) > 0)
      along(:m) = 0
      across(:m) = 0
    end where
  end subroutine take_gradient

  !> Heat convected away from the levels of a line's columns for each kelvin, `absorption` [W/(m3 K)], and to them,
  !> `inflow` [W/m3], by oil that moves with (along, across) the line [m/s]; `here` as of `set_sources`.
  subroutine carry(self, line, cut, here, capacity, along, across, absorption, inflow)
    type(swept_columns), intent(inout) :: self
    integer, intent(in) :: line, cut
    real(wp), intent(in) :: here(0:, :)
    real(wp), contiguous, intent(in) :: capacity(:), along(:, :), across(:, :)
    real(wp), contiguous, intent(inout) :: absorption(:, :), inflow(:, :)
    real(wp) :: across_rate(most_columns), along_rate(most_columns)
    type(line_cut) :: part
    integer :: k, before, m, first, last

    first = 2 + (cut - 1)*most_columns
    last = min(1 + cut*most_columns, self%way%length - 1)
    m = last - first + 1
    ! the first line in work has but one before it
    before = max(line - 2, 1)
    self%onward(cut, line) = .false.
    self%backward(cut, line) = .false.
    part = cut_of_line(self, line, cut)
    do k = 1, size(along, 2)
      call carry_level(part, self%rise(first - 2:last + 2, before, k), self%rise(first - 1:last + 1, line - 1, k), &
        here(:m + 1, k), self%rise(first - 1:last + 1, line + 1, k), capacity, along(:, k), &
        across(:, k), absorption(:, k), inflow(:, k))
      along_rate(:m) = merge(1, 0, self%aside)*abs(along(:m, k))*self%way%per_node
      across_rate(:m) = across(:m, k)*self%way%per_line
      self%onward(cut, line) = self%onward(cut, line) .or. any(across_rate(:m) > along_rate(:m))
      self%backward(cut, line) = self%backward(cut, line) .or. any(-across_rate(:m) > along_rate(:m))
      if (self%aside) then
        where (.not. abs(across_rate(:m)) > along_rate(:m))
          absorption(:m, k) = fixed_capacity
          inflow(:m, k) = fixed_capacity*self%rise(first:last, line, k)
        end where
      end if
    end do
  end subroutine carry

  !> A cut of a line as `carry_level` takes it.
  pure type(line_cut) function cut_of_line(self, line, cut)
    type(swept_columns), intent(in) :: self
    integer, intent(in) :: line, cut
    integer :: first, last

    first = 2 + (cut - 1)*most_columns
    last = min(1 + cut*most_columns, self%way%length - 1)
    cut_of_line = line_cut(last - first + 1, first == 2, last == self%way%length - 1, line > 2 .and. .not. self%aside, &
      self%way%per_node, self%way%per_line)
  end function cut_of_line

end module pyworm_column_sweep
