!> Conjugate gradients with bounds for the dry contact on one grid.
!>
!> Pressure p >= 0 of a given sum minimises complementary energy. As in Polonsky and Keer (1999, Wear 231:206)
!> the contact set is found in the iteration: after each step nodes in tension leave it, and those that overlap
!> join it. As in Vollebregt's BCCG (2014, J. Optim. Theory Appl. 162:931) the gradients are preconditioned
!> with a transform, directions are continued through a change of the set (Polak and Ribiere's beta damps them
!> then), and the deflection after a step that no bound limits needs no further convolution.
module pyworm_constrained_gradients
  use pyworm_half_space, only: elastic_half_space
  use pyworm_interruption, only: interrupted
  use pyworm_kinds, only: wp
  use pyworm_periodic_stiffness, only: periodic_half_space, new_periodic_half_space
  use pyworm_status, only: status_ok, status_interrupted, status_no_memory, status_not_converged, status_not_finite
  use pyworm_vectors, only: dot
  implicit none(type, external)
  private

  public :: dry_bodies, close_gap, worst_overlap

  !> Largest overlap outside the contact at convergence, over the mean residual gap inside.
  real(wp), parameter :: worst_overlap = 10

  !> Two bodies without friction: their undeformed gap [m] at the nodes, as a vector, where both exist, reduced modulus E'
  !> [Pa], and load [N].
  type :: dry_bodies
    real(wp), allocatable :: gap(:)
    logical, allocatable :: covered(:)
    real(wp) :: reduced_modulus = 0, load = 0
  end type dry_bodies

  !> Fields of the iteration.
  type :: gradient_fields
    !> Gap plus deflection [m]; 1 in contact, else 0.
    real(wp), allocatable :: film(:), contact(:)
    !> Film in the contact less its mean, now and a step before [m]; preconditioned [Pa]; direction of the step [Pa] and
    !> deflection by it [m].
    real(wp), allocatable :: residual(:), last_residual(:), correction(:), direction(:), response(:)
    real(wp) :: last_slope = 1
  end type gradient_fields

