!> Linear heat flow along the paths of a fast surface against closed forms and quadrature along the paths.
program test_surface_path
  use pyworm_kinds, only: wp
  use pyworm_moving_source, only: moving_body, new_moving_body
  use pyworm_status, only: status_ok, status_bad_argument
  use pyworm_surface_path, only: fast_body, new_fast_body
  use tap, only: check, close_to, done
  implicit none(type, external)

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Conductivity [W/(m K)] and rho c [J/(m3 K)] of steel, flux [W/m2] and what makes a rise of int q
  !> dt/sqrt(t).
  real(wp), parameter :: k = 47, rho_c = 7900*477.0_wp, flux = 1e8_wp, effusion = 1/sqrt(pi*k*rho_c)
  !> Half the window [m], the semi-axes of the source [m] and where the surface turns about.
  real(wp), parameter :: half = 1e-3_wp, axis_x = 0.6e-3_wp, axis_y = 0.4e-3_wp, pole = 1.5e-3_wp
  !> Speed [m/s] at which heat does not spread to the sides.
  real(wp), parameter :: fast = 1e6_wp
  integer :: stat

  call uniform_flux(0.0_wp, 2.0_wp)
  call uniform_flux(0.0_wp, -2.0_wp)
  call uniform_flux(1e3_wp, 0.5_wp)
  call band()
  call converges("smooth source, uniform motion", 0, .true., 1e-4_wp, 2.5_wp)
  call converges("smooth source, rotation", 1, .true., 1e-4_wp, 2.5_wp)
  call converges("elliptic source, rotation", 1, .false., 1e-3_wp, 2.2_wp)
  call far_between()
  call stripes()
  call against_conduction_all_round(0.0_wp)
  call against_conduction_all_round(0.3_wp)
  call directions()
  call transposed(2.0_wp, 0.3_wp)
  call transposed(-0.2_wp, -1.5_wp)
  call refusals()
  call done()

