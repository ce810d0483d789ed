!> Flux that places of a surface met, against fluxes that are linear in place and time.
program test_remembered_flux
  use, intrinsic :: ieee_arithmetic, only: ieee_get_halting_mode, ieee_invalid, ieee_quiet_nan, ieee_set_halting_mode, ieee_value
  use pyworm_kinds, only: wp
  use pyworm_linear_interpolation, only: add_linear
  use pyworm_remembered_flux, only: flux_reading, moving_axes, remembered_flux, surface_motion
  use tap, only: check, close_to, done
  implicit none(type, external)

  integer, parameter :: n = 21

  type :: flux_history
    real(wp) :: flux(n, n, 3), present(n, n, 3)
    type(moving_axes) :: axes(3)
  end type flux_history

  real(wp), parameter :: dx = 0.1_wp, dy = 0.05_wp, age = 0.3_wp, u = 0.7_wp, v = -0.2_wp

  call bilinear()
  call steady_way()
  call changing_flux()
  call turned_axes()
  call left_grid()
  call spread_flux()
  call done()

contains

  !> A bilinear field is met between its nodes, and zero beyond them.
  subroutine bilinear()
    real(wp) :: field(7, 4)
    integer :: i, j

    field = reshape([((2.0_wp*i - j + 0.5_wp*i*j + 1, i=0, 6), j=0, 3)], [7, 4])
    call close_to(linear_at(field, 2.25_wp, 1.5_wp), 2*2.25_wp - 1.5_wp + 0.5_wp*2.25_wp*1.5_wp + 1, 1e-13_wp, "between nodes")
    call close_to(linear_at(field, 6.0_wp, 3.0_wp), 19.0_wp, 1e-13_wp, "the last node")
    call close_to(linear_at(field, 0.0_wp, 0.0_wp), 1.0_wp, 1e-13_wp, "the first node")
    call check(linear_at(field, -0.1_wp, 1.0_wp) == 0 .and. linear_at(field, 6.1_wp, 1.0_wp) == 0, "beyond along x")
    call check(linear_at(field, 3.0_wp, 3.1_wp) == 0 .and. linear_at(field, 3.0_wp, -1e-9_wp) == 0, "beyond along y")
    call close_to(linear_at(field(:, 1:1), 1.5_wp, 0.0_wp), 4.0_wp, 1e-13_wp, "along a line")
    call check(at_no_number(field) == 0, "not a number")
  end subroutine bilinear

  !> A field at one place, in nodes from the first.
  real(wp) function linear_at(field, column, row)
    real(wp), intent(in) :: field(:, :), column, row
    real(wp) :: value(1, 1)

    value = 0
    call add_linear(field, [0.0_wp, 0.0_wp], [1.0_wp, 1.0_wp], 1.0_wp, reshape([column, row], [2, 1, 1]), value)
    linear_at = value(1, 1)
  end function linear_at

  !> A field at a place that is no number; a build that traps such comparisons is not to end by this one.
  real(wp) function at_no_number(field)
    real(wp), intent(in) :: field(:, :)
    logical :: halts

    call ieee_get_halting_mode(ieee_invalid, halts)
    call ieee_set_halting_mode(ieee_invalid, .false.)
    at_no_number = linear_at(field, ieee_value(1.0_wp, ieee_quiet_nan), 1.0_wp)
    call ieee_set_halting_mode(ieee_invalid, halts)
  end function at_no_number

  !> q = time + 3 x - 2 y of a time on a grid moved by `shift`; of the present, of a time `age` before and twice that.
  function history(shift) result(of)
    real(wp), intent(in) :: shift(2)
    type(flux_history) :: of
    integer :: i, j, k

    do k = 1, 3
      of%axes(k) = moving_axes(-[dx, dy]*(n - 1)/2 + (k - 1)*shift, [dx, dy])
      do j = 1, n
        do i = 1, n
          of%flux(i, j, k) = flux_at(of%axes(k)%first(1) + (i - 1)*dx, of%axes(k)%first(2) + (j - 1)*dy, (k - 1)*age)
        end do
      end do
    end do
    of%present = spread(of%flux(:, :, 1), 3, 3)
  end function history

  pure function flux_at(x, y, before) result(flux)
    real(wp), intent(in) :: x, y, before
    real(wp) :: flux

    flux = 10 - before + 3*x - 2*y
  end function flux_at

  !> The integral at two nodes of one reading.
  function one_of(of, reading, turning, at_origin) result(integral)
    type(flux_history), intent(in) :: of
    type(flux_reading), intent(in) :: reading
    real(wp), intent(in) :: turning, at_origin(2)
    real(wp) :: integral(2)
    real(wp) :: found(2, 1), along(2, 1), across(2, 1)

    along = u
    across = v
    call remembered_flux(of%flux, of%present, of%axes, [reading], surface_motion(turning, at_origin), &
      [0.0_wp, 0.25_wp], [0.1_wp], along, across, found)
    integral = found(:, 1)
  end function one_of

  !> A flux that has stayed as it is, met on the way of steady motion, adds nothing.
  subroutine steady_way()
    type(flux_history) :: of
    real(wp) :: found(2)

    of = history([0.0_wp, 0.0_wp])
    of%flux(:, :, 2) = of%flux(:, :, 1)
    found = one_of(of, flux_reading(age, 2.0_wp, 1, 1.0_wp, [u, v]*age), 0.0_wp, [u, v])
    call close_to(maxval(abs(found)), 0.0_wp, 1e-13_wp, "steady motion under a steady flux")
  end subroutine steady_way

  !> Between two times, on grids that move, and on a way that was half as long.
  subroutine changing_flux()
    real(wp) :: found(2), wanted

    found = one_of(history([0.03_wp, 0.01_wp]), flux_reading(1.75_wp*age, 2.0_wp, 2, 0.75_wp, [u, v]*1.75_wp*age/2), 0.0_wp, [u, v])
    wanted = 2*(-1.75_wp*age + (3*u - 2*v)*1.75_wp*age/2)
    call close_to(found(1), wanted, 1e-12_wp, "a flux that changes, met on a shorter way")
    call close_to(found(2), wanted, 1e-12_wp, "the same at another node")
  end subroutine changing_flux

  !> A place (x, y) of a body at rest was at (-y, x), seen from axes that have turned by a right angle since.
  subroutine turned_axes()
    real(wp), parameter :: right = acos(0.0_wp)
    real(wp) :: found(2)
    type(flux_history) :: of

    of = history([0.0_wp, 0.0_wp])
    found = one_of(of, flux_reading(age, 1.0_wp, 1, 1.0_wp, [0.0_wp, 0.0_wp]), right/age, [0.0_wp, 0.0_wp])
    associate (x => -u*age, y => 0.1_wp - v*age)
      call close_to(found(1), flux_at(-y, x, age) - flux_at(x, y, 0.0_wp), 1e-12_wp, "axes that turn")
    end associate
  end subroutine turned_axes

  !> Where the place has come from beyond the grid it met no flux.
  subroutine left_grid()
    real(wp) :: found(2)

    found = one_of(history([0.0_wp, 0.0_wp]), flux_reading(age, 1.0_wp, 1, 1.0_wp, [5.0_wp, 0.0_wp]), 0.0_wp, [u, v])
    call close_to(found(1), -flux_at(-u*age, 0.1_wp - v*age, 0.0_wp), 1e-12_wp, "from beyond the grid")
  end subroutine left_grid

  !> The present flux is taken as it would have spread within each time, linear between two of them.
  subroutine spread_flux()
    type(flux_history) :: of
    real(wp) :: found(2)

    of = history([0.0_wp, 0.0_wp])
    of%present(:, :, 2) = 5
    of%present(:, :, 3) = 7
    found = one_of(of, flux_reading(1.75_wp*age, 2.0_wp, 2, 0.75_wp, [u, v]*1.75_wp*age), 0.0_wp, [u, v])
    associate (x => -u*1.75_wp*age, y => 0.1_wp - v*1.75_wp*age)
      call close_to(found(1), 2*(flux_at(x, y, 1.75_wp*age) - 6.5_wp), 1e-12_wp, "a present flux that spreads")
    end associate
  end subroutine spread_flux

end program test_remembered_flux
