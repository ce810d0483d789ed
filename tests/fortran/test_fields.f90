program test_fields
  use pyworm_cubic_refinement, only: interpolate_cubic
  use pyworm_kinds, only: wp
  use tap, only: check, close_to, done
  use pyworm_vectors, only: dot, total
  implicit none(type, external)

  real(wp) :: coarse(7, 6), fine(13, 11), x, y, worst
  integer :: i, j

  do j = 1, 6
    do i = 1, 7
      coarse(i, j) = cubic(real(i, wp), real(j, wp))
    end do
  end do
  call interpolate_cubic(coarse, fine)
  worst = 0
  do j = 1, 11
    do i = 1, 13
      x = (i + 1)/2.0_wp
      y = (j + 1)/2.0_wp
      worst = max(worst, abs(fine(i, j) - cubic(x, y)))
    end do
  end do
  call close_to(worst, 0.0_wp, 1e-11_wp, "a cubic is interpolated exactly, ends included")

  call close_to(dot([(real(i, wp), i=1, 100)], [(1/real(i, wp), i=1, 100)]), 100.0_wp, 1e-12_wp, "inner product")
  call close_to(total(reshape([(real(i, wp), i=1, 42)], [7, 6])), 903.0_wp, 1e-12_wp, "sum of a field")
  call check(abs(dot(coarse(:, 1), coarse(:, 1)) - sum(coarse(:, 1)**2)) < 1e-12_wp*sum(coarse(:, 1)**2), &
    "inner product of a column")
  call done()

contains

  pure real(wp) function cubic(x, y)
    real(wp), intent(in) :: x, y

    cubic = (1 + 2*x - x**3)*(3 - y**2 + y**3/2)
  end function cubic

end program test_fields
