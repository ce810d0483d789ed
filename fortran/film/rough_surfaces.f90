!> Two rough surfaces with a film between them, averaged over their roughness.
!>
!> The pressure between them is shared: oil bears what the asperities in contact leave (Johnson, Greenwood and Poon,
!> Wear 19 (1972) 91). Pressure of the asperities, real area of contact, mean thickness of the gap and the flow factors of
!> Patir and Cheng (J. Lubr. Technol. 100 (1978) 12, 101 (1979) 220) depend on the gap between the surfaces' mean planes
!> alone; they are given as tables. Components of a tensor are in the order xx, yy, xy.
module pyworm_rough_surfaces
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_bad_argument, status_no_memory, status_not_finite
  implicit none(type, external)
  private

  public :: gap_curves, rough_film, new_rough_film, share_pressure, asperity_pressure

  !> Curves of a table, in its order.
  integer, parameter, public :: curve_count = 9
  integer, parameter :: log_pressure = 1, surplus = 2, real_area = 3, flow_factor = 4, shear_factor = 7

  !> Curves over the gap between mean planes, as cubics between rows equidistant in asinh(gap/scale); constant beyond
  !> both ends.
  type :: gap_curves
    !> Scale of the gap [m]; asinh(gap/scale) of the first row, and between rows.
    real(wp) :: scale = 0, first = 0, spacing = 0
    !> Values (curve, row): logarithm of the asperities' pressure [Pa], mean thickness less the gap [m], real area of contact
    !> over the nominal, pressure flow factors of the mean thickness's cube, shear flow factors times roughness [m]; and their
    !> derivatives by the rows' coordinate.
    real(wp), allocatable :: value(:, :), slope(:, :)
    !> Coefficients (curve, power, row) of the cubics from each row to the next by the fraction of the way between them.
    real(wp), allocatable :: cubic(:, :, :)
  end type gap_curves

  !> Averages at the nodes.
  type :: rough_film
    type(gap_curves) :: curves
    !> Friction coefficient of asperities in contact.
    real(wp) :: boundary_friction = 0
    !> Total pressure [Pa], and what that of the asperities exceeds it by where the oil's is ambient [Pa].
    real(wp), allocatable :: total(:, :), excess(:, :)
    !> Where the oil had ruptured in the last Newton step: its pressure stays ambient, whatever a step that is not exact leaves
    !> between total and asperities', until oil flows in.
    logical, allocatable :: ruptured(:, :)
    !> Rise of the asperities' pressure as the gap closes [Pa/m]; change of the mean thickness by the gap; real area, and its
    !> change by the gap.
    real(wp), allocatable :: stiffness(:, :), widening(:, :), area(:, :), area_h(:, :)
    !> Flow factors and their derivatives by the gap.
    real(wp), allocatable :: flow(:, :, :), flow_h(:, :, :), shear(:, :, :), shear_h(:, :, :)
    !> Scratch: change of the oil's pressure [Pa].
    real(wp), allocatable :: change(:, :)
  end type rough_film

