!> Flow of an oil between two sliding walls under a pressure gradient, with its exact derivatives by film, gradient and the
!> stresses of its flow law; for the matrices A, B and C see `shear_stress`.
module pyworm_shear_flow
  use pyworm_flow_laws, only: flow_law, thinning_by_stresses
  use pyworm_gauss_lobatto, only: levels_across
  use pyworm_kinds, only: wp
  use pyworm_shear_stress, only: square_stress
  use pyworm_status, only: status_ok, status_no_memory
  use pyworm_strip_of_points, only: shear_strip
  implicit none(type, external)
  private

  public :: flow_deficit, deficit_change, new_deficit_change, flow_change, flow_change_by_stresses

  !> Flow deficit S of the points of a strip, linearised at given sliding.
  type :: deficit_change
    !> S [m2/s].
    real(wp), allocatable :: x(:), y(:)
    !> Mobility dS/d(grad p) = C - B A^-1 B [m3/(Pa s)], symmetric and positive definite.
    real(wp), allocatable :: mobility_xx(:), mobility_xy(:), mobility_yy(:)
    !> Derivative by the film [m/s].
    real(wp), allocatable :: by_film_x(:), by_film_y(:)
    !> Derivative by the fluidity at each level [Pa m2].
    real(wp), allocatable :: by_fluidity_x(:, :), by_fluidity_y(:, :)
    !> Derivatives by the stress at which the flow law departs from Newton's and by the limiting stress [m2/(Pa s)].
    real(wp), allocatable :: by_onset_x(:), by_onset_y(:), by_limit_x(:), by_limit_y(:)
  end type deficit_change

