!> Heat of a film's columns: shearing, compression, conduction and capacity under pressure, against Couette and Poiseuille
!> flow; its derivatives; and what oil carries away.
program test_column_sources
  use pyworm_column_sources, only: column_oil, new_column_oil, set_heat, carried_away
  use pyworm_film_column, only: film_strip, new_film_strip, solve_columns
  use pyworm_gauss_lobatto, only: new_levels
  use pyworm_flow_laws, only: flow_law, law_newton, law_eyring
  use pyworm_kinds, only: wp
  use pyworm_shear_fields, only: shear_columns
  use pyworm_thermal_properties, only: oil_heat_law
  use pyworm_viscosity_density, only: oil_law, law_barus
  use pyworm_strip_of_points, only: shear_strip, new_shear_strip
  use pyworm_sheared_oil, only: sheared_oil
  use pyworm_status, only: status_ok
  use tap, only: check, close_to, done
  implicit none(type, external)

  integer, parameter :: columns = 3, n = 7
  !> The oil of Sharif, Kong, Evans and Snidle (2001), table 2 and appendix, with Barus' law and a beta of its size.
  real(wp), parameter :: eta0 = 0.227_wp, alpha = 9.5e-9_wp, beta = 0.03_wp, inlet = 333.15_wp
  type(oil_law), parameter :: oil = oil_law(law_barus, eta0, alpha, 1.0_wp, 0.67e-9_wp, 2.68e-9_wp, inlet, beta, 7.1e-4_wp, &
    1.5e-9_wp)
  type(oil_heat_law), parameter :: law = oil_heat_law(0.148_wp, 1.56e-9_wp, 0.61e-9_wp, 1025*1844.0_wp, 0.5e-9_wp, &
    0.51e-9_wp, 3.4e-4_wp, 3.3e-9_wp, -2.3e-18_wp)
  !> Film [m], pressure [Pa], its gradient [Pa/m] and its rate of change [Pa/s], velocity of body 1 and of body 2 over it [m/s].
  real(wp), parameter :: h(columns) = [0.6e-6_wp, 1.1e-6_wp, 0.9e-6_wp], p(columns) = [0.0_wp, 2e8_wp, 1e9_wp], &
    px(columns) = [3e10_wp, -1e12_wp, 2e12_wp], py(columns) = [1e11_wp, 4e11_wp, 0.0_wp], &
    pressing(columns) = [0.0_wp, 3e12_wp, -2e12_wp], &
    u1(columns) = [3.0_wp, 2.0_wp, -1.0_wp], v1(columns) = [0.5_wp, -1.0_wp, 2.0_wp], &
    us(columns) = [-2.0_wp, -5.0_wp, 0.4_wp], vs(columns) = [1.0_wp, 0.0_wp, -3.0_wp]

  type :: heated_columns
    type(sheared_oil) :: nodes
    type(shear_strip) :: shear
    type(film_strip) :: strip
    type(column_oil) :: oil
  end type heated_columns

  call one_temperature()
  call derivatives()
  call carried()
  call done()

