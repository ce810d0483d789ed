!> Heights of a flank over the common tangent plane, their slopes and curvatures, and where on a ray the flank ends.
!>
!> Newton's method finds the parameters q of the flank on the line through each point along the common normal. With the slope
!> T_x = -normal . ex/normal . ez the second derivatives are T_xy = T_xi q_i,y.
module pyworm_flank_height
  use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
  use pyworm_flank_surface, only: contact_frame, flank_surface, most_parameters
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: flank_height, new_flank_height

  !> Ratio of the determinant to that of the contact point at which a flank counts as ending. It falls to zero at the flank's
  !> edge of regression (of the involute the base helix), where curvature grows without bound; the flank is continued from a
  !> little before it.
  real(wp), parameter :: edge = 0.1_wp
  !> Newton step [rad] below which the height, whose error is the step's cube, is right to rounding, and at which the iteration
  !> fails: larger ones led to other parts of the flank.
  real(wp), parameter :: min_newton_step = 1e-6_wp, max_newton_step = 0.3_wp
  !> Largest number of Newton steps.
  integer, parameter :: most_steps = 8
  !> Largest change of a parameter [rad] from the contact point's: beyond lie other windings.
  real(wp), parameter :: max_parameter_change = acos(0.0_wp)
  !> Accuracy of the flank's end: of the square of the determinant over the contact point's, and of its place on the ray from
  !> there as a fraction of its length.
  real(wp), parameter :: ended = 1e-8_wp
  !> Largest number of places tried on a ray for the flank's end.
  integer, parameter :: most_tries = 64
  !> Largest next step from the flank over that to a place tried beyond its end, where the last one was not.
  real(wp), parameter :: back = 0.9_wp

  !> Height of a flank over the tangent plane of a contact.
  type :: flank_height
    private
    !> The flank, and the frame of the contact.
    class(flank_surface), allocatable :: surface
    type(contact_frame) :: frame
    !> Parameters of the flank at the contact point, the determinant and the margin to its end there.
    real(wp) :: start(most_parameters) = 0, determinant = 1, start_margin = 0
  contains
    procedure :: converge
    procedure :: expand
    procedure :: end_of_ray
    procedure, private :: line
    procedure, private :: follow
  end type flank_height

