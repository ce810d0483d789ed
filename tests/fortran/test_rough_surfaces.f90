!> Films between rough surfaces: averages by table, flow by the lay, the load shared with asperities, and the Jacobian of
!> free, ruptured and boundary rows.
program test_rough_surfaces
  use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_positive_inf
  use pyworm_film_newton, only: contact_conditions, newton_step, film_balance_again, film_contact, film_residual, film_step, &
    roughen_contact, set_ruptured, set_system, set_transient_term, shear_contact
  use pyworm_flow_laws, only: flow_law, law_newton, law_eyring
  use pyworm_kinds, only: wp
  use pyworm_line_film, only: line_contact, new_line_contact
  use pyworm_point_film, only: point_contact, new_point_contact
  use pyworm_rough_surfaces, only: asperity_pressure, curve_count, gap_curves, new_rough_film, rough_film, share_pressure
  use pyworm_sheared_reynolds, only: sheared_imbalance
  use pyworm_status, only: status_ok, status_bad_argument, status_not_finite
  use tap, only: check, close_to, done
  use pyworm_viscosity_density, only: oil_law, law_roelands
  implicit none(type, external)

  integer, parameter :: nx = 25, ny = 21, levels = 5, rows = 400
  real(wp), parameter :: roughness = 0.5e-6_wp, hardest = 3e8_wp, give = 0.24e-6_wp, friction = 0.1_wp
  real(wp), parameter :: floor = 1e-9_wp, modulus = 2e11_wp
  type(oil_law), parameter :: oil = oil_law(law_roelands, 0.227_wp, 0.227_wp, 1.961e8_wp, 0.67e-9_wp, 2.68e-9_wp, &
    333.15_wp, 0.782_wp, 7.1e-4_wp, 1.5e-9_wp)

  call averages()
  call refusals()
  call flow_by_lay()
  call drag_by_sliding()
  call point_jacobian()
  call line_jacobian()
  call moving_rupture()
  call shared_load()
  call starved_transient()
  call done()

