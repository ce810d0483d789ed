!> Frictionless dry contact of two half-spaces with an arbitrary gap under a given load.
!>
!> Nested iteration on grids of halving spacing, each started from the pressure of the one before, so that only
!> the boundary of the contact changes; conjugate gradients with bounds on each (`constrained_gradients`).
module pyworm_dry_contact
  use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
  use pyworm_coated_surface, only: elastic_layer
  use pyworm_constrained_gradients, only: dry_bodies, close_gap
  use pyworm_half_space, only: elastic_half_space, new_half_space
  use pyworm_kinds, only: wp
  use pyworm_pressure_refinement, only: refine_pressure
  use pyworm_status, only: status_ok, status_bad_argument, status_not_converged, status_not_finite
  use pyworm_vectors, only: total
  implicit none(type, external)
  private

  public :: solve_dry_contact

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Least number of nodes of the coarsest grid along each direction.
  integer, parameter :: fewest_nodes = 12
  !> Tolerance of coarser grids, which need not be more accurate than their spacing allows.
  real(wp), parameter :: coarse_tolerance = 1e-5_wp
  integer, parameter :: most_coarse_iterations = 100

contains

  !> Finds the pressure p [Pa] that carries `load` [N] and closes the gap [m] at one approach [m].
  !>
  !> On entry p >= 0 is an initial guess with a positive sum. `covered` is true where both bodies exist.
  !> Converged when the residual gap in the contact is `tolerance` times the approach, in the mean square, and no
  !> node outside overlaps. `iterations` counts those on the grid itself, not those on coarser ones.
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
    real(wp), allocatable :: solid_gap(:, :)
    real(wp) :: modulus

    approach = 0
    iterations = 0
    where (.not. covered) p = 0
    stat = status_not_finite
    if (.not. (ieee_is_finite(load) .and. all(ieee_is_finite(p)))) return
    if (.not. all(ieee_is_finite(gap) .or. .not. covered)) return
    stat = status_bad_argument
    if (load <= 0) return
    if (total(p) <= 0) return

    ! beyond a body its gap is arbitrary and may not be finite
    solid_gap = merge(gap, 0.0_wp, covered)
    modulus = reduced_modulus(space)
    call start_from_coarser(solid_gap, covered, [space%dx, space%dy], modulus, space%layers, load, tolerance, p, stat)
    if (stat /= status_ok) return
    call close_gap(space, dry_bodies(reshape(solid_gap, [size(gap)]), reshape(covered, [size(gap)]), modulus, load), &
      tolerance, most_iterations, p, approach, iterations, stat)
  end subroutine solve_dry_contact

  !> Initial guess that carries the load, from the contact on a grid of twice the spacing.
  recursive subroutine start_from_coarser(gap, covered, spacing, modulus, layers, load, tolerance, p, stat)
    real(wp), contiguous, intent(in) :: gap(:, :)
    logical, contiguous, intent(in) :: covered(:, :)
    real(wp), intent(in) :: spacing(2), modulus, load, tolerance
    type(elastic_layer), intent(in) :: layers(2)
    real(wp), contiguous, intent(inout) :: p(:, :)
    integer, intent(out) :: stat
    type(elastic_half_space) :: space
    real(wp), allocatable :: coarse_gap(:, :), coarse_p(:, :)
    logical, allocatable :: coarse_covered(:, :)
    real(wp) :: approach
    integer :: iterations

    stat = status_ok
    allocate (coarse_covered, source=covered(::2, ::2)) ! assigned, gfortran warns of bounds that it does not use
    if (minval(shape(coarse_covered)) >= fewest_nodes .and. any(coarse_covered)) then
      coarse_gap = gap(::2, ::2)
      coarse_p = merge(p(::2, ::2), 0.0_wp, coarse_covered)
      ! a guess may fall between the nodes
      if (.not. total(coarse_p) > 0) coarse_p = merge(1.0_wp, 0.0_wp, coarse_covered)
      call start_from_coarser(coarse_gap, coarse_covered, 2*spacing, modulus, layers, load, tolerance, coarse_p, stat)
      if (stat /= status_ok) return
      call new_half_space(space, size(coarse_gap, 1), size(coarse_gap, 2), 2*spacing(1), 2*spacing(2), modulus, &
        stat, layers)
      if (stat /= status_ok) return
      call close_gap(space, dry_bodies(reshape(coarse_gap, [size(coarse_gap)]), reshape(coarse_covered, &
        [size(coarse_gap)]), modulus, load), max(tolerance, coarse_tolerance), most_coarse_iterations, coarse_p, approach, &
        iterations, stat)
      if (stat == status_not_converged) stat = status_ok
      if (stat /= status_ok) return
      call refine_pressure(coarse_p, p)
      where (.not. covered) p = 0
    end if
    p = p*load/(total(p)*spacing(1)*spacing(2))
  end subroutine start_from_coarser

  !> E' [Pa] of a half-space, from its deflection at the centre of one rectangle.
  pure real(wp) function reduced_modulus(space)
    type(elastic_half_space), intent(in) :: space

    associate (dx => space%dx, dy => space%dy)
      reduced_modulus = 4*(dx*asinh(dy/dx) + dy*asinh(dx/dy))/(pi*space%centre)
    end associate
  end function reduced_modulus

end module pyworm_dry_contact
