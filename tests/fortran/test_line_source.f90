!> Surface temperature under moving lines of heat against exact solutions.
program test_line_source
  use pyworm_bessel, only: scaled_bessel_k
  use pyworm_kinds, only: wp
  use pyworm_line_source, only: line_body, new_line_body
  use pyworm_moving_source, only: moving_body, new_moving_body
  use pyworm_status, only: status_ok, status_bad_argument
  use tap, only: check, close_to, done
  implicit none(type, external)

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Conductivity [W/(m K)] and rho c [J/(m3 K)] of steel, flux [W/m2], cell [m].
  real(wp), parameter :: k = 47, rho_c = 7900*477.0_wp, flux = 2e8_wp, dx = 3e-5_wp
  integer :: stat

  call bessel_functions()
  call band(0.5_wp)
  call band(5.0_wp)
  call band(50.0_wp)
  call band(1000.0_wp)
  call fast_band()
  call elliptic_flux()
  call long_rectangle()
  call mirrored()
  call refusals()
  call done()

contains

  !> Values of Abramowitz and Stegun (1964), tables 9.8 and 9.11, and of asymptotic series.
  subroutine bessel_functions()
    real(wp) :: k0, k1

    call scaled_bessel_k(0.1_wp, k0, k1)
    call close_to(k0*exp(-0.1_wp), 2.427069024702017_wp, 1e-14_wp, "K0(0.1)")
    call close_to(k1*exp(-0.1_wp), 9.853844780870606_wp, 1e-13_wp, "K1(0.1)")
    call scaled_bessel_k(1.0_wp, k0, k1)
    call close_to(k0*exp(-1.0_wp), 0.4210244382407083_wp, 1e-15_wp, "K0(1)")
    call close_to(k1*exp(-1.0_wp), 0.6019072301972346_wp, 1e-15_wp, "K1(1)")
    call scaled_bessel_k(1e-8_wp, k0, k1)
    call close_to(k0, -log(0.5e-8_wp) - 0.5772156649015329_wp, 1e-6_wp, "K0 near 0")
    call close_to(k1*1e-8_wp, 1.0_wp, 2e-8_wp, "K1 near 0")
    call scaled_bessel_k(1e4_wp, k0, k1)
    call close_to(k0/sqrt(pi/2e4_wp), 1 - 1/8e4_wp + 9/(2*8e4_wp**2), 1e-13_wp, "K0 far out")
    call close_to(k1/sqrt(pi/2e4_wp), 1 + 3/8e4_wp - 15/(2*8e4_wp**2), 2e-13_wp, "K1 far out")
  end subroutine bessel_functions

  !> Uniform band of Peclet number U a/(2 kappa): T = q/(pi k) int exp(p s) K0(p |s|) ds, p = U/(2 kappa), over the sources
  !> a way s behind; K0 as an integral over hyperbolic angles, so that s is integrated in closed form.
  subroutine band(peclet)
    real(wp), intent(in) :: peclet
    integer, parameter :: n = 60, first = 15, last = 40
    type(line_body) :: body
    real(wp) :: q(n, 1), t(n, 1), a, p, x, angle, exact, worst
    real(wp), parameter :: step = 0.002_wp
    integer :: i, m

    a = (last - first + 1)*dx/2
    p = peclet/a
    q = 0
    q(first:last, 1) = flux
    call new_line_body(body, n, dx, p*2*k/rho_c, k, rho_c, stat)
    call check(stat == status_ok, "a body is made")
    call body%rise(q, t)
    worst = 0
    do i = first, last, 5
      x = (i - 0.5_wp*(first + last))*dx
      exact = 0
      do m = 0, 7000
        angle = (m + 0.5_wp)*step
        exact = exact + step*(along(p*2*sinh(angle/2)**2, a + x) + along(p*2*cosh(angle/2)**2, a - x))
      end do
      worst = max(worst, abs(t(i, 1)/(flux/(pi*k)*exact) - 1))
    end do
    call close_to(worst, 0.0_wp, 1e-5_wp, "Jaeger's band")
  end subroutine band

  !> Integral of exp(-decay s) from 0 to the end.
  elemental real(wp) function along(decay, end)
    real(wp), intent(in) :: decay, end

    if (decay*end < 1e-6_wp) then
      along = end*(1 - decay*end/2)
    else
      along = (1 - exp(-min(decay*end, 700.0_wp)))/decay
    end if
  end function along

  !> A band so fast that heat flows straight into depth: T = 2 q sqrt(x/(pi k rho c U)).
  subroutine fast_band()
    integer, parameter :: n = 50
    type(line_body) :: body
    real(wp) :: q(n, 1), t(n, 1)
    real(wp), parameter :: speed = 1e4_wp*2*k/(rho_c*dx)

    q = 0
    q(11:, 1) = flux
    call new_line_body(body, n, dx, speed, k, rho_c, stat)
    call body%rise(q, t)
    call close_to(t(40, 1), 2*flux*sqrt(29.5_wp*dx/(pi*k*rho_c*speed)), 1e-5_wp*t(40, 1), "heat flows into depth")
    call check(maxval(abs(t(:8, 1))) < 1e-6_wp*maxval(t), "nothing is warm before the source")
  end subroutine fast_band

  !> Flux q0 sqrt(1 - (x/a)2) of a fast body at its middle: with x = -a cos(2 angle) the root of the kernel goes, and
  !> T = q0 sqrt(a/(pi k rho c U)) int sqrt(1 - s2)/sqrt(-s) ds from -1 to 0, which is B(1/4, 3/2)/2.
  subroutine elliptic_flux()
    integer, parameter :: n = 401
    type(line_body) :: body
    real(wp) :: q(n, 1), t(n, 1), a
    real(wp), parameter :: speed = 1e4_wp*2*k/(rho_c*dx)
    integer :: i

    a = 200*dx
    q(:, 1) = [(flux*sqrt(max(0.0_wp, 1 - ((i - 201)*dx/a)**2)), i=1, n)]
    call new_line_body(body, n, dx, speed, k, rho_c, stat)
    call body%rise(q, t)
    call close_to(t(201, 1), flux*sqrt(a/(pi*k*rho_c*speed))*gamma(0.25_wp)*gamma(1.5_wp)/gamma(1.75_wp)/2, &
      1e-3_wp*maxval(t), "elliptic flux")
  end subroutine elliptic_flux

  !> The middle of a long rectangle in three dimensions.
  subroutine long_rectangle()
    integer, parameter :: nx = 40, ny = 41
    type(line_body) :: body
    type(moving_body) :: rectangle
    real(wp) :: q(nx, 1), t(nx, 1), wide_q(nx, ny), wide_t(nx, ny)
    real(wp), parameter :: speed = 5*2*k/(rho_c*10*dx)
    integer :: i

    q(:, 1) = [(flux*max(0.0_wp, 1 - ((i - 18)/10.0_wp)**2), i=1, nx)]
    wide_q = spread(q(:, 1), 2, ny)
    call new_line_body(body, nx, dx, -speed, k, rho_c, stat)
    call body%rise(q, t)
    call new_moving_body(rectangle, nx, ny, dx, 10*dx, -speed, 0.0_wp, k, rho_c, stat)
    call rectangle%rise(wide_q, wide_t)
    call close_to(maxval(abs(wide_t(:, ny/2 + 1) - t(:, 1))), 0.0_wp, 1e-5_wp*maxval(t), "a long rectangle is a line")
  end subroutine long_rectangle

  !> The opposite motion is the mirror image, and heat is in the wake.
  subroutine mirrored()
    integer, parameter :: n = 31
    type(line_body) :: forward, backward
    real(wp) :: q(n, 1), t(n, 1), mirror(n, 1), back(n, 1)
    integer :: i

    q(:, 1) = [(max(0.0_wp, 1 - ((i - 12)/8.0_wp)**2), i=1, n)]
    call new_line_body(forward, n, dx, 0.1_wp, k, rho_c, stat)
    call new_line_body(backward, n, dx, -0.1_wp, k, rho_c, stat)
    call forward%rise(q, t)
    mirror = q(n:1:-1, :)
    call backward%rise(mirror, back)
    call close_to(maxval(abs(t - back(n:1:-1, :))), 0.0_wp, 1e-6_wp*maxval(t), "the opposite motion")
    call check(t(28, 1) > t(2, 1), "the wake lies downstream")
  end subroutine mirrored

  subroutine refusals()
    type(line_body) :: body

    call new_line_body(body, 5, dx, 0.0_wp, k, rho_c, stat)
    call check(stat == status_bad_argument, "a body at rest is refused")
    call new_line_body(body, 5, -dx, 1.0_wp, k, rho_c, stat)
    call check(stat == status_bad_argument, "a negative spacing is refused")
    call new_line_body(body, 5, dx, 1.0_wp, 0.0_wp, rho_c, stat)
    call check(stat == status_bad_argument, "a body that does not conduct is refused")
  end subroutine refusals

end program test_line_source
