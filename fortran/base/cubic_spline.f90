!> The cubic spline through some points, with continuous third derivatives next to its ends ("not a knot"; de Boor, A Practical
!> Guide to Splines, 1978, chapter IV). Through three points it is a parabola, through two a line.
module pyworm_cubic_spline
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: spline_slopes, spline_coefficients, spline_value, monotone_slopes

contains

  !> Derivatives at the points of the spline through `y` at increasing `x`.
  pure function spline_slopes(x, y) result(slopes)
    real(wp), intent(in) :: x(:), y(:)
    real(wp) :: slopes(size(x))
    real(wp) :: h(size(x) - 1), chord(size(x) - 1), diagonal(size(x)), factor
    integer :: i, n

    n = size(x)
    h = x(2:) - x(:n - 1)
    chord = (y(2:) - y(:n - 1))/h
    if (n == 2) then
      slopes = chord(1)
      return
    else if (n == 3) then
      factor = (chord(2) - chord(1))/(x(3) - x(1))
      slopes = [chord(1) - factor*h(1), chord(1) + factor*h(1), chord(2) + factor*h(2)]
      return
    end if
    ! one tridiagonal system, solved downwards and back
    diagonal(1) = h(2)
    slopes(1) = ((h(1) + 2*(h(1) + h(2)))*h(2)*chord(1) + h(1)**2*chord(2))/(h(1) + h(2))
    do i = 2, n - 1
      factor = h(i)/diagonal(i - 1)
      diagonal(i) = 2*(h(i - 1) + h(i)) - factor*merge(h(1) + h(2), h(max(i - 2, 1)), i == 2)
      slopes(i) = 3*(h(i)*chord(i - 1) + h(i - 1)*chord(i)) - factor*slopes(i - 1)
    end do
    associate (before => h(n - 2), last => h(n - 1))
      factor = (before + last)/diagonal(n - 1)
      diagonal(n) = before - factor*before
      slopes(n) = (last**2*chord(n - 2) + (2*(before + last) + last)*before*chord(n - 1))/(before + last) &
        - factor*slopes(n - 1)
    end associate
    slopes(n) = slopes(n)/diagonal(n)
    do i = n - 1, 1, -1
      slopes(i) = (slopes(i) - merge(h(1) + h(2), h(max(i - 1, 1)), i == 1)*slopes(i + 1))/diagonal(i)
    end do
  end function spline_slopes

  !> Coefficients (power, cell) of the spline through `y` at points one apart, in powers of the distance from a cell's first one.
  pure function spline_coefficients(y) result(coefficients)
    real(wp), intent(in) :: y(:)
    real(wp) :: coefficients(4, size(y) - 1)
    real(wp) :: slopes(size(y))
    integer :: i

    slopes = spline_slopes([(real(i, wp), i=1, size(y))], y)
    do i = 1, size(y) - 1
      associate (rise => y(i + 1) - y(i), a => slopes(i), b => slopes(i + 1))
        coefficients(:, i) = [y(i), a, 3*rise - 2*a - b, a + b - 2*rise]
      end associate
    end do
  end function spline_coefficients

  !> Value at `place`, between the ends, of a spline through `y` at increasing `x`, from its slopes.
  pure real(wp) function spline_value(x, y, slopes, place)
    real(wp), intent(in) :: x(:), y(:), slopes(:), place
    real(wp) :: t, step, rise
    integer :: i

    i = cell_of(x, place)
    step = x(i + 1) - x(i)
    t = (place - x(i))/step
    rise = y(i + 1) - y(i)
    associate (a => step*slopes(i), b => step*slopes(i + 1))
      spline_value = y(i) + t*(a + t*(3*rise - 2*a - b + t*(a + b - 2*rise)))
    end associate
  end function spline_value

  !> Number of the cell between increasing points that holds a place, by bisection; the first or the last if none does.
  pure integer function cell_of(x, place)
    real(wp), intent(in) :: x(:), place
    integer :: last, middle

    cell_of = 1
    last = size(x)
    do while (last > cell_of + 1)
      middle = (cell_of + last)/2
      if (x(middle) <= place) then
        cell_of = middle
      else
        last = middle
      end if
    end do
  end function cell_of

  !> Derivatives at increasing `x` of the monotone cubics through `y` (Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984)
  !> 300).
  pure function monotone_slopes(x, y) result(slopes)
    real(wp), intent(in) :: x(:), y(:)
    real(wp) :: slopes(size(y))
    real(wp) :: h(size(y) - 1), chord(size(y) - 1)
    integer :: i, n

    n = size(y)
    h = x(2:) - x(:n - 1)
    chord = (y(2:) - y(:n - 1))/h
    slopes = 0
    do i = 2, n - 1
      if (one_way(chord(i - 1), chord(i))) slopes(i) = 3*(h(i - 1) + h(i)) &
        /((2*h(i) + h(i - 1))/chord(i - 1) + (h(i) + 2*h(i - 1))/chord(i))
    end do
    slopes(1) = end_slope(h(1), h(2), chord(1), chord(2))
    slopes(n) = end_slope(h(n - 1), h(n - 2), chord(n - 1), chord(n - 2))
  end function monotone_slopes

  !> Derivative at the end of the first of two cells, from their widths and chords.
  pure real(wp) function end_slope(width, next_width, first, second)
    real(wp), intent(in) :: width, next_width, first, second

    end_slope = ((2*width + next_width)*first - width*second)/(width + next_width)
    if (.not. one_way(end_slope, first)) then
      end_slope = 0
    else if (.not. one_way(first, second) .and. abs(end_slope) > 3*abs(first)) then
      end_slope = 3*first
    end if
  end function end_slope

  !> Whether both rise or both fall.
  elemental logical function one_way(a, b)
    real(wp), intent(in) :: a, b

    one_way = (a > 0 .and. b > 0) .or. (a < 0 .and. b < 0)
  end function one_way

end module pyworm_cubic_spline
