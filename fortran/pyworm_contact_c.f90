!> The same for C programs (`pyworm_contact.h`): plain numbers and arrays, x changing fastest, contacts as opaque pointers.
module pyworm_contact_c
  use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_f_procpointer, c_funptr, c_int, c_loc, &
    c_null_ptr, c_ptr
  use pyworm_contact, only: interruption_query, pyworm_bad_argument, pyworm_body, pyworm_conditions, pyworm_flow, &
    pyworm_solve_dry, pyworm_found, pyworm_interrupt_by, pyworm_ok, pyworm_oil, pyworm_point, pyworm_read, &
    pyworm_setup, pyworm_shear, pyworm_solve
  implicit none(type, external)
  private

  public :: c_solve_dry, c_setup, c_solve, c_read, c_shear, c_free, c_interrupt_by

  abstract interface
    !> Not zero once the present call is to end.
    integer(c_int) function c_query() bind(c)
      import :: c_int
      implicit none(type, external)
    end function c_query
  end interface

  !> An oil, a flow law and a body as the header has them.
  type, bind(c) :: c_oil
    integer(c_int) :: law
    real(c_double) :: viscosity, exponent, pole_pressure, d1, d2, temperature, thermal_exponent, expansivity, conductivity, &
      heat_capacity
  end type c_oil

  type, bind(c) :: c_flow
    integer(c_int) :: law
    real(c_double) :: stress, limit, limit_pressure, exponent
    integer(c_int) :: levels
  end type c_flow

  type, bind(c) :: c_body
    real(c_double) :: conductivity, heat_capacity, bulk_rise
  end type c_body

  type, bind(c) :: c_found
    real(c_double) :: film_min, film_central, pressure_max, film_min_error, film_central_error, pressure_max_error, &
      window_error, residual, load_error
    integer(c_int) :: steps, coarsening
  end type c_found

  procedure(c_query), pointer :: c_asked => null()

contains

  !> As `pyworm_solve_dry`.
  integer(c_int) function c_solve_dry(nx, ny, gap, dx, dy, reduced_modulus, load, tolerance, p, approach) &
      bind(c, name="pyworm_solve_dry")
    integer(c_int), value :: nx, ny
    real(c_double), intent(in) :: gap(nx, ny)
    real(c_double), value :: dx, dy, reduced_modulus, load, tolerance
    real(c_double), intent(out) :: p(nx, ny), approach
    integer :: stat

    call pyworm_solve_dry(gap, dx, dy, reduced_modulus, load, tolerance, p, approach, stat)
    c_solve_dry = stat
  end function c_solve_dry

  !> As `pyworm_setup`; `flow` and `bodies` may be null.
  type(c_ptr) function c_setup(nx, ny, gap, dx, dy, velocity_1, velocity_2, reduced_modulus, load, oil, flow, bodies, status) &
      bind(c, name="pyworm_setup")
    integer(c_int), value :: nx, ny
    real(c_double), intent(in) :: gap(nx, ny)
    real(c_double), value :: dx, dy, reduced_modulus, load
    real(c_double), intent(in) :: velocity_1(2), velocity_2(2)
    type(c_oil), intent(in) :: oil
    type(c_ptr), value :: flow, bodies
    integer(c_int), intent(out) :: status
    type(pyworm_point), pointer :: contact
    type(c_flow), pointer :: law
    type(c_body), pointer :: two(:)
    type(pyworm_flow), allocatable :: own_flow
    type(pyworm_body), allocatable :: own_bodies(:)
    integer :: stat, k

    allocate (contact)
    if (c_associated(flow)) then
      call c_f_pointer(flow, law)
      own_flow = pyworm_flow(law%law, law%stress, law%limit, law%limit_pressure, law%exponent, law%levels)
    end if
    if (c_associated(bodies)) then
      call c_f_pointer(bodies, two, [2])
      own_bodies = [(pyworm_body(two(k)%conductivity, two(k)%heat_capacity, two(k)%bulk_rise), k=1, 2)]
    end if
    ! an argument that is not allocated counts as absent
    call pyworm_setup(contact, gap, dx, dy, pyworm_conditions(load, reduced_modulus, velocity_1, velocity_2), &
      pyworm_oil(oil%law, oil%viscosity, oil%exponent, oil%pole_pressure, oil%d1, oil%d2, oil%temperature, &
      oil%thermal_exponent, oil%expansivity, oil%conductivity, oil%heat_capacity), stat, own_flow, own_bodies)
    status = stat
    c_setup = c_loc(contact)
  end function c_setup

  !> As `pyworm_solve`.
  integer(c_int) function c_solve(contact, tolerance, accuracy, found) bind(c, name="pyworm_solve")
    type(c_ptr), value :: contact
    real(c_double), value :: tolerance, accuracy
    type(c_found), intent(out) :: found
    type(pyworm_point), pointer :: own
    type(pyworm_found) :: of_own
    integer :: stat

    call c_f_pointer(contact, own)
    call pyworm_solve(own, tolerance, accuracy, of_own, stat)
    found = c_found(of_own%film_min, of_own%film_central, of_own%pressure_max, of_own%film_min_error, &
      of_own%film_central_error, of_own%pressure_max_error, of_own%window_error, of_own%residual, of_own%load_error, &
      of_own%steps, of_own%coarsening)
    c_solve = stat
  end function c_solve

  !> As `pyworm_read`, of a grid of (nx, ny) nodes.
  subroutine c_read(contact, nx, ny, p, h, rise) bind(c, name="pyworm_read")
    type(c_ptr), value :: contact
    integer(c_int), value :: nx, ny
    real(c_double), intent(out) :: p(nx, ny), h(nx, ny), rise(nx, ny)
    type(pyworm_point), pointer :: own

    call c_f_pointer(contact, own)
    call pyworm_read(own, p, h, rise)
  end subroutine c_read

  !> As `pyworm_shear`.
  integer(c_int) function c_shear(contact, nx, ny, stress_x, stress_y, heat) bind(c, name="pyworm_shear")
    type(c_ptr), value :: contact
    integer(c_int), value :: nx, ny
    real(c_double), intent(out) :: stress_x(nx, ny), stress_y(nx, ny), heat(nx, ny)
    type(pyworm_point), pointer :: own
    integer :: stat

    call c_f_pointer(contact, own)
    call pyworm_shear(own, stress_x, stress_y, heat, stat)
    c_shear = stat
  end function c_shear

  !> Releases a contact.
  subroutine c_free(contact) bind(c, name="pyworm_free")
    type(c_ptr), value :: contact
    type(pyworm_point), pointer :: own

    if (.not. c_associated(contact)) return
    call c_f_pointer(contact, own)
    deallocate (own)
  end subroutine c_free

  !> Sets what is asked, once an iteration, whether a call is to end; null for nothing.
  subroutine c_interrupt_by(asked) bind(c, name="pyworm_interrupt_by")
    type(c_funptr), value :: asked
    procedure(interruption_query), pointer :: query

    call c_f_procpointer(asked, c_asked)
    query => null()
    if (associated(c_asked)) query => ask
    call pyworm_interrupt_by(query)
  end subroutine c_interrupt_by

  logical function ask()
    ask = c_asked() /= 0
  end function ask

end module pyworm_contact_c
