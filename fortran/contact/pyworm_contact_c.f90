!> The same for C programs (`pyworm_contact.h`): structures of numbers and of pointers to fields, x changing fastest; films as
!> opaque pointers. What may be left away is a null pointer.
module pyworm_contact_c
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_f_procpointer, c_funptr, c_int, c_loc, &
    c_null_char, c_null_ptr, c_ptr
  use pyworm_contact, only: interruption_query, pyworm_advance, pyworm_bad_argument, pyworm_body, pyworm_branch, &
    pyworm_fields, pyworm_film, pyworm_flow, pyworm_found, pyworm_interrupt_by, pyworm_message, pyworm_oil, pyworm_ok, &
    pyworm_options, pyworm_read, pyworm_rough_surface, pyworm_roughness, pyworm_scene, pyworm_setup, pyworm_solve, &
    pyworm_solve_dry, pyworm_version, viscosity_function
  implicit none(type, external)
  private

  public :: c_solve_dry, c_setup, c_solve, c_advance, c_read, c_free, c_interrupt_by, c_message, c_version

  abstract interface
    !> Not zero once the present call is to end.
    integer(c_int) function c_query() bind(c)
      import :: c_int
      implicit none(type, external)
    end function c_query

    !> Viscosity [Pa s] at a pressure [Pa] and a temperature [K].
    real(c_double) function c_viscosity(pressure, temperature) bind(c)
      import :: c_double
      implicit none(type, external)
      real(c_double), value :: pressure, temperature
    end function c_viscosity
  end interface

  !> The types of `contact_description` as the header has them.
  type, bind(c) :: c_scene
    integer(c_int) :: nx, ny
    real(c_double) :: dx, dy, load, reduced_modulus, velocity_1(2), velocity_2(2)
    type(c_ptr) :: gap, covered, velocity, supply
  end type c_scene

  type, bind(c) :: c_oil
    integer(c_int) :: law
    real(c_double) :: viscosity, exponent, pole_pressure, d1, d2, temperature, thermal_exponent, expansivity, &
      expansivity_decay, conductivity, c1, c2, heat_capacity, k1, k2, b0, b1, b2
    integer(c_int) :: pressure_count, temperature_count
    type(c_ptr) :: pressures, temperatures, viscosities, densities
    type(c_funptr) :: viscosity_at
    real(c_double) :: largest_pressure, coldest, warmest
  end type c_oil

  type, bind(c) :: c_flow
    integer(c_int) :: law
    real(c_double) :: stress, limit, limit_pressure, exponent, stress_pressure, stress_temperature
    integer(c_int) :: levels, branch_count, pair_count
    type(c_ptr) :: branches, table
  end type c_flow

  type, bind(c) :: c_branch
    real(c_double) :: fraction, ratio, exponent, yasuda
  end type c_branch

  type, bind(c) :: c_body
    real(c_double) :: conductivity, heat_capacity, bulk_rise
  end type c_body

  type, bind(c) :: c_rough_surface
    real(c_double) :: height, slope, aspect, lay, hardness, sharpness, density
  end type c_rough_surface

  type, bind(c) :: c_roughness
    type(c_rough_surface) :: surface(2)
    real(c_double) :: boundary_friction
  end type c_roughness

  type, bind(c) :: c_options
    real(c_double) :: tolerance, accuracy
    integer(c_int) :: most_steps
  end type c_options

  type, bind(c) :: c_found
    real(c_double) :: film_min, film_central, pressure_max, film_min_error, film_central_error, pressure_max_error, &
      window_error, residual, load_error
    integer(c_int) :: steps, coarsening
  end type c_found

  type, bind(c) :: c_fields
    type(c_ptr) :: p, h, asperity_pressure, fraction, stress_x, stress_y, heat, rise
  end type c_fields

  procedure(c_query), pointer :: c_asked => null()
  procedure(c_viscosity), pointer :: c_viscosity_at => null()
  !> Texts that end as C's do.
  character(kind=c_char, len=len(pyworm_version) + 1), target :: version = pyworm_version//c_null_char
  character(kind=c_char, len=80), target :: message = ''