contains

  !> The columns at temperatures above the inlet's [K].
  subroutine heat(flow, rise, made)
    type(flow_law), intent(in) :: flow
    real(wp), intent(in) :: rise(columns, n)
    type(heated_columns), intent(out) :: made
    integer :: stat

    made%nodes%law = flow
    made%nodes%levels = new_levels(n)
    call new_film_strip(made%strip, columns, made%nodes%levels, stat)
    call check(stat == status_ok, "columns are made")
    call new_shear_strip(columns, n, made%shear, stat)
    made%shear%film = h
    made%shear%px = px
    made%shear%py = py
    made%shear%us = us
    made%shear%vs = vs
    made%strip%known = rise
    made%strip%absorption = 0
    call new_column_oil(columns, n, made%oil, stat)
    made%oil%p = p
    made%oil%pressing = pressing
    made%oil%u1 = u1
    made%oil%v1 = v1
    call shear_columns(oil, made%nodes, p, rise, made%shear, made%oil%mean, made%oil%softening)
    call set_heat(law, oil, made%nodes, made%shear, made%oil, made%strip)
  end subroutine heat

  !> A Newtonian film 10 K above the inlet: Couette and Poiseuille flow, and the appendix's properties under pressure.
  subroutine one_temperature()
    real(wp), parameter :: warm = 10
    type(heated_columns) :: made
    real(wp) :: z(n), eta, u(n), v(n), source(n), eps
    integer :: c

    call heat(flow_law(law_newton), spread(spread(warm, 1, columns), 2, n), made)
    z = made%nodes%levels%z
    do c = 1, columns
      eta = eta0*exp(alpha*p(c) - beta*warm)
      u = u1(c) + us(c)*(z + 0.5_wp) + px(c)*h(c)**2/(2*eta)*(z**2 - 0.25_wp)
      v = v1(c) + vs(c)*(z + 0.5_wp) + py(c)*h(c)**2/(2*eta)*(z**2 - 0.25_wp)
      source = ((eta*us(c)/h(c) + z*h(c)*px(c))**2 + (eta*vs(c)/h(c) + z*h(c)*py(c))**2)/eta
      eps = 7.1e-4_wp*exp(-1.5e-9_wp*p(c))
      call all_close(made%oil%u(c, :), u, 1e-10_wp, "velocity along x")
      call all_close(made%oil%v(c, :), v, 1e-10_wp, "and along y")
      call all_close(made%strip%source(c, :), source, 1e-10_wp, "heat of shearing")
      call all_close(made%oil%compression(c, :), eps*(inlet + warm)*(u*px(c) + v*py(c) + pressing(c)), 1e-10_wp, &
        "heat of compression")
      call close_to(made%strip%thickness(c), h(c), 1e-20_wp, "the film")
      call all_close(made%strip%wall(c, :), [warm, warm], 1e-12_wp, "walls as they are")
    end do
    call all_close(made%strip%conductivity, 0.148_wp*[1.0_wp, 1.434_wp/1.122_wp, 3.17_wp/1.61_wp], 1e-12_wp, &
      "conductivity under pressure")
    ! 1 + .5 p/(1 + .51 p), and 1 + 3.4e-4 (1 + 3.3 p - 2.3 p2) times 10 K, with p in GPa
    call all_close(made%oil%capacity, 1025*1844*[1.0034_wp, 1.202_wp/1.102_wp*(1 + 3.4e-3_wp*1.568_wp), &
      2.01_wp/1.51_wp*1.0068_wp], 1e-12_wp, "heat capacity under pressure")
  end subroutine one_temperature

  !> Heat follows temperature as growth, loading and relief say: against differences, of Newton's and of Eyring's law.
  subroutine derivatives()
    real(wp), parameter :: step = 1e-3_wp
    type(flow_law) :: flows(2)
    type(heated_columns) :: made, more, less
    real(wp) :: rise(columns, n), change(columns, n), linear(n), difference(n)
    integer :: c, k, i

    flows = [flow_law(law_newton), flow_law(law_eyring, reference=3e6_wp)]
    do k = 1, n
      do c = 1, columns
        rise(c, k) = 20 + 3*modulo(2*k + c, 5)
        change(c, k) = 1 + modulo(3*k + c, 4)
      end do
    end do
    do i = 1, size(flows)
      call heat(flows(i), rise, made)
      call heat(flows(i), rise + step*change, more)
      call heat(flows(i), rise - step*change, less)
      do c = 1, columns
        difference = (more%strip%source(c, :) - less%strip%source(c, :))/(2*step)
        linear = made%strip%growth(c, :)*change(c, :) &
          - made%strip%loading(c, :, 1)*dot_product(made%strip%relief(c, :, 1), change(c, :)) &
          - made%strip%loading(c, :, 2)*dot_product(made%strip%relief(c, :, 2), change(c, :))
        call all_close(linear, difference, 1e-5_wp, "heat follows temperature")
      end do
    end do
  end subroutine derivatives

  !> What oil carries away less what it brought is what shearing gave and walls did not take.
  subroutine carried()
    type(heated_columns) :: made
    real(wp) :: inflow(columns, n), taken(columns), work(columns)
    integer :: c, k

    call heat(flow_law(law_newton), spread(spread(10.0_wp, 1, columns), 2, n), made)
    made%strip%growth = 0
    made%strip%loading = 0
    made%strip%relief = 0
    made%strip%absorption = 1e11_wp
    do k = 1, n
      inflow(:, k) = 1e12_wp*(5 + modulo(3*k, 4))
    end do
    do c = 1, columns
      work(c) = h(c)*dot_product(made%nodes%levels%weight, made%strip%source(c, :))
    end do
    made%strip%source = made%strip%source + inflow
    call solve_columns(made%strip)
    call carried_away(made%strip, inflow, taken)
    call all_close(sum(made%strip%flux, dim=2) + taken, work, 1e-10_wp, "no heat is lost")
    call check(all(abs(taken) > 1e-3_wp*work), "and oil carries some")
  end subroutine carried

  !> Checks values against others, to a share of the largest of these.
  subroutine all_close(values, wanted, within, what)
    real(wp), intent(in) :: values(:), wanted(:), within
    character(len=*), intent(in) :: what

    call close_to(maxval(abs(values - wanted)), 0.0_wp, within*maxval(abs(wanted)), what)
  end subroutine all_close

end program test_column_sources
