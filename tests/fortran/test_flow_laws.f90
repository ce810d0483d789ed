program test_flow_laws
  use pyworm_kinds, only: wp
  use pyworm_flow_laws, only: flow_law, has_limit, slip_stress, stress_scales, thinning, thinning_by_stresses, stress_guess, &
    law_newton, law_eyring, law_bair_winer, law_eyring_limited, law_carreau
  use tap, only: check, close_to, done
  implicit none(type, external)

  real(wp), parameter :: tau0 = 5e6_wp, limit = 1e8_wp
  type(flow_law), parameter :: newton = flow_law(law_newton), eyring = flow_law(law_eyring), &
    bair_winer = flow_law(law_bair_winer), limited = flow_law(law_eyring_limited), &
    sharply_limited = flow_law(law_eyring_limited, exponent=2.5_wp), carreau = flow_law(law_carreau, exponent=0.45_wp), &
    slips_gently = flow_law(law_eyring_limited, exponent=2.5_wp, slip_step=0.1_wp)
  type(flow_law) :: law
  real(wp) :: reference, reference_slope, bound, bound_slope, x

  call check(abs(g(newton, 7*tau0) - 1) <= 0, "Newton's oil does not thin")
  x = 3.0_wp
  call close_to(g(eyring, x*tau0), sinh(x)/x, 1e-14_wp*sinh(x)/x, "Eyring")
  call close_to(g(eyring, 0.3_wp*tau0), sinh(0.3_wp)/0.3_wp, 1e-15_wp, "Eyring near rest")
  call close_to(g(eyring, 0.499999_wp*tau0), g(eyring, 0.500001_wp*tau0), 1e-6_wp, "Eyring's series meets the closed form")
  call close_to(g(limited, x*tau0), sinh(x)/x/(1 - 0.15_wp**2), 1e-14_wp*sinh(x)/x, "limited Eyring")
  call close_to(g(sharply_limited, x*tau0), sinh(x)/x/(1 - 0.15_wp**5), 1e-14_wp*sinh(x)/x, "sharply limited Eyring")
  call close_to(g(bair_winer, 0.9_wp*limit), -log(0.1_wp)/0.9_wp, 1e-14_wp, "Bair and Winer")
  call close_to(g(bair_winer, 1e-5_wp*limit), 1 + 0.5e-5_wp, 1e-10_wp, "Bair and Winer near rest")
  call close_to(g(carreau, x*tau0), 10**(0.55_wp/0.9_wp), 1e-14_wp*10, "Carreau")

  call derivatives(newton, "Newton")
  call derivatives(eyring, "Eyring")
  call derivatives(bair_winer, "Bair and Winer")
  call derivatives(limited, "limited Eyring")
  call derivatives(sharply_limited, "sharply limited Eyring")
  call derivatives(carreau, "Carreau")
  call derivatives(slips_gently, "a wide slip step")
  call solid(eyring, "Eyring")
  call solid(bair_winer, "Bair and Winer")
  call solid(limited, "limited Eyring")
  call solid(carreau, "Carreau")
  call slip(bair_winer, "Bair and Winer")
  call slip(limited, "limited Eyring")
  call widened()

  call check(.not. has_limit(eyring) .and. has_limit(limited), "laws with a limit")
  law = flow_law(law_eyring_limited, tau0, 1e-9_wp, 0.01_wp, limit, 0.05_wp)
  call stress_scales(law, 1e9_wp, 50.0_wp, reference, reference_slope, bound, bound_slope)
  call close_to(reference, tau0*exp(0.5_wp), 1e-14_wp*tau0, "reference stress with pressure and temperature")
  call close_to(reference_slope, 1e-9_wp*reference, 1e-20_wp, "its slope")
  call close_to(bound, 1.5e8_wp, 1e-6_wp, "limiting stress with pressure")
  call close_to(bound_slope, 0.05_wp, 1e-16_wp, "its slope with pressure")
  ! one in proportion to pressure does not end at ambient pressure, but is itself from a few megapascal on
  law = flow_law(law_eyring_limited, tau0, 0.0_wp, 0.0_wp, 0.0_wp, 0.05_wp)
  call stress_scales(law, 4e6_wp, 0.0_wp, reference, reference_slope, bound, bound_slope)
  call close_to(bound, 2e5_wp, 1e-9_wp, "a limit in proportion to pressure")
  call close_to(bound_slope, 0.05_wp, 1e-16_wp, "and its slope")
  call stress_scales(law, 0.0_wp, 0.0_wp, reference, reference_slope, bound, bound_slope)
  call check(bound > 1e4_wp .and. bound < 2e5_wp .and. abs(bound_slope) <= 0, "leaves some stress at ambient pressure")
  x = 8.0_wp
  call close_to(stress_guess(eyring, tau0*sinh(x), tau0, limit), x*tau0, 1e-12_wp*tau0, "Eyring's stress guessed exactly")
  call check(stress_guess(limited, 1e30_wp, tau0, limit) < slip_stress(limit), "guesses stay below slip")
  call done()

