program test_shear_flow
  use pyworm_kinds, only: wp
  use pyworm_gauss_lobatto, only: levels_across, new_levels
  use pyworm_flow_laws, only: flow_law, has_limit, law_newton, law_eyring, law_bair_winer, law_eyring_limited, law_carreau, &
    slip_stress
  use pyworm_sharif_flow_factors, only: flow_factors
  use pyworm_shear_flow, only: flow_deficit, deficit_change, new_deficit_change, flow_change, flow_change_by_stresses
  use pyworm_shear_profile, only: film_velocity, film_shear_rate, film_heat, wall_slip
  use pyworm_shear_stress, only: solve_shear
  use pyworm_strip_of_points, only: shear_strip, new_shear_strip, slip_at_body_1, slip_at_body_2
  use tap, only: check, close_to, done
  implicit none(type, external)

  real(wp), parameter :: h = 0.4e-6_wp, eta = 3.0_wp, tau0 = 4e6_wp, limit = 5e7_wp
  type(flow_law), parameter :: newton = flow_law(law_newton), eyring = flow_law(law_eyring), &
    bair_winer = flow_law(law_bair_winer), limited = flow_law(law_eyring_limited), &
    sharply_limited = flow_law(law_eyring_limited, exponent=2.5_wp), carreau = flow_law(law_carreau, exponent=0.45_wp)
  !> A film's deficit with all its derivatives.
  type :: change
    real(wp) :: deficit(2), mobility(3), by_film(2), by_fluidity(7, 2), by_reference(2), by_limit(2)
  end type change
  type(levels_across) :: seven, many

  seven = new_levels(7)
  many = new_levels(15)
  call newtonian()
  call closed_forms()
  call derivatives(newton, "Newton")
  call derivatives(eyring, "Eyring")
  call derivatives(bair_winer, "Bair and Winer")
  call derivatives(limited, "limited Eyring")
  call derivatives(sharply_limited, "sharply limited Eyring")
  call derivatives(carreau, "Carreau")
  call symmetries()
  call slipping()
  call widened_slip()
  call across_the_film(newton, "Newton")
  call across_the_film(limited, "limited Eyring")
  call factors()
  call part_of_a_strip()
  call hard_points(eyring, "Eyring")
  call hard_points(bair_winer, "Bair and Winer")
  call hard_points(limited, "limited Eyring")
  call hard_points(carreau, "Carreau")
  call done()

