!> A lubricated contact for Fortran programs: set up, solve to an accuracy, step in time, read the film.
!>
!> Numbers in SI; fields have the shape (nx, ny), with ny = 1 of a line contact, and the pressure is ambient on their outline, so
!> that the grid has to reach into the inlet. The kernel never stops and never prints: each procedure gives a status,
!> `pyworm_ok` or one of the numbers below, which `pyworm_message` puts into words.
module pyworm_contact
  use pyworm_contact_description, only: hidden_film, viscosity_function, pyworm_barus, pyworm_roelands, pyworm_tabulated, &
    pyworm_newton, pyworm_eyring, pyworm_bair_winer, pyworm_eyring_limited, pyworm_carreau, pyworm_carreau_yasuda, &
    pyworm_tabulated_flow, pyworm_scene, pyworm_oil, pyworm_branch, pyworm_flow, pyworm_body, pyworm_rough_surface, &
    pyworm_roughness, pyworm_options, pyworm_found, pyworm_fields, pyworm_film
  use pyworm_contact_input, only: complete_scene, oil_of, flow_of, curves_of_roughness
  use pyworm_contact_grids, only: found_by, halvings, reading, solve_on_grids
  use pyworm_contact_iteration, only: add_models, iterate, iteration_end
  use pyworm_contact_reading, only: read_fields
  use pyworm_contact_state, only: contact_state, dry_pressure, is_line, make_film
  use pyworm_contact_time, only: advance, film_past, remember
  use pyworm_interruption, only: interrupt_by, interruption_query
  use pyworm_kinds, only: pyworm_real => wp
  use pyworm_status, only: pyworm_ok => status_ok, pyworm_bad_argument => status_bad_argument, &
    pyworm_not_finite => status_not_finite, pyworm_no_plan => status_no_plan, &
    pyworm_not_converged => status_not_converged, pyworm_no_descent => status_no_descent, &
    pyworm_no_memory => status_no_memory, pyworm_interrupted => status_interrupted, &
    pyworm_inaccurate => status_inaccurate, status_message
  use pyworm_thermal_properties, only: oil_heat_law
  use pyworm_version_number, only: pyworm_version
  implicit none(type, external)
  private

  public :: pyworm_real, pyworm_version, pyworm_message, viscosity_function
  public :: pyworm_scene, pyworm_oil, pyworm_branch, pyworm_flow, pyworm_body, pyworm_rough_surface, pyworm_roughness, &
    pyworm_options, pyworm_film, pyworm_found, pyworm_fields
  public :: pyworm_solve_dry, pyworm_setup, pyworm_solve, pyworm_advance, pyworm_read
  public :: pyworm_interrupt_by, interruption_query
  public :: pyworm_barus, pyworm_roelands, pyworm_tabulated
  public :: pyworm_newton, pyworm_eyring, pyworm_bair_winer, pyworm_eyring_limited, pyworm_carreau, pyworm_carreau_yasuda, &
    pyworm_tabulated_flow
  public :: pyworm_ok, pyworm_bad_argument, pyworm_not_finite, pyworm_no_plan, pyworm_not_converged, &
    pyworm_no_descent, pyworm_no_memory, pyworm_interrupted, pyworm_inaccurate

  integer, parameter :: wp = pyworm_real

  !> A film's contact and, of time steps, the films before; the same on every second node, whose film shows the error by the grid.
  type, extends(hidden_film) :: film_in_time
    type(contact_state), allocatable :: contact, coarser
    type(film_past), allocatable :: past, coarser_past
    logical :: solved = .false.
  end type film_in_time

