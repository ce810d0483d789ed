!> Temperature of a line contact's film: thermal Couette flow, heat carried by a film of one velocity, compression,
!> partition of heat between fast bodies, its balance, opposite flow and its mirror image.
program test_line_heat
  use pyworm_film_newton, only: set_transient_term, shear_contact, film_residual
  use pyworm_flow_laws, only: flow_law, law_newton
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  use pyworm_line_film, only: line_contact, new_line_contact
  use pyworm_line_source, only: line_body, new_line_body
  use pyworm_shear_fields, only: shear_field, nodal_shear
  use pyworm_line_heat, only: line_film_heat, new_line_heat
  use pyworm_thermal_properties, only: oil_heat_law
  use pyworm_thermal_step, only: heat_sweep
  use pyworm_viscosity_density, only: oil_law, law_barus
  use pyworm_status, only: status_ok
  use tap, only: check, close_to, done
  implicit none(type, external)

  integer, parameter :: n = 121, levels = 9
  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Film between parallel walls [m], spacing [m], viscosity [Pa s], its exponent [1/K], conductivity [W/(m K)].
  real(wp), parameter :: h = 1e-6_wp, dx = 2e-6_wp, eta = 0.05_wp, beta = 0.04_wp, k = 0.14_wp
  !> Temperature of the inlet [K].
  real(wp), parameter :: inlet = 300
  !> Walls that no heat warms, and steel: conductivity and rho c.
  real(wp), parameter :: mirror(2) = [1e9_wp, 1e12_wp], steel(2) = [47.0_wp, 3.7e6_wp]
  !> A line contact and its heat.
  type :: heated_line
    type(line_contact) :: film
    type(line_film_heat) :: heat
  end type heated_line

  integer :: stat

  call couette(8.0_wp)
  call couette(50.0_wp)
  call convection(1.0_wp)
  call convection(-1.0_wp)
  call compression(10.0_wp)
  call compression(-10.0_wp)
  call partition()
  call reversed()
  call done()

