!> Points of a film with their levels, for the flow across the film; strips of points, so that loops are over points.
module pyworm_strip_of_points
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_no_memory
  implicit none(type, external)
  private

  public :: shear_strip, new_shear_strip

  !> Bits of a point's slip.
  integer, parameter, public :: slip_at_body_1 = 1, slip_at_body_2 = 2

  !> Points of a film, and its levels as second index.
  type :: shear_strip
    !> Number of points in use.
    integer :: points = 0
    !> Number of points whose stress did not converge; counted and reset by the callers.
    integer :: unsolved = 0
    !> Input: film [m], pressure gradient [Pa/m], velocity of body 2 over body 1 [m/s], reference and
    !> limiting stress [Pa] of the flow law, and fluidity 1/eta [1/(Pa s)] at the levels.
    real(wp), allocatable :: film(:), px(:), py(:), us(:), vs(:), reference(:), limit(:), fluidity(:, :)
    !> Share of the area that oil covers, the rest asperities in contact.
    real(wp), allocatable :: wetted(:)
    !> Stress halfway [Pa]: the initial guess, or zero for none, then the solution.
    real(wp), allocatable :: tau_x(:), tau_y(:)
    !> Where the film slips: 0, slip_at_body_1, slip_at_body_2, or their sum.
    integer, allocatable :: slip(:)
    !> Thinning [-] at the levels and its derivative by the square of the stress [1/Pa2].
    real(wp), allocatable :: g(:, :), g_slope(:, :)
    !> Inverse of the kinematic matrix A [Pa s/m].
    real(wp), allocatable :: inverse_xx(:), inverse_xy(:), inverse_yy(:)
    !> B A^-1 [m], derivative of the flow by the missing velocity; set by `flow_change`.
    real(wp), allocatable :: arm_xx(:), arm_xy(:), arm_yx(:), arm_yy(:)
    !> Scratch: a field of the levels.
    real(wp), allocatable :: at_levels(:, :)
    !> Scratch: reciprocal squares of the law's stresses, squares of the stress, sums over the film, a step.
    real(wp), allocatable :: per_reference(:), per_limit(:), square(:), rest_x(:), rest_y(:), power(:), ease(:), a_xx(:), a_xy(:), &
      a_yy(:), step_x(:), step_y(:), excess(:)
  end type shear_strip

contains

  !> Allocates a strip of up to `points` points with `levels` levels.
  subroutine new_shear_strip(points, levels, strip, stat)
    integer, intent(in) :: points, levels
    type(shear_strip), intent(out) :: strip
    integer, intent(out) :: stat
    integer :: err

    allocate (strip%film(points), strip%px(points), strip%py(points), strip%us(points), strip%vs(points), strip%wetted(points), &
      strip%reference(points), strip%limit(points), strip%fluidity(points, levels), strip%tau_x(points), &
      strip%tau_y(points), strip%slip(points), strip%g(points, levels), strip%g_slope(points, levels), &
      strip%inverse_xx(points), strip%inverse_xy(points), strip%inverse_yy(points), strip%arm_xx(points), &
      strip%arm_xy(points), strip%arm_yx(points), strip%arm_yy(points), strip%square(points), &
      strip%rest_x(points), strip%rest_y(points), strip%power(points), strip%ease(points), strip%a_xx(points), strip%a_xy(points), &
      strip%a_yy(points), strip%step_x(points), strip%step_y(points), strip%excess(points), &
      strip%per_reference(points), strip%per_limit(points), strip%at_levels(points, levels), &
      stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
    if (stat /= status_ok) return
    strip%points = points
    strip%tau_x = 0
    strip%tau_y = 0
    strip%reference = 1
    strip%wetted = 1
    strip%limit = 1
  end subroutine new_shear_strip

end module pyworm_strip_of_points
