!> A body whose surface warms where it is heated, in double precision, as differences want it.
module local_surface
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  !> A body whose surface warms where it is heated, and half as much at the next node along x.
  type, extends(heated_body), public :: local_body
  contains
    procedure :: rise
    procedure :: rise_transposed
  end type local_body

contains

  subroutine rise(self, q, temperature_rise)
    class(local_body), intent(inout) :: self
    real(wp), intent(in) :: q(self%nx, self%ny)
    real(wp), intent(out) :: temperature_rise(self%nx, self%ny)

    temperature_rise = self%own*q
    temperature_rise(2:, :) = temperature_rise(2:, :) + self%own*q(:self%nx - 1, :)/2
  end subroutine rise

  subroutine rise_transposed(self, weight, by_flux)
    class(local_body), intent(inout) :: self
    real(wp), intent(in) :: weight(self%nx, self%ny)
    real(wp), intent(out) :: by_flux(self%nx, self%ny)

    by_flux = self%own*weight
    by_flux(:self%nx - 1, :) = by_flux(:self%nx - 1, :) + self%own*weight(2:, :)/2
  end subroutine rise_transposed

end module local_surface

!> Heat of films linearised in temperature, pressure and film, and their flow in temperature, of smooth and rough point and line
!> contacts in any state: products agree with central differences of the equations, and with their transposes.
program test_heat_linearisation
  use local_surface, only: local_body
  use pyworm_film_newton, only: contact_conditions, film_residual, roughen_contact, set_film, set_ruptured, shear_contact
  use pyworm_film_warming, only: film_warming, new_film_warming, warm_imbalance, warm_imbalance_transposed
  use pyworm_flow_laws, only: flow_law, law_eyring, law_eyring_limited
  use pyworm_heat_linearisation, only: heat_linearisation, linearise_heat
  use pyworm_heat_products, only: heat_by_temperature, heat_by_film, heat_by_film_transposed, heat_transposed
  use pyworm_heat_residual, only: heat_residual
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  use pyworm_line_film, only: line_contact, new_line_contact
  use pyworm_line_heat, only: heat_line_contact
  use pyworm_point_film, only: point_contact, new_point_contact
  use pyworm_point_heat, only: heat_point_contact
  use pyworm_rough_surfaces, only: curve_count, gap_curves
  use pyworm_status, only: status_ok, status_bad_argument
  use pyworm_thermal_properties, only: oil_heat_law
  use pyworm_thermal_step, only: thermal_contact, start_temperature
  use pyworm_viscosity_density, only: oil_law, law_roelands
  use tap, only: check, close_to, done
  implicit none(type, external)

  integer, parameter :: levels = 5, rows = 400
  real(wp), parameter :: roughness = 0.3e-6_wp, modulus = 2e11_wp, floor = 1e-9_wp
  type(oil_law), parameter :: oil = oil_law(law_roelands, 0.03_wp, 0.5_wp, 1.961e8_wp, 0.67e-9_wp, 2.68e-9_wp, 333.15_wp, &
    1.1_wp, 7.1e-4_wp, 1.5e-9_wp)
  type(oil_heat_law), parameter :: heat_law = oil_heat_law(0.14_wp, 1.56e-9_wp, 0.61e-9_wp, 1.7e6_wp, 0.47e-9_wp, 0.81e-9_wp, &
    9.3e-4_wp, 1.4e-9_wp, -0.51e-18_wp)
  type(flow_law), parameter :: eyring = flow_law(law_eyring, 5e6_wp, 0.5e-9_wp, 2e-3_wp), &
    limited = flow_law(law_eyring_limited, 5e6_wp, 0.0_wp, 2e-3_wp, 0.0_wp, 0.06_wp)

  !> A contact with a pressure [Pa] and rigid film [m], not those of balance.
  type :: contact_state
    type(thermal_contact) :: contact
    real(wp), allocatable :: p(:, :)
    real(wp) :: h0 = 0
  end type contact_state

  integer :: stat

  call examine("a point contact", .true., eyring, [1.2_wp, 0.2_wp], [0.7_wp, -0.1_wp], .false.)
  call examine("a point contact across", .true., limited, [0.2_wp, -1.2_wp], [0.1_wp, -0.9_wp], .false.)
  call examine("a rough point contact", .true., eyring, [-0.3_wp, 0.9_wp], [0.1_wp, 0.6_wp], .true.)
  call examine("a line contact", .false., limited, [1.2_wp, 0.0_wp], [0.7_wp, 0.0_wp], .false.)
  call examine("a rough line contact with backflow", .false., eyring, [-1.2_wp, 0.0_wp], [0.4_wp, 0.0_wp], .true.)
  call refusal()
  call done()

