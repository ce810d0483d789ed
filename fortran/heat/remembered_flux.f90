!> Flux that the places of a surface met on their way through a contact, against the present one along a steady way.
module pyworm_remembered_flux
  use pyworm_kinds, only: wp
  use pyworm_linear_interpolation, only: add_linear
  implicit none(type, external)
  private

  public :: flux_reading, moving_axes, remembered_flux, surface_motion

  !> Axes of the grid at one time: first node and spacing along each direction [m].
  type :: moving_axes
    real(wp) :: first(2), spacing(2)
  end type moving_axes

  !> An age of the heat at which its flux is read, and the weight of what is read.
  type :: flux_reading
    !> Time before the present [s].
    real(wp) :: age
    !> Weight in the integral over the age [sqrt(s)].
    real(wp) :: weight
    !> Number of the time of the history that ends the interval of time that the age lies in; the part of that
    !> interval before its end.
    integer :: interval
    real(wp) :: share
    !> Way of the surface through the contact point since then [m].
    real(wp) :: way(2)
  end type flux_reading

  !> Motion of the surface at the contact point.
  type :: surface_motion
    !> Angular velocity of the axes [rad/s], and velocity there [m/s].
    real(wp) :: turning, at_origin(2)
  end type surface_motion

contains

  !> Integral over the age s of [q(X(s), t - s) - q(x - u s, t)]/sqrt(s) at each node of a grid [W sqrt(s)/m2].
  !>
  !> X(s) is the place of the surface a time s ago, in axes that have turned since: of the way of the contact point, and of
  !> what the velocity there, `at_origin`, differs from that of the node (`motion`). Between two times the flux is linear.
  !> `flux` has that of each time along its last dimension, the present first, at the nodes of a grid with `axes` [W/m2],
  !> `present` the present one, on its grid; both as their heat has spread along the surface since that time. `x`, `y` are
  !> places of the nodes, `u`, `v` the surface's velocity there.
  pure subroutine remembered_flux(flux, present, axes, readings, motion, x, y, u, v, integral)
    real(wp), contiguous, intent(in) :: flux(:, :, :), present(:, :, :)
    type(moving_axes), intent(in) :: axes(:)
    type(flux_reading), intent(in) :: readings(:)
    type(surface_motion), intent(in) :: motion
    real(wp), intent(in) :: x(:), y(:), u(:, :), v(:, :)
    real(wp), contiguous, intent(out) :: integral(:, :)
    real(wp), allocatable :: steady(:, :, :), then(:, :, :)
    integer :: k

    allocate (steady(2, size(x), size(y)), then(2, size(x), size(y)))
    integral = 0
    do k = 1, size(readings)
      call find_places(readings(k), motion, x, y, u, v, steady, then)
      associate (before => readings(k)%interval + 1, after => readings(k)%interval, share => readings(k)%share, &
          weight => readings(k)%weight)
        call add(share*present(:, :, before) + (1 - share)*present(:, :, after), axes(1), -weight, steady, integral)
        call add(flux(:, :, before), axes(before), weight*share, then, integral)
        if (share < 1) call add(flux(:, :, after), axes(after), weight*(1 - share), then, integral)
      end associate
    end do
  end subroutine remembered_flux

  !> Places of the nodes' surface a time ago, by the steady way, and in the axes of that time by the way since then, (2, nx, ny).
  pure subroutine find_places(reading, motion, x, y, u, v, steady, then)
    type(flux_reading), intent(in) :: reading
    type(surface_motion), intent(in) :: motion
    real(wp), intent(in) :: x(:), y(:), u(:, :), v(:, :)
    real(wp), contiguous, intent(out) :: steady(:, :, :), then(:, :, :)
    real(wp) :: c, s, onward(2), place(2)
    integer :: i, j

    c = cos(motion%turning*reading%age)
    s = sin(motion%turning*reading%age)
    onward = motion%at_origin*reading%age - reading%way
    do j = 1, size(y)
      do i = 1, size(x)
        steady(:, i, j) = [x(i) - u(i, j)*reading%age, y(j) - v(i, j)*reading%age]
        place = steady(:, i, j) + onward
        then(:, i, j) = [c*place(1) - s*place(2), s*place(1) + c*place(2)]
      end do
    end do
  end subroutine find_places

  !> Adds a flux at some places, times a weight.
  pure subroutine add(flux, axes, weight, places, integral)
    real(wp), contiguous, intent(in) :: flux(:, :), places(:, :, :)
    type(moving_axes), intent(in) :: axes
    real(wp), intent(in) :: weight
    real(wp), contiguous, intent(inout) :: integral(:, :)

    call add_linear(flux, axes%first, axes%spacing, weight, places, integral)
  end subroutine add

end module pyworm_remembered_flux
