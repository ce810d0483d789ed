!> The film of a line contact: its Jacobian against differences, Newton's method, mirror symmetry, Martin's
!> exact rigid film, and what is refused.
program test_line_film
  use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_positive_inf
  use pyworm_kinds, only: wp
  use pyworm_film_newton, only: newton_step, set_transient_term, film_residual, film_step, set_system
  use pyworm_line_film, only: line_contact, new_line_contact
  use pyworm_viscosity_density, only: oil_law, law_barus, law_roelands
  use pyworm_status, only: status_ok, status_bad_argument, status_not_finite
  use tap, only: check, close_to, done
  implicit none(type, external)

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> With E' = 4, R = 1 and this load, Hertz's half-width and pressure are 1.
  real(wp), parameter :: load = pi/2, modulus = 4
  !> (M, L) = (20, 10): alpha p_H = L (M / 2 pi)^(1/2), 12 eta0 u = 3 pi^2 / 8 M^2.
  real(wp), parameter :: m = 20, l = 10
  real(wp), parameter :: alpha = l*sqrt(m/(2*pi)), eta0 = pi**2/(32*m**2)
  real(wp), parameter :: floor = 1e-5_wp
  type(oil_law), parameter :: barus = oil_law(law_barus, eta0, alpha, 1.0_wp, 0.0_wp, 0.0_wp)

  call jacobian()
  call piezoviscous()
  call martin()
  call refusals()
  call done()

