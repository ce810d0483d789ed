program test_multigrid
  use pyworm_kinds, only: wp
  use pyworm_film_model, only: film_model
  use pyworm_multigrid, only: film_multigrid, new_film_multigrid, set_film_multigrid, film_cycle
  use pyworm_viscosity_density, only: oil_law, law_barus
  use pyworm_reynolds, only: film_grid, film_fields, new_film_fields, set_film_fields, flow_imbalance_change
  use pyworm_status, only: status_ok
  use tap, only: check, close_to, done
  implicit none(type, external)

  call reduces(65, 65, 1.0_wp, 1.0_wp, 0.15_wp)
  ! lines run along y at rest: they take strong coupling along y, and suffer from strong coupling across
  call reduces(97, 41, 3.0_wp, 1.0_wp, 0.15_wp)
  call reduces(97, 41, 1.0_wp, 3.0_wp, 0.7_wp)
  call reduces(40, 33, 2.0_wp, 1.0_wp, 0.15_wp)
  call leaves_ruptured_nodes()
  call mirrors()
  call done()

contains

  !> On pure diffusion the five-point model is exact, so cycles must shrink the error as multigrid does.
  subroutine reduces(nx, ny, dx, dy, factor)
    integer, intent(in) :: nx, ny
    real(wp), intent(in) :: dx, dy, factor
    type(film_grid) :: grid
    type(film_fields) :: fields
    type(film_multigrid) :: cycles
    type(film_model) :: model
    real(wp) :: wanted(nx, ny), x(nx, ny), r(nx, ny), f(nx, ny), first
    logical :: free(nx, ny)
    integer :: i, j, k, stat

    call still(nx, ny, dx, dy, grid, fields, free)
    call new_film_multigrid(grid, 0.0_wp, cycles, stat)
    model%fields = fields
    call set_film_multigrid(cycles, model, free, stat)
    call check(stat == status_ok, "levels are set up")
    wanted = 0
    do j = 2, ny - 1
      do i = 2, nx - 1
        wanted(i, j) = sin(12.9898_wp*i + 78.233_wp*j)
      end do
    end do
    call flow_imbalance_change(grid, fields, wanted, 0*wanted, f)
    x = 0
    first = maxval(abs(wanted))
    do k = 1, 6
      call flow_imbalance_change(grid, fields, wanted - x, 0*wanted, r)
      call film_cycle(cycles, r, f)
      x = x + f
    end do
    call check(maxval(abs(wanted - x)) < first*factor**6, "six cycles shrink the error as they should")
    write (*, "(a, f6.3)") "# mean factor ", (maxval(abs(wanted - x))/first)**(1.0_wp/6)
  end subroutine reduces

  subroutine leaves_ruptured_nodes()
    integer, parameter :: n = 33
    type(film_grid) :: grid
    type(film_fields) :: fields
    type(film_multigrid) :: cycles
    type(film_model) :: model
    real(wp) :: x(n, n), f(n, n)
    logical :: free(n, n)
    integer :: stat

    call still(n, n, 1.0_wp, 1.0_wp, grid, fields, free)
    free(20:, :) = .false.
    call new_film_multigrid(grid, 0.0_wp, cycles, stat)
    model%fields = fields
    call set_film_multigrid(cycles, model, free, stat)
    f = 1
    call film_cycle(cycles, f, x)
    call check(maxval(abs(x(20:, :))) <= 0, "pressure that is not free does not change")
    call check(minval(x(2:19, 2:n - 1)) > 0, "all other does")
  end subroutine leaves_ruptured_nodes

  !> A scene mirrored in the entrainment's direction gives a mirrored cycle up to the order of the lines.
  subroutine mirrors()
    integer, parameter :: n = 33
    type(film_grid) :: grid
    type(film_fields) :: fields
    type(film_multigrid) :: cycles
    type(film_model) :: model
    real(wp) :: x(n, n), f(n, n), mirrored(n, n)
    logical :: free(n, n)
    integer :: stat

    call still(n, n, 1.0_wp, 1.0_wp, grid, fields, free)
    f = 0
    f(8, 12) = 1
    f(30, 5) = -2
    grid%u = 1
    call new_film_multigrid(grid, 1.0_wp, cycles, stat)
    model%fields = fields
    call set_film_multigrid(cycles, model, free, stat)
    call film_cycle(cycles, f, x)
    grid%u = -1
    call new_film_multigrid(grid, 1.0_wp, cycles, stat)
    model%fields = fields
    call set_film_multigrid(cycles, model, free, stat)
    call film_cycle(cycles, f(n:1:-1, :), mirrored)
    call close_to(maxval(abs(mirrored(n:1:-1, :) - x)), 0.0_wp, 1e-5_wp*maxval(abs(x)), &
      "sweeps follow the entrainment")
  end subroutine mirrors

  !> A film of even thickness at rest.
  subroutine still(nx, ny, dx, dy, grid, fields, free)
    integer, intent(in) :: nx, ny
    real(wp), intent(in) :: dx, dy
    type(film_grid), intent(out) :: grid
    type(film_fields), intent(out) :: fields
    logical, intent(out) :: free(nx, ny)
    real(wp) :: nothing(nx, ny)
    integer :: stat

    nothing = 0
    grid = film_grid(nx, ny, dx, dy, nothing, nothing, nothing)
    call new_film_fields(nx, ny, fields, stat)
    fields%h = 1
    call set_film_fields(oil_law(law_barus, 1.0_wp, 0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp), 1e-9_wp, fields)
    free = .false.
    free(2:nx - 1, 2:ny - 1) = .true.
  end subroutine still

end program test_multigrid
