!> Interpolation of fields to a grid of half the spacing.
module pyworm_cubic_refinement
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: interpolate_cubic

contains

  !> Interpolates by cubics in both directions, (nx, ny) to (2 nx - 1, 2 ny - 1), nx and ny at least 4; along x
  !> alone where ny is 1.
  pure subroutine interpolate_cubic(coarse, fine)
    real(wp), intent(in) :: coarse(:, :)
    real(wp), intent(out) :: fine(:, :)
    integer :: j, nx, ny

    nx = size(coarse, 1)
    ny = size(coarse, 2)
    do j = 1, ny
      fine(::2, 2*j - 1) = coarse(:, j)
      fine(2, 2*j - 1) = at_end(coarse(1, j), coarse(2, j), coarse(3, j), coarse(4, j))
      fine(4:2*nx - 4:2, 2*j - 1) = between(coarse(:nx - 3, j), coarse(2:nx - 2, j), coarse(3:nx - 1, j), &
        coarse(4:, j))
      fine(2*nx - 2, 2*j - 1) = at_end(coarse(nx, j), coarse(nx - 1, j), coarse(nx - 2, j), coarse(nx - 3, j))
    end do
    if (ny == 1) return
    fine(:, 2) = at_end(fine(:, 1), fine(:, 3), fine(:, 5), fine(:, 7))
    do j = 4, 2*ny - 4, 2
      fine(:, j) = between(fine(:, j - 3), fine(:, j - 1), fine(:, j + 1), fine(:, j + 3))
    end do
    fine(:, 2*ny - 2) = at_end(fine(:, 2*ny - 1), fine(:, 2*ny - 3), fine(:, 2*ny - 5), fine(:, 2*ny - 7))
  end subroutine interpolate_cubic

  !> Value midway between the second and the third of four points.
  elemental real(wp) function between(a, b, c, d)
    real(wp), intent(in) :: a, b, c, d

    between = (9*(b + c) - a - d)/16
  end function between

  !> Value midway between the first and the second of four points.
  elemental real(wp) function at_end(a, b, c, d)
    real(wp), intent(in) :: a, b, c, d

    at_end = (5*a + 15*b - 5*c + d)/16
  end function at_end

end module pyworm_cubic_refinement
