program test_line_smoother
  use kinds, only: wp
  use line_smoother, only: lines, factor_lines, sweep_lines
  use tap, only: close_to, done
  implicit none(type, external)

  call solves_lines(9)
  call solves_lines(10)
  call solves_lines(5)
  call done()

contains

  !> Without coupling between lines one sweep is an exact solve, in either order and for any length.
  subroutine solves_lines(n)
    integer, intent(in) :: n
    real(wp) :: left(n, 4), centre(n, 4), right(n, 4), none(n, 4), f(n, 4), x(n, 4), r
    type(lines) :: all
    integer :: i, j

    do j = 1, 4
      do i = 1, n
        left(i, j) = -1 - i/10.0_wp
        right(i, j) = 0.5_wp - j/7.0_wp
        centre(i, j) = 4 + i*j/10.0_wp
        f(i, j) = i - 3*j
      end do
    end do
    none = 0
    x = 0
    call factor_lines(left, centre, right, none, none, all)
    call sweep_lines(all, f, .true., x)
    r = 0
    do j = 2, 3
      do i = 2, n - 1
        r = max(r, abs(left(i, j)*x(i - 1, j) + centre(i, j)*x(i, j) + right(i, j)*x(i + 1, j) - f(i, j)))
      end do
    end do
    call close_to(r, 0.0_wp, 1e-12_wp, "a line is solved exactly")
    none = x
    call sweep_lines(all, f, .false., x)
    call close_to(maxval(abs(none - x)), 0.0_wp, 1e-14_wp, "and stays solved")
  end subroutine solves_lines

end program test_line_smoother
