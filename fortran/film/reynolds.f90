!> Reynolds' equation div(rho h um) - div(rho h^3 / (12 eta) grad p) + rho dh/dt = 0 on a uniform grid.
!>
!> Node-centred finite volumes: diffusive fluxes with the mean mobility of a face's two nodes, wedge fluxes
!> with second-order upwind rho h by the sign of the entrainment at the face. Density is taken relative to
!> that at ambient pressure, so that the residual is a volume flow per area [m/s].
module reynolds
  use kinds, only: wp
  use oil_laws, only: oil_law, viscosity, density
  use status, only: status_ok, status_no_memory
  implicit none(type, external)
  private

  public :: film_grid, film_fields, new_film_fields, set_film_fields, flow_imbalance, flow_imbalance_change
  public :: add_wedge, clear_outline

  !> Where the film is: points, spacing [m], and the kinematics over it [m/s].
  type :: film_grid
    integer :: nx = 0, ny = 0
    real(wp) :: dx = 0, dy = 0
    !> Entrainment through the face after a node, along x and along y.
    real(wp), allocatable :: u(:, :), v(:, :)
    !> Rate of change of the gap.
    real(wp), allocatable :: squeeze(:, :)
  end type film_grid

  !> Nodal fields at one pressure and film, with the derivatives that Newton's method needs.
  type :: film_fields
    !> Pressure [Pa] and film [m].
    real(wp), allocatable :: p(:, :), h(:, :)
    !> Relative density and its derivative by pressure.
    real(wp), allocatable :: rho(:, :), rho_p(:, :)
    !> Mobility rho h^3 / (12 eta) and its derivatives by pressure and film.
    real(wp), allocatable :: mobility(:, :), mobility_p(:, :), mobility_h(:, :)
    !> Mobility along y where it is another than along x (`sheared_reynolds`).
    real(wp), allocatable :: mobility_y(:, :)
    !> Scratch: rho h, or its change, and the change of the mobility.
    real(wp), allocatable :: mass(:, :), mobility_change(:, :)
  end type film_fields

