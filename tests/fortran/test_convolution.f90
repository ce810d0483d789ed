!> Convolution by transforms against the sum over all pairs of nodes, with a kernel that has no symmetry.
program test_convolution
  use pyworm_convolution, only: grid_convolution, new_grid_convolution
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_bad_argument
  use tap, only: check, close_to, done
  implicit none(type, external)

  integer :: stat

  call against_direct_sum(23, 18)
  call against_direct_sum(16, 33)
  call against_direct_sum(2, 2)
  call against_direct_sum(37, 1)
  call refusal()
  call done()

contains

  subroutine against_direct_sum(nx, ny)
    integer, intent(in) :: nx, ny
    type(grid_convolution) :: space
    real(wp) :: kernel(1 - nx:nx - 1, 1 - ny:ny - 1), x(nx, ny), y(nx, ny), direct(nx, ny), transposed(nx, ny)
    integer :: i, j, k, l

    do j = 1 - ny, ny - 1
      do i = 1 - nx, nx - 1
        kernel(i, j) = modulo(5*i*i + 3*j + i*j, 11) - 4
      end do
    end do
    do j = 1, ny
      do i = 1, nx
        x(i, j) = modulo(7*i*i + 13*j + i*j, 17)
      end do
    end do
    call new_grid_convolution(space, nx, ny, kernel, stat)
    call check(stat == status_ok, "a convolution is made")
    call space%convolve(x, y)
    direct = 0
    transposed = 0
    do l = 1, ny
      do k = 1, nx
        do j = 1, ny
          do i = 1, nx
            direct(i, j) = direct(i, j) + kernel(i - k, j - l)*x(k, l)
            transposed(i, j) = transposed(i, j) + kernel(k - i, l - j)*x(k, l)
          end do
        end do
      end do
    end do
    call close_to(maxval(abs(y - direct)), 0.0_wp, 1e-6_wp*maxval(abs(direct)), &
      "convolution is the direct sum but for rounding")
    call space%convolve_transposed(x, y)
    call close_to(maxval(abs(y - transposed)), 0.0_wp, 1e-6_wp*maxval(abs(transposed)), "and so is its transpose")
  end subroutine against_direct_sum

  subroutine refusal()
    type(grid_convolution) :: space
    real(wp) :: kernel(0:0, -1:1)

    kernel = 1
    call new_grid_convolution(space, 1, 2, kernel, stat)
    call check(stat == status_bad_argument, "a single column is refused")
  end subroutine refusal

end program test_convolution
