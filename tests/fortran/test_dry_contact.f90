program test_dry_contact
  use dry_contact, only: solve_dry_contact
  use half_space, only: elastic_half_space, new_half_space
  use kinds, only: wp
  use status, only: status_ok, status_bad_argument, status_not_converged
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
    call check(iterations < 60, "in a few dozen iterations")
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
  end subroutine refusals

end program test_dry_contact