contains

  !> Makes the averages of nx by ny nodes.
  subroutine new_rough_film(curves, boundary_friction, nx, ny, self, stat)
    type(gap_curves), intent(in) :: curves
    real(wp), intent(in) :: boundary_friction
    integer, intent(in) :: nx, ny
    type(rough_film), intent(out) :: self
    integer, intent(out) :: stat
    integer :: err

    stat = status_bad_argument
    if (.not. (curves%scale > 0 .and. curves%spacing > 0 .and. boundary_friction >= 0)) return
    if (size(curves%value, 1) /= curve_count .or. size(curves%value, 2) < 2) return
    if (any(shape(curves%slope) /= shape(curves%value))) return
    stat = status_not_finite
    if (.not. (all(abs(curves%value) <= huge(1.0_wp)) .and. all(abs(curves%slope) <= huge(1.0_wp)))) return
    self%curves = curves
    call set_cubics(self%curves)
    self%boundary_friction = boundary_friction
    allocate (self%total(nx, ny), self%excess(nx, ny), self%stiffness(nx, ny), self%widening(nx, ny), self%area(nx, ny), &
      self%area_h(nx, ny), self%change(nx, ny), self%flow(nx, ny, 3), self%flow_h(nx, ny, 3), self%shear(nx, ny, 3), &
      self%shear_h(nx, ny, 3), &
      source=0.0_wp, stat=err)
    if (err == 0) allocate (self%ruptured(nx, ny), source=.false., stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
  end subroutine new_rough_film

  !> Sets the coefficients of the cubics.
  pure subroutine set_cubics(curves)
    type(gap_curves), intent(inout) :: curves
    integer :: k, rows

    rows = size(curves%value, 2)
    if (allocated(curves%cubic)) deallocate (curves%cubic)
    allocate (curves%cubic(curve_count, 0:3, rows - 1))
    do k = 1, rows - 1
      associate (a => curves%value(:, k), b => curves%value(:, k + 1), da => curves%spacing*curves%slope(:, k), &
          db => curves%spacing*curves%slope(:, k + 1))
        curves%cubic(:, 0, k) = a
        curves%cubic(:, 1, k) = da
        curves%cubic(:, 2, k) = 3*(b - a) - 2*da - db
        curves%cubic(:, 3, k) = da + db - 2*(b - a)
      end associate
    end do
  end subroutine set_cubics

  !> Takes the total pressure `p` and the gap between mean planes `h` and replaces them by the oil's pressure and the mean
  !> thickness of the gap; sets all averages. Asperities bear where both surfaces are `covered`.
  subroutine share_pressure(self, covered, p, h)
    type(rough_film), intent(inout) :: self
    logical, intent(in) :: covered(:, :)
    real(wp), contiguous, intent(inout) :: p(:, :), h(:, :)
    real(wp) :: value(curve_count), slope(curve_count), asperities
    integer :: i, j

    !$omp parallel do private(i, value, slope, asperities) schedule(static)
    do j = 1, size(p, 2)
      do i = 1, size(p, 1)
        call look_up(self%curves, h(i, j), value, slope)
        self%total(i, j) = p(i, j)
        asperities = merge(exp(value(log_pressure)), 0.0_wp, covered(i, j))
        self%stiffness(i, j) = -slope(log_pressure)*asperities
        self%excess(i, j) = merge(asperities - p(i, j), max(asperities - p(i, j), 0.0_wp), self%ruptured(i, j))
        p(i, j) = merge(0.0_wp, max(p(i, j) - asperities, 0.0_wp), self%ruptured(i, j))
        h(i, j) = h(i, j) + value(surplus)
        self%widening(i, j) = 1 + slope(surplus)
        self%area(i, j) = value(real_area)
        self%area_h(i, j) = slope(real_area)
        self%flow(i, j, :) = value(flow_factor:flow_factor + 2)
        self%flow_h(i, j, :) = slope(flow_factor:flow_factor + 2)
        self%shear(i, j, :) = value(shear_factor:shear_factor + 2)
        self%shear_h(i, j, :) = slope(shear_factor:shear_factor + 2)
      end do
    end do
  end subroutine share_pressure

  !> Computes all curves at a gap [m], and their derivatives by it.
  pure subroutine look_up(curves, gap, value, slope)
    type(gap_curves), intent(in) :: curves
    real(wp), intent(in) :: gap
    real(wp), intent(out) :: value(curve_count), slope(curve_count)
    real(wp) :: row, t, turn
    integer :: k, last

    last = size(curves%value, 2)
    row = (asinh(gap/curves%scale) - curves%first)/curves%spacing
    slope = 0
    ! a gap that is not a number has the last row
    value = curves%value(:, merge(1, last, row <= 0))
    if (.not. (row > 0 .and. row < last - 1)) return
    k = int(row) + 1
    t = row - (k - 1)
    turn = 1/(curves%spacing*hypot(gap, curves%scale))
    associate (c => curves%cubic(:, :, k))
      value = c(:, 1) + t*(c(:, 2) + t*(c(:, 3) + t*c(:, 4)))
      slope = turn*(c(:, 2) + t*(2*c(:, 3) + 3*t*c(:, 4)))
    end associate
  end subroutine look_up

  !> Pressure of the asperities [Pa] in row j, the total less the oil's, p.
  pure function asperity_pressure(self, p, j) result(pressure)
    type(rough_film), intent(in) :: self
    real(wp), intent(in) :: p(:, :)
    integer, intent(in) :: j
    real(wp) :: pressure(size(p, 1))

    pressure = self%total(:, j) - p(:, j)
  end function asperity_pressure

end module pyworm_rough_surfaces