contains

  !> Smooth curves of the kind that rough surfaces have, with the exact derivatives of the table; their tensors are
  !> `along` and `across` a lay at `angle` to x, times what the gap makes of them.
  function curves(along, across, drag, angle) result(table)
    real(wp), intent(in) :: along, across, drag, angle
    type(gap_curves) :: table
    real(wp) :: value(curve_count), slope(curve_count), row, gap, turn
    integer :: k

    table%scale = roughness
    table%first = asinh(-6.0_wp)
    table%spacing = (asinh(1e4_wp) - table%first)/(rows - 1)
    allocate (table%value(curve_count, rows), table%slope(curve_count, rows))
    do k = 1, rows
      row = table%first + (k - 1)*table%spacing
      gap = roughness*sinh(row)
      turn = roughness*cosh(row)
      call exact(along, across, drag, angle, gap, value, slope)
      table%value(:, k) = value
      table%slope(:, k) = slope*turn
    end do
  end function curves

  !> The curves and their derivatives by the gap [m].
  subroutine exact(along, across, drag, angle, gap, value, slope)
    real(wp), intent(in) :: along, across, drag, angle, gap
    real(wp), intent(out) :: value(curve_count), slope(curve_count)
    real(wp) :: fall, tensor(3, 2)

    tensor(:, 1) = [cos(angle)**2, sin(angle)**2, cos(angle)*sin(angle)]
    tensor(:, 2) = [sin(angle)**2, cos(angle)**2, -cos(angle)*sin(angle)]
    fall = exp(-min(max(gap/roughness, -6.0_wp), 300.0_wp))
    value(1) = log(hardest) - gap/give
    slope(1) = -1/give
    value(2) = 0.4_wp*roughness*fall
    slope(2) = -0.4_wp*fall
    value(3) = 0.2_wp*fall
    slope(3) = -0.2_wp*fall/roughness
    value(4:6) = [1.0_wp, 1.0_wp, 0.0_wp] + fall*(along*tensor(:, 1) + across*tensor(:, 2))
    slope(4:6) = -fall/roughness*(along*tensor(:, 1) + across*tensor(:, 2))
    value(7:9) = drag*roughness*fall*tensor(:, 1)
    slope(7:9) = -drag*fall*tensor(:, 1)
    if (value(1) < -600) slope(1) = 0
    value(1) = max(value(1), -600.0_wp)
  end subroutine exact

  !> The table gives its curves back, and their slopes; total and oil's pressure and the gap's thickness follow.
  subroutine averages()
    type(rough_film) :: rough
    real(wp) :: p(6, 1), h(6, 1), gap(6), value(curve_count), slope(curve_count)
    logical :: covered(6, 1)
    integer :: i, stat

    call new_rough_film(curves(-0.5_wp, -0.7_wp, 0.3_wp, 0.4_wp), friction, 6, 1, rough, stat)
    call check(stat == status_ok, "averages are made")
    gap = [-1.0_wp, 0.0_wp, 0.3_wp, 1.0_wp, 4.0_wp, 300.0_wp]*roughness
    p(:, 1) = 2e8_wp
    h(:, 1) = gap
    covered = .true.
    covered(6, 1) = .false.
    call share_pressure(rough, covered, p, h)
    do i = 1, 6
      call exact(-0.5_wp, -0.7_wp, 0.3_wp, 0.4_wp, gap(i), value, slope)
      call close_to(h(i, 1), gap(i) + value(2), 1e-6_wp*roughness, "mean thickness")
      call close_to(rough%widening(i, 1), 1 + slope(2), 1e-5_wp, "its change by the gap")
      call close_to(rough%flow(i, 1, 3), value(6), 1e-5_wp, "flow factor across the axes")
      if (i == 6) cycle
      call close_to(p(i, 1), max(2e8_wp - exp(value(1)), 0.0_wp), 1e3_wp, "the oil bears the rest")
      call close_to(rough%stiffness(i, 1), exp(value(1))/give, 1e-4_wp*exp(value(1))/give, "stiffness of the asperities")
    end do
    call close_to(rough%excess(1, 1), hardest*exp(roughness/give) - 2e8_wp, 1e4_wp, "asperities that would bear more than all")
    call close_to(p(6, 1), 2e8_wp, 0.0_wp, "no asperities beyond the surfaces")
  end subroutine averages

  subroutine refusals()
    type(rough_film) :: rough
    type(point_contact) :: contact
    type(gap_curves) :: broken
    integer :: stat

    broken = curves(0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp)
    call roughen_contact(contact, broken, friction, stat)
    call check(stat == status_bad_argument, "a film without flow law cannot be rough")
    call new_rough_film(broken, -1.0_wp, 3, 3, rough, stat)
    call check(stat == status_bad_argument, "negative friction is refused")
    broken%value = broken%value(:curve_count - 1, :)
    call new_rough_film(broken, friction, 3, 3, rough, stat)
    call check(stat == status_bad_argument, "a table without all curves is refused")
    broken = curves(0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp)
    broken%slope(4, 7) = ieee_value(1.0_wp, ieee_positive_inf)
    call new_rough_film(broken, friction, 3, 3, rough, stat)
    call check(stat == status_not_finite, "a curve that is not finite is refused")
  end subroutine refusals

  !> Makes a point contact whose surfaces are rough, with its pressure and rigid film.
  subroutine make_point(law, table, u, sliding_x, sliding_y, contact, p)
    type(flow_law), intent(in) :: law
    type(gap_curves), intent(in) :: table
    real(wp), intent(in) :: u, sliding_x, sliding_y
    type(point_contact), intent(inout) :: contact
    real(wp), intent(out) :: p(nx, ny)
    real(wp), parameter :: spacing = 4e-5_wp
    real(wp) :: gap(nx, ny), x, y
    logical :: covered(nx, ny)
    integer :: i, j, stat

    do j = 1, ny
      do i = 1, nx
        x = (i - 0.5_wp*nx)*spacing
        y = (j - 0.5_wp*ny)*spacing
        gap(i, j) = x**2/0.04_wp + y**2/0.06_wp
        p(i, j) = 4e8_wp*exp(-((x/3e-4_wp)**2 + (y/3e-4_wp)**2)) + 1.5e8_wp
      end do
    end do
    covered = .true.
    call new_point_contact(contact, contact_conditions(gap, covered, [spacing, spacing], modulus, oil, 100.0_wp, floor), &
      0*gap + u, 0*gap + u/4, stat)
    call shear_contact(contact, law, levels, 0*gap + sliding_x, 0*gap + sliding_y, stat)
    call roughen_contact(contact, table, friction, stat)
    call check(stat == status_ok, "a rough contact is made")
    p([1, nx], :) = 0
    p(:, [1, ny]) = 0
  end subroutine make_point

  !> Ridges oblique to the grid turn a flow: a gradient along x drives oil along y, as their tensor has it.
  subroutine flow_by_lay()
    type(point_contact) :: contact
    real(wp) :: p(nx, ny), h(nx, ny), fall, expected(3), root(2)
    real(wp), parameter :: slope = 1e8_wp, angle = 0.6_wp
    integer :: i

    call make_point(flow_law(law_newton), curves(0.3_wp, -0.6_wp, 0.0_wp, angle), 0.0_wp, 0.0_wp, 0.0_wp, contact, p)
    associate (rough => contact%model%fields%rough)
      do i = 1, nx
        p(i, :) = 1e9_wp + slope*(i - 1)*4e-5_wp
      end do
      h = 2*roughness
      call share_pressure(rough, contact%covered, p, h)
      ! a film of one gap has one pressure of asperities: the oil's gradient is the total's
      contact%model%fields%p = p
      contact%model%fields%h = h
      call contact%set_flow()
      fall = exp(-2.0_wp)
      expected = [1.0_wp, 1.0_wp, 0.0_wp] + fall*(0.3_wp*[cos(angle)**2, sin(angle)**2, cos(angle)*sin(angle)] &
        - 0.6_wp*[sin(angle)**2, cos(angle)**2, -cos(angle)*sin(angle)])
      ! the oil's mobility without factors, by the flow along x
      associate (faces_x => contact%model%shear%along_x%flow, faces_y => contact%model%shear%along_y%flow, i => 12, j => 11)
        root = [faces_x(i, j)/expected(1), (faces_y(i, j) + faces_y(i + 1, j))/2/expected(3)]
        call close_to(root(2), root(1), 2e-3_wp*root(1), "the lay turns the flow")
      end associate
    end associate
  end subroutine flow_by_lay

  !> Without a gradient of pressure the rough wall that moves drags oil along: rho times the factor times half the sliding.
  subroutine drag_by_sliding()
    type(point_contact) :: contact
    real(wp) :: p(nx, ny), h(nx, ny), expected

    call make_point(flow_law(law_newton), curves(0.0_wp, 0.0_wp, 0.5_wp, 0.0_wp), 1.0_wp, -2.0_wp, 0.0_wp, contact, p)
    p = 1e9_wp
    h = roughness
    call share_pressure(contact%model%fields%rough, contact%covered, p, h)
    contact%model%fields%p = p
    contact%model%fields%h = h
    call contact%set_flow()
    ! body 2 moves against x relative to body 1, which is the rough one: oil is carried along x, against `flow`
    expected = -contact%model%fields%rho(12, 11)*0.5_wp*roughness*exp(-1.0_wp)*2.0_wp/2
    call close_to(contact%model%shear%along_x%flow(12, 11), expected, 1e-5_wp*abs(expected), "a rough wall drags oil along")
  end subroutine drag_by_sliding

  !> The Jacobian of a contact against central differences of its balance, its rupture held.
  subroutine compare(contact, p, h0, ruptured, what)
    class(film_contact), intent(inout) :: contact
    real(wp), contiguous, intent(in) :: p(:, :)
    real(wp), intent(in) :: h0
    logical, intent(in) :: ruptured(:, :)
    character(len=*), intent(in) :: what
    real(wp), parameter :: step = 1e-5_wp
    real(wp) :: dp(size(p, 1), size(p, 2)), x(size(p) + 1), y(size(p) + 1)
    real(wp), dimension(size(p, 1), size(p, 2)) :: above, below, change
    real(wp) :: dh0
    integer :: i, j, stat

    do j = 1, size(p, 2)
      do i = 1, size(p, 1)
        dp(i, j) = p(i, j)*sin(0.7_wp*i + 0.3_wp*j**2)
      end do
    end do
    where (.not. contact%covered) dp = 0
    dh0 = 0.3_wp*roughness
    call balance_at(contact, p + step*dp, h0 + step*dh0, ruptured, above)
    call balance_at(contact, p - step*dp, h0 - step*dh0, ruptured, below)
    call balance_at(contact, p, h0, ruptured, change)
    call check(any(contact%free .and. contact%model%fields%rough%total > contact%model%fields%p) .and. &
      any(contact%covered .and. .not. contact%free), what//": asperities and rupture")
    call set_system(contact, stat)
    x(:size(p)) = reshape(dp, [size(p)])
    x(size(p) + 1) = dh0
    call contact%multiply(x, y)
    change = reshape(y(:size(p)), shape(p))
    below = change - (above - below)/(2*step)
    call close_to(maxval(abs(below), mask=contact%free), 0.0_wp, 1e-6_wp*maxval(abs(change), mask=contact%free), &
      what//": Jacobian of free and boundary rows against differences")
    call close_to(maxval(abs(below), mask=.not. contact%free), 0.0_wp, 1e-6_wp*maxval(abs(change), mask=.not. contact%free), &
      what//": Jacobian of ruptured rows against differences")
  end subroutine compare

  !> Imbalance where the oil flows; where it has ruptured, what the total pressure exceeds the asperities' by.
  subroutine balance_at(contact, p, h0, ruptured, balance)
    class(film_contact), intent(inout) :: contact
    real(wp), contiguous, intent(in) :: p(:, :)
    real(wp), intent(in) :: h0
    logical, intent(in) :: ruptured(:, :)
    real(wp), intent(out) :: balance(:, :)
    real(wp) :: residual, load_error

    call set_ruptured(contact, ruptured)
    call film_residual(contact, p, h0, residual, load_error)
    balance = merge(contact%imbalance, -contact%model%fields%rough%excess, contact%free)
  end subroutine balance_at

  subroutine point_jacobian()
    type(point_contact) :: contact
    real(wp) :: p(nx, ny), deflected(nx, ny)
    logical :: ruptured(nx, ny)

    call make_point(flow_law(law_eyring, 3e6_wp, 1e-9_wp, 2e-3_wp), curves(0.3_wp, -0.6_wp, -0.4_wp, 0.6_wp), 1.0_wp, &
      2.0_wp, 0.5_wp, contact, p)
    contact%grid%implicit_rate = 500
    ruptured = .false.
    ruptured(18:, :) = .true.
    call contact%deflection(p, deflected)
    call compare(contact, p, roughness - minval(deflected + contact%gap), ruptured, "a point contact")
  end subroutine point_jacobian

  subroutine line_jacobian()
    type(line_contact) :: contact
    integer, parameter :: n = 81
    real(wp), parameter :: spacing = 2e-5_wp
    real(wp) :: x(n), p(n, 1), none(n, 1)
    logical :: covered(n), ruptured(n, 1)
    integer :: i, stat

    x = [((i - 0.5_wp*n)*spacing, i=1, n)]
    p(:, 1) = 3e8_wp*exp(-(x/3e-4_wp)**2) + 1.5e8_wp
    p([1, n], 1) = 0
    none = 0
    covered = .true.
    call new_line_contact(contact, x**2/0.04_wp, covered, 0*x + 1, spacing, modulus, oil, 1e5_wp, floor, stat)
    call shear_contact(contact, flow_law(law_eyring, 3e6_wp, 1e-9_wp, 2e-3_wp), levels, none + 1.5_wp, none, stat)
    call roughen_contact(contact, curves(-0.4_wp, -0.4_wp, -0.4_wp, 0.0_wp), friction, stat)
    call check(stat == status_ok, "a rough line contact is made")
    contact%grid%implicit_rate = 500
    ruptured = .false.
    ruptured(60:, 1) = .true.
    ! half-planes leave the zero of the rigid film open
    call contact%deflection(p, none)
    call compare(contact, p, roughness - minval(none + contact%gap), ruptured, "a line contact")
  end subroutine line_jacobian

  !> An iteration starts with the rupture line that is given. When its transient term changes oil that flows into ruptured nodes
  !> makes them free in the next step.
  subroutine moving_rupture()
    type(point_contact) :: contact
    real(wp) :: p(nx, ny), deflected(nx, ny), explicit_rate(nx, ny), residual, load_error
    logical :: ruptured(nx, ny)
    integer :: stat

    call make_point(flow_law(law_newton), curves(0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp), 1.0_wp, 0.0_wp, 0.0_wp, contact, p)
    call contact%deflection(p, deflected)
    ruptured = .false.
    ruptured(18:, :) = .true.
    explicit_rate = 0
    explicit_rate(18:20, :) = -1
    call set_ruptured(contact, ruptured)
    call set_transient_term(contact, 0.0_wp, explicit_rate, stat)
    call film_residual(contact, p, roughness - minval(deflected + contact%gap), residual, load_error)
    call check(all(contact%free .eqv. (contact%covered .and. .not. ruptured)), "an iteration starts with the rupture line given")
    call film_balance_again(contact, residual, load_error)
    call check(all(contact%free(18:20, :) .eqv. contact%covered(18:20, :)), "oil that flows in frees ruptured nodes")
    call check(.not. any(contact%free(21:, :) .and. contact%imbalance(21:, :) > 0), "others stay ruptured")
  end subroutine moving_rupture

  !> Newton's method shares the load: oil and asperities bear it together, neither less than nothing.
  subroutine shared_load()
    type(point_contact) :: contact
    real(wp) :: p(nx, ny), h0

    call make_point(flow_law(law_newton), curves(-0.5_wp, -0.5_wp, 0.0_wp, 0.0_wp), 1.0_wp, 0.0_wp, 0.0_wp, contact, p)
    call press(contact, p, h0)
    call converge(contact, p, h0, "a rough contact")
    call check_shares(contact, 100.0_wp, "a rough contact")
  end subroutine shared_load

  !> A time step of a rough contact whose supply is limited, its load rising: the load is shared, and what enters and does not
  !> leave is stored.
  subroutine starved_transient()
    real(wp), parameter :: layer = 0.6e-6_wp, rate = 2e4_wp, heavier = 115.0_wp
    type(point_contact) :: contact
    real(wp) :: p(nx, ny), h0, before(nx, ny), after(nx, ny), steady, gained
    integer :: stat

    call make_point(flow_law(law_eyring, 3e6_wp, 1e-9_wp, 2e-3_wp), curves(-0.5_wp, -0.4_wp, -0.3_wp, 0.3_wp), 1.0_wp, &
      0.5_wp, 0.2_wp, contact, p)
    call contact%feed(spread(spread(layer, 1, nx), 2, ny), stat)
    call check(stat == status_ok, "a rough contact is fed a layer")
    call press(contact, p, h0)
    call converge(contact, p, h0, "a starved rough contact")
    call check_shares(contact, 100.0_wp, "a starved rough contact")
    call stored_oil(contact, before)
    call close_to(inflow(contact), 0.0_wp, 1e-8_wp*layer/4e-5_wp, "a steady film gains no oil")
    steady = minval(contact%model%fields%h)
    contact%load = heavier
    call set_transient_term(contact, rate, -rate*before, stat)
    call check(stat == status_ok, "a time step is set")
    call converge(contact, p, h0, "a starved rough transient")
    call check_shares(contact, heavier, "a starved rough transient")
    call stored_oil(contact, after)
    gained = rate*sum(after(2:nx - 1, 2:ny - 1) - before(2:nx - 1, 2:ny - 1))
    call close_to(inflow(contact), gained, 1e-6_wp*abs(gained), "what enters and does not leave is stored")
    call check(minval(contact%model%fields%h) < steady, "more load, less film")
    call check(any(contact%model%partial%fraction < 1 .and. contact%model%partial%fraction > 0), "the gap is filled in part")
  end subroutine starved_transient

  !> Oil over each node [m], relative to its density at ambient pressure.
  subroutine stored_oil(contact, stored)
    type(point_contact), intent(in) :: contact
    real(wp), intent(out) :: stored(nx, ny)

    stored = reshape(contact%model%partial%fraction, [nx, ny])*contact%model%fields%rho*contact%model%fields%h
  end subroutine stored_oil

  !> Net flow into the inner nodes, summed from their faces on the outline, over the spacing [m/s].
  real(wp) function inflow(contact)
    type(point_contact), intent(inout) :: contact
    real(wp) :: net(nx, ny), along_x(nx, ny), along_y(nx, ny)

    call contact%set_flow()
    ! what pressure drives out of all inner nodes; the transient term is not in it
    contact%still%explicit_rate = 0
    call sheared_imbalance(contact%still, contact%model%shear, contact%model%fields, net)
    associate (partial => contact%model%partial)
      along_x = reshape(partial%share_x*partial%full_x, [nx, ny])
      along_y = reshape(partial%share_y*partial%full_y, [nx, ny])
    end associate
    inflow = sum(along_x(1, 2:ny - 1) - along_x(nx - 1, 2:ny - 1)) + sum(along_y(2:nx - 1, 1) - along_y(2:nx - 1, ny - 1)) &
      - sum(net(2:nx - 1, 2:ny - 1))
  end function inflow

  !> A pressure that bears 100 N, and a rigid film, to start from.
  subroutine press(contact, p, h0)
    type(point_contact), intent(in) :: contact
    real(wp), intent(out) :: p(nx, ny), h0

    p = 6e8_wp*exp(-8e6_wp*contact%gap/0.04_wp*1e-5_wp)
    p([1, nx], :) = 0
    p(:, [1, ny]) = 0
    p = p*(100.0_wp/(sum(p)*4e-5_wp**2))
    h0 = -1.5e-6_wp
  end subroutine press

  subroutine converge(contact, p, h0, what)
    type(point_contact), intent(inout) :: contact
    real(wp), intent(inout) :: p(nx, ny), h0
    character(len=*), intent(in) :: what
    real(wp) :: residual, load_error
    type(newton_step) :: step
    integer :: steps, stat

    call film_residual(contact, p, h0, residual, load_error)
    do steps = 1, 60
      if (residual + abs(load_error) < 1e-9_wp) exit
      call film_step(contact, 1e-3_wp, p, h0, residual, load_error, step, stat)
      if (stat /= status_ok) exit
    end do
    call check(residual + abs(load_error) < 1e-9_wp, what//": Newton converges")
  end subroutine converge

  !> Both bear a part of the load, and together all of it.
  subroutine check_shares(contact, load, what)
    type(point_contact), intent(in) :: contact
    real(wp), intent(in) :: load
    character(len=*), intent(in) :: what
    real(wp) :: borne, rubbed(nx)
    integer :: j

    borne = 0
    do j = 1, ny
      rubbed = asperity_pressure(contact%model%fields%rough, contact%model%fields%p, j)
      borne = borne + sum(rubbed)
      call check(all(rubbed >= 0), what//": asperities bear no less than nothing")
    end do
    borne = borne*4e-5_wp**2
    call check(all(contact%model%fields%p >= 0), what//": nor does the oil")
    call close_to(sum(contact%model%fields%p)*4e-5_wp**2 + borne, load, 1e-6_wp, what//": together they bear the load")
    call check(borne > 0.01_wp*load .and. borne < 0.99_wp*load, what//": both bear a part")
  end subroutine check_shares

end program test_rough_surfaces
