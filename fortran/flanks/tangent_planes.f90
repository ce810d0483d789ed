!> Flanks of involute helicoids as families of tangent planes, for their heights over a tangent plane.
!>
!> Such a flank is an envelope of planes, so its height over a point of the tangent plane is the stationary value, over the
!> family's parameters q, of the height T(q) at which the plane q crosses the line through the point along the common normal:
!>   T = (support(q) - normal(q) . line)/B,     B = normal(q) . ez.
!> Newton's method on dT/dq = 0 settles it. With p the point of the crossing and n_i, s_i the derivatives of normal and
!> support by q,
!>   T_i = (s_i - n_i . p)/B,     T_ij = (s_ij - n_ij . p)/B,
!> the latter where T_i = 0, which is near enough for Newton's method. Its step h also gives the stationary value itself,
!> T - T_i h_i/2, to the step's cube: the height is right to rounding where q is not yet. The rates of q over the plane follow
!> by implicit differentiation, q_x = -(T_ij)^-1 T_xj, with T_xi = -n_i . (ex + T_x ez)/B.
module pyworm_tangent_planes
  use pyworm_flank_surface, only: contact_frame, flank_surface, most_parameters, screw_seat
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: worm_planes, wheel_planes, new_worm_planes, new_wheel_planes

  !> Tangent planes of an involute helicoid.
  type, abstract, extends(flank_surface) :: plane_family
    !> Sine and cosine of the lead angle on the base cylinder.
    real(wp) :: across = 0, along = 1
    !> Advance of a plane along its normal per radian of the screw [m].
    real(wp) :: base_travel = 0
  contains
    procedure(family_at), deferred :: at
    procedure :: newton => newton_of_planes
    procedure :: rates => rates_of_planes
    procedure :: normals => normals_of_planes
    procedure, private :: crossing
    procedure, private :: planes
  end type plane_family

  !> Those of the worm; the parameter is theta.
  type, extends(plane_family) :: worm_planes
  contains
    procedure :: at => worm_at
  end type worm_planes

  !> Those of the wheel; the parameters are the hob's theta and the lag, roll - angle.
  type, extends(plane_family) :: wheel_planes
    !> Moment arm of every normal about the wheel's axis [m].
    real(wp) :: lever = 0
  contains
    procedure :: at => wheel_at
  end type wheel_planes

  abstract interface
    !> Support [m] and normal of a plane, (0), their derivatives by the parameters, (1:2), and second ones, 11, 12 and 22.
    pure subroutine family_at(self, q, support, normal, support_bend, normal_bend)
      import :: plane_family, wp
      implicit none(type, external)
      class(plane_family), intent(in) :: self
      real(wp), intent(in) :: q(:)
      real(wp), intent(out) :: support(0:2), normal(3, 0:2), support_bend(3), normal_bend(3, 3)
    end subroutine family_at
  end interface

