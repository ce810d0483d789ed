!> Surface temperature of a half-space that moves past the contact with one velocity, in the steady state.
!>
!> An instantaneous uniform heat source on a cell of the grid has, a time t later, the temperature
!>   dt/(rho c sqrt(pi kappa t)) X(x, t) Y(y, t),  X = [erf((x + dx/2 - u t)/w) - erf((x - dx/2 - u t)/w)]/2, Y alike,
!> on the surface, w = sqrt(4 kappa t) (Carslaw and Jaeger 1959, sec. 10.3; Jaeger 1942). The kernel of the
!> convolution is its integral over all past times, exact in three dimensions for any velocity and for none;
!> time is integrated by the trapezoidal rule in a variable in which the spot of heat grows, and moves by its
!> own size, uniformly.
module pyworm_moving_source
  use pyworm_convolution, only: grid_convolution, new_grid_convolution
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_bad_argument, status_no_memory
  implicit none(type, external)
  private

  public :: moving_body, new_moving_body

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Step of the trapezoidal rule in theta = ln t + U sqrt(t/kappa). Its error is about exp(-pi2/step) for a
  !> body at rest and exp(-(pi/step)2) for a fast one.
  real(wp), parameter :: step = 0.8_wp
  !> Extent of a spot in widths w: erfc(4) = 1.5e-8.
  real(wp), parameter :: reach = 4
  !> Width of a spot, in sizes of the window, from which on its temperature is uniform in the window.
  real(wp), parameter :: even = 300
  !> Fraction of the largest term at which the sums of early and late spots end.
  real(wp), parameter :: negligible = 1e-9_wp
  !> Number of spots added to the kernel together.
  integer, parameter :: batch = 32

  type, extends(heated_body) :: moving_body
    type(grid_convolution) :: response
  contains
    procedure :: rise
    procedure :: rise_transposed
  end type moving_body

