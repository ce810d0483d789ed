!> Temperature of the film of a line contact, swept both ways (`thermal_step`).
!>
!> A sweep runs once against the entrainment, over the columns with backflow, and once with it, over all columns: each
!> column uses the latest values of its neighbours, whatever the direction of flow of its levels. Derivatives along the film
!> are upwind differences of second order.
module pyworm_line_heat
  use pyworm_column_sources, only: column_oil, new_column_oil, set_heat, carried_away
  use pyworm_film_column, only: film_strip, new_film_strip, solve_column
  use pyworm_film_newton, only: film_contact
  use pyworm_heat_columns, only: heat_columns
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  use pyworm_line_columns, only: line_columns, new_line_columns, gather_line
  use pyworm_line_convection, only: bring
  use pyworm_line_film, only: line_contact
  use omp_lib, only: omp_get_max_threads, omp_get_thread_num
  use pyworm_shear_fields, only: shear_columns
  use pyworm_strip_of_points, only: shear_strip, new_shear_strip
  use pyworm_status, only: status_ok, status_bad_argument, status_no_memory
  use pyworm_thermal_properties, only: oil_heat_law
  use pyworm_thermal_step, only: film_heat, thermal_contact, new_film_heat, enclose_film
  implicit none(type, external)
  private

  public :: line_film_heat, new_line_heat, heat_line_contact

  !> Columns treated together.
  integer, parameter :: most_columns = 64
  !> Fraction of the largest pressure above which temperatures must converge; reduction of the walls' imbalance by a
  !> sweep, and its largest number of Krylov iterations.
  real(wp), parameter :: judged_pressure = 0.005_wp, wall_tolerance = 0.01_wp
  integer, parameter :: most_wall_iterations = 20

  type, extends(film_heat) :: line_film_heat
    !> Direction of the entrainment, 1 or -1.
    integer :: onward = 1
    !> Velocity of body 1's surface at the nodes [m/s].
    real(wp), allocatable :: u1(:)
    !> Of a transient film: rates of change of temperature at the levels [K/s] and of pressure [Pa/s].
    real(wp), allocatable :: warming(:, :), pressing(:)
    !> Stress at the middle of the film [Pa], the initial guess of the next sweep.
    real(wp), allocatable :: stress(:)
    !> Heat convected or stored by the oil, less that of its compression [W/m2].
    real(wp), allocatable :: carried(:)
    !> At the levels of the nodes: convection along x per kelvin [W/(m3 K)], heat of shearing, and of compression less that
    !> stored [W/m3].
    real(wp), allocatable :: flow(:, :), dissipation(:, :), compression(:, :)
    !> Columns of the inner nodes, strip by strip, and each thread's shear and oil.
    type(film_strip), allocatable :: columns(:)
    type(shear_strip), allocatable :: shear(:)
    type(column_oil), allocatable :: oil(:)
  contains
    procedure :: sweep_columns
    procedure :: change_with_time
    procedure :: cool
    procedure :: unsolved
    procedure :: carried_heat
    procedure :: copy_columns
  end type line_film_heat

