!> Sums over fields. The compiler may reorder them (`omp simd`), always in the same way.
module vectors
  use kinds, only: wp
  implicit none(type, external)
  private

  public :: dot, total

contains

  !> Inner product of two vectors.
  pure real(wp) function dot(a, b)
    real(wp), contiguous, intent(in) :: a(:), b(:)
    integer :: i

    dot = 0
    !$omp simd reduction(+:dot)
    do i = 1, size(a)
      dot = dot + a(i)*b(i)
    end do
  end function dot

  !> Sum of a field.
  pure real(wp) function total(a)
    real(wp), contiguous, intent(in) :: a(:, :)
    real(wp) :: row
    integer :: i, j

    total = 0
    do j = 1, size(a, 2)
      row = 0
      !$omp simd reduction(+:row)
      do i = 1, size(a, 1)
        row = row + a(i, j)
      end do
      total = total + row
    end do
  end function total

end module vectors
