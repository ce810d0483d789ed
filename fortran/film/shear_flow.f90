!> Flow of an oil between two sliding walls under a pressure gradient, with its exact derivatives by film, gradient and the
!> stresses of its flow law; for the matrices A, B and C see `shear_stress`.
module pyworm_shear_flow
  use pyworm_flow_laws, only: flow_law, thinning_by_stresses
  use pyworm_gauss_lobatto, only: levels_across
  use pyworm_kinds, only: wp
  use pyworm_shear_stress, only: square_stress
  use pyworm_strip_of_points, only: shear_strip
  implicit none(type, external)
  private

  public :: flow_deficit, flow_change, flow_change_by_stresses

contains

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

  !> The deficit S [m2/s] with its derivatives at given sliding: the mobility dS/d(grad p) = C - B A^-1 B
  !> [m3/(Pa s)], symmetric and positive definite; by the film [m/s]; and by the fluidity at each level [Pa
  !> m2].
  pure subroutine flow_change(levels, strip, deficit_x, deficit_y, mobility_xx, mobility_xy, mobility_yy, by_film_x, &
    by_film_y, by_fluidity_x, by_fluidity_y)
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    real(wp), contiguous, intent(out) :: deficit_x(:), deficit_y(:), mobility_xx(:), mobility_xy(:), mobility_yy(:), &
      by_film_x(:), by_film_y(:), by_fluidity_x(:, :), by_fluidity_y(:, :)
    real(wp) :: x, y, height, weight, along, across
    integer :: i, k

    associate (s => strip, b_xx => strip%a_xx, b_xy => strip%a_xy, b_yy => strip%a_yy)
      deficit_x = 0
      deficit_y = 0
      mobility_xx = 0
      mobility_xy = 0
      mobility_yy = 0
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
          deficit_x(i) = deficit_x(i) + along*x
          deficit_y(i) = deficit_y(i) + along*y
          b_xx(i) = b_xx(i) + along + across*x*x
          b_xy(i) = b_xy(i) + across*x*y
          b_yy(i) = b_yy(i) + along + across*y*y
          mobility_xx(i) = mobility_xx(i) + height*(along + across*x*x)
          mobility_xy(i) = mobility_xy(i) + height*across*x*y
          mobility_yy(i) = mobility_yy(i) + height*(along + across*y*y)
        end do
      end do
      do i = 1, s%points
        s%arm_xx(i) = b_xx(i)*s%inverse_xx(i) + b_xy(i)*s%inverse_xy(i)
        s%arm_xy(i) = b_xx(i)*s%inverse_xy(i) + b_xy(i)*s%inverse_yy(i)
        s%arm_yx(i) = b_xy(i)*s%inverse_xx(i) + b_yy(i)*s%inverse_xy(i)
        s%arm_yy(i) = b_xy(i)*s%inverse_xy(i) + b_yy(i)*s%inverse_yy(i)
        mobility_xx(i) = mobility_xx(i) - s%arm_xx(i)*b_xx(i) - s%arm_xy(i)*b_xy(i)
        mobility_xy(i) = mobility_xy(i) - s%arm_xx(i)*b_xy(i) - s%arm_xy(i)*b_yy(i)
        mobility_yy(i) = mobility_yy(i) - s%arm_yx(i)*b_xy(i) - s%arm_yy(i)*b_yy(i)
        by_film_x(i) = (2*deficit_x(i) - s%arm_xx(i)*s%us(i) - s%arm_xy(i)*s%vs(i) + mobility_xx(i)*s%px(i) &
          + mobility_xy(i)*s%py(i))/s%film(i)
        by_film_y(i) = (2*deficit_y(i) - s%arm_yx(i)*s%us(i) - s%arm_yy(i)*s%vs(i) + mobility_xy(i)*s%px(i) &
          + mobility_yy(i)*s%py(i))/s%film(i)
      end do
      do k = 1, levels%count
        do i = 1, s%points
          height = levels%z(k)*s%film(i)
          weight = levels%weight(k)*s%film(i)*s%g(i, k)
          x = weight*(s%tau_x(i) + height*s%px(i))
          y = weight*(s%tau_y(i) + height*s%py(i))
          by_fluidity_x(i, k) = (height - s%arm_xx(i))*x - s%arm_xy(i)*y
          by_fluidity_y(i, k) = (height - s%arm_yy(i))*y - s%arm_yx(i)*x
        end do
      end do
    end associate
  end subroutine flow_change

  !> Derivatives of the deficit by the reference and the limiting stress [m2/(Pa s)], after `flow_change`.
  pure subroutine flow_change_by_stresses(law, levels, strip, by_reference_x, by_reference_y, by_limit_x, by_limit_y)
    type(flow_law), intent(in) :: law
    type(levels_across), intent(in) :: levels
    type(shear_strip), intent(inout) :: strip
    real(wp), contiguous, intent(out) :: by_reference_x(:), by_reference_y(:), by_limit_x(:), by_limit_y(:)
    real(wp) :: x, y, height, weight, to_x, to_y
    integer :: i, k

    by_reference_x = 0
    by_reference_y = 0
    by_limit_x = 0
    by_limit_y = 0
    associate (s => strip, by_reference => strip%step_x, by_limit => strip%step_y)
      do k = 1, levels%count
        call square_stress(s%points, levels%z(k), s%film, s%px, s%py, s%tau_x, s%tau_y, s%square)
        call thinning_by_stresses(law, s%points, s%square, s%reference, s%limit, s%g(:, k), s%g_slope(:, k), &
          by_reference, by_limit)
        do i = 1, s%points
          height = levels%z(k)*s%film(i)
          x = s%tau_x(i) + height*s%px(i)
          y = s%tau_y(i) + height*s%py(i)
          weight = levels%weight(k)*s%film(i)*s%fluidity(i, k)
          to_x = weight*((height - s%arm_xx(i))*x - s%arm_xy(i)*y)
          to_y = weight*((height - s%arm_yy(i))*y - s%arm_yx(i)*x)
          by_reference_x(i) = by_reference_x(i) + by_reference(i)*to_x
          by_reference_y(i) = by_reference_y(i) + by_reference(i)*to_y
          by_limit_x(i) = by_limit_x(i) + by_limit(i)*to_x
          by_limit_y(i) = by_limit_y(i) + by_limit(i)*to_y
        end do
      end do
    end associate
  end subroutine flow_change_by_stresses

end module pyworm_shear_flow
