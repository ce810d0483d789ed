!> Levels across a film: quadrature, integrals from the wall and conduction are exact for polynomials.
program test_gauss_lobatto
  use pyworm_gauss_lobatto, only: levels_across, new_levels
  use pyworm_kinds, only: wp
  use tap, only: check, done
  implicit none(type, external)

  real(wp), parameter :: rounding = 1e-12_wp
  type(levels_across) :: levels
  real(wp), allocatable :: z(:)
  integer :: n, k

  do n = 3, 11, 2
    levels = new_levels(n)
    z = levels%z
    call check(abs(z(1) + 0.5_wp) + abs(z(n) - 0.5_wp) < rounding, "the walls are levels")
    call check(abs(sum(levels%weight) - 1) < rounding, "weights add to the film")
    ! the highest even degree that is exact, over (-1/2, 1/2)
    k = 2*n - 4
    call check(abs(sum(levels%weight*z**k) - 0.5_wp**k/(k + 1)) < rounding, "quadrature is exact to degree 2n - 3")
    call check(maxval(abs(matmul(levels%integral, z**2) - (z**3 + 0.125_wp)/3)) < rounding, "integral from body 1")
    call check(maxval(abs(levels%integral(n, :) - levels%weight)) < rounding, "integral over the whole film")
    ! a heat source of 2 in unit conductivity: T = 1/4 - z**2 loses 1 through each wall, where z**2 is level
    call check(maxval(abs(matmul(levels%stiffness, 0.25_wp - z**2) - 2*levels%weight + walls(n))) < 1e-10_wp, &
      "conduction carries a uniform source to the walls")
  end do
  deallocate (z)
  call done()

contains

  !> What leaves through the walls.
  function walls(count)
    integer, intent(in) :: count
    real(wp) :: walls(count)

    walls = 0
    walls(1) = 1
    walls(count) = 1
  end function walls

end program test_gauss_lobatto