contains

  !> A field of a line contact as the film takes it.
  pure function on_nodes(a) result(field)
    real(wp), intent(in) :: a(:)
    real(wp) :: field(size(a), 1)

    field(:, 1) = a
  end function on_nodes

  !> An oil of which a viscosity [Pa s] and its exponent [1/K] are given.
  pure type(oil_law) function thinned(exponent)
    real(wp), intent(in) :: exponent

    thinned = oil_law(law_barus, eta, 2e-8_wp, 1.0_wp, 0.0_wp, 0.0_wp, inlet, exponent)
  end function thinned

  !> A film of constant thickness h between bodies of the velocities u1 and u2 [m/s]; `capacity` rho c of the oil
  !> [J/(m3 K)], `slope` of the pressure [Pa/m], which is zero at the first node.
  subroutine new_film(contact, u1, u2, oil, capacity, body, bulk, slope)
    type(heated_line), intent(inout) :: contact
    real(wp), intent(in) :: u1, u2, capacity, body(2), bulk(2), slope
    type(oil_law), intent(in) :: oil
    class(heated_body), allocatable :: body_1, body_2
    type(line_body), allocatable :: moving
    real(wp) :: field(n), residual, load_error
    integer :: i
    logical :: covered(n)

    covered = .true.
    field = 1
    ! bodies so stiff that no pressure bends them
    call new_line_contact(contact%film, 0*field, covered, (u1 + u2)/2*field, dx, 1e30_wp, oil, 1e5_wp, &
      1e-9_wp, stat)
    if (stat == status_ok) call set_transient_term(contact%film, 0.0_wp, on_nodes(1e-6_wp*field), stat)
    call check(stat == status_ok, "a contact is made")
    call shear_contact(contact%film, flow_law(law_newton), levels, on_nodes((u2 - u1)*field), on_nodes(0*field), stat)
    allocate (moving)
    call new_line_body(moving, n, dx, u1, body(1), body(2), stat)
    call move_alloc(moving, body_1)
    allocate (moving)
    call new_line_body(moving, n, dx, u2, body(1), body(2), stat)
    call move_alloc(moving, body_2)
    call new_line_heat(contact%heat, contact%film, oil_heat_law(conductivity=k, capacity=capacity), u1*field, body_1, body_2, &
      bulk, stat)
    call check(stat == status_ok, "and heated")
    field = [(slope*(i - 1)*dx, i=1, n)]
    call film_residual(contact%film, on_nodes(field), h, residual, load_error)
  end subroutine new_film

  !> Sweeps until the temperature stands still, but for the rounding of surfaces in single precision.
  subroutine settle(contact, most)
    type(heated_line), intent(inout) :: contact
    integer, intent(in) :: most
    real(wp) :: before(n, levels), change
    integer :: sweep

    do sweep = 1, most
      before = contact%film%model%shear%nodes%rise(:, 1, :)
      call heat_sweep(contact%film, contact%heat, change, stat)
      change = maxval(abs(contact%film%model%shear%nodes%rise(:, 1, :) - before))
      if (change < 1e-5_wp) exit
    end do
    call check(change < 1e-5_wp, "the temperature settles")
  end subroutine settle

  !> Walls that stay cold: T = ln(1 + Na/8)/beta halfway, tau = eta us/h asinh(x)/(x sqrt(1 + x2)), x = sqrt(Na/8).
  subroutine couette(nahme)
    real(wp), intent(in) :: nahme
    type(heated_line) :: contact
    type(shear_field) :: field
    real(wp) :: us, x, tau

    us = sqrt(nahme*k/(beta*eta))
    x = sqrt(nahme/8)
    call new_film(contact, 10 - us/2, 10 + us/2, thinned(beta), 0.0_wp, mirror, [0.0_wp, 0.0_wp], 0.0_wp)
    call settle(contact, 40)
    call nodal_shear(contact%film, .false., field, stat)
    tau = eta*us/h*asinh(x)/(x*sqrt(1 + x**2))
    call close_to(contact%film%model%shear%nodes%rise(n/2, 1, levels/2 + 1), log(1 + nahme/8)/beta, &
      4e-4_wp*log(1 + nahme/8)/beta, "temperature of thermal Couette flow")
    call close_to(field%stress_x(n/2, 1), tau, 4e-4_wp*tau, "and its stress")
  end subroutine couette

  !> Oil of one velocity that enters cold between walls of 1 K: the mean difference to the walls falls along the film as
  !> 8/pi2 exp(-pi2 k x/(rho c u h2)), once higher modes are gone (a plug flow's Graetz number).
  subroutine convection(velocity)
    real(wp), intent(in) :: velocity
    real(wp), parameter :: capacity = 1e8_wp
    type(heated_line) :: contact
    real(wp) :: wanted, got, mean(2)
    integer :: node(2)

    call new_film(contact, velocity, velocity, thinned(0.0_wp), capacity, mirror, [1.0_wp, 1.0_wp], 0.0_wp)
    contact%film%model%shear%nodes%rise([1, n], 1, 2:levels - 1) = 0
    call settle(contact, 5)
    node = [61, 101]
    if (velocity < 0) node = n + 1 - node
    associate (levels_here => contact%film%model%shear%nodes%levels, rise => contact%film%model%shear%nodes%rise)
      mean(1) = sum(levels_here%weight*rise(node(1), 1, :))
      mean(2) = sum(levels_here%weight*rise(node(2), 1, :))
    end associate
    wanted = -pi**2*k*40*dx/(capacity*abs(velocity)*h**2)
    got = log((1 - mean(2))/(1 - mean(1)))
    call close_to(got, wanted, 1e-3_wp*abs(wanted), "heat is carried along the film")
  end subroutine convection

  !> Oil that moves with both walls up a gradient of pressure: k T'' = -eps U p' (T0 + T), so that halfway it is
  !> T0 [1/cos(m h/2) - 1] warmer than cold walls, m2 = eps U p'/k; down the gradient the cosine is a hyperbolic one.
  subroutine compression(velocity)
    real(wp), intent(in) :: velocity
    real(wp), parameter :: slope = 1e13_wp, eps = 7.1e-4_wp, decay = 1.5e-9_wp
    !> So thick an oil that the gradient moves it no more than 1e-5 of the walls' speed.
    type(oil_law), parameter :: thick = oil_law(law_barus, 1e4_wp, 0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp, inlet, 0.0_wp, eps, decay)
    type(heated_line) :: contact
    real(wp) :: half, wanted
    integer :: node

    call new_film(contact, velocity, velocity, thick, 0.0_wp, mirror, [0.0_wp, 0.0_wp], slope)
    call settle(contact, 60)
    do node = 9, 33, 8
      half = sqrt(eps*exp(-decay*slope*(node - 1)*dx)*abs(velocity)*slope/k)*h/2
      wanted = inlet*(1/merge(cos(half), cosh(half), velocity > 0) - 1)
      call close_to(contact%film%model%shear%nodes%rise(node, 1, levels/2 + 1), wanted, 1e-3_wp, &
        "compression warms, expansion cools")
    end do
  end subroutine compression

  !> Fast bodies under the heat of constant viscosity: alike in both, q = eta us2/(2 h), they are as warm as
  !> 2 q sqrt(x/(pi k rho c u)), the slower one more; and all heat is accounted for.
  subroutine partition()
    type(heated_line) :: contact
    type(shear_field) :: field
    real(wp), parameter :: u1 = 39, u2 = 41
    real(wp) :: q, x

    call new_film(contact, u1, u2, thinned(0.0_wp), 0.0_wp, steel, [0.0_wp, 0.0_wp], 0.0_wp)
    call settle(contact, 40)
    call nodal_shear(contact%film, .false., field, stat)
    q = eta*(u2 - u1)**2/(2*h)
    x = 99*dx
    associate (wall => contact%heat%walls%wall(:, 1, :), flux => contact%heat%walls%flux(:, 1, :))
      call close_to((wall(101, 1) + wall(101, 2))/2, 2*q*sqrt(x/(pi*steel(1)*steel(2)*(u1 + u2)/2)), &
        1e-2_wp*wall(101, 1), "fast bodies are as warm as heat that flows into depth makes them")
      call check(wall(101, 1) > wall(101, 2), "the slower one more")
      call close_to((sum(flux) + sum(contact%heat%carried))/sum(field%friction), 1.0_wp, 1e-8_wp, "no heat is lost")
    end associate
  end subroutine partition

  !> The opposite velocities make the mirror image, also of a film that flows both ways.
  subroutine reversed()
    type(heated_line) :: forth, back
    real(wp) :: rise(n, levels)

    call new_film(forth, 4.0_wp, -1.0_wp, thinned(beta), 1.7e6_wp, steel, [5.0_wp, 0.0_wp], 0.0_wp)
    call settle(forth, 200)
    call new_film(back, -4.0_wp, 1.0_wp, thinned(beta), 1.7e6_wp, steel, [5.0_wp, 0.0_wp], 0.0_wp)
    call settle(back, 200)
    rise = back%film%model%shear%nodes%rise(n:1:-1, 1, :)
    call close_to(maxval(abs(rise - forth%film%model%shear%nodes%rise(:, 1, :))), 0.0_wp, 1e-6_wp*maxval(rise), "the mirror image")
  end subroutine reversed

end program test_line_heat
