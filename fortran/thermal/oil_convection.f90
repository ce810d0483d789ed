!> Convection of heat along a film, from column to column, by upwind differences along the path of the oil.
module pyworm_oil_convection
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: carry_level

contains

  !> Computes the heat convected from one level of a line's m columns per kelvin, `absorption` [W/(m3 K)], and to them,
  !> `inflow` [W/m3], from the temperature of this line and its neighbours, with reciprocal spacings [1/m].
  !>
  !> Oil comes from the foot of its path on the square of the eight neighbouring nodes; where that lies on the line
  !> before, a second foot two lines back gives a second-order difference along the path, unless there is no such line
  !> (`two_back`) or the foot lies beyond its end (`at_first`, `at_last`). Elsewhere values lag behind, and only with a
  !> first-order difference do their errors never grow from sweep to sweep.
  pure subroutine carry_level(m, at_first, at_last, two_back, far, back, here, ahead, capacity, per_node, per_line, u, v, &
    absorption, inflow)
    integer, intent(in) :: m
    logical, intent(in) :: at_first, at_last, two_back
    real(wp), intent(in) :: far(-1:m + 2), back(0:m + 1), here(0:m + 1), ahead(0:m + 1), capacity(m), per_node, per_line, &
      u(m), v(m)
    real(wp), intent(out) :: absorption(m), inflow(m)
    !> One or zero: whether oil comes from the left, from the line before, and from a line more than along it; whether its
    !> second foot exists.
    real(wp) :: left, behind, crossing, reached
    real(wp) :: along, across, rate, skew, beside, foot, second, order
    integer :: c, low, high

    low = merge(1, 0, at_first)
    high = merge(m, m + 1, at_last)
    ! weights instead of branches let the loop be vectorised
    do c = 1, m
      along = u(c)*per_node
      across = v(c)*per_line
      left = merge(1.0_wp, 0.0_wp, along > 0)
      behind = merge(1.0_wp, 0.0_wp, across > 0)
      crossing = merge(1.0_wp, 0.0_wp, abs(across) >= abs(along))
      rate = max(abs(across), abs(along), tiny(rate))
      skew = min(abs(across), abs(along))/rate
      reached = left*merge(1.0_wp, 0.0_wp, c > low) + (1 - left)*merge(1.0_wp, 0.0_wp, c < high)
      reached = max(reached, merge(1.0_wp, 0.0_wp, skew < 0.5_wp))
      order = 0.5_wp*merge(1.0_wp, 0.0_wp, two_back)*behind*crossing*reached
      beside = left*(behind*back(c - 1) + (1 - behind)*ahead(c - 1)) &
        + (1 - left)*(behind*back(c + 1) + (1 - behind)*ahead(c + 1))
      foot = skew*beside + (1 - skew)*(crossing*(behind*back(c) + (1 - behind)*ahead(c)) &
        + (1 - crossing)*(left*here(c - 1) + (1 - left)*here(c + 1)))
      second = max(1 - 2*skew, 0.0_wp)*far(c) + (1 - abs(2*skew - 1))*(left*far(c - 1) + (1 - left)*far(c + 1)) &
        + max(2*skew - 1, 0.0_wp)*(left*far(c - 2) + (1 - left)*far(c + 2))
      absorption(c) = (1 + order)*capacity(c)*rate
      inflow(c) = capacity(c)*rate*((1 + 2*order)*foot - order*second)
    end do
  end subroutine carry_level

end module pyworm_oil_convection
