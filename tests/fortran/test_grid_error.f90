!> Errors by grids: they hold what regular convergence leaves, and claim little where figures move to and fro.
program test_grid_error
  use pyworm_grid_error, only: grid_error
  use pyworm_kinds, only: wp
  use tap, only: check, close_to, done
  implicit none(type, external)
  real(wp) :: found, left
  integer :: order, n

  call check(grid_error([1.0_wp]) > 1e300_wp, "of one grid nothing is known")
  call close_to(grid_error([1.0_wp, 1.0_wp, 1.0_wp]), 0.0_wp, 0.0_wp, "a figure that stands still on three grids has no error")
  do order = 1, 2
    do n = 2, 4
      found = grid_error(1 + 0.3_wp*powers(order, n))
      left = 0.3_wp*2.0_wp**(-order*(n - 1))/(1 + 0.3_wp*2.0_wp**(-order*(n - 1)))
      call check(found >= left, "the error holds what is left at first and second order")
      if (n > 2) call check(found < 1.5_wp*left, "and not much more by three grids")
    end do
  end do
  call close_to(grid_error([1.0_wp, 1.2_wp, 1.1_wp]), 1.0_wp/11, 0.002_wp, "changes of other sign promise no convergence")
  call close_to(grid_error([1.0_wp, 2.0_wp, 2.001_wp]), 0.125_wp, 1e-12_wp, "a figure may stand still by chance")
  call check(grid_error([1.0_wp, 1.5_wp, 2.5_wp]) >= 0.4_wp, "changes that grow are taken in full")
  call done()

contains

  !> Errors of an order on n grids of halving spacing, the first 1.
  pure function powers(order, n)
    integer, intent(in) :: order, n
    real(wp) :: powers(n)
    integer :: k

    powers = [(2.0_wp**(-order*k), k=0, n - 1)]
  end function powers

end program test_grid_error
