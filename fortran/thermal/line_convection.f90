!> Convection of heat along the film of a line contact, by upwind differences.
module pyworm_line_convection
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: bring

  !> Velocity over that of the faster body below which oil is slow.
  real(wp), parameter :: slow_fraction = 0.2_wp

contains

  !> Computes the heat convected from the levels at node i per kelvin, `absorption` [W/(m3 K)], and to them, `inflow`
  !> [W/m3], by differences to one or two upstream nodes.
  !>
  !> Where oil flows in both directions, levels of little velocity convect from both sides; else one whose direction
  !> changes from sweep to sweep would jump between the temperatures of inlet and contact.
  pure subroutine bring(rise, flow, i, absorption, inflow)
    real(wp), intent(in) :: rise(:, :), flow(:)
    integer, intent(in) :: i
    real(wp), intent(out) :: absorption(:), inflow(:)
    real(wp) :: slow, from_before
    integer :: k

    slow = 0
    if (minval(flow) < 0 .and. maxval(flow) > 0) slow = slow_fraction*maxval(abs(flow([1, size(flow)])))
    do k = 1, size(flow)
      if (abs(flow(k)) < slow) then
        from_before = (1 + flow(k)/slow)/2
      else
        from_before = merge(1, 0, flow(k) > 0)
      end if
      absorption(k) = 0
      inflow(k) = 0
      call bring_from(-1, rise(:, k), i, from_before*abs(flow(k)), from_before >= 1, absorption(k), inflow(k))
      call bring_from(1, rise(:, k), i, (1 - from_before)*abs(flow(k)), from_before <= 0, absorption(k), inflow(k))
    end do
  end subroutine bring

  !> Adds the convection of a `rate` [W/(m3 K)] of oil from one side of node i, by a difference of `second` order or of
  !> first, with which errors of lagging values do not grow from sweep to sweep.
  pure subroutine bring_from(side, rise, i, rate, second, absorption, inflow)
    integer, intent(in) :: side, i
    real(wp), intent(in) :: rise(:), rate
    logical, intent(in) :: second
    real(wp), intent(inout) :: absorption, inflow

    if (second .and. i + 2*side >= 1 .and. i + 2*side <= size(rise)) then
      absorption = absorption + 1.5_wp*rate
      inflow = inflow + rate*(2*rise(i + side) - 0.5_wp*rise(i + 2*side))
    else
      absorption = absorption + rate
      inflow = inflow + rate*rise(i + side)
    end if
  end subroutine bring_from

end module pyworm_line_convection
