!> A lubricated point contact for Fortran programs: set up, solve to a tolerance, read the film.
!>
!> Arguments in SI; fields have the shape (nx, ny), and the pressure is ambient on their outline, so that the grid has to
!> reach into the inlet. A solve climbs grids up to the one given and tells from the climb how far off its film may be, and
!> from a narrower window how much is missing beyond the outline. The kernel never stops and never prints: each procedure
!> gives a status, `pyworm_ok` or one of the numbers below.
module pyworm_contact
  use pyworm_conducting_body, only: new_conducting_body
  use pyworm_cubic_refinement, only: interpolate_cubic
  use pyworm_dry_contact, only: solve_dry_contact
  use pyworm_film_newton, only: contact_conditions, newton_step, film_residual, film_step, shear_contact
  use pyworm_flow_laws, only: flow_law
  use pyworm_grid_error, only: grid_error
  use pyworm_half_space, only: elastic_half_space, new_half_space
  use pyworm_heated_surface, only: heated_body
  use pyworm_interruption, only: interrupt_by, interruption_query
  use pyworm_kinds, only: pyworm_real => wp
  use pyworm_point_film, only: new_point_contact, point_contact
  use pyworm_point_heat, only: heat_point_contact
  use pyworm_shear_fields, only: nodal_shear, shear_field
  use pyworm_status, only: pyworm_ok => status_ok, pyworm_bad_argument => status_bad_argument, &
    pyworm_not_finite => status_not_finite, pyworm_no_plan => status_no_plan, &
    pyworm_not_converged => status_not_converged, pyworm_no_descent => status_no_descent, &
    pyworm_no_memory => status_no_memory, pyworm_interrupted => status_interrupted
  use pyworm_thermal_properties, only: oil_heat_law
  use pyworm_thermal_step, only: heated_step, thermal_contact
  use pyworm_viscosity_density, only: oil_law
  implicit none(type, external)
  private

  public :: pyworm_real, pyworm_conditions, pyworm_oil, pyworm_flow, pyworm_body, pyworm_point, pyworm_found
  public :: pyworm_solve_dry, pyworm_setup, pyworm_solve, pyworm_read, pyworm_shear
  public :: pyworm_interrupt_by, interruption_query
  public :: pyworm_ok, pyworm_bad_argument, pyworm_not_finite, pyworm_no_plan, pyworm_not_converged, &
    pyworm_no_descent, pyworm_no_memory, pyworm_interrupted

  integer, parameter :: wp = pyworm_real

  !> Laws of viscosity, and laws of flow.
  integer, parameter, public :: pyworm_barus = 1, pyworm_roelands = 2
  integer, parameter, public :: pyworm_newton = 0, pyworm_eyring = 1, pyworm_bair_winer = 2, pyworm_eyring_limited = 3, &
    pyworm_carreau = 4

  !> Status of a film that was found and is less accurate than asked for.
  integer, parameter, public :: pyworm_inaccurate = 8

  !> Most steps on a grid, and most of a film whose balance is within `near` times the tolerance: local slip and heat slow
  !> the last steps.
  integer, parameter :: most_steps = 30, most_slow_steps = 60
  real(wp), parameter :: near = 6
  !> Relative accuracy of the linear systems.
  real(wp), parameter :: forcing = 0.1_wp
  !> Growth of the residual from which Newton's iteration does not recover.
  real(wp), parameter :: hopeless = 100
  !> Fewest nodes a side of a coarser grid, and of the grid that is cut to a narrower window.
  integer, parameter :: fewest_nodes = 33, fewest_cut = 49
  !> Sides of the narrower window over those of the window: half the gap of a paraboloid.
  real(wp), parameter :: narrower = sqrt(0.5_wp)
  !> Error of a window over what its films differ by from those of half its reach (in gap). It falls with the power -3/2 of
  !> the reach, and is up to 2.1 times the change to twice the reach (`pyworm/solver/point/contact.py`).
  real(wp), parameter :: window_share = 2.1_wp/2**1.5_wp
  !> Film below which the mobility is constant, and pressure with which a film starts outside its dry contact, over
  !> the expected film and the largest dry pressure.
  real(wp), parameter :: floor_fraction = 1e-3_wp, trace = 1e-6_wp
  !> Last change of temperature over the largest rise at which heat is settled, and the least rise that counts [K].
  real(wp), parameter :: settled = 1e-3_wp, least_rise = 10.0_wp
  real(wp), parameter :: pi = acos(-1.0_wp)

  !> Operating conditions: load [N], E' [Pa] with 2/E' = (1-nu1^2)/E1 + (1-nu2^2)/E2, and velocities (u, v) of the surfaces
  !> along x and y [m/s].
  type :: pyworm_conditions
    real(wp) :: load = 0, reduced_modulus = 0, velocity_1(2) = 0, velocity_2(2) = 0
  end type pyworm_conditions

  !> An oil: viscosity and density against pressure and, where heat is simulated, its thermal constants.
  type :: pyworm_oil
    integer :: law = pyworm_barus
    !> Viscosity at ambient pressure [Pa s]; alpha [1/Pa] of Barus or z [-] of Roelands; his pole pressure [Pa].
    real(wp) :: viscosity = 0, exponent = 0, pole_pressure = 1.96e8_wp
    !> Coefficients [1/Pa] of the density 1 + d1 p/(1 + d2 p).
    real(wp) :: d1 = 0, d2 = 0
    !> Inlet temperature [K], decay of viscosity with temperature (beta [1/K] of Barus, s0 [-] of Roelands),
    !> expansivity [1/K].
    real(wp) :: temperature = 313.15_wp, thermal_exponent = 0, expansivity = 0
    !> Conductivity [W/(m K)] and volumetric heat capacity [J/(m3 K)].
    real(wp) :: conductivity = 0, heat_capacity = 0
  end type pyworm_oil

  !> How an oil shears: see `flow_laws`.
  type :: pyworm_flow
    integer :: law = pyworm_newton
    !> Eyring's or Carreau's stress [Pa], limiting stress [Pa] and its rise with pressure [-], exponent [-].
    real(wp) :: stress = 1, limit = 0, limit_pressure = 0, exponent = 1
    !> Levels across the film.
    integer :: levels = 7
  end type pyworm_flow

  !> A solid's surface: conductivity [W/(m K)], volumetric heat capacity [J/(m3 K)], bulk temperature above the
  !> inlet's [K].
  type :: pyworm_body
    real(wp) :: conductivity = 0, heat_capacity = 0, bulk_rise = 0
  end type pyworm_body

  !> What a solve found, and how far off it may be.
  type :: pyworm_found
    !> Minimum film and film at the least gap [m], maximum pressure [Pa], at nodes of the grid that was solved.
    real(wp) :: film_min = 0, film_central = 0, pressure_max = 0
    !> Relative errors of these by the grids' changes; `huge` where one grid alone was solved.
    real(wp) :: film_min_error = huge(1.0_wp), film_central_error = huge(1.0_wp), pressure_max_error = huge(1.0_wp)
    !> Relative error of both films by the window, which ends too near by it; `huge` where that is not known.
    real(wp) :: window_error = huge(1.0_wp)
    !> Residual, missing load over the load, and Newton steps on the grid of the film.
    real(wp) :: residual = huge(1.0_wp), load_error = 1
    integer :: steps = 0
    !> Spacing of the grid of the film over that of the grid given: 1, or a power of two where no film was found on it.
    integer :: coarsening = 1
  end type pyworm_found

  !> A contact: what was set up, and the film of the last solve.
  type :: pyworm_point
    private
    type(pyworm_oil) :: oil
    type(pyworm_flow) :: flow
    type(pyworm_body) :: bodies(2)
    logical :: sheared = .false., heated = .false.
    real(wp) :: dx = 0, dy = 0, reduced_modulus = 0, load = 0, h0 = 0, expected_film = 0
    real(wp), allocatable :: gap(:, :), p(:, :)
    !> Spacing of the grid of `p` and `film` over that of `gap`.
    integer :: step = 1
    !> Velocities (u, v) [m/s] of body 1 and body 2: (nx, ny, component, body).
    real(wp), allocatable :: velocity(:, :, :, :)
    type(thermal_contact) :: film
  end type pyworm_point

