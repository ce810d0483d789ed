!> Flow laws of an oil under shear: rate = F(tau) = g tau / eta, with g >= 1 the thinning of the law.
!>
!> Thinning is written as a function of the square of the stress, by which films shear in two directions
!> (Sharif, Kong, Evans and Snidle 2001, eqs 4-7). Two laws have a stress that the oil cannot exceed. From
!> half a per cent below it they are continued exponentially: there a body slips over its film, and the slip
!> follows the shear stress at its wall. Thinning then keeps a derivative. The stress passes the limit by half a
!> per cent where a body slips 500 times as fast as its film would shear at 0.995 of it, by one per cent at 100 000.
module pyworm_flow_laws
  use pyworm_kinds, only: wp
  use pyworm_thinning_table, only: tabulate_factors, tabulated_factor, thinning_table
  implicit none(type, external)
  private

  public :: flow_law, has_limit, hardens, slip_stress, stress_scales, thinning, thinning_by_stresses, stress_guess

  !> F = tau / eta
  integer, parameter, public :: law_newton = 0
  !> F = tau0/eta sinh(tau/tau0) (Eyring 1936)
  integer, parameter, public :: law_eyring = 1
  !> F = -tauL/eta ln(1 - tau/tauL) (Bair and Winer; Sharif et al., eq. 5)
  integer, parameter, public :: law_bair_winer = 2
  !> F = tau0/eta sinh(tau/tau0) tauL^(2 lambda) / (tauL^(2 lambda) - tau^(2 lambda)) (Sharif et al., eq. 6)
  integer, parameter, public :: law_eyring_limited = 3
  !> F = tau/eta [1 + (tau/G)^2]^((1/n - 1)/2) (Carreau's law by stress, as Bair and Habchi use it)
  integer, parameter, public :: law_carreau = 4
  !> F = g(tau/G) tau/eta by a table, without and with a limiting stress as that of law 3
  integer, parameter, public :: law_tabulated = 5, law_tabulated_limited = 6

  !> Fraction of the limit at which a wall slips (Sharif et al., text to fig. 4).
  real(wp), parameter :: slip_fraction = 0.995_wp
  !> Least limiting stress [Pa], since one proportional to pressure vanishes at ambient pressure.
  real(wp), parameter :: least_limit = 1e5_wp
  !> Largest exponents: beyond them thinning stays constant, so that a stray stress does not overflow.
  real(wp), parameter :: largest_eyring = 150.0_wp, largest_slip = 50.0_wp, largest_carreau = 1e30_wp
  !> Square of tau/tau0 below which Eyring's thinning is summed as a series.
  real(wp), parameter :: series_below = 1.0_wp
  !> Points of a block that use the same formula.
  integer, parameter :: block_points = 32
  !> Least square of tau/tauL where the slope by the square grows without bound toward rest.
  real(wp), parameter :: least_ratio = 1e-12_wp

  type :: flow_law
    integer :: law = law_newton
    !> tau0 of Eyring, or G of Carreau [Pa], at ambient pressure and reference temperature.
    real(wp) :: reference = 1
    !> Logarithmic growth of tau0 with pressure [1/Pa] and decay with the film's mean temperature [1/K].
    real(wp) :: reference_growth = 0, reference_decay = 0
    !> Limiting stress at ambient pressure [Pa] and its growth with pressure [-].
    real(wp) :: limit = 0, limit_growth = 0
    !> lambda of the limited law, or n of Carreau [-].
    real(wp) :: exponent = 1
    !> Stress, in fractions of that at slip, in which the rate grows e-fold beyond it. With a tenth of this, films that slip
    !> everywhere had no solution: the slipping wall depends on a gradient that Newton steps cannot resolve.
    real(wp) :: slip_step = 1e-3_wp
    !> Tables of the thinning g over (tau/G)^2, and of eta rate/tau over (eta rate/G)^2.
    type(thinning_table) :: by_stress, by_rate
  end type flow_law

contains

  !> Whether the law bounds the stress.
  elemental logical function has_limit(law)
    type(flow_law), intent(in) :: law

    has_limit = law%law == law_bair_winer .or. law%law == law_eyring_limited .or. law%law == law_tabulated_limited
  end function has_limit

  !> Whether a stress of the law depends on pressure.
  elemental logical function hardens(law)
    type(flow_law), intent(in) :: law

    hardens = law%law /= law_newton .and. abs(law%reference_growth) + abs(law%limit_growth) > 0
  end function hardens

  !> Stress [Pa] beyond which a wall slips, of an oil with limiting stress `limit` [Pa].
  elemental real(wp) function slip_stress(limit)
    real(wp), intent(in) :: limit

    slip_stress = slip_fraction*limit
  end function slip_stress

  !> Reference and limiting stress [Pa] at pressure `p` [Pa] and mean temperature `rise` [K] of the film above
  !> the reference temperature, with their derivatives by pressure [-].
  elemental subroutine stress_scales(law, p, rise, reference, reference_slope, limit, limit_slope)
    type(flow_law), intent(in) :: law
    real(wp), intent(in) :: p, rise
    real(wp), intent(out) :: reference, reference_slope, limit, limit_slope

    reference = law%reference*exp(law%reference_growth*p - law%reference_decay*rise)
    reference_slope = law%reference_growth*reference
    limit = max(law%limit + law%limit_growth*p, least_limit)
    limit_slope = merge(law%limit_growth, 0.0_wp, limit > least_limit)
  end subroutine stress_scales

  !> Thinning `g` [-] of `count` points and its derivative `slope` [1/Pa2] by the square of the stress, at
  !> `square` [Pa2]; `per_reference` and `per_limit` are 1/reference^2 and 1/limit^2 [1/Pa2], common to the levels
  !> of a film.
  pure subroutine thinning(law, count, square, per_reference, per_limit, g, slope)
    type(flow_law), intent(in) :: law
    integer, intent(in) :: count
    real(wp), intent(in) :: square(count), per_reference(count), per_limit(count)
    real(wp), intent(out) :: g(count), slope(count)
    integer :: i

    call thinning_below_slip(law, count, square, per_reference, per_limit, g, slope)
    if (.not. has_limit(law)) return
    do i = 1, count
      if (square(i)*per_limit(i) > slip_fraction**2) then
        call continue_slip(law, square(i), per_reference(i), per_limit(i), g(i), slope(i))
      end if
    end do
  end subroutine thinning

  !> Thinning of stresses below that at slip; beyond it the result is finite and unused.
  pure subroutine thinning_below_slip(law, count, square, per_reference, per_limit, g, slope)
    type(flow_law), intent(in) :: law
    integer, intent(in) :: count
    real(wp), intent(in) :: square(count), per_reference(count), per_limit(count)
    real(wp), intent(out) :: g(count), slope(count)

    select case (law%law)
    case (law_eyring)
      call eyring(count, square, per_reference, g, slope)
    case (law_bair_winer)
      call bair_winer(count, square, per_limit, g, slope)
    case (law_eyring_limited)
      call eyring(count, square, per_reference, g, slope)
      if (abs(law%exponent - 1) <= 0) then
        call limit_thinning(count, square, per_limit, g, slope)
      else
        call limit_thinning_by_power(law%exponent, count, square, per_limit, g, slope)
      end if
    case (law_carreau)
      call carreau((1/law%exponent - 1)/2, count, square, per_reference, g, slope)
    case (law_tabulated)
      call tabulate_factors(law%by_stress, count, square, per_reference, g, slope)
    case (law_tabulated_limited)
      call tabulate_factors(law%by_stress, count, square, per_reference, g, slope)
      call limit_thinning_by_power(law%exponent, count, square, per_limit, g, slope)
    case default
      g = 1
      slope = 0
    end select
  end subroutine thinning_below_slip

  !> g = sinh(x)/x at x^2 = square/reference^2.
  !>
  !> Neighbours in a film mostly lie on the same side of the end of the series, which is far cheaper.
  pure subroutine eyring(count, square, per_reference, g, slope)
    integer, intent(in) :: count
    real(wp), intent(in) :: square(count), per_reference(count)
    real(wp), intent(out) :: g(count), slope(count)
    integer :: first, last, near

    do first = 1, count, block_points
      last = min(first + block_points - 1, count)
      slope(first:last) = square(first:last)*per_reference(first:last)
      near = number_near_rest(last - first + 1, slope(first:last))
      if (near == last - first + 1) then
        call eyring_series(last - first + 1, per_reference(first:last), g(first:last), slope(first:last))
      else if (near == 0) then
        call eyring_closed(last - first + 1, per_reference(first:last), g(first:last), slope(first:last))
      else
        call eyring_mixed(last - first + 1, per_reference(first:last), g(first:last), slope(first:last))
      end if
    end do
  end subroutine eyring

  !> Evaluates points by the series.
  pure integer function number_near_rest(points, s)
    integer, intent(in) :: points
    real(wp), intent(in) :: s(points)

    number_near_rest = count(s < series_below)
  end function number_near_rest

  !> Evaluates thinning near rest; `slope` enters as square/reference^2.
  pure subroutine eyring_series(count, per_reference, g, slope)
    integer, intent(in) :: count
    real(wp), intent(in) :: per_reference(count)
    real(wp), intent(out) :: g(count)
    real(wp), intent(inout) :: slope(count)
    !> 1/(2 k + 1)!
    integer, parameter :: terms = 10
    integer :: i, k
    real(wp), parameter :: coefficient(0:terms) = [(1/gamma(2*k + 2.0_wp), k=0, terms)]
    real(wp) :: s, value, derivative

    do i = 1, count
      s = slope(i)
      value = coefficient(terms)
      derivative = 0
      do k = terms - 1, 0, -1
        derivative = value + s*derivative
        value = coefficient(k) + s*value
      end do
      g(i) = value
      slope(i) = derivative*per_reference(i)
    end do
  end subroutine eyring_series

  !> Evaluates thinning away from rest; `slope` enters as square/reference^2.
  pure subroutine eyring_closed(count, per_reference, g, slope)
    integer, intent(in) :: count
    real(wp), intent(in) :: per_reference(count)
    real(wp), intent(out) :: g(count)
    real(wp), intent(inout) :: slope(count)
    real(wp) :: s, x, growth, decay, per_x
    integer :: i

    do i = 1, count
      s = min(slope(i), largest_eyring**2)
      x = sqrt(s)
      growth = exp(x)
      ! one division for both reciprocals
      per_x = 1/(growth*x)
      decay = per_x*x
      per_x = per_x*growth
      g(i) = (growth - decay)*per_x/2
      ! a weight instead of a branch lets the loop be vectorised
      slope(i) = ((growth + decay)/2 - g(i))*per_x**2/2*per_reference(i)*merge(1.0_wp, 0.0_wp, slope(i) < largest_eyring**2)
    end do
  end subroutine eyring_closed

  !> Evaluates thinning on both sides of the end of the series; `slope` enters as square/reference^2.
  pure subroutine eyring_mixed(count, per_reference, g, slope)
    integer, intent(in) :: count
    real(wp), intent(in) :: per_reference(count)
    real(wp), intent(out) :: g(count)
    real(wp), intent(inout) :: slope(count)
    real(wp), dimension(block_points) :: small, g_near, slope_near
    integer :: i

    do i = 1, count
      small(i) = merge(1.0_wp, 0.0_wp, slope(i) < series_below)
      slope_near(i) = min(slope(i), series_below)
      slope(i) = max(slope(i), series_below)
    end do
    call eyring_series(count, per_reference, g_near, slope_near)
    call eyring_closed(count, per_reference, g, slope)
    do i = 1, count
      g(i) = small(i)*g_near(i) + (1 - small(i))*g(i)
      slope(i) = small(i)*slope_near(i) + (1 - small(i))*slope(i)
    end do
  end subroutine eyring_mixed

  !> Divides thinning by 1 - square/limit^2.
  pure subroutine limit_thinning(count, square, per_limit, g, slope)
    integer, intent(in) :: count
    real(wp), intent(in) :: square(count), per_limit(count)
    real(wp), intent(inout) :: g(count), slope(count)
    real(wp) :: excess
    integer :: i

    do i = 1, count
      excess = 1/(1 - min(square(i)*per_limit(i), slip_fraction**2))
      g(i) = g(i)*excess
      slope(i) = (slope(i) + g(i)*per_limit(i))*excess
    end do
  end subroutine limit_thinning

  !> Divides thinning by 1 - (square/limit^2)^power.
  pure subroutine limit_thinning_by_power(power, count, square, per_limit, g, slope)
    integer, intent(in) :: count
    real(wp), intent(in) :: power, square(count), per_limit(count)
    real(wp), intent(inout) :: g(count), slope(count)
    real(wp) :: ratio, lower_power, excess
    integer :: i

    do i = 1, count
      ratio = max(min(square(i)*per_limit(i), slip_fraction**2), least_ratio)
      lower_power = exp((power - 1)*log(ratio))
      excess = 1/(1 - lower_power*ratio)
      g(i) = g(i)*excess
      slope(i) = (slope(i) + g(i)*power*lower_power*per_limit(i))*excess
    end do
  end subroutine limit_thinning_by_power

  !> g = -ln(1 - x)/x at x^2 = square/limit^2.
  pure subroutine bair_winer(count, square, per_limit, g, slope)
    integer, intent(in) :: count
    real(wp), intent(in) :: square(count), per_limit(count)
    real(wp), intent(out) :: g(count), slope(count)
    !> Below it the slope is summed as a series.
    real(wp), parameter :: small = 1e-3_wp
    real(wp) :: x, rest, closed, series, near_rest
    integer :: i

    do i = 1, count
      x = sqrt(min(max(square(i)*per_limit(i), least_ratio), slip_fraction**2))
      ! the rounding of 1 - x cancels between logarithm and divisor
      rest = 1 - x
      g(i) = log(rest)/(rest - 1)
      closed = (1/rest - g(i))/x
      series = 1/2.0_wp + x*(2/3.0_wp + x*(3/4.0_wp + x*(4/5.0_wp + x*5/6)))
      near_rest = merge(1.0_wp, 0.0_wp, x < small)
      slope(i) = (near_rest*series + (1 - near_rest)*closed)/(2*x)*per_limit(i)
    end do
  end subroutine bair_winer

  !> g = (1 + square/reference^2)^power.
  pure subroutine carreau(power, count, square, per_reference, g, slope)
    integer, intent(in) :: count
    real(wp), intent(in) :: power, square(count), per_reference(count)
    real(wp), intent(out) :: g(count), slope(count)
    real(wp) :: s
    integer :: i

    do i = 1, count
      s = min(square(i)*per_reference(i), largest_carreau)
      g(i) = exp(power*log(1 + s))
      slope(i) = power*g(i)/(1 + s)*per_reference(i)*merge(1.0_wp, 0.0_wp, s < largest_carreau)
    end do
  end subroutine carreau

  !> Beyond the stress c at slip: F = F(c) + F'(c) l [exp((tau - c)/l) - 1].
  pure subroutine continue_slip(law, square, per_reference, per_limit, g, slope)
    type(flow_law), intent(in) :: law
    real(wp), intent(in) :: square, per_reference, per_limit
    real(wp), intent(out) :: g, slope
    real(wp) :: c, step, stress, stiffness, growth, g_c(1), slope_c(1)

    c = slip_fraction/sqrt(per_limit)
    call thinning_below_slip(law, 1, [c**2], [per_reference], [per_limit], g_c, slope_c)
    step = law%slip_step*c
    stress = min(sqrt(square), c + largest_slip*step)
    stiffness = g_c(1) + 2*c**2*slope_c(1)
    growth = exp((stress - c)/step)
    g = (g_c(1)*c + stiffness*step*(growth - 1))/stress
    slope = 0
    if (stress < c + largest_slip*step) slope = (stiffness*growth - g)/(2*stress**2)
  end subroutine continue_slip

  !> Derivatives [1/Pa] of thinning by the reference and the limiting stress, from `g` and `slope` of
  !> `thinning` there.
  !>
  !> Thinning depends on the ratios of the three stresses only, so that its derivatives obey Euler's relation.
  pure subroutine thinning_by_stresses(law, count, square, reference, limit, g, slope, by_reference, by_limit)
    type(flow_law), intent(in) :: law
    integer, intent(in) :: count
    real(wp), intent(in) :: square(count), reference(count), limit(count), g(count), slope(count)
    real(wp), intent(out) :: by_reference(count), by_limit(count)
    integer :: i

    by_reference = 0
    by_limit = 0
    select case (law%law)
    case (law_eyring, law_carreau, law_tabulated)
      by_reference = -2*square*slope/reference
    case (law_bair_winer)
      by_limit = -2*square*slope/limit
    case (law_eyring_limited, law_tabulated_limited)
      do i = 1, count
        by_limit(i) = max(min(square(i)/limit(i)**2, slip_fraction**2), least_ratio)
      end do
      if (abs(law%exponent - 1) > 0) by_limit = exp(law%exponent*log(by_limit))
      do i = 1, count
        by_reference(i) = -2*(square(i)*slope(i) - g(i)*law%exponent*by_limit(i)/(1 - by_limit(i)))/reference(i)
      end do
      if (any(square > slip_stress(limit)**2)) then
        do i = 1, count
          if (square(i) > slip_stress(limit(i))**2) then
            by_reference(i) = slip_by_reference(law, square(i), reference(i), limit(i))
          end if
        end do
      end if
      by_limit = -(2*square*slope + reference*by_reference)/limit
    case default
    end select
  end subroutine thinning_by_stresses

  !> Derivative [1/Pa] by the reference stress of the limited law's continuation.
  elemental real(wp) function slip_by_reference(law, square, reference, limit)
    type(flow_law), intent(in) :: law
    real(wp), intent(in) :: square, reference, limit
    real(wp) :: c, step, stress, x, ratio, excess, excess_slope, growth

    if (law%law == law_tabulated_limited) then
      slip_by_reference = slip_difference(law, square, reference, limit)
      return
    end if
    slip_by_reference = 0
    c = slip_stress(limit)
    x = c/reference
    if (x >= largest_eyring) return
    step = law%slip_step*c
    stress = min(sqrt(square), c + largest_slip*step)
    ratio = slip_fraction**(2*law%exponent)
    excess = 1/(1 - ratio)
    excess_slope = 2*law%exponent*ratio*excess**2/c
    growth = step*(exp((stress - c)/step) - 1)
    slip_by_reference = ((sinh(x) - x*cosh(x))*(excess + excess_slope*growth) - x*sinh(x)*excess*growth/reference)/stress
  end function slip_by_reference

  !> The same derivative of a law by a table, by differences.
  elemental real(wp) function slip_difference(law, square, reference, limit)
    type(flow_law), intent(in) :: law
    real(wp), intent(in) :: square, reference, limit
    real(wp), parameter :: part = 1e-5_wp
    real(wp) :: less, more, slope

    call continue_slip(law, square, 1/(reference*(1 - part))**2, 1/limit**2, less, slope)
    call continue_slip(law, square, 1/(reference*(1 + part))**2, 1/limit**2, more, slope)
    slip_difference = (more - less)/(2*part*reference)
  end function slip_difference

  !> Approximate stress [Pa], an initial guess, at which the law has the shear rate of a Newtonian oil at
  !> `newtonian` [Pa].
  elemental real(wp) function stress_guess(law, newtonian, reference, limit)
    type(flow_law), intent(in) :: law
    real(wp), intent(in) :: newtonian, reference, limit
    real(wp) :: factor, slope

    select case (law%law)
    case (law_eyring)
      stress_guess = reference*asinh(newtonian/reference)
    case (law_bair_winer)
      stress_guess = min(limit*(1 - exp(-newtonian/limit)), 0.95_wp*slip_stress(limit))
    case (law_eyring_limited)
      stress_guess = reference*asinh(newtonian/reference)
      stress_guess = min(stress_guess/sqrt(1 + (stress_guess/limit)**2), 0.95_wp*slip_stress(limit))
    case (law_carreau)
      stress_guess = newtonian*(1 + (newtonian/reference)**2)**((law%exponent - 1)/2)
    case (law_tabulated, law_tabulated_limited)
      call tabulated_factor(law%by_rate, (newtonian/reference)**2, factor, slope)
      stress_guess = newtonian/factor
      if (law%law == law_tabulated_limited) then
        stress_guess = min(stress_guess/sqrt(1 + (stress_guess/limit)**2), 0.95_wp*slip_stress(limit))
      end if
    case default
      stress_guess = newtonian
    end select
  end function stress_guess

end module pyworm_flow_laws
