program test_line_smoother
  use kinds, only: pp, wp
  use line_smoother, only: five_points, line_factors, new_line_factors, factor_lines, sweep_lines
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
    type(five_points) :: a
    type(line_factors) :: factors
    real(pp) :: f(n, 4), x(n, 4), again(n, 4)
    real(wp) :: worst
    integer :: i, j, stat

    allocate (a%centre(n, 4), a%left(n, 4), a%right(n, 4), a%before(n, 4), a%after(n, 4))
    do j = 1, 4
      do i = 1, n
        a%left(i, j) = -1 - i/10.0_pp
        a%right(i, j) = 0.5_pp - j/7.0_pp
        a%centre(i, j) = 4 + i*j/10.0_pp
        f(i, j) = i - 3*j
      end do
    end do
    a%before = 0
    a%after = 0
    x = 0
    call new_line_factors(n, 4, factors, stat)
    call factor_lines(a, factors)
    call sweep_lines(a, factors, f, .true., x)
    worst = 0
    do j = 2, 3
      do i = 2, n - 1
        worst = max(worst, real(abs(a%left(i, j)*x(i - 1, j) + a%centre(i, j)*x(i, j) &
          + a%right(i, j)*x(i + 1, j) - f(i, j)), wp))
      end do
    end do
    call close_to(worst, 0.0_wp, 1e-5_wp, "a line is solved to rounding")
    again = x
    call sweep_lines(a, factors, f, .false., again)
    call close_to(real(maxval(abs(again - x)), wp), 0.0_wp, 0.0_wp, "and stays solved")
  end subroutine solves_lines

end program test_line_smoother
