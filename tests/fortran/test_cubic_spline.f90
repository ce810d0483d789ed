!> Splines: cubics are reproduced to their ends, few points give lower orders, monotone cubics do not overshoot.
program test_cubic_spline
  use pyworm_cubic_spline, only: monotone_slopes, spline_coefficients, spline_slopes, spline_value
  use pyworm_kinds, only: wp
  use tap, only: check, close_to, done
  implicit none(type, external)
  real(wp), parameter :: x(6) = [0.0_wp, 0.4_wp, 1.1_wp, 1.5_wp, 2.6_wp, 3.0_wp]
  real(wp) :: y(6), slopes(6), c(4, 5)
  integer :: n

  y = cubic(x)
  do n = 4, 6
    call close_to(maxval(abs(spline_slopes(x(:n), y(:n)) - slope(x(:n)))), 0.0_wp, 1e-13_wp, "slopes of a cubic are its own")
  end do
  slopes = spline_slopes(x, y)
  call close_to(spline_value(x, y, slopes, 2.0_wp), cubic(2.0_wp), 1e-13_wp, "and its values between the points")
  call close_to(spline_value(x, y, slopes, 3.0_wp), cubic(3.0_wp), 1e-13_wp, "and at the last one")
  call close_to(maxval(abs(spline_slopes(x(:3), x(:3)**2) - 2*x(:3))), 0.0_wp, 1e-13_wp, "three points make a parabola")
  call close_to(maxval(abs(spline_slopes(x(:2), 3*x(:2)) - 3)), 0.0_wp, 1e-13_wp, "two a line")
  c = spline_coefficients(cubic([0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp, 4.0_wp, 5.0_wp]))
  call close_to(sum(c(:, 3)*0.5_wp**[0, 1, 2, 3]), cubic(2.5_wp), 1e-12_wp, "cells have the powers of a cubic")

  slopes = monotone_slopes(2*[0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp, 4.0_wp, 5.0_wp], [0.0_wp, 0.0_wp, 1.0_wp, 3.0_wp, 3.0_wp, 2.0_wp])
  call close_to(maxval(abs(slopes([1, 2, 4, 5]))), 0.0_wp, 0.0_wp, "monotone cubics are level where values stand still or turn")
  call close_to(slopes(3), 2/3.0_wp, 1e-15_wp, "else they have the harmonic mean of both chords")
  call check(slopes(6) < 0, "and fall towards an end that falls")
  call done()

contains

  elemental real(wp) function cubic(t)
    real(wp), intent(in) :: t

    cubic = 1 - 2*t + 0.3_wp*t**2 + 0.7_wp*t**3
  end function cubic

  elemental real(wp) function slope(t)
    real(wp), intent(in) :: t

    slope = -2 + 0.6_wp*t + 2.1_wp*t**2
  end function slope

end program test_cubic_spline
