!> Interpolation of a field along straight lines between the nodes of its grid.
module pyworm_linear_interpolation
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: linear_at

contains

  !> Value of a field at a place between its nodes, bilinear, and linear along x where it has one row.
  !>
  !> `column` and `row` are the place over the spacing, counted from zero at the first node; beyond the grid the value
  !> is zero.
  pure function linear_at(field, column, row) result(value)
    real(wp), intent(in) :: field(:, :), column, row
    real(wp) :: value
    real(wp) :: x, y, before, behind
    integer :: left, below

    value = 0
    ! in this form places that are not numbers lie beyond, too
    if (.not. (column >= 0 .and. column <= size(field, 1) - 1)) return
    if (.not. (row >= 0 .and. row <= size(field, 2) - 1)) return
    left = max(1, min(int(column) + 1, size(field, 1) - 1))
    below = max(1, min(int(row) + 1, size(field, 2) - 1))
    x = column - (left - 1)
    y = row - (below - 1)
    before = (1 - x)*field(left, below) + x*field(left + 1, below)
    value = before
    if (size(field, 2) == 1) return
    behind = (1 - x)*field(left, below + 1) + x*field(left + 1, below + 1)
    value = (1 - y)*before + y*behind
  end function linear_at

end module pyworm_linear_interpolation
