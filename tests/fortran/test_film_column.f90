!> Energy across the film: exact thermal Couette flow, polynomials, convection, the heat balance and the
!> derivatives.
program test_film_column
  use pyworm_film_column, only: film_strip, new_film_strip, solve_columns, warm_walls
  use pyworm_gauss_lobatto, only: new_levels
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_bad_argument
  use tap, only: check, close_to, done
  implicit none(type, external)

  !> Film [m] and conductivity [W/(m K)].
  real(wp), parameter :: h = 0.7e-6_wp, k_oil = 0.16_wp
  integer, parameter :: counts(5) = [3, 5, 7, 9, 11]
  integer :: j

  call sheared_films()
  do j = 1, size(counts)
    call polynomial_source(counts(j))
    call balance_and_derivatives(counts(j))
  end do
  call absorbing_film()
  call runaway_without_relief()
  call refusals()
  call done()

contains

  !> Thermal Couette flow from cold: spectral convergence for every Nahme number.
  subroutine sheared_films()
    real(wp), parameter :: nahme(5) = [0.1_wp, 1.0_wp, 8.0_wp, 50.0_wp, 500.0_wp]
    !> Twice the error of beta times the middle's rise measured with 3, 5, ... levels.
    real(wp), parameter :: within(5, 5) = reshape([ &
      5e-5_wp, 1e-8_wp, 1e-11_wp, 1e-11_wp, 1e-11_wp, &
      4e-3_wp, 1.2e-5_wp, 6e-8_wp, 4e-10_wp, 1e-11_wp, &
      4e-2_wp, 3e-3_wp, 9e-5_wp, 3e-6_wp, 1.3e-7_wp, &
      0.23_wp, 3e-2_wp, 6e-3_wp, 8e-4_wp, 9e-5_wp, &
      1.1_wp, 0.17_wp, 1.8e-2_wp, 1.6e-2_wp, 6e-3_wp], [5, 5])
    real(wp) :: rise(5), stress(5)
    integer :: i, n

    do i = 1, size(nahme)
      do n = 1, size(counts)
        call couette(counts(n), nahme(i), rise(n), stress(n))
        call check(abs(rise(n)) < within(n, i), "thermal Couette flow")
      end do
      call check(abs(stress(3)) < 0.016_wp*within(3, i)/1.8e-2_wp + 1e-11_wp, "its stress")
      write (*, "(a, f6.1, 5(2x, 2es9.1))") "# Na", nahme(i), (rise(n), stress(n), n=1, size(counts))
    end do
  end subroutine sheared_films

  !> Film of n levels sheared between walls at one temperature, viscosity falling exponentially with
  !> temperature, by Newton's method from cold: errors of beta times the middle's rise, ln(1 + Na/8), and of
  !> the stress over that without heating, asinh(x)/(x sqrt(1 + x2)) with x2 = Na/8 (Gavis and Laurence 1968).
  subroutine couette(n, na, rise_error, stress_error)
    integer, intent(in) :: n
    real(wp), intent(in) :: na
    real(wp), intent(out) :: rise_error, stress_error
    !> More than one group of columns, and an incomplete one, in a strip with room for more.
    integer, parameter :: columns = 19, room = 24, most = 300
    !> Viscosity at the wall [Pa s] and its decay [1/K].
    real(wp), parameter :: eta1 = 0.2_wp, beta = 0.04_wp, wall = 300
    type(film_strip) :: strip
    real(wp) :: speed, x, stress, fluidity(n), share(n)
    logical :: settled
    integer :: stat, step, c

    call new_film_strip(strip, room, new_levels(n), stat)
    strip%columns = columns
    speed = sqrt(na*k_oil/(beta*eta1))
    strip%thickness = h
    strip%conductivity = k_oil
    strip%wall = wall
    strip%absorption = 0
    strip%loading(:, :, 2) = 0
    strip%relief(:, :, 2) = 0
    strip%known = wall
    strip%wall(columns + 1:, :) = huge(1.0_wp)
    strip%known(columns + 1:, :) = -huge(1.0_wp)
    do step = 1, most
      do c = 1, columns
        fluidity = exp(beta*(strip%known(c, :) - wall))/eta1
        share = strip%levels%weight*fluidity/sum(strip%levels%weight*fluidity)
        stress = speed/h/sum(strip%levels%weight*fluidity)
        strip%source(c, :) = stress**2*fluidity
        strip%growth(c, :) = beta*strip%source(c, :)
        strip%loading(c, :, 1) = 2*stress*fluidity
        strip%relief(c, :, 1) = beta*stress*share
      end do
      call solve_columns(strip)
      settled = maxval(abs(strip%temperature(:columns, :) - strip%known(:columns, :))) < 1e-11_wp/beta
      strip%known(:columns, :) = strip%temperature(:columns, :)
      if (settled) exit
    end do
    call check(settled .and. (step <= 12 .or. na > 10) .and. (step <= 30 .or. na > 100), "Newton's method converges")
    x = sqrt(na/8)
    rise_error = beta*(strip%temperature(columns, (n + 1)/2) - wall) - log(1 + na/8)
    stress_error = stress*h/(eta1*speed) - asinh(x)/(x*sqrt(1 + x**2))
  end subroutine couette

  !> Sources up to the second degree across the film (to the zeroth for a parabola), between unequal walls.
  subroutine polynomial_source(n)
    integer, intent(in) :: n
    integer, parameter :: columns = 3
    real(wp), parameter :: mean = 350, difference = 20
    type(film_strip) :: strip
    real(wp) :: s(0:2), z(n), exact(n), q(2)
    integer :: stat, c

    call new_film_strip(strip, columns, new_levels(n), stat)
    z = strip%levels%z
    s = merge([3e13_wp, 1e13_wp, 9e13_wp], [3e13_wp, 0.0_wp, 0.0_wp], n > 3)
    strip%thickness = h
    strip%conductivity = k_oil
    strip%wall(:, 1) = mean - difference/2
    strip%wall(:, 2) = mean + difference/2
    strip%absorption = 0
    strip%growth = 0
    strip%loading = 0
    strip%relief = 0
    strip%known = 300
    do c = 1, columns
      strip%source(c, :) = s(0) + s(1)*z + s(2)*z**2
    end do
    call solve_columns(strip)
    exact = mean + difference*z &
      + h**2/k_oil*(s(0)*(1 - 4*z**2)/8 + s(1)*(z - 4*z**3)/24 + s(2)*(1 - 16*z**4)/192)
    q = h*(s(0)/2 + s(1)*[-1, 1]/12 + s(2)/24) + k_oil/h*difference*[1, -1]
    call close_to(maxval(abs(strip%temperature(columns, :) - exact)), 0.0_wp, 1e-10_wp, "temperature is the polynomial")
    call close_to(maxval(abs(strip%flux(columns, :) - q)), 0.0_wp, 1e-9_wp*q(1), "and so is the flux into the bodies")
    call close_to(maxval(abs(strip%admittance(columns, :, :) - k_oil/h*reshape([-1, 1, 1, -1], [2, 2]))), 0.0_wp, &
      1e-10_wp*k_oil/h, "a film without more conducts")
  end subroutine polynomial_source

  !> Everything at once: what is dissipated is convected away or enters the walls, and derivatives are those
  !> of a second solution with other walls, since all is linear.
  subroutine balance_and_derivatives(n)
    integer, intent(in) :: n
    integer, parameter :: columns = 5
    type(film_strip) :: strip, other
    real(wp) :: heat, convected, change(n), scale
    integer :: stat, c, k

    call new_film_strip(strip, columns, new_levels(n), stat)
    do c = 1, columns
      strip%thickness(c) = h*c
      strip%conductivity(c) = k_oil*(1 + 0.1_wp*c)
      strip%wall(c, :) = [330 + c, 345 - 2*c]
      do k = 1, n
        scale = strip%conductivity(c)/strip%thickness(c)**2
        strip%known(c, k) = 320 + modulo(7*k + c, 5)
        strip%source(c, k) = 40*scale*(1 + modulo(3*k + 2*c, 7))
        strip%absorption(c, k) = scale*modulo(k*k + c, 4)
        ! below the bounds on growth, whose part left out would be missing
        strip%growth(c, k) = scale*modulo(5*k + c, 6)/5
        strip%loading(c, k, :) = 1e7_wp*[1.0_wp + modulo(k, 3), -0.5_wp*modulo(k + c, 2)]
        strip%relief(c, k, :) = scale/n/1e7_wp*[0.7_wp, -0.2_wp]
      end do
    end do
    call solve_columns(strip)
    do c = 1, columns
      change = strip%temperature(c, :) - strip%known(c, :)
      heat = 0
      convected = 0
      do k = 1, n
        heat = heat + strip%thickness(c)*strip%levels%weight(k)*(strip%source(c, k) + strip%growth(c, k)*change(k) &
          - dot_product(strip%loading(c, k, :), matmul(change, strip%relief(c, :, :))))
        convected = convected + strip%thickness(c)*strip%levels%weight(k)*strip%absorption(c, k)*strip%temperature(c, k)
      end do
      call close_to(sum(strip%flux(c, :)), heat - convected, 1e-11_wp*(heat + convected), "no heat is lost")
    end do

    other = strip
    other%wall(:, 1) = strip%wall(:, 1) + 13
    other%wall(:, 2) = strip%wall(:, 2) - 29
    call solve_columns(other)
    call warm_walls(strip, other%wall - strip%wall)
    call close_to(maxval(abs(strip%temperature - other%temperature)), 0.0_wp, 1e-9_wp, "levels follow the walls")
    call close_to(maxval(abs(strip%flux - other%flux)), 0.0_wp, 1e-9_wp*maxval(abs(other%flux)), "so do the fluxes")
  end subroutine balance_and_derivatives

  !> A film with a source, from which oil carries heat in proportion to temperature: a hyperbolic cosine.
  subroutine absorbing_film()
    integer, parameter :: n = 11
    real(wp), parameter :: wall = 20, rest = 80, m = 3
    type(film_strip) :: strip
    real(wp) :: exact(n)
    integer :: stat

    call new_film_strip(strip, 1, new_levels(n), stat)
    strip%thickness = h
    strip%conductivity = k_oil
    strip%wall = wall
    strip%absorption = k_oil*(m/h)**2
    strip%source = strip%absorption*rest
    strip%growth = 0
    strip%loading = 0
    strip%relief = 0
    strip%known = 0
    call solve_columns(strip)
    exact = rest + (wall - rest)*cosh(m*strip%levels%z)/cosh(m/2)
    call close_to(maxval(abs(strip%temperature(1, :) - exact)), 0.0_wp, 1e-7_wp, "absorption levels the temperature")
    call close_to(strip%flux(1, 2), k_oil/h*m*(rest - wall)*tanh(m/2), 1e-9_wp*k_oil/h*rest, "and draws on the walls")
  end subroutine absorbing_film

  !> Heat that grows without relief faster than conduction carries it off has no steady state; the step stays
  !> sane.
  subroutine runaway_without_relief()
    integer, parameter :: n = 7
    type(film_strip) :: strip
    integer :: stat

    call new_film_strip(strip, 1, new_levels(n), stat)
    strip%thickness = h
    strip%conductivity = k_oil
    strip%wall = 300
    strip%known = 300
    strip%absorption = 0
    strip%source = 8*k_oil/h**2
    strip%growth = 1e4_wp*k_oil/h**2
    strip%loading = 0
    strip%relief = 0
    call solve_columns(strip)
    ! conduction alone gives a rise of one kelvin in the middle
    call check(maxval(abs(strip%temperature - 300)) < 10, "a runaway is held")
  end subroutine runaway_without_relief

  subroutine refusals()
    type(film_strip) :: strip
    integer :: stat

    call new_film_strip(strip, 0, new_levels(5), stat)
    call check(stat == status_bad_argument, "no columns are refused")
    call new_film_strip(strip, 4, new_levels(2), stat)
    call check(stat == status_bad_argument, "walls alone are refused")
    call new_film_strip(strip, 4, new_levels(3), stat)
    call check(stat == status_ok, "one inner level is enough")
  end subroutine refusals

end program test_film_column
