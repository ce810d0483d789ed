!> Error of a figure on the last of grids of halving spacing, by its changes from grid to grid.
!>
!> Richardson extrapolation with a safety factor (Roache, Annu. Rev. Fluid Mech. 29, 1997, 123-160), for figures that are at
!> most of second order and may stand still, or move to and fro, between coarse grids.
module pyworm_grid_error
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: grid_error

  !> Safety factor, as recommended for three grids.
  real(wp), parameter :: safety = 1.25_wp
  !> Least and largest ratio of successive changes that promises anything: of first and of second order.
  real(wp), parameter :: least_fall = 2, most_fall = 4
  !> Ratio beyond which the last change is small by chance.
  real(wp), parameter :: steepest_fall = 8

contains

  !> Relative error of the last of some readings of a figure, the coarsest grid's first; `huge` by a single one.
  pure real(wp) function grid_error(readings)
    real(wp), intent(in) :: readings(:)
    real(wp) :: last, before
    integer :: n

    n = size(readings)
    grid_error = huge(1.0_wp)
    if (n < 2) return
    last = relative(readings(n - 1), readings(n))
    grid_error = safety*abs(last)
    if (n == 2) return
    before = relative(readings(n - 2), readings(n - 1))
    if (before*last < 0 .or. abs(before) > steepest_fall*abs(last)) then
      grid_error = max(abs(last), abs(before)/4)
    else if (abs(last) > 0) then
      grid_error = max(safety*abs(last), abs(before)/4)/(min(max(before/last, least_fall), most_fall) - 1)
    end if
  end function grid_error

  !> Change from one value to another, relative to the latter.
  pure real(wp) function relative(from, to)
    real(wp), intent(in) :: from, to

    relative = (to - from)/max(abs(to), tiny(1.0_wp))
  end function relative

end module pyworm_grid_error
