program test_oil_laws
  use kinds, only: wp
  use oil_laws, only: oil_law, viscosity, density, law_barus, law_roelands
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
  call done()
end program test_oil_laws
