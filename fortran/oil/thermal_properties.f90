!> Conductivity and heat capacity of an oil against pressure and temperature (Sharif, Kong, Evans and Snidle 2001,
!> appendix).
module pyworm_thermal_properties
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: oil_heat_law, conductivity, heat_capacity

  !> The defaults are an oil whose properties are constant.
  type :: oil_heat_law
    !> Conductivity [W/(m K)] at ambient pressure, and c1, c2 [1/Pa] of k/k0 = 1 + c1 p/(1 + c2 p).
    real(wp) :: conductivity = 0, c1 = 0, c2 = 0
    !> Volumetric heat capacity [J/(m3 K)] at ambient pressure and reference temperature, and k1, k2 [1/Pa] of
    !> its growth 1 + k1 p/(1 + k2 p).
    real(wp) :: capacity = 0, k1 = 0, k2 = 0
    !> Growth of the capacity with temperature, b0 (1 + b1 p + b2 p^2) [1/K], with b1 [1/Pa] and b2 [1/Pa2].
    real(wp) :: b0 = 0, b1 = 0, b2 = 0
  end type oil_heat_law

contains

  !> Conductivity [W/(m K)] at pressure `p` [Pa].
  elemental real(wp) function conductivity(oil, p)
    type(oil_heat_law), intent(in) :: oil
    real(wp), intent(in) :: p

    conductivity = oil%conductivity*(1 + oil%c1*p/(1 + oil%c2*p))
  end function conductivity

  !> Volumetric heat capacity [J/(m3 K)] at pressure `p` [Pa] and `rise` [K] above the reference temperature.
  elemental real(wp) function heat_capacity(oil, p, rise)
    type(oil_heat_law), intent(in) :: oil
    real(wp), intent(in) :: p, rise

    heat_capacity = oil%capacity*(1 + oil%k1*p/(1 + oil%k2*p))*(1 + oil%b0*(1 + p*(oil%b1 + p*oil%b2))*rise)
  end function heat_capacity

end module pyworm_thermal_properties
