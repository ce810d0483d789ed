!> Heights of flanks: involutes as planes and as points of a line are one, slopes and curvatures are differences, flanks end.
program test_flank_height
  use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
  use pyworm_flank_height, only: flank_height, new_flank_height
  use pyworm_flank_points, only: new_wheel_points, new_worm_points, swept_curve
  use pyworm_flank_surface, only: contact_frame, new_screw_seat, screw_seat
  use pyworm_kinds, only: wp
  use pyworm_tangent_planes, only: new_wheel_planes, new_worm_planes
  use tap, only: check, close_to, done
  implicit none(type, external)

  !> A worm with two threads of module 4 mm, its lead angle 11.3 and normal pressure angle 20 deg, and 41 teeth.
  real(wp), parameter :: centre_distance = 0.1_wp, screw = 4e-3_wp, ratio = 2/41.0_wp, base_lead = acos(0.921476_wp)
  real(wp), parameter :: base_radius = screw/tan(base_lead), travel = screw*cos(base_lead), lever = travel/ratio
  !> Polar angle of the generator of the contact, and length for which u stands.
  real(wp), parameter :: theta = -1.077_wp, size_of_u = 0.02_wp
  real(wp), parameter :: endless(2) = [0.0_wp, huge(1.0_wp)]
  type(swept_curve) :: line
  type(screw_seat) :: seat
  type(contact_frame) :: frame
  type(flank_height) :: planes, points
  real(wp) :: u, roll, normal(3)

  seat = new_screw_seat(centre_distance, 0.0_wp, 0.0_wp)
  allocate (line%coefficients(3, 2), source=reshape([0.0_wp, 1.0_wp, screw/base_radius, base_radius, 0.0_wp, 0.0_wp], [3, 2]))
  normal = [sin(base_lead)*sin(theta), -sin(base_lead)*cos(theta), cos(base_lead)]
  frame%ez = normal
  frame%ex = [cos(theta), sin(theta), 0.0_wp]
  frame%ey = cross(frame%ez, frame%ex)

  u = 17.6e-3_wp
  frame%origin = [base_radius*cos(theta) - u*sin(theta) - centre_distance, base_radius*sin(theta) + u*cos(theta), &
    screw*theta + screw/base_radius*u]
  call new_flank_height(planes, new_worm_planes(seat, 0.0_wp, base_lead, travel), frame, [theta, 0.0_wp, 0.0_wp])
  call new_flank_height(points, new_worm_points(seat, 0.0_wp, line, endless, screw, size_of_u), frame, &
    [u/size_of_u, theta, 0.0_wp])
  call compare("the worm's", [theta, 0.0_wp, 0.0_wp], [u/size_of_u, theta, 0.0_wp])
  call check_end()
  call check_bounds()

  roll = (-0.08_wp - x_cut(0.0_wp))/(x_cut(1.0_wp) - x_cut(0.0_wp))
  frame%origin = cut(roll)
  u = cos(theta)*frame%origin(2) - sin(theta)*(frame%origin(1) + centre_distance)
  call new_flank_height(planes, new_wheel_planes(seat, roll, base_lead, travel, lever), frame, [theta, 0.0_wp, 0.0_wp])
  call new_flank_height(points, new_wheel_points(seat, roll, line, endless, screw, size_of_u, ratio), frame, &
    [u/size_of_u, theta, 0.0_wp])
  call compare("the wheel's", [theta, 0.0_wp, 0.0_wp], [u/size_of_u, theta, 0.0_wp])
  call done()

