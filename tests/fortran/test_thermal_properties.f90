!> The oil of Sharif, Kong, Evans and Snidle (2001): table 2 and appendix.
program test_thermal_properties
  use pyworm_kinds, only: wp
  use pyworm_thermal_properties, only: oil_heat_law, conductivity, heat_capacity
  use tap, only: close_to, done
  implicit none(type, external)

  type(oil_heat_law), parameter :: oil = oil_heat_law(0.148_wp, 1.56e-9_wp, 0.61e-9_wp, 1025*1844.0_wp, 0.5e-9_wp, &
    0.51e-9_wp, 3.4e-4_wp, 3.3e-9_wp, -2.3e-18_wp)
  type(oil_heat_law), parameter :: constant = oil_heat_law(conductivity=0.14_wp, capacity=1.7e6_wp)

  call close_to(conductivity(oil, 0.0_wp), 0.148_wp, 1e-16_wp, "conductivity at ambient pressure")
  call close_to(conductivity(oil, 1e9_wp), 0.148_wp*3.17_wp/1.61_wp, 1e-15_wp, "conductivity at 1 GPa")
  call close_to(heat_capacity(oil, 0.0_wp, 50.0_wp), 1890100*1.017_wp, 1e-8_wp, "capacity with temperature")
  call close_to(heat_capacity(oil, 1e9_wp, 0.0_wp), 1890100*2.01_wp/1.51_wp, 1e-8_wp, "capacity with pressure")
  call close_to(heat_capacity(oil, 1e9_wp, 100.0_wp), 1890100*2.01_wp/1.51_wp*1.068_wp, 1e-8_wp, "capacity with both")
  call close_to(conductivity(constant, 2e9_wp), 0.14_wp, 1e-16_wp, "constant conductivity")
  call close_to(heat_capacity(constant, 2e9_wp, 80.0_wp), 1.7e6_wp, 1e-9_wp, "constant capacity")
  call done()
end program test_thermal_properties
