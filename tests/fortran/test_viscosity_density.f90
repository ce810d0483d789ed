program test_viscosity_density
  use pyworm_kinds, only: wp
  use pyworm_viscosity_density, only: oil_law, viscosity, density, hot_fluidity, hot_density, expansivity, law_barus, law_roelands
  use tap, only: close_to, check, done
  implicit none(type, external)

  type(oil_law) :: barus, roelands
  real(wp) :: eta, slope, rho, rho_slope, above, below, unused
  real(wp), parameter :: p = 0.7e9_wp, step = 1e3_wp

  ! z = alpha p0 / (ln eta0 + 9.67) makes both laws share their slope at p = 0
  barus = oil_law(law_barus, 0.04_wp, 2.2e-8_wp, 1.0_wp, 0.0_wp, 0.0_wp)
  roelands = oil_law(law_roelands, 0.04_wp, 2.2e-8_wp*1.96e8_wp/(log(0.04_wp) + 9.67_wp), 1.96e8_wp, &
    0.34_wp/5.9e8_wp, 1/5.9e8_wp)

  call viscosity(barus, 1e8_wp, eta, slope)
  call close_to(eta, 0.04_wp*exp(2.2_wp), 1e-14_wp, "Barus")
  call viscosity(roelands, 0.0_wp, eta, slope)
  call close_to(eta, 0.04_wp, 1e-16_wp, "Roelands at ambient pressure")
  call close_to(slope*1e8_wp, 2.2_wp, 1e-12_wp, "Roelands has slope alpha at ambient pressure")

  call viscosity(roelands, p, eta, slope)
  call viscosity(roelands, p + step, above, unused)
  call viscosity(roelands, p - step, below, unused)
  call close_to(slope, (above - below)/(2*step*eta), 1e-6_wp*slope, "slope of Roelands against differences")
  call viscosity(barus, 1e12_wp, eta, slope)
  call check(eta < huge(eta) .and. abs(slope) <= 0, "a solid oil does not overflow")

  call density(roelands, 1e9_wp, rho, rho_slope)
  call close_to(rho, (5.9_wp + 13.4_wp)/(5.9_wp + 10.0_wp), 1e-14_wp, "Dowson and Higginson, pole form")
  call density(roelands, p, rho, rho_slope)
  call density(roelands, p + step, above, unused)
  call density(roelands, p - step, below, unused)
  call close_to(rho_slope, (above - below)/(2*step), 1e-6_wp*rho_slope, "slope of density against differences")
  call hot_oils()
  call done()

contains

  !> Oils with temperature: the polyglycol of Sharif, Kong, Evans and Snidle (2001), table 2 and appendix, and
  !> Barus.
  subroutine hot_oils()
    type(oil_law), parameter :: polyglycol = oil_law(law_roelands, 0.227_wp, 0.227_wp, 1/5.1e-9_wp, 0.67e-9_wp, 2.68e-9_wp, &
      333.15_wp, 0.782_wp, 7.1e-4_wp, 1.5e-9_wp)
    type(oil_law), parameter :: hot_barus = oil_law(law_barus, 0.04_wp, 2e-8_wp, thermal_exponent=0.03_wp)
    real(wp), parameter :: p = 0.5e9_wp, rise = 45.0_wp, dp = 1e3_wp, dt = 1e-3_wp

    call isotherm(polyglycol, "Roelands")
    call isotherm(hot_barus, "Barus")
    ! eq. 20 by hand at 0.5 GPa and 45 K above 60 C
    call close_to(fluidity_at(polyglycol, p, rise), 1/(0.227_wp*exp((log(0.227_wp) + 9.67_wp) &
      *((1 + 5.1_wp*0.5_wp)**0.227_wp*((378.15_wp - 138)/(333.15_wp - 138))**(-0.782_wp) - 1))), 1e-12_wp, &
      "polyglycol hot and pressed")
    call close_to(1/fluidity_at(hot_barus, 1e8_wp, 10.0_wp), 0.04_wp*exp(1.7_wp), 1e-14_wp, "Barus with temperature")
    call derivatives(polyglycol, p, rise, "Roelands")
    call derivatives(hot_barus, 1e8_wp, rise, "Barus")
    call check(fluidity_at(polyglycol, p, -330.0_wp) > 0 .and. fluidity_at(hot_barus, 1e12_wp, 0.0_wp) > 0, &
      "solid oils keep some fluidity")
    call check(1/fluidity_at(hot_barus, 0.0_wp, 1e6_wp) > 0, "no oil is too hot")

    call close_to(expansivity(polyglycol, 1e9_wp), 7.1e-4_wp*exp(-1.5_wp), 1e-18_wp, "expansivity at 1 GPa")
    call hot_density(polyglycol, 1e9_wp, 100.0_wp, rho, rho_slope)
    call close_to(rho, (1 + 0.67_wp/3.68_wp)*(1 - 0.071_wp*exp(-1.5_wp)), 1e-14_wp, "density hot and pressed")
    call hot_density(polyglycol, p + dp, rise, above, unused)
    call hot_density(polyglycol, p - dp, rise, below, unused)
    call hot_density(polyglycol, p, rise, rho, rho_slope)
    call close_to(rho_slope, (above - below)/(2*dp), 1e-6_wp*rho_slope, "slope of hot density against differences")
  end subroutine hot_oils

  !> At its own temperature an oil has the viscosity of `viscosity`.
  subroutine isotherm(oil, name)
    type(oil_law), intent(in) :: oil
    character(len=*), intent(in) :: name

    call viscosity(oil, 0.3e9_wp, eta, slope)
    call close_to(fluidity_at(oil, 0.3e9_wp, 0.0_wp)*eta, 1.0_wp, 1e-13_wp, name//" at its own temperature")
  end subroutine isotherm

  !> Fluidity of one point at one level.
  real(wp) function fluidity_at(oil, p, rise)
    type(oil_law), intent(in) :: oil
    real(wp), intent(in) :: p, rise
    real(wp), dimension(1, 1) :: fluidity, by_pressure, by_temperature

    call hot_fluidity(oil, [p], reshape([rise], [1, 1]), fluidity, by_pressure, by_temperature)
    fluidity_at = fluidity(1, 1)
  end function fluidity_at

  !> Logarithmic slopes of fluidity against differences.
  subroutine derivatives(oil, p, rise, name)
    type(oil_law), intent(in) :: oil
    real(wp), intent(in) :: p, rise
    character(len=*), intent(in) :: name
    real(wp), parameter :: dp = 1e3_wp, dt = 1e-3_wp
    real(wp), dimension(1, 2) :: fluidity, by_pressure, by_temperature
    real(wp) :: wanted

    call hot_fluidity(oil, [p], reshape([0.0_wp, rise], [1, 2]), fluidity, by_pressure, by_temperature)
    wanted = log(fluidity_at(oil, p + dp, rise)/fluidity_at(oil, p - dp, rise))/(2*dp)
    call close_to(by_pressure(1, 2), wanted, 1e-6_wp*abs(wanted), name//": slope of fluidity by pressure")
    wanted = log(fluidity_at(oil, p + dp, 0.0_wp)/fluidity_at(oil, p - dp, 0.0_wp))/(2*dp)
    call close_to(by_pressure(1, 1), wanted, 1e-6_wp*abs(wanted), name//": slope of fluidity by pressure, first level")
    wanted = log(fluidity_at(oil, p, rise + dt)/fluidity_at(oil, p, rise - dt))/(2*dt)
    call close_to(by_temperature(1, 2), wanted, 1e-6_wp*abs(wanted), name//": slope of fluidity by temperature")
  end subroutine derivatives

end program test_viscosity_density