contains

  !> Heights, slopes and curvatures of both forms of a flank beside the contact point.
  subroutine compare(whose, start_of_planes, start_of_points)
    character(*), intent(in) :: whose
    real(wp), intent(in) :: start_of_planes(3), start_of_points(3)
    real(wp), parameter :: x = 1.1e-3_wp, y = -0.7e-3_wp, step = 4e-6_wp
    real(wp) :: one, other, left, q(3), r(3), slopes(2), bend(2, 2), rates(3, 2), around(-1:1, -1:1)
    integer :: i, j

    q = start_of_planes
    call planes%converge(0.0_wp, 0.0_wp, q, one, left)
    call close_to(one, 0.0_wp, 1e-16_wp, whose//" flank passes through its contact point")
    q = start_of_planes
    r = start_of_points
    call planes%converge(x, y, q, one, left)
    call points%converge(x, y, r, other, left)
    call check(abs(one) > 1e-6_wp, whose//" flank leaves the tangent plane")
    call close_to(other, one, 1e-12_wp*abs(one), whose//" heights by points are those by planes")
    do j = -1, 1
      do i = -1, 1
        r = q
        call planes%converge(x + i*step, y + j*step, r, around(i, j), left)
      end do
    end do
    call planes%expand(x, y, q, one, slopes, bend, rates)
    call close_to(one, around(0, 0), 1e-17_wp, whose//" height")
    call close_to(slopes(1), (around(1, 0) - around(-1, 0))/(2*step), 1e-8_wp, whose//" slope along x")
    call close_to(slopes(2), (around(0, 1) - around(0, -1))/(2*step), 1e-8_wp, whose//" slope along y")
    call close_to(bend(1, 1), (around(1, 0) - 2*one + around(-1, 0))/step**2, 1e-3_wp, whose//" curvature along x")
    call close_to(bend(2, 2), (around(0, 1) - 2*one + around(0, -1))/step**2, 1e-3_wp, whose//" curvature along y")
    call close_to(bend(1, 2), (around(1, 1) - around(-1, 1) - around(1, -1) + around(-1, -1))/(4*step**2), 1e-3_wp, &
      whose//" twist")
    call close_to(bend(2, 1), bend(1, 2), 1e-10_wp, whose//" second derivatives are symmetric")
  end subroutine compare

  !> On rays towards its base helix the worm's flank ends near it, where the generator has a tenth of its length.
  subroutine check_end()
    real(wp) :: reach, q(3), height, left, sine, cosine, along
    integer :: k

    do k = 1, 3
      cosine = cos(3.75_wp + 0.15_wp*k)
      sine = sin(3.75_wp + 0.15_wp*k)
      call planes%end_of_ray(0.04_wp*cosine, 0.04_wp*sine, reach, q)
      call check(reach > 0.1_wp .and. reach < 1, "the flank ends on the ray")
      call planes%converge(reach*0.04_wp*cosine, reach*0.04_wp*sine, q, height, left)
      call close_to(left, 0.0_wp, 1e-7_wp, "where nothing of it is left")
      ! det T_ij is the generator's length over normal . ez, which is 1 at the contact point
      along = 0.1_wp*u*dot_product(normal, [sin(base_lead)*sin(q(1)), -sin(base_lead)*cos(q(1)), cos(base_lead)])
      associate (end_point => [base_radius*cos(q(1)) - along*sin(q(1)) - centre_distance, base_radius*sin(q(1)) &
          + along*cos(q(1)), screw*q(1) + screw/base_radius*along] - frame%origin)
        call close_to(dot_product(end_point, frame%ex)*sine - dot_product(end_point, frame%ey)*cosine, 0.0_wp, 1e-9_wp, &
          "with a tenth of the generator's length")
      end associate
    end do
  end subroutine check_end

  !> A flank whose bounds end at its contact point has no place beyond it, and none is found far from any.
  subroutine check_bounds()
    type(flank_height) :: bounded
    real(wp) :: reach, q(3), height, left

    call new_flank_height(bounded, new_worm_points(seat, 0.0_wp, line, [0.0_wp, u/size_of_u], screw, size_of_u), frame, &
      [u/size_of_u, theta, 0.0_wp])
    call bounded%end_of_ray(1e-3_wp, 0.0_wp, reach, q)
    call close_to(reach, 0.0_wp, 0.0_wp, "a flank that ends at its contact point has none of a ray")
    q = [u/size_of_u, theta, 0.0_wp]
    call bounded%converge(1.0_wp, 0.0_wp, q, height, left)
    call check(all(ieee_is_nan([height, left, q(1)])), "what is not found is no number")
  end subroutine check_bounds

  !> First coordinate of the point that the hob's generator cuts at a roll [m].
  pure real(wp) function x_cut(roll)
    real(wp), intent(in) :: roll

    associate (point => cut(roll))
      x_cut = point(1)
    end associate
  end function x_cut

  !> The point of the wheel that the hob's generator cuts at a roll, on its plane and the plane's derivatives [m].
  pure function cut(roll) result(point)
    real(wp), intent(in) :: roll
    real(wp) :: point(3), rows(3, 3), right(3)

    rows(:, 1) = normal
    rows(:, 2) = sin(base_lead)*[cos(theta), sin(theta), 0.0_wp]
    rows(:, 3) = [normal(3), 0.0_wp, -normal(1)]
    right = [-centre_distance*normal(1) + travel*theta - lever*roll, -centre_distance*rows(1, 2) + travel, -lever]
    point = (right(1)*cross(rows(:, 2), rows(:, 3)) + right(2)*cross(rows(:, 3), rows(:, 1)) &
      + right(3)*cross(rows(:, 1), rows(:, 2)))/dot_product(rows(:, 1), cross(rows(:, 2), rows(:, 3)))
  end function cut

  pure function cross(first, other) result(product)
    real(wp), intent(in) :: first(3), other(3)
    real(wp) :: product(3)

    product = [first(2)*other(3) - first(3)*other(2), first(3)*other(1) - first(1)*other(3), &
      first(1)*other(2) - first(2)*other(1)]
  end function cross

end program test_flank_height
