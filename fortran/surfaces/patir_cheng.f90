!> Flow factors of Patir and Cheng (J. Lubr. Technol. 100 (1978) 12 and 101 (1979) 220): oil between rough surfaces against oil
!> between their mean planes.
!>
!> Their fits hold to a gap of 4 times the roughness; from 5 on the asymptotes of second order hold (Tripp, J. Lubr. Technol. 105
!> (1983) 458). The same as `pyworm/formulas/flow_factors.py`.
module pyworm_patir_cheng
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: pressure_flow_factor, shear_flow_factor, open_gap, overlap

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Aspects of the tables: correlation length along the flow over that across it.
  real(wp), parameter :: aspects(7) = [1/9.0_wp, 1/6.0_wp, 1/3.0_wp, 1.0_wp, 3.0_wp, 6.0_wp, 9.0_wp]
  !> C and r of 1 - C exp(-r H), of aspects above 1 of 1 + C H^-r (1978, table 1).
  real(wp), parameter :: factor(7) = [1.48_wp, 1.38_wp, 1.18_wp, 0.90_wp, 0.225_wp, 0.520_wp, 0.870_wp]
  real(wp), parameter :: rate(7) = [0.42_wp, 0.42_wp, 0.42_wp, 0.56_wp, 1.5_wp, 1.5_wp, 1.5_wp]
  !> A1, a1, a2 and a3 of A1 H^a1 exp(-a2 H + a3 H^2) (1979, table 2, not seen in print).
  real(wp), parameter :: size_1(7) = [2.046_wp, 1.962_wp, 1.858_wp, 1.899_wp, 1.560_wp, 1.290_wp, 1.011_wp]
  real(wp), parameter :: power(7) = [1.12_wp, 1.08_wp, 1.01_wp, 0.98_wp, 0.85_wp, 0.62_wp, 0.54_wp]
  real(wp), parameter :: decay(7) = [0.78_wp, 0.77_wp, 0.76_wp, 0.92_wp, 1.13_wp, 1.09_wp, 1.07_wp]
  real(wp), parameter :: bend(7) = [0.03_wp, 0.03_wp, 0.03_wp, 0.05_wp, 0.08_wp, 0.08_wp, 0.08_wp]
  !> Gaps over roughness up to which the fits, from which the asymptotes, and below which constants hold.
  real(wp), parameter :: fitted = 4, asymptotic = 5, least_fitted = 0.5_wp

contains

  !> Pressure flow factor [-] at a gap over the roughness, at least zero.
  pure real(wp) function pressure_flow_factor(gap, aspect)
    real(wp), intent(in) :: gap, aspect
    real(wp) :: fits(7), asymptote

    fits = merge(1 + factor*max(gap, least_fitted)**(-rate), 1 - factor*exp(-rate*max(gap, 0.0_wp)), aspects > 1)
    asymptote = 1 + 3*(1 - 3/(1 + aspect))/max(gap, fitted)**2
    pressure_flow_factor = max(blend(gap, between(fits, aspect), asymptote), 0.0_wp)
  end function pressure_flow_factor

  !> Shear flow factor [-] of a rough surface against a smooth one; below the fits the same part of the mean thickness.
  pure real(wp) function shear_flow_factor(gap, aspect)
    real(wp), intent(in) :: gap, aspect
    real(wp) :: fits(7), near, part, asymptote

    near = min(max(gap, least_fitted), asymptotic)
    fits = size_1*near**power*exp(-decay*near + bend*near**2)
    part = open_gap(min(gap, least_fitted))/open_gap(least_fitted)
    asymptote = 3/((1 + aspect)*max(gap, fitted))
    shear_flow_factor = part*blend(gap, between(fits, aspect), asymptote)
  end function shear_flow_factor

  !> Mean thickness of the gap over the roughness [-], where surfaces of normal heights overlap nowhere.
  pure real(wp) function open_gap(gap)
    real(wp), intent(in) :: gap

    open_gap = max(gap*overlap(-gap) + exp(-gap**2/2)/sqrt(2*pi), 0.0_wp)
  end function open_gap

  !> Share of normal heights above a gap over the roughness.
  pure real(wp) function overlap(gap)
    real(wp), intent(in) :: gap

    overlap = erfc(gap/sqrt(2.0_wp))/2
  end function overlap

  !> Value at an aspect from those of the tables, linear in its logarithm; the nearest beyond them.
  pure real(wp) function between(fits, aspect)
    real(wp), intent(in) :: fits(7), aspect
    real(wp) :: part
    integer :: k

    k = min(max(count(aspects <= aspect), 1), 6)
    part = min(max(log(aspect/aspects(k))/log(aspects(k + 1)/aspects(k)), 0.0_wp), 1.0_wp)
    between = (1 - part)*fits(k) + part*fits(k + 1)
  end function between

  !> Fit and asymptote, blended between the gaps up to which the one and from which the other holds.
  pure real(wp) function blend(gap, fit, asymptote)
    real(wp), intent(in) :: gap, fit, asymptote
    real(wp) :: part

    part = min(max((gap - fitted)/(asymptotic - fitted), 0.0_wp), 1.0_wp)
    part = part**2*(3 - 2*part)
    blend = (1 - part)*fit + part*asymptote
  end function blend

end module pyworm_patir_cheng
