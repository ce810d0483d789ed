!> Steps of film and heat together, of a sliding contact in Hertz units (`test_point_film`) whose heat thins its film much:
!> what is taken of each sweep is Aitken's share, and with it film and temperature settle.
program test_heated_step
  use pyworm_point_heat, only: point_film_heat, new_point_heat
  use pyworm_flow_laws, only: flow_law, law_newton
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  use pyworm_moving_source, only: moving_body, new_moving_body
  use pyworm_thermal_properties, only: oil_heat_law
  use pyworm_viscosity_density, only: oil_law, law_barus
  use pyworm_film_newton, only: contact_conditions, newton_step, shear_contact, film_residual, film_step
  use pyworm_point_film, only: point_contact, new_point_contact
  use pyworm_status, only: status_ok
  use tap, only: check, close_to, done
  use pyworm_thermal_step, only: heated_step
  implicit none(type, external)

  real(wp), parameter :: pi = acos(-1.0_wp), load = 2*pi/3, modulus = pi
  !> (M, L) = (20, 10): alpha p_H = (L/pi)(1.5 M)^(1/3), 12 eta0 u = (128 pi^3 / 3 M^4)^(1/3).
  real(wp), parameter :: m = 20, l = 10
  real(wp), parameter :: alpha = l/pi*(1.5_wp*m)**(1.0_wp/3)
  real(wp), parameter :: eta0 = (128*pi**3/(3*m**4))**(1.0_wp/3)/12
  !> Fall of the viscosity [1/K], velocity of either body less their mean, conductivity and rho c of oil and bodies.
  real(wp), parameter :: beta = 0.04_wp, half_slide = 0.1_wp, oil(2) = [0.034_wp, 2.0_wp], body(2) = [0.02_wp, 20.0_wp]
  integer, parameter :: n = 41, levels = 5
  real(wp), parameter :: dx = 6.0_wp/(n - 1)
  !> A point contact and its heat.
  type :: heated_contact
    type(point_contact) :: film
    type(point_film_heat) :: heat
  end type heated_contact

  type(heated_contact) :: contact
  real(wp) :: p(n, n), h0, residual, load_error
  integer :: stat

  call isothermal_film()
  call warm()
  call done()

contains

  !> The film at the inlet's temperature.
  subroutine isothermal_film()
    class(heated_body), allocatable :: body_1, body_2
    real(wp) :: gap(n, n)
    type(newton_step) :: step
    integer :: i, j, steps
    logical :: covered(n, n)

    do j = 1, n
      do i = 1, n
        gap(i, j) = ((-3.5_wp + dx*(i - 1))**2 + (-3 + dx*(j - 1))**2)/2
      end do
    end do
    covered = .true.
    call new_point_contact(contact%film, contact_conditions(gap, covered, [dx, dx], modulus, &
      oil_law(law_barus, eta0, alpha, 1.0_wp, 0.0_wp, 0.0_wp, 300.0_wp, beta), load, 1e-4_wp), 0*gap + 1, 0*gap, stat)
    call shear_contact(contact%film, flow_law(law_newton), levels, 0*gap - 2*half_slide, 0*gap, stat)
    p = sqrt(max(0.0_wp, 1 - 2*gap))
    h0 = -0.5_wp
    call film_residual(contact%film, p, h0, residual, load_error)
    do steps = 1, 20
      call film_step(contact%film, 0.03_wp, p, h0, residual, load_error, step, stat)
      if (residual + abs(load_error) < 1e-4_wp) exit
    end do
    call check(residual + abs(load_error) < 1e-4_wp, "the isothermal film converges")
    call new_body(1 + half_slide, body_1)
    call new_body(1 - half_slide, body_2)
    call new_point_heat(contact%heat, contact%film, oil_heat_law(conductivity=oil(1), capacity=oil(2)), &
      0*gap + 1 + half_slide, 0*gap, &
      body_1, body_2, [0.0_wp, 0.0_wp], stat)
    call check(stat == status_ok, "and is heated")
    call film_residual(contact%film, p, h0, residual, load_error)
  end subroutine isothermal_film

  !> A body that moves along x.
  subroutine new_body(velocity, made)
    real(wp), intent(in) :: velocity
    class(heated_body), allocatable, intent(out) :: made
    type(moving_body), allocatable :: moving

    allocate (moving)
    call new_moving_body(moving, n, n, dx, dx, velocity, 0.0_wp, body(1), body(2), stat)
    call move_alloc(moving, made)
  end subroutine new_body

  !> Where Newton's step is taken whole, the share of the sweep after it is
  !>   -share' sum w' (w - w')/sum (w - w')^2,
  !> w being what the sweep wanted to change and ' the step before (Kuettler and Wall 2008, eq. 44), between an eighth and
  !> one; a half at most where the film did not bear that at once.
  subroutine warm()
    integer, parameter :: most = 40
    real(wp), allocatable :: before(:, :, :), wanted(:, :, :)
    real(wp) :: share_before, share
    type(newton_step) :: step
    logical :: judged(n, n, levels)
    integer :: steps, extrapolated

    extrapolated = 0
    do steps = 1, most
      before = contact%heat%wanted
      share_before = contact%heat%last_fraction
      call heated_step(contact%film, contact%heat, 0.03_wp, p, h0, residual, load_error, step, stat)
      if (stat /= status_ok .or. (step%change < 1e-2_wp .and. residual < 1e-3_wp)) exit
      if (steps == 1 .or. step%damping < 1) cycle
      wanted = contact%heat%wanted
      judged = spread(contact%film%model%fields%p > 0.02_wp*maxval(contact%film%model%fields%p), 3, levels)
      share = -share_before*sum(before*(wanted - before), judged)/sum((wanted - before)**2, judged)
      if (share > 0.125_wp .and. share < 1) extrapolated = extrapolated + 1
      share = min(max(share, 0.125_wp), 1.0_wp)
      ! a half may be the bound
      if (share < 0.5_wp .or. abs(contact%heat%fraction - 0.5_wp) > 0) then
        call close_to(contact%heat%fraction, share, 1e-9_wp, "Aitken's share")
      end if
    end do
    call check(extrapolated >= 5, "sweeps that overshoot are shortened")
    call check(stat == status_ok .and. step%change < 1e-2_wp .and. residual < 1e-3_wp, "film and temperature settle")
    call check(maxval(contact%film%model%shear%nodes%rise) > 1/beta, "where heat changes the viscosity much")
  end subroutine warm

end program test_heated_step
