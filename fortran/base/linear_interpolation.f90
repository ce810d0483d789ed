!> Interpolation of a field along straight lines between the nodes of its grid.
module pyworm_linear_interpolation
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: interpolate_linear

contains

  !> Values of a field at places between its nodes, bilinear, and linear along x where it has one row.
  !>
  !> `column` and `row` are the places over the spacing, counted from zero at the first node; beyond the grid the value
  !> is zero.
  pure subroutine interpolate_linear(field, column, row, values)
    real(wp), intent(in) :: field(:, :), column(:, :), row(:, :)
    real(wp), intent(out) :: values(:, :)
    real(wp) :: x, y, before, behind
    integer :: i, j, left, below

    do j = 1, size(values, 2)
      do i = 1, size(values, 1)
        x = column(i, j)
        y = row(i, j)
        values(i, j) = 0
        ! in this form places that are not numbers lie beyond, too
        if (.not. (x >= 0 .and. x <= size(field, 1) - 1 .and. y >= 0 .and. y <= size(field, 2) - 1)) cycle
        left = max(1, min(int(x) + 1, size(field, 1) - 1))
        below = max(1, min(int(y) + 1, size(field, 2) - 1))
        x = x - (left - 1)
        y = y - (below - 1)
        before = (1 - x)*field(left, below) + x*field(left + 1, below)
        values(i, j) = before
        if (size(field, 2) == 1) cycle
        behind = (1 - x)*field(left, below + 1) + x*field(left + 1, below + 1)
        values(i, j) = (1 - y)*before + y*behind
      end do
    end do
  end subroutine interpolate_linear

end module pyworm_linear_interpolation
