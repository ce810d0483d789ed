!> Backward differences: exact for polynomials, blended where there are four times.
program test_contact_time
  use pyworm_contact_time, only: backward_weights
  use pyworm_kinds, only: wp
  use tap, only: close_to, done
  implicit none(type, external)
  real(wp), parameter :: times(4) = [2.0_wp, 1.7_wp, 1.1_wp, 0.4_wp]
  real(wp) :: third, second, first

  call close_to(sum(backward_weights(times(:2))*times(:2)), 1.0_wp, 1e-13_wp, "two times give the rate of a line")
  call close_to(sum(backward_weights(times(:3))*times(:3)**2), 4.0_wp, 1e-12_wp, "three that of a parabola")
  call close_to(sum(backward_weights(times)*times**2), 4.0_wp, 1e-12_wp, "four that of a parabola")
  ! d(t^3)/dt through three times is off by (t1 - t2)(t1 - t3)
  second = 12 - (times(1) - times(2))*(times(1) - times(3))
  third = sum(backward_weights(times)*times**3)
  call close_to(third, 0.48_wp*12 + 0.52_wp*second, 1e-12_wp, "and of a cubic that through four and through three, blended")
  first = sum(backward_weights([0.3_wp, 0.2_wp, 0.1_wp])*[3, -4, 1])
  call close_to(first, 26/0.2_wp, 1e-10_wp, "of equal steps (3 y1 - 4 y2 + y3)/(2 dt)")
  call done()
end program test_contact_time
