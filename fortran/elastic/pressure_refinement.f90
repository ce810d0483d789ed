!> Interpolation of a contact pressure to a grid of half the spacing.
module pyworm_pressure_refinement
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: refine_pressure

contains

  !> Interpolates the pressure to half the spacing; node (i, j) becomes (2i - 1, 2j - 1).
  !>
  !> The square is interpolated, continued to one node beyond the contact: at the boundary of a contact the
  !> square falls to zero linearly (Johnson, Contact Mechanics, section 5.1), so that the boundary is located
  !> more accurately than by the coarse grid.
  pure subroutine refine_pressure(coarse, fine)
    real(wp), intent(in) :: coarse(:, :)
    real(wp), intent(out) :: fine(:, :)
    real(wp), allocatable :: square(:, :)
    integer :: nx, ny, j

    nx = size(fine, 1)
    ny = size(fine, 2)
    allocate (square, source=continued(coarse**2))
    do j = 1, ny, 2
      fine(1::2, j) = square(:, (j + 1)/2)
      fine(2:nx - 1:2, j) = (fine(1:nx - 2:2, j) + fine(3:nx:2, j))/2
      if (mod(nx, 2) == 0) fine(nx, j) = fine(nx - 1, j)
    end do
    do j = 2, ny - 1, 2
      fine(:, j) = (fine(:, j - 1) + fine(:, j + 1))/2
    end do
    if (mod(ny, 2) == 0) fine(:, ny) = fine(:, ny - 1)
    fine = sqrt(max(fine, 0.0_wp))
  end subroutine refine_pressure

  !> A field that is positive in the contact, continued linearly to the nodes next to it, where it is negative.
  pure function continued(field) result(wider)
    real(wp), intent(in) :: field(:, :)
    real(wp) :: wider(size(field, 1), size(field, 2))
    real(wp) :: framed(-1:size(field, 1) + 2, -1:size(field, 2) + 2)
    integer :: i, j

    framed = 0
    framed(1:size(field, 1), 1:size(field, 2)) = field
    do j = 1, size(field, 2)
      do i = 1, size(field, 1)
        wider(i, j) = framed(i, j)
        if (framed(i, j) <= 0) wider(i, j) = beyond( &
          [framed(i - 1, j), framed(i + 1, j), framed(i, j - 1), framed(i, j + 1)], &
          [framed(i - 2, j), framed(i + 2, j), framed(i, j - 2), framed(i, j + 2)])
      end do
    end do
  end function continued

  !> Mean of the straight lines through pairs of nodes, `near` and `far`, that leave the contact; 0 if none does.
  pure real(wp) function beyond(near, far)
    real(wp), intent(in) :: near(4), far(4)
    logical :: leaves(4)

    leaves = near > 0 .and. far > near
    beyond = min(sum(2*near - far, mask=leaves)/max(count(leaves), 1), 0.0_wp)
  end function beyond

end module pyworm_pressure_refinement
