!> Convection of heat along a film, from column to column, by upwind differences along the path of the oil.
module pyworm_oil_convection
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: line_cut, carry_level

  !> Columns of a line treated together, whatever the number of threads.
  integer, parameter, public :: most_columns = 32

  !> Some columns of a line.
  type :: line_cut
    integer :: columns = 0
    !> Whether the first and the last column are those of the line, and whether there is a line two back.
    logical :: at_first = .false., at_last = .false., two_back = .false.
    !> Reciprocal spacings of the nodes and of the lines [1/m].
    real(wp) :: per_node = 0, per_line = 0
  end type line_cut

contains

  !> Computes the heat convected from one level of a line's columns per kelvin, `absorption` [W/(m3 K)], and to them,
  !> `inflow` [W/m3], by oil of heat `capacity` [J/(m3 K)] that moves with u along and v across the line [m/s], from the
  !> temperature of this line, `here`, of those one and two lines back, and of the one ahead.
  !>
  !> Oil comes from the foot of its path on the square of the eight neighbouring nodes; where that lies on the line
  !> before, a second foot two lines back gives a second-order difference along the path, unless there is no such line
  !> (`two_back`) or the foot lies beyond its end (`at_first`, `at_last`). Elsewhere values lag behind, and only with a
  !> first-order difference do their errors never grow from sweep to sweep.
  pure subroutine carry_level(cut, far, back, here, ahead, capacity, u, v, absorption, inflow)
    type(line_cut), intent(in) :: cut
    real(wp), intent(in) :: far(-1:cut%columns + 2)
    real(wp), dimension(0:cut%columns + 1), intent(in) :: back, here, ahead
    real(wp), dimension(cut%columns), intent(in) :: capacity, u, v
    real(wp), dimension(cut%columns), intent(out) :: absorption, inflow
    !> One or zero: whether oil comes from the left, from the line before, and from a line more than along it; whether its
    !> second foot exists.
    real(wp) :: left, behind, crossing, reached
    real(wp) :: along, across, rate, skew, beside, foot, second, order
    integer :: c, low, high

    associate (at_first => cut%at_first, at_last => cut%at_last, two_back => cut%two_back)
      low = merge(1, 0, at_first)
      high = merge(cut%columns, cut%columns + 1, at_last)
      ! weights instead of branches let the loop be vectorised
      do c = 1, cut%columns
        along = u(c)*cut%per_node
        across = v(c)*cut%per_line
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
        ! capacity rate (T - foot + order (T - 2 foot + second)): with an order of one half the difference is of second order
        absorption(c) = (1 + order)*capacity(c)*rate
        inflow(c) = capacity(c)*rate*((1 + 2*order)*foot - order*second)
      end do
    end associate
  end subroutine carry_level

end module pyworm_oil_convection