contains

  !> Text of a status.
  pure function pyworm_message(stat) result(message)
    integer, intent(in) :: stat
    character(len=:), allocatable :: message

    message = status_message(stat)
  end function pyworm_message

  !> Sets what is asked, once an iteration, whether a call is to end; null for nothing.
  subroutine pyworm_interrupt_by(asked)
    procedure(interruption_query), pointer, intent(in) :: asked

    call interrupt_by(asked)
  end subroutine pyworm_interrupt_by

  !> Pressure `p` [Pa] and rigid approach [m] of the dry point contact of a scene, whose velocities do not count, to a residual
  !> gap of `tolerance` times the approach.
  subroutine pyworm_solve_dry(scene, tolerance, p, approach, stat)
    type(pyworm_scene), intent(in) :: scene
    real(wp), intent(in) :: tolerance
    real(wp), intent(out) :: p(:, :), approach
    integer, intent(out) :: stat
    type(pyworm_scene), allocatable :: whole

    approach = 0
    p = 0
    allocate (whole)
    call complete_scene(scene, 2, whole, stat)
    if (stat /= pyworm_ok) return
    stat = pyworm_bad_argument
    if (is_line(whole) .or. any(shape(p) /= shape(whole%gap))) return
    call dry_pressure(whole, tolerance, p, approach, stat)
  end subroutine pyworm_solve_dry

  !> Sets up the film of a scene and an oil. With a `flow` the film is sheared by it, with `bodies` too heat is simulated, and
  !> with a `roughness` asperities bear a part of the load.
  subroutine pyworm_setup(film, scene, oil, stat, flow, bodies, roughness)
    type(pyworm_film), intent(out) :: film
    type(pyworm_scene), intent(in) :: scene
    type(pyworm_oil), intent(in) :: oil
    integer, intent(out) :: stat
    type(pyworm_flow), intent(in), optional :: flow
    type(pyworm_body), intent(in), optional :: bodies(2)
    type(pyworm_roughness), intent(in), optional :: roughness
    type(film_in_time), allocatable :: made

    stat = pyworm_bad_argument
    if (present(bodies) .and. .not. present(flow)) return
    allocate (made)
    allocate (made%contact)
    associate (contact => made%contact)
      allocate (contact%scene, contact%oil)
      call complete_scene(scene, 33, contact%scene, stat)
      if (stat == pyworm_ok) call oil_of(oil, contact%oil, stat)
      if (stat /= pyworm_ok) return
      contact%heat = oil_heat_law(oil%conductivity, oil%c1, oil%c2, oil%heat_capacity, oil%k1, oil%k2, oil%b0, oil%b1, oil%b2)
      contact%sheared = present(flow) .or. present(roughness)
      contact%heated = present(bodies)
      if (present(flow)) then
        contact%levels = flow%levels
        call flow_of(flow, contact%law, stat)
        if (stat /= pyworm_ok) return
      end if
      if (present(bodies)) contact%bodies = bodies
      if (present(roughness)) then
        allocate (contact%curves)
        contact%boundary_friction = roughness%boundary_friction
        call curves_of_roughness(roughness, scene%reduced_modulus, contact%curves, stat)
        if (stat /= pyworm_ok) return
      end if
    end associate
    call move_alloc(made, film%hidden)
  end subroutine pyworm_setup

  !> Solves the steady film of what was set up.
  !>
  !> `pyworm_ok` if a film was found whose errors by grid and window are together within the accuracy, else
  !> `pyworm_inaccurate`.
  subroutine pyworm_solve(film, options, found, stat)
    type(pyworm_film), intent(inout) :: film
    type(pyworm_options), intent(in) :: options
    type(pyworm_found), intent(out) :: found
    integer, intent(out) :: stat

    stat = pyworm_bad_argument
    if (.not. (options%tolerance > 0 .and. options%accuracy > 0 .and. options%most_steps > 0)) return
    if (.not. allocated(film%hidden)) return
    select type (whole => film%hidden)
    type is (film_in_time)
      if (allocated(whole%past)) deallocate (whole%past)
      if (allocated(whole%contact%residual_rise)) deallocate (whole%contact%residual_rise)
      if (allocated(whole%coarser)) deallocate (whole%coarser, whole%coarser_past)
      call solve_on_grids(whole%contact, options, found, stat)
      whole%solved = stat == pyworm_ok
    end select
    if (stat /= pyworm_ok) return
    associate (by_grid => max(found%film_min_error, found%film_central_error))
      if (.not. by_grid + found%window_error <= options%accuracy) stat = pyworm_inaccurate
    end associate
  end subroutine pyworm_solve

  !> Solves the film of a scene `seconds` after the last one, which was steady or itself reached by a step; a scene of the same
  !> grid with its load, gap and velocities then. Where it fails the film is still that before the step.
  subroutine pyworm_advance(film, scene, seconds, options, found, stat)
    type(pyworm_film), intent(inout) :: film
    type(pyworm_scene), intent(in) :: scene
    real(wp), intent(in) :: seconds
    type(pyworm_options), intent(in) :: options
    type(pyworm_found), intent(out) :: found
    integer, intent(out) :: stat
    type(pyworm_scene), allocatable :: next

    stat = pyworm_bad_argument
    if (.not. (seconds > 0 .and. options%tolerance > 0 .and. allocated(film%hidden))) return
    allocate (next)
    call complete_scene(scene, 33, next, stat)
    if (stat /= pyworm_ok) return
    stat = pyworm_bad_argument
    select type (whole => film%hidden)
    type is (film_in_time)
      if (.not. whole%solved) return
      if (whole%contact%step /= 1 .or. any(shape(next%gap) /= shape(whole%contact%scene%gap))) return
      call step_both(whole, next, seconds, options, found, stat)
    end select
    if (stat /= pyworm_ok) return
    if (.not. max(found%film_min_error, found%film_central_error) <= options%accuracy) stat = pyworm_inaccurate
  end subroutine pyworm_advance

  !> Makes a time step on the given grid and on that of every second node.
  subroutine step_both(whole, next, seconds, options, found, stat)
    type(film_in_time), intent(inout) :: whole
    type(pyworm_scene), intent(in) :: next
    real(wp), intent(in) :: seconds
    type(pyworm_options), intent(in) :: options
    type(pyworm_found), intent(out) :: found
    integer, intent(out) :: stat
    type(iteration_end) :: ended, coarse_end
    real(wp), allocatable :: readings(:, :)
    integer :: coarse_stat, node(2)

    if (.not. allocated(whole%past)) then
      allocate (whole%past)
      call remember(whole%past, 0.0_wp, whole%contact)
      call begin_coarser(whole, options)
    end if
    whole%contact%scene = next
    call advance(whole%contact, whole%past, seconds, options, ended, stat)
    if (stat /= pyworm_ok) return
    node = 1 + 2*((minloc(next%gap) - 1)/2) ! one of both grids
    readings = reshape(reading(whole%contact, node), [3, 1])
    if (allocated(whole%coarser)) then
      whole%coarser%scene = next
      call advance(whole%coarser, whole%coarser_past, seconds, options, coarse_end, coarse_stat)
      if (coarse_stat == pyworm_ok) then
        readings = reshape([reading(whole%coarser, 1 + (node - 1)/2), readings], [3, 2])
      else
        deallocate (whole%coarser)
      end if
    end if
    found = found_by(readings, ended, 1)
  end subroutine step_both

  !> Begins time steps on every second node with the steady film there; without one the error by the grid stays unknown.
  subroutine begin_coarser(whole, options)
    type(film_in_time), intent(inout) :: whole
    type(pyworm_options), intent(in) :: options
    type(iteration_end) :: ended
    integer :: stat

    if (halvings(shape(whole%contact%scene%gap)) == 0) return
    allocate (whole%coarser)
    associate (coarser => whole%coarser, contact => whole%contact)
      coarser%scene = contact%scene
      coarser%oil = contact%oil
      coarser%heat = contact%heat
      coarser%law = contact%law
      coarser%levels = contact%levels
      coarser%bodies = contact%bodies
      if (allocated(contact%curves)) coarser%curves = contact%curves
      coarser%boundary_friction = contact%boundary_friction
      coarser%sheared = contact%sheared
      coarser%heated = contact%heated
      coarser%expected_film = contact%expected_film
      coarser%p = contact%p(::2, ::2)
      coarser%h0 = contact%h0
      call make_film(coarser, 2, stat)
      if (stat == pyworm_ok) call iterate(coarser, options, ended, stat)
      if (stat == pyworm_ok) call add_models(coarser, options, ended, stat)
      if (stat == pyworm_ok) then
        if (.not. allocated(whole%coarser_past)) allocate (whole%coarser_past)
        call remember(whole%coarser_past, 0.0_wp, coarser)
      end if
    end associate
    if (stat /= pyworm_ok) deallocate (whole%coarser)
  end subroutine begin_coarser

  !> Reads the fields of the last film, on the given grid; interpolated where the film is that of a coarser one.
  subroutine pyworm_read(film, fields, stat)
    type(pyworm_film), intent(in) :: film
    type(pyworm_fields), intent(out) :: fields
    integer, intent(out) :: stat

    stat = pyworm_bad_argument
    if (.not. allocated(film%hidden)) return
    select type (whole => film%hidden)
    type is (film_in_time)
      if (allocated(whole%contact%film)) call read_fields(whole%contact, fields, stat)
    end select
  end subroutine pyworm_read

end module pyworm_contact