contains

  !> Planes of a worm at its place, at a rotation angle [rad], by the lead angle on its base cylinder [rad] and the advance of
  !> a plane along its normal per radian [m].
  pure function new_worm_planes(seat, angle, base_lead_angle, base_travel) result(planes)
    type(screw_seat), intent(in) :: seat
    real(wp), intent(in) :: angle, base_lead_angle, base_travel
    type(worm_planes) :: planes

    planes%parameters = 1
    call form(planes, seat, angle, base_lead_angle, base_travel)
  end function new_worm_planes

  !> Planes of a wheel at a rotation angle [rad] by those numbers of its hob and the moment arm of its normals [m].
  pure function new_wheel_planes(seat, angle, base_lead_angle, base_travel, lever) result(planes)
    type(screw_seat), intent(in) :: seat
    real(wp), intent(in) :: angle, base_lead_angle, base_travel, lever
    type(wheel_planes) :: planes

    planes%parameters = 2
    call form(planes, seat, angle, base_lead_angle, base_travel)
    planes%lever = lever
  end function new_wheel_planes

  !> What planes of worms and of hobs have.
  pure subroutine form(planes, seat, angle, base_lead_angle, base_travel)
    class(plane_family), intent(inout) :: planes
    type(screw_seat), intent(in) :: seat
    real(wp), intent(in) :: angle, base_lead_angle, base_travel

    planes%seat = seat
    planes%angle = angle
    planes%across = sin(base_lead_angle)
    planes%along = cos(base_lead_angle)
    planes%base_travel = base_travel
  end subroutine form

  !> The tangent plane of a generator at rotation angle 0 and its first two derivatives by theta.
  pure subroutine planes(self, theta, support, normal)
    class(plane_family), intent(in) :: self
    real(wp), intent(in) :: theta
    real(wp), intent(out) :: support(0:2), normal(3, 0:2)
    real(wp) :: x, y

    x = self%across*cos(theta)
    y = self%across*sin(theta)
    associate (upright => self%seat%upright, tilt => self%seat%tilt)
      normal(:, 0) = [y, -upright*x - tilt*self%along, upright*self%along - tilt*x]
      normal(:, 1) = [x, upright*y, tilt*y]
      normal(:, 2) = [-y, upright*x, tilt*x]
    end associate
    support = self%seat%axial_shift*normal(2, :) - self%seat%centre_distance*normal(1, :)
    support(0) = support(0) + self%base_travel*theta
    support(1) = support(1) + self%base_travel
  end subroutine planes

  pure subroutine worm_at(self, q, support, normal, support_bend, normal_bend)
    class(worm_planes), intent(in) :: self
    real(wp), intent(in) :: q(:)
    real(wp), intent(out) :: support(0:2), normal(3, 0:2), support_bend(3), normal_bend(3, 3)

    call self%planes(q(1), support, normal)
    support_bend = 0
    normal_bend = 0
    support_bend(1) = support(2)
    normal_bend(:, 1) = normal(:, 2)
    support(0) = support(0) - self%base_travel*self%angle
  end subroutine worm_at

  pure subroutine wheel_at(self, q, support, normal, support_bend, normal_bend)
    class(wheel_planes), intent(in) :: self
    real(wp), intent(in) :: q(:)
    real(wp), intent(out) :: support(0:2), normal(3, 0:2), support_bend(3), normal_bend(3, 3)
    real(wp) :: of_hob(0:2), cosine, sine
    integer :: k

    call self%planes(q(1), of_hob, normal)
    cosine = cos(q(2))
    sine = sin(q(2))
    do k = 0, 2
      normal(:, k) = [cosine*normal(1, k) + sine*normal(3, k), normal(2, k), cosine*normal(3, k) - sine*normal(1, k)]
    end do
    support = [of_hob(0) - self%lever*(q(2) + self%angle), of_hob(1), -self%lever]
    support_bend = [of_hob(2), 0.0_wp, 0.0_wp]
    normal_bend(:, 1) = normal(:, 2)
    normal_bend(:, 2) = [normal(3, 1), 0.0_wp, -normal(1, 1)]
    normal_bend(:, 3) = [-normal(1, 0), 0.0_wp, -normal(3, 0)]
    normal(:, 2) = [normal(3, 0), 0.0_wp, -normal(1, 0)]
  end subroutine wheel_at

  !> T [m], T_i and T_ij of a plane where it crosses a line along the common normal.
  pure subroutine crossing(self, q, line, ez, height, slope, bend)
    class(plane_family), intent(in) :: self
    real(wp), intent(in) :: q(:), line(3), ez(3)
    real(wp), intent(out) :: height, slope(2), bend(3)
    real(wp) :: support(0:2), normal(3, 0:2), support_bend(3), normal_bend(3, 3), lift, point(3)

    call self%at(q, support, normal, support_bend, normal_bend)
    lift = dot_product(normal(:, 0), ez)
    height = (support(0) - dot_product(normal(:, 0), line))/lift
    point = line + height*ez
    slope = (support(1:) - matmul(point, normal(:, 1:)))/lift
    bend = (support_bend - matmul(point, normal_bend))/lift
  end subroutine crossing

  pure subroutine newton_of_planes(self, q, line, frame, height, step, determinant, found)
    class(plane_family), intent(in) :: self
    real(wp), intent(in) :: q(:), line(3)
    type(contact_frame), intent(in) :: frame
    real(wp), intent(out) :: height, step(:), determinant
    logical, intent(out) :: found
    real(wp) :: slope(2), bend(3)

    call self%crossing(q, line, frame%ez, height, slope, bend)
    determinant = determinant_of(self%parameters, bend)
    step = 0
    found = abs(determinant) > 0
    if (.not. found) return
    call solve(self%parameters, bend, slope, step)
    height = height - dot_product(slope(:self%parameters), step(:self%parameters))/2
  end subroutine newton_of_planes

  pure subroutine rates_of_planes(self, q, line, frame, direction, rate)
    class(plane_family), intent(in) :: self
    real(wp), intent(in) :: q(:), line(3), direction(3)
    type(contact_frame), intent(in) :: frame
    real(wp), intent(out) :: rate(:)
    real(wp) :: height, slope(2), bend(3), tilt, by_q(most_parameters)

    call self%crossing(q, line, frame%ez, height, slope, bend)
    call self%tilted(q, direction, frame, tilt, by_q)
    call solve(self%parameters, bend, -by_q(:2), rate)
  end subroutine rates_of_planes

  pure subroutine normals_of_planes(self, q, normal, swings)
    class(plane_family), intent(in) :: self
    real(wp), intent(in) :: q(:)
    real(wp), intent(out) :: normal(3), swings(:, :)
    real(wp) :: support(0:2), family(3, 0:2), support_bend(3), normal_bend(3, 3)

    call self%at(q, support, family, support_bend, normal_bend)
    normal = family(:, 0)
    swings(:, :2) = family(:, 1:)
  end subroutine normals_of_planes

  pure real(wp) function determinant_of(count, matrix)
    integer, intent(in) :: count
    real(wp), intent(in) :: matrix(3)

    determinant_of = matrix(1)
    if (count == 2) determinant_of = matrix(1)*matrix(3) - matrix(2)*matrix(2)
  end function determinant_of

  !> Solution of a 1 x 1 or symmetric 2 x 2 system.
  pure subroutine solve(count, matrix, right, solution)
    integer, intent(in) :: count
    real(wp), intent(in) :: matrix(3), right(2)
    real(wp), intent(out) :: solution(:)
    real(wp) :: scale

    solution = 0
    scale = 1/determinant_of(count, matrix)
    if (count == 1) then
      solution(1) = right(1)*scale
    else
      solution(1) = (matrix(3)*right(1) - matrix(2)*right(2))*scale
      solution(2) = (matrix(1)*right(2) - matrix(2)*right(1))*scale
    end if
  end subroutine solve

end module pyworm_tangent_planes
