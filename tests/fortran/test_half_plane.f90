!> Deflection of a half-plane: by Hertz's pressure a parabola flat, and its constant the same on every grid.
program test_half_plane
  use pyworm_half_plane, only: elastic_half_plane, new_half_plane
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_bad_argument
  use tap, only: check, close_to, done
  implicit none(type, external)

  !> With E' = 4 and R = 1, Hertz's half-width and pressure are 1.
  real(wp), parameter :: modulus = 4
  type(elastic_half_plane) :: plane
  real(wp) :: unevenness(2), approach(2)
  integer :: stat

  call press(100, unevenness(1), approach(1))
  call press(200, unevenness(2), approach(2))
  call check(unevenness(2) < 1e-3_wp, "Hertz's pressure flattens a parabola")
  call check(unevenness(1)/unevenness(2) > 2.5_wp, "and the better the finer its strips")
  call close_to(approach(2), approach(1), 2e-3_wp, "the constant is that of the interval, not of the spacing")
  ! a line load of pi/2 and the interval's length 4: 1/2 (1/2 + ln 2 + ln 4)
  call close_to(approach(2), 0.25_wp + 1.5_wp*log(2.0_wp), 1e-3_wp, "and what quadrature gives")

  call new_half_plane(plane, 4, 1.0_wp, modulus, stat)
  call check(stat == status_bad_argument, "a grid too small is refused")
  call new_half_plane(plane, 9, 0.0_wp, modulus, stat)
  call check(stat == status_bad_argument, "no spacing is refused")
  call new_half_plane(plane, 9, 1.0_wp, -1.0_wp, stat)
  call check(stat == status_bad_argument, "a negative modulus is refused")
  call done()

contains

  !> Range of gap and deflection within 0.9 half-widths, and deflection in the middle, on n cells of -2 to 2.
  subroutine press(n, unevenness, approach)
    integer, intent(in) :: n
    real(wp), intent(out) :: unevenness, approach
    type(elastic_half_plane) :: plane
    real(wp) :: x(n + 1), w(n + 1), h(n + 1)
    integer :: i, stat

    x = [(-2 + 4.0_wp*(i - 1)/n, i=1, n + 1)]
    call new_half_plane(plane, n + 1, 4.0_wp/n, modulus, stat)
    call check(stat == status_ok, "a half-plane is made")
    call plane%deflection(sqrt(max(0.0_wp, 1 - x**2)), w)
    h = x**2/2 + w
    unevenness = maxval(h, mask=abs(x) < 0.9_wp) - minval(h, mask=abs(x) < 0.9_wp)
    approach = w(n/2 + 1)
  end subroutine press

end program test_half_plane
