!> Temperature of the film of a point contact (`thermal_step`), swept with the oil (`column_sweep`).
!>
!> A sweep goes with the entrainment. Oil that flows back, or to a side, as beside the contact where pressure stops the
!> entrained oil, takes its upwind temperature from later columns or from its own line: until it converges, sweeps in its
!> own directions precede. Without them heat would be convected by one node a sweep there.
module pyworm_point_heat
  use pyworm_column_sweep, only: swept_columns, new_swept_columns, change_swept, enter_sweep, sweep_lines, swept_rise
  use pyworm_column_work, only: column_work, new_column_work
  use pyworm_film_newton, only: film_contact
  use pyworm_heat_columns, only: heat_columns
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  use pyworm_point_columns, only: point_columns, new_point_columns
  use pyworm_point_film, only: point_contact
  use pyworm_status, only: status_ok, status_bad_argument
  use pyworm_sweep_order, only: sweep_frame, new_sweep_frame, from_sweep
  use pyworm_thermal_properties, only: oil_heat_law
  use pyworm_thermal_step, only: film_heat, thermal_contact, new_film_heat, enclose_film
  implicit none(type, external)
  private

  public :: point_film_heat, new_point_heat, heat_point_contact, swept_shear

  !> Change of temperature of oil that flows against the sweep or along its lines, over the largest rise, above which it is
  !> swept in its own direction too.
  real(wp), parameter :: lagging = 0.01_wp
  !> Fraction of the largest pressure above which temperatures must converge; reduction of the walls' imbalance by a
  !> sweep, and its largest number of Krylov iterations.
  real(wp), parameter :: judged_pressure = 0.02_wp, wall_tolerance = 0.1_wp
  integer, parameter :: most_wall_iterations = 8

  type, extends(film_heat) :: point_film_heat
    !> Columns in the order of sweeps with or against the entrainment, and across it. Allocatable, lest gfortran (12.2)
    !> release only the first (tests/python/test_fortran_types.py).
    type(swept_columns), allocatable :: main, aside
    !> Scratch of each thread.
    type(column_work), allocatable :: threads(:)
  contains
    procedure :: sweep_columns
    procedure :: change_with_time
    procedure :: cool
    procedure :: unsolved
    procedure :: carried_heat
    procedure :: copy_columns
  end type point_film_heat

