!> Temperature of a point contact's film: thermal Couette flow, conductivity under pressure, heat of compression, heat
!> carried in all directions, also across the entrainment, the balance of heat, and what is taken of a sweep that
!> overshoots.
program test_point_heat
  use pyworm_point_heat, only: point_film_heat, new_point_heat
  use pyworm_flow_laws, only: flow_law, law_newton
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  use pyworm_moving_source, only: moving_body, new_moving_body
  use pyworm_shear_fields, only: shear_field, nodal_shear
  use pyworm_thermal_properties, only: oil_heat_law
  use pyworm_viscosity_density, only: oil_law, law_barus
  use pyworm_film_newton, only: contact_conditions, shear_contact, set_transient_term, film_residual
  use pyworm_point_film, only: point_contact, new_point_contact
  use pyworm_status, only: status_ok
  use tap, only: check, close_to, done
  use pyworm_thermal_step, only: heat_sweep
  implicit none(type, external)

  integer, parameter :: levels = 9, halfway = 5
  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Film between parallel walls [m], spacing [m], viscosity [Pa s], its exponent [1/K], conductivity [W/(m K)].
  real(wp), parameter :: h = 1e-6_wp, dx = 2e-6_wp, eta = 0.05_wp, beta = 0.04_wp, k = 0.14_wp
  !> Temperature of the inlet [K].
  real(wp), parameter :: inlet = 300
  !> Walls that no heat warms, and steel: conductivity and rho c.
  real(wp), parameter :: mirror(2) = [1e9_wp, 1e12_wp], steel(2) = [47.0_wp, 3.7e6_wp]
  !> An oil of constant viscosity.
  type(oil_law), parameter :: constant = oil_law(law_barus, eta, 0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp, inlet)
  !> A point contact and its heat.
  type :: heated_contact
    type(point_contact) :: film
    type(point_film_heat) :: heat
  end type heated_contact

  integer :: stat

  call couette([1.0_wp, 0.0_wp], 8.0_wp)
  call couette([-0.6_wp, 0.8_wp], 50.0_wp)
  call conduction_under_pressure()
  call compression([1.0_wp, 0.0_wp])
  call compression([-1.0_wp, 0.0_wp])
  call compression([0.0_wp, 1.0_wp])
  call compression([0.0_wp, -1.0_wp])
  call convection([1.0_wp, 0.0_wp])
  call convection([-1.0_wp, 0.0_wp])
  call convection([0.0_wp, 1.0_wp])
  call convection([0.0_wp, -1.0_wp])
  call convection([1.0_wp, 0.5_wp])
  call convection([-0.4_wp, 1.0_wp])
  call convection([1.0_wp, -1.0_wp])
  call turned(0.1_wp)
  call turned(-0.1_wp)
  call balance()
  call done()

