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

  public :: close_gap, worst_overlap

  !> Largest overlap outside the contact at convergence, over the mean residual gap inside.
  real(wp), parameter :: worst_overlap = 10

contains

  !> Finds the pressure p [Pa] that carries `load` [N] and closes the gap [m] at one approach [m].
  !>
  !> On entry p >= 0 carries the load and is positive only where `covered`. Fields are (nx, ny), as vectors.
  !> Converged when the residual gap in the contact is `tolerance` times the approach, in the mean square.
  subroutine close_gap(space, reduced_modulus, n, gap, covered, load, tolerance, most_iterations, p, film, &
      approach, iterations, stat)
    type(elastic_half_space), intent(inout) :: space
    integer, intent(in) :: n, most_iterations
    real(wp), intent(in) :: reduced_modulus, gap(n), load, tolerance
    logical, intent(in) :: covered(n)
    real(wp), intent(inout) :: p(n)
    !> Gap plus deflection [m].
    real(wp), intent(out) :: film(n), approach
    integer, intent(out) :: iterations, stat
    type(periodic_half_space) :: stiffness
    real(wp), allocatable :: work(:, :)
    real(wp) :: left, slope, last_slope, beta, step
    logical :: cut
    integer :: err

    iterations = 0
    approach = 0
    stat = status_no_memory
    allocate (work(n, 6), source=0.0_wp, stat=err)
    if (err /= 0) return
    call new_periodic_half_space(stiffness, space%nx, space%ny, space%dx, space%dy, reduced_modulus, stat)
    if (stat /= status_ok) return
    last_slope = 1
    call space%deflection(p, film)
    film = film + gap

    associate (contact => work(:, 1), residual => work(:, 2), last_residual => work(:, 3), &
      correction => work(:, 4), direction => work(:, 5), response => work(:, 6))
      do iterations = 0, most_iterations
        contact = merge(1.0_wp, 0.0_wp, p > 0)
        call spread_in(contact, film, approach, left)
        if (.not. left <= huge(left)) then
          stat = status_not_finite
          return
        end if
        if (left <= tolerance*abs(approach) &
          .and. .not. any(film < approach - worst_overlap*tolerance*abs(approach) .and. covered)) then
          stat = status_ok
          return
        end if
        if (iterations == most_iterations) exit
        if (interrupted()) then
          stat = status_interrupted
          return
        end if

        where (covered .and. film < approach) contact = 1
        residual = film
        call keep_balanced(contact, residual)
        call stiffness%pressure(residual, correction)
        call keep_balanced(contact, correction)
        call keep_balanced(contact, direction)
        slope = dot(residual, correction)
        beta = max(0.0_wp, slope - dot(last_residual, correction))/last_slope
        direction = correction + beta*direction
        if (dot(residual, direction) <= 0) direction = correction
        last_residual = residual
        last_slope = slope

        call space%deflection(direction, response)
        step = dot(residual, direction)/dot(response, direction)
        call advance(p, direction, step, cut)
        if (cut) then
          p = p*load/(sum(p)*space%dx*space%dy)
          call space%deflection(p, film)
          film = film + gap
        else
          film = film - step*response
        end if
      end do
    end associate
    stat = status_not_converged
  end subroutine close_gap

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