contains

  !> Heat of a point contact whose film is already sheared.
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
    type(sweep_frame) :: with_oil, across_it

    self%judged_pressure = judged_pressure
    self%wall_tolerance = wall_tolerance
    call new_film_heat(self, film, law, body_1, body_2, bulk, most_wall_iterations, stat)
    if (stat /= status_ok) return
    associate (grid => film%grid, along_x => film%cycles%transposed)
      with_oil = new_sweep_frame(grid%nx, grid%ny, grid%dx, grid%dy, along_x, .not. film%cycles%rising)
      across_it = new_sweep_frame(grid%nx, grid%ny, grid%dx, grid%dy, .not. along_x, .false.)
    end associate
    call new_swept_columns(self%main, film, with_oil, .false., u1, v1, stat)
    if (stat == status_ok) call new_swept_columns(self%aside, film, across_it, .true., u1, v1, stat)
    if (stat == status_ok) call new_column_work(self%threads, film, stat)
    if (stat == status_ok) call enclose_film(film, self)
  end subroutine new_point_heat

  !> Gives a point contact whose film is already sheared its heat; for the arguments see `new_point_heat`.
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

  !> Sets rates of change of the oil's temperature and pressure; see `thermal_step`.
  subroutine change_with_time(self, warming, pressing, stat)
    class(point_film_heat), intent(inout) :: self
    real(wp), intent(in) :: warming(:, :, :), pressing(:, :)
    integer, intent(out) :: stat

    call change_swept(self%main, warming, pressing, stat)
    if (stat == status_ok) call change_swept(self%aside, warming, pressing, stat)
  end subroutine change_with_time

  !> Number of columns whose shear stress did not converge in the last sweep.
  pure integer function unsolved(self)
    class(point_film_heat), intent(in) :: self

    unsolved = sum(self%threads%shear%unsolved)
  end function unsolved

  !> Resets the initial stresses of sweeps and the marks of backflow and side flow.
  subroutine cool(self)
    class(point_film_heat), intent(inout) :: self

    call forget(self%main)
    call forget(self%aside)
  end subroutine cool

  !> Resets the stresses and changes of the last sweep.
  pure subroutine forget(columns)
    type(swept_columns), intent(inout) :: columns

    columns%stress_x = 0
    columns%stress_y = 0
    columns%change_backward = 0
    columns%change_along = 0
  end subroutine forget

  !> Heat convected or stored by the oil, less that of its compression, at the nodes at the last sweep [W/m2].
  subroutine carried_heat(self, carried)
    class(point_film_heat), intent(in) :: self
    real(wp), intent(out) :: carried(:, :)

    call from_sweep(self%main%way, self%main%carried, carried)
  end subroutine carried_heat

  !> Columns of the point contact in the state of its film, in the order of the sweep with the entrainment (`heat_columns`).
  subroutine copy_columns(self, film, columns, stat)
    class(point_film_heat), intent(in) :: self
    class(film_contact), intent(in) :: film
    class(heat_columns), allocatable, intent(out) :: columns
    integer, intent(out) :: stat
    type(point_columns), allocatable :: point

    stat = status_bad_argument
    if (allocated(self%main%warming)) return
    allocate (point)
    call new_point_columns(point, film, self%main, stat)
    if (stat == status_ok) call move_alloc(point, columns)
  end subroutine copy_columns

  !> Stress at the middle of the film [Pa], heat of shearing [W/m2] and the largest shear rate across the film [1/s] at the
  !> nodes, as of the last sweep.
  subroutine swept_shear(heat, stress_x, stress_y, friction, rate)
    class(film_heat), intent(in) :: heat
    real(wp), intent(out) :: stress_x(:, :), stress_y(:, :), friction(:, :), rate(:, :)

    select type (heat)
    type is (point_film_heat)
      associate (main => heat%main)
        call from_sweep(main%way, main%stress_x, stress_x)
        call from_sweep(main%way, main%stress_y, stress_y)
        call from_sweep(main%way, main%friction, friction)
        call from_sweep(main%way, main%rate, rate)
      end associate
    end select
  end subroutine swept_shear

  !> Sweeps the columns with the entrainment, at constant wall temperature, after sweeps in other directions where oil that
  !> flows so has not converged.
  !>
  !> `change` is the largest of temperature [K] at more than a pressure of `least` [Pa].
  subroutine sweep_columns(self, film, least, change)
    class(point_film_heat), intent(inout) :: self
    class(film_contact), intent(inout) :: film
    real(wp), intent(in) :: least
    real(wp), intent(out) :: change
    real(wp) :: unsettled
    integer :: k, i

    associate (main => self%main)
      unsettled = lagging*maxval(film%model%shear%nodes%rise)
      if (main%change_along > unsettled) call sweep_aside(self, film, least)
      call enter_sweep(main, film)
      if (main%change_backward > unsettled) then
        call sweep_lines(main, film, self%law, self%threads, .true., least, change)
      end if
      self%threads%shear%unsolved = 0
      call sweep_lines(main, film, self%law, self%threads, .false., least, change)
      call swept_rise(main, film)
      do k = 1, 2
        call from_sweep(main%way, main%flux(:, :, k), self%walls%flux(:, :, k))
        ! where a surface has ended gaps are as wide as teeth, and oil that turns back in them would heat the other
        where (.not. film%covered) self%walls%flux(:, :, k) = 0
        do i = 1, 2
          call from_sweep(main%way, main%admittance(:, :, i, k), self%walls%admittance(:, :, i, k))
          where (.not. film%covered) self%walls%admittance(:, :, i, k) = 0
        end do
      end do
    end associate
  end subroutine sweep_columns

  !> Sweeps to both sides the levels at which oil moves there rather than with the entrainment.
  subroutine sweep_aside(self, film, least)
    class(point_film_heat), intent(inout) :: self
    class(film_contact), intent(inout) :: film
    real(wp), intent(in) :: least
    real(wp) :: change

    call enter_sweep(self%aside, film)
    call sweep_lines(self%aside, film, self%law, self%threads, .true., least, change)
    call sweep_lines(self%aside, film, self%law, self%threads, .false., least, change)
    call swept_rise(self%aside, film)
  end subroutine sweep_aside

end module pyworm_point_heat
