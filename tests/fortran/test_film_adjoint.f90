!> The adjoint of a film: its system is the transpose of Newton's Jacobian, whatever the contact, its entrainment and its oil, and
!> the change of a solved film by its load is what the adjoint says.
program test_film_adjoint
  use pyworm_kinds, only: wp
  use pyworm_film_adjoint, only: adjoint_system, film_adjoint, new_adjoint_system, solve_adjoint
  use pyworm_film_newton, only: contact_conditions, film_contact, film_residual, film_step, newton_step, roughen_contact, &
    set_system, shear_contact
  use pyworm_flow_laws, only: flow_law, law_eyring
  use pyworm_line_film, only: line_contact, new_line_contact
  use pyworm_point_film, only: new_point_contact, point_contact
  use pyworm_rough_surfaces, only: gap_curves
  use pyworm_status, only: status_bad_argument, status_ok
  use pyworm_viscosity_density, only: law_barus, law_roelands, oil_law
  use tap, only: check, close_to, done
  implicit none(type, external)

  real(wp), parameter :: pi = acos(-1.0_wp)
  type(oil_law), parameter :: oil = oil_law(law_roelands, 0.01_wp, 0.6_wp, 0.3_wp, 0.5_wp, 1.5_wp)

  call points(.false., .false.)
  call points(.true., .false.)
  call points(.true., .true.)
  call lines(.false.)
  call lines(.true.)
  call by_load()
  call done()