contains

  !> Heights of a flank whose parameters at the contact point are given; without an end before it, its margin is positive.
  pure subroutine new_flank_height(self, surface, frame, start)
    type(flank_height), intent(out) :: self
    class(flank_surface), intent(in) :: surface
    type(contact_frame), intent(in) :: frame
    real(wp), intent(in) :: start(most_parameters)
    real(wp) :: height, step(most_parameters)
    logical :: found

    allocate (self%surface, source=surface)
    self%frame = frame
    self%start = start
    call surface%newton(start, frame%origin, frame, height, step, self%determinant, found)
    self%start_margin = merge(min(1 - edge**2, surface%margin(start)), 0.0_wp, found)
  end subroutine new_flank_height

  !> Point of the tangent plane at (x, y) [m].
  pure function line(self, x, y)
    class(flank_height), intent(in) :: self
    real(wp), intent(in) :: x, y
    real(wp) :: line(3)

    line = self%frame%origin + x*self%frame%ex + y*self%frame%ey
  end function line

  !> Height [m] at (x, y) and q, from a first guess of q, and the margin to the flank's end, NaN where nothing is found.
  !>
  !> The margin is the square of the determinant over the contact point's, less that of `edge`, or the part of the flank's
  !> bounds, or what is left of the parameters, where that is less.
  pure subroutine converge(self, x, y, q, height, left)
    class(flank_height), intent(in) :: self
    real(wp), intent(in) :: x, y
    real(wp), intent(inout) :: q(most_parameters)
    real(wp), intent(out) :: height, left
    logical :: found

    call newton(self, self%line(x, y), q, height, left, found)
    if (found) return
    q = ieee_value(q, ieee_quiet_nan)
    height = q(1)
    left = q(1)
  end subroutine converge

  pure subroutine newton(self, point, q, height, left, found)
    type(flank_height), intent(in) :: self
    real(wp), intent(in) :: point(3)
    real(wp), intent(inout) :: q(most_parameters)
    real(wp), intent(out) :: height, left
    logical, intent(out) :: found
    real(wp) :: step(most_parameters), determinant, size_of_step, part
    integer :: number

    height = 0
    left = 0
    size_of_step = max_newton_step
    do number = 1, most_steps
      call self%surface%newton(q, point, self%frame, height, step, determinant, found)
      if (.not. found) return
      size_of_step = maxval(abs(step))
      found = size_of_step < max_newton_step
      if (.not. found) return
      q = q - step
      if (size_of_step < min_newton_step) exit
    end do
    part = determinant/self%determinant
    found = size_of_step < min_newton_step .and. part > 0
    if (.not. found) return
    associate (changes => abs(q - self%start)/max_parameter_change)
      left = min(part*part - edge**2, 1 - maxval(changes), self%surface%margin(q))
    end associate
  end subroutine newton

  !> Height [m], slopes and second derivatives [1/m] at (x, y) where q is known, and the rates of q along ex and ey [1/m].
  pure subroutine expand(self, x, y, q, height, slopes, bend, rates)
    class(flank_height), intent(in) :: self
    real(wp), intent(in) :: x, y, q(most_parameters)
    real(wp), intent(out) :: height, slopes(2), bend(2, 2), rates(most_parameters, 2)
    real(wp) :: step(most_parameters), determinant, directions(3, 2), crosses(most_parameters, 2), point(3)
    integer :: k
    logical :: found

    point = self%line(x, y)
    call self%surface%newton(q, point, self%frame, height, step, determinant, found)
    directions(:, 1) = self%frame%ex
    directions(:, 2) = self%frame%ey
    crosses = 0
    do k = 1, 2
      call self%surface%tilted(q, directions(:, k), self%frame, slopes(k), crosses(:, k))
      call self%surface%rates(q, point, self%frame, directions(:, k), rates(:, k))
    end do
    bend = matmul(transpose(crosses), rates)
  end subroutine expand

  !> Fraction of the ray from the contact point to (x, y) that lies on the flank, and q there.
  !>
  !> The margin to the flank's end falls nearly linearly, so that the secant method finds its zero, with steps halved where no
  !> point is found: that far q is not followed at once.
  pure subroutine end_of_ray(self, x, y, reach, q)
    class(flank_height), intent(in) :: self
    real(wp), intent(in) :: x, y
    real(wp), intent(out) :: reach, q(most_parameters)
    real(wp) :: step, growth, left, last, last_left, before, before_left, goal, there, ahead, tried(most_parameters)
    integer :: number
    logical :: found

    reach = 0
    q = self%start
    step = 0.5_wp
    growth = 2
    left = self%start_margin
    last = 0
    last_left = left
    before = 0
    before_left = left
    do number = 1, most_tries
      if (.not. (left > ended .and. step > ended .and. reach < 1)) exit
      goal = 1
      if (abs(last_left - before_left) > 0) goal = last - last_left*(last - before)/(last_left - before_left)
      if (.not. goal > reach) goal = 1
      there = min(goal, 1.0_wp, reach + step)
      tried = q
      call self%follow(x, y, reach, there, tried, ahead, found)
      if (found .and. ahead > -ended) then
        reach = there
        q = tried
        left = ahead
        step = growth*step
        growth = min(2*growth, 2.0_wp)
      else
        step = merge(back, 0.5_wp, found .and. last_left > 0)*(there - reach)
        growth = merge(1.0_wp, 0.5_wp, found)
      end if
      if (.not. found) cycle
      before = last
      before_left = last_left
      last = there
      last_left = ahead
    end do
  end subroutine end_of_ray

  !> q followed along the ray to (x, y) from one fraction of it to another, and the margin there.
  pure subroutine follow(self, x, y, here, there, q, left, found)
    class(flank_height), intent(in) :: self
    real(wp), intent(in) :: x, y, here, there
    real(wp), intent(inout) :: q(most_parameters)
    real(wp), intent(out) :: left
    logical, intent(out) :: found
    real(wp) :: rate(most_parameters), height

    call self%surface%rates(q, self%line(here*x, here*y), self%frame, x*self%frame%ex + y*self%frame%ey, rate)
    q = q + (there - here)*rate
    call newton(self, self%line(there*x, there*y), q, height, left, found)
  end subroutine follow

end module pyworm_flank_height
