!> What a surface is warmer than by steady conduction, since it was heated by other fluxes on its way through the contact.
!>
!> Steady conduction takes the present flux all along the way. With q the flux into a body, u its velocity and e^2 = k rho c,
!>
!>   rise - steady rise = 1/(sqrt(pi) e) int_0 [q_s(X(s), t - s) - q_s(x - u s, t)]/sqrt(s) ds,
!>
!> X(s) being where the place was a time s ago, and q_s the flux averaged by a Gaussian of variance 2 kappa s, as its heat has
!> spread along the surface in the time s (Carslaw and Jaeger 1959, section 10.2; `pyworm/solver/transient/heat_memory.py` has the
!> reasons). The flux is linear in time between instants of growing age, and the bracket along the path over two cells.
module pyworm_residual_rise
  use pyworm_kinds, only: wp
  use pyworm_lapack, only: dgemm
  use pyworm_remembered_flux, only: flux_reading, moving_axes, remembered_flux, surface_motion
  implicit none(type, external)
  private

  public :: surface_past, residual_rise, chosen_times, onward_flux

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Ratio of successive ages.
  real(wp), parameter :: age_ratio = 1.4_wp
  !> Instants at least, in a passage of a surface through the grid: some six on its way through the contact.
  integer, parameter :: ages_per_passage = 16
  !> Widths of the Gaussian in which heat spreads up to which it counts.
  real(wp), parameter :: spreading_widths = 3
  !> Cells of the grid, at most, that a surface passes between two readings of the flux along its path: the shortest wave of the
  !> grid. With 5 a disturbed division of heat between two surfaces grows 70-fold, with 2 and 1 it decays at once.
  real(wp), parameter :: cells_per_reading = 2
  !> Age that no surface reaches [s].
  real(wp), parameter :: never = huge(1.0_wp)

  !> A body's surface at the present, the first time, and before.
  type :: surface_past
    !> Age of each time [s] and velocity at the contact point then (component, time) [m/s].
    real(wp), allocatable :: ages(:), velocities(:, :)
    !> Numbers of the times whose fluxes count, the present the first (`chosen_times`), those fluxes [W/m2], and their grids.
    integer, allocatable :: chosen(:)
    real(wp), allocatable :: flux(:, :, :)
    type(moving_axes), allocatable :: axes(:)
  end type surface_past

