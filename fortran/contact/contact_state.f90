!> A contact on one of its grids: the kernel's film of it, made from what a program said, and its first guess.
module pyworm_contact_state
  use pyworm_conducting_body, only: new_conducting_body
  use pyworm_contact_description, only: pyworm_body, pyworm_scene
  use pyworm_dry_contact, only: solve_dry_contact
  use pyworm_film_newton, only: contact_conditions, film_contact, roughen_contact, shear_contact
  use pyworm_flow_laws, only: flow_law
  use pyworm_half_space, only: elastic_half_space, new_half_space
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  use pyworm_line_film, only: line_contact, new_line_contact
  use pyworm_line_heat, only: heat_line_contact
  use pyworm_line_source, only: line_body, new_line_body
  use pyworm_point_film, only: new_point_contact, point_contact
  use pyworm_point_heat, only: heat_point_contact
  use pyworm_rough_surfaces, only: gap_curves
  use pyworm_status, only: status_not_converged, status_ok
  use pyworm_thermal_properties, only: oil_heat_law
  use pyworm_thermal_step, only: thermal_contact
  use pyworm_viscosity_density, only: law_roelands, oil_law
  implicit none(type, external)
  private

  public :: contact_state, dry_pressure, guess_dry, make_film, set_flow_law, add_heat, is_line, is_inner

  !> Film below which the mobility is constant, and pressure with which a film starts outside its dry contact, over
  !> the expected film and the largest dry pressure.
  real(wp), parameter :: floor_fraction = 1e-3_wp, trace = 1e-6_wp
  !> Accuracy of the dry contact with which a film starts, and the most iterations for a dry contact.
  real(wp), parameter :: dry_tolerance = 1e-3_wp
  integer, parameter :: most_dry_iterations = 2000
  !> Passes in which the width of a dry line contact is found.
  integer, parameter :: width_passes = 20
  real(wp), parameter :: pi = acos(-1.0_wp)

  type :: contact_state
    !> What was said, with all fields that may be left away.
    type(pyworm_scene), allocatable :: scene
    type(oil_law), allocatable :: oil
    type(oil_heat_law) :: heat
    type(pyworm_body) :: bodies(2)
    !> Flow law, Newtonian without one, and levels across the film.
    type(flow_law) :: law
    integer :: levels = 7
    !> Averages of rough surfaces, and the friction coefficient of their asperities.
    type(gap_curves), allocatable :: curves
    real(wp) :: boundary_friction = 0
    !> Whether it has a flow law, and heat.
    logical :: sheared = .false., heated = .false.
    !> In a time step, what each body's surface is warmer by than in steady conduction, since it was heated before [K].
    real(wp), allocatable :: residual_rise(:, :, :)
    !> Expected central film [m].
    real(wp) :: expected_film = 0
    !> Spacing of the present grid over that of the given one; pressure [Pa] and rigid film [m] on it.
    integer :: step = 1
    real(wp), allocatable :: p(:, :)
    real(wp) :: h0 = 0
    type(thermal_contact), allocatable :: film
  end type contact_state