contains

  !> Makes the heat of a line contact whose film is already sheared.
  !>
  !> u1 is the nodal velocity of body 1's surface [m/s]; the bodies move into it, `bulk` being their temperature
  !> far below the surface, above the inlet's [K].
  subroutine new_line_heat(self, film, law, u1, body_1, body_2, bulk, stat)
    type(line_film_heat), intent(inout) :: self
    type(line_contact), intent(inout) :: film
    type(oil_heat_law), intent(in) :: law
    real(wp), intent(in) :: u1(:), bulk(2)
    class(heated_body), allocatable, intent(inout) :: body_1, body_2
    integer, intent(out) :: stat
    integer :: n, levels, i, err

    n = film%grid%n
    levels = film%model%shear%nodes%levels%count
    self%judged_pressure = judged_pressure
    self%wall_tolerance = wall_tolerance
    self%onward = merge(1, -1, sum(film%grid%u) > 0)
    self%u1 = u1
    call new_film_heat(self, film, law, body_1, body_2, bulk, most_wall_iterations, stat)
    if (stat /= status_ok) return
    allocate (self%stress(n), self%carried(n), self%flow(n, levels), self%dissipation(n, levels), &
      self%compression(n, levels), source=0.0_wp, stat=err)
    if (err == 0) allocate (self%columns((n - 2 + most_columns - 1)/most_columns), &
      self%shear(0:omp_get_max_threads() - 1), self%oil(0:omp_get_max_threads() - 1), stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
    if (stat /= status_ok) return
    do i = 1, size(self%columns)
      if (stat == status_ok) call new_film_strip(self%columns(i), most_columns, film%model%shear%nodes%levels, stat)
    end do
    do i = 0, ubound(self%shear, 1)
      if (stat == status_ok) call new_shear_strip(most_columns, levels, self%shear(i), stat)
      if (stat == status_ok) call new_column_oil(most_columns, levels, self%oil(i), stat)
    end do
    if (stat == status_ok) call enclose_film(film, self)
  end subroutine new_line_heat

  !> Adds heat to a line contact whose film is already sheared; arguments as of `new_line_heat`.
  subroutine heat_line_contact(contact, law, u1, body_1, body_2, bulk, stat)
    type(thermal_contact), intent(inout) :: contact
    type(oil_heat_law), intent(in) :: law
    real(wp), intent(in) :: u1(:), bulk(2)
    class(heated_body), allocatable, intent(inout) :: body_1, body_2
    integer, intent(out) :: stat
    type(line_film_heat), allocatable :: heat

    stat = status_bad_argument
    allocate (heat)
    select type (film => contact%film)
    type is (line_contact)
      call new_line_heat(heat, film, law, u1, body_1, body_2, bulk, stat)
    end select
    if (stat == status_ok) call move_alloc(heat, contact%heat)
  end subroutine heat_line_contact

  !> Sets rates of change of the oil's temperature and pressure; see `thermal_step`.
  subroutine change_with_time(self, warming, pressing, stat)
    class(line_film_heat), intent(inout) :: self
    real(wp), intent(in) :: warming(:, :, :), pressing(:, :)
    integer, intent(out) :: stat
    integer :: err

    if (allocated(self%warming)) deallocate (self%warming, self%pressing)
    allocate (self%warming, source=warming(:, 1, :), stat=err)
    if (err == 0) allocate (self%pressing, source=pressing(:, 1), stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
  end subroutine change_with_time

  !> Number of columns whose shear stress did not converge in the last sweep.
  pure integer function unsolved(self)
    class(line_film_heat), intent(in) :: self

    unsolved = sum(self%shear%unsolved)
  end function unsolved

  !> Resets the initial stresses of sweeps.
  subroutine cool(self)
    class(line_film_heat), intent(inout) :: self

    self%stress = 0
  end subroutine cool

  !> Heat convected or stored by the oil, less that of its compression, at the nodes at the last sweep [W/m2].
  subroutine carried_heat(self, carried)
    class(line_film_heat), intent(in) :: self
    real(wp), intent(out) :: carried(:, :)

    carried(:, 1) = self%carried
  end subroutine carried_heat

  !> Columns of the line contact in the state of its film, each alone in the order of the entrainment (`heat_columns`).
  subroutine copy_columns(self, film, columns, stat)
    class(line_film_heat), intent(in) :: self
    class(film_contact), intent(in) :: film
    class(heat_columns), allocatable, intent(out) :: columns
    integer, intent(out) :: stat
    type(line_columns), allocatable :: line

    stat = status_bad_argument
    if (allocated(self%warming)) return
    allocate (line)
    call new_line_columns(line, film, self%onward < 0, self%u1, self%stress, stat)
    if (stat == status_ok) call move_alloc(line, columns)
  end subroutine copy_columns

  !> Makes one sweep over the columns with fixed walls: against the entrainment, then with it.
  !>
  !> `change` is the largest change of temperature [K] where the pressure exceeds `least` [Pa].
  subroutine sweep_columns(self, film, least, change)
    class(line_film_heat), intent(inout) :: self
    class(film_contact), intent(inout) :: film
    real(wp), intent(in) :: least
    real(wp), intent(out) :: change
    integer :: strip, first, thread, n

    n = size(film%gap, 1)
    self%shear%unsolved = 0
    !$omp parallel do private(first, thread) schedule(dynamic)
    do strip = 1, size(self%columns)
      first = 2 + (strip - 1)*most_columns
      thread = omp_get_thread_num()
      call set_strip(self, film, first, min(first + most_columns, n) - 1, self%columns(strip), self%shear(thread), &
        self%oil(thread))
    end do
    call sweep_nodes(self, film, -self%onward)
    call sweep_nodes(self, film, self%onward)
    change = 0
    do strip = 1, size(self%columns)
      call take_up(self, film, strip, least, change)
    end do
  end subroutine sweep_columns

  !> Computes shear and heat of the columns at nodes first..last, without convection.
  subroutine set_strip(self, film, first, last, columns, shear, oil)
    class(line_film_heat), intent(inout) :: self
    class(film_contact), intent(in) :: film
    integer, intent(in) :: first, last
    type(film_strip), intent(inout) :: columns
    type(shear_strip), intent(inout) :: shear
    type(column_oil), intent(inout) :: oil
    integer :: m, k

    m = last - first + 1
    shear%tau_x(:m) = self%stress(first:last)
    shear%tau_y(:m) = 0
    call gather_line(film, self%u1, first, last, columns, shear, oil)
    call shear_columns(film%oil, film%model%shear%nodes, oil%p, columns%known, shear, oil%mean, oil%softening)
    self%stress(first:last) = shear%tau_x(:m)
    if (allocated(self%pressing)) oil%pressing(:m) = self%pressing(first:last)
    call set_heat(self%law, film%oil, film%model%shear%nodes, shear, oil, columns)
    associate (capacity => oil%capacity, compression => oil%compression)
      do k = 1, size(oil%u, 2)
        self%flow(first:last, k) = capacity(:m)*oil%u(:m, k)/film%spacing(1)
        self%dissipation(first:last, k) = columns%source(:m, k)
        self%compression(first:last, k) = compression(:m, k)
        if (allocated(self%warming)) then
          self%compression(first:last, k) = self%compression(first:last, k) - capacity(:m)*self%warming(first:last, k)
        end if
      end do
    end associate
  end subroutine set_strip

  !> Solves the columns at the inner nodes one after another, `along` x or against it; against the entrainment only those
  !> with backflow.
  subroutine sweep_nodes(self, film, along)
    class(line_film_heat), intent(inout) :: self
    class(film_contact), intent(inout) :: film
    integer, intent(in) :: along
    integer :: i, strip, column, levels, n

    n = size(film%gap, 1)
    levels = size(self%flow, 2)
    associate (rise => film%model%shear%nodes%rise)
      do i = merge(2, n - 1, along > 0), merge(n - 1, 2, along > 0), along
        if (along /= self%onward .and. all(along*self%flow(i, :) <= 0)) cycle
        strip = (i - 2)/most_columns + 1
        column = i - 1 - (strip - 1)*most_columns
        associate (columns => self%columns(strip))
          call bring(rise(:, 1, :), self%flow(i, :), i, columns%absorption(column, :), columns%source(column, :))
          columns%source(column, :) = columns%source(column, :) + self%compression(i, :) + self%dissipation(i, :)
          call solve_column(columns, column)
          rise(i, 1, 2:levels - 1) = columns%temperature(column, 2:levels - 1)
        end associate
      end do
    end associate
  end subroutine sweep_nodes

  !> Gathers fluxes and admittances of a strip's columns for the walls, convected heat, and the largest change of
  !> temperature [K] where the pressure exceeds `least` [Pa].
  subroutine take_up(self, film, strip, least, change)
    class(line_film_heat), intent(inout) :: self
    class(film_contact), intent(in) :: film
    integer, intent(in) :: strip
    real(wp), intent(in) :: least
    real(wp), intent(inout) :: change
    real(wp), dimension(most_columns, film%model%shear%nodes%levels%count) :: inflow
    real(wp) :: carried(most_columns)
    integer :: i, c, k, m

    associate (columns => self%columns(strip), before => 1 + (strip - 1)*most_columns)
      m = columns%columns
      do k = 1, size(inflow, 2)
        inflow(:m, k) = columns%source(:m, k) - self%dissipation(before + 1:before + m, k)
      end do
      call carried_away(columns, inflow, carried)
      self%carried(before + 1:before + m) = carried(:m)
      do c = 1, m
        i = before + c
        self%walls%flux(i, 1, :) = columns%flux(c, :)
        self%walls%admittance(i, 1, :, :) = columns%admittance(c, :, :)
        if (film%model%fields%p(i, 1) > least) change = max(change, maxval(abs(columns%temperature(c, :) - columns%known(c, :))))
      end do
    end associate
  end subroutine take_up

end module pyworm_line_heat
