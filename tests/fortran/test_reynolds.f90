!> Exact solutions of Reynolds' equation for h = h0 + x^2/2Rx + y^2/2Ry with constant viscosity and no
!> rupture, for entrainment along x, along y, spin and squeeze; and the Jacobian against differences.
module rigid_film
  use pyworm_kinds, only: wp
  use pyworm_krylov, only: linear_system
  use pyworm_multigrid, only: film_multigrid, film_cycle
  use pyworm_reynolds, only: film_grid, film_fields, flow_imbalance_change
  implicit none(type, external)
  private

  !> The film at fixed thickness: linear in pressure.
  type, extends(linear_system), public :: rigid
    type(film_grid) :: grid
    type(film_fields) :: fields
    type(film_multigrid) :: cycles
  contains
    procedure :: multiply
    procedure :: precondition
  end type rigid

contains

  subroutine multiply(self, x, y)
    class(rigid), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    real(wp), contiguous, pointer :: dp(:, :), dr(:, :)
    real(wp), allocatable :: dh(:, :)

    dp(1:self%grid%nx, 1:self%grid%ny) => x
    dr(1:self%grid%nx, 1:self%grid%ny) => y
    allocate (dh(self%grid%nx, self%grid%ny))
    dh = 0
    call flow_imbalance_change(self%grid, self%fields, dp, dh, dr)
  end subroutine multiply

  subroutine precondition(self, x, y)
    class(rigid), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    real(wp), contiguous, pointer :: r(:, :), dp(:, :)

    r(1:self%grid%nx, 1:self%grid%ny) => x
    dp(1:self%grid%nx, 1:self%grid%ny) => y
    call film_cycle(self%cycles, r, dp)
  end subroutine precondition

end module rigid_film
program test_reynolds
  use pyworm_kinds, only: pp, wp
  use pyworm_krylov, only: gmres
  use pyworm_film_model, only: film_model
  use pyworm_multigrid, only: new_film_multigrid, set_film_multigrid
  use pyworm_viscosity_density, only: oil_law, law_barus, law_roelands
  use pyworm_reynolds, only: film_grid, film_fields, new_film_fields, set_film_fields, flow_imbalance, &
    flow_imbalance_change
  use rigid_film, only: rigid
  use pyworm_status, only: status_ok
  use tap, only: check, close_to, done
  implicit none(type, external)

  !> Radii and viscosity in units that make the film of order one.
  real(wp), parameter :: radius_x = 1.0_wp, radius_y = 2.5_wp, eta = 0.3_wp, h0 = 0.5_wp
  real(wp), parameter :: floor = 1e-9_wp

  call exact("entrainment along x", 1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp)
  call exact("entrainment along y", 0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp)
  call exact("spin", 0.0_wp, 0.0_wp, 1.0_wp, 0.0_wp)
  call exact("squeeze", 0.0_wp, 0.0_wp, 0.0_wp, -1.0_wp)
  call exact("all of them, against the axes", -0.8_wp, -0.5_wp, 0.7_wp, -0.3_wp)
  call jacobian()
  call conservation()
  call done()