contains

  !> Whether it is a line contact.
  pure logical function is_line(scene)
    type(pyworm_scene), intent(in) :: scene

    is_line = size(scene%gap, 2) == 1
  end function is_line

  !> Where nodes of a grid are not on its outline.
  pure function is_inner(nx, ny) result(inner)
    integer, intent(in) :: nx, ny
    logical :: inner(nx, ny)

    inner = .true.
    inner([1, nx], :) = .false.
    if (ny > 1) inner(:, [1, ny]) = .false.
  end function is_inner

  !> Pressure [Pa] and rigid approach [m] of a dry point contact.
  subroutine dry_pressure(scene, tolerance, p, approach, stat)
    type(pyworm_scene), intent(in) :: scene
    real(wp), intent(in) :: tolerance
    real(wp), intent(out) :: p(:, :), approach
    integer, intent(out) :: stat
    type(elastic_half_space) :: space
    integer :: iterations

    approach = 0
    p = 1
    call new_half_space(space, size(p, 1), size(p, 2), scene%dx, scene%dy, scene%reduced_modulus, stat)
    if (stat == status_ok) call solve_dry_contact(space, scene%gap, scene%covered, scene%load, tolerance, most_dry_iterations, &
      p, approach, iterations, stat)
  end subroutine dry_pressure

  !> Starts from the dry contact on every `step`-th node, lifted by the expected film, and makes its Newtonian film.
  subroutine guess_dry(contact, step, stat)
    type(contact_state), intent(inout) :: contact
    integer, intent(in) :: step
    integer, intent(out) :: stat
    type(pyworm_scene) :: scene
    real(wp), allocatable :: deflection(:, :)
    real(wp) :: approach
    integer :: nx, ny, centre(2)

    call thin_out(contact%scene, step, scene)
    nx = size(scene%gap, 1)
    ny = size(scene%gap, 2)
    if (allocated(contact%p)) deallocate (contact%p)
    allocate (contact%p(nx, ny))
    approach = 0
    stat = status_ok
    if (is_line(scene)) then
      call hertz_line(scene, contact%oil, contact%p(:, 1), contact%expected_film)
    else
      call dry_pressure(scene, dry_tolerance, contact%p, approach, stat)
      if (stat == status_not_converged) stat = status_ok
      contact%expected_film = central_film(scene, contact%oil, maxval(contact%p), approach)
    end if
    contact%h0 = contact%expected_film - approach
    if (stat == status_ok) call make_film(contact, step, stat)
    if (stat /= status_ok) return
    if (is_line(scene)) then
      allocate (deflection(nx, ny))
      centre = maxloc(contact%p)
      call contact%film%film%deflection(contact%p, deflection)
      contact%h0 = contact%expected_film - deflection(centre(1), 1) - scene%gap(centre(1), 1)
    end if
    contact%p = merge(contact%p + trace*maxval(contact%p), 0.0_wp, is_inner(nx, ny) .and. scene%covered)
  end subroutine guess_dry

  !> Central film [m] of a point contact by Hamrock and Dowson (1977), of the circular contact with this dry pressure and
  !> approach.
  pure real(wp) function central_film(scene, oil, pressure, approach)
    type(pyworm_scene), intent(in) :: scene
    type(oil_law), intent(in) :: oil
    real(wp), intent(in) :: pressure, approach
    real(wp) :: radius, speed

    radius = 3*scene%load/(2*pi*pressure)/max(abs(approach), tiny(1.0_wp))
    speed = norm2(entrainment_at(scene, minloc(scene%gap)))
    central_film = 1.9_wp*radius*(oil%eta0*speed/(scene%reduced_modulus*radius))**0.67_wp &
      *max(stiffening(oil)*scene%reduced_modulus, 100.0_wp)**0.53_wp &
      *(scene%load/(scene%reduced_modulus*radius**2))**(-0.067_wp)
  end function central_film

  !> Entrainment (u, v) at a node [m/s].
  pure function entrainment_at(scene, node) result(mean)
    type(pyworm_scene), intent(in) :: scene
    integer, intent(in) :: node(2)
    real(wp) :: mean(2)

    mean = sum(scene%velocity(node(1), node(2), :, :), dim=2)/2
  end function entrainment_at

  !> Pressure-viscosity coefficient [1/Pa].
  pure real(wp) function stiffening(oil)
    type(oil_law), intent(in) :: oil

    stiffening = oil%exponent
    if (oil%law == law_roelands) stiffening = oil%exponent*(log(oil%eta0) + 9.67_wp)/oil%pole_pressure
  end function stiffening

  !> Hertz's pressure [Pa] of a line contact whose gap rises over its own half-width as that of a cylinder, and its central film
  !> [m] by Dowson and Higginson (1966).
  pure subroutine hertz_line(scene, oil, p, film)
    type(pyworm_scene), intent(in) :: scene
    type(oil_law), intent(in) :: oil
    real(wp), intent(out) :: p(:), film
    real(wp) :: radius, width, x(size(p)), speed
    integer :: centre, reach, pass, low, high, i

    centre = minloc(scene%gap(:, 1), dim=1, mask=scene%covered(:, 1))
    reach = 1
    do pass = 1, width_passes
      low = max(centre - reach, 1)
      high = min(centre + reach, size(p))
      radius = (scene%dx*(high - low)/2)**2/max(scene%gap(low, 1) + scene%gap(high, 1) - 2*scene%gap(centre, 1), &
        tiny(1.0_wp))
      radius = min(radius, (scene%dx*size(p))**2*scene%reduced_modulus/scene%load)
      width = sqrt(8*scene%load*radius/(pi*scene%reduced_modulus))
      reach = max(min(nint(width/scene%dx), size(p) - 1), 1)
    end do
    x = [(scene%dx*(i - centre), i=1, size(p))]
    p = merge(sqrt(max(1 - (x/width)**2, 0.0_wp)), 0.0_wp, scene%covered(:, 1))
    do pass = 1, 2 ! a pressure that rises as a root loses Newton's iteration
      p(2:size(p) - 1) = (p(:size(p) - 2) + 2*p(2:size(p) - 1) + p(3:))/4
    end do
    p = p*scene%load/(sum(p)*scene%dx)
    speed = norm2(entrainment_at(scene, [centre, 1]))
    film = 3*radius*(oil%eta0*speed/(scene%reduced_modulus*radius))**0.7_wp &
      *max(stiffening(oil)*scene%reduced_modulus, 100.0_wp)**0.54_wp*(scene%load/(scene%reduced_modulus*radius))**(-0.13_wp)
  end subroutine hertz_line

  !> The scene on every `step`-th node.
  pure subroutine thin_out(scene, step, thinned)
    type(pyworm_scene), intent(in) :: scene
    integer, intent(in) :: step
    type(pyworm_scene), intent(out) :: thinned

    thinned = pyworm_scene(dx=step*scene%dx, dy=step*scene%dy, load=scene%load, reduced_modulus=scene%reduced_modulus)
    thinned%gap = scene%gap(::step, ::step)
    thinned%covered = scene%covered(::step, ::step)
    thinned%velocity = scene%velocity(::step, ::step, :, :)
    if (allocated(scene%supply)) thinned%supply = scene%supply(::step, ::step)
  end subroutine thin_out

  !> Makes the Newtonian film of one temperature on every `step`-th node, whose pressure is there; it is ambient beyond a body.
  subroutine make_film(contact, step, stat)
    type(contact_state), intent(inout) :: contact
    integer, intent(in) :: step
    integer, intent(out) :: stat
    type(pyworm_scene) :: scene
    class(film_contact), allocatable :: film
    real(wp), allocatable :: mean(:, :, :)

    call thin_out(contact%scene, step, scene)
    mean = sum(scene%velocity, dim=4)/2
    if (is_line(scene)) then
      call make_line(film)
    else
      call make_point(film)
    end if
    if (stat == status_ok .and. allocated(scene%supply)) call film%feed(scene%supply, stat)
    if (stat /= status_ok) return
    where (.not. scene%covered) contact%p = 0
    contact%step = step
    if (allocated(contact%film)) deallocate (contact%film)
    allocate (contact%film)
    call move_alloc(film, contact%film%film)

  contains

    subroutine make_line(film)
      class(film_contact), allocatable, intent(out) :: film
      type(line_contact), allocatable :: line

      allocate (line)
      call new_line_contact(line, scene%gap(:, 1), scene%covered(:, 1), mean(:, 1, 1), scene%dx, scene%reduced_modulus, &
        contact%oil, scene%load, floor_fraction*contact%expected_film, stat)
      call move_alloc(line, film)
    end subroutine make_line

    subroutine make_point(film)
      class(film_contact), allocatable, intent(out) :: film
      type(point_contact), allocatable :: point

      allocate (point)
      call new_point_contact(point, contact_conditions(scene%gap, scene%covered, [scene%dx, scene%dy], scene%reduced_modulus, &
        contact%oil, scene%load, floor_fraction*contact%expected_film), mean(:, :, 1), mean(:, :, 2), stat)
      call move_alloc(point, film)
    end subroutine make_point

  end subroutine make_film

  !> Gives the film a flow law, its own or, for a start, that of a Newtonian oil, and rough surfaces where they are.
  subroutine set_flow_law(contact, newtonian, stat)
    type(contact_state), intent(inout) :: contact
    logical, intent(in) :: newtonian
    integer, intent(out) :: stat
    type(flow_law) :: law

    if (allocated(contact%film%heat)) deallocate (contact%film%heat)
    if (.not. newtonian) law = contact%law
    associate (velocity => contact%scene%velocity(::contact%step, ::contact%step, :, :))
      call shear_contact(contact%film%film, law, contact%levels, velocity(:, :, 1, 2) - velocity(:, :, 1, 1), &
        velocity(:, :, 2, 2) - velocity(:, :, 2, 1), stat)
    end associate
    if (stat == status_ok .and. allocated(contact%curves)) call roughen_contact(contact%film%film, contact%curves, &
      contact%boundary_friction, stat)
  end subroutine set_flow_law

  !> Adds heat to a film with a flow law.
  subroutine add_heat(contact, stat)
    type(contact_state), intent(inout) :: contact
    integer, intent(out) :: stat
    class(heated_body), allocatable :: body_1, body_2
    real(wp), allocatable :: velocity(:, :, :, :)
    integer :: number

    allocate (velocity, source=contact%scene%velocity(::contact%step, ::contact%step, :, :))
    if (is_line(contact%scene)) then
      call line_surface(1, body_1)
      if (stat == status_ok) call line_surface(2, body_2)
      if (stat == status_ok) call heat_line_contact(contact%film, contact%heat, velocity(:, 1, 1, 1), body_1, body_2, &
        contact%bodies%bulk_rise, stat)
    else
      call point_surface(1, body_1)
      if (stat == status_ok) call point_surface(2, body_2)
      if (stat == status_ok) call heat_point_contact(contact%film, contact%heat, velocity(:, :, 1, 1), velocity(:, :, 2, 1), &
        body_1, body_2, contact%bodies%bulk_rise, stat)
    end if
    if (stat /= status_ok .or. .not. allocated(contact%residual_rise)) return
    do number = 1, 2
      contact%film%heat%walls%body(number)%remembered = contact%residual_rise(:, :, number)
    end do

  contains

    !> A body under a line contact; its velocity is that at the least gap.
    subroutine line_surface(number, body)
      integer, intent(in) :: number
      class(heated_body), allocatable, intent(out) :: body
      type(line_body), allocatable :: moving
      integer :: centre

      centre = maxloc(contact%p(:, 1), dim=1)
      allocate (moving)
      call new_line_body(moving, size(velocity, 1), contact%step*contact%scene%dx, velocity(centre, 1, 1, number), &
        contact%bodies(number)%conductivity, contact%bodies(number)%heat_capacity, stat)
      call move_alloc(moving, body)
    end subroutine line_surface

    !> A body under the present pressure of a point contact.
    subroutine point_surface(number, body)
      integer, intent(in) :: number
      class(heated_body), allocatable, intent(out) :: body
      real(wp) :: error, semi(2), pressure(size(contact%p, 1), size(contact%p, 2))

      pressure = contact%p
      semi = sqrt(1.5_wp*contact%scene%load/(pi*maxval(pressure)))
      associate (solid => contact%bodies(number))
        call new_conducting_body(velocity(:, :, 1, number), velocity(:, :, 2, number), pressure, semi, &
          contact%step*[contact%scene%dx, contact%scene%dy], solid%conductivity, solid%heat_capacity, body, error, stat)
      end associate
    end subroutine point_surface

  end subroutine add_heat

end module pyworm_contact_state