contains

  !> Compares all products of a contact whose bodies move with u1 and u2 [m/s].
  subroutine examine(what, point, law, u1, u2, rough)
    character(len=*), intent(in) :: what
    logical, intent(in) :: point, rough
    type(flow_law), intent(in) :: law
    real(wp), intent(in) :: u1(2), u2(2)
    type(contact_state) :: state

    if (point) then
      call make_point(law, u1, u2, rough, state)
    else
      call make_line(law, u1(1), u2(1), rough, state)
    end if
    call place(state, 0.0_wp, 0.0_wp)
    call heat_differences(what, state)
    call flow_differences(what, state)
    call transposes(what, state)
  end subroutine examine

  !> A point contact under a bell of pressure.
  subroutine make_point(law, u1, u2, rough, state)
    type(flow_law), intent(in) :: law
    real(wp), intent(in) :: u1(2), u2(2)
    logical, intent(in) :: rough
    type(contact_state), intent(inout) :: state
    integer, parameter :: nx = 37, ny = 21
    real(wp), parameter :: dx = 3e-5_wp, dy = 4e-5_wp
    type(point_contact), allocatable :: film
    class(heated_body), allocatable :: body_1, body_2
    real(wp) :: gap(nx, ny), p(nx, ny), x, y
    logical :: covered(nx, ny)
    integer :: i, j

    do j = 1, ny
      do i = 1, nx
        x = (i - 0.5_wp*(nx + 1))*dx
        y = (j - 0.5_wp*(ny + 1))*dy
        gap(i, j) = x**2/0.04_wp + y**2/0.06_wp
        p(i, j) = bell(hypot(x, y))*((1 - (2*x/(nx - 1)/dx)**2)*(1 - (2*y/(ny - 1)/dy)**2))**3
      end do
    end do
    covered = .true.
    allocate (film)
    call new_point_contact(film, contact_conditions(gap, covered, [dx, dy], modulus, oil, 100.0_wp, floor), &
      0*gap + (u1(1) + u2(1))/2, 0*gap + (u1(2) + u2(2))/2, stat)
    call shear_contact(film, law, levels, 0*gap + u2(1) - u1(1), 0*gap + u2(2) - u1(2), stat)
    call move_alloc(film, state%contact%film)
    call press(rough, p, state)
    call new_body(nx, ny, body_1)
    call new_body(nx, ny, body_2)
    call heat_point_contact(state%contact, heat_law, 0*gap + u1(1), 0*gap + u1(2), body_1, body_2, [20.0_wp, 5.0_wp], stat)
    call check(stat == status_ok, "a contact is heated")
    call warm(state)
  end subroutine make_point

  !> A line contact under a bell of pressure.
  subroutine make_line(law, u1, u2, rough, state)
    type(flow_law), intent(in) :: law
    real(wp), intent(in) :: u1, u2
    logical, intent(in) :: rough
    type(contact_state), intent(inout) :: state
    integer, parameter :: n = 129
    real(wp), parameter :: dx = 1e-5_wp
    type(line_contact), allocatable :: film
    class(heated_body), allocatable :: body_1, body_2
    real(wp) :: x(n), field(n, 1), p(n, 1)
    integer :: i

    x = [((i - 0.5_wp*(n + 1))*dx, i=1, n)]
    p(:, 1) = bell(x)*(1 - (2*x/(n - 1)/dx)**2)**3
    field = 1
    allocate (film)
    call new_line_contact(film, x**2/0.04_wp, [(.true., i=1, n)], 0*x + (u1 + u2)/2, dx, modulus, oil, 1e5_wp, floor, stat)
    call shear_contact(film, law, levels, (u2 - u1)*field, 0*field, stat)
    call move_alloc(film, state%contact%film)
    call press(rough, p, state)
    call new_body(n, 1, body_1)
    call new_body(n, 1, body_2)
    call heat_line_contact(state%contact, heat_law, 0*x + u1, body_1, body_2, [20.0_wp, 5.0_wp], stat)
    call check(stat == status_ok, "a contact is heated")
    call warm(state)
  end subroutine make_line

  !> Pressure at a distance from the middle [m].
  elemental real(wp) function bell(distance)
    real(wp), intent(in) :: distance

    bell = 5e8_wp*exp(-(distance/2.5e-4_wp)**2) + 0.2e8_wp
  end function bell

  !> Sets pressure and rigid film, whose least gap is a few times the roughness, and roughens the surfaces.
  subroutine press(rough, p, state)
    logical, intent(in) :: rough
    real(wp), contiguous, intent(in) :: p(:, :)
    type(contact_state), intent(inout) :: state
    real(wp) :: deflected(size(p, 1), size(p, 2))

    if (rough) call roughen_contact(state%contact%film, curves(), 0.12_wp, stat)
    state%p = p
    call state%contact%film%deflection(p, deflected)
    state%h0 = merge(1.2_wp, 0.7_wp, rough)*roughness - minval(deflected + state%contact%film%gap)
  end subroutine press

  !> Curves of the kind that rough surfaces have, with oblique ridges; their slopes are differences.
  function curves() result(table)
    type(gap_curves) :: table
    real(wp) :: row
    integer :: k

    table%scale = roughness
    table%first = asinh(-6.0_wp)
    table%spacing = (asinh(1e4_wp) - table%first)/(rows - 1)
    allocate (table%value(curve_count, rows), table%slope(curve_count, rows))
    do k = 1, rows
      row = table%first + (k - 1)*table%spacing
      table%value(:, k) = values_at(roughness*sinh(row))
      table%slope(:, k) = (values_at(roughness*sinh(row + 1e-4_wp)) - values_at(roughness*sinh(row - 1e-4_wp)))/2e-4_wp
    end do
  end function curves

  !> All curves at a gap [m].
  pure function values_at(gap) result(values)
    real(wp), intent(in) :: gap
    real(wp) :: values(curve_count), fall

    fall = exp(-min(max(gap/roughness, -6.0_wp), 300.0_wp))
    values(1) = max(log(3e8_wp) - 2*gap/roughness, -600.0_wp)
    values(2) = 0.4_wp*roughness*fall
    values(3) = 0.2_wp*fall
    values(4:6) = [1.0_wp, 1.0_wp, 0.0_wp] + fall*[0.1_wp, -0.5_wp, 0.2_wp]
    values(7:9) = -0.4_wp*roughness*fall*[0.6_wp, 0.4_wp, 0.3_wp]
  end function values_at

  subroutine new_body(nx, ny, body)
    integer, intent(in) :: nx, ny
    class(heated_body), allocatable, intent(out) :: body
    type(local_body), allocatable :: made

    allocate (made)
    made%nx = nx
    made%ny = ny
    made%own = 1e-7_wp
    call move_alloc(made, body)
  end subroutine new_body

  !> Warms the film unevenly.
  subroutine warm(state)
    type(contact_state), intent(inout) :: state
    real(wp) :: rise(size(state%p, 1), size(state%p, 2), levels)

    call wave([0.21_wp, 0.13_wp, 0.5_wp], rise)
    call start_temperature(state%contact%film, state%contact%heat, 30 + 15*rise)
  end subroutine warm

  !> A field that changes from node to node and level to level, at these rates.
  pure subroutine wave(rates, field)
    real(wp), intent(in) :: rates(3)
    real(wp), intent(out) :: field(:, :, :)
    integer :: i, j, k

    do k = 1, size(field, 3)
      do j = 1, size(field, 2)
        do i = 1, size(field, 1)
          field(i, j, k) = cos(rates(1)*i + rates(2)*j + rates(3)*k)
        end do
      end do
    end do
  end subroutine wave

  !> Direction of change of the pressure, in proportion to it [Pa].
  function pressing(state) result(dp)
    type(contact_state), intent(in) :: state
    real(wp) :: dp(size(state%p, 1), size(state%p, 2)), field(size(state%p, 1), size(state%p, 2), 1)

    call wave([0.7_wp, 0.9_wp, 0.0_wp], field)
    dp = state%p*field(:, :, 1)
  end function pressing

  !> Places the film `pressed` times the direction of its pressure and `lifted` [m] away from the state, and evaluates it; oil
  !> between rough surfaces has ruptured where the bell of pressure ends.
  subroutine place(state, pressed, lifted)
    type(contact_state), intent(inout) :: state
    real(wp), intent(in) :: pressed, lifted
    logical :: ruptured(size(state%p, 1), size(state%p, 2))
    real(wp) :: p(size(state%p, 1), size(state%p, 2)), residual, load_error

    ruptured = .false.
    ruptured(5*size(state%p, 1)/6:, :) = .true.
    call set_ruptured(state%contact%film, ruptured)
    p = state%p + pressed*pressing(state)
    call film_residual(state%contact%film, p, state%h0 + lifted, residual, load_error)
  end subroutine place

  !> Relative difference of a field from another.
  pure real(wp) function distance(field, wanted)
    real(wp), intent(in) :: field(:, :, :), wanted(:, :, :)

    distance = norm2(field - wanted)/norm2(wanted)
  end function distance

  !> The heat's equations linearised, against central differences; levels between the walls and walls apart.
  subroutine heat_differences(what, state)
    character(len=*), intent(in) :: what
    type(contact_state), intent(inout) :: state
    type(heat_linearisation) :: linear
    real(wp), allocatable, dimension(:, :, :) :: warming, change, less, more, rise
    real(wp), parameter :: step = 1e-3_wp, part = 1e-6_wp, lift = 1e-5_wp*roughness
    integer, parameter :: walls(2) = [1, levels]

    associate (film => state%contact%film, heat => state%contact%heat)
      call linearise_heat(film, heat, linear, stat)
      call check(stat == status_ok, what//": heat is linearised")
      rise = film%model%shear%nodes%rise
      allocate (warming, change, less, more, mold=rise)
      call wave([0.7_wp, 0.9_wp, 1.3_wp], warming)
      film%model%shear%nodes%rise = rise + step*warming
      call heat_residual(film, heat, more, stat)
      film%model%shear%nodes%rise = rise - step*warming
      call heat_residual(film, heat, less, stat)
      film%model%shear%nodes%rise = rise
      call heat_by_temperature(linear, heat%walls, warming, change)
      more = (more - less)/(2*step)
      call close_to(distance(change(:, :, 2:levels - 1), more(:, :, 2:levels - 1)), 0.0_wp, 1e-6_wp, &
        what//": heat of levels by temperature")
      call close_to(distance(change(:, :, walls), more(:, :, walls)), 0.0_wp, 1e-6_wp, &
        what//": balance of walls by temperature")

      call place(state, part, lift)
      call heat_residual(film, heat, more, stat)
      call place(state, -part, -lift)
      call heat_residual(film, heat, less, stat)
      call place(state, 0.0_wp, 0.0_wp)
      more = (more - less)/(2*part)
      call change_by_film(state, linear, lift/part, change)
      call close_to(distance(change(:, :, 2:levels - 1), more(:, :, 2:levels - 1)), 0.0_wp, 1e-6_wp, &
        what//": heat of levels by the film")
      call close_to(distance(change(:, :, walls), more(:, :, walls)), 0.0_wp, 1e-6_wp, &
        what//": balance of walls by the film")
    end associate
  end subroutine heat_differences

  !> Change of the heat's equations by that of the pressure and by `lifted` [m].
  subroutine change_by_film(state, linear, lifted, change)
    type(contact_state), intent(inout) :: state
    type(heat_linearisation), intent(in) :: linear
    real(wp), intent(in) :: lifted
    real(wp), intent(out) :: change(:, :, :)
    real(wp), dimension(size(state%p, 1), size(state%p, 2)) :: dp, dh, asperities

    dp = pressing(state)
    call state%contact%film%deflection(dp, dh)
    dh = dh + lifted
    asperities = 0
    associate (fields => state%contact%film%model%fields)
      if (fields%is_rough()) then
        ! what the asperities do not bear of the change is the oil's, where it flows
        asperities = merge(dp, -fields%rough%stiffness*dh, fields%rough%ruptured .or. .not. fields%p > 0)
        dp = dp - asperities
      end if
    end associate
    call heat_by_film(linear, state%contact%heat%walls, dp, dh, asperities, change)
  end subroutine change_by_film

  !> The imbalance of the film linearised in temperature, against central differences.
  subroutine flow_differences(what, state)
    character(len=*), intent(in) :: what
    type(contact_state), intent(inout) :: state
    type(film_warming) :: flow
    real(wp), allocatable :: warming(:, :, :), rise(:, :, :), change(:, :, :), less(:, :), more(:, :, :)
    real(wp), parameter :: step = 1e-3_wp

    associate (film => state%contact%film)
      call new_film_warming(film, flow, stat)
      call check(stat == status_ok, what//": the flow is linearised")
      rise = film%model%shear%nodes%rise
      allocate (warming, mold=rise)
      allocate (change(size(rise, 1), size(rise, 2), 1), more(size(rise, 1), size(rise, 2), 1))
      call wave([0.7_wp, 0.9_wp, 1.3_wp], warming)
      film%model%shear%nodes%rise = rise - step*warming
      call film%set_flow()
      less = film%imbalance
      film%model%shear%nodes%rise = rise + step*warming
      call film%set_flow()
      more(:, :, 1) = (film%imbalance - less)/(2*step)
      film%model%shear%nodes%rise = rise
      call film%set_flow()
      call warm_imbalance(film, flow, warming, change(:, :, 1))
      call close_to(distance(change, more), 0.0_wp, 1e-6_wp, what//": imbalance by temperature")
    end associate
  end subroutine flow_differences

  !> Sums weighted by a field on either side of each product.
  subroutine transposes(what, state)
    character(len=*), intent(in) :: what
    type(contact_state), intent(inout) :: state
    type(heat_linearisation) :: linear
    type(film_warming) :: flow
    real(wp), allocatable, dimension(:, :, :) :: warming, change, weight, by_warming
    real(wp), allocatable, dimension(:, :) :: by_p, by_h, by_asperities, imbalance
    real(wp) :: dh(size(state%p, 1), size(state%p, 2))

    associate (film => state%contact%film, heat => state%contact%heat)
      call linearise_heat(film, heat, linear, stat)
      call new_film_warming(film, flow, stat)
      allocate (warming, change, weight, by_warming, mold=film%model%shear%nodes%rise)
      allocate (by_p, by_h, by_asperities, imbalance, mold=state%p)
      call wave([0.7_wp, 0.9_wp, 1.3_wp], warming)
      call wave([1.7_wp, 0.5_wp, 0.8_wp], weight)
      ! what levels lack over the conductance is of the walls' unit
      weight(:, :, 2:levels - 1) = weight(:, :, 2:levels - 1)/linear%conductance
      call heat_by_temperature(linear, heat%walls, warming, change)
      call heat_transposed(linear, heat%walls, weight, by_p, by_h, by_asperities, by_warming)
      call equal_sums(what//": heat by temperature, transposed", weight*change, by_warming*warming)
      dh = warming(:, :, 1)*roughness
      associate (dp => warming(:, :, 2)*1e8_wp, asperities => warming(:, :, 3)*1e8_wp)
        call heat_by_film(linear, heat%walls, dp, dh, asperities, change)
        call heat_by_film_transposed(linear, heat%walls, weight, by_p, by_h, by_asperities)
        call equal_sums(what//": heat by the film, transposed", weight*change, &
          spread(by_p*dp + by_h*dh + by_asperities*asperities, 3, 1))
      end associate
      call warm_imbalance(film, flow, warming, imbalance)
      call warm_imbalance_transposed(film, flow, weight(:, :, 1), by_warming)
      call equal_sums(what//": imbalance by temperature, transposed", spread(imbalance*weight(:, :, 1), 3, 1), &
        by_warming*warming)
    end associate
  end subroutine transposes

  subroutine equal_sums(what, one, other)
    character(len=*), intent(in) :: what
    real(wp), intent(in) :: one(:, :, :), other(:, :, :)

    call close_to(sum(one), sum(other), 1e-12_wp*sqrt(sum(one**2)*size(one)), what)
  end subroutine equal_sums

  !> Oil that stores heat has another state.
  subroutine refusal()
    type(contact_state) :: state
    real(wp), allocatable :: residual(:, :, :)

    call make_line(eyring, 1.0_wp, 0.5_wp, .false., state)
    call place(state, 0.0_wp, 0.0_wp)
    residual = 0*state%contact%film%model%shear%nodes%rise
    call state%contact%heat%change_with_time(residual, 0*state%p, stat)
    call heat_residual(state%contact%film, state%contact%heat, residual, stat)
    call check(stat == status_bad_argument, "oil that stores heat is refused")
  end subroutine refusal

end program test_heat_linearisation
