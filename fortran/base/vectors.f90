!> Sums and updates of long vectors, on all threads.
!>
!> Sums go over blocks of a fixed length, whose sums are then added in order: the result is the same to the
!> last bit whatever the number of threads. Within a block they go in lanes, which gfortran 12 turns into
!> vector instructions; a simd directive's reduction it does not, and leave to reorder all sums would spoil
!> those that are in good order.
module pyworm_vectors
  use pyworm_kinds, only: pp, wp
  implicit none(type, external)
  private

  public :: dot, total, step_along, normalise, project_out, combine

  !> Elements of a block: long enough to be worth a thread's while.
  integer, parameter :: block_length = 8192
  !> Elements of a block that is used many times and should stay in the first cache.
  integer, parameter :: cached_length = 2048
  !> Number of partial sums, one for each lane.
  integer, parameter :: lanes = 8

contains

  !> Inner product of two vectors.
  real(wp) function dot(a, b)
    real(wp), contiguous, intent(in) :: a(:), b(:)
    real(wp) :: partial((size(a) + block_length - 1)/block_length)
    integer :: k, first, last

    !$omp parallel do private(first, last) schedule(static) if(size(partial) > 1)
    do k = 1, size(partial)
      first = (k - 1)*block_length + 1
      last = min(k*block_length, size(a))
      partial(k) = short_dot(a(first:last), b(first:last))
    end do
    dot = sum(partial)
  end function dot

  !> Sum of a field.
  real(wp) function total(a)
    real(wp), contiguous, intent(in) :: a(:, :)
    real(wp) :: row(size(a, 2)), lane(lanes)
    integer :: i, j, whole

    whole = size(a, 1) - mod(size(a, 1), lanes)
    !$omp parallel do private(lane, i) schedule(static) if(size(a) > block_length)
    do j = 1, size(a, 2)
      lane = 0
      do i = 1, whole, lanes
        lane = lane + a(i:i + lanes - 1, j)
      end do
      row(j) = sum(lane) + sum(a(whole + 1:, j))
    end do
    total = sum(row)
  end function total

  !> Inner product within a block.
  pure real(wp) function short_dot(a, b)
    real(wp), contiguous, intent(in) :: a(:), b(:)
    real(wp) :: lane(lanes)
    integer :: i, whole

    whole = size(a) - mod(size(a), lanes)
    lane = 0
    do i = 1, whole, lanes
      lane = lane + a(i:i + lanes - 1)*b(i:i + lanes - 1)
    end do
    short_dot = sum(lane) + sum(a(whole + 1:)*b(whole + 1:))
  end function short_dot

  !> Inner product within a block with a vector in single precision.
  pure real(wp) function mixed_dot(a, b)
    real(pp), contiguous, intent(in) :: a(:)
    real(wp), contiguous, intent(in) :: b(:)
    real(wp) :: lane(lanes)
    integer :: i, whole

    whole = size(a) - mod(size(a), lanes)
    lane = 0
    do i = 1, whole, lanes
      lane = lane + a(i:i + lanes - 1)*b(i:i + lanes - 1)
    end do
    mixed_dot = sum(lane) + sum(a(whole + 1:)*b(whole + 1:))
  end function mixed_dot

  !> Replaces x by x + step d.
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

  !> Divides w by its norm and copies it to a column of a basis.
  subroutine normalise(norm, w, column)
    real(wp), intent(in) :: norm
    real(wp), contiguous, intent(inout) :: w(:)
    real(pp), contiguous, intent(out) :: column(:)
    integer :: i

    !$omp parallel do schedule(static) if(size(w) > block_length)
    do i = 1, size(w)
      w(i) = w(i)*(1/norm)
      column(i) = real(w(i), pp)
    end do
  end subroutine normalise

  !> Orthogonalises w against the columns of an orthonormal basis: w - V V'w, by classical Gram-Schmidt.
  !>
  !> `along` is V'w, `rest` the squared norm of the result.
  subroutine project_out(basis, w, along, rest)
    real(pp), contiguous, intent(in) :: basis(:, :)
    real(wp), contiguous, intent(inout) :: w(:)
    real(wp), intent(out) :: along(size(basis, 2)), rest
    real(wp) :: partial(size(basis, 2), (size(w) + cached_length - 1)/cached_length)
    integer :: i, k, l, first, last

    !$omp parallel do private(l, first, last) schedule(static) if(size(w) > block_length)
    do k = 1, size(partial, 2)
      first = (k - 1)*cached_length + 1
      last = min(k*cached_length, size(w))
      do l = 1, size(basis, 2)
        partial(l, k) = mixed_dot(basis(first:last, l), w(first:last))
      end do
    end do
    along = sum(partial, dim=2)
    !$omp parallel do private(i, l, first, last) schedule(static) if(size(w) > block_length)
    do k = 1, size(partial, 2)
      first = (k - 1)*cached_length + 1
      last = min(k*cached_length, size(w))
      do l = 1, size(basis, 2)
        do i = first, last
          w(i) = w(i) - along(l)*basis(i, l)
        end do
      end do
      partial(1, k) = short_dot(w(first:last), w(first:last))
    end do
    rest = sum(partial(1, :))
  end subroutine project_out

  !> Computes the combination w = V c of a basis' columns.
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

end module pyworm_vectors
