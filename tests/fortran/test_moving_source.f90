!> Surface temperature under moving sources against exact solutions.
program test_moving_source
  use pyworm_kinds, only: wp
  use pyworm_moving_source, only: moving_body, new_moving_body
  use pyworm_status, only: status_ok, status_bad_argument
  use tap, only: check, close_to, done
  implicit none(type, external)

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Conductivity [W/(m K)] and rho c [J/(m3 K)] of steel, flux [W/m2], cell [m].
  real(wp), parameter :: k = 47, rho_c = 7900*477.0_wp, flux = 2e8_wp, dx = 3e-5_wp, dy = 2e-5_wp
  integer :: stat

  call uniform_rectangle(0.0_wp, 1.0_wp, 0.0_wp)
  call uniform_rectangle(1e-6_wp, 1.0_wp, 0.0_wp)
  call uniform_rectangle(0.5_wp, 1.0_wp, 0.0_wp)
  call uniform_rectangle(0.5_wp, -0.6_wp, 0.8_wp)
  call uniform_rectangle(5.0_wp, 0.0_wp, -1.0_wp)
  call uniform_rectangle(50.0_wp, 0.8_wp, 0.6_wp)
  call uniform_rectangle(1000.0_wp, -1.0_wp, 0.0_wp)
  call uniform_rectangle(1e4_wp, 0.6_wp, -0.8_wp)
  call uniform_rectangle(1e5_wp, 0.0_wp, 1.0_wp)
  call band(5.0_wp)
  call band(50.0_wp)
  call fast_band()
  call elliptic_source_at_rest()
  call elliptic_source_in_motion()
  call symmetries()
  call refusals()
  call done()

