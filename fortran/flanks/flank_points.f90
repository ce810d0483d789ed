!> Flanks of any profile as points, for their heights over a tangent plane.
!>
!> A helicoid is swept by a curve r0(u) that turns about its axis and advances by p per radian, a wheel flank cut by a hob of
!> that shape. The parameters q are solved for by Newton's method from the two places in the tangent plane and, of the wheel,
!> from the hob's condition of cutting: where its normal N has no part of the velocity V of hob against wheel by the roll,
!>   N . V = 0,     V = Y x point - (p/ratio) hob axis.
!> The height where the step h leads is that of the point less its slopes times the step, right to the step's square.
module pyworm_flank_points
  use pyworm_flank_surface, only: contact_frame, flank_surface, screw_seat, turned_back
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: swept_curve, worm_points, wheel_points, new_worm_points, new_wheel_points

  !> A curve by its coordinates: polynomials of s = (u - middle)/half, and of an arc in the axial plane its height.
  type :: swept_curve
    !> Coefficients of powers of s along x, y and z, the highest first, (3, powers) [m].
    real(wp), allocatable :: coefficients(:, :)
    !> Middle and half of the range of the parameter u [m].
    real(wp) :: middle = 0, half = 1
    !> Radius of an arc z = sqrt(arc^2 - (top - u)^2) [m], zero without one, and radius of its centre [m].
    real(wp) :: arc = 0, top = 0
  end type swept_curve

  !> A helicoid of any profile (`pyworm.drives.worm.flanks.swept_helicoid`).
  type, abstract, extends(flank_surface) :: helicoid_points
    !> The curve that sweeps it.
    type(swept_curve) :: curve
    !> Advance per radian p, and length for which the parameter u stands [m].
    real(wp) :: screw = 0, size = 1
  contains
    procedure :: expand
    procedure :: swing
    procedure, private :: seated
  end type helicoid_points

  !> The worm's flank; the parameters are u and the turn of its curve.
  type, extends(helicoid_points) :: worm_points
  contains
    procedure :: newton => newton_of_worm
    procedure :: rates => rates_of_worm
    procedure :: normals => normals_of_worm
  end type worm_points

  !> The wheel's flank; the parameters are u and turn of the hob's curve and the lag, roll - angle.
  type, extends(helicoid_points) :: wheel_points
    !> Wheel angle by hob angle, threads/teeth.
    real(wp) :: ratio = 1
  contains
    procedure :: newton => newton_of_wheel
    procedure :: rates => rates_of_wheel
    procedure :: normals => normals_of_wheel
    procedure, private :: system
  end type wheel_points

  !> Points of a helicoid with derivatives by u and by the turn.
  type :: expansion
    !> Curve before the turn: its tangent, second derivative and way in the screw motion.
    real(wp) :: along(3), bend(3), swept(3)
    !> Cosine and sine of the turn.
    real(wp) :: cosine, sine
    !> Place [m], and its derivatives, in the drive frame.
    real(wp) :: point(3), by_u(3), by_turn(3)
    !> Whether the curve has such a point.
    logical :: exists
  end type expansion