contains

  !> Numbers of the times whose fluxes count for a surface, of growing distance, up to those so long ago that their heat has left
  !> the grid of `nodes` and `spacing` [m]. The first of `ages` [s] is the present, which counts.
  pure function chosen_times(ages, nodes, spacing, velocity, diffusivity) result(chosen)
    real(wp), intent(in) :: ages(:), spacing(2), velocity(2), diffusivity
    integer, intent(in) :: nodes(2)
    integer, allocatable :: chosen(:)
    integer :: numbers(size(ages)), count, k
    real(wp) :: passage, oldest, last, longer

    passage = time_through(spacing*max(nodes - 1, 1), velocity, nodes)
    oldest = oldest_age(passage, norm2(velocity), diffusivity)
    numbers(:2) = [1, 2]
    count = 2
    do k = 3, size(ages)
      last = ages(numbers(count))
      if (last > oldest) exit
      longer = merge(passage/ages_per_passage, never, last < passage)
      if (ages(k) < min(age_ratio*last, last + longer)) cycle
      count = count + 1
      numbers(count) = k
    end do
    chosen = numbers(:count)
  end function chosen_times

  !> Time in which a surface passes lengths along both directions [s]; a line has one.
  pure real(wp) function time_through(lengths, velocity, nodes)
    real(wp), intent(in) :: lengths(2), velocity(2)
    integer, intent(in) :: nodes(2)
    real(wp) :: rate

    rate = maxval(abs(velocity)/lengths, mask=nodes > 1)
    time_through = never
    if (rate > 0) time_through = 1/rate
  end function time_through

  !> Age at which a surface has carried heat out of a grid, that which spreads against its motion, too [s]: the root of
  !> u s - n sqrt(2 kappa s) = u T, T being the time of its way through the grid.
  pure real(wp) function oldest_age(passage, speed, diffusivity)
    real(wp), intent(in) :: passage, speed, diffusivity
    real(wp) :: spreading

    oldest_age = never
    if (.not. passage < never) return
    spreading = spreading_widths*sqrt(2*diffusivity)
    oldest_age = ((spreading + sqrt(spreading**2 + 4*speed**2*passage))/(2*speed))**2
  end function oldest_age

  !> Present flux into both bodies [W/m2] by the last two, `ahead` being the time since the last over that between them, zero with
  !> one alone: their sum over both bodies extrapolated, divided as the last was.
  !>
  !> A thin film makes both walls nearly equally warm, and so decides how the heat is divided by what the surfaces remember. With
  !> the flux of each body extrapolated by itself, a deviation of the division that is multiplied by z in a time step satisfies
  !> (1 - 1/z)^2 = -S(1/z), S > 0, which has a root with |z| > 1: at phase 0.9 of a worm gear with films of half the roughness
  !> temperatures swung by 120 K. Taken from the last step it satisfies 1 - 1/z = -S(1/z), whose roots are stable. The sum
  !> follows from load and sliding and is not fed back.
  elemental subroutine onward_flux(last_1, last_2, before_1, before_2, ahead, flux_1, flux_2)
    real(wp), intent(in) :: last_1, last_2, before_1, before_2, ahead
    real(wp), intent(out) :: flux_1, flux_2
    real(wp) :: whole, change, share

    whole = abs(last_1) + abs(last_2)
    change = max(ahead*((last_1 + last_2) - (before_1 + before_2)), -abs(last_1 + last_2))
    share = 0.5_wp
    if (whole > 0) share = abs(last_1)/whole
    flux_1 = last_1 + change*share
    if (whole > 0) share = abs(last_2)/whole
    flux_2 = last_2 + change*share
  end subroutine onward_flux

  !> Rise [K] at the nodes of the present grid over that of steady conduction, of a body of `diffusivity` [m2/s] and
  !> `inertia` k rho c [W2 s/(m4 K2)]; `turning` is the angular velocity of the axes [rad/s], (u, v) the
  !> velocity of the surface at the nodes [m/s].
  subroutine residual_rise(past, diffusivity, inertia, turning, u, v, rise)
    type(surface_past), intent(in) :: past
    real(wp), intent(in) :: diffusivity, inertia, turning, u(:, :), v(:, :)
    real(wp), contiguous, intent(out) :: rise(:, :)
    real(wp), allocatable :: flux(:, :, :), present_flux(:, :, :)
    type(flux_reading), allocatable :: readings(:)
    type(moving_axes) :: axes(size(past%chosen))
    real(wp) :: width, x(size(u, 1)), y(size(u, 2)), ages(size(past%chosen))
    integer :: rim(2), outer(2), nodes(2), k

    nodes = shape(u)
    axes = past%axes
    x = [(axes(1)%first(1) + axes(1)%spacing(1)*(k - 1), k=1, nodes(1))]
    y = [(axes(1)%first(2) + axes(1)%spacing(2)*(k - 1), k=1, nodes(2))]
    ages = past%ages(past%chosen)
    width = sqrt(2*diffusivity*ages(size(ages)))
    ! before the age of a surface at rest its heat may have spread farther than any integer tells
    rim = ceiling(min(width/axes(1)%spacing, real(nodes, wp)))
    rim = min(rim, nodes/2)
    outer = merge(rim + 1, 0, nodes > 1)
    allocate (flux(nodes(1) + 2*outer(1), nodes(2) + 2*outer(2), size(ages)), source=0.0_wp)
    allocate (present_flux, source=flux)
    do k = 1, size(ages)
      width = sqrt(2*diffusivity*ages(k))
      call spread_flux(past%flux(:, :, k), axes(k)%spacing, width, rim, flux(:, :, k))
      call spread_flux(past%flux(:, :, 1), axes(1)%spacing, width, rim, present_flux(:, :, k))
      axes(k)%first = axes(k)%first - outer*axes(k)%spacing
    end do
    call read_along_path(past, time_through(cells_per_reading*past%axes(1)%spacing, past%velocities(:, 1), nodes), readings)
    call remembered_flux(flux, present_flux, axes, readings, surface_motion(turning, past%velocities(:, 1)), x, y, u, v, rise)
    rise = rise/sqrt(pi*inertia)
  end subroutine residual_rise

  !> A flux averaged by a Gaussian of `width` [m] along each axis, on a rim of further nodes, too. The outermost nodes, one more on
  !> each side, stay zero, so that it ends continuously; a line has neither across.
  subroutine spread_flux(flux, spacing, width, rim, spread)
    real(wp), intent(in) :: flux(:, :), spacing(2), width
    integer, intent(in) :: rim(2)
    real(wp), contiguous, intent(inout) :: spread(:, :)
    real(wp), allocatable :: along(:, :), means_x(:, :), means_y(:, :), whole(:, :)
    integer :: nx, ny, mx, my

    nx = size(flux, 1)
    ny = size(flux, 2)
    if (.not. width > 0) then
      mx = rim(1) + 1
      my = merge(rim(2) + 1, 0, ny > 1)
      spread(mx + 1:mx + nx, my + 1:my + ny) = flux
      return
    end if
    mx = nx + 2*rim(1)
    means_x = means_of(nx, rim(1), spacing(1), width)
    allocate (along(mx, ny))
    call dgemm('n', 'n', mx, ny, nx, 1.0_wp, means_x, mx, flux, nx, 0.0_wp, along, mx)
    if (ny == 1) then
      spread(2:mx + 1, :) = along
      return
    end if
    my = ny + 2*rim(2)
    means_y = means_of(ny, rim(2), spacing(2), width)
    allocate (whole(mx, my))
    call dgemm('n', 't', mx, my, ny, 1.0_wp, along, mx, means_y, my, 0.0_wp, whole, mx)
    spread(2:mx + 1, 2:my + 1) = whole
  end subroutine spread_flux

  !> Shares of the flux of `nodes` in its means at these and a rim of nodes on each side, (mean, node).
  pure function means_of(nodes, rim, spacing, width) result(means)
    integer, intent(in) :: nodes, rim
    real(wp), intent(in) :: spacing, width
    real(wp) :: means(nodes + 2*rim, nodes)
    real(wp) :: ends(1 - nodes - rim:nodes + rim), shares(1 - nodes - rim:nodes + rim - 1)
    integer :: i, j

    ends = [(erf((j - 0.5_wp)*spacing/(sqrt(2.0_wp)*width)), j=1 - nodes - rim, nodes + rim)]
    shares = (ends(2 - nodes - rim:) - ends(:nodes + rim - 1))/2
    do j = 1, nodes
      means(:, j) = [(shares(i - j - rim), i=1, nodes + 2*rim)]
    end do
  end function means_of

  !> Readings of the flux up to each of the chosen ages, not more than `longest` apart [s].
  pure subroutine read_along_path(past, longest, readings)
    type(surface_past), intent(in) :: past
    real(wp), intent(in) :: longest
    type(flux_reading), allocatable, intent(out) :: readings(:)
    real(wp), allocatable :: weights(:)
    integer :: parts(size(past%chosen) - 1), interval, part, k

    associate (ages => past%ages(past%chosen))
      parts = [(max(1, ceiling((ages(k + 1) - ages(k))/longest)), k=1, size(parts))]
      allocate (readings(sum(parts)))
      k = 0
      do interval = 1, size(parts)
        do part = 1, parts(interval)
          k = k + 1
          readings(k)%share = real(part, wp)/parts(interval)
          readings(k)%age = ages(interval) + readings(k)%share*(ages(interval + 1) - ages(interval))
          readings(k)%interval = interval
          readings(k)%way = way_since(past, readings(k)%age)
        end do
      end do
    end associate
    weights = weights_of(readings%age)
    readings%weight = weights
  end subroutine read_along_path

  !> Weights of a function's values at some ages in its integral over 1/sqrt(age) [sqrt(s)]: it is zero at age zero and linear
  !> between the ages.
  pure function weights_of(ages) result(weights)
    real(wp), intent(in) :: ages(:)
    real(wp) :: weights(size(ages))
    real(wp), dimension(size(ages)) :: begins, whole, first, late

    begins = [0.0_wp, ages(:size(ages) - 1)]
    whole = 2*(sqrt(ages) - sqrt(begins))
    first = 2/3.0_wp*(sqrt(ages)**3 - sqrt(begins)**3)
    late = (first - begins*whole)/(ages - begins)
    weights = late + [whole(2:) - late(2:), 0.0_wp]
  end function weights_of

  !> Way of the surface through the contact point since an age [m], its velocity linear between the times.
  pure function way_since(past, age) result(way)
    type(surface_past), intent(in) :: past
    real(wp), intent(in) :: age
    real(wp) :: way(2)
    real(wp) :: step
    integer :: k

    way = 0
    do k = 2, past%chosen(size(past%chosen))
      step = past%ages(k) - past%ages(k - 1)
      associate (part => step*(past%velocities(:, k) + past%velocities(:, k - 1))/2)
        if (age <= past%ages(k)) then
          way = way + part*((age - past%ages(k - 1))/step)
          return
        end if
        way = way + part
      end associate
    end do
  end function way_since

end module pyworm_residual_rise
