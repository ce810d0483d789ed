!> Averages over the roughness of two surfaces, by the gap between their mean planes, for `rough_surfaces`.
!>
!> Pressure and real area of asperities of one radius (Greenwood and Tripp, Proc. IMechE 185 (1970) 625), or of surfaces that
!> are rough on all scales (Persson, arXiv:0706.2762), with a hardness that limits both; flow factors by `patir_cheng`. The
!> same as `pyworm/materials/rough_surfaces.py`, whose formulas and constants have their sources there.
module pyworm_roughness_curves
  use pyworm_cubic_spline, only: monotone_slopes
  use pyworm_kinds, only: wp
  use pyworm_patir_cheng, only: open_gap, overlap, pressure_flow_factor, shear_flow_factor
  use pyworm_rough_surfaces, only: curve_count, gap_curves
  implicit none(type, external)
  private

  public :: rough_side, curves_of, curves_through, gap_under

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Mean thickness of the gap between surfaces pressed together, over their roughness.
  real(wp), parameter :: least_gap = 0.05_wp
  !> Rows, and their least and largest gap over the roughness.
  integer, parameter :: rows = 500
  real(wp), parameter :: first_gap = -6, last_gap = 1e4_wp
  !> Logarithm of the least pressure of asperities [Pa], and the least real area.
  real(wp), parameter :: least_logarithm = -600, least_area = 1e-30_wp
  !> Pressure at mean planes that touch over E* h'rms, gap over Rq in which it falls e-fold, and area times E* h'rms over it.
  real(wp), parameter :: touching = 0.34_wp, fall_length = 0.47_wp, area_factor = 2
  !> Cells of the integral over heights, and the height over the roughness that none exceeds.
  integer, parameter :: height_cells = 2000
  real(wp), parameter :: largest_height = 35

  !> Roughness of one surface: root mean square height [m] and slope [-], correlation length along the lay over that across,
  !> angle of the lay from the x axis [rad], hardness [Pa], composite roughness over the radius of asperities of one radius
  !> (zero without), and such asperities for each area times radius times composite roughness.
  type :: rough_side
    real(wp) :: height = 0, slope = 0, aspect = 1, lay = 0, hardness = huge(1.0_wp), sharpness = 0, density = 0
  end type rough_side

