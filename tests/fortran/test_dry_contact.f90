program test_dry_contact
  use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
  use pyworm_dry_contact, only: solve_dry_contact
  use pyworm_half_space, only: elastic_half_space, new_half_space
  use pyworm_kinds, only: wp
  use pyworm_periodic_stiffness, only: periodic_half_space, new_periodic_half_space
  use pyworm_pressure_refinement, only: refine_pressure
  use pyworm_status, only: status_ok, status_bad_argument, status_not_converged, status_not_finite
  use tap, only: check, close_to, done
  implicit none(type, external)

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> A circular contact of radius 1 and Hertz pressure 1: R = 1, F = 2 pi / 3, E' = pi.
  real(wp), parameter :: load = 2*pi/3, modulus = pi
  real(wp) :: coarse, fine, unused
  integer :: stat, iterations

  call hertz(24, coarse, unused)
  call hertz(48, fine, unused)
  call check(fine < coarse/2, "Hertz pressure: the error falls with the grid")
  call close_to(fine, 0.0_wp, 4e-3_wp, "Hertz pressure: mean error")
  call close_to(unused, 1.0_wp, 2e-3_wp, "Hertz approach")
  call edge()
  call rough()
  call between_nodes()
  call wave()
  call refinement()
  call refusals()
  call done()

