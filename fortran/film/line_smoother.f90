!> Gauss-Seidel by lines: every line of a field is solved at once against its two neighbours.
!>
!> Each tridiagonal system is factored beforehand from both ends towards its middle, so that a sweep runs
!> two independent recurrences side by side and divides nowhere.
module line_smoother
  use kinds, only: wp
  implicit none(type, external)
  private

  public :: lines, factor_lines, sweep_lines

  !> Lines along the first index of a field of points (length, count).
  type :: lines
    !> Coupling to the line before and to the line after.
    real(wp), allocatable :: before(:, :), after(:, :)
    !> Factors: reciprocal pivot, coupling to the point eliminated before, coupling to that solved before.
    real(wp), allocatable :: pivot(:, :), outward(:, :), inward(:, :)
  end type lines

contains

  !> Factors the lines; points of the outline are never touched.
  pure subroutine factor_lines(left, centre, right, before, after, self)
    real(wp), intent(in) :: left(:, :), centre(:, :), right(:, :), before(:, :), after(:, :)
    type(lines), intent(inout) :: self
    integer :: i, j, n, middle

    n = size(centre, 1)
    middle = n/2
    self%before = before
    self%after = after
    if (.not. allocated(self%pivot)) allocate (self%pivot, self%outward, self%inward, mold=centre)
    self%pivot = 0
    self%outward = 0
    self%inward = 0
    do j = 2, size(centre, 2) - 1
      do i = 2, middle
        self%pivot(i, j) = 1/(centre(i, j) - left(i, j)*self%inward(i - 1, j))
        self%outward(i, j) = left(i, j)*self%pivot(i, j)
        self%inward(i, j) = right(i, j)*self%pivot(i, j)
      end do
      do i = n - 1, middle + 1, -1
        self%pivot(i, j) = 1/(centre(i, j) - right(i, j)*self%inward(i + 1, j))
        self%outward(i, j) = right(i, j)*self%pivot(i, j)
        self%inward(i, j) = left(i, j)*self%pivot(i, j)
      end do
    end do
  end subroutine factor_lines

  !> One sweep over all lines, in rising order when `rising`, else in falling order.
  pure subroutine sweep_lines(self, f, rising, x)
    type(lines), intent(in) :: self
    real(wp), contiguous, intent(in) :: f(:, :)
    logical, intent(in) :: rising
    real(wp), contiguous, intent(inout) :: x(:, :)
    integer :: j, count

    count = size(x, 2)
    if (rising) then
      do j = 2, count - 1
        call solve_line(self, j, f, x)
      end do
    else
      do j = count - 1, 2, -1
        call solve_line(self, j, f, x)
      end do
    end if
  end subroutine sweep_lines

  pure subroutine solve_line(self, j, f, x)
    type(lines), intent(in) :: self
    integer, intent(in) :: j
    real(wp), contiguous, intent(in) :: f(:, :)
    real(wp), contiguous, intent(inout) :: x(:, :)
    real(wp) :: g(size(x, 1))
    real(wp) :: low, high
    integer :: i, k, n, middle

    n = size(x, 1)
    middle = n/2
    do i = 2, n - 1
      g(i) = (f(i, j) - self%before(i, j)*x(i, j - 1) - self%after(i, j)*x(i, j + 1))*self%pivot(i, j)
    end do
    ! elimination from both ends: the two halves differ in length by at most one point
    low = 0
    high = 0
    if (mod(n, 2) == 1) then
      high = g(n - 1)
    end if
    do k = 2, middle
      low = g(k) - self%outward(k, j)*low
      g(k) = low
      i = n + 1 - k - mod(n, 2)
      high = g(i) - self%outward(i, j)*high
      g(i) = high
    end do
    low = (g(middle) - self%inward(middle, j)*g(middle + 1)) &
      /(1 - self%inward(middle, j)*self%inward(middle + 1, j))
    high = g(middle + 1) - self%inward(middle + 1, j)*low
    x(middle, j) = low
    x(middle + 1, j) = high
    do k = middle - 1, 2, -1
      low = g(k) - self%inward(k, j)*low
      x(k, j) = low
      i = 2*middle + 1 - k
      high = g(i) - self%inward(i, j)*high
      x(i, j) = high
    end do
    if (mod(n, 2) == 1) x(n - 1, j) = g(n - 1) - self%inward(n - 1, j)*high
  end subroutine solve_line

end module line_smoother