contains

  !> As `pyworm_solve_dry`.
  integer(c_int) function c_solve_dry(scene, tolerance, p, approach) bind(c, name="pyworm_solve_dry")
    type(c_scene), intent(in) :: scene
    real(c_double), value :: tolerance
    real(c_double), intent(out) :: p(scene%nx, scene%ny), approach
    integer :: stat

    call pyworm_solve_dry(scene_of(scene), tolerance, p, approach, stat)
    c_solve_dry = stat
  end function c_solve_dry

  !> As `pyworm_setup`; `flow`, `bodies` and `roughness` may be null.
  type(c_ptr) function c_setup(scene, oil, flow, bodies, roughness, status) bind(c, name="pyworm_setup")
    type(c_scene), intent(in) :: scene
    type(c_oil), intent(in) :: oil
    type(c_ptr), value :: flow, bodies, roughness
    integer(c_int), intent(out) :: status
    type(pyworm_film), pointer :: film
    type(c_flow), pointer :: law
    type(c_body), pointer :: two(:)
    type(c_roughness), pointer :: rough
    type(pyworm_flow), allocatable :: own_flow
    type(pyworm_body), allocatable :: own_bodies(:)
    type(pyworm_roughness), allocatable :: own_roughness
    integer :: stat, k

    allocate (film)
    if (c_associated(flow)) then
      call c_f_pointer(flow, law)
      own_flow = flow_of(law)
    end if
    if (c_associated(bodies)) then
      call c_f_pointer(bodies, two, [2])
      own_bodies = [(pyworm_body(two(k)%conductivity, two(k)%heat_capacity, two(k)%bulk_rise), k=1, 2)]
    end if
    if (c_associated(roughness)) then
      call c_f_pointer(roughness, rough)
      allocate (own_roughness)
      own_roughness%boundary_friction = rough%boundary_friction
      own_roughness%surface = [(surface_of(rough%surface(k)), k=1, 2)]
    end if
    ! an argument that is not allocated counts as absent
    call pyworm_setup(film, scene_of(scene), oil_of(oil), stat, own_flow, own_bodies, own_roughness)
    status = stat
    c_setup = c_loc(film)
  end function c_setup

  !> A flow law, its branches and table copied.
  type(pyworm_flow) function flow_of(flow)
    type(c_flow), intent(in) :: flow
    type(c_branch), pointer :: branches(:)
    integer :: k

    flow_of = pyworm_flow(flow%law, flow%stress, flow%limit, flow%limit_pressure, flow%exponent, flow%stress_pressure, &
      flow%stress_temperature, flow%levels)
    if (c_associated(flow%branches)) then
      call c_f_pointer(flow%branches, branches, [flow%branch_count])
      flow_of%branches = [(pyworm_branch(branches(k)%fraction, branches(k)%ratio, branches(k)%exponent, branches(k)%yasuda), &
        k=1, flow%branch_count)]
    end if
    if (c_associated(flow%table)) flow_of%table = values_at(flow%table, 2_c_int, flow%pair_count)
  end function flow_of

  !> A scene, its fields copied.
  type(pyworm_scene) function scene_of(scene)
    type(c_scene), intent(in) :: scene
    integer(c_int), pointer :: covered(:, :)
    real(c_double), pointer :: velocity(:, :, :, :)

    scene_of = pyworm_scene(dx=scene%dx, dy=scene%dy, load=scene%load, reduced_modulus=scene%reduced_modulus, &
      velocity_1=scene%velocity_1, velocity_2=scene%velocity_2)
    scene_of%gap = values_at(scene%gap, scene%nx, scene%ny)
    if (c_associated(scene%supply)) scene_of%supply = values_at(scene%supply, scene%nx, scene%ny)
    if (c_associated(scene%covered)) then
      call c_f_pointer(scene%covered, covered, [scene%nx, scene%ny])
      scene_of%covered = covered /= 0
    end if
    if (c_associated(scene%velocity)) then
      call c_f_pointer(scene%velocity, velocity, [scene%nx, scene%ny, 2, 2])
      scene_of%velocity = velocity
    end if
  end function scene_of

  !> The numbers at an address.
  function values_at(address, nx, ny) result(values)
    type(c_ptr), intent(in) :: address
    integer(c_int), intent(in) :: nx, ny
    real(c_double) :: values(nx, ny)
    real(c_double), pointer :: there(:, :)

    call c_f_pointer(address, there, [nx, ny])
    values = there
  end function values_at

  !> An oil, its tables copied.
  type(pyworm_oil) function oil_of(oil)
    type(c_oil), intent(in) :: oil

    oil_of = pyworm_oil(oil%law, oil%viscosity, oil%exponent, oil%pole_pressure, oil%d1, oil%d2, oil%temperature, &
      oil%thermal_exponent, oil%expansivity, oil%expansivity_decay, oil%conductivity, oil%c1, oil%c2, oil%heat_capacity, &
      oil%k1, oil%k2, oil%b0, oil%b1, oil%b2)
    if (c_associated(oil%pressures) .and. c_associated(oil%temperatures)) then
      oil_of%pressures = reshape(values_at(oil%pressures, oil%pressure_count, 1_c_int), [oil%pressure_count])
      oil_of%temperatures = reshape(values_at(oil%temperatures, oil%temperature_count, 1_c_int), [oil%temperature_count])
      if (c_associated(oil%viscosities)) oil_of%viscosities = values_at(oil%viscosities, oil%pressure_count, &
        oil%temperature_count)
      if (c_associated(oil%densities)) oil_of%densities = values_at(oil%densities, oil%pressure_count, oil%temperature_count)
    end if
    if (c_associated(oil%viscosity_at)) then
      call c_f_procpointer(oil%viscosity_at, c_viscosity_at)
      oil_of%viscosity_at => viscosity_by_c
      if (oil%largest_pressure > 0) oil_of%largest_pressure = oil%largest_pressure
      oil_of%coldest = oil%coldest
      oil_of%warmest = oil%warmest
    end if
  end function oil_of

  !> The viscosity by C's function, which is asked in `pyworm_setup` alone.
  function viscosity_by_c(pressure, temperature) result(viscosity)
    real(c_double), intent(in) :: pressure, temperature
    real(c_double) :: viscosity

    viscosity = c_viscosity_at(pressure, temperature)
  end function viscosity_by_c

  !> A rough surface; a hardness of zero is none.
  type(pyworm_rough_surface) function surface_of(surface)
    type(c_rough_surface), intent(in) :: surface

    surface_of = pyworm_rough_surface(surface%height, surface%slope, surface%aspect, surface%lay, &
      sharpness=surface%sharpness, density=surface%density)
    if (surface%hardness > 0) surface_of%hardness = surface%hardness
  end function surface_of

  !> As `pyworm_solve`; `options` may be null.
  integer(c_int) function c_solve(film, options, found) bind(c, name="pyworm_solve")
    type(c_ptr), value :: film, options
    type(c_found), intent(out) :: found
    type(pyworm_film), pointer :: own
    type(pyworm_found) :: of_own
    integer :: stat

    call c_f_pointer(film, own)
    call pyworm_solve(own, options_at(options), of_own, stat)
    found = found_of(of_own)
    c_solve = stat
  end function c_solve

  !> As `pyworm_advance`; `options` may be null.
  integer(c_int) function c_advance(film, scene, seconds, options, found) bind(c, name="pyworm_advance")
    type(c_ptr), value :: film, options
    type(c_scene), intent(in) :: scene
    real(c_double), value :: seconds
    type(c_found), intent(out) :: found
    type(pyworm_film), pointer :: own
    type(pyworm_found) :: of_own
    integer :: stat

    call c_f_pointer(film, own)
    call pyworm_advance(own, scene_of(scene), seconds, options_at(options), of_own, stat)
    found = found_of(of_own)
    c_advance = stat
  end function c_advance

  !> Options at an address, or the usual ones.
  type(pyworm_options) function options_at(address)
    type(c_ptr), intent(in) :: address
    type(c_options), pointer :: options

    if (.not. c_associated(address)) return
    call c_f_pointer(address, options)
    options_at = pyworm_options(options%tolerance, options%accuracy, options%most_steps)
  end function options_at

  !> What was found as the header has it.
  type(c_found) function found_of(found)
    type(pyworm_found), intent(in) :: found

    found_of = c_found(found%film_min, found%film_central, found%pressure_max, found%film_min_error, &
      found%film_central_error, found%pressure_max_error, found%window_error, found%residual, found%load_error, &
      found%steps, found%coarsening)
  end function found_of

  !> Fields of a film into memory for nx*ny numbers each, the temperatures for as many at each level; null ones are left away.
  integer(c_int) function c_read(film, fields) bind(c, name="pyworm_read")
    type(c_ptr), value :: film
    type(c_fields), intent(in) :: fields
    type(pyworm_film), pointer :: own
    type(pyworm_fields) :: of_own
    integer :: stat

    call c_f_pointer(film, own)
    call pyworm_read(own, of_own, stat)
    c_read = stat
    if (stat /= pyworm_ok) return
    call copy(of_own%p, fields%p)
    call copy(of_own%h, fields%h)
    call copy(of_own%asperity_pressure, fields%asperity_pressure)
    call copy(of_own%fraction, fields%fraction)
    if (.not. allocated(of_own%rise)) then
      if (any([c_associated(fields%stress_x), c_associated(fields%stress_y), c_associated(fields%heat), &
        c_associated(fields%rise)])) c_read = pyworm_bad_argument
      return
    end if
    call copy(of_own%stress_x, fields%stress_x)
    call copy(of_own%stress_y, fields%stress_y)
    call copy(of_own%heat, fields%heat)
    call copy(reshape(of_own%rise, [size(of_own%rise, 1), size(of_own%rise, 2)*size(of_own%rise, 3)]), fields%rise)
  end function c_read

  !> Copies a field to an address that is not null.
  subroutine copy(field, address)
    real(c_double), intent(in) :: field(:, :)
    type(c_ptr), intent(in) :: address
    real(c_double), pointer :: there(:, :)

    if (.not. c_associated(address)) return
    call c_f_pointer(address, there, shape(field))
    there = field
  end subroutine copy

  !> Releases a film.
  subroutine c_free(film) bind(c, name="pyworm_free")
    type(c_ptr), value :: film
    type(pyworm_film), pointer :: own

    if (.not. c_associated(film)) return
    call c_f_pointer(film, own)
    deallocate (own)
  end subroutine c_free

  !> Sets what is asked, once an iteration, whether a call is to end; null for nothing.
  subroutine c_interrupt_by(asked) bind(c, name="pyworm_interrupt_by")
    type(c_funptr), value :: asked
    procedure(interruption_query), pointer :: query

    call c_f_procpointer(asked, c_asked)
    query => null()
    if (associated(c_asked)) query => ask
    call pyworm_interrupt_by(query)
  end subroutine c_interrupt_by

  logical function ask()
    ask = c_asked() /= 0
  end function ask

  !> Text of a status, up to the next call.
  type(c_ptr) function c_message(status) bind(c, name="pyworm_message")
    integer(c_int), value :: status

    message = pyworm_message(status)//c_null_char
    c_message = c_loc(message)
  end function c_message

  !> The version.
  type(c_ptr) function c_version() bind(c, name="pyworm_version")
    c_version = c_loc(version)
  end function c_version

end module pyworm_contact_c
