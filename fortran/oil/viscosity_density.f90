!> Viscosity and density of an oil against pressure and temperature, with their derivatives.
module pyworm_viscosity_density
  use pyworm_kinds, only: wp
  use pyworm_property_table, only: property_table, tabulate_row, tabulated, tabulated_cold
  implicit none(type, external)
  private

  public :: oil_law, viscosity, viscosities, density, densities, hot_fluidity, hot_density, density_by_rise, expansivity

  !> eta = eta0 exp(alpha p) (Barus 1893)
  integer, parameter, public :: law_barus = 1
  !> eta = eta0 exp{(ln eta0 + 9.67) [(1 + p/p0)^z - 1]} (Roelands 1966)
  integer, parameter, public :: law_roelands = 2
  !> ln(eta/eta0) by a table over pressure and temperature
  integer, parameter, public :: law_tabulated = 3

  !> Minus the logarithm of the viscosity [Pa s] where Roelands' isotherms meet.
  real(wp), parameter :: roelands_pole_log = 9.67_wp
  !> Largest exponent, far beyond the solid state, so that a stray Newton step does not overflow.
  real(wp), parameter :: largest_exponent = 200.0_wp
  !> Temperature [K] where Roelands' oils solidify, and the least distance from it [K].
  real(wp), parameter :: roelands_pole_temperature = 138.0_wp, least_distance = 10.0_wp

  type :: oil_law
    integer :: law = law_barus
    !> Viscosity at ambient pressure [Pa s].
    real(wp) :: eta0 = 0
    !> alpha [1/Pa] of Barus, or z [-] of Roelands.
    real(wp) :: exponent = 0
    !> Pole pressure of Roelands [Pa].
    real(wp) :: pole_pressure = 1
    !> Coefficients [1/Pa] of rho/rho0 = 1 + d1 p / (1 + d2 p) (Dowson and Higginson 1966).
    real(wp) :: d1 = 0, d2 = 0
    !> Temperature [K] at which the viscosity and the density at ambient pressure are given.
    real(wp) :: temperature = 313.15_wp
    !> beta [1/K] of eta = eta0 exp(alpha p - beta (T - T0)), or s0 [-] of Roelands.
    real(wp) :: thermal_exponent = 0
    !> Expansivity at ambient pressure [1/K], and its logarithmic decay with pressure [1/Pa].
    real(wp) :: expansivity = 0, expansivity_decay = 0
    !> Tables of ln(eta/eta0), and of rho over that at ambient pressure and the oil's temperature in place of the laws.
    type(property_table), allocatable :: viscosity_table, density_table
  end type oil_law