contains

  !> Body of `conductivity` [W/(m K)] and `heat_capacity` rho c [J/(m3 K)] whose surface passes the grid with
  !> the velocity (u, v) [m/s]; points downstream of a source, in the direction of (u, v), are in its wake.
  subroutine new_moving_body(self, nx, ny, dx, dy, u, v, conductivity, heat_capacity, stat)
    type(moving_body), intent(inout) :: self
    integer, intent(in) :: nx, ny
    real(wp), intent(in) :: dx, dy, u, v, conductivity, heat_capacity
    integer, intent(out) :: stat
    real(wp), allocatable :: kernel(:, :)
    integer :: err

    stat = status_bad_argument
    if (nx < 2 .or. ny < 2 .or. .not. (dx > 0 .and. dy > 0 .and. conductivity > 0 .and. heat_capacity > 0)) return
    if (.not. abs(u) + abs(v) <= huge(1.0_wp)) return
    self%nx = nx
    self%ny = ny
    allocate (kernel(1 - nx:nx - 1, 1 - ny:ny - 1), stat=err)
    stat = status_no_memory
    if (err /= 0) return
    call integrate_spots(nx, ny, dx, dy, u, v, conductivity, conductivity/heat_capacity, kernel)
    self%own = kernel(0, 0)
    call new_grid_convolution(self%response, nx, ny, kernel, stat)
  end subroutine new_moving_body

  !> Temperature rise [K] under the flux `q` [W/m2].
  subroutine rise(self, q, temperature_rise)
    class(moving_body), intent(inout) :: self
    real(wp), intent(in) :: q(self%nx, self%ny)
    real(wp), intent(out) :: temperature_rise(self%nx, self%ny)

    call self%response%convolve(q, temperature_rise)
  end subroutine rise

  !> Transposed product of `rise` (`heated_surface`).
  subroutine rise_transposed(self, weight, by_flux)
    class(moving_body), intent(inout) :: self
    real(wp), intent(in) :: weight(self%nx, self%ny)
    real(wp), intent(out) :: by_flux(self%nx, self%ny)

    call self%response%convolve_transposed(weight, by_flux)
  end subroutine rise_transposed

  !> Temperature [K m2/W] at all offsets from a cell under unit flux. Time is parametrised by the depth
  !> sqrt(kappa t) [m].
  subroutine integrate_spots(nx, ny, dx, dy, u, v, conductivity, diffusivity, kernel)
    integer, intent(in) :: nx, ny
    real(wp), intent(in) :: dx, dy, u, v, conductivity, diffusivity
    real(wp), intent(out) :: kernel(1 - nx:nx - 1, 1 - ny:ny - 1)
    real(wp) :: along(1 - nx:nx - 1, batch), across(1 - ny:ny - 1, batch)
    integer, dimension(batch) :: from_x, to_x, from_y, to_y
    real(wp) :: speed, depth, first_depth
    integer :: spots, b, j
    logical :: gone, everywhere

    speed = hypot(u, v)/diffusivity
    first_depth = min(depth_within(dx, abs(u)/diffusivity), depth_within(dy, abs(v)/diffusivity))
    kernel = 0
    kernel(0, 0) = early_spots(speed, first_depth)
    depth = first_depth
    do
      do spots = 1, batch
        depth = depth_after(depth, speed, step)
        call spot_factor(nx, dx, u/diffusivity, depth, along(:, spots), from_x(spots), to_x(spots))
        call spot_factor(ny, dy, v/diffusivity, depth, across(:, spots), from_y(spots), to_y(spots))
        associate (factor => across(from_y(spots):to_y(spots), spots))
          factor = factor*weight(depth, speed)
        end associate
        gone = from_x(spots) > to_x(spots) .or. from_y(spots) > to_y(spots)
        everywhere = 2*depth > even*max(nx*dx, ny*dy)
        if (gone .or. everywhere) exit
      end do
      spots = min(spots, batch)
      !$omp parallel do private(b) schedule(static)
      do j = 1 - ny, ny - 1
        do b = 1, spots
          if (j < from_y(b) .or. j > to_y(b)) cycle
          kernel(from_x(b):to_x(b), j) = kernel(from_x(b):to_x(b), j) + across(j, b)*along(from_x(b):to_x(b), b)
        end do
      end do
      if (gone .or. everywhere) exit
    end do
    if (everywhere) kernel = kernel + dx*dy*late_spots(speed, depth)
    kernel = kernel*2/(conductivity*sqrt(pi))
  end subroutine integrate_spots

  !> Depth of the latest spot that lies within its cell, in one direction.
  pure real(wp) function depth_within(spacing, speed)
    real(wp), intent(in) :: spacing, speed

    depth_within = spacing/(2*reach + sqrt(4*reach**2 + 2*speed*spacing))
  end function depth_within

  !> Depth at which theta = 2 ln(depth) + speed depth is greater by `more`, by Newton's method for ln(depth).
  pure real(wp) function depth_after(depth, speed, more)
    real(wp), intent(in) :: depth, speed, more
    real(wp) :: growth
    integer :: iteration

    growth = more/(2 + speed*depth)
    do iteration = 1, 4
      depth_after = depth*exp(growth)
      growth = growth - (2*growth + speed*(depth_after - depth) - more)/(2 + speed*depth_after)
    end do
    depth_after = depth*exp(growth)
  end function depth_after

  !> Step of depth that one step of theta makes.
  pure real(wp) function weight(depth, speed)
    real(wp), intent(in) :: depth, speed

    weight = step/(2/depth + speed)
  end function weight

  !> Sum of the spots up to a depth, which lie within their cell.
  pure real(wp) function early_spots(speed, depth)
    real(wp), intent(in) :: speed, depth
    real(wp) :: here

    early_spots = 0
    here = depth
    do while (here > negligible*depth)
      early_spots = early_spots + weight(here, speed)
      here = depth_after(here, speed, -step)
    end do
  end function early_spots

  !> Sum of the spots after a depth, over the area of a cell; they are even over the window, and leave it if
  !> they move.
  pure real(wp) function late_spots(speed, depth)
    real(wp), intent(in) :: speed, depth
    real(wp) :: here

    late_spots = 0
    here = depth_after(depth, speed, step)
    do while (here < depth/negligible .and. speed*here/2 < 2*reach)
      late_spots = late_spots + weight(here, speed)*exp(-(speed*here/2)**2)/(4*pi*here**2)
      here = depth_after(here, speed, step)
    end do
  end function late_spots

  !> Factor X or Y of a spot at offsets `from` to `to`, beyond which it is negligible; an empty range if the
  !> spot has left the window.
  pure subroutine spot_factor(n, spacing, speed, depth, factor, from, to)
    integer, intent(in) :: n
    real(wp), intent(in) :: spacing, speed, depth
    real(wp), intent(inout) :: factor(1 - n:)
    integer, intent(out) :: from, to
    real(wp) :: centre, before, after
    integer :: i

    ! at the age t a spot is a Gaussian of variance 2 kappa t about U t, here averaged over the cells
    centre = speed*depth**2
    from = max(1 - n, ceiling((centre - 2*reach*depth)/spacing - 0.5_wp))
    to = min(n - 1, floor((centre + 2*reach*depth)/spacing + 0.5_wp))
    after = erf(((from - 0.5_wp)*spacing - centre)/(2*depth))
    do i = from, to
      before = after
      after = erf(((i + 0.5_wp)*spacing - centre)/(2*depth))
      factor(i) = (after - before)/2
    end do
  end subroutine spot_factor

end module pyworm_moving_source