contains

  !> Mean pressure error over the load's area on 3 by 3 with n cells a side.
  subroutine hertz(n, error, approach)
    integer, intent(in) :: n
    real(wp), intent(out) :: error, approach
    type(elastic_half_space) :: space
    real(wp) :: gap(n + 1, n + 1), p(n + 1, n + 1), exact(n + 1, n + 1), d
    logical :: covered(n + 1, n + 1)
    integer :: i, j

    d = 3.0_wp/n
    do j = 1, n + 1
      do i = 1, n + 1
        gap(i, j) = ((-1.5_wp + (i - 1)*d)**2 + (-1.5_wp + (j - 1)*d)**2)/2
      end do
    end do
    exact = sqrt(max(0.0_wp, 1 - 2*gap))
    covered = .true.
    p = 1
    call new_half_space(space, n + 1, n + 1, d, d, modulus, stat)
    call solve_dry_contact(space, gap, covered, load, 1e-8_wp, 400, p, approach, iterations, stat)
    call check(stat == status_ok, "Hertz contact converges")
    call close_to(sum(p)*d*d, load, 1e-12_wp, "the load is carried")
    call check(iterations <= 8, "in a few iterations, whatever the grid")
    error = sum(abs(p - exact))*d*d/pi
  end subroutine hertz

  !> A body that ends within the contact presses harder at its end and not at all beyond.
  subroutine edge()
    integer, parameter :: n = 40
    type(elastic_half_space) :: space
    real(wp) :: gap(n + 1, n + 1), p(n + 1, n + 1), approach, d
    logical :: covered(n + 1, n + 1)
    integer :: i, j

    d = 4.0_wp/n
    do j = 1, n + 1
      do i = 1, n + 1
        gap(i, j) = ((-2 + (i - 1)*d)**2 + (-2 + (j - 1)*d)**2)/2
        covered(i, j) = i <= 26
      end do
    end do
    p = 1
    call new_half_space(space, n + 1, n + 1, d, d, modulus, stat)
    call solve_dry_contact(space, gap, covered, load, 1e-7_wp, 1000, p, approach, iterations, stat)
    call check(stat == status_ok, "a contact that runs off an edge converges")
    call check(maxval(abs(p(27:, :))) <= 0, "no pressure beyond the edge")
    call check(p(26, 21) > p(24, 21), "pressure rises towards the edge")
  end subroutine edge

  !> On a gap of white noise: no pull, no film where there is pressure, no overlap elsewhere; twice the same.
  subroutine rough()
    integer, parameter :: nx = 60, ny = 47
    type(elastic_half_space) :: space
    real(wp) :: gap(nx, ny), p(nx, ny), again(nx, ny), film(nx, ny), approach
    logical :: covered(nx, ny)
    integer :: i, j

    do j = 1, ny
      do i = 1, nx
        gap(i, j) = mod(7919*i + 104729*j + 31*i*j, 1000)*1e-4_wp
        covered(i, j) = i > 3 .and. mod(i*j, 17) /= 0
      end do
    end do
    p = 1
    again = 2
    call new_half_space(space, nx, ny, 0.05_wp, 0.1_wp, modulus, stat)
    call solve_dry_contact(space, gap, covered, 0.05_wp, 1e-9_wp, 100, p, approach, iterations, stat)
    call check(stat == status_ok, "a rough contact converges")
    call space%deflection(p, film)
    film = film + gap - approach
    call check(minval(p) >= 0 .and. count(p > 0) > 20 .and. count(p > 0) < nx*ny/2, "asperities press")
    call check(maxval(abs(film), mask=p > 0) < 1e-7_wp*approach, "no film where there is pressure")
    call check(minval(film, mask=covered) > -1e-8_wp*approach, "no overlap elsewhere")
    call solve_dry_contact(space, gap, covered, 0.05_wp, 1e-9_wp, 100, again, approach, iterations, stat)
    call check(maxval(abs(again - p)) <= 0, "the same to the last bit from a uniform guess of any size")
  end subroutine rough

  !> A contact and a guess that all coarser grids miss.
  subroutine between_nodes()
    integer, parameter :: n = 48
    type(elastic_half_space) :: space
    real(wp) :: gap(n, n), p(n, n), approach
    logical :: covered(n, n)

    gap = 1
    gap(24, 24) = 0
    covered = .true.
    p = 0
    p(24, 24) = 1
    call new_half_space(space, n, n, 0.1_wp, 0.1_wp, modulus, stat)
    call solve_dry_contact(space, gap, covered, 1e-4_wp, 1e-9_wp, 100, p, approach, iterations, stat)
    call check(stat == status_ok .and. count(p > 0) == 1, "a contact of one node is found between coarse nodes")
    call close_to(approach, 1e-2_wp*space%centre, 1e-12_wp, "and sinks in by its own deflection")
  end subroutine between_nodes

  !> A cosine deflection asks for E' k / 4 times itself.
  subroutine wave()
    integer, parameter :: nx = 16, ny = 24
    type(periodic_half_space) :: stiffness
    real(wp) :: w(nx, ny), p(nx, ny)
    integer :: i, j

    do j = 1, ny
      do i = 1, nx
        w(i, j) = cos(2*pi*(2*real(i, wp)/nx + 3*real(j, wp)/ny))
      end do
    end do
    call new_periodic_half_space(stiffness, nx, ny, 0.5_wp, 0.25_wp, modulus, stat)
    call stiffness%pressure(w, p)
    call close_to(maxval(abs(p - modulus*2*pi*sqrt(0.25_wp**2 + 0.5_wp**2)/4*w)), 0.0_wp, 1e-12_wp, &
      "stiffness of a wavy surface")
  end subroutine wave

  !> The refined Hertz pressure keeps its boundary, on grids of odd and of even size.
  subroutine refinement()
    real(wp) :: coarse(21, 21), odd(41, 41), even(42, 42)

    coarse = hertz_pressure(21, 0.15_wp)
    call refine_pressure(coarse, odd)
    call close_to(maxval(abs(odd**2 - hertz_pressure(41, 0.075_wp)**2)), 0.0_wp, 0.03_wp, &
      "refined pressure, squared, within the square of the spacing")
    call refine_pressure(coarse, even)
    call check(maxval(abs(even(:41, :41) - odd)) <= 0, "on an even grid as on an odd one")
  end subroutine refinement

  !> Hertz pressure on n by n nodes from the corner (-1.5, -1.5).
  pure function hertz_pressure(n, d) result(p)
    integer, intent(in) :: n
    real(wp), intent(in) :: d
    real(wp) :: p(n, n)
    integer :: i, j

    do j = 1, n
      do i = 1, n
        p(i, j) = sqrt(max(0.0_wp, 1 - (-1.5_wp + (i - 1)*d)**2 - (-1.5_wp + (j - 1)*d)**2))
      end do
    end do
  end function hertz_pressure

  subroutine refusals()
    type(elastic_half_space) :: space
    real(wp) :: gap(9, 9), p(9, 9), approach
    logical :: covered(9, 9)

    gap = 0
    gap(5, 5) = -1
    covered = .true.
    call new_half_space(space, 9, 9, 1.0_wp, 1.0_wp, 1.0_wp, stat)
    p = 1
    call solve_dry_contact(space, gap, covered, 0.0_wp, 1e-6_wp, 100, p, approach, iterations, stat)
    call check(stat == status_bad_argument, "no load is refused")
    p = 0
    call solve_dry_contact(space, gap, covered, 1.0_wp, 1e-6_wp, 100, p, approach, iterations, stat)
    call check(stat == status_bad_argument, "a first guess without load is refused")
    p = 1
    call solve_dry_contact(space, gap, covered, 1.0_wp, 1e-14_wp, 1, p, approach, iterations, stat)
    call check(stat == status_not_converged, "too few iterations are told")
    gap(2, 2) = ieee_value(1.0_wp, ieee_quiet_nan)
    call solve_dry_contact(space, gap, covered, 1.0_wp, 1e-6_wp, 100, p, approach, iterations, stat)
    call check(stat == status_not_finite, "a gap that is not a number is told")
    covered(2, 2) = .false.
    call solve_dry_contact(space, gap, covered, 1.0_wp, 1e-6_wp, 100, p, approach, iterations, stat)
    call check(stat == status_ok, "and does not matter where a body has ended")
  end subroutine refusals

end program test_dry_contact