contains

  !> Curves of two surfaces of the reduced modulus E' [Pa].
  pure function curves_of(sides, reduced_modulus) result(curves)
    type(rough_side), intent(in) :: sides(2)
    real(wp), intent(in) :: reduced_modulus
    type(gap_curves) :: curves
    real(wp), dimension(3) :: flow, shear
    real(wp) :: values(curve_count, rows), height, row(2), gap, thickness, pressure, area
    integer :: k

    height = hypot(sides(1)%height, sides(2)%height)
    row = asinh([first_gap, last_gap])
    do k = 1, rows
      gap = sinh(row(1) + (k - 1)*((row(2) - row(1))/(rows - 1)))
      thickness = sqrt(sqrt(open_gap(gap)**4 + least_gap**4))
      call bear(sides, reduced_modulus/2, gap, pressure, area)
      call flow_factors_of(sides, height, gap, flow, shear)
      values(:2, k) = [log(max(pressure, exp(least_logarithm))), (thickness - gap)*height]
      values(3, k) = merge(area, 0.0_wp, area > least_area)
      values(4:6, k) = (flow*max(gap, 0.0_wp)**3 + least_gap**3*[1, 1, 0])/thickness**3
      values(7:, k) = shear*height
    end do
    curves = curves_through(height, row(1), (row(2) - row(1))/(rows - 1), values)
  end function curves_of

  !> Monotone curves through values (curve, row).
  pure function curves_through(scale, first, spacing, values) result(curves)
    real(wp), intent(in) :: scale, first, spacing, values(:, :)
    type(gap_curves) :: curves
    real(wp) :: slopes(size(values, 1), size(values, 2)), places(size(values, 2))
    integer :: i

    places = [(spacing*i, i=0, size(values, 2) - 1)]
    do i = 1, size(values, 1)
      slopes(i, :) = monotone_slopes(places, values(i, :))
    end do
    curves = gap_curves(scale, first, spacing, values, slopes)
  end function curves_through

  !> Gap between mean planes [m] at which asperities alone bear a pressure [Pa], linear between the rows.
  pure real(wp) function gap_under(curves, pressure)
    type(gap_curves), intent(in) :: curves
    real(wp), intent(in) :: pressure
    real(wp) :: wanted, fraction
    integer :: k

    wanted = log(pressure)
    associate (bearing => curves%value(1, :))
      k = min(max(count(bearing >= wanted), 1), size(bearing) - 1)
      fraction = 0
      if (bearing(k) > bearing(k + 1)) fraction = (bearing(k) - wanted)/(bearing(k) - bearing(k + 1))
      fraction = min(max(fraction, 0.0_wp), 1.0_wp)
      gap_under = (1 - fraction)*gap_at(k) + fraction*gap_at(k + 1)
    end associate

  contains

    !> Gap of a row [m].
    pure real(wp) function gap_at(row)
      integer, intent(in) :: row

      gap_at = curves%scale*sinh(curves%first + (row - 1)*curves%spacing)
    end function gap_at

  end function gap_under

  !> Pressure of the asperities [Pa] and real area over the nominal one at a gap over the roughness; `modulus` is E* [Pa].
  pure subroutine bear(sides, modulus, gap, pressure, area)
    type(rough_side), intent(in) :: sides(2)
    real(wp), intent(in) :: modulus, gap
    real(wp), intent(out) :: pressure, area
    real(wp) :: stiffness, hardness, share
    integer :: sharp

    if (any(sides%sharpness > 0)) then
      sharp = maxloc(sides%height, dim=1, mask=sides%sharpness > 0)
      associate (density => sides(sharp)%density)
        pressure = 16*sqrt(2.0_wp)*pi/15*density**2*sqrt(sides(sharp)%sharpness)*modulus*overlap_moment(2.5_wp, gap)
        area = (pi*density)**2*overlap_moment(2.0_wp, gap)
      end associate
    else
      stiffness = modulus*hypot(sides(1)%slope, sides(2)%slope)
      pressure = touching*stiffness*exp(-gap/fall_length)
      area = min(area_factor*pressure/stiffness, 1.0_wp)
    end if
    hardness = minval(sides%hardness)
    if (hardness >= huge(1.0_wp)) return
    share = 1/hypot(1.0_wp, pressure/(hardness*max(overlap(gap), tiny(1.0_wp))))
    pressure = pressure*share
    area = max(area*share, overlap(gap)*sqrt(1 - share**2))
  end subroutine bear

  !> Moment int_gap^inf (t - gap)^order exp(-t^2/2) dt/sqrt(2 pi) of the heights above a gap, with t - gap = s^2 by Simpson's
  !> rule.
  pure real(wp) function overlap_moment(order, gap)
    real(wp), intent(in) :: order, gap
    real(wp) :: step, s
    integer :: k

    overlap_moment = 0
    if (.not. gap < largest_height) return
    step = sqrt(largest_height - gap)/height_cells
    do k = 1, height_cells
      s = k*step
      overlap_moment = overlap_moment + merge(4, 2, mod(k, 2) == 1)*s**(2*order + 1)*exp(-(gap + s**2)**2/2)
    end do
    overlap_moment = overlap_moment*2*step/3/sqrt(2*pi)
  end function overlap_moment

  !> Pressure and shear flow factors [-] at a gap over the roughness, tensors xx, yy, xy: those of both surfaces add with their
  !> shares of the variance.
  pure subroutine flow_factors_of(sides, height, gap, flow, shear)
    type(rough_side), intent(in) :: sides(2)
    real(wp), intent(in) :: height, gap
    real(wp), intent(out) :: flow(3), shear(3)
    real(wp) :: share, aspect, angle, tensor(3)
    integer :: side, turn

    flow = 0
    shear = 0
    do side = 1, 2
      share = (sides(side)%height/height)**2
      do turn = 0, 1
        aspect = merge(sides(side)%aspect, 1/sides(side)%aspect, turn == 0)
        angle = sides(side)%lay + turn*pi/2
        tensor = [cos(angle)**2, sin(angle)**2, cos(angle)*sin(angle)]
        flow = flow + share*tensor*pressure_flow_factor(gap, aspect)
        shear = shear + merge(1, -1, side == 1)*share*tensor*shear_flow_factor(gap, aspect)
      end do
    end do
  end subroutine flow_factors_of

end module pyworm_roughness_curves
