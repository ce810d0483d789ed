!> Averages over roughness: the numbers of the package's own tables (`pyworm/materials/rough_surfaces.py`), and limits.
program test_roughness_curves
  use pyworm_kinds, only: wp
  use pyworm_patir_cheng, only: open_gap, pressure_flow_factor, shear_flow_factor
  use pyworm_rough_surfaces, only: gap_curves
  use pyworm_roughness_curves, only: curves_of, gap_under, rough_side
  use tap, only: check, close_to, done
  implicit none(type, external)
  real(wp), parameter :: modulus = 230e9_wp
  real(wp), parameter :: value(9) = [1.65766649844_wp, 3.93230337181e-15_wp, 1.74901751412e-09_wp, 0.976165623453_wp, &
    0.937838207813_wp, 0.0131105979039_wp, -5.44195920272e-08_wp, -1.66905030154e-08_wp, -1.29059292691e-08_wp]
  type(rough_side), parameter :: ground = rough_side(3e-7_wp, 0.05_wp, aspect=3.0_wp, lay=0.3_wp, hardness=3e9_wp)
  type(rough_side), parameter :: lapped = rough_side(4e-7_wp, 0.02_wp)
  type(gap_curves) :: curves

  call close_to(pressure_flow_factor(1.5_wp, 1/6.0_wp), 0.2650233146104819_wp, 1e-12_wp, "pressure factor of a tabled aspect")
  call close_to(pressure_flow_factor(3.0_wp, 2.0_wp), 0.9654134793915577_wp, 1e-12_wp, "and between two of them")
  call close_to(pressure_flow_factor(4.5_wp, 4.0_wp), 1.0478277330127461_wp, 1e-12_wp, "blended with the asymptote")
  call close_to(pressure_flow_factor(20.0_wp, 0.5_wp), 1 - 3/400.0_wp, 1e-12_wp, "and the asymptote alone")
  call close_to(shear_flow_factor(0.2_wp, 1.0_wp), 0.4470516078758391_wp, 1e-12_wp, "shear factor of oil in valleys")
  call close_to(shear_flow_factor(3.0_wp, 2.0_wp), 0.37758759883549853_wp, 1e-12_wp, "and of their fits")
  call close_to(shear_flow_factor(20.0_wp, 0.5_wp), 0.1_wp, 1e-12_wp, "and of the asymptote")
  call close_to(open_gap(0.0_wp), 1/sqrt(2*acos(-1.0_wp)), 1e-14_wp, "mean gap of surfaces whose mean planes touch")

  curves = curves_of([ground, lapped], modulus)
  call close_to(curves%scale, 5e-7_wp, 1e-20_wp, "variances add")
  call check(all(abs(curves%value(:, 201) - value) <= 1e-10_wp*abs(value) + [0.0_wp, 1e-20_wp, spread(0.0_wp, 1, 7)]), &
    "all curves of two surfaces, one of which yields")
  call close_to(curves%slope(1, 201), -36.3375050037_wp, 1e-8_wp, "with the slopes of monotone cubics")
  call close_to(gap_under(curves, 1e8_wp), 6.950095482248e-07_wp, 1e-17_wp, "the gap at which they bear a pressure")
  curves = curves_of([rough_side(3e-7_wp, 0.05_wp, sharpness=0.01_wp, density=0.04_wp), lapped], modulus)
  call close_to(curves%value(1, 181), 7.356635440043651_wp, 1e-8_wp, "pressure of asperities of one radius")
  call close_to(curves%value(3, 181), 3.570734860324901e-07_wp, 1e-15_wp, "and their area")
  call done()
end program test_roughness_curves
