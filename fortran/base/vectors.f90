!> Sums and steps over long vectors, on all threads.
!>
!> Sums go over blocks of a fixed length, whose sums are then added in order: the result is the same to the last bit
!> whatever the number of threads. Within a block the compiler may sum in lanes (`meson.build`); gfortran 12 made a
!> simd directive's reduction four times slower than that.
module vectors
  use kinds, only: pp, wp
  implicit none(type, external)
  private

  public :: dot, total, step_along, project_out, combine

  !> Elements of a block: long enough to be worth a thread's while.
  integer, parameter :: block_length = 8192
  !> The same where a block is met many times and had better stay in the first cache.
  integer, parameter :: cached_length = 2048

contains

  !> Inner product of two vectors.
  real(wp) function dot(a, b)
    real(wp), contiguous, intent(in) :: a(:), b(:)
    real(wp) :: partial((size(a) + block_length - 1)/block_length), part
    integer :: i, k

    !$omp parallel do private(part, i) schedule(static) if(size(partial) > 1)
    do k = 1, size(partial)
      part = 0
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

  !> Takes from w what lies along the columns of an orthonormal basis: w - V V'w, by classical Gram-Schmidt.
  !>
  !> `along` is V'w, `rest` the squared norm of what is left.
  subroutine project_out(basis, w, along, rest)
    real(pp), contiguous, intent(in) :: basis(:, :)
    real(wp), contiguous, intent(inout) :: w(:)
    real(wp), intent(out) :: along(size(basis, 2)), rest
    real(wp) :: partial(size(basis, 2), (size(w) + cached_length - 1)/cached_length), part
    integer :: i, k, l, first, last

    !$omp parallel do private(part, i, l, first, last) schedule(static) if(size(w) > block_length)
    do k = 1, size(partial, 2)
      first = (k - 1)*cached_length + 1
      last = min(k*cached_length, size(w))
      do l = 1, size(basis, 2)
        part = 0
        do i = first, last
          part = part + basis(i, l)*w(i)
        end do
        partial(l, k) = part
      end do
    end do
    along = sum(partial, dim=2)
    !$omp parallel do private(part, i, l, first, last) schedule(static) if(size(w) > block_length)
    do k = 1, size(partial, 2)
      first = (k - 1)*cached_length + 1
      last = min(k*cached_length, size(w))
      do l = 1, size(basis, 2)
        do i = first, last
          w(i) = w(i) - along(l)*basis(i, l)
        end do
      end do
      part = 0
      do i = first, last
        part = part + w(i)**2
      end do
      partial(1, k) = part
    end do
    rest = sum(partial(1, :))
  end subroutine project_out

  !> w = V c, the combination of a basis' columns.
  subroutine combine(basis, c, w)
    real(pp), contiguous, intent(in) :: basis(:, :)
    real(wp), intent(in) :: c(size(basis, 2))
    real(wp), contiguous, intent(out) :: w(:)
    integer :: i, k, l, last

    !$omp parallel do private(i, l, last) schedule(static) if(size(w) > block_length)
    do k = 1, size(w), cached_length
      last = min(k + cached_length - 1, size(w))
      w(k:last) = 0
      do l = 1, size(basis, 2)
        do i = k, last
          w(i) = w(i) + c(l)*basis(i, l)
        end do
      end do
    end do
  end subroutine combine

end module vectors
