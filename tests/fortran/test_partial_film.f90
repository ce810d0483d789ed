!> A gap that is filled in part: a circular contact in Hertz units whose supply of oil is limited.
program test_partial_film
  use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_positive_inf
  use pyworm_kinds, only: wp
  use pyworm_viscosity_density, only: oil_law, law_barus
  use pyworm_film_newton, only: contact_conditions, newton_step, film_residual, film_step, set_system
  use pyworm_point_film, only: point_contact, new_point_contact
  use pyworm_reynolds, only: flow_imbalance
  use pyworm_status, only: status_ok, status_bad_argument, status_not_finite
  use tap, only: check, close_to, done
  implicit none(type, external)

  real(wp), parameter :: pi = acos(-1.0_wp), load = 2*pi/3, modulus = pi
  !> (M, L) = (20, 10), as in `test_point_film`.
  real(wp), parameter :: m = 20, l = 10
  real(wp), parameter :: alpha = l/pi*(1.5_wp*m)**(1.0_wp/3)
  real(wp), parameter :: eta0 = (128*pi**3/(3*m**4))**(1.0_wp/3)/12
  integer, parameter :: n = 49
  real(wp), parameter :: spacing = 5.0_wp/(n - 1), layer = 0.15_wp
  type(point_contact) :: contact
  real(wp) :: p(n, n), h0

  call make(0.8_wp, 0.6_wp, contact)
  call refusals()
  call solve(contact, 1e-12_wp, p, h0)
  call oil_is_kept()
  call jacobian()
  call plenty()
  call done()

contains

  subroutine make(u, v, contact)
    real(wp), intent(in) :: u, v
    type(point_contact), intent(out) :: contact
    real(wp) :: gap(n, n)
    integer :: i, j, stat

    do j = 1, n
      do i = 1, n
        gap(i, j) = (place(i)**2 + place(j)**2)/2
      end do
    end do
    call new_point_contact(contact, contact_conditions(gap, spread(spread(.true., 1, n), 2, n), [spacing, spacing], modulus, &
      oil_law(law_barus, eta0, alpha, 1.0_wp, 0.0_wp, 0.0_wp), load, 1e-4_wp), 0*gap + u, 0*gap + v, stat)
    call check(stat == status_ok, "a contact is made")
  end subroutine make

  pure real(wp) function place(i)
    integer, intent(in) :: i

    place = -2.5_wp + spacing*(i - 1)
  end function place

  subroutine refusals()
    real(wp) :: supply(n, n)
    integer :: stat

    supply = layer
    supply(3, 4) = -1
    call contact%feed(supply, stat)
    call check(stat == status_bad_argument, "a negative layer is refused")
    supply(3, 4) = ieee_value(1.0_wp, ieee_positive_inf)
    call contact%feed(supply, stat)
    call check(stat == status_not_finite, "an infinite layer is refused")
    supply = layer
    call contact%feed(supply, stat)
    call check(stat == status_ok, "a layer is taken")
  end subroutine refusals

  !> Newton from Hertz's pressure.
  subroutine solve(contact, tolerance, p, h0)
    type(point_contact), intent(inout) :: contact
    real(wp), intent(in) :: tolerance
    real(wp), intent(out) :: p(n, n), h0
    real(wp) :: residual, load_error
    type(newton_step) :: step
    integer :: steps, stat

    p = sqrt(max(0.0_wp, 1 - 2*contact%gap))
    h0 = -0.4_wp
    call film_residual(contact, p, h0, residual, load_error)
    do steps = 1, 60
      if (residual + abs(load_error) < tolerance) exit
      call film_step(contact, 1e-3_wp, p, h0, residual, load_error, step, stat)
      if (stat /= status_ok) exit
    end do
    call check(residual + abs(load_error) < tolerance, "Newton converges")
  end subroutine solve

  !> Oil that enters and leaves each node, by the flows through its faces.
  subroutine oil_is_kept()
    real(wp) :: net(n, n), along_x(n, n), along_y(n, n), entering, leaving
    integer :: i, j

    call flow_imbalance(contact%still, contact%model%fields, net)
    associate (partial => contact%model%partial)
      along_x = reshape(partial%share_x*partial%full_x, [n, n])
      along_y = reshape(partial%share_y*partial%full_y, [n, n])
      do j = 2, n - 1
        do i = 2, n - 1
          net(i, j) = net(i, j) + along_x(i, j) - along_x(i - 1, j) + along_y(i, j) - along_y(i, j - 1)
        end do
      end do
      call close_to(maxval(abs(net)), 0.0_wp, 1e-10_wp*layer/spacing, "every node keeps its oil")
      entering = sum(along_x(1, 2:n - 1)) + sum(along_y(2:n - 1, 1))
      leaving = sum(along_x(n - 1, 2:n - 1)) + sum(along_y(2:n - 1, n - 1))
      call close_to(entering, 1.4_wp*layer*(n - 2)/spacing, 1e-10_wp*entering, "the layer enters")
      call close_to(leaving, entering, 1e-10_wp*entering, "what enters leaves")
      call check(all(contact%model%fields%p <= 0 .or. reshape(partial%fraction, [n, n]) >= 1), &
        "pressure only where the gap is full")
      call check(count(partial%fraction < 1) > n*n/4, "a large part of the gap is not full")
    end associate
  end subroutine oil_is_kept

  !> The Jacobian against central differences, where the sets of full and other nodes stay.
  subroutine jacobian()
    real(wp), parameter :: small = 1e-5_wp
    real(wp) :: x(n*n + 1), y(n*n + 1), up(n, n), down(n, n), dp(n, n), residual, load_error, difference(n, n)
    integer :: i, j, stat

    call film_residual(contact, p, h0, residual, load_error)
    call set_system(contact, stat)
    do j = 1, n
      do i = 1, n
        dp(i, j) = merge(p(i, j)*sin(3*place(i) + 1)*cos(2*place(j)), 0.0_wp, contact%free(i, j))
      end do
    end do
    x = [reshape(dp, [n*n]), 0.01_wp]
    call contact%multiply(x, y)
    call film_residual(contact, p + small*dp, h0 + small*0.01_wp, residual, load_error)
    up = contact%imbalance
    call film_residual(contact, p - small*dp, h0 - small*0.01_wp, residual, load_error)
    down = contact%imbalance
    call film_residual(contact, p, h0, residual, load_error)
    difference = merge((up - down)/(2*small), 0.0_wp, contact%free)
    call close_to(maxval(abs(reshape(y(:n*n), [n, n]) - difference)), 0.0_wp, 1e-6_wp*maxval(abs(difference)), &
      "the Jacobian is that of differences")
  end subroutine jacobian

  !> A layer as thick as the gap floods it: the film is that without a limit.
  subroutine plenty()
    type(point_contact) :: fed, flooded
    real(wp) :: q(n, n), other(n, n), film, h
    integer :: stat

    call make(1.0_wp, 0.0_wp, flooded)
    call solve(flooded, 1e-9_wp, q, film)
    call make(1.0_wp, 0.0_wp, fed)
    call fed%feed(spread(spread(100.0_wp, 1, n), 2, n), stat)
    call solve(fed, 1e-9_wp, other, h)
    call close_to(maxval(abs(q - other)), 0.0_wp, 1e-7_wp, "plenty of oil floods the contact")
    call close_to(h, film, 1e-7_wp, "with the same film")
  end subroutine plenty

end program test_partial_film