contains

  !> One point of uniform viscosity.
  subroutine one_point(levels, px, py, us, vs, strip)
    type(levels_across), intent(in) :: levels
    real(wp), intent(in) :: px, py, us, vs
    type(shear_strip), intent(out) :: strip
    integer :: stat

    call new_shear_strip(1, levels%count, strip, stat)
    strip%film = h
    strip%px = px
    strip%py = py
    strip%us = us
    strip%vs = vs
    strip%reference = tau0
    strip%limit = limit
    strip%fluidity = 1/eta
  end subroutine one_point

  !> Exact flow of a Newtonian oil, of uniform viscosity and of fluidity linear across the film.
  subroutine newtonian()
    real(wp), parameter :: px = 2e12_wp, py = -1e12_wp, us = 1.5_wp, vs = 0.4_wp, slope = 0.8_wp
    type(shear_strip) :: strip
    type(change) :: got
    integer :: failures

    call one_point(seven, px, py, us, vs, strip)
    call solve_shear(newton, seven, strip, failures)
    got = change_of(newton, strip)
    call close_to(strip%tau_x(1), eta*us/h, 1e-14_wp*eta*us/h, "Couette stress")
    call close_to(got%deficit(1), h**3/(12*eta)*px, 1e-14_wp*h**3/(12*eta)*px, "Poiseuille flow along x")
    call close_to(got%deficit(2), h**3/(12*eta)*py, -1e-14_wp*h**3/(12*eta)*py, "Poiseuille flow along y")
    call close_to(got%mobility(3), h**3/(12*eta), 1e-14_wp*h**3/(12*eta), "Poiseuille mobility")

    strip%fluidity(1, :) = (1 + 2*slope*seven%z)/eta
    call solve_shear(newton, seven, strip, failures)
    got = change_of(newton, strip)
    call close_to(strip%tau_x(1), eta*us/h - slope*h*px/6, 1e-14_wp*eta*us/h, "stress at linear fluidity")
    call close_to(got%deficit(1), h*us*slope/6 + h**3*px/eta*(1/12.0_wp - slope**2/36), 1e-14_wp*h*us, &
      "flow at linear fluidity")
    call close_to(got%mobility(1), h**3/eta*(1/12.0_wp - slope**2/36), 1e-14_wp*h**3/eta, "mobility at linear fluidity")
  end subroutine newtonian

  !> Solutions in closed form at uniform viscosity.
  subroutine closed_forms()
    type(shear_strip) :: strip
    type(change) :: got
    real(wp) :: a, px, us, wanted, x
    integer :: failures

    us = 40*h*tau0/eta
    call one_point(seven, 0.0_wp, 0.0_wp, 0.6_wp*us, -0.8_wp*us, strip)
    call solve_shear(eyring, seven, strip, failures)
    wanted = tau0*asinh(40.0_wp)
    call close_to(strip%tau_x(1), 0.6_wp*wanted, 1e-11_wp*wanted, "Eyring sliding, along x")
    call close_to(strip%tau_y(1), -0.8_wp*wanted, 1e-11_wp*wanted, "Eyring sliding, along y")

    a = 9.0_wp
    px = a*tau0/h
    call one_point(many, px, 0.0_wp, 0.0_wp, 0.0_wp, strip)
    call solve_shear(eyring, many, strip, failures)
    got = change_of(eyring, strip)
    wanted = h**2*tau0/eta*(cosh(a/2)/a - 2*sinh(a/2)/a**2)
    call close_to(got%deficit(1), wanted, 1e-12_wp*wanted, "Eyring rolling under a gradient")

    us = 25*h*tau0/eta
    call one_point(many, px, 0.0_wp, us, 0.0_wp, strip)
    call solve_shear(eyring, many, strip, failures)
    wanted = tau0*asinh(25*a/(2*sinh(a/2)))
    call close_to(strip%tau_x(1), wanted, 1e-10_wp*wanted, "Eyring sliding along a gradient")
    x = asinh(25*a/(2*sinh(a/2)))
    got = change_of(eyring, strip)
    wanted = h**2*tau0/eta*cosh(x)*(cosh(a/2)/a - 2*sinh(a/2)/a**2)
    call close_to(got%deficit(1), wanted, 1e-10_wp*wanted, "Eyring flow with sliding along a gradient")

    us = 3*h*limit/eta
    call one_point(seven, 0.0_wp, 0.0_wp, us, 0.0_wp, strip)
    call solve_shear(bair_winer, seven, strip, failures)
    wanted = limit*(1 - exp(-3.0_wp))
    call close_to(strip%tau_x(1), wanted, 1e-11_wp*wanted, "Bair and Winer sliding")

    ! rates at stresses chosen
    x = 5.0_wp
    us = h*tau0/eta*x*(1 + x**2)**((1/carreau%exponent - 1)/2)
    call one_point(seven, 0.0_wp, 0.0_wp, us, 0.0_wp, strip)
    call solve_shear(carreau, seven, strip, failures)
    call close_to(strip%tau_x(1), x*tau0, 1e-10_wp*x*tau0, "Carreau sliding")
    us = h*tau0/eta*sinh(x)/(1 - (x*tau0/limit)**5)
    call one_point(seven, 0.0_wp, 0.0_wp, us, 0.0_wp, strip)
    call solve_shear(sharply_limited, seven, strip, failures)
    call close_to(strip%tau_x(1), x*tau0, 1e-10_wp*x*tau0, "sharply limited Eyring sliding")
  end subroutine closed_forms

  !> Solution and derivatives of a strip's first point.
  type(change) function change_of(law, strip)
    type(flow_law), intent(in) :: law
    type(shear_strip), intent(inout) :: strip
    type(levels_across) :: levels
    type(deficit_change) :: got
    integer :: stat

    levels = new_levels(size(strip%fluidity, 2))
    call new_deficit_change(1, levels%count, got, stat)
    call flow_change(levels, strip, got)
    call flow_change_by_stresses(law, levels, strip, got)
    change_of%deficit = [got%x, got%y]
    change_of%mobility = [got%mobility_xx, got%mobility_xy, got%mobility_yy]
    change_of%by_film = [got%by_film_x, got%by_film_y]
    change_of%by_fluidity(:, 1) = got%by_fluidity_x(1, :7)
    change_of%by_fluidity(:, 2) = got%by_fluidity_y(1, :7)
    change_of%by_reference = [got%by_onset_x, got%by_onset_y]
    change_of%by_limit = [got%by_limit_x, got%by_limit_y]
  end function change_of

  !> A point whose viscosity varies tenfold, sheared across its gradient.
  subroutine skew_point(law, strip)
    type(flow_law), intent(in) :: law
    type(shear_strip), intent(out) :: strip

    call one_point(seven, 1.1e13_wp, -0.7e13_wp, 20*h*tau0/eta, 9*h*tau0/eta, strip)
    strip%fluidity(1, :) = exp(2.3_wp*seven%z)/eta
    if (law%law == law_bair_winer) strip%limit = 10*tau0
  end subroutine skew_point

  !> A solution to rounding, from which differences can be taken.
  subroutine solve_twice(law, strip, failures)
    type(flow_law), intent(in) :: law
    type(shear_strip), intent(inout) :: strip
    integer, intent(out) :: failures
    integer :: again

    call solve_shear(law, seven, strip, failures)
    call solve_shear(law, seven, strip, again)
    failures = failures + again
  end subroutine solve_twice

  !> Deficit of a point solved anew.
  function deficit_of(law, strip) result(deficit)
    type(flow_law), intent(in) :: law
    type(shear_strip), intent(in) :: strip
    real(wp) :: deficit(2)
    type(shear_strip) :: again
    real(wp) :: x(1), y(1)
    integer :: failures

    again = strip
    again%tau_x = 0
    again%tau_y = 0
    call solve_twice(law, again, failures)
    call flow_deficit(seven, again, x, y)
    deficit = [x(1), y(1)]
  end function deficit_of

  !> All derivatives of the deficit against differences.
  subroutine derivatives(law, name)
    type(flow_law), intent(in) :: law
    character(len=*), intent(in) :: name
    real(wp), parameter :: relative = 1e-5_wp
    type(shear_strip) :: strip, above, below
    type(change) :: got
    real(wp) :: step, wanted(2), scale
    integer :: failures, k

    call skew_point(law, strip)
    call solve_shear(law, seven, strip, failures)
    got = change_of(law, strip)
    wanted = got%deficit
    call solve_twice(law, strip, failures)
    call check(failures == 0, name//": converges")
    got = change_of(law, strip)
    call check(norm2(wanted - got%deficit) < 2e-10_wp*norm2(wanted), name//": one solution is accurate")
    scale = norm2(got%deficit)

    step = relative*strip%px(1)
    above = strip
    below = strip
    above%px = strip%px + step
    below%px = strip%px - step
    wanted = (deficit_of(law, above) - deficit_of(law, below))/(2*step)
    call check(norm2(got%mobility(1:2) - wanted) < 1e-6_wp*norm2(wanted), name//": derivative by the gradient along x")
    above%px = strip%px
    below%px = strip%px
    above%py = strip%py + step
    below%py = strip%py - step
    wanted = (deficit_of(law, above) - deficit_of(law, below))/(2*step)
    call check(norm2(got%mobility(2:3) - wanted) < 1e-6_wp*norm2(wanted), name//": derivative by the gradient along y")
    call check(got%mobility(1) > 0 .and. got%mobility(1)*got%mobility(3) > got%mobility(2)**2, &
      name//": mobility positive definite")

    step = relative*strip%film(1)
    above = strip
    below = strip
    above%film = strip%film + step
    below%film = strip%film - step
    wanted = (deficit_of(law, above) - deficit_of(law, below))/(2*step)
    call check(norm2(got%by_film - wanted) < 1e-6_wp*norm2(wanted), name//": derivative by the film")

    do k = 1, 7
      step = 10*relative*strip%fluidity(1, k)
      above = strip
      below = strip
      above%fluidity(1, k) = strip%fluidity(1, k) + step
      below%fluidity(1, k) = strip%fluidity(1, k) - step
      wanted = (deficit_of(law, above) - deficit_of(law, below))/(2*step)
      if (norm2(got%by_fluidity(k, :) - wanted)*strip%fluidity(1, k) > 1e-6_wp*scale) exit
    end do
    call check(k > 7, name//": derivatives by the fluidities")

    step = relative*tau0
    above = strip
    below = strip
    above%reference = strip%reference + step
    below%reference = strip%reference - step
    wanted = (deficit_of(law, above) - deficit_of(law, below))/(2*step)
    call check(norm2(got%by_reference - wanted)*tau0 < 1e-6_wp*scale, name//": derivative by the reference stress")
    step = relative*strip%limit(1)
    above = strip
    below = strip
    above%limit = strip%limit + step
    below%limit = strip%limit - step
    wanted = (deficit_of(law, above) - deficit_of(law, below))/(2*step)
    call check(norm2(got%by_limit - wanted)*strip%limit(1) < 1e-6_wp*scale, name//": derivative by the limiting stress")
  end subroutine derivatives

  !> The flow turns with its causes.
  subroutine symmetries()
    type(shear_strip) :: strip, turned
    real(wp), parameter :: cosine = 0.28_wp, sine = 0.96_wp
    real(wp) :: deficit(2), other(2)

    call skew_point(limited, strip)
    deficit = deficit_of(limited, strip)
    turned = strip
    turned%px = cosine*strip%px - sine*strip%py
    turned%py = sine*strip%px + cosine*strip%py
    turned%us = cosine*strip%us - sine*strip%vs
    turned%vs = sine*strip%us + cosine*strip%vs
    other = deficit_of(limited, turned)
    call check(norm2(other - [cosine*deficit(1) - sine*deficit(2), sine*deficit(1) + cosine*deficit(2)]) &
      < 1e-10_wp*norm2(deficit), "the flow turns with its causes")
    turned%px = -strip%px
    turned%py = -strip%py
    turned%us = -strip%us
    turned%vs = -strip%vs
    other = deficit_of(limited, turned)
    call check(norm2(other + deficit) < 1e-10_wp*norm2(deficit), "the flow is odd in its causes")
  end subroutine symmetries

  !> Bair and Winer's film takes no more than ln(200) of its scale of speed; the rest is slip.
  subroutine slipping()
    type(shear_strip) :: strip
    real(wp) :: us, bound, first(2), second(2), u(1, 7), v(1, 7), x(1), y(1)
    integer :: failures

    us = 9*h*limit/eta
    bound = slip_stress(limit)
    call one_point(seven, 0.0_wp, 0.0_wp, us, 0.0_wp, strip)
    call solve_shear(bair_winer, seven, strip, failures)
    call check(failures == 0 .and. strip%slip(1) == slip_at_body_1 + slip_at_body_2, "a uniform film slips at both walls")
    call check(strip%tau_x(1) > bound .and. strip%tau_x(1) < 1.01_wp*bound, "its stress is that at slip")

    call one_point(seven, 0.1_wp*limit/h, 0.0_wp, us, 0.0_wp, strip)
    call solve_shear(bair_winer, seven, strip, failures)
    call check(failures == 0 .and. strip%slip(1) == slip_at_body_2, "a gradient lets one wall slip, that of body 2")
    call wall_slip(bair_winer, seven, strip, 1, 1, first(1), first(2))
    call wall_slip(bair_winer, seven, strip, 1, 7, second(1), second(2))
    call check(norm2(first) <= 0, "no slip at body 1")
    call film_velocity(bair_winer, seven, strip, [0.3_wp], [0.0_wp], u, v)
    call close_to(u(1, 7), 0.3_wp + us, 1e-12_wp*us, "the walls move with the bodies")
    ! the rate at tau = limit (0.945 + 0.1 z) is known; its integral is that of the logarithm
    call close_to(second(1), us - h*limit/eta*shear(strip%tau_x(1)/limit), 2e-3_wp*us, "slip is the sliding that is left")
    call flow_deficit(seven, strip, x, y)
    call check(x(1) > h*second(1)/2, "slip at body 2 takes flow")

    call one_point(seven, 0.1_wp*limit/h, 0.05_wp*limit/h, 0.6_wp*us, 0.8_wp*us, strip)
    strip%fluidity(1, :) = exp(-4*seven%z)/eta
    call solve_shear(bair_winer, seven, strip, failures)
    call flow_deficit(seven, strip, x, v(:, 1))
    call solve_twice(bair_winer, strip, failures)
    call flow_deficit(seven, strip, y, v(:, 1))
    call check(failures == 0 .and. strip%slip(1) == slip_at_body_2, "a skew film slips")
    call close_to(x(1), y(1), 2e-10_wp*abs(y(1)), "its solution is accurate")
    call slipping_derivative(strip)
    call wall_slip(bair_winer, seven, strip, 1, 7, second(1), second(2))
    x = strip%tau_x + h*strip%px/2
    y = strip%tau_y + h*strip%py/2
    call close_to((second(1)*y(1) - second(2)*x(1))/(norm2(second)*hypot(x(1), y(1))), 0.0_wp, 1e-10_wp, &
      "slip follows the stress at its wall")
    call check(hypot(x(1), y(1)) > bound .and. hypot(x(1), y(1)) < 1.01_wp*bound, "the wall is at the stress of slip")

    ! a pressure that falls by more than both walls together can bear
    call one_point(seven, 3*limit/h, 0.0_wp, us, 0.1_wp*us, strip)
    call solve_shear(bair_winer, seven, strip, failures)
    call flow_deficit(seven, strip, x, y)
    call check(abs(x(1)) < huge(us) .and. abs(y(1)) < huge(us) .and. strip%slip(1) == slip_at_body_1 + slip_at_body_2, &
      "a gradient beyond bearing lets both walls slip")
    call one_point(seven, 1e5_wp*tau0/h, 0.0_wp, us, 0.1_wp*us, strip)
    call solve_shear(eyring, seven, strip, failures)
    call flow_deficit(seven, strip, x, y)
    call check(x(1) > 0 .and. x(1) < huge(us), "a gradient beyond reason does not overflow")
  end subroutine slipping

  !> Oil under 16 times its stresses, with the wide slip of the stress continuation, so viscous that it only slips: the walls'
  !> stress grows by three limits for each e-fold of the slip.
  subroutine widened_slip()
    type(shear_strip) :: strip
    type(flow_law), parameter :: firm = flow_law(law_eyring_limited, slip_step=3.0_wp)
    real(wp), parameter :: sliding = 15.0_wp
    real(wp) :: rate
    integer :: failures, k

    call one_point(seven, 0.3_wp*16*limit/h, 0.0_wp, sliding, 0.0_wp, strip)
    strip%reference = 16*tau0
    strip%limit = 16*limit
    strip%fluidity = 1e-20_wp
    call solve_shear(firm, seven, strip, failures)
    rate = 0
    do k = 1, 7
      rate = rate + seven%weight(k)*strip%fluidity(1, k)*strip%g(1, k)*(strip%tau_x(1) + seven%z(k)*h*strip%px(1))
    end do
    call check(failures == 0, "widened slip of a very viscous oil is found")
    call close_to(h*rate, sliding, 1e-8_wp, "widened slip has the sliding asked for")
  end subroutine widened_slip

  !> The mobility of a film that slips, against differences well within the stresses over which slip sets in.
  subroutine slipping_derivative(strip)
    type(shear_strip), intent(inout) :: strip
    type(shear_strip) :: above, below
    type(change) :: got
    real(wp) :: step, wanted(2)

    got = change_of(bair_winer, strip)
    step = 1e-5_wp*strip%px(1)
    above = strip
    below = strip
    above%px = strip%px + step
    below%px = strip%px - step
    wanted = (deficit_of(bair_winer, above) - deficit_of(bair_winer, below))/(2*step)
    call check(norm2(got%mobility(1:2) - wanted) < 1e-4_wp*norm2(wanted), "derivative by the gradient of a film that slips")
  end subroutine slipping_derivative

  !> Mean of -ln(1 - x) over x within 0.05 of a centre, that at slip counting beyond it.
  real(wp) function shear(centre)
    real(wp), intent(in) :: centre
    real(wp), parameter :: at_slip = 0.005_wp
    real(wp) :: low, high, slipping

    low = max(1 - centre - 0.05_wp, at_slip)
    high = 1 - centre + 0.05_wp
    slipping = low - (1 - centre - 0.05_wp)
    shear = -((high*log(high) - high) - (low*log(low) - low) + slipping*log(at_slip))/0.1_wp
  end function shear

  !> Velocities and heat at the levels.
  subroutine across_the_film(law, name)
    type(flow_law), intent(in) :: law
    character(len=*), intent(in) :: name
    real(wp), parameter :: relative = 1e-4_wp
    type(shear_strip) :: strip, above, below
    real(wp), dimension(1, 7) :: u, v, rate, heat, own, response_x, response_y, stress_x, stress_y, high, low
    real(wp) :: x(1), y(1), power, wanted, worst, derivative
    integer :: failures, k, l

    call one_point(seven, 3e12_wp, 0.0_wp, 2.0_wp, 0.0_wp, strip)
    call solve_shear(newton, seven, strip, failures)
    call film_velocity(newton, seven, strip, [1.0_wp], [0.5_wp], u, v)
    call check(maxval(abs(u(1, :) - (1 + 2*(seven%z + 0.5_wp) - h**2/(2*eta)*3e12_wp*(0.25_wp - seven%z**2)))) < 1e-13_wp, &
      "velocity of Couette and Poiseuille")
    call check(maxval(abs(v - 0.5_wp)) < 1e-14_wp, "velocity across")

    call skew_point(law, strip)
    call solve_shear(law, seven, strip, failures)
    call film_shear_rate(seven, strip, rate)
    call film_heat(seven, strip, heat, own, response_x, response_y, stress_x, stress_y)
    call flow_deficit(seven, strip, x, y)
    power = strip%tau_x(1)*strip%us(1) + strip%tau_y(1)*strip%vs(1) + strip%px(1)*x(1) + strip%py(1)*y(1)
    call close_to(h*sum(seven%weight*heat(1, :)), power, 1e-10_wp*power, name//": heat is the power of walls and gradient")
    call check(maxval(abs(heat*strip%g*strip%fluidity - rate**2)/rate**2) < 1e-12_wp, name//": heat and rate of shear")

    worst = 0
    do l = 1, 7
      above = strip
      below = strip
      above%fluidity(1, l) = strip%fluidity(1, l)*(1 + relative)
      below%fluidity(1, l) = strip%fluidity(1, l)*(1 - relative)
      call solve_twice(law, above, failures)
      call solve_twice(law, below, failures)
      call film_heat(seven, above, high, own, response_x, response_y, stress_x, stress_y)
      call film_heat(seven, below, low, own, response_x, response_y, stress_x, stress_y)
      call film_heat(seven, strip, heat, own, response_x, response_y, stress_x, stress_y)
      do k = 1, 7
        wanted = (high(1, k) - low(1, k))/(2*relative*strip%fluidity(1, l))
        derivative = -response_x(1, k)*stress_x(1, l) - response_y(1, k)*stress_y(1, l)
        if (k == l) derivative = derivative + own(1, k)
        worst = max(worst, abs(derivative - wanted)*strip%fluidity(1, l)/heat(1, k))
      end do
    end do
    call check(worst < 1e-6_wp, name//": derivatives of heat by the fluidities")
  end subroutine across_the_film

  !> The paper's form of the flow.
  subroutine factors()
    type(shear_strip) :: strip
    real(wp), dimension(1) :: x, y, cosine, sine, factor_s, factor_r, lag_s, lag_r
    real(wp) :: along, gradient
    integer :: failures

    call one_point(seven, 2e12_wp, 1e12_wp, 1.2_wp, -0.5_wp, strip)
    call solve_shear(newton, seven, strip, failures)
    call flow_factors(newton, seven, strip, cosine, sine, factor_s, factor_r, lag_s, lag_r)
    call close_to(factor_s(1), h**3/(12*eta), 1e-14_wp*h**3/eta, "Newtonian factor along the sliding")
    call close_to(factor_r(1), h**3/(12*eta), 1e-14_wp*h**3/eta, "Newtonian factor across the sliding")
    call check(abs(lag_s(1)) + abs(lag_r(1)) < 1e-14_wp, "uniform viscosity entrains at the mean speed")
    call close_to(sine(1), -0.5_wp/1.3_wp, 1e-15_wp, "direction of sliding")

    call skew_point(eyring, strip)
    call solve_shear(eyring, seven, strip, failures)
    call flow_deficit(seven, strip, x, y)
    call flow_factors(eyring, seven, strip, cosine, sine, factor_s, factor_r, lag_s, lag_r)
    along = cosine(1)*x(1) + sine(1)*y(1)
    gradient = cosine(1)*strip%px(1) + sine(1)*strip%py(1)
    call close_to(lag_s(1)*h + factor_s(1)*gradient, along, 1e-9_wp*abs(along), "factor and lag make up the flow")

    strip%fluidity = 1/eta
    strip%px = 0
    strip%py = 0
    call solve_shear(eyring, seven, strip, failures)
    call flow_factors(eyring, seven, strip, cosine, sine, factor_s, factor_r, lag_s, lag_r)
    along = hypot(strip%us(1), strip%vs(1))*eta/(h*tau0)
    call close_to(factor_s(1), h**3/(12*eta)*sqrt(1 + along**2), 1e-6_wp*factor_s(1), "Eyring factor along, no gradient")
    call close_to(factor_r(1), h**3/(12*eta)*along/asinh(along), 1e-6_wp*factor_r(1), "Eyring factor across, no gradient")
  end subroutine factors

  !> A strip that is not full, started from the solution: nothing changes but rounding.
  subroutine part_of_a_strip()
    type(shear_strip) :: strip, one
    real(wp) :: x(3), y(3), wanted(1), unused(1)
    integer :: failures, stat

    call skew_point(limited, one)
    call solve_shear(limited, seven, one, failures)
    call flow_deficit(seven, one, wanted, unused)
    call new_shear_strip(3, 7, strip, stat)
    strip%points = 2
    strip%film(:2) = one%film(1)
    strip%px(:2) = one%px(1)
    strip%py(:2) = one%py(1)
    strip%us(:2) = one%us(1)
    strip%vs(:2) = one%vs(1)
    strip%reference(:2) = one%reference(1)
    strip%limit(:2) = one%limit(1)
    strip%fluidity(:2, :) = spread(one%fluidity(1, :), 1, 2)
    strip%tau_x(:2) = one%tau_x(1)
    strip%tau_y(:2) = [one%tau_y(1), 0.0_wp]
    call solve_shear(limited, seven, strip, failures)
    call flow_deficit(seven, strip, x, y)
    call check(failures == 0 .and. all(abs(x(:2) - wanted(1)) < 1e-9_wp*abs(wanted(1))), &
      "guesses decide only how soon a film is solved")
  end subroutine part_of_a_strip

  !> Random points, many of them harder than a contact's: all are solved.
  subroutine hard_points(law, name)
    type(flow_law), intent(in) :: law
    character(len=*), intent(in) :: name
    integer, parameter :: points = 100, strips = 100
    type(shear_strip) :: strip
    real(wp) :: draw(points, 7), stress(points), worst, lacking(2), x, y, deficit(points, 2), extreme
    integer :: failures, stat, failed, trial, i, k, wrong, outside, slips

    call random_seed(put=[(271828 + i, i=1, 64)])
    call new_shear_strip(points, 7, strip, stat)
    failed = 0
    wrong = 0
    outside = 0
    slips = 0
    do trial = 1, strips
      call random_number(draw)
      strip%film = 1e-8_wp*1e3_wp**draw(:, 1)
      strip%reference = tau0
      strip%limit = tau0*(2 + 28*draw(:, 7))
      ! gradients that a film can bear: walls at most 30 tau0 apart, or 0.8 of what the limit allows
      stress = merge(1.6_wp*strip%limit, 30*tau0, has_limit(law))*draw(:, 2)**2
      strip%px = stress/strip%film*cos(7*draw(:, 3))
      strip%py = stress/strip%film*sin(7*draw(:, 3))
      do k = 1, 7
        strip%fluidity(:, k) = exp(10*(draw(:, 4) - 0.5_wp) + 7*(draw(:, 5) - 0.5_wp)*2*seven%z(k))
      end do
      stress = strip%film*exp(10*(draw(:, 4) - 0.5_wp))*tau0*10.0_wp**(14*draw(:, 6) - 2)
      strip%us = stress*cos(7*draw(:, 7))
      strip%vs = stress*sin(7*draw(:, 7))
      strip%tau_x = 0
      strip%tau_y = 0
      call solve_shear(law, seven, strip, failures)
      failed = failed + failures
      slips = slips + count(strip%slip > 0)
      call flow_deficit(seven, strip, deficit(:, 1), deficit(:, 2))
      do i = 1, points
        extreme = 0
        lacking = [strip%us(i), strip%vs(i)]
        worst = 0
        do k = 1, 7
          x = strip%tau_x(i) + seven%z(k)*strip%film(i)*strip%px(i)
          y = strip%tau_y(i) + seven%z(k)*strip%film(i)*strip%py(i)
          extreme = max(extreme, hypot(x, y))
          lacking = lacking - seven%weight(k)*strip%film(i)*strip%fluidity(i, k)*strip%g(i, k)*[x, y]
          worst = worst + seven%weight(k)*strip%film(i)*strip%fluidity(i, k)*strip%g(i, k)*hypot(x, y)
        end do
        if (.not. norm2(lacking) < 1e-8_wp*worst) wrong = wrong + 1
        if (has_limit(law) .and. .not. extreme < 1.05_wp*strip%limit(i)) outside = outside + 1
      end do
    end do
    write (*, "(a, 4(1x, i0))") "# "//name//": failed, wrong, outside, slipping", failed, wrong, outside, slips
    call check(failed == 0, name//": hard points converge")
    call check(wrong == 0, name//": hard points have the sliding asked for")
    call check(outside == 0, name//": hard points stay about the limiting circle")
  end subroutine hard_points

end program test_shear_flow
