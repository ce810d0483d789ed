!> All that Python sees of the kernel: plain arrays and scalars, explicit shapes, an integer status.
!>
!> A contact that lives through many calls is held by its owner as an opaque address (`handle`), made by
!> `point_film_new` and given back to `point_film_free`.
module bindings
  use iso_c_binding, only: c_double, c_int, c_int64_t
  implicit none
  private

  public :: dry_contact_solve, elastic_deflection
  public :: point_film_new, point_film_free, point_film_evaluate, point_film_step, point_film_fields, &
    point_film_convolve, point_film_work, point_film_thickness, point_film_entrain, point_film_store, point_film_shear, &
    point_film_heat, point_film_warm, point_film_rise, point_film_set_rise, point_film_unsolved, &
    point_film_shear_fields, point_film_heat_fields, point_film_profile
  public :: line_film_new, line_film_free, line_film_evaluate, line_film_step, line_film_fields, &
    line_film_convolve, line_film_store, line_film_shear, line_film_heat, line_film_rise, line_film_unsolved, &
    line_film_set_rise, line_film_shear_fields, line_film_heat_fields, line_film_profile
  public :: prolong_cubic, level_positions
  public :: compiled_with

contains

  !> Deflection w [m] of a half-space pair under pressure p [Pa].
  subroutine elastic_deflection(p, nx, ny, dx, dy, reduced_modulus, w, stat)
    use half_space, only: elastic_half_space, new_half_space
    use status, only: status_ok
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: p(nx, ny)
    real(c_double), intent(in) :: dx, dy, reduced_modulus
    real(c_double), intent(out) :: w(nx, ny)
    integer(c_int), intent(out) :: stat
    type(elastic_half_space) :: space
    !f2py threadsafe

    w = 0
    call new_half_space(space, nx, ny, dx, dy, reduced_modulus, stat)
    if (stat == status_ok) call space%deflection(p, w)
  end subroutine elastic_deflection

  !> Dry contact of a gap [m]; p [Pa] enters as a first guess and leaves as the solution.
  subroutine dry_contact_solve(gap, covered, nx, ny, dx, dy, reduced_modulus, load, tolerance, &
      most_iterations, p, approach, iterations, stat)
    use dry_contact, only: solve_dry_contact
    use half_space, only: elastic_half_space, new_half_space
    use status, only: status_ok
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: gap(nx, ny)
    integer(c_int), intent(in) :: covered(nx, ny)
    real(c_double), intent(in) :: dx, dy, reduced_modulus, load, tolerance
    integer(c_int), intent(in) :: most_iterations
    real(c_double), intent(inout) :: p(nx, ny)
    real(c_double), intent(out) :: approach
    integer(c_int), intent(out) :: iterations, stat
    type(elastic_half_space) :: space
    !f2py threadsafe

    approach = 0
    iterations = 0
    call new_half_space(space, nx, ny, dx, dy, reduced_modulus, stat)
    if (stat == status_ok) call solve_dry_contact(space, gap, covered /= 0, load, tolerance, &
      most_iterations, p, approach, iterations, stat)
  end subroutine dry_contact_solve

  !> Makes a point contact; see `point_film` for the arguments and `oil_laws` for the oil's.
  subroutine point_film_new(gap, covered, u, v, nx, ny, dx, dy, reduced_modulus, law, eta0, exponent, &
      pole_pressure, d1, d2, load, floor, handle, stat)
    use oil_laws, only: oil_law
    use point_film, only: new_point_contact
    use contact_handle, only: handle_of
    use film_temperature, only: heated_contact
    use status, only: status_ok, status_no_memory
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: gap(nx, ny), u(nx, ny), v(nx, ny)
    integer(c_int), intent(in) :: covered(nx, ny)
    real(c_double), intent(in) :: dx, dy, reduced_modulus
    integer(c_int), intent(in) :: law
    real(c_double), intent(in) :: eta0, exponent, pole_pressure, d1, d2, load, floor
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: stat
    type(heated_contact), pointer :: contact
    integer :: err
    !f2py threadsafe

    handle = 0
    stat = status_no_memory
    allocate (contact, stat=err)
    if (err /= 0) return
    call new_point_contact(contact%point_contact, gap, covered /= 0, u, v, dx, dy, reduced_modulus, &
      oil_law(law, eta0, exponent, pole_pressure, d1, d2), load, floor, stat)
    if (stat == status_ok) then
      handle = handle_of(contact)
    else
      deallocate (contact)
    end if
  end subroutine point_film_new

  !> Gives back the memory of a contact.
  subroutine point_film_free(handle)
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact
    integer(c_int64_t), intent(in) :: handle
    type(heated_contact), pointer :: contact

    contact => contact_of(handle)
    deallocate (contact)
  end subroutine point_film_free

  !> Changes the nodal entrainment of a contact to (u, v) [m/s].
  subroutine point_film_entrain(handle, u, v, nx, ny)
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact
    use point_film, only: entrain
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: u(nx, ny), v(nx, ny)
    type(heated_contact), pointer :: contact

    contact => contact_of(handle)
    call entrain(contact%point_contact, u, v)
  end subroutine point_film_entrain

  !> Lets the oil that a contact's film stores change by `renewal` [1/s] times rho h, and by `squeeze` [m/s].
  subroutine point_film_store(handle, renewal, squeeze, nx, ny, stat)
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact
    use point_film, only: store
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: renewal, squeeze(nx, ny)
    integer(c_int), intent(out) :: stat
    type(heated_contact), pointer :: contact

    contact => contact_of(handle)
    call store(contact%point_contact, renewal, squeeze, stat)
  end subroutine point_film_store

  !> Gives a contact's oil a flow law; see `flow_laws` and `point_film` for the arguments.
  subroutine point_film_shear(handle, sliding_x, sliding_y, nx, ny, law, reference, reference_growth, &
      reference_decay, limit, limit_growth, exponent, levels, stat)
    use flow_laws, only: flow_law
    use point_film, only: shear_point_contact
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: sliding_x(nx, ny), sliding_y(nx, ny)
    integer(c_int), intent(in) :: law
    real(c_double), intent(in) :: reference, reference_growth, reference_decay, limit, limit_growth, exponent
    integer(c_int), intent(in) :: levels
    integer(c_int), intent(out) :: stat
    type(heated_contact), pointer :: contact
    !f2py threadsafe

    contact => contact_of(handle)
    call shear_point_contact(contact%point_contact, flow_law(law, reference, reference_growth, reference_decay, limit, &
      limit_growth, exponent), levels, sliding_x, sliding_y, stat)
  end subroutine point_film_shear

  !> Residual and load error at pressure p [Pa] and rigid film h0 [m].
  subroutine point_film_evaluate(handle, p, nx, ny, h0, residual, load_error)
    use point_film, only: film_residual
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: p(nx, ny)
    real(c_double), intent(in) :: h0
    real(c_double), intent(out) :: residual, load_error
    type(heated_contact), pointer :: contact
    !f2py threadsafe

    contact => contact_of(handle)
    call contact%work%whole%start()
    call film_residual(contact%point_contact, p, h0, residual, load_error)
    call contact%work%whole%finish()
  end subroutine point_film_evaluate

  !> One Newton step from the state last evaluated, and where heat is simulated one sweep of it; p and h0 are replaced.
  !>
  !> `change` is the change of temperature [K] that heat is judged by, and `largest_rise` the film's [K].
  subroutine point_film_step(handle, forcing, p, nx, ny, h0, last_residual, last_load_error, new_h0, residual, &
      load_error, krylov, step, change, largest_rise, stat)
    use point_film, only: film_step
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact, heated_step
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: forcing
    real(c_double), intent(inout) :: p(nx, ny)
    real(c_double), intent(in) :: h0, last_residual, last_load_error
    real(c_double), intent(out) :: new_h0, residual, load_error, step, change, largest_rise
    integer(c_int), intent(out) :: krylov, stat
    type(heated_contact), pointer :: contact
    !f2py threadsafe

    contact => contact_of(handle)
    new_h0 = h0
    residual = last_residual
    load_error = last_load_error
    change = 0
    largest_rise = 0
    call contact%work%whole%start()
    if (allocated(contact%heat)) then
      call heated_step(contact, forcing, p, new_h0, residual, load_error, krylov, step, change, stat)
      largest_rise = maxval(contact%shear%nodes%rise)
    else
      call film_step(contact%point_contact, forcing, p, new_h0, residual, load_error, krylov, step, stat)
    end if
    call contact%work%whole%finish()
  end subroutine point_film_step

  !> Film [m], viscosity-free mobility [m3/(Pa s)], relative density and net outflow [m/s] as last evaluated.
  subroutine point_film_fields(handle, nx, ny, film, density, imbalance)
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(out) :: film(nx, ny), density(nx, ny), imbalance(nx, ny)
    type(heated_contact), pointer :: contact

    contact => contact_of(handle)
    film = contact%fields%h
    density = contact%fields%rho
    imbalance = contact%imbalance
  end subroutine point_film_fields

  !> Deflection w [m] under pressure p [Pa] on the contact's own grid: the unit of cost.
  subroutine point_film_convolve(handle, p, nx, ny, w)
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: p(nx, ny)
    real(c_double), intent(out) :: w(nx, ny)
    type(heated_contact), pointer :: contact
    !f2py threadsafe

    contact => contact_of(handle)
    call contact%space%deflection(p, w)
  end subroutine point_film_convolve

  !> Heat of a contact whose oil has a flow law; see `film_temperature` for the arguments.
  !>
  !> `oil` holds T0 [K], the exponent of viscosity with temperature, expansivity and its decay (`oil_laws`),
  !> conductivity, c1, c2, capacity, k1, k2, b0, b1, b2 (`oil_heat`); `bodies` conductivity, heat capacity and bulk
  !> temperature above the inlet's of each; `semi` the contact's semi-axes [m]. `errors` are those of the bodies' model
  !> of conduction (`conduction_model`).
  subroutine point_film_heat(handle, u1, v1, u2, v2, nx, ny, oil, bodies, semi, errors, stat)
    use conducting_body, only: new_conducting_body
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact, heat_contact
    use heated_surface, only: heated_body
    use oil_heat, only: oil_heat_law
    use status, only: status_ok
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: u1(nx, ny), v1(nx, ny), u2(nx, ny), v2(nx, ny)
    real(c_double), intent(in) :: oil(13), bodies(3, 2), semi(2)
    real(c_double), intent(out) :: errors(2)
    integer(c_int), intent(out) :: stat
    type(heated_contact), pointer :: contact
    class(heated_body), allocatable :: body_1, body_2
    !f2py threadsafe

    contact => contact_of(handle)
    associate (heat => contact%fields%p, dx => contact%grid%dx, dy => contact%grid%dy)
      call new_conducting_body(u1, v1, heat, semi, dx, dy, bodies(1, 1), bodies(2, 1), body_1, errors(1), stat)
      if (stat == status_ok) call new_conducting_body(u2, v2, heat, semi, dx, dy, bodies(1, 2), bodies(2, 2), body_2, &
        errors(2), stat)
    end associate
    if (stat /= status_ok) return
    contact%oil%temperature = oil(1)
    contact%oil%thermal_exponent = oil(2)
    contact%oil%expansivity = oil(3)
    contact%oil%expansivity_decay = oil(4)
    call heat_contact(contact, oil_heat_law(oil(5), oil(6), oil(7), oil(8), oil(9), oil(10), oil(11), oil(12), oil(13)), &
      u1, v1, body_1, body_2, bodies(3, :), stat)
  end subroutine point_film_heat

  !> One sweep of heat through a contact (`film_temperature`); `change` is the largest of its temperature [K].
  subroutine point_film_warm(handle, change, stat)
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact, heat_sweep
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(out) :: change
    integer(c_int), intent(out) :: stat
    type(heated_contact), pointer :: contact
    !f2py threadsafe

    contact => contact_of(handle)
    call heat_sweep(contact, change, stat)
  end subroutine point_film_warm

  !> Faces and columns whose shear stress was not found when they were last met.
  subroutine point_film_unsolved(handle, count)
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: count
    type(heated_contact), pointer :: contact

    contact => contact_of(handle)
    count = 0
    if (allocated(contact%shear)) count = sum(contact%shear%strips%unsolved)
    if (allocated(contact%heat)) count = count + sum(contact%heat%threads%shear%unsolved)
  end subroutine point_film_unsolved

  !> Temperature of a contact above its inlet's [K], at the levels from body 1 to body 2.
  subroutine point_film_rise(handle, nx, ny, levels, rise)
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny, levels
    real(c_double), intent(out) :: rise(nx, ny, levels)
    type(heated_contact), pointer :: contact

    contact => contact_of(handle)
    rise = contact%shear%nodes%rise
  end subroutine point_film_rise

  !> Takes up a temperature above the inlet's [K].
  subroutine point_film_set_rise(handle, rise, nx, ny, levels)
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact, set_temperature
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny, levels
    real(c_double), intent(in) :: rise(nx, ny, levels)
    type(heated_contact), pointer :: contact

    contact => contact_of(handle)
    call set_temperature(contact, rise)
  end subroutine point_film_set_rise

  !> Fields of a contact's shear; see `nodal_shear`.
  subroutine point_film_shear_fields(handle, factors_wanted, nx, ny, stress_x, stress_y, friction, rate, along, across, slip, stat)
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact
    use nodal_shear, only: shear_field, shear_fields
    use status, only: status_ok
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: factors_wanted, nx, ny
    real(c_double), intent(out) :: stress_x(nx, ny), stress_y(nx, ny), friction(nx, ny), rate(nx, ny), along(nx, ny), &
      across(nx, ny)
    integer(c_int), intent(out) :: slip(nx, ny), stat
    type(heated_contact), pointer :: contact
    type(shear_field) :: field
    !f2py threadsafe

    contact => contact_of(handle)
    call shear_fields(contact%point_contact, factors_wanted /= 0, field, stat)
    if (stat /= status_ok) return
    stress_x = field%stress_x
    stress_y = field%stress_y
    friction = field%friction
    rate = field%rate
    along = field%along
    across = field%across
    slip = field%slip
  end subroutine point_film_shear_fields

  !> Stress at the middle of the film [Pa], heat of shearing [W/m2], the largest shear rate across the film [1/s], heat
  !> flux into the bodies and what oil carries away, less what compression gives it [W/m2]: as of the last sweep of heat.
  subroutine point_film_heat_fields(handle, nx, ny, stress_x, stress_y, friction, rate, flux, carried)
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact
    use march_layout, only: from_march
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(out) :: stress_x(nx, ny), stress_y(nx, ny), friction(nx, ny), rate(nx, ny), &
      flux(nx, ny, 2), carried(nx, ny)
    type(heated_contact), pointer :: contact

    contact => contact_of(handle)
    associate (heat => contact%heat)
      call from_march(heat%way, heat%stress_x, stress_x)
      call from_march(heat%way, heat%stress_y, stress_y)
      call from_march(heat%way, heat%friction, friction)
      call from_march(heat%way, heat%rate, rate)
      call from_march(heat%way, heat%carried, carried)
      flux = heat%walls%flux
    end associate
  end subroutine point_film_heat_fields

  !> Velocity [m/s] across the film at node (i, j), counted from 1, body 1 moving with (u1, v1).
  subroutine point_film_profile(handle, i, j, u1, v1, levels, u, v, stat)
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact
    use nodal_shear, only: film_profile
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: i, j, levels
    real(c_double), intent(in) :: u1, v1
    real(c_double), intent(out) :: u(levels), v(levels)
    integer(c_int), intent(out) :: stat
    type(heated_contact), pointer :: contact

    contact => contact_of(handle)
    call film_profile(contact%point_contact, i, j, u1, v1, u, v, stat)
  end subroutine point_film_profile

  !> Film [m] alone, as last evaluated.
  subroutine point_film_thickness(handle, nx, ny, film)
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(out) :: film(nx, ny)
    type(heated_contact), pointer :: contact

    contact => contact_of(handle)
    film = contact%fields%h
  end subroutine point_film_thickness

  !> How often each part of the work on a contact was done and the processor time [s] that it took:
  !> convolutions, fields and flows, building the preconditioner, its cycles, heat, and all of it with whole
  !> steps and evaluations.
  subroutine point_film_work(handle, counts, seconds)
    use contact_handle, only: contact_of
    use film_temperature, only: heated_contact
    use tally, only: work_tally
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: counts(6)
    real(c_double), intent(out) :: seconds(6)
    type(heated_contact), pointer :: contact
    type(work_tally) :: heat

    contact => contact_of(handle)
    if (allocated(contact%heat)) heat = contact%heat%work
    associate (work => contact%work)
      counts = [work%convolution%count, work%flow%count, work%building%count, work%cycle%count, heat%count, &
        work%whole%count]
      seconds = [work%convolution%seconds, work%flow%seconds, work%building%seconds, work%cycle%seconds, &
        heat%seconds, work%whole%seconds]
    end associate
  end subroutine point_film_work

  !> Makes a line contact; see `line_film` for the arguments and `oil_laws` for the oil's.
  subroutine line_film_new(gap, covered, u, n, dx, reduced_modulus, law, eta0, exponent, pole_pressure, &
      d1, d2, load, floor, handle, stat)
    use oil_laws, only: oil_law
    use line_film, only: new_line_contact
    use line_handle, only: handle_of
    use line_temperature, only: heated_line
    use status, only: status_ok, status_no_memory
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: gap(n), u(n)
    integer(c_int), intent(in) :: covered(n)
    real(c_double), intent(in) :: dx, reduced_modulus
    integer(c_int), intent(in) :: law
    real(c_double), intent(in) :: eta0, exponent, pole_pressure, d1, d2, load, floor
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: stat
    type(heated_line), pointer :: contact
    integer :: err
    !f2py threadsafe

    handle = 0
    stat = status_no_memory
    allocate (contact, stat=err)
    if (err /= 0) return
    call new_line_contact(contact%line_contact, gap, covered /= 0, u, dx, reduced_modulus, &
      oil_law(law, eta0, exponent, pole_pressure, d1, d2), load, floor, stat)
    if (stat == status_ok) then
      handle = handle_of(contact)
    else
      deallocate (contact)
    end if
  end subroutine line_film_new

  !> Gives back the memory of a line contact.
  subroutine line_film_free(handle)
    use line_handle, only: contact_of
    use line_temperature, only: heated_line
    integer(c_int64_t), intent(in) :: handle
    type(heated_line), pointer :: contact

    contact => contact_of(handle)
    deallocate (contact)
  end subroutine line_film_free

  !> Residual and load error of a line contact at pressure p [Pa] and rigid film h0 [m].
  subroutine line_film_evaluate(handle, p, n, h0, residual, load_error)
    use line_film, only: line_residual
    use line_handle, only: contact_of
    use line_temperature, only: heated_line
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: p(n)
    real(c_double), intent(in) :: h0
    real(c_double), intent(out) :: residual, load_error
    type(heated_line), pointer :: contact
    !f2py threadsafe

    contact => contact_of(handle)
    call line_residual(contact%line_contact, p, h0, residual, load_error)
  end subroutine line_film_evaluate

  !> One Newton step of a line contact from the state last evaluated, and where heat is simulated one sweep of it; p and
  !> h0 are replaced; `change` and `largest_rise` as in `point_film_step`.
  subroutine line_film_step(handle, forcing, p, n, h0, last_residual, last_load_error, new_h0, residual, &
      load_error, krylov, step, change, largest_rise, stat)
    use line_film, only: line_step
    use line_handle, only: contact_of
    use line_temperature, only: heated_line, heated_line_step
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: forcing
    real(c_double), intent(inout) :: p(n)
    real(c_double), intent(in) :: h0, last_residual, last_load_error
    real(c_double), intent(out) :: new_h0, residual, load_error, step, change, largest_rise
    integer(c_int), intent(out) :: krylov, stat
    type(heated_line), pointer :: contact
    !f2py threadsafe

    contact => contact_of(handle)
    new_h0 = h0
    residual = last_residual
    load_error = last_load_error
    change = 0
    largest_rise = 0
    if (allocated(contact%heat)) then
      call heated_line_step(contact, forcing, p, new_h0, residual, load_error, krylov, step, change, stat)
      largest_rise = maxval(contact%shear%nodes%rise)
    else
      call line_step(contact%line_contact, forcing, p, new_h0, residual, load_error, krylov, step, stat)
    end if
  end subroutine line_film_step

  !> Film [m], relative density and net outflow per length [m/s] of a line contact as last evaluated.
  subroutine line_film_fields(handle, n, film, density, imbalance)
    use line_handle, only: contact_of
    use line_temperature, only: heated_line
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n
    real(c_double), intent(out) :: film(n), density(n), imbalance(n)
    type(heated_line), pointer :: contact

    contact => contact_of(handle)
    film = contact%fields%h(:, 1)
    density = contact%fields%rho(:, 1)
    imbalance = contact%imbalance
  end subroutine line_film_fields

  !> Deflection w [m] under pressure p [Pa] on a line contact's own grid: the unit of cost.
  subroutine line_film_convolve(handle, p, n, w)
    use line_handle, only: contact_of
    use line_temperature, only: heated_line
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: p(n)
    real(c_double), intent(out) :: w(n)
    type(heated_line), pointer :: contact
    !f2py threadsafe

    contact => contact_of(handle)
    call contact%plane%deflection(p, w)
  end subroutine line_film_convolve

  !> Lets the oil that a line contact's film stores change by `renewal` [1/s] times rho h, and by `squeeze` [m/s].
  subroutine line_film_store(handle, renewal, squeeze, n, stat)
    use line_film, only: store_line
    use line_handle, only: contact_of
    use line_temperature, only: heated_line
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: renewal, squeeze(n)
    integer(c_int), intent(out) :: stat
    type(heated_line), pointer :: contact

    contact => contact_of(handle)
    call store_line(contact%line_contact, renewal, squeeze, stat)
  end subroutine line_film_store

  !> Gives a line contact's oil a flow law; see `flow_laws` and `line_film` for the arguments.
  subroutine line_film_shear(handle, sliding, n, law, reference, reference_growth, reference_decay, limit, limit_growth, &
      exponent, levels, stat)
    use flow_laws, only: flow_law
    use line_film, only: shear_line_contact
    use line_handle, only: contact_of
    use line_temperature, only: heated_line
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: sliding(n)
    integer(c_int), intent(in) :: law
    real(c_double), intent(in) :: reference, reference_growth, reference_decay, limit, limit_growth, exponent
    integer(c_int), intent(in) :: levels
    integer(c_int), intent(out) :: stat
    type(heated_line), pointer :: contact
    !f2py threadsafe

    contact => contact_of(handle)
    call shear_line_contact(contact%line_contact, flow_law(law, reference, reference_growth, reference_decay, limit, &
      limit_growth, exponent), levels, sliding, stat)
  end subroutine line_film_shear

  !> Heat of a line contact whose oil has a flow law; see `line_temperature` for the arguments.
  !>
  !> `oil` and `bodies` as in `point_film_heat`; `velocities` [m/s] are those of both surfaces, neither of them zero.
  subroutine line_film_heat(handle, u1, n, oil, bodies, velocities, stat)
    use heated_surface, only: heated_body
    use line_handle, only: contact_of
    use line_source, only: line_body, new_line_body
    use line_temperature, only: heated_line, heat_line
    use oil_heat, only: oil_heat_law
    use status, only: status_ok
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: u1(n)
    real(c_double), intent(in) :: oil(13), bodies(3, 2), velocities(2)
    integer(c_int), intent(out) :: stat
    type(heated_line), pointer :: contact
    class(heated_body), allocatable :: body_1, body_2
    !f2py threadsafe

    contact => contact_of(handle)
    call new_body(1, body_1)
    if (stat == status_ok) call new_body(2, body_2)
    if (stat /= status_ok) return
    contact%oil%temperature = oil(1)
    contact%oil%thermal_exponent = oil(2)
    contact%oil%expansivity = oil(3)
    contact%oil%expansivity_decay = oil(4)
    call heat_line(contact, oil_heat_law(oil(5), oil(6), oil(7), oil(8), oil(9), oil(10), oil(11), oil(12), oil(13)), &
      u1, body_1, body_2, bodies(3, :), stat)

  contains

    !> A body on the contact's grid.
    subroutine new_body(body, surface)
      integer, intent(in) :: body
      class(heated_body), allocatable, intent(out) :: surface
      type(line_body), allocatable :: moving

      allocate (moving)
      call new_line_body(moving, n, contact%grid%dx, velocities(body), bodies(1, body), bodies(2, body), stat)
      call move_alloc(moving, surface)
    end subroutine new_body

  end subroutine line_film_heat

  !> Faces and columns of a line contact whose shear stress was not found when they were last met.
  subroutine line_film_unsolved(handle, count)
    use line_handle, only: contact_of
    use line_temperature, only: heated_line
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: count
    type(heated_line), pointer :: contact

    contact => contact_of(handle)
    count = 0
    if (allocated(contact%shear)) count = sum(contact%shear%strips%unsolved)
    if (allocated(contact%heat)) count = count + sum(contact%heat%shear%unsolved)
  end subroutine line_film_unsolved

  !> Temperature of a line contact above its inlet's [K], at the levels from body 1 to body 2.
  subroutine line_film_rise(handle, n, levels, rise)
    use line_handle, only: contact_of
    use line_temperature, only: heated_line
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n, levels
    real(c_double), intent(out) :: rise(n, levels)
    type(heated_line), pointer :: contact

    contact => contact_of(handle)
    rise = contact%shear%nodes%rise(:, 1, :)
  end subroutine line_film_rise

  !> Takes up a temperature above the inlet's [K].
  subroutine line_film_set_rise(handle, rise, n, levels)
    use line_handle, only: contact_of
    use line_temperature, only: heated_line, set_line_temperature
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n, levels
    real(c_double), intent(in) :: rise(n, levels)
    type(heated_line), pointer :: contact

    contact => contact_of(handle)
    call set_line_temperature(contact, rise)
  end subroutine line_film_set_rise

  !> Fields of a line contact's shear; see `line_nodal_shear`.
  subroutine line_film_shear_fields(handle, n, stress, friction, rate, factor, slip, stat)
    use line_handle, only: contact_of
    use line_nodal_shear, only: line_shear_field, line_shear_fields
    use line_temperature, only: heated_line
    use status, only: status_ok
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n
    real(c_double), intent(out) :: stress(n), friction(n), rate(n), factor(n)
    integer(c_int), intent(out) :: slip(n), stat
    type(heated_line), pointer :: contact
    type(line_shear_field) :: field
    !f2py threadsafe

    contact => contact_of(handle)
    call line_shear_fields(contact, field, stat)
    if (stat /= status_ok) return
    stress = field%stress
    friction = field%friction
    rate = field%rate
    factor = field%factor
    slip = field%slip
  end subroutine line_film_shear_fields

  !> Heat flux into the bodies and what oil carries away, less what compression gives it [W/m2].
  subroutine line_film_heat_fields(handle, n, flux, carried)
    use line_handle, only: contact_of
    use line_temperature, only: heated_line
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n
    real(c_double), intent(out) :: flux(n, 2), carried(n)
    type(heated_line), pointer :: contact

    contact => contact_of(handle)
    flux = contact%heat%walls%flux(:, 1, :)
    carried = contact%heat%carried
  end subroutine line_film_heat_fields

  !> Velocity [m/s] across the film of a line contact at node i, counted from 1, body 1 moving with u1.
  subroutine line_film_profile(handle, i, u1, levels, u, stat)
    use line_handle, only: contact_of
    use line_nodal_shear, only: profile => line_film_profile
    use line_temperature, only: heated_line
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: i, levels
    real(c_double), intent(in) :: u1
    real(c_double), intent(out) :: u(levels)
    integer(c_int), intent(out) :: stat
    type(heated_line), pointer :: contact

    contact => contact_of(handle)
    call profile(contact, i, u1, u, stat)
  end subroutine line_film_profile

  !> Where `count` levels across a film are, from -1/2 at body 1 to 1/2 at body 2.
  subroutine level_positions(count, z)
    use film_levels, only: levels_across, new_levels
    integer(c_int), intent(in) :: count
    real(c_double), intent(out) :: z(count)
    type(levels_across) :: levels

    levels = new_levels(count)
    z = levels%z
  end subroutine level_positions

  !> Field on a grid of half the spacing.
  subroutine prolong_cubic(coarse, nx, ny, fine)
    use grid_transfer, only: interpolate_cubic
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: coarse(nx, ny)
    real(c_double), intent(out) :: fine(2*nx - 1, 2*ny - 1)
    !f2py threadsafe

    call interpolate_cubic(coarse, fine)
  end subroutine prolong_cubic

  !> The compiler and its options, of all of the kernel alike; blanks fill up what they leave.
  subroutine compiled_with(compiler, options)
    use iso_fortran_env, only: compiler_options, compiler_version
    character(len=200), intent(out) :: compiler
    character(len=2000), intent(out) :: options

    compiler = compiler_version()
    options = compiler_options()
  end subroutine compiled_with

end module bindings
