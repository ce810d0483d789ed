!> Contact of a periodic rough surface with a rigid flat at a given separation, elastic up to a hardness.
!>
!> Pressure 0 <= p <= hardness minimises complementary energy: an elastic half-space whose asperities yield without
!> hardening (Tian and Bhushan 1996, J. Tribol. 118:33). As in Polonsky and Keer (1999, Wear 231:206) the nodes at either
!> bound are found in the iteration of conjugate gradients: after each step nodes with the wrong sign of the gap leave their
!> bound. Gradients are preconditioned with the stiffness of the whole surface (`constrained_gradients` has more on that).
!> The separation and not the load is given, since where most of the contact yields a load leaves it hardly determined.
module pyworm_cell_contact
  use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
  use pyworm_elastic_cell, only: elastic_surface
  use pyworm_interruption, only: interrupted
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_bad_argument, status_interrupted, status_no_memory, status_not_converged, &
    status_not_finite
  use pyworm_vectors, only: dot
  implicit none(type, external)
  private

  public :: press_flat

  !> Largest gap of the wrong sign at a bound, over the mean gap left between bounds.
  real(wp), parameter :: worst_over_mean = 10

contains

  !> Finds the pressure p [Pa] between a surface of `height` [m] and a rigid flat at `separation` [m] above height zero.
  !>
  !> On entry p is a guess; fields are (nx, ny), as vectors. `gap` [m] is that between the deformed surface and the flat,
  !> negative where material has yielded. Converged when it is `tolerance` [m] in the mean square where the pressure lies
  !> between its bounds.
  subroutine press_flat(surface, height, separation, hardness, tolerance, most_iterations, p, gap, iterations, stat)
    type(elastic_surface), intent(inout) :: surface
    integer, intent(in) :: most_iterations
    real(wp), intent(in) :: height(surface%nx*surface%ny), separation, hardness, tolerance
    real(wp), intent(inout) :: p(surface%nx*surface%ny)
    real(wp), intent(out) :: gap(surface%nx*surface%ny)
    integer, intent(out) :: iterations, stat
    real(wp), allocatable :: work(:, :)
    logical, allocatable :: free(:)
    real(wp) :: slope, last_slope, beta
    integer :: err

    iterations = 0
    gap = 0
    stat = status_bad_argument
    if (.not. (hardness > 0 .and. tolerance > 0)) return
    stat = status_not_finite
    if (.not. (all(ieee_is_finite(p)) .and. all(ieee_is_finite(height)) .and. ieee_is_finite(separation))) return
    stat = status_no_memory
    allocate (work(size(p), 5), source=0.0_wp, stat=err)
    if (err == 0) allocate (free(size(p)), stat=err)
    if (err /= 0) return
    last_slope = 1
    p = min(max(p, 0.0_wp), hardness)

    associate (residual => work(:, 1), last_residual => work(:, 2), correction => work(:, 3), direction => work(:, 4), &
      response => work(:, 5))
      do iterations = 0, most_iterations
        call surface%deflection(p, gap)
        gap = gap + separation - height
        if (closed(p, gap, hardness, tolerance)) then
          stat = status_ok
          return
        end if
        if (iterations == most_iterations) exit
        if (interrupted()) then
          stat = status_interrupted
          return
        end if

        free = (p > 0 .and. p < hardness) .or. (p <= 0 .and. gap < 0) .or. (p >= hardness .and. gap > 0)
        residual = merge(gap, 0.0_wp, free)
        call surface%pressure(residual, correction)
        correction = merge(correction, 0.0_wp, free)
        slope = dot(residual, correction)
        ! where nodes joined or left, Polak and Ribiere's beta damps the directions before
        beta = max(0.0_wp, slope - dot(last_residual, correction))/last_slope
        direction = correction + beta*merge(direction, 0.0_wp, free)
        if (dot(residual, direction) <= 0) direction = correction
        last_residual = residual
        last_slope = slope

        call surface%deflection(direction, response)
        p = min(max(p - dot(residual, direction)/dot(response, direction)*direction, 0.0_wp), hardness)
      end do
    end associate
    stat = status_not_converged
  end subroutine press_flat

  !> Whether the gap is zero where the pressure lies between its bounds, and of the right sign where it is at one.
  pure logical function closed(p, gap, hardness, tolerance)
    real(wp), intent(in) :: p(:), gap(:), hardness, tolerance
    real(wp) :: squares
    integer :: i, count

    closed = .false.
    squares = 0
    count = 0
    do i = 1, size(p)
      if (p(i) > 0 .and. p(i) < hardness) then
        squares = squares + gap(i)**2
        count = count + 1
      else if (p(i) <= 0) then
        if (.not. gap(i) >= -worst_over_mean*tolerance) return
      else if (.not. gap(i) <= worst_over_mean*tolerance) then
        return
      end if
    end do
    closed = squares <= count*tolerance**2
  end function closed

end module pyworm_cell_contact
