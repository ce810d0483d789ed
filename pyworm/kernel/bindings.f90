!> The kernel's interface to Python: plain arrays and scalars, explicit shapes, an integer status.
!>
!> The caller owns a contact by an opaque address (`handle`), made by `point_film_new` or `line_film_new` and
!> released by `film_free`. Fields have shape (nx, ny), with ny = 1 of a
!> line contact, whose load and friction are for each length.
!>
!> No procedure may be called like a type that a contact holds (film_fields, film_work): gfortran takes it for that.
module bindings
  use iso_c_binding, only: c_double, c_int, c_int64_t
  use pyworm_contact_handle, only: contact_of, handle_of
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_no_memory, status_not_finite
  use pyworm_thermal_step, only: thermal_contact
  implicit none
  private

  public :: dry_contact_solve, elastic_deflection, point_stress, line_stress, heat_stress
  public :: point_film_transport, point_film_fluidity, point_film_limit
  public :: point_film_new, point_film_entrain, point_film_heat, point_film_swept_shear
  public :: line_film_new, line_film_entrain, line_film_heat
  public :: film_free, film_place, film_evaluate, film_step, film_state, film_thickness, film_convolve, film_tally, &
    film_transient, film_set_gap, film_hold, film_hold_rise, film_judge, film_remember, film_store, film_shear, film_roughen, &
    film_asperities, film_tabulate, film_set_ruptured, film_feed, film_fraction, film_warm, film_rise, film_set_rise, &
    film_unsolved, film_shear_fields, film_heat_fields, film_profile, film_adjoints, film_evaluate_at, film_heat_change, &
    film_spread_change, film_set_oil
  public :: cell_press, cell_conduct
  public :: prolong_cubic, level_positions, flow_tables
  public :: heated_times, extrapolated_flux, surface_residual_rise
  public :: flank_heights, flank_expansions, flank_ends
  public :: compiled_with, status_text, watch_signals