contains

  !> A field of a line contact as the film takes it.
  pure function on_nodes(a) result(field)
    real(wp), intent(in) :: a(:)
    real(wp) :: field(size(a), 1)

    field(:, 1) = a
  end function on_nodes

  !> The written Jacobian times a direction against central differences of the imbalance.
  subroutine jacobian()
    integer, parameter :: n = 41
    type(line_contact) :: contact
    real(wp) :: x(n), p(n), along(n), forward(n), backward(n), wanted(n), got(n + 1), back(n + 1)
    real(wp) :: residual, load_error
    real(wp), parameter :: h0 = 0.4_wp, along_h0 = 0.7_wp, step = 1e-6_wp
    integer :: i, stat

    x = [(-1 + 0.05_wp*(i - 1), i=1, n)]
    p = 0.3_wp*(1.2_wp + sin(5*x))
    along = cos(7*x)
    along([1, n]) = 0
    ! entrainment of both signs, a transient term, a compressible Roelands oil: every term takes part
    call new_line_contact(contact, x**2/2, [(.true., i=1, n)], sin(3*x), 0.05_wp, modulus, &
      oil_law(law_roelands, 0.01_wp, 0.6_wp, 0.3_wp, 0.5_wp, 1.5_wp), load, floor, stat)
    if (stat == status_ok) call set_transient_term(contact, 1.5_wp, on_nodes(0.2_wp*x), stat)
    call check(stat == status_ok, "a contact is made")
    call film_residual(contact, on_nodes(p + step*along), h0 + step*along_h0, residual, load_error)
    forward = contact%imbalance(:, 1)
    call film_residual(contact, on_nodes(p - step*along), h0 - step*along_h0, residual, load_error)
    backward = contact%imbalance(:, 1)
    call film_residual(contact, on_nodes(p), h0, residual, load_error)
    call set_system(contact, stat)
    call check(stat == status_ok, "its Jacobian is set up")
    call contact%multiply([along, along_h0], got)
    wanted = (forward - backward)/(2*step)
    call close_to(maxval(abs(got(:n) - wanted))/maxval(abs(wanted)), 0.0_wp, 1e-7_wp, &
      "the Jacobian is the derivative of the imbalance")
    call contact%precondition([along, along_h0], got)
    call contact%multiply(got, back)
    call close_to(back(n + 1), along_h0, 1e-9_wp, "the preconditioner meets the load exactly")
  end subroutine jacobian

  !> Forwards and backwards entrained at (M, L) = (20, 10).
  subroutine piezoviscous()
    integer, parameter :: n = 121
    type(line_contact) :: contact
    real(wp) :: x(n), p(n), q(n), thinnest, other
    integer :: i, steps

    x = [(-3 + 0.05_wp*(i - 1), i=1, n)]
    p = sqrt(max(0.0_wp, 1 - x**2)) + 1e-6_wp
    p([1, n]) = 0
    q = p
    call solve(contact, x, [(1.0_wp, i=1, n)], modulus, barus, p, 0.4_wp, steps)
    call check(steps < 15, "Newton converges in few steps")
    call check(all(p >= 0) .and. all(contact%imbalance > -1e-9_wp), "pressure and outflow are complementary")
    call close_to(sum(p)*0.05_wp, load, 1e-9_wp, "the load is carried")
    thinnest = minval(contact%model%fields%h)
    call close_to(thinnest*8*m/pi, 3.97_wp, 0.4_wp, "the film is what an independent solver finds, nearly")
    call solve(contact, x, [(-1.0_wp, i=1, n)], modulus, barus, q, 0.4_wp, steps)
    other = minval(contact%model%fields%h)
    call close_to(maxval(abs(q(n:1:-1) - p)), 0.0_wp, 1e-9_wp, "backwards as forwards")
    call close_to(other, thinnest, 1e-9_wp*thinnest, "with the same film")
  end subroutine piezoviscous

  !> Rigid cylinder, isoviscous oil: w h0 / (eta0 u R) = 4.89497 (Martin 1916), by order.
  subroutine martin()
    real(wp) :: coarse, fine

    coarse = rigid_film(150)
    fine = rigid_film(300)
    call check(abs(fine) < 2e-3_wp, "Martin's film")
    call check(log(abs(coarse/fine))/log(2.0_wp) > 1.6_wp, "is approached by second order")
  end subroutine martin

  !> Relative error of Martin's load number on n cells; Reynolds' far pressure stands on the inlet.
  real(wp) function rigid_film(n)
    integer, intent(in) :: n
    type(line_contact) :: contact
    type(oil_law) :: oil
    real(wp) :: x(n + 1), p(n + 1), d, beyond
    real(wp), parameter :: exact = 4.89497_wp, h0 = 0.5_wp, reach = 9
    integer :: i, steps

    d = (reach + 1)/n
    x = [(-reach + d*(i - 1), i=1, n + 1)]
    ! at unit speed and radius
    oil = oil_law(law_barus, load*h0/exact, 0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp)
    p = 0.3_wp
    call far_pressure(oil%eta0, h0, reach, p(1), beyond)
    p(n + 1) = 0
    call solve(contact, x, [(1.0_wp, i=1, n + 1)], 1e9_wp, oil, p, h0, steps, beyond - p(1)*d/2)
    call check(steps < 15, "Newton converges on a rigid film")
    rigid_film = minval(contact%model%fields%h)/h0 - 1
  end function rigid_film

  !> Pressure at a distance before a rigid film, and the load carried beyond: midpoints over 1/x.
  pure subroutine far_pressure(eta, h0, reach, pressure, beyond)
    real(wp), intent(in) :: eta, h0, reach
    real(wp), intent(out) :: pressure, beyond
    integer, parameter :: points = 4000
    real(wp), parameter :: flow = 1.22575_wp
    real(wp) :: x, h, part
    integer :: i

    pressure = 0
    beyond = 0
    do i = 1, points
      x = reach*points/(i - 0.5_wp)
      h = h0 + x**2/2
      part = 12*eta*(h - flow*h0)/h**3*x**2/(reach*points)
      pressure = pressure + part
      beyond = beyond + part*(x - reach)
    end do
  end subroutine far_pressure

  !> Newton to a residual of 1e-10. `beyond` is load that is carried elsewhere.
  subroutine solve(contact, x, u, stiffness, oil, p, h0, steps, beyond)
    type(line_contact), intent(out) :: contact
    real(wp), intent(in) :: x(:), u(:), stiffness, h0
    type(oil_law), intent(in) :: oil
    real(wp), contiguous, target, intent(inout) :: p(:)
    integer, intent(out) :: steps
    real(wp), intent(in), optional :: beyond
    real(wp) :: carried, film, residual, load_error
    type(newton_step) :: step
    real(wp), contiguous, pointer :: pressure(:, :)
    logical :: covered(size(x))
    integer :: stat

    carried = load
    if (present(beyond)) carried = load - beyond
    covered = .true.
    call new_line_contact(contact, x**2/2, covered, u, x(2) - x(1), stiffness, oil, carried, floor, stat)
    call check(stat == status_ok, "a contact is made")
    film = h0
    if (stiffness < 100) film = h0 - 1
    pressure(1:size(p), 1:1) => p
    call film_residual(contact, pressure, film, residual, load_error)
    do steps = 1, 30
      call film_step(contact, 1e-4_wp, pressure, film, residual, load_error, step, stat)
      if (stat /= status_ok) exit
      if (residual + abs(load_error) < 1e-10_wp) exit
    end do
    call check(residual + abs(load_error) < 1e-10_wp, "Newton converges")
  end subroutine solve

  subroutine refusals()
    integer, parameter :: n = 9
    type(line_contact) :: contact
    real(wp) :: field(n), broken(n), infinite
    logical :: covered(n)
    type(oil_law) :: oil
    integer :: stat

    field = 1
    covered = .true.
    infinite = ieee_value(1.0_wp, ieee_positive_inf)
    call new_line_contact(contact, field, covered, field, 1.0_wp, modulus, barus, 0.0_wp, floor, stat)
    call check(stat == status_bad_argument, "no load is refused")
    call new_line_contact(contact, field, covered, field, 1.0_wp, modulus, barus, infinite, floor, stat)
    call check(stat == status_not_finite, "an infinite load is refused")
    call new_line_contact(contact, field, covered, field, 0.0_wp, modulus, barus, load, floor, stat)
    call check(stat == status_bad_argument, "no spacing is refused")
    oil = barus
    oil%eta0 = 0
    call new_line_contact(contact, field, covered, field, 1.0_wp, modulus, oil, load, floor, stat)
    call check(stat == status_bad_argument, "an oil without viscosity is refused")
    broken = field
    broken(3) = infinite
    call new_line_contact(contact, broken, covered, field, 1.0_wp, modulus, barus, load, floor, stat)
    call check(stat == status_not_finite, "a gap that is not finite is refused")
    call new_line_contact(contact, field, covered, broken, 1.0_wp, modulus, barus, load, floor, stat)
    call check(stat == status_not_finite, "a velocity that is not finite is refused")
    call new_line_contact(contact, field, covered, field, 1.0_wp, modulus, barus, load, floor, stat)
    call set_transient_term(contact, 1.0_wp, on_nodes(broken), stat)
    call check(stat == status_not_finite, "a transient term that is not finite is refused")
    call set_transient_term(contact, 1.0_wp, on_nodes(field(:2)), stat)
    call check(stat == status_bad_argument, "a transient term of another grid is refused")
  end subroutine refusals

end program test_line_film