contains

  !> Points of a worm at its place, at a rotation angle [rad], swept by a curve between two bounds of u, by its advance per
  !> radian and the length for which u stands [m].
  pure function new_worm_points(seat, angle, curve, bounds, screw, size) result(points)
    type(screw_seat), intent(in) :: seat
    type(swept_curve), intent(in) :: curve
    real(wp), intent(in) :: angle, bounds(2), screw, size
    type(worm_points) :: points

    points%parameters = 2
    call form(points, seat, angle, curve, bounds, screw, size)
  end function new_worm_points

  !> Points of a wheel at a rotation angle [rad] by those numbers of its hob and the ratio threads/teeth.
  pure function new_wheel_points(seat, angle, curve, bounds, screw, size, ratio) result(points)
    type(screw_seat), intent(in) :: seat
    type(swept_curve), intent(in) :: curve
    real(wp), intent(in) :: angle, bounds(2), screw, size, ratio
    type(wheel_points) :: points

    points%parameters = 3
    call form(points, seat, angle, curve, bounds, screw, size)
    points%ratio = ratio
  end function new_wheel_points

  !> What points of worms and of hobs have.
  pure subroutine form(points, seat, angle, curve, bounds, screw, size)
    class(helicoid_points), intent(inout) :: points
    type(screw_seat), intent(in) :: seat
    type(swept_curve), intent(in) :: curve
    real(wp), intent(in) :: angle, bounds(2), screw, size

    points%seat = seat
    points%angle = angle
    points%first = bounds(1)
    points%last = bounds(2)
    points%curve = curve
    points%screw = screw
    points%size = size
  end subroutine form

  !> The curve and its first [-] and second [1/m] derivatives at a parameter [m], and whether it has such a point.
  pure subroutine evaluate(curve, u, place, along, bend, exists)
    type(swept_curve), intent(in) :: curve
    real(wp), intent(in) :: u
    real(wp), intent(out) :: place(3), along(3), bend(3)
    logical, intent(out) :: exists
    real(wp) :: s, below, height
    integer :: k

    s = (u - curve%middle)/curve%half
    place = 0
    along = 0
    bend = 0
    do k = 1, size(curve%coefficients, 2)
      bend = bend*s + along
      along = along*s + place
      place = place*s + curve%coefficients(:, k)
    end do
    along = along/curve%half
    bend = 2*bend/curve%half**2
    exists = .true.
    if (.not. curve%arc > 0) return
    below = curve%top - u
    exists = abs(below) < curve%arc
    if (.not. exists) return
    height = sqrt(curve%arc**2 - below**2)
    place(3) = height
    along(3) = below/height
    bend(3) = -curve%arc**2/height**3
  end subroutine evaluate

  !> Points at u, a turn of the curve and an angle of the screw [rad].
  pure function expand(self, u, turn, angle) result(on)
    class(helicoid_points), intent(in) :: self
    real(wp), intent(in) :: u, turn, angle
    type(expansion) :: on
    real(wp) :: place(3)

    call evaluate(self%curve, u*self%size, place, on%along, on%bend, on%exists)
    on%swept = [-place(2), place(1), self%screw]
    on%cosine = cos(turn)
    on%sine = sin(turn)
    place(3) = place(3) + self%screw*(turn - angle)
    on%point = self%seated(on, place)
    on%point(1) = on%point(1) - self%seat%centre_distance
    on%point(2) = on%point(2) + self%seat%axial_shift
    on%by_u = self%size*self%seated(on, on%along)
    on%by_turn = self%seated(on, on%swept)
  end function expand

  !> Normal into the thread there, of any length, and its derivatives by u and by the turn.
  pure subroutine swing(self, on, normal, by_u, by_turn)
    class(helicoid_points), intent(in) :: self
    type(expansion), intent(in) :: on
    real(wp), intent(out) :: normal(3), by_u(3), by_turn(3)
    real(wp) :: own(3)

    own = cross(on%along, on%swept)
    normal = self%seated(on, own)
    by_turn = self%seated(on, [-own(2), own(1), 0.0_wp])
    by_u = self%size*self%seated(on, cross(on%bend, on%swept) + cross(on%along, [-on%along(2), on%along(1), 0.0_wp]))
  end subroutine swing

  !> A vector of the screw after its turn, in the drive frame.
  pure function seated(self, on, vector) result(placed)
    class(helicoid_points), intent(in) :: self
    type(expansion), intent(in) :: on
    real(wp), intent(in) :: vector(3)
    real(wp) :: placed(3), across

    across = on%sine*vector(1) + on%cosine*vector(2)
    associate (upright => self%seat%upright, tilt => self%seat%tilt)
      placed = [on%cosine*vector(1) - on%sine*vector(2), upright*across - tilt*vector(3), tilt*across + upright*vector(3)]
    end associate
  end function seated

  pure subroutine newton_of_worm(self, q, line, frame, height, step, determinant, found)
    class(worm_points), intent(in) :: self
    real(wp), intent(in) :: q(:), line(3)
    type(contact_frame), intent(in) :: frame
    real(wp), intent(out) :: height, step(:), determinant
    logical, intent(out) :: found
    type(expansion) :: on
    real(wp) :: off(3)

    on = self%expand(q(1), q(2), self%angle)
    off = on%point - line
    call solve_two(on, frame, [dot_product(off, frame%ex), dot_product(off, frame%ey)], step, determinant, found)
    height = dot_product(off - on%by_u*step(1) - on%by_turn*step(2), frame%ez)
  end subroutine newton_of_worm

  pure subroutine rates_of_worm(self, q, line, frame, direction, rate)
    class(worm_points), intent(in) :: self
    real(wp), intent(in) :: q(:), line(3), direction(3)
    type(contact_frame), intent(in) :: frame
    real(wp), intent(out) :: rate(:)
    real(wp) :: determinant
    logical :: found

    associate (along => [dot_product(direction, frame%ex), dot_product(direction, frame%ey)])
      call solve_two(self%expand(q(1), q(2), self%angle), frame, along, rate, determinant, found)
    end associate
  end subroutine rates_of_worm

  pure subroutine normals_of_worm(self, q, normal, swings)
    class(worm_points), intent(in) :: self
    real(wp), intent(in) :: q(:)
    real(wp), intent(out) :: normal(3), swings(:, :)

    call self%swing(self%expand(q(1), q(2), self%angle), normal, swings(:, 1), swings(:, 2))
  end subroutine normals_of_worm

  !> Changes of u and turn that lead some way in the tangent plane [m], and the determinant; zero where there are none.
  pure subroutine solve_two(on, frame, way, change, determinant, found)
    type(expansion), intent(in) :: on
    type(contact_frame), intent(in) :: frame
    real(wp), intent(in) :: way(2)
    real(wp), intent(out) :: change(:), determinant
    logical, intent(out) :: found
    real(wp) :: a, b, c, d

    a = dot_product(on%by_u, frame%ex)
    b = dot_product(on%by_turn, frame%ex)
    c = dot_product(on%by_u, frame%ey)
    d = dot_product(on%by_turn, frame%ey)
    determinant = a*d - b*c
    change = 0
    found = on%exists .and. abs(determinant) > 0
    if (found) change(:2) = [d*way(1) - b*way(2), a*way(2) - c*way(1)]/determinant
  end subroutine solve_two

  pure subroutine newton_of_wheel(self, q, line, frame, height, step, determinant, found)
    class(wheel_points), intent(in) :: self
    real(wp), intent(in) :: q(:), line(3)
    type(contact_frame), intent(in) :: frame
    real(wp), intent(out) :: height, step(:), determinant
    logical, intent(out) :: found
    type(expansion) :: on
    real(wp) :: matrix(3, 3), rise(3), miss, seen(3, 3)

    call self%system(q, frame, on, matrix, rise, miss, seen)
    associate (off => matmul(on%point, seen) - [dot_product(line, frame%ex), dot_product(line, frame%ey), &
        dot_product(line, frame%ez)])
      call solve_three(matrix, [off(1), off(2), miss], step, determinant, found)
      found = found .and. on%exists
      height = off(3) - dot_product(rise, step(:3))
    end associate
  end subroutine newton_of_wheel

  pure subroutine rates_of_wheel(self, q, line, frame, direction, rate)
    class(wheel_points), intent(in) :: self
    real(wp), intent(in) :: q(:), line(3), direction(3)
    type(contact_frame), intent(in) :: frame
    real(wp), intent(out) :: rate(:)
    type(expansion) :: on
    real(wp) :: matrix(3, 3), rise(3), miss, seen(3, 3), determinant
    logical :: found

    call self%system(q, frame, on, matrix, rise, miss, seen)
    associate (ahead => [dot_product(direction, frame%ex), dot_product(direction, frame%ey), 0.0_wp])
      call solve_three(matrix, ahead, rate, determinant, found)
    end associate
  end subroutine rates_of_wheel

  !> Point that the hob may cut; derivatives by q of its places along ex and ey and of N . V, in rows, and of its height; N . V
  !> there; and the axes, in columns, turned back by the lag, as they were when it was cut.
  pure subroutine system(self, q, frame, on, matrix, rise, miss, seen)
    class(wheel_points), intent(in) :: self
    real(wp), intent(in) :: q(:)
    type(contact_frame), intent(in) :: frame
    type(expansion), intent(out) :: on
    real(wp), intent(out) :: matrix(3, 3), rise(3), miss, seen(3, 3)
    real(wp) :: roll, pace, axis(3), speed(3), normal(3), by_u(3), by_turn(3), ways(3, 3), cosine, sine

    cosine = cos(q(3))
    sine = sin(q(3))
    seen(:, 1) = turned_back(cosine, sine, frame%ex)
    seen(:, 2) = turned_back(cosine, sine, frame%ey)
    seen(:, 3) = turned_back(cosine, sine, frame%ez)
    roll = q(3) + self%angle
    on = self%expand(q(1), q(2), roll/self%ratio)
    call self%swing(on, normal, by_u, by_turn)
    pace = self%screw/self%ratio
    axis = pace*[0.0_wp, -self%seat%tilt, self%seat%upright]
    speed = about_wheel(on%point) - axis
    ways(:, 1) = on%by_u
    ways(:, 2) = on%by_turn
    ways(:, 3) = speed
    matrix(1, :) = matmul(seen(:, 1), ways)
    matrix(2, :) = matmul(seen(:, 2), ways)
    rise = matmul(seen(:, 3), ways)
    miss = dot_product(normal, speed)
    matrix(3, :) = [dot_product(by_u, speed) + dot_product(normal, about_wheel(on%by_u)), &
      dot_product(by_turn, speed) + dot_product(normal, about_wheel(on%by_turn)), -dot_product(normal, about_wheel(axis))]
  end subroutine system

  pure subroutine normals_of_wheel(self, q, normal, swings)
    class(wheel_points), intent(in) :: self
    real(wp), intent(in) :: q(:)
    real(wp), intent(out) :: normal(3), swings(:, :)
    real(wp) :: of_hob(3), by_u(3), by_turn(3), cosine, sine

    call self%swing(self%expand(q(1), q(2), (q(3) + self%angle)/self%ratio), of_hob, by_u, by_turn)
    cosine = cos(q(3))
    sine = -sin(q(3))
    normal = turned_back(cosine, sine, of_hob)
    swings(:, 1) = turned_back(cosine, sine, by_u)
    swings(:, 2) = turned_back(cosine, sine, by_turn)
    swings(:, 3) = turned_back(cosine, sine, about_wheel(of_hob))
  end subroutine normals_of_wheel

  !> Solution of a system of three equations, and its determinant; zero where there is none.
  pure subroutine solve_three(matrix, right, solution, determinant, found)
    real(wp), intent(in) :: matrix(3, 3), right(3)
    real(wp), intent(out) :: solution(:), determinant
    logical, intent(out) :: found
    real(wp) :: minors(3, 3)

    minors(:, 1) = cross(matrix(2, :), matrix(3, :))
    minors(:, 2) = cross(matrix(3, :), matrix(1, :))
    minors(:, 3) = cross(matrix(1, :), matrix(2, :))
    determinant = dot_product(matrix(1, :), minors(:, 1))
    solution = 0
    found = abs(determinant) > 0
    if (found) solution(:3) = matmul(minors, right)/determinant
  end subroutine solve_three

  !> Cross product of the wheel's axis with a vector.
  pure function about_wheel(vector) result(product)
    real(wp), intent(in) :: vector(3)
    real(wp) :: product(3)

    product = [vector(3), 0.0_wp, -vector(1)]
  end function about_wheel

  pure function cross(first, other) result(product)
    real(wp), intent(in) :: first(3), other(3)
    real(wp) :: product(3)

    product = [first(2)*other(3) - first(3)*other(2), first(3)*other(1) - first(1)*other(3), &
      first(1)*other(2) - first(2)*other(1)]
  end function cross

end module pyworm_flank_points