contains

  !> Pressure at (x, y) of the exact solutions, which superpose.
  pure real(wp) function pressure(x, y, u, v, spin, squeeze)
    real(wp), intent(in) :: x, y, u, v, spin, squeeze
    real(wp) :: ratio

    ratio = radius_x/radius_y
    pressure = -4*eta*u*x/(1 + 2*ratio/3) - 4*eta*v*y/(1 + 2/(3*ratio)) &
      - 4*eta*spin*x*y*(ratio - 1)/(ratio + 1) - 6*eta*squeeze/(1/radius_x + 1/radius_y)
    pressure = pressure/film(x, y)**2
  end function pressure

  pure real(wp) function film(x, y)
    real(wp), intent(in) :: x, y

    film = h0 + x**2/(2*radius_x) + y**2/(2*radius_y)
  end function film

  !> Largest error of the pressure on grids of n and 2n cells: second order.
  subroutine exact(what, u, v, spin, squeeze)
    character(len=*), intent(in) :: what
    real(wp), intent(in) :: u, v, spin, squeeze
    real(wp) :: coarse, fine

    coarse = solved_error(48, u, v, spin, squeeze)
    fine = solved_error(96, u, v, spin, squeeze)
    call check(log(coarse/fine)/log(2.0_wp) > 1.8_wp, what//": second order")
    call check(fine < 0.01_wp, what//": close to the exact solution")
  end subroutine exact

  !> Error over the largest exact pressure.
  real(wp) function solved_error(n, u, v, spin, squeeze)
    integer, intent(in) :: n
    real(wp), intent(in) :: u, v, spin, squeeze
    type(rigid) :: system
    real(wp), allocatable :: x(:), y(:), wanted(:, :), right(:), change(:), imbalance(:, :)
    real(pp), allocatable :: basis(:, :)
    logical, allocatable :: free(:, :)
    type(film_model) :: model
    real(wp) :: reduction, dx, dy
    integer :: i, j, iterations, stat, ny

    ny = 5*n/4
    dx = 4.0_wp/n
    dy = 6.0_wp/ny
    allocate (x(n + 1), y(ny + 1), wanted(n + 1, ny + 1), free(n + 1, ny + 1), imbalance(n + 1, ny + 1))
    x = [(-2 + (i - 1)*dx, i=1, n + 1)]
    y = [(-3 + (j - 1)*dy, j=1, ny + 1)]
    allocate (system%grid%u(n + 1, ny + 1), system%grid%v(n + 1, ny + 1), system%grid%explicit_rate(n + 1, ny + 1))
    system%grid%nx = n + 1
    system%grid%ny = ny + 1
    system%grid%dx = dx
    system%grid%dy = dy
    system%grid%explicit_rate = squeeze
    call new_film_fields(n + 1, ny + 1, system%fields, stat)
    do j = 1, ny + 1
      do i = 1, n + 1
        system%grid%u(i, j) = u - spin*y(j)
        system%grid%v(i, j) = v + spin*x(i)
        wanted(i, j) = pressure(x(i), y(j), u, v, spin, squeeze)
        system%fields%h(i, j) = film(x(i), y(j))
      end do
    end do
    system%fields%p = wanted
    system%fields%p(2:n, 2:ny) = 0
    free = .false.
    free(2:n, 2:ny) = .true.
    call set_film_fields(oil_law(law_barus, eta, 0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp), floor, system%fields)
    call flow_imbalance(system%grid, system%fields, imbalance)
    call new_film_multigrid(system%grid, 0.0_wp, system%cycles, stat)
    model%fields = system%fields
    call set_film_multigrid(system%cycles, model, free, stat)
    call check(stat == status_ok, "multigrid is set up")
    right = reshape(-imbalance, [size(imbalance)])
    allocate (change(size(right)), basis(size(right), 30))
    call gmres(system, right, 1e-6_wp, 30, basis, change, iterations, reduction)
    call check(reduction <= 1e-6_wp .and. iterations <= 8, "GMRES with multigrid converges fast")
    solved_error = maxval(abs(reshape(change, shape(wanted)) + system%fields%p - wanted))/maxval(abs(wanted))
  end function solved_error

  !> The exact Jacobian against central differences, piezoviscous and compressible, films below the floor
  !> included.
  subroutine jacobian()
    integer, parameter :: nx = 14, ny = 11
    type(film_grid) :: grid
    type(film_fields) :: fields
    type(oil_law) :: oil
    real(wp) :: p(nx, ny), h(nx, ny), dp(nx, ny), dh(nx, ny), change(nx, ny), above(nx, ny), below(nx, ny)
    real(wp), parameter :: step = 1e-5_wp
    integer :: i, j, stat

    grid = film_grid(nx, ny, 0.3_wp, 0.2_wp, spread([(1.0_wp - 0.2_wp*i, i=1, nx)], 2, ny), &
      spread([(0.7_wp - 0.15_wp*j, j=1, ny)], 1, nx), spread([(0.1_wp*i, i=1, nx)], 2, ny), 2.0_wp)
    oil = oil_law(law_roelands, 0.5_wp, 0.6_wp, 1.0_wp, 0.4_wp, 0.7_wp)
    do j = 1, ny
      do i = 1, nx
        p(i, j) = 1 + sin(1.0_wp*i)*cos(0.7_wp*j)/2
        h(i, j) = 1 + 0.3_wp*cos(0.5_wp*i + j)
        dp(i, j) = sin(2.1_wp*i + 0.3_wp*j)
        dh(i, j) = cos(0.9_wp*i - 1.7_wp*j)
      end do
    end do
    h(5, 5) = 0.02_wp
    call new_film_fields(nx, ny, fields, stat)
    call imbalance_at(grid, oil, p + step*dp, h + step*dh, fields, above)
    call imbalance_at(grid, oil, p - step*dp, h - step*dh, fields, below)
    call imbalance_at(grid, oil, p, h, fields, change)
    call flow_imbalance_change(grid, fields, dp, dh, change)
    call close_to(maxval(abs(change - (above - below)/(2*step))), 0.0_wp, 1e-7_wp*maxval(abs(change)), &
      "Jacobian against differences")
  end subroutine jacobian

  subroutine imbalance_at(grid, oil, p, h, fields, r)
    type(film_grid), intent(in) :: grid
    type(oil_law), intent(in) :: oil
    real(wp), intent(in) :: p(:, :), h(:, :)
    type(film_fields), intent(inout) :: fields
    real(wp), contiguous, intent(out) :: r(:, :)

    fields%p = p
    fields%h = h
    call set_film_fields(oil, 0.1_wp, fields)
    call flow_imbalance(grid, fields, r)
  end subroutine imbalance_at

  !> What leaves one cell enters its neighbour: a lone pressure peak changes nothing in sum.
  subroutine conservation()
    integer, parameter :: n = 21
    type(film_grid) :: grid
    type(film_fields) :: fields
    real(wp) :: r(n, n), nothing(n, n)
    integer :: stat

    nothing = 0
    grid = film_grid(n, n, 0.1_wp, 0.1_wp, nothing + 1, nothing - 2, nothing)
    call new_film_fields(n, n, fields, stat)
    fields%h = 1
    fields%h(9:12, 8:13) = 0.6_wp
    fields%p(10, 10) = 3
    call set_film_fields(oil_law(law_barus, 1.0_wp, 0.5_wp, 1.0_wp, 0.2_wp, 0.3_wp), floor, fields)
    call flow_imbalance(grid, fields, r)
    call check(maxval(abs(r)) > 1, "a peak drives flow")
    call close_to(sum(r), 0.0_wp, 1e-11_wp*maxval(abs(r)), "and mass is conserved")
  end subroutine conservation

end program test_reynolds
