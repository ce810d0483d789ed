!> Gauss-Seidel by lines: every line of a field is solved at once against its two neighbours.
!>
!> Each tridiagonal system is factored beforehand from both ends towards its middle, so that a sweep runs
!> two independent recurrences side by side and divides nowhere.
module line_smoother
  use kinds, only: pp
  use status, only: status_ok, status_no_memory
  implicit none(type, external)
  private

  public :: five_points, line_factors, new_line_factors, factor_lines, sweep_lines

  !> A five-point matrix over a field whose lines run along the first index.
  type :: five_points
    !> Centre, the two neighbours within the line, the lines before and after; (length, count).
    real(pp), allocatable :: centre(:, :), left(:, :), right(:, :), before(:, :), after(:, :)
  end type five_points

  !> Factors: reciprocal pivot, coupling to the point eliminated before, coupling to that solved before.
  type :: line_factors
    real(pp), allocatable :: pivot(:, :), outward(:, :), inward(:, :)
  end type line_factors

contains

  !> Space for the factors of `count` lines of `length` points.
  subroutine new_line_factors(length, count, self, stat)
    integer, intent(in) :: length, count
    type(line_factors), intent(out) :: self
    integer, intent(out) :: stat
    integer :: err

    allocate (self%pivot(length, count), self%outward(length, count), self%inward(length, count), &
      source=0.0_pp, stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
  end subroutine new_line_factors

  !> Factors the lines; points of the outline are never touched.
  subroutine factor_lines(matrix, self)
    type(five_points), intent(in) :: matrix
    type(line_factors), intent(inout) :: self
    integer :: i, j, n, middle

    n = size(matrix%centre, 1)
    middle = n/2
    !$omp parallel do private(i) schedule(static)
    do j = 2, size(matrix%centre, 2) - 1
      do i = 2, middle
        self%pivot(i, j) = 1/(matrix%centre(i, j) - matrix%left(i, j)*self%inward(i - 1, j))
        self%outward(i, j) = matrix%left(i, j)*self%pivot(i, j)
        self%inward(i, j) = matrix%right(i, j)*self%pivot(i, j)
      end do
      do i = n - 1, middle + 1, -1
        self%pivot(i, j) = 1/(matrix%centre(i, j) - matrix%right(i, j)*self%inward(i + 1, j))
        self%outward(i, j) = matrix%right(i, j)*self%pivot(i, j)
        self%inward(i, j) = matrix%left(i, j)*self%pivot(i, j)
      end do
    end do
  end subroutine factor_lines

  !> One sweep over all lines, in rising order when `rising`, else in falling order.
  pure subroutine sweep_lines(matrix, factors, f, rising, x)
    type(five_points), intent(in) :: matrix
    type(line_factors), intent(in) :: factors
    real(pp), contiguous, intent(in) :: f(:, :)
    logical, intent(in) :: rising
    real(pp), contiguous, intent(inout) :: x(:, :)
    integer :: j, count

    count = size(x, 2)
    if (rising) then
      do j = 2, count - 1
        call solve_line(matrix, factors, j, f, x)
      end do
    else
      do j = count - 1, 2, -1
        call solve_line(matrix, factors, j, f, x)
      end do
    end if
  end subroutine sweep_lines

  pure subroutine solve_line(matrix, factors, j, f, x)
    type(five_points), intent(in) :: matrix
    type(line_factors), intent(in) :: factors
    integer, intent(in) :: j
    real(pp), contiguous, intent(in) :: f(:, :)
    real(pp), contiguous, intent(inout) :: x(:, :)
    real(pp) :: g(size(x, 1))
    real(pp) :: low, high
    integer :: i, k, n, middle

    n = size(x, 1)
    middle = n/2
    do i = 2, n - 1
      g(i) = (f(i, j) - matrix%before(i, j)*x(i, j - 1) - matrix%after(i, j)*x(i, j + 1))*factors%pivot(i, j)
    end do
    ! elimination from both ends: the upper half has one point more if n is odd
    low = 0
    high = 0
    if (mod(n, 2) == 1) high = g(n - 1)
    do k = 2, middle
      low = g(k) - factors%outward(k, j)*low
      g(k) = low
      i = n + 1 - k - mod(n, 2)
      high = g(i) - factors%outward(i, j)*high
      g(i) = high
    end do
    low = (g(middle) - factors%inward(middle, j)*g(middle + 1)) &
      /(1 - factors%inward(middle, j)*factors%inward(middle + 1, j))
    high = g(middle + 1) - factors%inward(middle + 1, j)*low
    x(middle, j) = low
    x(middle + 1, j) = high
    do k = middle - 1, 2, -1
      low = g(k) - factors%inward(k, j)*low
      x(k, j) = low
      i = 2*middle + 1 - k
      high = g(i) - factors%inward(i, j)*high
      x(i, j) = high
    end do
    if (mod(n, 2) == 1) x(n - 1, j) = g(n - 1) - factors%inward(n - 1, j)*high
  end subroutine solve_line

end module line_smoother