contains

  !> Space for the fields of a grid.
  subroutine new_film_fields(nx, ny, fields, stat)
    integer, intent(in) :: nx, ny
    type(film_fields), intent(out) :: fields
    integer, intent(out) :: stat
    integer :: err

    allocate (fields%p(nx, ny), fields%h(nx, ny), fields%rho(nx, ny), fields%rho_p(nx, ny), &
      fields%mobility(nx, ny), fields%mobility_p(nx, ny), fields%mobility_h(nx, ny), fields%mass(nx, ny), &
      fields%mobility_change(nx, ny), stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
    if (stat /= status_ok) return
    fields%p = 0
    fields%h = 0
  end subroutine new_film_fields

  !> Fields at the pressure and film that `fields` already holds.
  !>
  !> A film below `floor` [m] keeps the mobility of the floor: coarse grids and Newton steps may pass through
  !> films that are not positive.
  subroutine set_film_fields(oil, floor, fields)
    type(oil_law), intent(in) :: oil
    real(wp), intent(in) :: floor
    type(film_fields), intent(inout) :: fields
    real(wp) :: eta, slope, thickness
    integer :: i, j

    !$omp parallel do private(i, eta, slope, thickness) schedule(static)
    do j = 1, size(fields%p, 2)
      do i = 1, size(fields%p, 1)
        call viscosity(oil, fields%p(i, j), eta, slope)
        call density(oil, fields%p(i, j), fields%rho(i, j), fields%rho_p(i, j))
        thickness = max(fields%h(i, j), floor)
        fields%mobility(i, j) = fields%rho(i, j)*thickness**3/(12*eta)
        fields%mobility_p(i, j) = fields%mobility(i, j)*(fields%rho_p(i, j)/fields%rho(i, j) - slope)
        fields%mobility_h(i, j) = 0
        if (fields%h(i, j) > floor) fields%mobility_h(i, j) = 3*fields%mobility(i, j)/thickness
      end do
    end do
  end subroutine set_film_fields

  !> Net volume outflow per area [m/s] of each inner node's cell; zero on the outline.
  subroutine flow_imbalance(grid, fields, imbalance)
    type(film_grid), intent(in) :: grid
    type(film_fields), intent(inout) :: fields
    real(wp), contiguous, intent(out) :: imbalance(:, :)
    integer :: j

    !$omp parallel do schedule(static)
    do j = 1, grid%ny
      fields%mass(:, j) = fields%rho(:, j)*fields%h(:, j)
      imbalance(:, j) = fields%rho(:, j)*grid%squeeze(:, j)
    end do
    call add_wedge(grid, fields%mass, imbalance)
    call add_diffusion(grid, fields%mobility, fields%p, imbalance)
    call clear_outline(imbalance)
  end subroutine flow_imbalance

  !> Change of the imbalance for a small change of pressure and film: the exact Jacobian times (dp, dh).
  subroutine flow_imbalance_change(grid, fields, dp, dh, change)
    type(film_grid), intent(in) :: grid
    type(film_fields), intent(inout) :: fields
    real(wp), contiguous, intent(in) :: dp(:, :), dh(:, :)
    real(wp), contiguous, intent(out) :: change(:, :)
    integer :: j

    !$omp parallel do schedule(static)
    do j = 1, grid%ny
      fields%mass(:, j) = fields%rho_p(:, j)*fields%h(:, j)*dp(:, j) + fields%rho(:, j)*dh(:, j)
      fields%mobility_change(:, j) = fields%mobility_p(:, j)*dp(:, j) + fields%mobility_h(:, j)*dh(:, j)
      change(:, j) = fields%rho_p(:, j)*grid%squeeze(:, j)*dp(:, j)
    end do
    call add_wedge(grid, fields%mass, change)
    call add_diffusion(grid, fields%mobility, dp, change)
    call add_diffusion(grid, fields%mobility_change, fields%p, change)
    call clear_outline(change)
  end subroutine flow_imbalance_change

  !> Adds -div(m grad p).
  subroutine add_diffusion(grid, m, p, r)
    type(film_grid), intent(in) :: grid
    real(wp), contiguous, intent(in) :: m(:, :), p(:, :)
    real(wp), contiguous, intent(inout) :: r(:, :)
    real(wp) :: along_x, along_y
    integer :: i, j

    along_x = 0.5_wp/grid%dx**2
    along_y = 0.5_wp/grid%dy**2
    !$omp parallel do private(i) schedule(static)
    do j = 2, grid%ny - 1
      do i = 2, grid%nx - 1
        r(i, j) = r(i, j) &
          + along_x*((m(i, j) + m(i + 1, j))*(p(i, j) - p(i + 1, j)) &
          + (m(i, j) + m(i - 1, j))*(p(i, j) - p(i - 1, j))) &
          + along_y*((m(i, j) + m(i, j + 1))*(p(i, j) - p(i, j + 1)) &
          + (m(i, j) + m(i, j - 1))*(p(i, j) - p(i, j - 1)))
      end do
    end do
  end subroutine add_diffusion

  !> Adds div(q um) with q upwind to second order; next to the outline q is the mean of a face's two nodes.
  subroutine add_wedge(grid, q, r)
    type(film_grid), intent(in) :: grid
    real(wp), contiguous, intent(in) :: q(:, :)
    real(wp), contiguous, intent(inout) :: r(:, :)
    real(wp) :: flux(grid%nx), before(grid%nx), after(grid%nx)
    integer :: i, j, nx

    nx = grid%nx
    !$omp parallel do private(i, flux, before, after) schedule(static)
    do j = 2, grid%ny - 1
      flux(1) = grid%u(1, j)*(q(1, j) + q(2, j))/(2*grid%dx)
      flux(nx - 1) = grid%u(nx - 1, j)*(q(nx - 1, j) + q(nx, j))/(2*grid%dx)
      do i = 2, nx - 2
        flux(i) = upwind(grid%u(i, j), q(i - 1, j), q(i, j), q(i + 1, j), q(i + 2, j))/grid%dx
      end do
      call flow_between_rows(grid, q, j - 1, before)
      call flow_between_rows(grid, q, j, after)
      do i = 2, nx - 1
        r(i, j) = r(i, j) + flux(i) - flux(i - 1) + after(i) - before(i)
      end do
    end do
  end subroutine add_wedge

  !> Wedge flow through the faces between row j and the next, per spacing [m/s].
  pure subroutine flow_between_rows(grid, q, j, flux)
    type(film_grid), intent(in) :: grid
    real(wp), contiguous, intent(in) :: q(:, :)
    integer, intent(in) :: j
    real(wp), intent(out) :: flux(grid%nx)
    integer :: i

    if (j == 1 .or. j == grid%ny - 1) then
      flux = grid%v(:, j)*(q(:, j) + q(:, j + 1))/(2*grid%dy)
    else
      do i = 1, grid%nx
        flux(i) = upwind(grid%v(i, j), q(i, j - 1), q(i, j), q(i, j + 1), q(i, j + 2))/grid%dy
      end do
    end if
  end subroutine flow_between_rows

  !> Flow of q through a face between the second and the third of four nodes.
  pure real(wp) function upwind(u, q1, q2, q3, q4)
    real(wp), intent(in) :: u, q1, q2, q3, q4

    upwind = max(u, 0.0_wp)*(1.5_wp*q2 - 0.5_wp*q1) + min(u, 0.0_wp)*(1.5_wp*q3 - 0.5_wp*q4)
  end function upwind

  pure subroutine clear_outline(r)
    real(wp), contiguous, intent(inout) :: r(:, :)

    r(1, :) = 0
    r(size(r, 1), :) = 0
    r(:, 1) = 0
    r(:, size(r, 2)) = 0
  end subroutine clear_outline

end module reynolds
