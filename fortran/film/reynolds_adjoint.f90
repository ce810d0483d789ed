!> Transposed products of the linearised Reynolds equation on a uniform grid: those of `reynolds` and of `sheared_reynolds`.
!>
!> With r a weight of each node's imbalance they give the change of sum(r imbalance) by the oil's pressure and by the film at each
!> node. Weights are zero on the outline, which has no imbalance.
module pyworm_reynolds_adjoint
  use pyworm_kinds, only: wp
  use pyworm_reynolds, only: arithmetic_share, face_mean, film_fields, film_grid
  use pyworm_sheared_reynolds, only: sheared_film
  implicit none(type, external)
  private

  public :: flow_imbalance_adjoint, sheared_imbalance_adjoint, upwind_weights

contains

  !> The transpose of `flow_imbalance_change`.
  subroutine flow_imbalance_adjoint(grid, fields, r, by_p, by_h)
    type(film_grid), intent(in) :: grid
    type(film_fields), intent(in) :: fields
    real(wp), contiguous, intent(in) :: r(:, :)
    real(wp), contiguous, intent(out) :: by_p(:, :), by_h(:, :)
    real(wp), dimension(grid%nx, grid%ny) :: root, by_root

    call set_mass_adjoint(grid, fields, r, by_p, by_h)
    root = sqrt(fields%mobility)
    by_root = 0
    call add_diffusion_adjoint(1, 0, 1/grid%dx**2, root, fields%p, r, by_p, by_root)
    call add_diffusion_adjoint(0, 1, 1/grid%dy**2, root, fields%p, r, by_p, by_root)
    by_root = by_root/(2*root)
    by_p = by_p + by_root*fields%mobility_p
    by_h = by_h + by_root*fields%mobility_h
  end subroutine flow_imbalance_adjoint

  !> The transpose of `sheared_imbalance_change`.
  subroutine sheared_imbalance_adjoint(grid, film, fields, r, by_p, by_h)
    type(film_grid), intent(in) :: grid
    type(sheared_film), intent(in) :: film
    type(film_fields), intent(in) :: fields
    real(wp), contiguous, intent(in) :: r(:, :)
    real(wp), contiguous, intent(out) :: by_p(:, :), by_h(:, :)
    real(wp) :: outflow, aside
    integer :: i, j

    call set_mass_adjoint(grid, fields, r, by_p, by_h)
    associate (x => film%along_x, y => film%along_y, slope_x => 1/(4*grid%dx), slope_y => 1/(4*grid%dy))
      do j = 2, grid%ny - 1
        do i = 1, grid%nx - 1
          outflow = (r(i + 1, j) - r(i, j))/grid%dx
          by_p(i, j) = by_p(i, j) + x%before(i, j)*outflow
          by_p(i + 1, j) = by_p(i + 1, j) + x%after(i, j)*outflow
          by_h(i, j) = by_h(i, j) + x%film_before(i, j)*outflow
          by_h(i + 1, j) = by_h(i + 1, j) + x%film_after(i, j)*outflow
          aside = x%aside(i, j)*slope_y*outflow
          by_p(i:i + 1, j + 1) = by_p(i:i + 1, j + 1) + aside
          by_p(i:i + 1, j - 1) = by_p(i:i + 1, j - 1) - aside
        end do
      end do
      do j = 1, grid%ny - 1
        do i = 2, grid%nx - 1
          outflow = (r(i, j + 1) - r(i, j))/grid%dy
          by_p(i, j) = by_p(i, j) + y%before(i, j)*outflow
          by_p(i, j + 1) = by_p(i, j + 1) + y%after(i, j)*outflow
          by_h(i, j) = by_h(i, j) + y%film_before(i, j)*outflow
          by_h(i, j + 1) = by_h(i, j + 1) + y%film_after(i, j)*outflow
          aside = y%aside(i, j)*slope_x*outflow
          by_p(i + 1, j:j + 1) = by_p(i + 1, j:j + 1) + aside
          by_p(i - 1, j:j + 1) = by_p(i - 1, j:j + 1) - aside
        end do
      end do
    end associate
  end subroutine sheared_imbalance_adjoint

  !> Sets what the weights count of the change of rho h, by the wedge and the transient term: the transpose of `set_mass_change`
  !> after those.
  subroutine set_mass_adjoint(grid, fields, r, by_p, by_h)
    type(film_grid), intent(in) :: grid
    type(film_fields), intent(in) :: fields
    real(wp), contiguous, intent(in) :: r(:, :)
    real(wp), contiguous, intent(out) :: by_p(:, :), by_h(:, :)

    ! by_h is scratch: that by rho h
    by_h = grid%implicit_rate*r
    call add_wedge_adjoint(grid%nx, grid%ny, grid%dx, grid%dy, grid%u, grid%v, r, by_h)
    by_p = by_h*fields%rho_p*fields%h
    by_h = by_h*fields%rho
    if (fields%is_rough()) by_h = by_h*fields%rough%widening
  end subroutine set_mass_adjoint

  !> Adds the transpose of div(q um).
  pure subroutine add_wedge_adjoint(nx, ny, dx, dy, u, v, r, q)
    integer, intent(in) :: nx, ny
    real(wp), intent(in) :: dx, dy, u(nx, ny), v(nx, ny), r(nx, ny)
    real(wp), intent(inout) :: q(nx, ny)
    integer :: i, j

    do j = 2, ny - 1
      q(1:2, j) = q(1:2, j) + u(1, j)*(r(1, j) - r(2, j))/(2*dx)
      q(nx - 1:nx, j) = q(nx - 1:nx, j) + u(nx - 1, j)*(r(nx - 1, j) - r(nx, j))/(2*dx)
      do i = 2, nx - 2
        q(i - 1:i + 2, j) = q(i - 1:i + 2, j) + upwind_weights(u(i, j))*((r(i, j) - r(i + 1, j))/dx)
      end do
    end do
    do i = 2, nx - 1
      q(i, 1:2) = q(i, 1:2) + v(i, 1)*(r(i, 1) - r(i, 2))/(2*dy)
      q(i, ny - 1:ny) = q(i, ny - 1:ny) + v(i, ny - 1)*(r(i, ny - 1) - r(i, ny))/(2*dy)
    end do
    do j = 2, ny - 2
      do i = 2, nx - 1
        q(i, j - 1:j + 2) = q(i, j - 1:j + 2) + upwind_weights(v(i, j))*((r(i, j) - r(i, j + 1))/dy)
      end do
    end do
  end subroutine add_wedge_adjoint

  !> Flow of q through a face between the second and the third of four nodes, by q of each: `reynolds.upwind`.
  pure function upwind_weights(u) result(weight)
    real(wp), intent(in) :: u
    real(wp) :: weight(4)

    weight = (max(u, 0.0_wp)*[-1, 5, 2, 0] + min(u, 0.0_wp)*[0, 2, 5, -1])/6
  end function upwind_weights

  !> Adds what the diffusion between nodes (i, j) and (i + di, j + dj) gives: by pressure, and by the root of the mobility at the
  !> nodes.
  pure subroutine add_diffusion_adjoint(di, dj, per_square, root, p, r, by_p, by_root)
    integer, intent(in) :: di, dj
    real(wp), intent(in) :: per_square, root(:, :), p(:, :), r(:, :)
    real(wp), intent(inout) :: by_p(:, :), by_root(:, :)
    real(wp), parameter :: other = 1 - arithmetic_share
    real(wp) :: through, driven
    integer :: i, j, k, l

    do j = 1, size(p, 2) - dj
      do i = 1, size(p, 1) - di
        k = i + di
        l = j + dj
        through = (r(i, j) - r(k, l))*per_square
        driven = through*(p(i, j) - p(k, l))
        through = through*face_mean(root(i, j), root(k, l))
        by_p(i, j) = by_p(i, j) + through
        by_p(k, l) = by_p(k, l) - through
        by_root(i, j) = by_root(i, j) + driven*(arithmetic_share*root(i, j) + other*root(k, l))
        by_root(k, l) = by_root(k, l) + driven*(arithmetic_share*root(k, l) + other*root(i, j))
      end do
    end do
  end subroutine add_diffusion_adjoint

end module pyworm_reynolds_adjoint