contains

  !> Thinning at one stress [Pa].
  real(wp) function g(law, stress)
    type(flow_law), intent(in) :: law
    real(wp), intent(in) :: stress
    real(wp) :: of(1), slope(1)

    call thinning(law, 1, [stress**2], [1/tau0**2], [1/limit**2], of, slope)
    g = of(1)
  end function g

  !> Slopes by the square and by the stresses against differences, from rest to beyond slip.
  subroutine derivatives(law, name)
    type(flow_law), intent(in) :: law
    character(len=*), intent(in) :: name
    !> Stresses over tau0; those beyond 19.9 slip where the law does.
    real(wp), parameter :: stress(8) = [0.02_wp, 0.3_wp, 0.49_wp, 0.51_wp, 2.0_wp, 9.0_wp, 19.0_wp, 19.905_wp]
    real(wp), parameter :: relative = 3e-7_wp
    real(wp) :: of(8), slope(8), above(8), below(8), unused(8), by_reference(8), by_limit(8), square(8), bound(8), ref(8)

    square = (stress*tau0)**2
    ref = tau0
    bound = limit
    call thinning(law, 8, square, 1/ref**2, 1/bound**2, of, slope)
    call thinning(law, 8, square*(1 + relative), 1/ref**2, 1/bound**2, above, unused)
    call thinning(law, 8, square*(1 - relative), 1/ref**2, 1/bound**2, below, unused)
    call check(all(abs(slope*square - (above - below)/(2*relative)) < 1e-5_wp*(abs(slope*square) + 1e-3_wp*of)), &
      name//": slope by the square of stress")
    call thinning_by_stresses(law, 8, square, ref, bound, of, slope, by_reference, by_limit)
    call thinning(law, 8, square, 1/(ref*(1 + relative))**2, 1/bound**2, above, unused)
    call thinning(law, 8, square, 1/(ref*(1 - relative))**2, 1/bound**2, below, unused)
    call check(all(abs(by_reference*ref - (above - below)/(2*relative)) < 1e-5_wp*(abs(by_reference*ref) + 1e-3_wp*of)), &
      name//": slope by the reference stress")
    call thinning(law, 8, square, 1/ref**2, 1/(bound*(1 + relative))**2, above, unused)
    call thinning(law, 8, square, 1/ref**2, 1/(bound*(1 - relative))**2, below, unused)
    call check(all(abs(by_limit*bound - (above - below)/(2*relative)) < 1e-5_wp*(abs(by_limit*bound) + 1e-3_wp*of)), &
      name//": slope by the limiting stress")
  end subroutine derivatives

  !> Stresses beyond all reason.
  subroutine solid(law, name)
    type(flow_law), intent(in) :: law
    character(len=*), intent(in) :: name
    real(wp) :: of(3), slope(3)

    call thinning(law, 3, [0.0_wp, 1e20_wp, 1e60_wp], spread(1/tau0**2, 1, 3), spread(1/limit**2, 1, 3), of, slope)
    call check(all(of >= 1 .and. of < 1e100_wp .and. slope >= 0 .and. slope < huge(1.0_wp)), name//": no overflow")
    call close_to(of(1), 1.0_wp, 1e-5_wp, name//": Newtonian at rest")
  end subroutine solid

  !> Slip joins the law without a kink, and takes 500 times the rate half a per cent beyond the limit.
  subroutine slip(law, name)
    type(flow_law), intent(in) :: law
    character(len=*), intent(in) :: name
    real(wp) :: of(2), slope(2), c

    c = slip_stress(limit)
    call thinning(law, 2, [c*(1 - 1e-9_wp), c*(1 + 1e-9_wp)]**2, spread(1/tau0**2, 1, 2), spread(1/limit**2, 1, 2), of, slope)
    call close_to(of(1), of(2), 1e-6_wp*of(1), name//": slip joins thinning")
    call close_to(slope(1), slope(2), 1e-4_wp*slope(1), name//": slip joins its slope")
    call check(g(law, 1.005_wp*limit) > 500*g(law, c), name//": slip about the limit")
  end subroutine slip

  !> Rates beyond slip by a slip step of a tenth are those of a thousandth at a hundredth of the distance, but for the
  !> factor by which the step multiplies them.
  subroutine widened()
    type(flow_law), parameter :: wide = flow_law(law_eyring_limited, slip_step=0.1_wp)
    real(wp) :: c, at_slip, far, near

    c = slip_stress(limit)
    at_slip = c*g(limited, c)
    far = 1.3_wp*c*g(wide, 1.3_wp*c) - at_slip
    near = 1.003_wp*c*g(limited, 1.003_wp*c) - at_slip
    call close_to(far, 100*near, 1e-9_wp*far, "slip in a wide step")
  end subroutine widened

end program test_flow_laws
