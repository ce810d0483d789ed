!> Frictionless dry contact of two half-spaces with an arbitrary gap under a given load.
!>
!> Conjugate gradients with the FFT deflection, the contact set found on the way (Polonsky and Keer 1999,
!> Wear 231:206), restricted to the nodes where both bodies exist.
module dry_contact
  use half_space, only: elastic_half_space
  use kinds, only: wp
  use status, only: status_ok, status_bad_argument, status_not_converged, status_not_finite
  use vectors, only: dot, total
  implicit none(type, external)
  private

  public :: solve_dry_contact

contains

  !> Pressure p [Pa] that carries `load` [N] and closes the gap to one approach [m].
  !>
  !> On entry p >= 0 is a first guess with a positive sum. `covered` is true where both bodies exist.
  !> Stops when the film left in the contact, on average, is `tolerance` times the approach.
  subroutine solve_dry_contact(space, gap, covered, load, tolerance, most_iterations, p, approach, &
      iterations, stat)
    type(elastic_half_space), intent(inout) :: space
    real(wp), intent(in) :: gap(space%nx, space%ny)
    logical, intent(in) :: covered(space%nx, space%ny)
    real(wp), intent(in) :: load, tolerance
    integer, intent(in) :: most_iterations
    real(wp), intent(inout) :: p(space%nx, space%ny)
    real(wp), intent(out) :: approach
    integer, intent(out) :: iterations, stat
    real(wp), allocatable :: film(:, :), direction(:, :), response(:, :)
    real(wp) :: norm, last_norm, step, mean
    logical :: contact_grew
    integer :: j

    approach = 0
    iterations = 0
    stat = status_bad_argument
    if (load <= 0) return
    where (.not. covered) p = 0
    if (total(p) <= 0) return
    stat = status_not_converged
    p = p*load/(total(p)*space%dx*space%dy)
    allocate (film, direction, response, mold=gap)
    direction = 0
    last_norm = 1
    contact_grew = .false.

    do iterations = 1, most_iterations
      call space%deflection(p, film)
      film = film + gap
      approach = sum(film, mask=p > 0)/count(p > 0)
      film = film - approach
      norm = sum(film**2, mask=p > 0)
      if (.not. norm <= huge(norm)) then
        stat = status_not_finite
        return
      end if
      if (sqrt(norm/count(p > 0)) <= tolerance*abs(approach) .and. .not. any(film < -10*tolerance*abs(approach) .and. covered)) then
        stat = status_ok
        return
      end if

      if (contact_grew) last_norm = huge(norm)
      where (p > 0)
        direction = film + (norm/last_norm)*direction
      else where
        direction = 0
      end where
      last_norm = norm
      call space%deflection(direction, response)
      mean = sum(response, mask=p > 0)/count(p > 0)
      step = sum(film*direction, mask=p > 0)/sum((response - mean)*direction, mask=p > 0)

      contact_grew = .false.
      do j = 1, space%ny
        call advance(p(:, j), film(:, j), direction(:, j), covered(:, j), step, contact_grew)
      end do
      p = p*load/(total(p)*space%dx*space%dy)
    end do
    iterations = most_iterations
  end subroutine solve_dry_contact

  !> Moves one row along the direction; nodes that would pull leave the contact, those that overlap join it.
  pure subroutine advance(p, film, direction, covered, step, contact_grew)
    real(wp), intent(inout) :: p(:)
    real(wp), intent(in) :: film(:), direction(:), step
    logical, intent(in) :: covered(:)
    logical, intent(inout) :: contact_grew
    integer :: i

    do i = 1, size(p)
      if (p(i) > 0) p(i) = max(p(i) - step*direction(i), 0.0_wp)
      if (p(i) <= 0 .and. film(i) < 0 .and. covered(i)) then
        p(i) = -step*film(i)
        contact_grew = .true.
      end if
    end do
  end subroutine advance

end module dry_contact
