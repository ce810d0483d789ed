!> Flux that the places of a surface met on their way through a contact, against the present one along a steady way.
module pyworm_remembered_flux
  use pyworm_kinds, only: wp
  use pyworm_linear_interpolation, only: linear_at
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
  !> X(s) is the place of the surface a time s ago, in axes that have turned since:
  !> of the way of the contact point, and of what the velocity there, `at_origin`, differs from that of the node (`motion`). Between
  !> two times the flux is linear. `flux` has that of each time along its last dimension, the present first, at the nodes of
  !> a grid with `axes` [W/m2], `present` the present one, on its grid; both as their heat has spread along the surface
  !> since that time. `x`, `y` are places of the nodes, `u`, `v` the surface's velocity there.
  pure subroutine remembered_flux(flux, present, axes, readings, motion, x, y, u, v, integral)
    real(wp), intent(in) :: flux(:, :, :), present(:, :, :)
    type(moving_axes), intent(in) :: axes(:)
    type(flux_reading), intent(in) :: readings(:)
    type(surface_motion), intent(in) :: motion
    real(wp), intent(in) :: x(:), y(:), u(:, :), v(:, :)
    real(wp), intent(out) :: integral(:, :)
    real(wp) :: c, s, place(2), steady(2), then(2), more
    integer :: i, j, k

    integral = 0
    do k = 1, size(readings)
      associate (read => readings(k))
        c = cos(motion%turning*read%age)
        s = sin(motion%turning*read%age)
        do j = 1, size(integral, 2)
          do i = 1, size(integral, 1)
            steady = [x(i) - u(i, j)*read%age, y(j) - v(i, j)*read%age]
            place = steady + motion%at_origin*read%age - read%way
            then = [c*place(1) - s*place(2), s*place(1) + c*place(2)]
            associate (before => read%interval + 1, after => read%interval)
              more = read%share*(at(flux(:, :, before), axes(before), then) - at(present(:, :, before), axes(1), steady))
              if (read%share < 1) more = more + (1 - read%share)*(at(flux(:, :, after), axes(after), then) &
                - at(present(:, :, after), axes(1), steady))
            end associate
            integral(i, j) = integral(i, j) + read%weight*more
          end do
        end do
      end associate
    end do
  end subroutine remembered_flux

  !> Flux of a time at a place.
  pure function at(flux, axes, place) result(met)
    real(wp), intent(in) :: flux(:, :), place(2)
    type(moving_axes), intent(in) :: axes
    real(wp) :: met
    real(wp) :: node(2)

    node = (place - axes%first)/axes%spacing
    met = linear_at(flux, node(1), node(2))
  end function at

end module pyworm_remembered_flux
