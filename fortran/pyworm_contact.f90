!> A lubricated point contact for Fortran programs: set up, solve to a tolerance, read the film.
!>
!> Arguments in SI; fields have the shape (nx, ny), and the pressure is ambient on their outline, so that the grid has to
!> reach into the inlet, some three contact radii upstream. The kernel never stops and never prints: each procedure
!> gives a status, `pyworm_ok` or one of the numbers below.
module pyworm_contact
  use pyworm_conducting_body, only: new_conducting_body
  use pyworm_cubic_refinement, only: interpolate_cubic
  use pyworm_dry_contact, only: solve_dry_contact
  use pyworm_film_newton, only: film_residual, film_step, shear_contact
  use pyworm_flow_laws, only: flow_law
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

  public :: pyworm_real, pyworm_oil, pyworm_flow, pyworm_body, pyworm_point
  public :: pyworm_solve_dry, pyworm_setup, pyworm_solve, pyworm_read, pyworm_shear
  public :: pyworm_interrupt_by, interruption_query
  public :: pyworm_ok, pyworm_bad_argument, pyworm_not_finite, pyworm_no_plan, pyworm_not_converged, &
    pyworm_no_descent, pyworm_no_memory, pyworm_interrupted

  integer, parameter :: wp = pyworm_real

  !> Laws of viscosity, and laws of flow.
  integer, parameter, public :: pyworm_barus = 1, pyworm_roelands = 2
  integer, parameter, public :: pyworm_newton = 0, pyworm_eyring = 1, pyworm_bair_winer = 2, pyworm_eyring_limited = 3, &
    pyworm_carreau = 4

  !> Most steps on a grid, and the relative accuracy of the linear systems.
  integer, parameter :: most_steps = 60
  real(wp), parameter :: forcing = 0.1_wp
  !> Residual at which a coarser grid is left.
  real(wp), parameter :: coarse_tolerance = 0.02_wp
  !> Fewest nodes a side of a coarser grid.
  integer, parameter :: fewest_nodes = 33
  !> Film below which the mobility is constant, and pressure with which a film starts outside its dry contact, over
  !> the expected film and the largest dry pressure.
  real(wp), parameter :: floor_fraction = 1e-3_wp, trace = 1e-6_wp
  !> Last change of temperature over the largest rise at which heat is settled, and the least rise that counts [K].
  real(wp), parameter :: settled = 1e-3_wp, least_rise = 10.0_wp
  real(wp), parameter :: pi = acos(-1.0_wp)

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

  !> A contact: what was set up, and the film of the last solve.
  type :: pyworm_point
    private
    type(pyworm_oil) :: oil
    type(pyworm_flow) :: flow
    type(pyworm_body) :: bodies(2)
    logical :: sheared = .false., heated = .false.
    real(wp) :: dx = 0, dy = 0, reduced_modulus = 0, load = 0, h0 = 0, expected_film = 0
    real(wp), allocatable :: gap(:, :), p(:, :)
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

  !> Sets up a contact: gap [m] on the nodes, surfaces of uniform velocities [m/s] along x and y, reduced modulus [Pa], load
  !> [N]. With a `flow` the film is sheared by it, and with `bodies` too heat is simulated.
  subroutine pyworm_setup(contact, gap, dx, dy, velocity_1, velocity_2, reduced_modulus, load, oil, stat, flow, bodies)
    type(pyworm_point), intent(out) :: contact
    real(wp), intent(in) :: gap(:, :), dx, dy, velocity_1(2), velocity_2(2), reduced_modulus, load
    type(pyworm_oil), intent(in) :: oil
    integer, intent(out) :: stat
    type(pyworm_flow), intent(in), optional :: flow
    type(pyworm_body), intent(in), optional :: bodies(2)
    integer :: err

    stat = pyworm_bad_argument
    if (minval(shape(gap)) < fewest_nodes .or. .not. min(dx, dy, reduced_modulus, load, oil%viscosity) > 0) return
    if (present(bodies) .and. .not. present(flow)) return
    contact%gap = gap
    contact%dx = dx
    contact%dy = dy
    contact%reduced_modulus = reduced_modulus
    contact%load = load
    contact%oil = oil
    contact%sheared = present(flow)
    contact%heated = present(bodies)
    if (present(flow)) contact%flow = flow
    if (present(bodies)) contact%bodies = bodies
    allocate (contact%velocity(size(gap, 1), size(gap, 2), 2, 2), stat=err)
    stat = pyworm_no_memory
    if (err /= 0) return
    contact%velocity(:, :, 1, 1) = velocity_1(1)
    contact%velocity(:, :, 2, 1) = velocity_1(2)
    contact%velocity(:, :, 1, 2) = velocity_2(1)
    contact%velocity(:, :, 2, 2) = velocity_2(2)
    stat = pyworm_ok
  end subroutine pyworm_setup

  !> Solves the film until residual and load error are within `tolerance`, on coarser grids first.
  !>
  !> `steps` are the Newton steps on the finest grid. Without success the film is that of the last step.
  subroutine pyworm_solve(contact, tolerance, residual, load_error, steps, stat)
    type(pyworm_point), intent(inout) :: contact
    real(wp), intent(in) :: tolerance
    real(wp), intent(out) :: residual, load_error
    integer, intent(out) :: steps, stat
    integer :: level, coarsest
    real(wp), allocatable :: fine(:, :)

    residual = huge(1.0_wp)
    load_error = 1
    steps = 0
    stat = pyworm_bad_argument
    if (.not. (allocated(contact%gap) .and. tolerance > 0)) return
    coarsest = halvings(shape(contact%gap))
    call start_dry(contact, 2**coarsest, stat)
    do level = coarsest, 0, -1
      if (stat /= pyworm_ok) return
      if (level < coarsest) then
        allocate (fine(2*size(contact%p, 1) - 1, 2*size(contact%p, 2) - 1))
        call interpolate_cubic(contact%p, fine)
        fine = max(fine, 0.0_wp)
        call move_alloc(fine, contact%p)
      end if
      call make_film(contact, 2**level, stat)
      if (stat /= pyworm_ok) return
      call settle(contact, merge(tolerance, max(tolerance, coarse_tolerance), level == 0), residual, load_error, steps, stat)
      if (level > 0 .and. (stat == pyworm_not_converged .or. stat == pyworm_no_descent)) call start_dry(contact, 2**level, stat)
    end do
    if (stat == pyworm_ok .and. contact%sheared) then
      call add_flow(contact, stat)
      if (stat == pyworm_ok) call settle(contact, tolerance, residual, load_error, steps, stat)
    end if
  end subroutine pyworm_solve

  !> Pressure [Pa], film [m] and, of a heated film, the temperature in its middle above the inlet's [K].
  subroutine pyworm_read(contact, p, h, rise)
    type(pyworm_point), intent(in) :: contact
    real(wp), intent(out) :: p(:, :), h(:, :)
    real(wp), intent(out), optional :: rise(:, :)

    p = contact%p
    h = contact%film%film%fields%h
    if (.not. present(rise)) return
    rise = 0
    if (contact%sheared) rise = contact%film%film%shear%nodes%rise(:, :, (contact%flow%levels + 1)/2)
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
    stress_x = field%stress_x
    stress_y = field%stress_y
    heat = field%friction
  end subroutine pyworm_shear

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
    real(wp), allocatable :: mean(:, :, :)
    logical, allocatable :: covered(:, :)

    mean = sum(contact%velocity(::step, ::step, :, :), dim=4)/2
    allocate (covered(size(mean, 1), size(mean, 2)), source=.true.)
    allocate (film)
    associate (oil => contact%oil)
      call new_point_contact(film, contact%gap(::step, ::step), covered, mean(:, :, 1), mean(:, :, 2), step*contact%dx, &
        step*contact%dy, contact%reduced_modulus, oil_law(oil%law, oil%viscosity, oil%exponent, oil%pole_pressure, oil%d1, &
        oil%d2, oil%temperature, oil%thermal_exponent, oil%expansivity), contact%load, floor_fraction*contact%expected_film, &
        stat)
    end associate
    if (stat /= pyworm_ok) return
    if (allocated(contact%film%heat)) deallocate (contact%film%heat)
    if (allocated(contact%film%film)) deallocate (contact%film%film)
    call move_alloc(film, contact%film%film)
  end subroutine make_film

  !> Adds the flow law and, where it is simulated, heat to the film on the finest grid.
  subroutine add_flow(contact, stat)
    type(pyworm_point), intent(inout) :: contact
    integer, intent(out) :: stat
    class(heated_body), allocatable :: body_1, body_2

    associate (velocity => contact%velocity, flow => contact%flow, bodies => contact%bodies, oil => contact%oil)
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
      associate (velocity => contact%velocity(:, :, :, number), solid => contact%bodies(number))
        call new_conducting_body(velocity(:, :, 1), velocity(:, :, 2), pressure, semi, contact%dx, contact%dy, &
          solid%conductivity, solid%heat_capacity, body, error, stat)
      end associate
    end subroutine add_body

  end subroutine add_flow

  !> Makes Newton steps until the present film is within a tolerance and its heat settled.
  subroutine settle(contact, tolerance, residual, load_error, steps, stat)
    type(pyworm_point), intent(inout) :: contact
    real(wp), intent(in) :: tolerance
    real(wp), intent(out) :: residual, load_error
    integer, intent(out) :: steps, stat
    real(wp) :: damping, change, warming
    integer :: krylov
    logical :: heated

    heated = allocated(contact%film%heat)
    warming = merge(huge(1.0_wp), 0.0_wp, heated)
    call film_residual(contact%film%film, contact%p, contact%h0, residual, load_error)
    do steps = 0, most_steps
      stat = pyworm_ok
      if (max(residual, abs(load_error)) <= tolerance .and. warming <= settled) return
      if (steps == most_steps) exit
      if (heated) then
        call heated_step(contact%film%film, contact%film%heat, forcing, contact%p, contact%h0, residual, load_error, krylov, &
          damping, change, stat)
        warming = change/max(least_rise, maxval(contact%film%film%shear%nodes%rise))
      else
        call film_step(contact%film%film, forcing, contact%p, contact%h0, residual, load_error, krylov, damping, stat)
      end if
      ! a sweep of heat follows even where no step helps, and another film may belong to its temperatures
      if (stat /= pyworm_ok .and. .not. (heated .and. stat == pyworm_no_descent)) return
    end do
    stat = pyworm_not_converged
  end subroutine settle

end module pyworm_contact
