program test_half_space
  use pyworm_half_space, only: elastic_half_space, new_half_space
  use pyworm_kinds, only: wp
  use pyworm_padded_transform, only: padded_size
  use pyworm_status, only: status_ok, status_bad_argument
  use tap, only: check, close_to, done
  implicit none(type, external)

  real(wp), parameter :: pi = acos(-1.0_wp)
  integer :: stat

  call check(padded_size(512) == 512 .and. padded_size(513) == 640 .and. padded_size(642) == 768 .and. padded_size(4) == 4, &
    "padded sizes are powers of two, or 3 or 5 times one")
  call against_direct_sum(23, 18)
  call against_direct_sum(16, 33)
  call under_uniform_square()
  call between_negative_sizes()
  call done()

contains

  !> Deflection by FFT against the sum over all pairs of nodes, with Love's integral by quadrature.
  subroutine against_direct_sum(nx, ny)
    integer, intent(in) :: nx, ny
    type(elastic_half_space) :: space
    real(wp) :: p(nx, ny), w(nx, ny), direct, dx, dy
    integer :: i, j, k, l

    dx = 1.3_wp
    dy = 0.4_wp
    do j = 1, ny
      do i = 1, nx
        p(i, j) = modulo(7*i*i + 13*j + i*j, 17)
      end do
    end do
    call new_half_space(space, nx, ny, dx, dy, 2.0_wp, stat)
    call check(stat == status_ok, "a half-space is made")
    call space%deflection(p, w)
    direct = 0
    k = 4
    l = ny - 2
    do j = 1, ny
      do i = 1, nx
        direct = direct + p(i, j)*rectangle((i - k)*dx, (j - l)*dy, dx, dy)
      end do
    end do
    ! w = 2/(pi E') int p/r
    call close_to(w(k, l), direct/pi, 1e-9_wp*w(k, l), "convolution against direct summation")
  end subroutine against_direct_sum

  !> Integral of 1/r over a rectangle centred at (x, y): the inner one in closed form, the outer one by
  !> Gauss-Legendre in two halves graded towards the singular line.
  real(wp) function rectangle(x, y, dx, dy)
    real(wp), intent(in) :: x, y, dx, dy
    integer, parameter :: panels = 150
    real(wp), parameter :: node(3) = [-sqrt(0.6_wp), 0.0_wp, sqrt(0.6_wp)]
    real(wp), parameter :: weight(3) = [5.0_wp, 8.0_wp, 5.0_wp]/9
    real(wp) :: low, high, t, s
    integer :: side, panel, g

    rectangle = 0
    do side = -1, 1, 2
      do panel = 1, panels
        ! panels shrink geometrically towards the middle of the rectangle, where the pole may be
        low = dx/2*merge(0.0_wp, 0.85_wp**(panels - panel + 1), panel == 1)
        high = dx/2*0.85_wp**(panels - panel)
        do g = 1, 3
          t = x + side*((low + high)/2 + node(g)*(high - low)/2)
          s = asinh((y + dy/2)/abs(t)) - asinh((y - dy/2)/abs(t))
          rectangle = rectangle + weight(g)*(high - low)/2*s
        end do
      end do
    end do
  end function rectangle

  !> Middle of a uniformly loaded square of side 2a: the integral of 1/r is 8 a ln(1 + sqrt 2).
  subroutine under_uniform_square()
    integer, parameter :: n = 31
    type(elastic_half_space) :: space
    real(wp) :: p(n, n), w(n, n), a

    call new_half_space(space, n, n, 0.1_wp, 0.1_wp, 3.0_wp, stat)
    p = 1
    call space%deflection(p, w)
    a = n*0.1_wp/2
    call close_to(w(16, 16), 2/(pi*3)*8*a*log(1 + sqrt(2.0_wp)), 1e-13_wp, "middle of a uniform square")
    call close_to(w(1, 1), w(n, n), 1e-14_wp, "corners are alike")
  end subroutine under_uniform_square

  subroutine between_negative_sizes()
    type(elastic_half_space) :: space

    call new_half_space(space, 2, 5, 1.0_wp, 1.0_wp, 1.0_wp, stat)
    call check(stat == status_bad_argument, "two points are refused")
    call new_half_space(space, 5, 5, -1.0_wp, 1.0_wp, 1.0_wp, stat)
    call check(stat == status_bad_argument, "a negative spacing is refused")
  end subroutine between_negative_sizes

end program test_half_space
