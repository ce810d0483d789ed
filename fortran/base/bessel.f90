!> Modified Bessel functions of the second kind.
module pyworm_bessel
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: scaled_bessel_k

contains

  !> exp(x) K0(x) and exp(x) K1(x), x > 0.
  !>
  !> K_n(x) = int exp(-x cosh t) cosh(n t) dt from 0 to infinity (Abramowitz and Stegun 1964, eq. 9.6.24), an even
  !> integrand that is analytic and decays doubly exponentially: the trapezoidal rule is exact to rounding with some 15
  !> points, or 70 where x is tiny (Trefethen and Weideman 2014).
  elemental subroutine scaled_bessel_k(x, k0, k1)
    real(wp), intent(in) :: x
    real(wp), intent(out) :: k0, k1
    !> Largest step; step over the integrand's width where that is a narrow Gaussian; exponent at which the sum ends.
    real(wp), parameter :: widest = 0.25_wp, narrow = 0.7_wp, last = 42
    real(wp) :: step, decay, hyperbolic, part
    integer :: i

    step = min(widest, narrow/sqrt(x))
    k0 = 0.5_wp
    k1 = 0.5_wp
    i = 0
    do
      i = i + 1
      ! cosh t - 1 without loss of digits
      hyperbolic = 2*sinh(i*step/2)**2
      decay = x*hyperbolic
      if (decay > last) exit
      part = exp(-decay)
      k0 = k0 + part
      k1 = k1 + part*(1 + hyperbolic)
    end do
    k0 = k0*step
    k1 = k1*step
  end subroutine scaled_bessel_k

end module pyworm_bessel