contains

  !> Finds the pressure p [Pa] that carries the load and closes the gap at one approach [m].
  !>
  !> On entry p >= 0 carries the load and is positive only where `covered`. Fields are (nx, ny), as vectors.
  !> Converged when the residual gap in the contact is `tolerance` times the approach, in the mean square.
  subroutine close_gap(space, bodies, tolerance, most_iterations, p, approach, iterations, stat)
    type(elastic_half_space), intent(inout) :: space
    type(dry_bodies), intent(in) :: bodies
    real(wp), intent(in) :: tolerance
    integer, intent(in) :: most_iterations
    real(wp), intent(inout) :: p(space%nx*space%ny)
    real(wp), intent(out) :: approach
    integer, intent(out) :: iterations, stat
    type(periodic_half_space) :: stiffness
    type(gradient_fields) :: fields
    real(wp) :: deviation

    iterations = 0
    approach = 0
    call new_gradient_fields(size(p), fields, stat)
    if (stat /= status_ok) return
    call new_periodic_half_space(stiffness, space%nx, space%ny, space%dx, space%dy, bodies%reduced_modulus, stat)
    if (stat /= status_ok) return
    call set_film(space, bodies, p, fields%film)

    do iterations = 0, most_iterations
      fields%contact = merge(1.0_wp, 0.0_wp, p > 0)
      call spread_in(fields%contact, fields%film, approach, deviation)
      if (.not. deviation <= huge(deviation)) then
        stat = status_not_finite
        return
      end if
      if (deviation <= tolerance*abs(approach) &
        .and. .not. any(fields%film < approach - worst_overlap*tolerance*abs(approach) .and. bodies%covered)) then
        stat = status_ok
        return
      end if
      if (iterations == most_iterations) exit
      if (interrupted()) then
        stat = status_interrupted
        return
      end if
      where (bodies%covered .and. fields%film < approach) fields%contact = 1
      call set_direction(stiffness, fields)
      call take_step(space, bodies, fields, p)
    end do
    stat = status_not_converged
  end subroutine close_gap

  subroutine new_gradient_fields(n, fields, stat)
    integer, intent(in) :: n
    type(gradient_fields), intent(out) :: fields
    integer, intent(out) :: stat
    integer :: err

    allocate (fields%film(n), fields%contact(n), fields%residual(n), fields%last_residual(n), fields%correction(n), &
      fields%direction(n), fields%response(n), source=0.0_wp, stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
  end subroutine new_gradient_fields

  !> Sets the film [m]: gap plus deflection.
  subroutine set_film(space, bodies, p, film)
    type(elastic_half_space), intent(inout) :: space
    type(dry_bodies), intent(in) :: bodies
    real(wp), contiguous, intent(in) :: p(:)
    real(wp), contiguous, intent(out) :: film(:)

    call space%deflection(p, film)
    film = film + bodies%gap
  end subroutine set_film

  !> Sets the preconditioned gradient and the direction, continued by Polak and Ribiere's beta from the one before: it damps
  !> that where nodes joined or left the contact.
  subroutine set_direction(stiffness, fields)
    type(periodic_half_space), intent(inout) :: stiffness
    type(gradient_fields), intent(inout) :: fields
    real(wp) :: slope, beta

    associate (contact => fields%contact, residual => fields%residual, correction => fields%correction, &
      direction => fields%direction)
      residual = fields%film
      call keep_balanced(contact, residual)
      call stiffness%pressure(residual, correction)
      call keep_balanced(contact, correction)
      call keep_balanced(contact, direction)
      slope = dot(residual, correction)
      beta = max(0.0_wp, slope - dot(fields%last_residual, correction))/fields%last_slope
      direction = correction + beta*direction
      if (dot(residual, direction) <= 0) direction = correction
      fields%last_residual = residual
      fields%last_slope = slope
    end associate
  end subroutine set_direction

  !> Moves the pressure along the direction to the least energy, and the film with it: by the deflection already at hand unless
  !> the bound p >= 0 limited a node.
  subroutine take_step(space, bodies, fields, p)
    type(elastic_half_space), intent(inout) :: space
    type(dry_bodies), intent(in) :: bodies
    type(gradient_fields), intent(inout) :: fields
    real(wp), contiguous, intent(inout) :: p(:)
    real(wp) :: step
    logical :: cut

    call space%deflection(fields%direction, fields%response)
    step = dot(fields%residual, fields%direction)/dot(fields%response, fields%direction)
    call advance(p, fields%direction, step, cut)
    if (cut) then
      p = p*bodies%load/(sum(p)*space%dx*space%dy)
      call set_film(space, bodies, p, fields%film)
    else
      fields%film = fields%film - step*fields%response
    end if
  end subroutine take_step

  !> Computes the mean and the standard deviation of a field over the contact.
  subroutine spread_in(contact, field, mean, deviation)
    real(wp), contiguous, intent(in) :: contact(:), field(:)
    real(wp), intent(out) :: mean, deviation
    real(wp) :: nodes, squares
    integer :: i

    nodes = sum(contact)
    mean = dot(contact, field)/nodes
    squares = 0
    !$omp simd reduction(+:squares)
    do i = 1, size(field)
      squares = squares + contact(i)*(field(i) - mean)**2
    end do
    deviation = sqrt(squares/nodes)
  end subroutine spread_in

  !> Sets a field to zero outside the contact and subtracts its mean inside, so that it conserves the load.
  subroutine keep_balanced(contact, field)
    real(wp), contiguous, intent(in) :: contact(:)
    real(wp), contiguous, intent(inout) :: field(:)

    field = contact*(field - dot(contact, field)/sum(contact))
  end subroutine keep_balanced

  !> Moves the pressure against the direction; `cut` is true if the bound p >= 0 limited a node.
  pure subroutine advance(p, direction, step, cut)
    real(wp), contiguous, intent(inout) :: p(:)
    real(wp), contiguous, intent(in) :: direction(:)
    real(wp), intent(in) :: step
    logical, intent(out) :: cut
    integer :: i

    cut = .false.
    do i = 1, size(p)
      p(i) = p(i) - step*direction(i)
      cut = cut .or. p(i) < 0
      p(i) = max(p(i), 0.0_wp)
    end do
  end subroutine advance

end module pyworm_constrained_gradients
