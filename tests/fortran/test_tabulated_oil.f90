!> Tables of an oil: what is cubic over pressure and temperature they reproduce, relative to the reference.
program test_tabulated_oil
  use pyworm_kinds, only: wp
  use pyworm_property_table, only: property_table, tabulated, tabulated_cold
  use pyworm_tabulated_oil, only: equal_cells, fits_table, tabulated_property
  use tap, only: check, close_to, done
  implicit none(type, external)
  real(wp), parameter :: pressures(5) = [0.0_wp, 1e8_wp, 3e8_wp, 6e8_wp, 1e9_wp], reference = 333
  real(wp), parameter :: temperatures(4) = [300.0_wp, 320.0_wp, 350.0_wp, 400.0_wp]
  type(property_table) :: table
  real(wp) :: values(5, 4), ambient, growth, f, by_pressure, by_rise
  integer :: i, j

  do j = 1, 4
    values(:, j) = [(logarithm(pressures(i), temperatures(j)), i=1, 5)]
  end do
  call tabulated_property(pressures, temperatures, values, reference, .false., table, ambient, growth)
  call close_to(ambient, logarithm(0.0_wp, reference), 1e-12_wp, "the ambient value at the reference")
  call close_to(growth*1e8_wp, 2 - 0.01_wp*(reference - 300), 1e-11_wp, "and its growth with pressure")
  call tabulated(table, 4.3e8_wp, 20.0_wp, f, by_pressure, by_rise)
  call close_to(f, logarithm(4.3e8_wp, reference + 20) - ambient, 1e-11_wp, "a cubic is reproduced between the values")
  call close_to(by_rise, -0.03_wp - 0.01_wp*4.3_wp, 1e-11_wp, "with its slope by temperature")
  call tabulated_cold(table, 4.3e8_wp, f, by_pressure)
  call close_to(f, logarithm(4.3e8_wp, reference) - ambient, 1e-11_wp, "and at the reference")

  call tabulated_property(pressures, [reference], exp(0.01_wp*values(:, 2:2)), reference, .true., table, ambient, growth)
  call tabulated(table, 0.0_wp, 50.0_wp, f, by_pressure, by_rise)
  call close_to(f, 1.0_wp, 1e-14_wp, "a ratio is one at ambient pressure")
  call close_to(by_rise, 0.0_wp, 0.0_wp, "one temperature is that of all")

  call close_to(sum(equal_cells(1.0_wp, 3.0_wp, 4)), 10.0_wp, 1e-14_wp, "equal cells from the first to the last")
  call check(fits_table(pressures, temperatures, exp(values), reference), "increasing pressures and temperatures fit")
  call check(.not. fits_table(pressures, temperatures, exp(values), 290.0_wp), "a reference outside does not")
  call check(.not. fits_table(pressures(5:1:-1), temperatures, exp(values), reference), "nor pressures that fall")
  call done()

contains

  !> Logarithm of a viscosity.
  pure real(wp) function logarithm(p, t)
    real(wp), intent(in) :: p, t

    logarithm = -3 + 2*p/1e8_wp - 0.05_wp*(p/1e8_wp)**2 - (0.03_wp + 0.01_wp*p/1e8_wp)*(t - 300)
  end function logarithm

end program test_tabulated_oil
