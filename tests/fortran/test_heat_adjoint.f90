!> A body whose surface warms where it is heated, in double precision, as differences want it.
module local_surface
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  !> A body whose surface warms where it is heated, and half as much at the next node along x.
  type, extends(heated_body), public :: local_body
  contains
    procedure :: rise
    procedure :: rise_transposed
  end type local_body

contains

  subroutine rise(self, q, temperature_rise)
    class(local_body), intent(inout) :: self
    real(wp), intent(in) :: q(self%nx, self%ny)
    real(wp), intent(out) :: temperature_rise(self%nx, self%ny)

    temperature_rise = self%own*q
    temperature_rise(2:, :) = temperature_rise(2:, :) + self%own*q(:self%nx - 1, :)/2
  end subroutine rise

  subroutine rise_transposed(self, weight, by_flux)
    class(local_body), intent(inout) :: self
    real(wp), intent(in) :: weight(self%nx, self%ny)
    real(wp), intent(out) :: by_flux(self%nx, self%ny)

    by_flux = self%own*weight
    by_flux(:self%nx - 1, :) = by_flux(:self%nx - 1, :) + self%own*weight(2:, :)/2
  end subroutine rise_transposed

end module local_surface

!> Heat of converged films: the residual of its equations falls with the sweeps, approximate solves are each other's transposes,
!> and the coupled adjoint of film and temperature is the difference of converged films.
program test_heat_adjoint
  use local_surface, only: local_body
  use pyworm_film_newton, only: contact_conditions, newton_step, roughen_contact, shear_contact, film_residual, film_step
  use pyworm_flow_laws, only: flow_law, law_eyring
  use pyworm_heat_preconditioner, only: solve_heat, solve_heat_transposed
  use pyworm_heat_residual, only: heat_residual
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  use pyworm_line_film, only: line_contact, new_line_contact
  use pyworm_line_heat, only: heat_line_contact
  use pyworm_point_film, only: point_contact, new_point_contact
  use pyworm_point_heat, only: heat_point_contact
  use pyworm_rough_surfaces, only: curve_count, gap_curves
  use pyworm_status, only: status_ok
  use pyworm_thermal_adjoint, only: thermal_adjoint, thermal_adjoint_system, new_thermal_adjoint_system, solve_thermal_adjoint
  use pyworm_thermal_properties, only: oil_heat_law
  use pyworm_thermal_step, only: thermal_contact, heated_step
  use pyworm_viscosity_density, only: oil_law, law_barus
  use tap, only: check, close_to, done
  implicit none(type, external)

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Moes' numbers (M, L) = (20, 10) of both contacts in Hertz units: of points alpha p_H = (L/pi)(1.5 M)^(1/3), 12 eta0 u =
  !> (128 pi^3 / 3 M^4)^(1/3), of lines alpha p_H = L (M / 2 pi)^(1/2), 12 eta0 u = 3 pi^2 / 8 M^2.
  real(wp), parameter :: m = 20, l = 10
  type(flow_law), parameter :: eyring = flow_law(law_eyring, 8.0_wp, 0.3_wp, 0.003_wp)
  type(oil_heat_law), parameter :: heat_law = oil_heat_law(0.034_wp, 0.5_wp, 1.0_wp, 2.0_wp, 0.2_wp, 1.0_wp, 5e-4_wp, &
    0.2_wp, 0.1_wp)
  !> Velocity of the bodies.
  real(wp), parameter :: u1(2) = [1.3_wp, 0.1_wp], u2(2) = [0.7_wp, -0.05_wp]
  integer, parameter :: levels = 5
  !> Height of the asperities.
  real(wp), parameter :: roughness = 0.06_wp

  !> A contact with its pressure and rigid film.
  type :: contact_state
    type(thermal_contact) :: contact
    real(wp), allocatable :: p(:, :)
    real(wp) :: h0 = 0
  end type contact_state

  !> What a figure is differentiated by: bulk temperature of body 1, load and gap.
  type :: contact_inputs
    real(wp) :: bulk = 0, load = 0
    real(wp), allocatable :: gap(:, :)
  end type contact_inputs

  integer :: stat

  call examine("a point contact", .true., .false.)
  call examine("a line contact", .false., .false.)
  call examine("a rough line contact", .false., .true.)
  call done()