contains

  !> A film of constant thickness h between bodies of the velocities u1 and u2 [m/s] at the pressure `p` [Pa]; `body` is
  !> their conductivity and rho c, `bulk` their temperature above the inlet's [K].
  subroutine new_film(contact, u1, u2, oil, heat, body, bulk, p)
    type(heated_contact), intent(inout) :: contact
    real(wp), intent(in) :: u1(2), u2(2), body(2), bulk(2)
    real(wp), contiguous, intent(in) :: p(:, :)
    type(oil_law), intent(in) :: oil
    type(oil_heat_law), intent(in) :: heat
    class(heated_body), allocatable :: body_1, body_2
    real(wp) :: field(size(p, 1), size(p, 2)), residual, load_error
    logical :: covered(size(p, 1), size(p, 2))

    covered = .true.
    field = 1
    ! bodies so stiff that no pressure bends them
    call new_point_contact(contact%film, contact_conditions(0*field, covered, [dx, dx], 1e30_wp, oil, 1.0_wp, 1e-9_wp), &
      (u1(1) + u2(1))/2*field, (u1(2) + u2(2))/2*field, stat)
    if (stat == status_ok) call set_transient_term(contact%film, 0.0_wp, 1e-6_wp*field, stat)
    call check(stat == status_ok, "a contact is made")
    call shear_contact(contact%film, flow_law(law_newton), levels, (u2(1) - u1(1))*field, &
      (u2(2) - u1(2))*field, stat)
    call new_body(shape(p), u1, body, body_1)
    call new_body(shape(p), u2, body, body_2)
    call new_point_heat(contact%heat, contact%film, heat, u1(1)*field, u1(2)*field, body_1, body_2, bulk, stat)
    call check(stat == status_ok, "and heated")
    call film_residual(contact%film, p, h, residual, load_error)
  end subroutine new_film

  !> A body of this conductivity and rho c that moves with this velocity.
  subroutine new_body(nodes, velocity, body, made)
    integer, intent(in) :: nodes(2)
    real(wp), intent(in) :: velocity(2), body(2)
    class(heated_body), allocatable, intent(out) :: made
    type(moving_body), allocatable :: moving

    allocate (moving)
    call new_moving_body(moving, nodes(1), nodes(2), dx, dx, velocity(1), velocity(2), body(1), body(2), stat)
    call move_alloc(moving, made)
  end subroutine new_body

  !> Sweeps until the temperature stands still, but for the rounding of surfaces in single precision.
  subroutine settle(contact, most)
    type(heated_contact), intent(inout) :: contact
    integer, intent(in) :: most
    real(wp), allocatable :: before(:, :, :)
    real(wp) :: change
    integer :: sweep

    do sweep = 1, most
      before = contact%film%model%shear%nodes%rise
      call heat_sweep(contact%film, contact%heat, change, stat)
      change = maxval(abs(contact%film%model%shear%nodes%rise - before))
      if (change < 1e-5_wp) exit
    end do
    call check(change < 1e-5_wp, "the temperature settles")
  end subroutine settle

  !> Walls that stay cold: T = ln(1 + Na/8)/beta halfway, tau = eta us/h asinh(x)/(x sqrt(1 + x2)), x = sqrt(Na/8)
  !> (Gavis and Laurence 1968), whichever way they slide.
  subroutine couette(way, nahme)
    real(wp), intent(in) :: way(2), nahme
    integer, parameter :: n = 17, middle = 9
    type(heated_contact) :: contact
    type(shear_field) :: field
    real(wp) :: us, x, tau

    us = sqrt(nahme*k/(beta*eta))
    x = sqrt(nahme/8)
    call new_film(contact, (10 - us/2)*way, (10 + us/2)*way, oil_law(law_barus, eta, 2e-8_wp, 1.0_wp, 0.0_wp, 0.0_wp, &
      inlet, beta), oil_heat_law(conductivity=k), mirror, [0.0_wp, 0.0_wp], spread(spread(0.0_wp, 1, n), 2, n))
    call settle(contact, 60)
    call nodal_shear(contact%film, .false., field, stat)
    tau = eta*us/h*asinh(x)/(x*sqrt(1 + x**2))
    call close_to(contact%film%model%shear%nodes%rise(middle, middle, halfway), log(1 + nahme/8)/beta, &
      4e-4_wp*log(1 + nahme/8)/beta, "temperature of thermal Couette flow")
    call close_to(field%stress_x(middle, middle), tau*way(1), 4e-4_wp*tau, "its stress along x")
    call close_to(field%stress_y(middle, middle), tau*way(2), 4e-4_wp*tau, "and along y")
  end subroutine couette

  !> Without change of viscosity the film is eta us2/(8 k) warmer than cold walls; k is that at the pressure
  !> (Sharif et al. 2001, appendix).
  subroutine conduction_under_pressure()
    integer, parameter :: n = 17, middle = 9
    real(wp), parameter :: us = 20, pressure = 1e9_wp
    type(heated_contact) :: contact
    real(wp) :: p(n, n)

    p = pressure
    call new_film(contact, [10 - us/2, 0.0_wp], [10 + us/2, 0.0_wp], constant, &
      oil_heat_law(conductivity=k, c1=1.56e-9_wp, c2=0.61e-9_wp), mirror, [0.0_wp, 0.0_wp], p)
    call settle(contact, 5)
    call close_to(contact%film%model%shear%nodes%rise(middle, middle, halfway), eta*us**2/(8*k*(3.17_wp/1.61_wp)), &
      1e-6_wp, "oil conducts better under pressure")
  end subroutine conduction_under_pressure

  !> Oil that moves with both walls up a gradient of pressure: k T'' = -eps U p' (T0 + T), so that halfway it is
  !> T0 [1/cos(m h/2) - 1] warmer than cold walls, m2 = eps U p'/k; down the gradient the cosine is a hyperbolic one.
  subroutine compression(way)
    real(wp), intent(in) :: way(2)
    integer, parameter :: n = 33, middle = 17, inlet_side = 9
    real(wp), parameter :: speed = 10, slope = 1e13_wp, eps = 7.1e-4_wp, decay = 1.5e-9_wp
    !> So thick an oil that the gradient moves it no more than 1e-5 of the walls' speed.
    type(oil_law), parameter :: thick = oil_law(law_barus, 1e4_wp, 0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp, inlet, 0.0_wp, &
      eps, decay)
    type(heated_contact) :: contact
    type(shear_field) :: field
    real(wp) :: p(n, n), x(n, n)
    integer :: i, at(2)

    do i = 1, n
      x(i, :) = (i - 1)*dx
    end do
    if (abs(way(2)) > 0) x = transpose(x)
    p = slope*x
    call new_film(contact, speed*way, speed*way, thick, oil_heat_law(conductivity=k), mirror, [0.0_wp, 0.0_wp], p)
    call settle(contact, 60)
    do i = inlet_side, middle, middle - inlet_side
      at = merge([i, middle], [middle, i], abs(way(1)) > 0)
      associate (rise => contact%film%model%shear%nodes%rise(at(1), at(2), halfway), &
          m2 => eps*exp(-decay*p(at(1), at(2)))*speed*slope/k)
        if (sum(way) > 0) then
          call close_to(rise, inlet*(1/cos(sqrt(m2)*h/2) - 1), 1e-3_wp, "compression warms")
        else
          call close_to(rise, inlet*(1/cosh(sqrt(m2)*h/2) - 1), 1e-3_wp, "expansion cools")
        end if
      end associate
    end do
    ! what the gradient drives is all that shears
    call nodal_shear(contact%film, .false., field, stat)
    call close_to(field%friction(middle, middle), slope**2*h**3/(12*thick%eta0), 1e-6_wp, "heat of Poiseuille flow")
  end subroutine compression

  !> Oil of one velocity that enters cold between walls of 1 K: the mean difference to the walls falls along the film as
  !> 8/pi2 exp(-pi2 k x/(rho c u h2)), once higher modes are gone (a plug flow's Graetz number), x being the way from
  !> the side by which oil comes in.
  subroutine convection(velocity)
    real(wp), intent(in) :: velocity(2)
    integer, parameter :: length = 81, width = 61, place(2) = [31, 51], beside = 55
    real(wp), parameter :: capacity = 1e8_wp
    type(heated_contact) :: contact
    real(wp) :: wanted, got, mean(2)
    integer :: nodes(2), at(2, 2), i
    logical :: along_x

    along_x = abs(velocity(1)) >= abs(velocity(2))
    nodes = merge([length, width], [width, length], along_x)
    call new_film(contact, velocity, velocity, constant, oil_heat_law(conductivity=k, capacity=capacity), mirror, &
      [1.0_wp, 1.0_wp], spread(spread(0.0_wp, 1, nodes(1)), 2, nodes(2)))
    call let_in_cold(contact)
    call settle(contact, 20)
    do i = 1, 2
      ! at places whose oil came in by the near end, not by a side
      at(:, i) = merge([place(i), beside], [beside, place(i)], along_x)
      where (velocity < 0) at(:, i) = nodes + 1 - at(:, i)
      associate (levels_here => contact%film%model%shear%nodes%levels, rise => contact%film%model%shear%nodes%rise)
        mean(i) = sum(levels_here%weight*rise(at(1, i), at(2, i), :))
      end associate
    end do
    wanted = -pi**2*k*20*dx/(capacity*maxval(abs(velocity))*h**2)
    got = log((1 - mean(2))/(1 - mean(1)))
    call close_to(got, wanted, 2e-3_wp*abs(wanted), "heat is carried along the film")
  end subroutine convection

  !> Lets oil of the inlet's temperature in between warmer walls.
  subroutine let_in_cold(contact)
    type(heated_contact), intent(inout) :: contact

    associate (rise => contact%film%model%shear%nodes%rise)
      rise([1, size(rise, 1)], :, 2:size(rise, 3) - 1) = 0
      rise(:, [1, size(rise, 2)], 2:size(rise, 3) - 1) = 0
    end associate
  end subroutine let_in_cold

  !> Oil that moves across the entrainment, by which the order of the columns is chosen: its heat is carried as far in a few
  !> sweeps. Along lines of the sweep differences are of first order: they fall by 1/(1 + a) a node instead of exp(-a).
  subroutine turned(along)
    real(wp), intent(in) :: along
    integer, parameter :: n = 81, place(2) = [31, 51], beside = 41, few = 8
    real(wp), parameter :: capacity = 1e8_wp, across = 1
    type(heated_contact) :: contact
    type(point_film_heat) :: heat
    class(heated_body), allocatable :: body_1, body_2
    real(wp) :: field(n, n), mean(2), change, a
    integer :: i

    field = 1
    call new_film(contact, [1.0_wp, 0.0_wp], [1.0_wp, 0.0_wp], constant, oil_heat_law(conductivity=k, capacity=capacity), &
      mirror, [1.0_wp, 1.0_wp], field)
    call new_body([n, n], [along, across], mirror, body_1)
    call new_body([n, n], [along, across], mirror, body_2)
    call new_point_heat(heat, contact%film, oil_heat_law(conductivity=k, capacity=capacity), along*field, across*field, &
      body_1, body_2, [1.0_wp, 1.0_wp], stat)
    call check(stat == status_ok, "heat is given another velocity")
    call let_in_cold(contact)
    do i = 1, few
      call heat_sweep(contact%film, heat, change, stat)
    end do
    call check(change < 1e-3_wp, "heat across the entrainment settles in a few sweeps")
    do i = 1, 2
      associate (levels_here => contact%film%model%shear%nodes%levels, rise => contact%film%model%shear%nodes%rise)
        mean(i) = sum(levels_here%weight*rise(beside, place(i), :))
      end associate
    end do
    a = pi**2*k*dx/(capacity*across*h**2)
    call close_to(log((1 - mean(1))/(1 - mean(2)))/(place(2) - place(1)), log(1 + a), 2e-2_wp*a, "and is carried as far")
  end subroutine turned

  !> Of the work of shearing, eta us2/h for each area, all enters the bodies or is carried away, also where walls differ
  !> and oil flows both ways.
  subroutine balance()
    integer, parameter :: n = 33
    real(wp), parameter :: u1(2) = [9.0_wp, 3.0_wp], u2(2) = [-2.0_wp, 1.0_wp]
    type(heated_contact) :: contact
    real(wp) :: work

    call new_film(contact, u1, u2, constant, oil_heat_law(conductivity=k, capacity=1.7e6_wp), steel, [5.0_wp, -3.0_wp], &
      spread(spread(0.0_wp, 1, n), 2, n))
    call settle(contact, 200)
    work = eta*sum((u2 - u1)**2)/h*(n - 2)**2
    call close_to((sum(contact%heat%walls%flux) + sum(contact%heat%main%carried))/work, 1.0_wp, 1e-7_wp, "no heat is lost")
    call check(sum(contact%heat%walls%flux) > 0.5_wp*work, "and most of it enters the bodies")
  end subroutine balance

end program test_point_heat