contains

  !> Allocates the linearised deficit of a strip of up to `points` points.
  subroutine new_deficit_change(points, levels, deficit, stat)
    integer, intent(in) :: points, levels
    type(deficit_change), intent(out) :: deficit
    integer, intent(out) :: stat
    integer :: err

    allocate (deficit%x(points), deficit%y(points), deficit%mobility_xx(points), deficit%mobility_xy(points), &
      deficit%mobility_yy(points), deficit%by_film_x(points), deficit%by_film_y(points), deficit%by_onset_x(points), &
      deficit%by_onset_y(points), deficit%by_limit_x(points), deficit%by_limit_y(points), &
      deficit%by_fluidity_x(points, levels), deficit%by_fluidity_y(points, levels), source=0.0_wp, stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
  end subroutine new_deficit_change

  !> Flow deficit [m2/s] by shear, S = int z' f g tau dz': the film carries u h - S, with u the mean velocity of the
  !> bodies (Sharif et al., eqs 10 and 11).
  pure subroutine flow_deficit(levels, strip, deficit_x, deficit_y)
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(in) :: strip
    real(wp), contiguous, intent(out) :: deficit_x(:), deficit_y(:)
    real(wp) :: weight
    integer :: i, k

    deficit_x = 0
    deficit_y = 0
    do k = 1, levels%count
      do i = 1, strip%points
        weight = levels%weight(k)*levels%z(k)*strip%film(i)**2*strip%fluidity(i, k)*strip%g(i, k)
        deficit_x(i) = deficit_x(i) + weight*(strip%tau_x(i) + levels%z(k)*strip%film(i)*strip%px(i))
        deficit_y(i) = deficit_y(i) + weight*(strip%tau_y(i) + levels%z(k)*strip%film(i)*strip%py(i))
      end do
    end do
  end subroutine flow_deficit

  !> Computes the deficit with its derivatives at given sliding, but those by the flow law's stresses.
  pure subroutine flow_change(levels, strip, deficit)
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    type(deficit_change), intent(inout) :: deficit

    call sum_levels(levels, strip, deficit)
    call hold_sliding(strip, deficit)
    call set_by_fluidity(levels, strip, deficit)
  end subroutine flow_change

  !> Sums the deficit and the matrices B and C over the levels; C becomes part of the mobility.
  pure subroutine sum_levels(levels, strip, deficit)
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    type(deficit_change), intent(inout) :: deficit
    real(wp) :: x, y, height, weight, along, across
    integer :: i, k

    associate (s => strip, b_xx => strip%a_xx, b_xy => strip%a_xy, b_yy => strip%a_yy, d => deficit)
      d%x = 0
      d%y = 0
      d%mobility_xx = 0
      d%mobility_xy = 0
      d%mobility_yy = 0
      b_xx = 0
      b_xy = 0
      b_yy = 0
      do k = 1, levels%count
        do i = 1, s%points
          height = levels%z(k)*s%film(i)
          x = s%tau_x(i) + height*s%px(i)
          y = s%tau_y(i) + height*s%py(i)
          weight = levels%weight(k)*s%film(i)*s%fluidity(i, k)*height
          along = weight*s%g(i, k)
          across = 2*weight*s%g_slope(i, k)
          d%x(i) = d%x(i) + along*x
          d%y(i) = d%y(i) + along*y
          b_xx(i) = b_xx(i) + along + across*x*x
          b_xy(i) = b_xy(i) + across*x*y
          b_yy(i) = b_yy(i) + along + across*y*y
          d%mobility_xx(i) = d%mobility_xx(i) + height*(along + across*x*x)
          d%mobility_xy(i) = d%mobility_xy(i) + height*across*x*y
          d%mobility_yy(i) = d%mobility_yy(i) + height*(along + across*y*y)
        end do
      end do
    end associate
  end subroutine sum_levels

  !> Subtracts what keeps the sliding as given: the stress changes by -A^-1 B times a change of the gradient, which makes the
  !> mobility C - B A^-1 B.
  pure subroutine hold_sliding(strip, deficit)
    type(shear_strip), intent(inout) :: strip
    type(deficit_change), intent(inout) :: deficit
    integer :: i

    associate (s => strip, b_xx => strip%a_xx, b_xy => strip%a_xy, b_yy => strip%a_yy, d => deficit)
      do i = 1, s%points
        s%arm_xx(i) = b_xx(i)*s%inverse_xx(i) + b_xy(i)*s%inverse_xy(i)
        s%arm_xy(i) = b_xx(i)*s%inverse_xy(i) + b_xy(i)*s%inverse_yy(i)
        s%arm_yx(i) = b_xy(i)*s%inverse_xx(i) + b_yy(i)*s%inverse_xy(i)
        s%arm_yy(i) = b_xy(i)*s%inverse_xy(i) + b_yy(i)*s%inverse_yy(i)
        d%mobility_xx(i) = d%mobility_xx(i) - s%arm_xx(i)*b_xx(i) - s%arm_xy(i)*b_xy(i)
        d%mobility_xy(i) = d%mobility_xy(i) - s%arm_xx(i)*b_xy(i) - s%arm_xy(i)*b_yy(i)
        d%mobility_yy(i) = d%mobility_yy(i) - s%arm_yx(i)*b_xy(i) - s%arm_yy(i)*b_yy(i)
        d%by_film_x(i) = (2*d%x(i) - s%arm_xx(i)*s%us(i) - s%arm_xy(i)*s%vs(i) + d%mobility_xx(i)*s%px(i) &
          + d%mobility_xy(i)*s%py(i))/s%film(i)
        d%by_film_y(i) = (2*d%y(i) - s%arm_yx(i)*s%us(i) - s%arm_yy(i)*s%vs(i) + d%mobility_xy(i)*s%px(i) &
          + d%mobility_yy(i)*s%py(i))/s%film(i)
      end do
    end associate
  end subroutine hold_sliding

  !> Sets the derivative of the deficit by the fluidity at each level.
  pure subroutine set_by_fluidity(levels, strip, deficit)
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(in) :: strip
    type(deficit_change), intent(inout) :: deficit
    real(wp) :: x, y, height, weight
    integer :: i, k

    associate (s => strip)
      do k = 1, levels%count
        do i = 1, s%points
          height = levels%z(k)*s%film(i)
          weight = levels%weight(k)*s%film(i)*s%g(i, k)
          x = weight*(s%tau_x(i) + height*s%px(i))
          y = weight*(s%tau_y(i) + height*s%py(i))
          deficit%by_fluidity_x(i, k) = (height - s%arm_xx(i))*x - s%arm_xy(i)*y
          deficit%by_fluidity_y(i, k) = (height - s%arm_yy(i))*y - s%arm_yx(i)*x
        end do
      end do
    end associate
  end subroutine set_by_fluidity

  !> Computes the derivatives of the deficit by the stresses of the flow law, after `flow_change`.
  pure subroutine flow_change_by_stresses(law, levels, strip, deficit)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    type(deficit_change), intent(inout) :: deficit
    real(wp) :: x, y, height, weight, to_x, to_y
    integer :: i, k

    deficit%by_onset_x = 0
    deficit%by_onset_y = 0
    deficit%by_limit_x = 0
    deficit%by_limit_y = 0
    associate (s => strip, by_onset => strip%step_x, by_limit => strip%step_y)
      do k = 1, levels%count
        call square_stress(s%points, levels%z(k), s%film, s%px, s%py, s%tau_x, s%tau_y, s%square)
        call thinning_by_stresses(law, s%points, s%square, s%reference, s%limit, s%g(:, k), s%g_slope(:, k), &
          by_onset, by_limit)
        do i = 1, s%points
          height = levels%z(k)*s%film(i)
          x = s%tau_x(i) + height*s%px(i)
          y = s%tau_y(i) + height*s%py(i)
          weight = levels%weight(k)*s%film(i)*s%fluidity(i, k)
          to_x = weight*((height - s%arm_xx(i))*x - s%arm_xy(i)*y)
          to_y = weight*((height - s%arm_yy(i))*y - s%arm_yx(i)*x)
          deficit%by_onset_x(i) = deficit%by_onset_x(i) + by_onset(i)*to_x
          deficit%by_onset_y(i) = deficit%by_onset_y(i) + by_onset(i)*to_y
          deficit%by_limit_x(i) = deficit%by_limit_x(i) + by_limit(i)*to_x
          deficit%by_limit_y(i) = deficit%by_limit_y(i) + by_limit(i)*to_y
        end do
      end do
    end associate
  end subroutine flow_change_by_stresses

end module pyworm_shear_flow