contains

  !> Viscosity `eta` [Pa s] at pressure `p` [Pa] and its logarithmic derivative `slope` [1/Pa].
  elemental subroutine viscosity(oil, p, eta, slope)
    type(oil_law), intent(in) :: oil
    real(wp), intent(in) :: p
    real(wp), intent(out) :: eta, slope
    real(wp) :: rise, growth

    if (oil%law == law_barus) then
      rise = oil%exponent*p
      slope = oil%exponent
    else if (oil%law == law_tabulated) then
      call tabulated_cold(oil%viscosity_table, p, rise, slope)
    else
      growth = exp(oil%exponent*log(1 + p/oil%pole_pressure))*(log(oil%eta0) + roelands_pole_log)
      rise = growth - (log(oil%eta0) + roelands_pole_log)
      slope = oil%exponent*growth/(oil%pole_pressure + p)
    end if
    eta = oil%eta0*exp(min(rise, largest_exponent))
    if (rise > largest_exponent) slope = 0
  end subroutine viscosity

  !> Fluidity 1/eta [1/(Pa s)] of points at pressure `p` [Pa] and, at several levels (second index), `rise`
  !> [K] above the oil's temperature, with its logarithmic derivatives by pressure [1/Pa] and by temperature
  !> [1/K].
  !>
  !> Roelands: eta = eta0 exp{(ln eta0 + 9.67) [(1 + p/p0)^z ((T - 138)/(T0 - 138))^(-s0) - 1]} (Sharif, Kong,
  !> Evans and Snidle 2001, eq. 20).
  pure subroutine hot_fluidity(oil, p, rise, fluidity, by_pressure, by_temperature)
    type(oil_law), intent(in) :: oil
    real(wp), contiguous, intent(in) :: p(:), rise(:, :)
    real(wp), contiguous, intent(out) :: fluidity(:, :), by_pressure(:, :), by_temperature(:, :)
    real(wp) :: pole, span, distance, growth, exponent, within
    integer :: i, k, last

    if (oil%law == law_barus) then
      do k = 1, size(rise, 2)
        do i = 1, size(p)
          exponent = oil%exponent*p(i) - oil%thermal_exponent*rise(i, k)
          within = merge(1.0_wp, 0.0_wp, abs(exponent) < largest_exponent)
          fluidity(i, k) = exp(-max(min(exponent, largest_exponent), -largest_exponent))/oil%eta0
          by_pressure(i, k) = -oil%exponent*within
          by_temperature(i, k) = oil%thermal_exponent*within
        end do
      end do
      return
    end if
    if (oil%law == law_tabulated) then
      call tabulated_fluidity(oil, p, rise, fluidity, by_pressure, by_temperature)
      return
    end if
    pole = log(oil%eta0) + roelands_pole_log
    span = oil%temperature - roelands_pole_temperature
    last = size(rise, 2)
    ! growth with pressure, once for each point
    do i = 1, size(p)
      by_pressure(i, last) = pole*exp(oil%exponent*log(1 + p(i)/oil%pole_pressure))
    end do
    do k = 1, last
      do i = 1, size(p)
        distance = max(span + rise(i, k), least_distance)
        growth = by_pressure(i, last)*exp(-oil%thermal_exponent*log(distance/span))
        exponent = growth - pole
        within = merge(1.0_wp, 0.0_wp, exponent < largest_exponent)
        fluidity(i, k) = exp(-min(exponent, largest_exponent))/oil%eta0
        by_pressure(i, k) = -oil%exponent*growth/(oil%pole_pressure + p(i))*within
        by_temperature(i, k) = oil%thermal_exponent*growth/distance*within &
          *merge(1.0_wp, 0.0_wp, span + rise(i, k) > least_distance)
      end do
    end do
  end subroutine hot_fluidity

  !> The same by a table.
  pure subroutine tabulated_fluidity(oil, p, rise, fluidity, by_pressure, by_temperature)
    type(oil_law), intent(in) :: oil
    real(wp), contiguous, intent(in) :: p(:), rise(:, :)
    real(wp), contiguous, intent(out) :: fluidity(:, :), by_pressure(:, :), by_temperature(:, :)
    real(wp) :: within
    integer :: i, k

    do k = 1, size(rise, 2)
      call tabulate_row(oil%viscosity_table, size(p), p, rise(:, k), fluidity(:, k), by_pressure(:, k), by_temperature(:, k))
      do i = 1, size(p)
        within = merge(-1.0_wp, 0.0_wp, fluidity(i, k) < largest_exponent)
        fluidity(i, k) = exp(-min(fluidity(i, k), largest_exponent))/oil%eta0
        by_pressure(i, k) = by_pressure(i, k)*within
        by_temperature(i, k) = by_temperature(i, k)*within
      end do
    end do
  end subroutine tabulated_fluidity

  !> Evaluates the law over a row of pressures; inlined here, the loop is vectorised.
  pure subroutine viscosities(oil, p, eta, slope)
    type(oil_law), intent(in) :: oil
    real(wp), contiguous, intent(in) :: p(:)
    real(wp), intent(out) :: eta(size(p)), slope(size(p))
    integer :: i

    do i = 1, size(p)
      call viscosity(oil, p(i), eta(i), slope(i))
    end do
  end subroutine viscosities

  !> Density over that at ambient pressure, `rho` [-], at `p` [Pa] and its derivative `slope` [1/Pa].
  elemental subroutine density(oil, p, rho, slope)
    type(oil_law), intent(in) :: oil
    real(wp), intent(in) :: p
    real(wp), intent(out) :: rho, slope

    if (allocated(oil%density_table)) then
      call tabulated_cold(oil%density_table, p, rho, slope)
      return
    end if
    rho = 1 + oil%d1*p/(1 + oil%d2*p)
    slope = oil%d1/(1 + oil%d2*p)**2
  end subroutine density

  !> Expansivity [1/K] at pressure `p` [Pa].
  elemental real(wp) function expansivity(oil, p)
    type(oil_law), intent(in) :: oil
    real(wp), intent(in) :: p
    real(wp) :: rho, by_pressure, by_rise

    if (allocated(oil%density_table)) then
      call tabulated(oil%density_table, p, 0.0_wp, rho, by_pressure, by_rise)
      expansivity = -by_rise/rho
      return
    end if
    expansivity = oil%expansivity*exp(-oil%expansivity_decay*p)
  end function expansivity

  !> Density over that at ambient pressure and the oil's temperature, `rho` [-], at `p` [Pa] and `rise` [K]
  !> above that temperature, and its derivative `slope` [1/Pa] by pressure (Sharif et al. 2001, appendix).
  elemental subroutine hot_density(oil, p, rise, rho, slope)
    type(oil_law), intent(in) :: oil
    real(wp), intent(in) :: p, rise
    real(wp), intent(out) :: rho, slope
    real(wp) :: cold, cold_slope, expansion

    if (allocated(oil%density_table)) then
      call tabulated(oil%density_table, p, rise, rho, slope, expansion)
      return
    end if
    call density(oil, p, cold, cold_slope)
    expansion = expansivity(oil, p)*rise
    rho = cold*(1 - expansion)
    slope = cold_slope*(1 - expansion) + cold*expansion*oil%expansivity_decay
  end subroutine hot_density

  !> Derivative of the density of `hot_density` by `rise` [1/K].
  elemental real(wp) function density_by_rise(oil, p, rise)
    type(oil_law), intent(in) :: oil
    real(wp), intent(in) :: p, rise
    real(wp) :: rho, slope

    if (allocated(oil%density_table)) then
      call tabulated(oil%density_table, p, rise, rho, slope, density_by_rise)
      return
    end if
    call density(oil, p, rho, slope)
    density_by_rise = -rho*expansivity(oil, p)
  end function density_by_rise

  !> The same over a row of pressures.
  pure subroutine densities(oil, p, rho, slope)
    type(oil_law), intent(in) :: oil
    real(wp), contiguous, intent(in) :: p(:)
    real(wp), intent(out) :: rho(size(p)), slope(size(p))
    integer :: i

    do i = 1, size(p)
      call density(oil, p(i), rho(i), slope(i))
    end do
  end subroutine densities

end module pyworm_viscosity_density
