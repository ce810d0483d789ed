!> The film of a circular contact in Hertz units: half-width, Hertz pressure and the undeformed gap's unit
!> a^2/R are 1, so that F = 2 pi / 3, E' = pi and the wedge is set by eta0 alone.
program test_point_film
  use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_positive_inf
  use pyworm_kinds, only: wp
  use pyworm_viscosity_density, only: oil_law, law_barus
  use pyworm_film_newton, only: contact_conditions, newton_step, set_transient_term, film_balance_again, film_residual, film_step
  use pyworm_point_film, only: point_contact, new_point_contact, limit_rate
  use pyworm_status, only: status_ok, status_bad_argument, status_not_finite
  use tap, only: check, close_to, done
  implicit none(type, external)

  real(wp), parameter :: pi = acos(-1.0_wp), load = 2*pi/3, modulus = pi
  !> (M, L) = (20, 10): alpha p_H = (L/pi)(1.5 M)^(1/3), 12 eta0 u = (128 pi^3 / 3 M^4)^(1/3).
  real(wp), parameter :: m = 20, l = 10
  real(wp), parameter :: alpha = l/pi*(1.5_wp*m)**(1.0_wp/3)
  real(wp), parameter :: eta0 = (128*pi**3/(3*m**4))**(1.0_wp/3)/12
  integer, parameter :: n = 65
  real(wp) :: p(n, n), q(n, n), film, other
  integer :: krylov

  call solve(1.0_wp, 0.0_wp, p, film, krylov)
  call close_to(maxval(abs(p(:, n:1:-1) - p)), 0.0_wp, 1e-5_wp, "the film is symmetric about its centre line")
  call check(krylov < 80, "few Krylov iterations")
  call solve(0.0_wp, 1.0_wp, q, other, krylov)
  call close_to(maxval(abs(transpose(q) - p)), 0.0_wp, 1e-5_wp, "along y as along x")
  call close_to(other, film, 1e-5_wp, "with the same minimum film")
  call solve(-1.0_wp, 0.0_wp, q, other, krylov)
  call close_to(maxval(abs(q(n:1:-1, :) - p)), 0.0_wp, 1e-5_wp, "backwards as forwards")
  call refusals()
  call done()

contains

  !> Newton from Hertz's pressure to a residual of 1e-8.
  subroutine solve(u, v, p, thinnest, krylov)
    real(wp), intent(in) :: u, v
    real(wp), intent(out) :: p(n, n), thinnest
    integer, intent(out) :: krylov
    type(point_contact) :: contact
    real(wp) :: gap(n, n), h0, residual, load_error
    type(newton_step) :: step
    integer :: i, j, steps, stat
    logical :: covered(n, n)

    do j = 1, n
      do i = 1, n
        gap(i, j) = (place(i)**2 + place(j)**2)/2
      end do
    end do
    covered = .true.
    call new_point_contact(contact, contact_conditions(gap, covered, spread(place(2) - place(1), 1, 2), modulus, &
      oil_law(law_barus, eta0, alpha, 1.0_wp, 0.0_wp, 0.0_wp), load, 1e-4_wp), 0*gap + u, 0*gap + v, stat)
    call check(stat == status_ok, "a contact is made")
    p = sqrt(max(0.0_wp, 1 - 2*gap))
    h0 = -0.5_wp
    krylov = 0
    call film_residual(contact, p, h0, residual, load_error)
    do steps = 1, 25
      if (residual + abs(load_error) < 1e-8_wp) exit
      call film_step(contact, 0.03_wp, p, h0, residual, load_error, step, stat)
      if (stat /= status_ok) exit
      krylov = krylov + step%krylov
    end do
    call check(residual + abs(load_error) < 1e-8_wp, "Newton converges")
    call close_to(sum(p)*(place(2) - place(1))**2, load, 1e-7_wp*load, "the load is carried")
    call check(all(p >= 0) .and. all(contact%imbalance > -1e-5_wp), "pressure and outflow are complementary")
    thinnest = minval(contact%model%fields%h)
    if (u > 0) call limit(contact, p, h0)
  end subroutine solve

  !> A rate of change that is limited changes the balance of a film as an evaluation with it does.
  subroutine limit(contact, p, h0)
    type(point_contact), intent(inout) :: contact
    real(wp), intent(in) :: p(n, n), h0
    real(wp) :: explicit_rate(n, n), residual, load_error, limited, imbalance(n, n)
    integer :: i, stat

    explicit_rate = spread([(0.1_wp*sin(real(i, wp)), i=1, n)], 2, n)
    call set_transient_term(contact, 0.3_wp, explicit_rate, stat)
    call film_residual(contact, p, h0, residual, load_error)
    imbalance = contact%imbalance
    explicit_rate = explicit_rate/2
    call limit_rate(contact, explicit_rate, stat)
    call check(stat == status_ok, "a rate of change is limited")
    call film_balance_again(contact, limited, load_error)
    call check(maxval(abs(contact%imbalance - imbalance)) > 0.04_wp, "which changes what leaves a cell")
    imbalance = contact%imbalance
    call film_residual(contact, p, h0, residual, load_error)
    call close_to(maxval(abs(contact%imbalance - imbalance)), 0.0_wp, 1e-14_wp, "as an evaluation of the film does")
    call close_to(limited, residual, 1e-12_wp, "and so its residual")
    call limit_rate(contact, explicit_rate(:8, :), stat)
    call check(stat == status_bad_argument, "a rate of another grid is refused")
  end subroutine limit

  !> Nodes on a square of side 7 about the contact.
  pure real(wp) function place(i)
    integer, intent(in) :: i

    place = -3.5_wp + 7.0_wp*(i - 1)/(n - 1)
  end function place

  subroutine refusals()
    type(point_contact) :: contact
    real(wp) :: field(9, 9), broken(9, 9)
    logical :: covered(9, 9)
    type(oil_law) :: oil
    integer :: stat

    field = 1
    covered = .true.
    oil = oil_law(law_barus, eta0, alpha, 1.0_wp, 0.0_wp, 0.0_wp)
    call new_point_contact(contact, contact_conditions(field, covered, [1, 1]*1.0_wp, modulus, oil, 0.0_wp, 1e-4_wp), &
      field, field, stat)
    call check(stat == status_bad_argument, "no load is refused")
    oil%eta0 = 0
    call new_point_contact(contact, contact_conditions(field, covered, [1, 1]*1.0_wp, modulus, oil, load, 1e-4_wp), &
      field, field, stat)
    call check(stat == status_bad_argument, "an oil without viscosity is refused")
    oil%eta0 = eta0
    broken = field
    broken(3, 3) = ieee_value(1.0_wp, ieee_positive_inf)
    call new_point_contact(contact, contact_conditions(broken, covered, [1, 1]*1.0_wp, modulus, oil, load, 1e-4_wp), &
      field, field, stat)
    call check(stat == status_not_finite, "a gap that is not finite is refused")
    call new_point_contact(contact, contact_conditions(field, covered, [1, 1]*1.0_wp, modulus, oil, load, 1e-4_wp), &
      field, field, stat)
    call set_transient_term(contact, 1.0_wp, broken, stat)
    call check(stat == status_not_finite, "a transient term that is not finite is refused")
    call set_transient_term(contact, 1.0_wp, field(:8, :), stat)
    call check(stat == status_bad_argument, "a transient term of another grid is refused")
  end subroutine refusals

end program test_point_film