contains

  !> Uniform flux from the inflow on: 2 q sqrt(t/(pi k rho c)), the time being that of a motion whose speed
  !> falls as 1/(1 + slowing x).
  subroutine uniform_flux(slowing, speed)
    real(wp), intent(in) :: slowing, speed
    integer, parameter :: n = 101, m = 6
    real(wp), parameter :: dx = 1e-5_wp
    type(fast_body) :: body
    real(wp) :: u(n, m), v(n, m), q(n, m), t(n, m), x(n), exact(n)
    integer :: i

    x = [((i - 1)*dx, i=1, n)]
    if (speed < 0) x = x(n:1:-1)
    u = spread(speed/(1 + slowing*x), 2, m)
    v = 0
    q = flux
    call new_fast_body(body, dx, dx, u, v, k, rho_c, stat)
    call check(stat == status_ok, "a fast body is made")
    call body%rise(q, t)
    exact = 2*flux*effusion*sqrt((x + slowing*x**2/2)/abs(speed))
    call close_to(maxval(abs(t(:, 3) - exact)), 0.0_wp, 1e-4_wp*maxval(exact), "uniform flux")
    call close_to(maxval(abs(t - spread(t(:, 3), 2, m))), 0.0_wp, 1e-6_wp*maxval(exact), "all across the motion")
  end subroutine uniform_flux

  !> Band that begins within a step: closed form of a ramp.
  subroutine band()
    integer, parameter :: n = 81, m = 4, before = 20
    real(wp), parameter :: dx = 1e-5_wp, speed = 3
    type(fast_body) :: body
    real(wp) :: u(m, n), v(m, n), q(m, n), t(m, n), x, exact, worst
    integer :: j

    u = 0
    v = speed
    q = 0
    q(:, before + 1:) = flux
    call new_fast_body(body, dx, dx, u, v, k, rho_c, stat)
    call body%rise(q, t)
    call check(maxval(abs(t(:, :before))) <= 0, "nothing is warm before the band")
    worst = 0
    do j = before + 1, n
      x = (j - before)*dx
      exact = 4*flux*effusion/(3*dx*sqrt(speed))*(sqrt(x)**3 - sqrt(x - dx)**3)
      worst = max(worst, abs(t(2, j)/exact - 1))
    end do
    call close_to(worst, 0.0_wp, 2e-4_wp, "a band")
  end subroutine band

  !> Error of the rise on finer and finer grids, which falls by `order` from one to the next.
  subroutine converges(what, turning, smooth, within, order)
    character(len=*), intent(in) :: what
    integer, intent(in) :: turning
    logical, intent(in) :: smooth
    real(wp), intent(in) :: within, order
    real(wp) :: error(3)
    integer :: level

    error = [(source_error(1 + 32*2**level, 1 + 32*2**level, turning, smooth), level=1, 3)]
    write (*, "(a, 3es9.1)") "# "//what, error
    call check(error(3) < within, what)
    call check(error(1)/error(2) > order .and. error(2)/error(3) > order, what//" converges")
  end subroutine converges

  !> Lines so far apart that paths cross up to sixteen nodes from one to the next.
  subroutine far_between()
    real(wp) :: error(2)

    error = [source_error(33, 257, 1, .true.), source_error(65, 513, 1, .true.)]
    write (*, "(a, 2es9.1)") "# lines far apart", error
    call check(error(2) < 1e-3_wp .and. error(1)/error(2) > 3, "lines far apart")
  end subroutine far_between

  !> Root mean square error of the rise, over the largest rise, under a source in the middle of the window;
  !> the surface moves uniformly at 40 degrees to the x axis (turning = 0), or turns about a pole beside the
  !> window (turning = 1).
  real(wp) function source_error(nx, ny, turning, smooth)
    integer, intent(in) :: nx, ny, turning
    logical, intent(in) :: smooth
    type(fast_body) :: body
    real(wp), allocatable :: u(:, :), v(:, :), q(:, :), t(:, :)
    real(wp) :: x, y, greatest
    integer :: i, j

    allocate (u(nx, ny), v(nx, ny), q(nx, ny), t(nx, ny))
    do j = 1, ny
      do i = 1, nx
        x = half*(2*(i - 1.0_wp)/(nx - 1) - 1)
        y = half*(2*(j - 1.0_wp)/(ny - 1) - 1)
        u(i, j) = fast*merge(cos(0.7_wp), (y + pole)/pole, turning == 0)
        v(i, j) = fast*merge(sin(0.7_wp), -x/pole, turning == 0)
        q(i, j) = source(x, y, smooth)
      end do
    end do
    call new_fast_body(body, 2*half/(nx - 1), 2*half/(ny - 1), u, v, k, rho_c, stat)
    call body%rise(q, t)
    greatest = maxval(t)
    source_error = 0
    do j = 1, ny, (ny - 1)/16
      do i = 1, nx, (nx - 1)/16
        x = half*(2*(i - 1.0_wp)/(nx - 1) - 1)
        y = half*(2*(j - 1.0_wp)/(ny - 1) - 1)
        source_error = source_error + ((t(i, j) - along_path(x, y, turning, smooth))/greatest)**2
      end do
    end do
    source_error = sqrt(source_error)/17
  end function source_error

  !> Flux with a smooth edge or, as Hertz's pressure, with a steep one.
  pure real(wp) function source(x, y, smooth)
    real(wp), intent(in) :: x, y
    logical, intent(in) :: smooth

    source = max(0.0_wp, 1 - (x/axis_x)**2 - (y/axis_y)**2)
    source = flux*merge(source**2, sqrt(source), smooth)
  end function source

  !> Rise at a point: quadrature along the path that led there, the way being s**2.
  real(wp) function along_path(x, y, turning, smooth)
    real(wp), intent(in) :: x, y
    integer, intent(in) :: turning
    logical, intent(in) :: smooth
    integer, parameter :: steps = 4000
    real(wp) :: s, longest, way, angle
    integer :: i

    longest = sqrt(5*half)
    along_path = 0
    do i = 1, steps
      s = longest*(i - 0.5_wp)/steps
      way = s**2
      angle = way/pole
      if (turning == 0) then
        along_path = along_path + source(x - way*cos(0.7_wp), y - way*sin(0.7_wp), smooth)
      else if (angle < pi) then
        along_path = along_path + source(x*cos(angle) - (y + pole)*sin(angle), &
          x*sin(angle) + (y + pole)*cos(angle) - pole, smooth)
      end if
    end do
    along_path = effusion*along_path*2*longest/steps/sqrt(fast)
  end function along_path

  !> Flux q cos(m y), whose heat spreads to the sides: q cos(m y)/sqrt(k rho c) erf(sqrt(kappa m2
  !> t))/sqrt(kappa m2).
  subroutine stripes()
    integer, parameter :: nx = 401, ny = 65
    real(wp), parameter :: dx = 5e-6_wp, dy = 1e-5_wp, speed = 0.5_wp, m = 2*pi/((ny - 1)*dy)
    type(fast_body) :: body
    real(wp) :: u(nx, ny), v(nx, ny), q(nx, ny), t(nx, ny), exact(nx, ny)
    integer :: i, j

    u = speed
    v = 0
    do j = 1, ny
      do i = 1, nx
        q(i, j) = flux*cos(m*(j - 1)*dy)
        exact(i, j) = q(i, j)/sqrt(k*rho_c)*erf(sqrt(k/rho_c*m**2*(i - 1)*dx/speed))/sqrt(k/rho_c*m**2)
      end do
    end do
    call new_fast_body(body, dx, dy, u, v, k, rho_c, stat)
    call body%rise(q, t)
    write (*, "(a, f6.3, a, es9.1)") "# stripes keep ", t(nx, 1)/(2*flux*effusion*sqrt((nx - 1)*dx/speed)), &
      " of their heat, error ", maxval(abs(t - exact))/maxval(exact)
    call close_to(maxval(abs(t - exact)), 0.0_wp, 4e-3_wp*maxval(exact), "stripes fade")
  end subroutine stripes

  !> A slender source crossed the long way, at some angle: conduction to all sides, which counts 9 % for the
  !> hottest point, against conduction into depth and to the sides.
  subroutine against_conduction_all_round(angle)
    real(wp), intent(in) :: angle
    integer, parameter :: n = 129
    real(wp), parameter :: long = 1e-3_wp, short = 1e-4_wp, peclet = 1000
    type(fast_body) :: body
    type(moving_body) :: reference
    real(wp) :: u(n, n), v(n, n), q(n, n), t(n, n), exact(n, n)
    integer :: i, j

    u = peclet*k/rho_c/long*cos(angle)
    v = peclet*k/rho_c/long*sin(angle)
    do j = 1, n
      do i = 1, n
        q(i, j) = max(0.0_wp, 1 - ((i - 65)/40.0_wp)**2 - ((j - 65)/30.0_wp)**2)
      end do
    end do
    call new_fast_body(body, long/40, short/30, u, v, k, rho_c, stat)
    call new_moving_body(reference, n, n, long/40, short/30, u(1, 1), v(1, 1), k, rho_c, stat)
    call body%rise(q, t)
    call reference%rise(q, exact)
    call close_to(maxval(t), maxval(exact), 2e-3_wp*maxval(exact), "the hottest point of a slender source")
    call close_to(sum(t*q), sum(exact*q), 4e-3_wp*sum(exact*q), "its mean temperature")
  end subroutine against_conduction_all_round

  !> The same motion seen from all sides of the grid.
  subroutine directions()
    integer, parameter :: n = 41
    type(fast_body) :: body
    real(wp), dimension(n, n) :: u, v, q, t, tx, ty, flipped, turned
    integer :: i, j

    do j = 1, n
      do i = 1, n
        u(i, j) = 2 + 0.01_wp*j
        v(i, j) = 0.2_wp - 0.01_wp*i
        q(i, j) = flux*max(0.0_wp, 1 - ((i - 18)/14.0_wp)**2 - ((j - 22)/9.0_wp)**2)
      end do
    end do
    call new_fast_body(body, 1e-5_wp, 1e-5_wp, u, v, k, rho_c, stat)
    call body%rise(q, t)
    call against(-u(n:1:-1, :), v(n:1:-1, :), q(n:1:-1, :), flipped)
    tx = flipped(n:1:-1, :)
    call against(transpose(v), transpose(u), transpose(q), turned)
    ty = transpose(turned)
    call close_to(maxval(abs(tx - t)), 0.0_wp, 1e-6_wp*maxval(t), "against the x axis")
    call close_to(maxval(abs(ty - t)), 0.0_wp, 1e-6_wp*maxval(t), "along the y axis")
    turned = -transpose(u(n:1:-1, :))
    call against(transpose(v(n:1:-1, :)), turned, transpose(q(n:1:-1, :)), flipped)
    turned = transpose(flipped)
    call close_to(maxval(abs(turned(n:1:-1, :) - t)), 0.0_wp, 1e-6_wp*maxval(t), "against the y axis")
  end subroutine directions

  subroutine against(u, v, q, t)
    real(wp), contiguous, intent(in) :: u(:, :), v(:, :), q(:, :)
    real(wp), contiguous, intent(out) :: t(:, :)
    type(fast_body) :: body

    call new_fast_body(body, 1e-5_wp, 1e-5_wp, u, v, k, rho_c, stat)
    call body%rise(q, t)
  end subroutine against

  !> Rises weighted by a field add up to fluxes weighted by its transposed product.
  subroutine transposed(ahead, aside)
    real(wp), intent(in) :: ahead, aside
    integer, parameter :: nx = 37, ny = 23
    type(fast_body) :: body
    real(wp), dimension(nx, ny) :: u, v, q, t, weight, by_flux
    integer :: i, j

    do j = 1, ny
      do i = 1, nx
        u(i, j) = ahead + 0.01_wp*j
        v(i, j) = aside - 0.005_wp*i
        q(i, j) = flux*modulo(7*i*i + 13*j + i*j, 17)
        weight(i, j) = modulo(5*i*i + 3*j + i*j, 11) + 1
      end do
    end do
    call new_fast_body(body, 1e-5_wp, 2e-5_wp, u, v, k, rho_c, stat)
    call body%rise(q, t)
    call body%rise_transposed(weight, by_flux)
    call close_to(sum(by_flux*q)/sum(weight*t), 1.0_wp, 1e-6_wp, "the transposed rise")
    q = 0
    q(20, 11) = flux
    call body%rise(q, t)
    call close_to(sum(by_flux*q)/sum(weight*t), 1.0_wp, 1e-5_wp, "the transposed rise of one node")
  end subroutine transposed

  subroutine refusals()
    type(fast_body) :: body
    real(wp) :: u(5, 5), v(5, 5)
    integer :: i

    u = spread([(i - 3.0_wp, i=1, 5)], 1, 5)
    v = -transpose(u)
    call new_fast_body(body, 1e-5_wp, 1e-5_wp, u, v, k, rho_c, stat)
    call check(stat == status_bad_argument, "a surface that turns about a point of the window is refused")
    u = 1
    call new_fast_body(body, 1e-5_wp, 1e-5_wp, u(:3, :), v(:3, :), k, rho_c, stat)
    call check(stat == status_bad_argument, "three nodes are refused")
    call new_fast_body(body, 1e-5_wp, 1e-5_wp, u, v, k, 0.0_wp, stat)
    call check(stat == status_bad_argument, "a body that stores no heat is refused")
  end subroutine refusals

end program test_surface_path