contains

  !> An oil of both numbers, by alpha and 12 eta0.
  pure type(oil_law) function oil(alpha, viscosity)
    real(wp), intent(in) :: alpha, viscosity

    oil = oil_law(law_barus, viscosity/12, alpha, 1.0_wp, 0.3_wp, 1.0_wp, 300.0_wp, 0.04_wp, 7e-4_wp, 0.5_wp)
  end function oil

  !> A contact under a load, its film and temperature found together.
  subroutine examine(what, point, rough)
    character(len=*), intent(in) :: what
    logical, intent(in) :: point, rough
    type(contact_state), target :: state
    real(wp), allocatable :: residual(:, :, :), later(:, :, :)

    if (point) then
      call make_point(state, rough)
    else
      call make_line(state, rough)
    end if
    call converge(state, 1e-4_wp)
    residual = state%contact%film%model%shear%nodes%rise
    later = residual
    call heat_residual(state%contact%film, state%contact%heat, residual, stat)
    call converge(state, 1e-8_wp)
    call check(maxval(state%contact%film%model%shear%nodes%rise) > 20, what//": heat changes the viscosity much")
    call heat_residual(state%contact%film, state%contact%heat, later, stat)
    call check(maxval(abs(later)) < 1e-2_wp*maxval(abs(residual)), what//": the residual falls with the sweeps")
    call adjoint(what, state)
  end subroutine examine

  !> A point contact in Hertz units.
  subroutine make_point(state, rough)
    type(contact_state), intent(inout) :: state
    logical, intent(in) :: rough
    integer, parameter :: n = 33
    real(wp), parameter :: dx = 6.0_wp/(n - 1)
    class(heated_body), allocatable :: body_1, body_2
    type(point_contact), allocatable :: film
    real(wp) :: gap(n, n)
    integer :: i, j

    do j = 1, n
      do i = 1, n
        gap(i, j) = ((-3.5_wp + dx*(i - 1))**2 + (-3 + dx*(j - 1))**2)/2
      end do
    end do
    allocate (film)
    call new_point_contact(film, contact_conditions(gap, gap >= 0, [dx, dx], pi, &
      oil(l/pi*(1.5_wp*m)**(1.0_wp/3), (128*pi**3/(3*m**4))**(1.0_wp/3)), 2*pi/3, 1e-4_wp), 0*gap + (u1(1) + u2(1))/2, &
      0*gap + (u1(2) + u2(2))/2, stat)
    call shear_contact(film, eyring, levels, 0*gap + u2(1) - u1(1), 0*gap + u2(2) - u1(2), stat)
    if (rough) call roughen_contact(film, curves(), 0.12_wp, stat)
    call move_alloc(film, state%contact%film)
    state%p = sqrt(max(0.0_wp, 1 - 2*gap))
    state%h0 = -0.5_wp
    call find_film(state)
    call new_body(n, n, body_1)
    call new_body(n, n, body_2)
    call heat_point_contact(state%contact, heat_law, 0*gap + u1(1), 0*gap + u1(2), body_1, body_2, [5.0_wp, 0.0_wp], stat)
    call check(stat == status_ok, "a point contact is heated")
  end subroutine make_point

  !> A line contact in Hertz units.
  subroutine make_line(state, rough)
    type(contact_state), intent(inout) :: state
    logical, intent(in) :: rough
    integer, parameter :: n = 129
    real(wp), parameter :: dx = 6.0_wp/(n - 1)
    class(heated_body), allocatable :: body_1, body_2
    type(line_contact), allocatable :: film
    real(wp) :: x(n), field(n, 1)
    integer :: i

    x = [(-4 + dx*(i - 1), i=1, n)]
    field = 1
    allocate (film)
    call new_line_contact(film, x**2/2, [(.true., i=1, n)], 0*x + (u1(1) + u2(1))/2, dx, 4.0_wp, &
      oil(l*sqrt(m/(2*pi)), 3*pi**2/(8*m**2)), pi/2, 1e-5_wp, stat)
    call shear_contact(film, eyring, levels, (u2(1) - u1(1))*field, 0*field, stat)
    if (rough) call roughen_contact(film, curves(), 0.12_wp, stat)
    call move_alloc(film, state%contact%film)
    field(:, 1) = sqrt(max(0.0_wp, 1 - x**2)) + 1e-6_wp
    field([1, n], 1) = 0
    state%p = field
    state%h0 = 0.4_wp
    call find_film(state)
    call new_body(n, 1, body_1)
    call new_body(n, 1, body_2)
    call heat_line_contact(state%contact, heat_law, 0*x + u1(1), body_1, body_2, [5.0_wp, 0.0_wp], stat)
    call check(stat == status_ok, "a line contact is heated")
  end subroutine make_line

  !> Curves of surfaces whose asperities bear some of the load; their slopes are differences.
  function curves() result(table)
    type(gap_curves) :: table
    integer, parameter :: rows = 400
    real(wp) :: row
    integer :: k

    table%scale = roughness
    table%first = asinh(-6.0_wp)
    table%spacing = (asinh(1e4_wp) - table%first)/(rows - 1)
    allocate (table%value(curve_count, rows), table%slope(curve_count, rows))
    do k = 1, rows
      row = table%first + (k - 1)*table%spacing
      table%value(:, k) = values_at(roughness*sinh(row))
      table%slope(:, k) = (values_at(roughness*sinh(row + 1e-4_wp)) - values_at(roughness*sinh(row - 1e-4_wp)))/2e-4_wp
    end do
  end function curves

  !> All curves at a gap.
  pure function values_at(gap) result(values)
    real(wp), intent(in) :: gap
    real(wp) :: values(curve_count), fall

    fall = exp(-min(max(gap/roughness, -6.0_wp), 300.0_wp))
    values(1) = max(log(0.5_wp) - 2*gap/roughness, -600.0_wp)
    values(2) = 0.4_wp*roughness*fall
    values(3) = 0.2_wp*fall
    values(4:6) = [1.0_wp, 1.0_wp, 0.0_wp] + fall*[0.1_wp, -0.5_wp, 0.2_wp]
    values(7:9) = -0.2_wp*roughness*fall*[0.6_wp, 0.4_wp, 0.3_wp]
  end function values_at

  subroutine new_body(nx, ny, made)
    integer, intent(in) :: nx, ny
    class(heated_body), allocatable, intent(out) :: made
    type(local_body), allocatable :: warm

    allocate (warm)
    warm%nx = nx
    warm%ny = ny
    warm%own = 0.1_wp
    call move_alloc(warm, made)
  end subroutine new_body

  !> Finds the film at the inlet's temperature.
  subroutine find_film(state)
    type(contact_state), intent(inout) :: state
    type(newton_step) :: step
    real(wp) :: residual, load_error
    integer :: steps

    call film_residual(state%contact%film, state%p, state%h0, residual, load_error)
    do steps = 1, 30
      call film_step(state%contact%film, 0.03_wp, state%p, state%h0, residual, load_error, step, stat)
      if (residual + abs(load_error) < 1e-4_wp) exit
    end do
  end subroutine find_film

  !> Finds film and temperature, which then changes by less than `tolerance` [K] in a step.
  subroutine converge(state, tolerance)
    type(contact_state), intent(inout) :: state
    real(wp), intent(in) :: tolerance
    type(newton_step) :: step
    real(wp) :: residual, load_error
    integer :: steps

    call film_residual(state%contact%film, state%p, state%h0, residual, load_error)
    do steps = 1, 150
      call heated_step(state%contact%film, state%contact%heat, 1e-3_wp, state%p, state%h0, residual, load_error, step, stat)
      if (step%change < tolerance .and. residual < 0.01_wp*tolerance) exit
    end do
    call check(step%change < tolerance, "film and temperature converge")
  end subroutine converge

  !> Weights of a figure in temperatures, from node to node and level to level.
  pure subroutine weigh(weight)
    real(wp), intent(out) :: weight(:, :, :)
    integer :: i, j, k

    do k = 1, size(weight, 3)
      do j = 1, size(weight, 2)
        do i = 1, size(weight, 1)
          weight(i, j, k) = 1 + cos(0.7_wp*i + 0.4_wp*j*j + 1.3_wp*k)
        end do
      end do
    end do
  end subroutine weigh

  !> A figure of pressures and temperatures by bulk temperature, load and gap together: coupled adjoint against difference.
  subroutine adjoint(what, state)
    character(len=*), intent(in) :: what
    type(contact_state), target, intent(inout) :: state
    type(thermal_adjoint_system) :: system
    type(thermal_adjoint) :: found
    real(wp), allocatable, dimension(:, :, :) :: weight, solved, other
    real(wp), parameter :: step = 0.01_wp
    type(contact_inputs) :: start
    real(wp) :: figure(2), slope, along, lift(size(state%p, 1), size(state%p, 2))
    integer :: k

    allocate (weight, solved, other, mold=state%contact%film%model%shear%nodes%rise)
    call weigh(weight)
    call new_thermal_adjoint_system(system, state%contact, stat)
    call check(stat == status_ok, what//": the coupled system is made")
    call solve_heat(system%heat, system%approximate, weight, solved)
    call solve_heat_transposed(system%heat, system%approximate, weight, other)
    call close_to(sum(solved*weight), sum(other*weight), 1e-12_wp*norm2(solved)*norm2(weight), &
      what//": approximate solves are each other's transposes")

    call solve_thermal_adjoint(system, 3*weight(:, :, 1), 0*weight(:, :, 1), weight, 1e-8_wp, 200, found, stat)
    call check(stat == status_ok .and. found%reduction <= 1e-8_wp, what//": it is solved")
    call close_to(sum(found%by_gap), 0.0_wp, 1e-6_wp*sum(abs(found%by_gap)), what//": the rigid film takes up a lift of all")
    associate (film => state%contact%film, body => state%contact%heat%walls%body(1))
      lift = 1e-3_wp*(weight(:, :, 2) - 1)
      slope = by_bulk(state%contact, found%heat) + found%by_load*film%load/100 + sum(found%by_gap*lift)
      start = contact_inputs(body%bulk, film%load, film%gap)
      do k = 1, 2
        along = (2*k - 3)*step
        body%bulk = start%bulk + along
        film%load = start%load*(1 + along/100)
        film%gap = start%gap + along*lift
        call converge(state, 1e-8_wp)
        figure(k) = sum(weight*film%model%shear%nodes%rise) + sum(3*weight(:, :, 1)*state%p)
      end do
    end associate
    call close_to(slope, (figure(2) - figure(1))/(2*step), 1e-5_wp*slope, what//": a figure by bulk temperature, load and gap")
  end subroutine adjoint

  !> What the heat's equations with these weights change by a higher bulk temperature of body 1, with the opposite sign.
  real(wp) function by_bulk(contact, weight)
    type(thermal_contact), intent(in) :: contact
    real(wp), intent(in) :: weight(:, :, :)
    integer :: k, nx, rows(2)

    nx = size(weight, 1)
    rows = [min(2, size(weight, 2)), max(size(weight, 2) - 1, 1)]
    by_bulk = sum(weight(:, :, 1))
    do k = 2, size(weight, 3) - 1
      by_bulk = by_bulk + (0.5_wp - contact%film%model%shear%nodes%levels%z(k)) &
        *(sum(weight(:, :, k)) - sum(weight(2:nx - 1, rows(1):rows(2), k)))
    end do
  end function by_bulk

end program test_heat_adjoint
