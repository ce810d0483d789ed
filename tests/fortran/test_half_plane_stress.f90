!> Stress below a grid of strips: the direct sum, and below a Hertzian line contact on its axis (Johnson, Contact Mechanics,
!> eq. 4.46 and section 4.2).
program test_half_plane_stress
  use pyworm_half_plane_stress, only: half_plane_stress
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_bad_argument, status_ok
  use pyworm_strip_stress, only: strip_stress
  use tap, only: check, close_to, done
  implicit none(type, external)

  integer :: stat

  call against_direct_sum(33)
  call on_the_axis()
  call refusal()
  call done()

contains

  subroutine against_direct_sum(n)
    integer, intent(in) :: n
    real(wp), parameter :: dx = 0.3_wp, depths(2) = [0.0_wp, 0.7_wp]
    real(wp) :: tractions(n, 2), stress(n, 3, 2), direct(3)
    integer :: i, k

    do i = 1, n
      tractions(i, :) = [modulo(7*i*i, 17) - 5.0_wp, modulo(5*i*i + i, 13) - 5.0_wp]
    end do
    call half_plane_stress(tractions, dx, depths, stress, stat)
    call check(stat == status_ok, "there is a stress")
    do k = 1, 2
      direct = 0
      do i = 1, n
        direct = direct + matmul(strip_stress((4 - i)*dx, depths(k), dx), tractions(i, :))
      end do
      call close_to(maxval(abs(stress(4, :, k) - direct)), 0.0_wp, 2e-5_wp, "convolution is the direct sum")
    end do
  end subroutine against_direct_sum

  subroutine on_the_axis()
    integer, parameter :: n = 513, middle = 257, count = 5
    real(wp), parameter :: dx = 2.2_wp/(n - 1), depths(count) = [0.0_wp, 0.2_wp, 0.786_wp, 1.5_wp, 3.0_wp]
    real(wp) :: tractions(n, 2), stress(n, 3, count)
    integer :: i

    tractions = 0
    tractions(:, 1) = [(sqrt(max(1 - ((i - middle)*dx)**2, 0.0_wp)), i=1, n)]
    call half_plane_stress(tractions, dx, depths, stress, stat)
    associate (root => sqrt(1 + depths**2))
      call close_to(maxval(abs(stress(middle, 1, :) + (1 + 2*depths**2)/root - 2*depths)), 0.0_wp, 2e-4_wp, &
        "stress along the surface on the axis")
      call close_to(maxval(abs(stress(middle, 2, :) + 1/root)), 0.0_wp, 2e-4_wp, "normal stress on the axis")
    end associate
    call close_to((stress(middle, 1, 3) - stress(middle, 2, 3))/2, 0.300_wp, 5e-4_wp, "maximum shear stress of a line contact")
  end subroutine on_the_axis

  subroutine refusal()
    real(wp) :: tractions(5, 2), stress(5, 3, 1)

    tractions = 1
    call half_plane_stress(tractions, 0.0_wp, [0.1_wp], stress, stat)
    call check(stat == status_bad_argument, "no spacing is refused")
    call half_plane_stress(tractions(:1, :), 1.0_wp, [0.1_wp], stress(:1, :, :), stat)
    call check(stat == status_bad_argument, "a single node is refused")
  end subroutine refusal

end program test_half_plane_stress
