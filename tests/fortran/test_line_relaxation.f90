program test_line_relaxation
  use pyworm_kinds, only: pp, wp
  use pyworm_line_relaxation, only: line_systems, new_line_systems, factor_line, relax_line, relax_first
  use tap, only: close_to, done
  implicit none(type, external)

  call solves_lines(9)
  call solves_lines(10)
  call solves_lines(5)
  call leaves_closed_pairs(2)
  call leaves_closed_pairs(4)
  call leaves_closed_pairs(7)
  call done()

contains

  !> A line solved meets its equations with the neighbours that it has to see, for any length.
  subroutine solves_lines(n)
    integer, intent(in) :: n
    type(line_systems) :: lines
    real(pp), dimension(n, 4) :: centre, left, right, f, x
    real(pp) :: free(n)
    integer :: i, j, stat

    do j = 1, 4
      do i = 1, n
        left(i, j) = -1 - i/10.0_pp
        right(i, j) = 0.5_pp - j/7.0_pp
        centre(i, j) = 4 + i*j/10.0_pp
        f(i, j) = i - 3*j
      end do
    end do
    x = 0
    x(2:n - 1, :) = 0.5_pp
    free = 1
    call new_line_systems(n, 4, lines, stat)
    lines%before = 0.3_pp
    lines%after = -0.7_pp
    do j = 2, 3
      call factor_line(lines, j, centre(:, j), left(:, j), right(:, j), free)
    end do
    call relax_line(lines, 2, f, x)
    call close_to(imbalance(2, centre, left, right, 0.3_pp, -0.7_pp, f, x), 0.0_wp, 1e-5_wp, &
      "a line is solved against both its neighbours")
    call relax_first(lines, 3, .true., f, x)
    call close_to(imbalance(3, centre, left, right, 0.3_pp, 0.0_pp, f, x), 0.0_wp, 1e-5_wp, &
      "against the line before, in rising order")
    call relax_first(lines, 2, .false., f, x)
    call close_to(imbalance(2, centre, left, right, 0.0_pp, -0.7_pp, f, x), 0.0_wp, 1e-5_wp, &
      "against the line after, in falling order")

    free(3) = 0
    left(4, 2) = 0
    right(2, 2) = 0
    call factor_line(lines, 2, centre(:, 2), left(:, 2), right(:, 2), free)
    call relax_line(lines, 2, f, x)
    call close_to(real(x(3, 2), wp), 0.0_wp, 0.0_wp, "where it is not free it is zero")
  end subroutine solves_lines

  !> Two points that exchange oil with each other alone, so that no pressure balances what flows in, get some
  !> bounded one, and the rest of the line is solved; wherever in the line elimination meets them.
  subroutine leaves_closed_pairs(first)
    integer, intent(in) :: first
    integer, parameter :: n = 9
    type(line_systems) :: lines
    real(pp), dimension(n, 3) :: centre, left, right, f, x
    real(pp) :: free(n), rest(n)
    integer :: stat

    left = -1
    right = -1
    centre = 3
    f = 1
    x = 0
    free = 1
    centre(first:first + 1, :) = 1
    left(first, :) = 0
    right(first + 1, :) = 0
    call new_line_systems(n, 3, lines, stat)
    call factor_line(lines, 2, centre(:, 2), left(:, 2), right(:, 2), free)
    call relax_line(lines, 2, f, x)
    call close_to(real(maxval(abs(x(first:first + 1, 2))), wp), 1.0_wp, 1.0_wp, "a closed pair stays bounded")
    rest = 0
    rest(2:n - 1) = left(2:n - 1, 2)*x(:n - 2, 2) + centre(2:n - 1, 2)*x(2:n - 1, 2) + right(2:n - 1, 2)*x(3:, 2) - 1
    rest(first:first + 1) = 0
    call close_to(real(maxval(abs(rest)), wp), 0.0_wp, 1e-5_wp, "and the rest of its line is solved")
  end subroutine leaves_closed_pairs

  !> Largest imbalance of line j with its neighbours by the couplings given.
  real(wp) function imbalance(j, centre, left, right, before, after, f, x)
    integer, intent(in) :: j
    real(pp), dimension(:, :), intent(in) :: centre, left, right, f, x
    real(pp), intent(in) :: before, after
    integer :: n

    n = size(x, 1)
    imbalance = maxval(abs(left(2:n - 1, j)*x(:n - 2, j) + centre(2:n - 1, j)*x(2:n - 1, j) &
      + right(2:n - 1, j)*x(3:, j) + before*x(2:n - 1, j - 1) + after*x(2:n - 1, j + 1) - f(2:n - 1, j)))
  end function imbalance

end program test_line_relaxation
