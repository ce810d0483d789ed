!> Interpolation of a field along straight lines between the nodes of its grid.
module pyworm_linear_interpolation
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: add_linear

contains

  !> Adds a field's values at some places, (2, nx, ny), times a weight: bilinear, and linear along x where it has one row.
  !>
  !> `first` is the first node of its grid and `spacing` what lies between two, along each direction; beyond the grid the
  !> value is zero.
  pure subroutine add_linear(field, first, spacing, weight, places, total)
    real(wp), contiguous, intent(in) :: field(:, :), places(:, :, :)
    real(wp), intent(in) :: first(2), spacing(2), weight
    real(wp), contiguous, intent(inout) :: total(:, :)
    real(wp) :: per_node(2), x, y, before, behind
    integer :: columns, rows, left, below, above, i, j

    columns = size(field, 1)
    rows = size(field, 2)
    per_node = 1/spacing
    do j = 1, size(total, 2)
      do i = 1, size(total, 1)
        x = (places(1, i, j) - first(1))*per_node(1)
        y = (places(2, i, j) - first(2))*per_node(2)
        ! in this form places that are not numbers lie beyond, too
        if (.not. (x >= 0 .and. x <= columns - 1 .and. y >= 0 .and. y <= rows - 1)) cycle
        left = max(1, min(int(x) + 1, columns - 1))
        below = max(1, min(int(y) + 1, rows - 1))
        above = min(below + 1, rows) ! the same where there is one row
        x = x - (left - 1)
        y = y - (below - 1)
        before = (1 - x)*field(left, below) + x*field(left + 1, below)
        behind = (1 - x)*field(left, above) + x*field(left + 1, above)
        total(i, j) = total(i, j) + weight*((1 - y)*before + y*behind)
      end do
    end do
  end subroutine add_linear

end module pyworm_linear_interpolation
