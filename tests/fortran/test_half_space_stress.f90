!> Stress below a grid of rectangles: the direct sum, and below a circular Hertzian contact on its axis (Johnson, Contact
!> Mechanics, eq. 3.45 and section 3.4).
program test_half_space_stress
  use pyworm_half_space_stress, only: half_space_stress
  use pyworm_kinds, only: wp
  use pyworm_rectangle_stress, only: rectangle_stress, xx, yy, zz
  use pyworm_status, only: status_bad_argument, status_ok
  use tap, only: check, close_to, done
  implicit none(type, external)

  integer :: stat

  call against_direct_sum(19, 14)
  call against_direct_sum(8, 21)
  call on_the_axis()
  call refusal()
  call done()

contains

  subroutine against_direct_sum(nx, ny)
    integer, intent(in) :: nx, ny
    real(wp), parameter :: dx = 0.3_wp, dy = 0.4_wp, poisson = 0.3_wp, depths(2) = [0.0_wp, 0.7_wp]
    real(wp) :: tractions(nx, ny, 3), stress(nx, ny, 6, 2), direct(6)
    integer :: i, j, k, place(2)

    do k = 1, 3
      tractions(:, :, k) = reshape([(modulo(7*i*i + 5*k*i, 17) - 5.0_wp, i=1, nx*ny)], [nx, ny])
    end do
    call half_space_stress(tractions, dx, dy, poisson, depths, stress, stat)
    call check(stat == status_ok, "there is a stress")
    place = [4, ny - 2]
    do k = 1, 2
      direct = 0
      do j = 1, ny
        do i = 1, nx
          direct = direct + matmul(rectangle_stress((place(1) - i)*dx, (place(2) - j)*dy, depths(k), dx, dy, poisson), &
            tractions(i, j, :))
        end do
      end do
      call close_to(maxval(abs(stress(place(1), place(2), :, k) - direct)), 0.0_wp, 2e-5_wp, "convolution is the direct sum")
    end do
  end subroutine against_direct_sum

  subroutine on_the_axis()
    integer, parameter :: n = 129, middle = 65, count = 6
    real(wp), parameter :: spacing = 2.2_wp/(n - 1), nu = 0.3_wp
    real(wp), parameter :: depths(count) = [0.0_wp, 0.1_wp, 0.3_wp, 0.481_wp, 1.0_wp, 2.0_wp]
    real(wp), allocatable :: tractions(:, :, :), stress(:, :, :, :)
    real(wp) :: normal(count), along(count)
    integer :: i, j

    allocate (tractions(n, n, 3), source=0.0_wp)
    allocate (stress(n, n, 6, count))
    do j = 1, n
      do i = 1, n
        tractions(i, j, 1) = sqrt(max(1 - ((i - middle)**2 + (j - middle)**2)*spacing**2, 0.0_wp))
      end do
    end do
    call half_space_stress(tractions, spacing, spacing, nu, depths, stress, stat)
    normal = -1/(1 + depths**2)
    along = -(1 + nu)*(1 - depths*atan2(1.0_wp, depths)) - normal/2
    call close_to(maxval(abs(stress(middle, middle, zz, :) - normal)), 0.0_wp, 5e-4_wp, "normal stress on the axis")
    call close_to(maxval(abs(stress(middle, middle, xx, :) - along)), 0.0_wp, 5e-4_wp, "radial stress on the axis")
    call close_to(maxval(abs(stress(middle, middle, xx, :) - stress(middle, middle, yy, :))), 0.0_wp, 1e-6_wp, &
      "the same along both directions")
    call close_to((stress(middle, middle, xx, 4) - stress(middle, middle, zz, 4))/2, 0.310_wp, 5e-4_wp, &
      "maximum shear stress of a circular contact")
  end subroutine on_the_axis

  subroutine refusal()
    real(wp) :: tractions(5, 5, 3), stress(5, 5, 6, 1)

    tractions = 1
    call half_space_stress(tractions, 1.0_wp, -1.0_wp, 0.3_wp, [0.1_wp], stress, stat)
    call check(stat == status_bad_argument, "a negative spacing is refused")
    call half_space_stress(tractions, 1.0_wp, 1.0_wp, 0.3_wp, [-0.1_wp], stress, stat)
    call check(stat == status_bad_argument, "a depth above the surface is refused")
  end subroutine refusal

end program test_half_space_stress
