!> Line Gauss-Seidel: each line of a field is solved as a whole with its two neighbours fixed.
!>
!> Each tridiagonal system is factored beforehand from both ends towards its middle, so that a line has
!> two independent recurrences and no divisions. Of the matrix only the couplings between lines are stored.
module pyworm_line_relaxation
  use pyworm_kinds, only: pp
  use pyworm_status, only: status_ok, status_no_memory
  implicit none(type, external)
  private

  public :: line_systems, new_line_systems, factor_line, relax_line, relax_first

  !> The lines of a field, which run along its first index; (length, count). Points of the outline are
  !> unchanged.
  type :: line_systems
    !> Couplings of a point to the lines before and after.
    real(pp), allocatable :: before(:, :), after(:, :)
    !> Factors: reciprocal pivot, coupling to the point eliminated before, coupling to that solved before.
    real(pp), allocatable :: pivot(:, :), outward(:, :), inward(:, :)
    !> Workspace of one line.
    real(pp), allocatable :: work(:)
  end type line_systems

contains

  !> Allocates `count` lines of `length` points.
  subroutine new_line_systems(length, count, self, stat)
    integer, intent(in) :: length, count
    type(line_systems), intent(out) :: self
    integer, intent(out) :: stat
    integer :: err

    allocate (self%before(length, count), self%after(length, count), self%pivot(length, count), &
      self%outward(length, count), self%inward(length, count), self%work(length), source=0.0_pp, stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
  end subroutine new_line_systems

  !> Factors line j from its coefficients; where `free` is 0 its solution will be zero, else `free` is 1.
  !>
  !> It is zero too where the diagonal vanishes in the elimination, as for two points without flow to any other: no
  !> pressure there balances the inflow.
  pure subroutine factor_line(self, j, centre, left, right, free)
    type(line_systems), intent(inout) :: self
    integer, intent(in) :: j
    real(pp), contiguous, intent(in) :: centre(:), left(:), right(:), free(:)
    integer :: i, n, middle

    n = size(centre)
    middle = n/2
    associate (pivot => self%pivot(:, j), outward => self%outward(:, j), inward => self%inward(:, j))
      do i = 2, middle
        pivot(i) = reciprocal(free(i), centre(i) - left(i)*inward(i - 1), centre(i))
        outward(i) = left(i)*pivot(i)
        inward(i) = right(i)*pivot(i)
      end do
      do i = n - 1, middle + 1, -1
        pivot(i) = reciprocal(free(i), centre(i) - right(i)*inward(i + 1), centre(i))
        outward(i) = right(i)*pivot(i)
        inward(i) = left(i)*pivot(i)
      end do
      ! two such points where both recurrences meet are solved independently
      if (.not. abs(1 - inward(middle)*inward(middle + 1)) > epsilon(1.0_pp)) inward(middle + 1) = 0
    end associate
  end subroutine factor_line

  !> free/rest, or 0 where the rest of the diagonal is lost in its rounding.
  elemental real(pp) function reciprocal(free, rest, diagonal)
    real(pp), intent(in) :: free, rest, diagonal

    reciprocal = 0
    if (abs(rest) > epsilon(1.0_pp)*abs(diagonal)) reciprocal = free/rest
  end function reciprocal

  !> Solves line j of x for the right-hand side f against both its neighbours.
  pure subroutine relax_line(self, j, f, x)
    type(line_systems), intent(inout) :: self
    integer, intent(in) :: j
    real(pp), contiguous, intent(in) :: f(:, :)
    real(pp), contiguous, intent(inout) :: x(:, :)
    integer :: i

    do i = 2, size(x, 1) - 1
      self%work(i) = (f(i, j) - self%before(i, j)*x(i, j - 1) - self%after(i, j)*x(i, j + 1))*self%pivot(i, j)
    end do
    call substitute(self%outward(:, j), self%inward(:, j), self%work, x(:, j))
  end subroutine relax_line

  !> Solves line j in the first sweep from zero, with the neighbour already solved only: the line before when
  !> `rising`.
  pure subroutine relax_first(self, j, rising, f, x)
    type(line_systems), intent(inout) :: self
    integer, intent(in) :: j
    logical, intent(in) :: rising
    real(pp), contiguous, intent(in) :: f(:, :)
    real(pp), contiguous, intent(inout) :: x(:, :)
    integer :: i

    if (rising) then
      do i = 2, size(x, 1) - 1
        self%work(i) = (f(i, j) - self%before(i, j)*x(i, j - 1))*self%pivot(i, j)
      end do
    else
      do i = 2, size(x, 1) - 1
        self%work(i) = (f(i, j) - self%after(i, j)*x(i, j + 1))*self%pivot(i, j)
      end do
    end if
    call substitute(self%outward(:, j), self%inward(:, j), self%work, x(:, j))
  end subroutine relax_first

  !> Solves a factored line whose right-hand side g is already divided by the pivots; g is overwritten.
  pure subroutine substitute(outward, inward, g, x)
    real(pp), contiguous, intent(in) :: outward(:), inward(:)
    real(pp), contiguous, intent(inout) :: g(:), x(:)
    real(pp) :: low, high
    integer :: i, k, n, middle

    n = size(x)
    middle = n/2
    ! elimination from both ends: the upper half has one point more if n is odd
    low = 0
    high = 0
    if (mod(n, 2) == 1) high = g(n - 1)
    do k = 2, middle
      low = g(k) - outward(k)*low
      g(k) = low
      i = n + 1 - k - mod(n, 2)
      high = g(i) - outward(i)*high
      g(i) = high
    end do
    low = (g(middle) - inward(middle)*g(middle + 1))/(1 - inward(middle)*inward(middle + 1))
    high = g(middle + 1) - inward(middle + 1)*low
    x(middle) = low
    x(middle + 1) = high
    do k = middle - 1, 2, -1
      low = g(k) - inward(k)*low
      x(k) = low
      i = 2*middle + 1 - k
      high = g(i) - inward(i)*high
      x(i) = high
    end do
    if (mod(n, 2) == 1) x(n - 1) = g(n - 1) - inward(n - 1)*high
  end subroutine substitute

end module pyworm_line_relaxation
