!> Sums and steps over long vectors, on all threads.
!>
!> Sums go over blocks of a fixed length, whose sums are then added in order: the result is the same to the last bit
!> whatever the number of threads.
module vectors
  use kinds, only: wp
  implicit none(type, external)
  private

  public :: dot, total, step_along

  !> Elements of a block: long enough to be worth a thread's while.
  integer, parameter :: block_length = 8192

contains

  !> Inner product of two vectors.
  real(wp) function dot(a, b)
    real(wp), contiguous, intent(in) :: a(:), b(:)
    real(wp) :: partial((size(a) + block_length - 1)/block_length), part
    integer :: i, k

    !$omp parallel do private(part, i) schedule(static) if(size(partial) > 1)
    do k = 1, size(partial)
      part = 0
      !$omp simd reduction(+:part)
      do i = (k - 1)*block_length + 1, min(k*block_length, size(a))
        part = part + a(i)*b(i)
      end do
      partial(k) = part
    end do
    dot = sum(partial)
  end function dot

  !> Sum of a field.
  real(wp) function total(a)
    real(wp), contiguous, intent(in) :: a(:, :)
    real(wp) :: row(size(a, 2)), part
    integer :: i, j

    !$omp parallel do private(part, i) schedule(static) if(size(a) > block_length)
    do j = 1, size(a, 2)
      part = 0
      !$omp simd reduction(+:part)
      do i = 1, size(a, 1)
        part = part + a(i, j)
      end do
      row(j) = part
    end do
    total = sum(row)
  end function total

  !> x + step d, in place.
  subroutine step_along(step, d, x)
    real(wp), intent(in) :: step
    real(wp), contiguous, intent(in) :: d(:)
    real(wp), contiguous, intent(inout) :: x(:)
    integer :: i

    !$omp parallel do simd schedule(static) if(size(x) > block_length)
    do i = 1, size(x)
      x(i) = x(i) + step*d(i)
    end do
  end subroutine step_along

end module vectors