contains

  !> Sets what is asked, once an iteration, whether a call is to end; null for nothing.
  subroutine pyworm_interrupt_by(asked)
    procedure(interruption_query), pointer, intent(in) :: asked

    call interrupt_by(asked)
  end subroutine pyworm_interrupt_by

  !> Pressure `p` [Pa] and rigid approach [m] of a dry contact of a gap [m] under a load [N].
  subroutine pyworm_solve_dry(gap, dx, dy, reduced_modulus, load, tolerance, p, approach, stat)
    real(wp), intent(in) :: gap(:, :), dx, dy, reduced_modulus, load, tolerance
    real(wp), intent(out) :: p(:, :), approach
    integer, intent(out) :: stat
    type(elastic_half_space) :: space
    logical, allocatable :: covered(:, :)
    integer :: iterations

    approach = 0
    p = 1
    stat = pyworm_bad_argument
    if (any(shape(p) /= shape(gap))) return
    allocate (covered(size(gap, 1), size(gap, 2)), source=.true.)
    call new_half_space(space, size(gap, 1), size(gap, 2), dx, dy, reduced_modulus, stat)
    if (stat == pyworm_ok) call solve_dry_contact(space, gap, covered, load, tolerance, 2000, p, approach, iterations, stat)
  end subroutine pyworm_solve_dry

  !> Sets up a contact: gap [m] on nodes dx and dy [m] apart. With a `flow` the film is sheared by it, and with `bodies` too
  !> heat is simulated.
  subroutine pyworm_setup(contact, gap, dx, dy, conditions, oil, stat, flow, bodies)
    type(pyworm_point), intent(out) :: contact
    real(wp), intent(in) :: gap(:, :), dx, dy
    type(pyworm_conditions), intent(in) :: conditions
    type(pyworm_oil), intent(in) :: oil
    integer, intent(out) :: stat
    type(pyworm_flow), intent(in), optional :: flow
    type(pyworm_body), intent(in), optional :: bodies(2)
    integer :: err

    stat = pyworm_bad_argument
    if (minval(shape(gap)) < fewest_nodes) return
    if (.not. min(dx, dy, conditions%reduced_modulus, conditions%load, oil%viscosity) > 0) return
    if (present(bodies) .and. .not. present(flow)) return
    contact%gap = gap
    contact%dx = dx
    contact%dy = dy
    contact%reduced_modulus = conditions%reduced_modulus
    contact%load = conditions%load
    contact%oil = oil
    contact%sheared = present(flow)
    contact%heated = present(bodies)
    if (present(flow)) contact%flow = flow
    if (present(bodies)) contact%bodies = bodies
    allocate (contact%velocity(size(gap, 1), size(gap, 2), 2, 2), stat=err)
    stat = pyworm_no_memory
    if (err /= 0) return
    contact%velocity(:, :, 1, 1) = conditions%velocity_1(1)
    contact%velocity(:, :, 2, 1) = conditions%velocity_1(2)
    contact%velocity(:, :, 1, 2) = conditions%velocity_2(1)
    contact%velocity(:, :, 2, 2) = conditions%velocity_2(2)
    stat = pyworm_ok
  end subroutine pyworm_setup

  !> Solves the film until residual and load error are within `tolerance`, on coarser grids first.
  !>
  !> `pyworm_ok` if a film was found whose errors by grid and window are together within `accuracy` (relative), else
  !> `pyworm_inaccurate`. Where no film is found on the given grid, which may not bear a pressure spike that grows from grid
  !> to grid, it is that of the finest grid on which there is one. Without any the film is that of the last step.
  subroutine pyworm_solve(contact, tolerance, accuracy, found, stat)
    type(pyworm_point), intent(inout) :: contact
    real(wp), intent(in) :: tolerance, accuracy
    type(pyworm_found), intent(out) :: found
    integer, intent(out) :: stat
    real(wp), allocatable :: p(:, :)
    real(wp) :: h0
    integer :: coarsest, step, steps

    stat = pyworm_bad_argument
    if (.not. (allocated(contact%gap) .and. tolerance > 0 .and. accuracy > 0)) return
    coarsest = 2**halvings(shape(contact%gap))
    call climb(contact, coarsest, tolerance, found, p, h0, step, stat)
    if (.not. allocated(p)) return
    if (stat /= pyworm_ok .and. .not. spoils_a_grid(stat)) return
    if (step /= contact%step .or. stat /= pyworm_ok) then
      call make_film(contact, step, stat)
      contact%p = p
      contact%h0 = h0
      if (stat == pyworm_ok) call settle_all(contact, tolerance, found%residual, found%load_error, steps, stat)
      if (stat /= pyworm_ok) return
    end if
    call compare_windows(contact, coarsest, tolerance, found)
    if (.not. max(found%film_min_error, found%film_central_error) + found%window_error <= accuracy) stat = pyworm_inaccurate
  end subroutine pyworm_solve

  !> Solves grids from the coarsest to the given one; `p` and `h0` are the Newtonian film at `step` of the finest grid on
  !> which all was found, `p` not allocated without any, and `stat` is that of the given grid.
  subroutine climb(contact, coarsest, tolerance, found, p, h0, step, stat)
    type(pyworm_point), intent(inout) :: contact
    integer, intent(in) :: coarsest
    real(wp), intent(in) :: tolerance
    type(pyworm_found), intent(out) :: found
    real(wp), allocatable, intent(out) :: p(:, :)
    real(wp), intent(out) :: h0
    integer, intent(out) :: step, stat
    real(wp), allocatable :: readings(:, :), newtonian(:, :)
    real(wp) :: rigid, residual, load_error
    integer :: here, centre(2), steps
    logical :: lost

    h0 = 0
    step = coarsest
    here = coarsest
    centre = minloc(contact%gap(::coarsest, ::coarsest))
    allocate (readings(3, 0))
    lost = .true.
    do
      if (lost) then
        call start_dry(contact, here, stat)
      else
        call refine(newtonian, contact%p)
        contact%h0 = rigid
      end if
      if (stat == pyworm_ok) call make_film(contact, here, stat)
      if (stat /= pyworm_ok) return
      call settle(contact, tolerance, residual, load_error, steps, stat)
      lost = stat /= pyworm_ok
      newtonian = contact%p
      rigid = contact%h0
      if (stat == pyworm_ok .and. contact%sheared) call settle_sheared(contact, tolerance, residual, load_error, steps, stat)
      if (.not. (stat == pyworm_ok .or. spoils_a_grid(stat))) return
      if (stat == pyworm_ok) then
        readings = reshape([readings, reading(contact, 1 + (centre - 1)*(coarsest/here))], [3, size(readings, 2) + 1])
        found = found_by(readings, residual, load_error, steps, here)
        p = newtonian
        h0 = rigid
        step = here
      else if (here > 1) then
        deallocate (readings) ! errors are read from grids that follow each other
        allocate (readings(3, 0))
      end if
      if (here == 1) return
      here = here/2
      stat = pyworm_ok
    end do
  end subroutine climb

  !> Whether a status says that this grid has no film, and others may.
  pure logical function spoils_a_grid(stat)
    integer, intent(in) :: stat

    spoils_a_grid = any(stat == [pyworm_not_converged, pyworm_no_descent, pyworm_not_finite])
  end function spoils_a_grid

  !> Minimum film, film at a node, and maximum pressure of the present film.
  pure function reading(contact, node)
    type(pyworm_point), intent(in) :: contact
    integer, intent(in) :: node(2)
    real(wp) :: reading(3)

    associate (h => contact%film%film%model%fields%h)
      reading = [minval(h), h(node(1), node(2)), maxval(contact%p)]
    end associate
  end function reading

  !> The figures of a climb so far, with their errors by the grids.
  pure type(pyworm_found) function found_by(readings, residual, load_error, steps, coarsening)
    real(wp), intent(in) :: readings(:, :), residual, load_error
    integer, intent(in) :: steps, coarsening
    integer :: n

    n = size(readings, 2)
    found_by = pyworm_found(film_min=readings(1, n), film_central=readings(2, n), pressure_max=readings(3, n), &
      film_min_error=grid_error(readings(1, :)), film_central_error=grid_error(readings(2, :)), &
      pressure_max_error=grid_error(readings(3, :)), residual=residual, load_error=load_error, steps=steps, &
      coarsening=coarsening)
  end function found_by

  !> Sets the error by the window, from isothermal Newtonian films in this one and in one of half its reach, on a coarse grid;
  !> it stays unknown where one of them is not found.
  subroutine compare_windows(contact, coarsest, tolerance, found)
    type(pyworm_point), intent(in) :: contact
    integer, intent(in) :: coarsest
    real(wp), intent(in) :: tolerance
    type(pyworm_found), intent(inout) :: found
    real(wp) :: films(2, 2)
    integer :: step, nodes(2), centre(2), low(2), high(2), stat

    step = coarsest
    do while (step > 1 .and. minval((shape(contact%gap) - 1)/step + 1) < fewest_cut)
      step = step/2
    end do
    associate (gap => contact%gap(::step, ::step))
      nodes = shape(gap)
      centre = minloc(gap)
      low = centre - int(narrower*(centre - 1))
      high = centre + int(narrower*(nodes - centre))
      call films_in(contact, gap, step, tolerance, centre, films(:, 1), stat)
      if (stat /= pyworm_ok) return
      call films_in(contact, gap(low(1):high(1), low(2):high(2)), step, tolerance, centre - low + 1, films(:, 2), stat)
      if (stat /= pyworm_ok) return
    end associate
    found%window_error = window_share*maxval(abs(films(:, 2) - films(:, 1))/films(:, 1))
  end subroutine compare_windows

  !> Minimum film and film at a node of a contact of its own gap, isothermal and Newtonian.
  subroutine films_in(contact, gap, step, tolerance, node, films, stat)
    type(pyworm_point), intent(in) :: contact
    real(wp), intent(in) :: gap(:, :), tolerance
    integer, intent(in) :: step, node(2)
    real(wp), intent(out) :: films(2)
    integer, intent(out) :: stat
    type(pyworm_point) :: part
    real(wp) :: residual, load_error, figures(3)
    integer :: steps

    films = 0
    part%gap = gap
    part%dx = step*contact%dx
    part%dy = step*contact%dy
    part%reduced_modulus = contact%reduced_modulus
    part%load = contact%load
    part%oil = contact%oil
    part%velocity = contact%velocity(:size(gap, 1), :size(gap, 2), :, :) ! the same everywhere
    call start_dry(part, 1, stat)
    if (stat == pyworm_ok) call make_film(part, 1, stat)
    if (stat == pyworm_ok) call settle(part, tolerance, residual, load_error, steps, stat)
    if (stat /= pyworm_ok) return
    figures = reading(part, node)
    films = figures(:2)
  end subroutine films_in

  !> Pressure [Pa], film [m] and, of a heated film, the temperature in its middle above the inlet's [K], on the given grid;
  !> interpolated where the film is that of a coarser one.
  subroutine pyworm_read(contact, p, h, rise)
    type(pyworm_point), intent(in) :: contact
    real(wp), intent(out) :: p(:, :), h(:, :)
    real(wp), intent(out), optional :: rise(:, :)

    call on_given_grid(contact%p, p)
    p = max(p, 0.0_wp)
    call on_given_grid(contact%film%film%model%fields%h, h)
    if (.not. present(rise)) return
    rise = 0
    if (contact%sheared) call on_given_grid(contact%film%film%model%shear%nodes%rise(:, :, (contact%flow%levels + 1)/2), rise)
  end subroutine pyworm_read

  !> Shear stress in the middle of the film [Pa] and heat of shearing [W/m2] of a contact with a flow law.
  subroutine pyworm_shear(contact, stress_x, stress_y, heat, stat)
    type(pyworm_point), intent(in) :: contact
    real(wp), intent(out) :: stress_x(:, :), stress_y(:, :), heat(:, :)
    integer, intent(out) :: stat
    type(shear_field) :: field

    stat = pyworm_bad_argument
    if (.not. contact%sheared) return
    call nodal_shear(contact%film%film, .false., field, stat)
    if (stat /= pyworm_ok) return
    call on_given_grid(field%stress_x, stress_x)
    call on_given_grid(field%stress_y, stress_y)
    call on_given_grid(field%friction, heat)
  end subroutine pyworm_shear

  !> A field on its own grid or, by cubics, on a finer one over the same window.
  recursive subroutine on_given_grid(field, given)
    real(wp), intent(in) :: field(:, :)
    real(wp), intent(out) :: given(:, :)
    real(wp), allocatable :: finer(:, :)

    if (size(field, 1) == size(given, 1)) then
      given = field
      return
    end if
    allocate (finer(2*size(field, 1) - 1, 2*size(field, 2) - 1))
    call interpolate_cubic(field, finer)
    call on_given_grid(finer, given)
  end subroutine on_given_grid

  !> A pressure on the grid of half the spacing.
  subroutine refine(coarse, fine)
    real(wp), intent(in) :: coarse(:, :)
    real(wp), allocatable, intent(inout) :: fine(:, :)

    if (allocated(fine)) deallocate (fine)
    allocate (fine(2*size(coarse, 1) - 1, 2*size(coarse, 2) - 1))
    call interpolate_cubic(coarse, fine)
    fine = max(fine, 0.0_wp)
  end subroutine refine

  !> How often a grid can be halved, its ends kept.
  pure integer function halvings(nodes)
    integer, intent(in) :: nodes(2)
    integer :: cells(2)

    halvings = 0
    cells = nodes - 1
    do while (all(mod(cells, 2) == 0) .and. minval(cells)/2 + 1 >= fewest_nodes)
      cells = cells/2
      halvings = halvings + 1
    end do
  end function halvings

  !> Starts from the dry contact on every `step`-th node, lifted by the expected film.
  subroutine start_dry(contact, step, stat)
    type(pyworm_point), intent(inout) :: contact
    integer, intent(in) :: step
    integer, intent(out) :: stat
    real(wp), allocatable :: gap(:, :)
    real(wp) :: approach

    gap = contact%gap(::step, ::step)
    if (allocated(contact%p)) deallocate (contact%p)
    allocate (contact%p, mold=gap)
    call pyworm_solve_dry(gap, step*contact%dx, step*contact%dy, contact%reduced_modulus, contact%load, 1e-3_wp, &
      contact%p, approach, stat)
    if (stat == pyworm_not_converged) stat = pyworm_ok
    contact%expected_film = central_film(contact, maxval(contact%p), approach)
    contact%h0 = contact%expected_film - approach
    contact%p = contact%p + trace*maxval(contact%p)
    contact%p([1, size(gap, 1)], :) = 0
    contact%p(:, [1, size(gap, 2)]) = 0
  end subroutine start_dry

  !> Central film [m] by Hamrock and Dowson (1977), of the circular contact with this dry pressure and approach.
  pure real(wp) function central_film(contact, pressure, approach)
    type(pyworm_point), intent(in) :: contact
    real(wp), intent(in) :: pressure, approach
    real(wp) :: radius, speed, alpha

    radius = 3*contact%load/(2*pi*pressure)/max(abs(approach), tiny(1.0_wp))
    associate (velocity => contact%velocity(1, 1, :, :), oil => contact%oil)
      speed = norm2((velocity(:, 1) + velocity(:, 2))/2)
      alpha = oil%exponent
      if (oil%law == pyworm_roelands) alpha = oil%exponent*(log(oil%viscosity) + 9.67_wp)/oil%pole_pressure
      central_film = 1.9_wp*radius*(oil%viscosity*speed/(contact%reduced_modulus*radius))**0.67_wp &
        *max(alpha*contact%reduced_modulus, 100.0_wp)**0.53_wp*(contact%load/(contact%reduced_modulus*radius**2))**(-0.067_wp)
    end associate
  end function central_film

  !> Makes the Newtonian film of one temperature on every `step`-th node.
  subroutine make_film(contact, step, stat)
    type(pyworm_point), intent(inout) :: contact
    integer, intent(in) :: step
    integer, intent(out) :: stat
    type(point_contact), allocatable :: film
    type(contact_conditions) :: conditions
    real(wp), allocatable :: mean(:, :, :)

    mean = sum(contact%velocity(::step, ::step, :, :), dim=4)/2
    conditions%gap = contact%gap(::step, ::step)
    allocate (conditions%covered(size(mean, 1), size(mean, 2)), source=.true.)
    conditions%spacing = step*[contact%dx, contact%dy]
    conditions%reduced_modulus = contact%reduced_modulus
    conditions%load = contact%load
    conditions%floor = floor_fraction*contact%expected_film
    associate (oil => contact%oil)
      conditions%oil = oil_law(oil%law, oil%viscosity, oil%exponent, oil%pole_pressure, oil%d1, oil%d2, oil%temperature, &
        oil%thermal_exponent, oil%expansivity)
    end associate
    allocate (film)
    call new_point_contact(film, conditions, mean(:, :, 1), mean(:, :, 2), stat)
    if (stat /= pyworm_ok) return
    contact%step = step
    if (allocated(contact%film%heat)) deallocate (contact%film%heat)
    if (allocated(contact%film%film)) deallocate (contact%film%film)
    call move_alloc(film, contact%film%film)
  end subroutine make_film

  !> Settles the Newtonian film and then, where there is a flow law, the sheared one.
  subroutine settle_all(contact, tolerance, residual, load_error, steps, stat)
    type(pyworm_point), intent(inout) :: contact
    real(wp), intent(in) :: tolerance
    real(wp), intent(out) :: residual, load_error
    integer, intent(out) :: steps, stat

    call settle(contact, tolerance, residual, load_error, steps, stat)
    if (stat == pyworm_ok .and. contact%sheared) call settle_sheared(contact, tolerance, residual, load_error, steps, stat)
  end subroutine settle_all

  !> Adds the flow law and, where it is simulated, heat to the Newtonian film, and settles it again.
  subroutine settle_sheared(contact, tolerance, residual, load_error, steps, stat)
    type(pyworm_point), intent(inout) :: contact
    real(wp), intent(in) :: tolerance
    real(wp), intent(inout) :: residual, load_error
    integer, intent(inout) :: steps
    integer, intent(out) :: stat

    associate (step => contact%step)
      call add_flow(contact, contact%velocity(::step, ::step, :, :), stat)
    end associate
    if (stat == pyworm_ok) call settle(contact, tolerance, residual, load_error, steps, stat)
  end subroutine settle_sheared

  !> Adds the flow law and, where it is simulated, heat; velocities as of the contact, on the grid of the film.
  subroutine add_flow(contact, velocity, stat)
    type(pyworm_point), intent(inout) :: contact
    real(wp), intent(in) :: velocity(:, :, :, :)
    integer, intent(out) :: stat
    class(heated_body), allocatable :: body_1, body_2

    associate (flow => contact%flow, bodies => contact%bodies, oil => contact%oil)
      call shear_contact(contact%film%film, flow_law(flow%law, flow%stress, 0.0_wp, 0.0_wp, flow%limit, flow%limit_pressure, &
        flow%exponent), flow%levels, velocity(:, :, 1, 2) - velocity(:, :, 1, 1), velocity(:, :, 2, 2) &
        - velocity(:, :, 2, 1), stat)
      if (stat /= pyworm_ok .or. .not. contact%heated) return
      call add_body(1, body_1)
      if (stat == pyworm_ok) call add_body(2, body_2)
      if (stat /= pyworm_ok) return
      call heat_point_contact(contact%film, oil_heat_law(conductivity=oil%conductivity, capacity=oil%heat_capacity), &
        velocity(:, :, 1, 1), velocity(:, :, 2, 1), body_1, body_2, bodies%bulk_rise, stat)
    end associate

  contains

    !> A body under the present pressure.
    subroutine add_body(number, body)
      integer, intent(in) :: number
      class(heated_body), allocatable, intent(out) :: body
      real(wp) :: error, semi(2), pressure(size(contact%p, 1), size(contact%p, 2))

      pressure = contact%p
      semi = sqrt(1.5_wp*contact%load/(pi*maxval(pressure)))
      associate (solid => contact%bodies(number))
        call new_conducting_body(velocity(:, :, 1, number), velocity(:, :, 2, number), pressure, semi, &
          contact%step*[contact%dx, contact%dy], solid%conductivity, solid%heat_capacity, body, error, stat)
      end associate
    end subroutine add_body

  end subroutine add_flow

  !> Makes Newton steps until the present film is within a tolerance and its heat settled.
  subroutine settle(contact, tolerance, residual, load_error, steps, stat)
    type(pyworm_point), intent(inout) :: contact
    real(wp), intent(in) :: tolerance
    real(wp), intent(out) :: residual, load_error
    integer, intent(out) :: steps, stat
    type(newton_step) :: newton
    real(wp) :: warming, first
    logical :: heated

    heated = allocated(contact%film%heat)
    warming = merge(huge(1.0_wp), 0.0_wp, heated)
    call film_residual(contact%film%film, contact%p, contact%h0, residual, load_error)
    first = max(residual, 1.0_wp)
    do steps = 0, most_slow_steps
      stat = pyworm_ok
      if (max(residual, abs(load_error)) <= tolerance .and. warming <= settled) return
      if (steps >= most_steps .and. max(residual, abs(load_error)) > near*tolerance) exit
      if (steps == most_slow_steps .or. residual > hopeless*first) exit
      if (heated) then
        call heated_step(contact%film%film, contact%film%heat, forcing, contact%p, contact%h0, residual, load_error, &
          newton, stat)
        warming = newton%change/max(least_rise, maxval(contact%film%film%model%shear%nodes%rise))
      else
        call film_step(contact%film%film, forcing, contact%p, contact%h0, residual, load_error, newton, stat)
      end if
      ! a sweep of heat follows even where no step helps, and another film may belong to its temperatures
      if (stat /= pyworm_ok .and. .not. (heated .and. stat == pyworm_no_descent)) return
    end do
    stat = pyworm_not_converged
  end subroutine settle

end module pyworm_contact