contains

  !> Deflection w [m] of a half-space pair, with the numbers of its `layers_of`, under pressure p [Pa].
  subroutine elastic_deflection(p, nx, ny, dx, dy, reduced_modulus, layers, w, stat)
    use pyworm_coated_surface, only: layers_of
    use pyworm_half_space, only: elastic_half_space, new_half_space
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: p(nx, ny)
    real(c_double), intent(in) :: dx, dy, reduced_modulus, layers(5, 2)
    real(c_double), intent(out) :: w(nx, ny)
    integer(c_int), intent(out) :: stat
    type(elastic_half_space) :: space
    !f2py threadsafe

    w = 0
    call new_half_space(space, nx, ny, dx, dy, reduced_modulus, stat, layers_of(layers))
    if (stat == status_ok) call space%deflection(p, w)
  end subroutine elastic_deflection

  !> Stress [Pa] below the nodes of a half-space under pressure and shear tractions [Pa]; see `half_space_stress`.
  subroutine point_stress(tractions, nx, ny, dx, dy, poisson, depths, count, stress, stat)
    use pyworm_half_space_stress, only: half_space_stress
    integer(c_int), intent(in) :: nx, ny, count
    real(c_double), intent(in) :: tractions(nx, ny, 3)
    real(c_double), intent(in) :: dx, dy, poisson, depths(count)
    real(c_double), intent(out) :: stress(nx, ny, 6, count)
    integer(c_int), intent(out) :: stat
    !f2py threadsafe

    call half_space_stress(tractions, dx, dy, poisson, depths, stress, stat)
  end subroutine point_stress

  !> Stress [Pa] in the plane below the nodes of a half-plane under pressure and shear [Pa]; see `half_plane_stress`.
  subroutine line_stress(tractions, n, dx, depths, count, stress, stat)
    use pyworm_half_plane_stress, only: half_plane_stress
    integer(c_int), intent(in) :: n, count
    real(c_double), intent(in) :: tractions(n, 2)
    real(c_double), intent(in) :: dx, depths(count)
    real(c_double), intent(out) :: stress(n, 3, count)
    integer(c_int), intent(out) :: stat
    !f2py threadsafe

    call half_plane_stress(tractions, dx, depths, stress, stat)
  end subroutine line_stress

  !> Thermal stress [Pa] below some nodes, the `first` on, of a rise of the surface temperature [K]; see `thermal_stress`. `solid`
  !> are E alpha/(1 - nu) [Pa/K], Poisson's ratio, the diffusivity [m2/s] and both components of the velocity [m/s].
  subroutine heat_stress(rise, mx, my, spacing, solid, first, nx, ny, depths, count, stress, stat)
    use pyworm_thermal_stress, only: thermal_solid, thermal_stress
    integer(c_int), intent(in) :: mx, my, first(2), nx, ny, count
    real(c_double), intent(in) :: rise(mx, my), spacing(2), solid(5), depths(count)
    real(c_double), intent(out) :: stress(nx, ny, 6, count)
    integer(c_int), intent(out) :: stat
    !f2py threadsafe

    call thermal_stress(rise, spacing, thermal_solid(solid(1), solid(2), solid(3), solid(4:5)), first, depths, stress, stat)
  end subroutine heat_stress

  !> Solves the dry contact of a gap [m]; p [Pa] is the initial guess, then the solution.
  subroutine dry_contact_solve(gap, covered, nx, ny, dx, dy, reduced_modulus, layers, load, tolerance, &
      most_iterations, p, approach, iterations, stat)
    use pyworm_coated_surface, only: layers_of
    use pyworm_dry_contact, only: solve_dry_contact
    use pyworm_half_space, only: elastic_half_space, new_half_space
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: gap(nx, ny)
    integer(c_int), intent(in) :: covered(nx, ny)
    real(c_double), intent(in) :: dx, dy, reduced_modulus, layers(5, 2), load, tolerance
    integer(c_int), intent(in) :: most_iterations
    real(c_double), intent(inout) :: p(nx, ny)
    real(c_double), intent(out) :: approach
    integer(c_int), intent(out) :: iterations, stat
    type(elastic_half_space) :: space
    !f2py threadsafe

    approach = 0
    iterations = 0
    call new_half_space(space, nx, ny, dx, dy, reduced_modulus, stat, layers_of(layers))
    if (stat == status_ok) call solve_dry_contact(space, gap, covered /= 0, load, tolerance, &
      most_iterations, p, approach, iterations, stat)
  end subroutine dry_contact_solve

  !> Presses a periodic rough surface against a rigid flat; see `cell_contact`. p [Pa] is the initial guess, then the solution.
  subroutine cell_press(height, nx, ny, dx, dy, reduced_modulus, separation, hardness, tolerance, most_iterations, p, gap, &
      iterations, stat)
    use pyworm_cell_contact, only: press_flat
    use pyworm_elastic_cell, only: elastic_surface, new_elastic_surface
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: height(nx, ny)
    real(c_double), intent(in) :: dx, dy, reduced_modulus, separation, hardness, tolerance
    integer(c_int), intent(in) :: most_iterations
    real(c_double), intent(inout) :: p(nx, ny)
    real(c_double), intent(out) :: gap(nx, ny)
    integer(c_int), intent(out) :: iterations, stat
    type(elastic_surface) :: surface
    !f2py threadsafe

    gap = 0
    iterations = 0
    call new_elastic_surface(surface, nx, ny, dx, dy, reduced_modulus, stat)
    if (stat == status_ok) call press_flat(surface, height, separation, hardness, tolerance, most_iterations, p, gap, &
      iterations, stat)
  end subroutine cell_press

  !> Flow through a periodic gap [m]; see `cell_flow` for the arguments.
  subroutine cell_conduct(gap, nx, ny, dx, dy, tolerance, most_iterations, conducted, carried, iterations, stat)
    use pyworm_cell_flow, only: flow_through
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: gap(nx, ny)
    real(c_double), intent(in) :: dx, dy, tolerance
    integer(c_int), intent(in) :: most_iterations
    real(c_double), intent(out) :: conducted(3), carried(3)
    integer(c_int), intent(out) :: iterations, stat
    !f2py threadsafe

    call flow_through(gap, dx, dy, tolerance, most_iterations, conducted, carried, iterations, stat)
  end subroutine cell_conduct

  !> Makes a point contact; see `point_film` for the arguments and `viscosity_density` for the oil's.
  subroutine point_film_new(gap, covered, u, v, nx, ny, dx, dy, reduced_modulus, layers, law, eta0, exponent, &
      pole_pressure, d1, d2, load, floor, handle, stat)
    use pyworm_coated_surface, only: layers_of
    use pyworm_film_newton, only: contact_conditions
    use pyworm_point_film, only: point_contact, new_point_contact
    use pyworm_viscosity_density, only: oil_law
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: gap(nx, ny), u(nx, ny), v(nx, ny)
    integer(c_int), intent(in) :: covered(nx, ny)
    real(c_double), intent(in) :: dx, dy, reduced_modulus, layers(5, 2)
    integer(c_int), intent(in) :: law
    real(c_double), intent(in) :: eta0, exponent, pole_pressure, d1, d2, load, floor
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact
    type(point_contact), allocatable :: film
    integer :: err
    !f2py threadsafe

    handle = 0
    stat = status_no_memory
    allocate (film, stat=err)
    if (err /= 0) return
    call new_point_contact(film, contact_conditions(gap, covered /= 0, [dx, dy], reduced_modulus, &
      oil_law(law, eta0, exponent, pole_pressure, d1, d2), load, floor, layers_of(layers)), u, v, stat)
    if (stat /= status_ok) return
    allocate (contact, stat=err)
    if (err /= 0) then
      stat = status_no_memory
      return
    end if
    call move_alloc(film, contact%film)
    handle = handle_of(contact)
  end subroutine point_film_new

  !> Makes a line contact; see `line_film` for the arguments and `viscosity_density` for the oil's.
  subroutine line_film_new(gap, covered, u, n, dx, reduced_modulus, layers, law, eta0, exponent, pole_pressure, &
      d1, d2, load, floor, handle, stat)
    use pyworm_coated_surface, only: layers_of
    use pyworm_line_film, only: line_contact, new_line_contact
    use pyworm_viscosity_density, only: oil_law
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: gap(n), u(n)
    integer(c_int), intent(in) :: covered(n)
    real(c_double), intent(in) :: dx, reduced_modulus, layers(5, 2)
    integer(c_int), intent(in) :: law
    real(c_double), intent(in) :: eta0, exponent, pole_pressure, d1, d2, load, floor
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact
    type(line_contact), allocatable :: film
    integer :: err
    !f2py threadsafe

    handle = 0
    stat = status_no_memory
    allocate (film, stat=err)
    if (err /= 0) return
    call new_line_contact(film, gap, covered /= 0, u, dx, reduced_modulus, &
      oil_law(law, eta0, exponent, pole_pressure, d1, d2), load, floor, stat)
    if (stat == status_ok) call film%plane%coat(reduced_modulus, layers_of(layers), stat)
    if (stat /= status_ok) return
    allocate (contact, stat=err)
    if (err /= 0) then
      stat = status_no_memory
      return
    end if
    call move_alloc(film, contact%film)
    handle = handle_of(contact)
  end subroutine line_film_new

  !> Frees the memory of a contact.
  subroutine film_free(handle)
    integer(c_int64_t), intent(in) :: handle
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    deallocate (contact)
  end subroutine film_free

  !> Sets the nodal entrainment of a point contact to (u, v) [m/s].
  subroutine point_film_entrain(handle, u, v, nx, ny)
    use pyworm_point_film, only: entrain
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: u(nx, ny), v(nx, ny)
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    call entrain(contact%film, u, v)
  end subroutine point_film_entrain

  !> Sets the nodal entrainment of a line contact to u [m/s].
  subroutine line_film_entrain(handle, u, n)
    use pyworm_line_film, only: entrain_line
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: u(n)
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    call entrain_line(contact%film, u)
  end subroutine line_film_entrain

  !> Sets the oil of a contact, at its inlet; see `viscosity_density` for the arguments. Tables and heat are set anew after it.
  subroutine film_set_oil(handle, law, eta0, exponent, pole_pressure, d1, d2)
    use pyworm_viscosity_density, only: oil_law
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: law
    real(c_double), intent(in) :: eta0, exponent, pole_pressure, d1, d2
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    contact%film%oil = oil_law(law, eta0, exponent, pole_pressure, d1, d2)
  end subroutine film_set_oil

  !> Sets the transient term of a contact's film; arguments as of `film_newton`.
  subroutine film_transient(handle, implicit_rate, explicit_rate, nx, ny, stat)
    use pyworm_film_newton, only: set_transient_term
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: implicit_rate, explicit_rate(nx, ny)
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    call set_transient_term(contact%film, implicit_rate, explicit_rate, stat)
  end subroutine film_transient

  !> Prepares a point contact for time steps along the path of the oil; see `point_film`.
  subroutine point_film_transport(handle, stat)
    use pyworm_point_film, only: transport
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    call transport(contact%film, stat)
  end subroutine point_film_transport

  !> Sets the mobility of a point contact over that of the oil at its inlet's temperature and at rest, and the slopes of its
  !> logarithm by pressure [1/Pa] and film [1/m].
  subroutine point_film_fluidity(handle, fluidity, by_p, by_h, nx, ny, stat)
    use pyworm_point_film, only: set_fluidity
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: fluidity(nx, ny), by_p(nx, ny), by_h(nx, ny)
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    call set_fluidity(contact%film, fluidity, by_p, by_h, stat)
  end subroutine point_film_fluidity

  !> Sets the undeformed gap of a contact; it must be evaluated before its next step.
  subroutine film_set_gap(handle, gap, nx, ny)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: gap(nx, ny)
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    contact%film%gap = gap
  end subroutine film_set_gap

  !> Keeps the rigid film of a contact as it is given, whatever load the film then carries.
  subroutine film_hold(handle)
    integer(c_int64_t), intent(in) :: handle
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    contact%film%rigid_film_fixed = .true.
  end subroutine film_hold

  !> Keeps the temperatures of a heated film as they are given.
  subroutine film_hold_rise(handle)
    integer(c_int64_t), intent(in) :: handle
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    if (allocated(contact%heat)) contact%heat%held = .true.
  end subroutine film_hold_rise

  !> Judges temperatures of a heated film where the pressure exceeds a fraction of the largest; see `thermal_step`.
  subroutine film_judge(handle, fraction)
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: fraction
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    if (allocated(contact%heat)) contact%heat%judged_pressure = fraction
  end subroutine film_judge

  !> Sets what both bodies of a heated contact remember of other fluxes before [K]; see `wall_balance`.
  subroutine film_remember(handle, remembered, nx, ny, stat)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: remembered(nx, ny, 2)
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact
    integer :: wall

    stat = status_not_finite
    if (.not. all(abs(remembered) <= huge(1.0_wp))) return
    stat = status_ok
    contact => contact_of(handle)
    do wall = 1, 2
      contact%heat%walls%body(wall)%remembered = remembered(:, :, wall)
    end do
  end subroutine film_remember

  !> Sets rates of change of a heated contact's oil: of its temperature at the levels, `warming` [K/s], which stores heat,
  !> and of its pressure, `pressing` [Pa/s].
  subroutine film_store(handle, warming, pressing, nx, ny, levels, stat)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny, levels
    real(c_double), intent(in) :: warming(nx, ny, levels), pressing(nx, ny)
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact

    stat = status_not_finite
    if (.not. (all(abs(warming) <= huge(1.0_wp)) .and. all(abs(pressing) <= huge(1.0_wp)))) return
    contact => contact_of(handle)
    call contact%heat%change_with_time(warming, pressing, stat)
  end subroutine film_store

  !> Sets the flow law of a contact's oil, without heat; see `flow_laws` and `film_newton` for the arguments.
  subroutine film_shear(handle, sliding_x, sliding_y, nx, ny, law, reference, reference_growth, &
      reference_decay, limit, limit_growth, exponent, by_stress, by_rate, cells, per_log, slip_step, levels, stat)
    use pyworm_film_newton, only: shear_contact
    use pyworm_flow_laws, only: flow_law
    use pyworm_thinning_table, only: thinning_table
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: sliding_x(nx, ny), sliding_y(nx, ny)
    integer(c_int), intent(in) :: law
    real(c_double), intent(in) :: reference, reference_growth, reference_decay, limit, limit_growth, exponent
    integer(c_int), intent(in) :: cells
    real(c_double), intent(in) :: by_stress(4, cells), by_rate(4, cells), per_log, slip_step
    integer(c_int), intent(in) :: levels
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact
    !f2py threadsafe

    contact => contact_of(handle)
    if (allocated(contact%heat)) deallocate (contact%heat)
    call shear_contact(contact%film, flow_law(law, reference, reference_growth, reference_decay, limit, &
      limit_growth, exponent, slip_step, thinning_table(per_log, by_stress), &
      thinning_table(per_log, by_rate)), levels, sliding_x, sliding_y, stat)
  end subroutine film_shear

  !> Sets the table of a contact's viscosity (1) or density (2), right after it was made; see `property_table`.
  subroutine film_tabulate(handle, property, coefficient, cold, cells, warmths, per_pressure, per_rise, first_rise)
    use pyworm_property_table, only: property_table
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: property, cells, warmths
    real(c_double), intent(in) :: coefficient(4, 4, cells, warmths), cold(4, cells), per_pressure, per_rise, first_rise
    type(thermal_contact), pointer :: contact
    type(property_table) :: table

    contact => contact_of(handle)
    table = property_table(per_pressure, per_rise, first_rise, coefficient, cold)
    if (property == 1) contact%film%oil%viscosity_table = table
    if (property == 2) contact%film%oil%density_table = table
  end subroutine film_tabulate

  !> Makes the surfaces of a contact with a flow law rough; see `rough_surfaces` for the curves, (curve, row).
  subroutine film_roughen(handle, scale, first, spacing, value, slope, curves, rows, boundary_friction, stat)
    use pyworm_film_newton, only: roughen_contact
    use pyworm_rough_surfaces, only: gap_curves
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: curves, rows
    real(c_double), intent(in) :: scale, first, spacing, value(curves, rows), slope(curves, rows), boundary_friction
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    call roughen_contact(contact%film, gap_curves(scale, first, spacing, value, slope), boundary_friction, stat)
  end subroutine film_roughen

  !> Limits the oil that enters a contact's gap to a layer of thickness `supply` [m]; see `partial_film`.
  subroutine film_feed(handle, supply, nx, ny, stat)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: supply(nx, ny)
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    call contact%film%feed(supply, stat)
  end subroutine film_feed

  !> Fraction of the gap that oil fills, of a contact with a limited supply, as last evaluated.
  subroutine film_fraction(handle, nx, ny, fraction)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(out) :: fraction(nx, ny)
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    fraction = reshape(contact%film%model%partial%fraction, [nx, ny])
  end subroutine film_fraction

  !> Sets where the oil has ruptured between rough surfaces, for the next evaluation.
  subroutine film_set_ruptured(handle, ruptured, nx, ny)
    use pyworm_film_newton, only: set_ruptured
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny, ruptured(nx, ny)
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    call set_ruptured(contact%film, ruptured /= 0)
  end subroutine film_set_ruptured

  !> Pressure that asperities bear of the total, that of their curve at the present gap [Pa], which differs until the film is
  !> solved, and real area of contact over the nominal, as last evaluated.
  subroutine film_asperities(handle, nx, ny, pressure, curve, area)
    use pyworm_rough_surfaces, only: asperity_pressure
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(out) :: pressure(nx, ny), curve(nx, ny), area(nx, ny)
    type(thermal_contact), pointer :: contact
    integer :: j

    contact => contact_of(handle)
    associate (fields => contact%film%model%fields)
      do j = 1, ny
        pressure(:, j) = asperity_pressure(fields%rough, fields%p, j)
      end do
      curve = pressure + fields%rough%excess
      area = fields%rough%area
    end associate
  end subroutine film_asperities

  !> Sets the film, and what asperities bear of it, at pressure p [Pa] and rigid film h0 [m], without its flow.
  subroutine film_place(handle, p, nx, ny, h0)
    use pyworm_film_newton, only: set_film
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: p(nx, ny)
    real(c_double), intent(in) :: h0
    type(thermal_contact), pointer :: contact
    !f2py threadsafe

    contact => contact_of(handle)
    call contact%film%work%whole%start()
    call set_film(contact%film, p, h0)
    call contact%film%work%whole%finish()
  end subroutine film_place

  !> Evaluates residual and load error at pressure p [Pa] and rigid film h0 [m].
  subroutine film_evaluate(handle, p, nx, ny, h0, residual, load_error)
    use pyworm_film_newton, only: film_residual
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: p(nx, ny)
    real(c_double), intent(in) :: h0
    real(c_double), intent(out) :: residual, load_error
    type(thermal_contact), pointer :: contact
    !f2py threadsafe

    contact => contact_of(handle)
    call contact%film%work%whole%start()
    call film_residual(contact%film, p, h0, residual, load_error)
    call contact%film%work%whole%finish()
  end subroutine film_evaluate

  !> Replaces the explicit part of the transient term of a point contact; residual and load error of the present film follow.
  subroutine point_film_limit(handle, explicit_rate, nx, ny, residual, load_error, stat)
    use pyworm_film_newton, only: film_balance_again
    use pyworm_point_film, only: limit_rate
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: explicit_rate(nx, ny)
    real(c_double), intent(out) :: residual, load_error
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact
    !f2py threadsafe

    residual = 0
    load_error = 0
    contact => contact_of(handle)
    call contact%film%work%whole%start()
    call limit_rate(contact%film, explicit_rate, stat)
    if (stat == status_ok) call film_balance_again(contact%film, residual, load_error)
    call contact%film%work%whole%finish()
  end subroutine point_film_limit

  !> Makes one Newton step from the state last evaluated, and where heat is simulated one sweep of it; p and h0 are replaced.
  !>
  !> `change` is the largest change of temperature [K], and `largest_rise` the largest rise of the film [K].
  subroutine film_step(handle, forcing, p, nx, ny, h0, last_residual, last_load_error, new_h0, residual, &
      load_error, krylov, damping, change, largest_rise, stat)
    use pyworm_film_newton, only: newton_step, cold_step => film_step
    use pyworm_thermal_step, only: heated_step
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: forcing
    real(c_double), intent(inout) :: p(nx, ny)
    real(c_double), intent(in) :: h0, last_residual, last_load_error
    real(c_double), intent(out) :: new_h0, residual, load_error, damping, change, largest_rise
    integer(c_int), intent(out) :: krylov, stat
    type(thermal_contact), pointer :: contact
    type(newton_step) :: step
    logical :: sweeps
    !f2py threadsafe

    contact => contact_of(handle)
    new_h0 = h0
    residual = last_residual
    load_error = last_load_error
    largest_rise = 0
    call contact%film%work%whole%start()
    sweeps = allocated(contact%heat)
    if (sweeps) sweeps = .not. contact%heat%held
    if (sweeps) then
      call heated_step(contact%film, contact%heat, forcing, p, new_h0, residual, load_error, step, stat)
      largest_rise = maxval(contact%film%model%shear%nodes%rise)
    else
      call cold_step(contact%film, forcing, p, new_h0, residual, load_error, step, stat)
    end if
    krylov = step%krylov
    damping = step%damping
    change = step%change
    call contact%film%work%whole%finish()
  end subroutine film_step

  !> Evaluates a contact at the state of another with the same nodes, gap and moduli, whose rigid film is h0 [m], ruptured where it
  !> is; stresses of the faces start from its.
  subroutine film_evaluate_at(handle, other, h0, residual, load_error)
    use pyworm_film_newton, only: film_residual_at, set_ruptured
    integer(c_int64_t), intent(in) :: handle, other
    real(c_double), intent(in) :: h0
    real(c_double), intent(out) :: residual, load_error
    type(thermal_contact), pointer :: contact, found
    !f2py threadsafe

    contact => contact_of(handle)
    found => contact_of(other)
    associate (from => found%film%model, to => contact%film%model)
      if (from%is_rough()) call set_ruptured(contact%film, from%fields%rough%ruptured)
      if (from%is_sheared() .and. to%is_sheared()) then
        to%shear%along_x%stress_x = from%shear%along_x%stress_x
        to%shear%along_x%stress_y = from%shear%along_x%stress_y
        to%shear%along_y%stress_x = from%shear%along_y%stress_x
        to%shear%along_y%stress_y = from%shear%along_y%stress_y
      end if
    end associate
    call film_residual_at(contact%film, found%film, h0, residual, load_error)
  end subroutine film_evaluate_at

  !> Sensitivities of figures by the adjoint of a contact at its solution; see `contact_adjoint` for the weights and what is found;
  !> `active` is 1 where the oil's flow is balanced.
  subroutine film_adjoints(handle, weights, nx, ny, fields, figures, rise_weights, levels, tolerance, most, rows, heat_rows, &
      by_gap, by_load, active, iterations, reduction, stat)
    use pyworm_contact_adjoint, only: contact_adjoints
    use pyworm_thermal_adjoint, only: thermal_adjoint
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny, fields, figures, levels, most
    real(c_double), intent(in) :: weights(nx, ny, fields, figures), rise_weights(nx, ny, levels, figures), tolerance
    real(c_double), intent(out) :: rows(nx, ny, figures), heat_rows(nx, ny, levels, figures), by_gap(nx, ny, figures), &
      by_load(figures), reduction(figures)
    integer(c_int), intent(out) :: active(nx, ny), iterations(figures), stat
    type(thermal_contact), pointer :: contact
    type(thermal_adjoint) :: found(figures)
    integer :: figure
    !f2py threadsafe

    contact => contact_of(handle)
    rows = 0
    heat_rows = 0
    by_gap = 0
    call contact_adjoints(contact, weights, rise_weights, tolerance, most, found, stat)
    active = merge(1, 0, contact%film%free)
    by_load = found%by_load
    iterations = found%iterations
    reduction = found%reduction
    if (stat /= status_ok) return
    do figure = 1, figures
      rows(:, :, figure) = found(figure)%rows
      by_gap(:, :, figure) = found(figure)%by_gap
      if (allocated(found(figure)%heat)) heat_rows(:, :, :, figure) = found(figure)%heat
    end do
  end subroutine film_adjoints

  !> Change of what the equations of a heated contact's temperature miss from another at the same state, with the conduction of its
  !> bodies; see `heat_residual_change`.
  subroutine film_heat_change(handle, other, nx, ny, levels, change, stat)
    use pyworm_heat_residual, only: heat_residual_change
    integer(c_int64_t), intent(in) :: handle, other
    integer(c_int), intent(in) :: nx, ny, levels
    real(c_double), intent(out) :: change(nx, ny, levels)
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact, before
    !f2py threadsafe

    contact => contact_of(handle)
    before => contact_of(other)
    change = 0
    call heat_residual_change(contact%film, contact%heat, before%film, before%heat, change, stat)
  end subroutine film_heat_change

  !> Change of the walls' balance from another contact at the same state by the conduction of the bodies alone, wall last; see
  !> `spread_residual_change`.
  subroutine film_spread_change(handle, other, nx, ny, levels, change, stat)
    use pyworm_heat_residual, only: spread_residual_change
    integer(c_int64_t), intent(in) :: handle, other
    integer(c_int), intent(in) :: nx, ny, levels
    real(c_double), intent(out) :: change(nx, ny, levels)
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact, before
    !f2py threadsafe

    contact => contact_of(handle)
    before => contact_of(other)
    change = 0
    call spread_residual_change(contact%heat, before%film, before%heat, change, stat)
  end subroutine film_spread_change

  !> Film [m], relative density and net outflow [m/s] as last evaluated.
  subroutine film_state(handle, nx, ny, film, density, imbalance)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(out) :: film(nx, ny), density(nx, ny), imbalance(nx, ny)
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    film = contact%film%model%fields%h
    density = contact%film%model%fields%rho
    imbalance = contact%film%imbalance
  end subroutine film_state

  !> Film [m] alone, as last evaluated.
  subroutine film_thickness(handle, nx, ny, film)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(out) :: film(nx, ny)
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    film = contact%film%model%fields%h
  end subroutine film_thickness

  !> Deflection w [m] under pressure p [Pa] on the contact's grid, the unit of cost.
  subroutine film_convolve(handle, p, nx, ny, w)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: p(nx, ny)
    real(c_double), intent(out) :: w(nx, ny)
    type(thermal_contact), pointer :: contact
    !f2py threadsafe

    contact => contact_of(handle)
    call contact%film%deflection(p, w)
  end subroutine film_convolve

  !> Counts and processor times [s] of the parts of the work on a contact: convolutions, fields and flows, building
  !> the preconditioner, its solves, heat, and whole steps and evaluations.
  subroutine film_tally(handle, counts, seconds)
    use pyworm_tally, only: work_tally
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: counts(6)
    real(c_double), intent(out) :: seconds(6)
    type(thermal_contact), pointer :: contact
    type(work_tally) :: heat

    contact => contact_of(handle)
    if (allocated(contact%heat)) heat = contact%heat%work
    associate (work => contact%film%work)
      counts = [work%convolution%count, work%flow%count, work%building%count, work%cycle%count, heat%count, &
        work%whole%count]
      seconds = [work%convolution%seconds, work%flow%seconds, work%building%seconds, work%cycle%seconds, &
        heat%seconds, work%whole%seconds]
    end associate
  end subroutine film_tally

  !> Adds heat to a point contact whose oil has a flow law; see `point_heat` for the arguments.
  !>
  !> `oil` holds T0 [K], the exponent of viscosity with temperature, expansivity and its decay (`viscosity_density`),
  !> conductivity, c1, c2, capacity, k1, k2, b0, b1, b2 (`thermal_properties`); `bodies` conductivity, heat capacity and
  !> bulk temperature above the inlet's of each; `semi` the contact's semi-axes [m]. `errors` are
  !> those of the bodies' model of conduction (`conduction_model`).
  subroutine point_film_heat(handle, u1, v1, u2, v2, nx, ny, oil, bodies, semi, errors, stat)
    use pyworm_conducting_body, only: new_conducting_body
    use pyworm_heated_surface, only: heated_body
    use pyworm_point_heat, only: heat_point_contact
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: u1(nx, ny), v1(nx, ny), u2(nx, ny), v2(nx, ny)
    real(c_double), intent(in) :: oil(13), bodies(3, 2), semi(2)
    real(c_double), intent(out) :: errors(2)
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact
    class(heated_body), allocatable :: body_1, body_2
    !f2py threadsafe

    contact => contact_of(handle)
    associate (p => contact%film%model%fields%p, dx => contact%film%spacing(1), dy => contact%film%spacing(2))
      call new_conducting_body(u1, v1, p, semi, [dx, dy], bodies(1, 1), bodies(2, 1), body_1, errors(1), stat)
      if (stat == status_ok) call new_conducting_body(u2, v2, p, semi, [dx, dy], bodies(1, 2), bodies(2, 2), body_2, &
        errors(2), stat)
    end associate
    if (stat /= status_ok) return
    call set_oil_temperature(contact%film%oil, oil)
    call heat_point_contact(contact, heat_law(oil), u1, v1, body_1, body_2, bodies(3, :), stat)
  end subroutine point_film_heat

  !> Adds heat to a line contact whose oil has a flow law; see `line_heat` for the arguments.
  !>
  !> `oil` and `bodies` as in `point_film_heat`; `velocities` [m/s] are those of both surfaces, neither of them zero.
  subroutine line_film_heat(handle, u1, n, oil, bodies, velocities, stat)
    use pyworm_heated_surface, only: heated_body
    use pyworm_line_heat, only: heat_line_contact
    use pyworm_line_source, only: line_body, new_line_body
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: u1(n)
    real(c_double), intent(in) :: oil(13), bodies(3, 2), velocities(2)
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact
    class(heated_body), allocatable :: body_1, body_2
    !f2py threadsafe

    contact => contact_of(handle)
    call new_body(1, body_1)
    if (stat == status_ok) call new_body(2, body_2)
    if (stat /= status_ok) return
    call set_oil_temperature(contact%film%oil, oil)
    call heat_line_contact(contact, heat_law(oil), u1, body_1, body_2, bodies(3, :), stat)

  contains

    !> A body on the contact's grid.
    subroutine new_body(body, surface)
      integer, intent(in) :: body
      class(heated_body), allocatable, intent(out) :: surface
      type(line_body), allocatable :: moving

      allocate (moving)
      call new_line_body(moving, n, contact%film%spacing(1), velocities(body), bodies(1, body), bodies(2, body), stat)
      call move_alloc(moving, surface)
    end subroutine new_body

  end subroutine line_film_heat

  !> Temperature terms of an oil's viscosity and density, from the argument of `point_film_heat`.
  subroutine set_oil_temperature(law, oil)
    use pyworm_viscosity_density, only: oil_law
    type(oil_law), intent(inout) :: law
    real(c_double), intent(in) :: oil(13)

    law%temperature = oil(1)
    law%thermal_exponent = oil(2)
    law%expansivity = oil(3)
    law%expansivity_decay = oil(4)
  end subroutine set_oil_temperature

  !> Conductivity and heat capacity of an oil, from the argument of `point_film_heat`.
  function heat_law(oil) result(law)
    use pyworm_thermal_properties, only: oil_heat_law
    real(c_double), intent(in) :: oil(13)
    type(oil_heat_law) :: law

    law = oil_heat_law(oil(5), oil(6), oil(7), oil(8), oil(9), oil(10), oil(11), oil(12), oil(13))
  end function heat_law

  !> Makes one sweep of heat (`thermal_step`); `change` is the largest change of temperature [K].
  subroutine film_warm(handle, change, stat)
    use pyworm_thermal_step, only: heat_sweep
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(out) :: change
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact
    !f2py threadsafe

    contact => contact_of(handle)
    call heat_sweep(contact%film, contact%heat, change, stat)
  end subroutine film_warm

  !> Number of faces and columns whose shear stress did not converge when last solved.
  subroutine film_unsolved(handle, count)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: count
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    count = 0
    count = contact%film%model%unsolved()
    if (allocated(contact%heat)) count = count + contact%heat%unsolved()
  end subroutine film_unsolved

  !> Temperature of a contact above its inlet's [K], at the levels from body 1 to body 2.
  subroutine film_rise(handle, nx, ny, levels, rise)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny, levels
    real(c_double), intent(out) :: rise(nx, ny, levels)
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    rise = contact%film%model%shear%nodes%rise
  end subroutine film_rise

  !> Sets the temperature above the inlet's [K].
  subroutine film_set_rise(handle, rise, nx, ny, levels)
    use pyworm_thermal_step, only: start_temperature
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny, levels
    real(c_double), intent(in) :: rise(nx, ny, levels)
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    call start_temperature(contact%film, contact%heat, rise)
  end subroutine film_set_rise

  !> Fields of a contact's shear, as far as nodes are `counted`; see `shear_fields`.
  subroutine film_shear_fields(handle, factors_wanted, counted, nx, ny, stress_x, stress_y, friction, rate, along, across, slip, &
      stat)
    use pyworm_shear_fields, only: shear_field, nodal_shear
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: factors_wanted, nx, ny, counted(nx, ny)
    real(c_double), intent(out) :: stress_x(nx, ny), stress_y(nx, ny), friction(nx, ny), rate(nx, ny), along(nx, ny), &
      across(nx, ny)
    integer(c_int), intent(out) :: slip(nx, ny), stat
    type(thermal_contact), pointer :: contact
    type(shear_field) :: field
    !f2py threadsafe

    contact => contact_of(handle)
    call nodal_shear(contact%film, factors_wanted /= 0, field, stat, counted /= 0)
    if (stat /= status_ok) return
    stress_x = field%stress_x
    stress_y = field%stress_y
    friction = field%friction
    rate = field%rate
    along = field%along
    across = field%across
    slip = field%slip
  end subroutine film_shear_fields

  !> Stress at the middle of the film [Pa], heat of shearing [W/m2] and the largest shear rate across the film [1/s] of a
  !> point contact, as of the last sweep of heat.
  subroutine point_film_swept_shear(handle, nx, ny, stress_x, stress_y, friction, rate)
    use pyworm_point_heat, only: swept_shear
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(out) :: stress_x(nx, ny), stress_y(nx, ny), friction(nx, ny), rate(nx, ny)
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    call swept_shear(contact%heat, stress_x, stress_y, friction, rate)
  end subroutine point_film_swept_shear

  !> Heat flux into the bodies, and heat convected by the oil less that of its compression [W/m2], at the last sweep.
  subroutine film_heat_fields(handle, nx, ny, flux, carried)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(out) :: flux(nx, ny, 2), carried(nx, ny)
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    flux = contact%heat%walls%flux
    call contact%heat%carried_heat(carried)
  end subroutine film_heat_fields

  !> Velocity [m/s] across the film at node (i, j), counted from 1, body 1 moving with (u1, v1).
  subroutine film_profile(handle, i, j, u1, v1, levels, u, v, stat)
    use pyworm_shear_fields, only: profile => film_profile
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: i, j, levels
    real(c_double), intent(in) :: u1, v1
    real(c_double), intent(out) :: u(levels), v(levels)
    integer(c_int), intent(out) :: stat
    type(thermal_contact), pointer :: contact

    contact => contact_of(handle)
    call profile(contact%film, i, j, u1, v1, u, v, stat)
  end subroutine film_profile

  !> Positions of `count` levels across a film, from -1/2 at body 1 to 1/2 at body 2.
  subroutine level_positions(count, z)
    use pyworm_gauss_lobatto, only: levels_across, new_levels
    integer(c_int), intent(in) :: count
    real(c_double), intent(out) :: z(count)
    type(levels_across) :: levels

    levels = new_levels(count)
    z = levels%z
  end subroutine level_positions

  !> Interpolates a field to half the spacing.
  subroutine prolong_cubic(coarse, nx, ny, fine)
    use pyworm_cubic_refinement, only: interpolate_cubic
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: coarse(nx, ny)
    real(c_double), intent(out) :: fine(2*nx - 1, 2*ny - 1)
    !f2py threadsafe

    call interpolate_cubic(coarse, fine)
  end subroutine prolong_cubic

  !> Numbers of the times, the present the first, whose fluxes count for a surface (`residual_rise`), of which there are `count`.
  subroutine heated_times(ages, times, nx, ny, spacing, velocity, diffusivity, chosen, count)
    use pyworm_residual_rise, only: chosen_times
    integer(c_int), intent(in) :: times, nx, ny
    real(c_double), intent(in) :: ages(times), spacing(2), velocity(2), diffusivity
    integer(c_int), intent(out) :: chosen(times), count
    integer, allocatable :: numbers(:)

    allocate (numbers, source=chosen_times(ages, [nx, ny], spacing, velocity, diffusivity))
    count = size(numbers)
    chosen = 0
    chosen(:count) = numbers
  end subroutine heated_times

  !> Present flux into both bodies by the last two (`residual_rise`).
  subroutine extrapolated_flux(latest, before, nodes, ahead, flux)
    use pyworm_residual_rise, only: onward_flux
    integer(c_int), intent(in) :: nodes
    real(c_double), intent(in) :: latest(nodes, 2), before(nodes, 2), ahead
    real(c_double), intent(out) :: flux(nodes, 2)

    call onward_flux(latest(:, 1), latest(:, 2), before(:, 1), before(:, 2), ahead, flux(:, 1), flux(:, 2))
  end subroutine extrapolated_flux

  !> What a surface is warmer than by steady conduction [K] (`residual_rise`); `flux` is that of the times `chosen`.
  subroutine surface_residual_rise(ages, velocities, times, chosen, flux, nx, ny, count, first, spacing, body, turning, u, v, &
      rise)
    use pyworm_remembered_flux, only: moving_axes
    use pyworm_residual_rise, only: residual_rise, surface_past
    integer(c_int), intent(in) :: times, nx, ny, count
    real(c_double), intent(in) :: ages(times), velocities(2, times), flux(nx, ny, count), first(2, count), spacing(2, count)
    integer(c_int), intent(in) :: chosen(count)
    real(c_double), intent(in) :: body(2), turning, u(nx, ny), v(nx, ny)
    real(c_double), intent(out) :: rise(nx, ny)
    type(moving_axes) :: axes(count)
    integer :: k
    !f2py threadsafe

    axes = [(moving_axes(first(:, k), spacing(:, k)), k=1, count)]
    call residual_rise(surface_past(ages, velocities, chosen, flux, axes), body(1), body(2), turning, u, v, rise)
  end subroutine surface_residual_rise

  !> Height [m] of a flank, q and margin to its end at points of the tangent plane [m], from guesses of q (`flank_height`).
  subroutine flank_heights(kind, seat, form, curve, powers, frame, start, x, y, n, guess, q, height, left)
    use pyworm_flank_height, only: flank_height
    integer(c_int), intent(in) :: kind, powers, n
    real(c_double), intent(in) :: seat(4), form(9), curve(3, powers), frame(3, 4), start(3), x(n), y(n), guess(3, n)
    real(c_double), intent(out) :: q(3, n), height(n), left(n)
    type(flank_height) :: flank
    integer :: k
    !f2py threadsafe

    call set_flank(flank, kind, seat, form, curve, frame, start)
    q = guess
    do k = 1, n
      call flank%converge(x(k), y(k), q(:, k), height(k), left(k))
    end do
  end subroutine flank_heights

  !> Height [m] of a flank, slopes, second derivatives and rates of q [1/m] at points where q is known (`flank_height`).
  subroutine flank_expansions(kind, seat, form, curve, powers, frame, start, x, y, n, q, height, slopes, bend, rates)
    use pyworm_flank_height, only: flank_height
    integer(c_int), intent(in) :: kind, powers, n
    real(c_double), intent(in) :: seat(4), form(9), curve(3, powers), frame(3, 4), start(3), x(n), y(n), q(3, n)
    real(c_double), intent(out) :: height(n), slopes(2, n), bend(2, 2, n), rates(3, 2, n)
    type(flank_height) :: flank
    integer :: k
    !f2py threadsafe

    call set_flank(flank, kind, seat, form, curve, frame, start)
    do k = 1, n
      call flank%expand(x(k), y(k), q(:, k), height(k), slopes(:, k), bend(:, :, k), rates(:, :, k))
    end do
  end subroutine flank_expansions

  !> Fractions of rays to points [m] that lie on a flank, and q there (`flank_height`).
  subroutine flank_ends(kind, seat, form, curve, powers, frame, start, x, y, n, reach, q)
    use pyworm_flank_height, only: flank_height
    integer(c_int), intent(in) :: kind, powers, n
    real(c_double), intent(in) :: seat(4), form(9), curve(3, powers), frame(3, 4), start(3), x(n), y(n)
    real(c_double), intent(out) :: reach(n), q(3, n)
    type(flank_height) :: flank
    integer :: k
    !f2py threadsafe

    call set_flank(flank, kind, seat, form, curve, frame, start)
    do k = 1, n
      call flank%end_of_ray(x(k), y(k), reach(k), q(:, k))
    end do
  end subroutine flank_ends

  !> The flank of a kind, in the frame of a contact (ex, ey, ez and the contact point, in columns).
  subroutine set_flank(flank, kind, seat, form, curve, frame, start)
    use pyworm_flank_height, only: flank_height, new_flank_height
    use pyworm_flank_points, only: new_wheel_points, new_worm_points, swept_curve, wheel_points, worm_points
    use pyworm_flank_surface, only: contact_frame, new_screw_seat, screw_seat
    use pyworm_tangent_planes, only: new_wheel_planes, new_worm_planes
    type(flank_height), intent(out) :: flank
    integer(c_int), intent(in) :: kind
    real(c_double), intent(in) :: seat(4), form(9), curve(:, :), frame(3, 4), start(3)
    type(contact_frame) :: contact
    type(screw_seat) :: place
    type(swept_curve) :: swept
    type(worm_points) :: worm
    type(wheel_points) :: wheel

    contact = contact_frame(frame(:, 1), frame(:, 2), frame(:, 3), frame(:, 4))
    place = new_screw_seat(seat(1), seat(2), seat(3))
    allocate (swept%coefficients, source=curve)
    swept%middle = form(4)
    swept%half = form(5)
    swept%arc = form(6)
    swept%top = form(7)
    select case (kind)
    case (1)
      call new_flank_height(flank, new_worm_planes(place, seat(4), form(1), form(2)), contact, start)
    case (2)
      call new_flank_height(flank, new_wheel_planes(place, seat(4), form(1), form(2), form(3)), contact, start)
    case (3)
      worm = new_worm_points(place, seat(4), swept, form(8:9), form(1), form(2))
      call new_flank_height(flank, worm, contact, start)
    case default
      wheel = new_wheel_points(place, seat(4), swept, form(8:9), form(1), form(2), form(3))
      call new_flank_height(flank, wheel, contact, start)
    end select
  end subroutine set_flank

  !> Tables of the thinning of a flow law by its curve, stress over Newtonian stress; see `flow_table`.
  subroutine flow_tables(newtonian, stress, points, cells, by_stress, by_rate, per_log)
    use pyworm_flow_table, only: tabulate_flow
    use pyworm_thinning_table, only: thinning_table
    integer(c_int), intent(in) :: points, cells
    real(c_double), intent(in) :: newtonian(points), stress(points)
    real(c_double), intent(out) :: by_stress(4, cells), by_rate(4, cells), per_log
    type(thinning_table) :: of_stress, of_rate

    call tabulate_flow(newtonian, stress, of_stress, of_rate)
    by_stress = of_stress%coefficient(:, :cells)
    by_rate = of_rate%coefficient(:, :cells)
    per_log = of_stress%per_log
  end subroutine flow_tables

  !> Lets Python's signals interrupt kernel calls, from now on.
  subroutine watch_signals()
    use python_interruption, only: heed_python

    call heed_python()
  end subroutine watch_signals

  !> Text of a status, padded with blanks.
  subroutine status_text(stat, text)
    use pyworm_status, only: status_message
    integer(c_int), intent(in) :: stat
    character(len=100), intent(out) :: text

    text = status_message(stat)
  end subroutine status_text

  !> The compiler of the kernel and its options, padded with blanks.
  subroutine compiled_with(compiler, options)
    use iso_fortran_env, only: compiler_options, compiler_version
    character(len=200), intent(out) :: compiler
    character(len=2000), intent(out) :: options

    compiler = compiler_version()
    options = compiler_options()
  end subroutine compiled_with

end module bindings