contains

  !> Square cells under uniform flux, moving in the direction (cosine, sine) with Peclet number U a/(2 kappa),
  !> a the half length along x: exact in the plane and so on the grid.
  subroutine uniform_rectangle(peclet, cosine, sine)
    real(wp), intent(in) :: peclet, cosine, sine
    integer, parameter :: nx = 40, ny = 51, half_x = 12, half_y = 9, mid_x = 20, mid_y = 26
    type(moving_body) :: body
    real(wp) :: q(nx, ny), t(nx, ny), a, b, speed, worst
    integer :: i, j

    a = (half_x + 0.5_wp)*dx
    b = (half_y + 0.5_wp)*dy
    speed = peclet*2*k/(rho_c*a)
    q = 0
    q(mid_x - half_x:mid_x + half_x, mid_y - half_y:mid_y + half_y) = flux
    call new_moving_body(body, nx, ny, dx, dy, speed*cosine, speed*sine, k, rho_c, stat)
    call check(stat == status_ok, "a moving body is made")
    call body%rise(q, t)
    worst = 0
    do j = -half_y, half_y, 3
      do i = -half_x, half_x, 3
        worst = max(worst, abs(t(mid_x + i, mid_y + j) &
          - flux/(2*pi*k)*ray_integral(i*dx, j*dy, a, b, speed*rho_c/(2*k), atan2(sine, cosine))))
      end do
    end do
    write (*, "(a, es8.1, a, es8.1, a, f8.3)") "# Peclet ", peclet, ": error ", worst/maxval(t), " of ", maxval(t)
    call close_to(worst/maxval(t), 0.0_wp, 1e-6_wp, "uniform rectangle")
    call close_to(body%own, ray_integral(0.0_wp, 0.0_wp, dx/2, dy/2, speed*rho_c/(2*k), atan2(sine, cosine))/(2*pi*k), &
      1e-6_wp*body%own, "a cell heats itself")

  end subroutine uniform_rectangle

  !> Integral of exp(-p (r + s))/r, s the way of the source ahead of (x, y) in the direction of motion, over
  !> sources in a rectangle of half sides a, b (Rosenthal 1946): in closed form along rays from (x, y), by
  !> Gauss's rule between them.
  real(wp) function ray_integral(x, y, a, b, p, direction)
    real(wp), intent(in) :: x, y, a, b, p, direction
    integer, parameter :: panels = 300
    real(wp), parameter :: node(3) = [-sqrt(0.6_wp), 0.0_wp, sqrt(0.6_wp)]
    real(wp), parameter :: gauss(3) = [5.0_wp, 8.0_wp, 5.0_wp]/9
    real(wp) :: bend(6), low, high, angle, ray, decay
    integer :: sector, side, panel, g

    ! the ray's length bends at the corners; the integrand is peaked at sources straight behind, where panels
    ! shrink
    bend(1:4) = [atan2(b - y, a - x), atan2(b - y, -a - x), atan2(-b - y, -a - x), atan2(-b - y, a - x)]
    bend(1:4) = modulo(bend(1:4) - direction - pi, 2*pi)
    bend(5:6) = [0.0_wp, 2*pi]
    call sort(bend)
    ray_integral = 0
    do sector = 1, 5
      do side = 1, 2
        do panel = 1, panels
          low = graded((panel - 1)/real(panels, wp))
          high = graded(panel/real(panels, wp))
          do g = 1, 3
            angle = (bend(sector + 1) - bend(sector))/2*((low + high)/2 + node(g)*(high - low)/2)
            angle = merge(bend(sector) + angle, bend(sector + 1) - angle, side == 1)
            ray = min(((sign(a, cos(angle + direction + pi)) - x)/cos(angle + direction + pi)), &
              (sign(b, sin(angle + direction + pi)) - y)/sin(angle + direction + pi))
            ! r + s along a ray at this angle to what lies straight behind
            decay = p*2*sin(angle/2)**2
            ray_integral = ray_integral + gauss(g)*(high - low)/2*(bend(sector + 1) - bend(sector))/2*along(decay, ray)
          end do
        end do
      end do
    end do
  end function ray_integral

  !> Maps (0, 1) to itself with points gathering at 0.
  elemental real(wp) function graded(x)
    real(wp), intent(in) :: x

    graded = x**5
  end function graded

  !> Integral of exp(-decay r) from 0 to the ray's end.
  elemental real(wp) function along(decay, ray)
    real(wp), intent(in) :: decay, ray

    if (decay*ray < 1e-6_wp) then
      along = ray*(1 - decay*ray/2)
    else
      along = (1 - exp(-min(decay*ray, 700.0_wp)))/decay
    end if
  end function along

  pure subroutine sort(a)
    real(wp), intent(inout) :: a(:)
    integer :: i, least

    do i = 1, size(a) - 1
      least = i - 1 + minloc(a(i:), dim=1)
      a([i, least]) = a([least, i])
    end do
  end subroutine sort

  !> Jaeger's band, long across its motion: T = q/(pi k) int exp(p s) K0(p |s|) ds with p = U/(2 kappa), over
  !> the sources a way s behind; K0 as an integral over hyperbolic angles, so that s is integrated in closed
  !> form.
  subroutine band(peclet)
    real(wp), intent(in) :: peclet
    integer, parameter :: nx = 60, ny = 201, first = 15, last = 40
    type(moving_body) :: body
    real(wp) :: q(nx, ny), t(nx, ny), a, p, x, angle, exact, worst
    real(wp), parameter :: step = 0.002_wp
    integer :: i, m

    a = (last - first + 1)*dx/2
    p = peclet/a
    q = 0
    q(first:last, :) = flux
    call new_moving_body(body, nx, ny, dx, 4*dx, p*2*k/rho_c, 0.0_wp, k, rho_c, stat)
    call body%rise(q, t)
    worst = 0
    do i = first, last, 5
      x = (i - 0.5_wp*(first + last))*dx
      exact = 0
      do m = 0, 7000
        angle = (m + 0.5_wp)*step
        exact = exact + step*(along(p*2*sinh(angle/2)**2, a + x) + along(p*2*cosh(angle/2)**2, a - x))
      end do
      worst = max(worst, abs(t(i, ny/2 + 1)/(flux/(pi*k)*exact) - 1))
    end do
    call close_to(worst, 0.0_wp, 1e-5_wp, "Jaeger's band")
  end subroutine band

  !> A band so fast that heat flows straight into depth: T = 2 q sqrt(x/(pi k rho c U)).
  subroutine fast_band()
    integer, parameter :: n = 50
    type(moving_body) :: body
    real(wp) :: q(n, n), t(n, n)
    real(wp), parameter :: speed = 1e4_wp*2*k/(rho_c*dx)

    q = 0
    q(11:, :) = flux
    call new_moving_body(body, n, n, dx, dx, speed, 0.0_wp, k, rho_c, stat)
    call body%rise(q, t)
    call close_to(t(40, 25), 2*flux*sqrt(29.5_wp*dx/(pi*k*rho_c*speed)), 1e-5_wp*t(40, 25), "heat flows into depth")
    call check(maxval(abs(t(:8, :))) < 1e-6_wp*maxval(t), "nothing is warm before the source")
  end subroutine fast_band

  !> Flux q0 sqrt(1 - r2/a2) on a disk at rest: the rise is q0 pi a (2 - r2/a2)/(8 k), as Hertz's deflection.
  subroutine elliptic_source_at_rest()
    real(wp) :: error(3)
    integer :: level

    do level = 1, 3
      error(level) = disk_error(10*2**level)
    end do
    call check(error(3) < 2e-3_wp, "elliptic source at rest")
    call check(error(1)/error(3) > 6, "it converges with the grid")
  end subroutine elliptic_source_at_rest

  !> Largest error of the rise in the disk, over the rise in the middle, with n cells in its radius.
  real(wp) function disk_error(n)
    integer, intent(in) :: n
    type(moving_body) :: body
    real(wp) :: q(-n:n, -n:n), t(-n:n, -n:n)
    integer :: i, j

    do j = -n, n
      do i = -n, n
        q(i, j) = sqrt(max(0.0_wp, 1 - real(i**2 + j**2, wp)/n**2))
      end do
    end do
    call new_moving_body(body, 2*n + 1, 2*n + 1, 1.0_wp/n, 1.0_wp/n, 0.0_wp, 0.0_wp, 1.0_wp, 1.0_wp, stat)
    call body%rise(q, t)
    disk_error = 0
    do j = -n, n
      do i = -n, n
        if (i**2 + j**2 < n**2) disk_error = max(disk_error, abs(t(i, j)*4/pi - 1 + real(i**2 + j**2, wp)/(2*n**2)))
      end do
    end do
  end function disk_error

  !> The same disk in motion, its middle against the double integral of Rosenthal's point source.
  subroutine elliptic_source_in_motion()
    integer, parameter :: n = 40, rays = 2000, steps = 200
    real(wp), parameter :: p = 10, tilt = 0.4_wp
    type(moving_body) :: body
    real(wp) :: q(-n:n, -n:n), t(-n:n, -n:n), exact, angle, r, x
    integer :: i, j

    do j = -n, n
      do i = -n, n
        q(i, j) = sqrt(max(0.0_wp, 1 - real(i**2 + j**2, wp)/n**2))
      end do
    end do
    call new_moving_body(body, 2*n + 1, 2*n + 1, 1.0_wp/n, 1.0_wp/n, 2*p*cos(tilt), 2*p*sin(tilt), 1.0_wp, 1.0_wp, stat)
    call body%rise(q, t)
    exact = 0
    do j = 1, rays
      angle = 2*pi*(j - 0.5_wp)/rays
      do i = 1, steps
        ! r = sin x makes the root at the edge smooth
        x = pi/2*(i - 0.5_wp)/steps
        r = sin(x)
        exact = exact + exp(-p*r*(1 + cos(angle)))*cos(x)**2*pi/2/steps/rays
      end do
    end do
    call close_to(t(0, 0), exact, 1e-3_wp*maxval(t), "elliptic source in motion")
  end subroutine elliptic_source_in_motion

  !> Mirror images, a quarter turn, and the opposite motion.
  subroutine symmetries()
    integer, parameter :: n = 31
    type(moving_body) :: along_x, along_y, backward
    real(wp) :: q(n, n), t(n, n), turned(n, n), back(n, n), mirrored(n, n), speed
    integer :: i, j

    do j = 1, n
      do i = 1, n
        q(i, j) = max(0.0_wp, 1 - ((i - 12)/8.0_wp)**2 - ((j - 16)/5.0_wp)**2)
      end do
    end do
    speed = 3*2*k/(rho_c*8*dx)
    call new_moving_body(along_x, n, n, dx, dx, speed, 0.0_wp, k, rho_c, stat)
    call new_moving_body(along_y, n, n, dx, dx, 0.0_wp, speed, k, rho_c, stat)
    call new_moving_body(backward, n, n, dx, dx, -speed, 0.0_wp, k, rho_c, stat)
    call along_x%rise(q, t)
    mirrored = transpose(q)
    call along_y%rise(mirrored, turned)
    mirrored = q(n:1:-1, :)
    call backward%rise(mirrored, back)
    call close_to(maxval(abs(t - t(:, n:1:-1))), 0.0_wp, 1e-6_wp*maxval(t), "the two sides of the motion are alike")
    call close_to(maxval(abs(t - transpose(turned))), 0.0_wp, 1e-6_wp*maxval(t), "a quarter turn")
    call close_to(maxval(abs(t - back(n:1:-1, :))), 0.0_wp, 1e-6_wp*maxval(t), "the opposite motion")
    call check(t(28, 16) > 3*t(2, 16), "the wake lies downstream")
  end subroutine symmetries

  subroutine refusals()
    type(moving_body) :: body

    call new_moving_body(body, 1, 5, dx, dx, 0.0_wp, 0.0_wp, k, rho_c, stat)
    call check(stat == status_bad_argument, "a single row is refused")
    call new_moving_body(body, 5, 5, dx, -dx, 0.0_wp, 0.0_wp, k, rho_c, stat)
    call check(stat == status_bad_argument, "a negative spacing is refused")
    call new_moving_body(body, 5, 5, dx, dx, 0.0_wp, 0.0_wp, 0.0_wp, rho_c, stat)
    call check(stat == status_bad_argument, "a body that does not conduct is refused")
  end subroutine refusals

end program test_moving_source
