!> A function of the square of a stress ratio by a table: ln f is a cubic spline of ln(1 + s).
!>
!> Beyond the table f continues as a power of 1 + s.
module pyworm_thinning_table
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: thinning_table, tabulated_factor, tabulate_factors

  !> Largest square of the ratio, and largest logarithm of the factor: a stray stress does not overflow.
  real(wp), parameter :: largest_square = 1e60_wp, largest_log = 300.0_wp

  !> Points of a block, whose intermediates stay near the processor.
  integer, parameter :: block_points = 32

  type :: thinning_table
    !> Cells for each unit of ln(1 + s).
    real(wp) :: per_log = 1
    !> Coefficients of powers within a cell: (power, cell).
    real(wp), allocatable :: coefficient(:, :)
  end type thinning_table

contains

  !> Factor `f` [-] at the square `s` of a ratio, and its derivative by `s`.
  elemental subroutine tabulated_factor(table, s, f, slope)
    type(thinning_table), intent(in) :: table
    real(wp), intent(in) :: s
    real(wp), intent(out) :: f, slope
    real(wp) :: factor(1), by_square(1)

    call tabulate_factors(table, 1, [s], [1.0_wp], factor, by_square)
    f = factor(1)
    slope = by_square(1)
  end subroutine tabulated_factor

  !> The same at `count` squares times `scale`, the derivative by the square.
  pure subroutine tabulate_factors(table, count, square, scale, f, slope)
    type(thinning_table), intent(in) :: table
    integer, intent(in) :: count
    real(wp), intent(in) :: square(count), scale(count)
    real(wp), intent(out) :: f(count), slope(count)
    integer :: first, last

    do first = 1, count, block_points
      last = min(first + block_points - 1, count)
      call tabulate_block(size(table%coefficient, 2), table%coefficient, table%per_log, last - first + 1, square(first:last), &
        scale(first:last), f(first:last), slope(first:last))
    end do
  end subroutine tabulate_factors

  !> The same of a block. Logarithms and exponentials have loops of their own, which are vectorised: beside the look-up,
  !> or with branches, they would be scalar calls.
  pure subroutine tabulate_block(cells, coefficient, per_log, count, square, scale, f, slope)
    integer, intent(in) :: cells, count
    real(wp), intent(in) :: coefficient(4, cells), per_log, square(count), scale(count)
    real(wp), intent(out) :: f(count), slope(count)
    real(wp) :: place(block_points), t, beyond
    integer :: i, m

    do m = 1, count
      place(m) = log(1 + min(square(m)*scale(m), largest_square))*per_log
    end do
    do m = 1, count
      i = min(int(place(m)), cells - 1)
      t = min(place(m) - i, 1.0_wp)
      beyond = place(m) - i - t
      i = i + 1
      slope(m) = coefficient(2, i) + t*(2*coefficient(3, i) + t*3*coefficient(4, i))
      f(m) = coefficient(1, i) + t*(coefficient(2, i) + t*(coefficient(3, i) + t*coefficient(4, i))) + slope(m)*beyond
    end do
    do m = 1, count
      ! a weight instead of a branch
      slope(m) = slope(m)*per_log*scale(m)/(1 + min(square(m)*scale(m), largest_square)) &
        *merge(1.0_wp, 0.0_wp, f(m) < largest_log)*merge(1.0_wp, 0.0_wp, square(m)*scale(m) < largest_square)
      f(m) = exp(min(f(m), largest_log))
      slope(m) = slope(m)*f(m)
    end do
  end subroutine tabulate_block

end module pyworm_thinning_table
