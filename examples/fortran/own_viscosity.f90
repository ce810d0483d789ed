!> Viscosity by Johari and Whalley's law, with a temperature by Andrade's.
module own_viscosity
  use pyworm_contact, only: wp => pyworm_real
  implicit none(type, external)
  private

  public :: viscosity

contains

  !> Viscosity [Pa s] at a pressure [Pa] and a temperature [K].
  function viscosity(pressure, temperature) result(eta)
    real(wp), intent(in) :: pressure, temperature
    real(wp) :: eta

    eta = 0.04_wp*exp(20e-9_wp*pressure/(1 + pressure/4e9_wp) + 3500*(1/temperature - 1/333.15_wp))
  end function viscosity

end module own_viscosity
