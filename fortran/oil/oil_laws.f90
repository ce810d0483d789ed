!> Viscosity and density of an oil against pressure, with their derivatives.
module oil_laws
  use kinds, only: wp
  implicit none(type, external)
  private

  public :: oil_law, viscosity, viscosities, density, densities

  !> eta = eta0 exp(alpha p) (Barus 1893)
  integer, parameter, public :: law_barus = 1
  !> eta = eta0 exp{(ln eta0 + 9.67) [(1 + p/p0)^z - 1]} (Roelands 1966)
  integer, parameter, public :: law_roelands = 2

  !> Minus the logarithm of the viscosity [Pa s] where Roelands' isotherms meet.
  real(wp), parameter :: roelands_pole_log = 9.67_wp
  !> Largest exponent: beyond it an oil is a solid by any measure, and a Newton step that strays there
  !> must not overflow.
  real(wp), parameter :: largest_exponent = 200.0_wp

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
    else
      growth = exp(oil%exponent*log(1 + p/oil%pole_pressure))*(log(oil%eta0) + roelands_pole_log)
      rise = growth - (log(oil%eta0) + roelands_pole_log)
      slope = oil%exponent*growth/(oil%pole_pressure + p)
    end if
    eta = oil%eta0*exp(min(rise, largest_exponent))
    if (rise > largest_exponent) slope = 0
  end subroutine viscosity

  !> The same over a row of pressures; here, where it is inlined, the loop is turned into vector instructions.
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

    rho = 1 + oil%d1*p/(1 + oil%d2*p)
    slope = oil%d1/(1 + oil%d2*p)**2
  end subroutine density

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

end module oil_laws
