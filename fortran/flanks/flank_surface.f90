!> A flank at an instant, by parameters q, as heights over a tangent plane ask for it.
!>
!> Flanks are worm and wheel flanks of cylindrical worm gears: of involutes as families of tangent planes
!> (`tangent_planes`), of all profiles as points (`flank_points`). `pyworm/drives/worm/flanks` has the geometry.
module pyworm_flank_surface
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: contact_frame, flank_surface, screw_seat, new_screw_seat, turned_back

  !> Largest number of parameters.
  integer, parameter, public :: most_parameters = 3

  !> Axes of a contact, unit vectors, the last along the common normal, and its point [m], in the drive frame.
  type :: contact_frame
    real(wp) :: ex(3), ey(3), ez(3), origin(3)
  end type contact_frame

  !> Place of a screw in the drive frame (`pyworm.drives.worm.flanks.helicoid.Seated`).
  type :: screw_seat
    !> Distance of its axis from the wheel's, and its shift along the wheel's axis [m].
    real(wp) :: centre_distance = 0, axial_shift = 0
    !> Cosine and sine of the turn of its axis about X.
    real(wp) :: upright = 1, tilt = 0
  end type screw_seat

  type, abstract :: flank_surface
    !> Number of parameters q.
    integer :: parameters = 0
    !> Rotation angle of the body [rad].
    real(wp) :: angle = 0
    !> Place of the screw, the worm's or its hob's.
    type(screw_seat) :: seat
    !> Values of the first parameter between which the flank exists.
    real(wp) :: first = -huge(1.0_wp), last = huge(1.0_wp)
  contains
    procedure(newton_step), deferred :: newton
    procedure(change_along), deferred :: rates
    procedure(normal_field), deferred :: normals
    procedure :: margin
    procedure :: tilted
  end type flank_surface

  abstract interface
    !> One step of Newton's method to the place of the flank on a line along the common normal through a point of the
    !> tangent plane [m]: height along it where the step leads [m], right to the square of the step at least; the step to be
    !> taken off q; a determinant that vanishes at the flank's edge of regression; and whether there is such a step.
    pure subroutine newton_step(self, q, line, frame, height, step, determinant, found)
      import :: contact_frame, flank_surface, wp
      implicit none(type, external)
      class(flank_surface), intent(in) :: self
      real(wp), intent(in) :: q(:), line(3)
      type(contact_frame), intent(in) :: frame
      real(wp), intent(out) :: height, step(:), determinant
      logical, intent(out) :: found
    end subroutine newton_step

    !> Change of q along a direction of the tangent plane, at the flank's place on a line.
    pure subroutine change_along(self, q, line, frame, direction, rate)
      import :: contact_frame, flank_surface, wp
      implicit none(type, external)
      class(flank_surface), intent(in) :: self
      real(wp), intent(in) :: q(:), line(3), direction(3)
      type(contact_frame), intent(in) :: frame
      real(wp), intent(out) :: rate(:)
    end subroutine change_along

    !> Normal of any length, and its derivatives by q, (3, parameters).
    pure subroutine normal_field(self, q, normal, swings)
      import :: flank_surface, wp
      implicit none(type, external)
      class(flank_surface), intent(in) :: self
      real(wp), intent(in) :: q(:)
      real(wp), intent(out) :: normal(3), swings(:, :)
    end subroutine normal_field
  end interface

contains

  !> The place of a screw of which the axis is turned about X [rad].
  pure function new_screw_seat(centre_distance, axial_shift, swivel) result(seat)
    real(wp), intent(in) :: centre_distance, axial_shift, swivel
    type(screw_seat) :: seat

    seat = screw_seat(centre_distance, axial_shift, cos(swivel), sin(swivel))
  end function new_screw_seat

  !> How far the first parameter is within the flank, negative beyond it.
  pure real(wp) function margin(self, q)
    class(flank_surface), intent(in) :: self
    real(wp), intent(in) :: q(:)

    margin = min(q(1) - self%first, self%last - q(1))
  end function margin

  !> A vector turned by an angle about the wheel's axis, of which cosine and sine are given.
  pure function turned_back(cosine, sine, vector) result(turned)
    real(wp), intent(in) :: cosine, sine, vector(3)
    real(wp) :: turned(3)

    turned = [cosine*vector(1) - sine*vector(3), vector(2), cosine*vector(3) + sine*vector(1)]
  end function turned_back

  !> Slope of the height along a direction of the tangent plane, and its derivatives by q.
  pure subroutine tilted(self, q, direction, frame, slope, by_q)
    class(flank_surface), intent(in) :: self
    real(wp), intent(in) :: q(:), direction(3)
    type(contact_frame), intent(in) :: frame
    real(wp), intent(out) :: slope, by_q(:)
    real(wp) :: normal(3), swings(3, most_parameters), lift

    call self%normals(q, normal, swings)
    lift = dot_product(normal, frame%ez)
    slope = -dot_product(normal, direction)/lift
    by_q(:self%parameters) = -matmul(direction + slope*frame%ez, swings(:, :self%parameters))/lift
  end subroutine tilted

end module pyworm_flank_surface
