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
    real(wp) :: place, t, by_place, logarithm, bounded
    integer :: i

    bounded = min(s, largest_square)
    place = log(1 + bounded)*table%per_log
    i = min(int(place), size(table%coefficient, 2) - 1)
    t = min(place - i, 1.0_wp)
    associate (c => table%coefficient(:, i + 1))
      by_place = c(2) + t*(2*c(3) + t*3*c(4))
      logarithm = c(1) + t*(c(2) + t*(c(3) + t*c(4))) + by_place*(place - i - t)
    end associate
    f = exp(min(logarithm, largest_log))
    slope = 0
    if (logarithm < largest_log .and. s < largest_square) slope = f*by_place*table%per_log/(1 + bounded)
  end subroutine tabulated_factor

  !> The same at `count` squares times `scale`, the derivative by the square.
  pure subroutine tabulate_factors(table, count, square, scale, f, slope)
    type(thinning_table), intent(in) :: table
    integer, intent(in) :: count
    real(wp), intent(in) :: square(count), scale(count)
    real(wp), intent(out) :: f(count), slope(count)
    integer :: m

    do m = 1, count
      call tabulated_factor(table, square(m)*scale(m), f(m), slope(m))
      slope(m) = slope(m)*scale(m)
    end do
  end subroutine tabulate_factors

end module pyworm_thinning_table