contains

  !> A point contact whose entrainment turns all round, of a Newtonian or an Eyring oil, between smooth or rough surfaces.
  subroutine points(sheared, rough)
    logical, intent(in) :: sheared, rough
    integer, parameter :: nx = 33, ny = 25
    type(point_contact), target :: contact
    real(wp), dimension(nx, ny) :: x, y
    logical :: covered(nx, ny)
    integer :: i, stat

    x = spread([(-1 + (i - 1)/16.0_wp, i=1, nx)], 2, ny)
    y = spread([(-0.75_wp + (i - 1)/16.0_wp, i=1, ny)], 1, nx)
    covered = .true.
    call new_point_contact(contact, contact_conditions((x**2 + y**2)/2, covered, [1, 1]/16.0_wp, pi, oil, 2*pi/3, 1e-4_wp), &
      cos(3*x + y), sin(x - 2*y), stat)
    call check(stat == status_ok, "a point contact is made")
    if (sheared) call shear_contact(contact, flow_law(law_eyring, 0.3_wp), 4, cos(x), sin(y), stat)
    if (rough) call roughen_contact(contact, closing_gap(), 0.1_wp, stat)
    call check(stat == status_ok, "and sheared")
    call transposed(contact, 0.3_wp*max(0.0_wp, 1 - x**2 - y**2)*(1.2_wp + sin(5*x - y)))
  end subroutine points

  !> A line contact.
  subroutine lines(rough)
    logical, intent(in) :: rough
    integer, parameter :: n = 41
    type(line_contact), target :: contact
    real(wp) :: x(n), p(n, 1), sliding(n, 1)
    integer :: i, stat

    x = [(-1 + 0.05_wp*(i - 1), i=1, n)]
    call new_line_contact(contact, x**2/2, [(.true., i=1, n)], sin(3*x), 0.05_wp, 4.0_wp, oil, pi/2, 1e-5_wp, stat)
    sliding(:, 1) = cos(x)
    if (rough) call shear_contact(contact, flow_law(law_eyring, 0.3_wp), 4, sliding, 0*sliding, stat)
    if (rough) call roughen_contact(contact, closing_gap(), 0.1_wp, stat)
    call check(stat == status_ok, "a line contact is made")
    p(:, 1) = 0.3_wp*max(0.0_wp, 1 - x**2)*(1.2_wp + sin(5*x))
    call transposed(contact, p)
  end subroutine lines

  !> Averages of a roughness: asperities' pressure falls e-fold in 0.05, its flow factor and real area follow the gap.
  function closing_gap() result(curves)
    type(gap_curves) :: curves
    integer :: k

    curves%scale = 0.05_wp
    curves%first = -2
    curves%spacing = 0.5_wp
    allocate (curves%value(9, 17), curves%slope(9, 17))
    curves%value = 0
    curves%slope = 0
    do k = 1, 17
      curves%value(1, k) = -1 - 0.5_wp*k
      curves%slope(1, k) = -1
      curves%value(2, k) = 0.02_wp*exp(-0.2_wp*k)
      curves%slope(2, k) = -0.008_wp*exp(-0.2_wp*k)
      curves%value(3, k) = 0.2_wp*exp(-0.2_wp*k)
      curves%slope(3, k) = -0.08_wp*exp(-0.2_wp*k)
      curves%value(4:5, k) = 1 - 0.3_wp*exp(-0.2_wp*k)
      curves%slope(4:5, k) = 0.12_wp*exp(-0.2_wp*k)
      curves%value(6:9, k) = 0.05_wp*exp(-0.2_wp*k)
      curves%slope(6:9, k) = -0.02_wp*exp(-0.2_wp*k)
    end do
  end function closing_gap

  !> y . (J x) = x . (J^T y) for vectors of free pressures and rows; and the system solves what it multiplies.
  subroutine transposed(contact, p)
    class(film_contact), target, intent(inout) :: contact
    real(wp), contiguous, intent(in) :: p(:, :)
    type(adjoint_system) :: system
    real(wp), allocatable, target :: x(:), y(:), jx(:), jy(:)
    real(wp) :: residual, load_error, both
    logical :: unknown(size(p))
    integer :: i, n, stat

    n = size(p)
    call film_residual(contact, p, 0.3_wp, residual, load_error)
    call new_adjoint_system(system, contact, stat)
    call check(stat == status_ok, "an adjoint system is made")
    allocate (x(n + 1), y(n + 1), jx(n + 1), jy(n + 1))
    x = [(sin(1.7_wp*i), i=1, n + 1)]
    y = [(cos(0.9_wp*i**2), i=1, n + 1)]
    unknown = reshape(contact%free .or. contact%model%is_rough(), [n])
    where (.not. unknown) x(:n) = 0
    where (.not. unknown) y(:n) = 0
    call set_system(contact, stat)
    call contact%multiply(x, jx)
    call system%multiply(y, jy)
    both = dot_product(y, jx)
    call close_to(dot_product(x, jy)/both, 1.0_wp, 1e-11_wp, "the adjoint multiplies by the transpose")
  end subroutine transposed

  !> Minimum film and largest pressure of a circular contact under a little more and a little less load.
  subroutine by_load()
    integer, parameter :: n = 49
    real(wp), parameter :: load = 2*pi/3, step = 1e-4_wp
    type(point_contact) :: loaded, relieved
    type(point_contact), target :: contact
    type(adjoint_system) :: system
    type(film_adjoint) :: found
    real(wp), dimension(n, n) :: p, more, less, weight, none
    real(wp) :: film(-1:1)
    integer :: stat

    call solve(load*(1 + step), loaded, more)
    film(1) = loaded%model%fields%h(n/2 + 1, n/2 + 1)
    call solve(load*(1 - step), relieved, less)
    film(-1) = relieved%model%fields%h(n/2 + 1, n/2 + 1)
    call solve(load, contact, p)
    call new_adjoint_system(system, contact, stat)
    weight = 0
    none = 0
    weight(n/2 + 1, n/2 + 1) = 1
    call solve_adjoint(system, none, weight, 1e-10_wp, 300, found, stat)
    call check(stat == status_ok .and. found%iterations < 60, "the adjoint of the film in the middle is solved in few iterations")
    call close_to(found%by_load/((film(1) - film(-1))/(2*step*load)), 1.0_wp, 1e-6_wp, "which gives its change by the load")
    call solve_adjoint(system, weight, none, 1e-10_wp, 300, found, stat)
    call close_to(found%by_load/((more(n/2 + 1, n/2 + 1) - less(n/2 + 1, n/2 + 1))/(2*step*load)), 1.0_wp, 1e-6_wp, &
      "and that of the pressure there")
    call contact%feed(none + 1, stat)
    call new_adjoint_system(system, contact, stat)
    call check(stat == status_bad_argument, "a film of a limited supply is refused")
  end subroutine by_load

  !> A circular contact at (M, L) = (20, 10) in Hertz units, to a residual of 1e-12.
  subroutine solve(load, contact, p)
    real(wp), intent(in) :: load
    type(point_contact), intent(inout) :: contact
    real(wp), intent(out) :: p(:, :)
    real(wp), parameter :: m = 20, l = 10
    real(wp), parameter :: alpha = l/pi*(1.5_wp*m)**(1.0_wp/3), eta0 = (128*pi**3/(3*m**4))**(1.0_wp/3)/12
    real(wp) :: gap(size(p, 1), size(p, 2)), h0, residual, load_error, x(size(p, 1))
    type(newton_step) :: step
    logical :: covered(size(p, 1), size(p, 2))
    integer :: i, n, steps, stat

    n = size(p, 1)
    x = [(-3 + 4.5_wp*(i - 1)/(n - 1), i=1, n)]
    gap = (spread(x, 2, n)**2 + spread(x + 0.75_wp, 1, n)**2)/2
    covered = .true.
    call new_point_contact(contact, contact_conditions(gap, covered, [4.5_wp, 4.5_wp]/(n - 1), pi, &
      oil_law(law_barus, eta0, alpha, 1.0_wp, 0.0_wp, 0.0_wp), load, 1e-4_wp), 0*gap + 1, 0*gap, stat)
    p = sqrt(max(0.0_wp, 1 - 2*gap)) + 1e-6_wp
    p([1, n], :) = 0
    p(:, [1, n]) = 0
    h0 = -0.5_wp
    call film_residual(contact, p, h0, residual, load_error)
    do steps = 1, 40
      if (residual + abs(load_error) < 1e-12_wp) exit
      call film_step(contact, 1e-6_wp, p, h0, residual, load_error, step, stat)
      if (stat /= status_ok) exit
    end do
    call check(residual + abs(load_error) < 1e-10_wp, "a film is found")
  end subroutine solve

end program test_film_adjoint
