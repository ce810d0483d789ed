!> Stress below a rectangle against quadrature of the point loads of Boussinesq and Cerruti (Johnson, Contact Mechanics,
!> eq. 3.19 to 3.20 and 3.75), and at the surface.
program test_rectangle_stress
  use pyworm_kinds, only: wp
  use pyworm_rectangle_stress, only: pressure, rectangle_stress, shear_x, shear_y, xx, xy, xz, yy, yz, zz
  use tap, only: check, close_to, done
  implicit none(type, external)

  real(wp), parameter :: pi = acos(-1.0_wp), dx = 1.3_wp, dy = 0.7_wp
  real(wp), parameter :: poissons(2) = [0.3_wp, 0.47_wp]
  real(wp), parameter :: places(3, 4) = reshape([0.0_wp, 0.0_wp, 0.6_wp, 0.3_wp, -0.2_wp, 0.9_wp, -1.7_wp, 2.1_wp, 0.4_wp, &
    0.6_wp, 0.5_wp, 3.0_wp], [3, 4])
  integer :: place, body

  do body = 1, 2
    do place = 1, 4
      call against_quadrature(places(1, place), places(2, place), places(3, place), poissons(body))
    end do
  end do
  call at_the_surface()
  call far_from_it()
  call done()

contains

  subroutine against_quadrature(x, y, z, poisson)
    real(wp), intent(in) :: x, y, z, poisson
    real(wp), parameter :: node(3) = [-sqrt(0.6_wp), 0.0_wp, sqrt(0.6_wp)], weight(3) = [5.0_wp, 8.0_wp, 5.0_wp]/18
    integer, parameter :: panels = 60
    real(wp) :: total(6, 3), at_x, at_y
    integer :: i, j, g, h

    total = 0
    do i = 1, panels
      do j = 1, panels
        do g = 1, 3
          do h = 1, 3
            at_x = dx*((i - 0.5_wp + node(g)/2)/panels - 0.5_wp)
            at_y = dy*((j - 0.5_wp + node(h)/2)/panels - 0.5_wp)
            total = total + weight(g)*weight(h)*point_load(x - at_x, y - at_y, z, poisson)
          end do
        end do
      end do
    end do
    total = total*dx*dy/panels**2
    call close_to(maxval(abs(rectangle_stress(x, y, z, dx, dy, poisson) - total)), 0.0_wp, 1e-9_wp, &
      "closed form against quadrature of point loads")
  end subroutine against_quadrature

  !> Stress by unit forces, (component, direction of the force: into the half-space, along x, along y).
  pure function point_load(x, y, z, poisson) result(stress)
    real(wp), intent(in) :: x, y, z, poisson
    real(wp) :: stress(6, 3), rho, r2, radial, hoop

    rho = sqrt(x**2 + y**2 + z**2)
    r2 = x**2 + y**2
    ! Boussinesq, in polar components; 1/r2 - z/(rho r2) without its cancellation
    associate (near => 1/(rho*(rho + z)))
      radial = (1 - 2*poisson)*near - 3*z*r2/rho**5
      hoop = -(1 - 2*poisson)*(near - z/rho**3)
    end associate
    stress(xx, pressure) = (radial*x**2 + hoop*y**2)/r2
    stress(yy, pressure) = (radial*y**2 + hoop*x**2)/r2
    stress(xy, pressure) = (radial - hoop)*x*y/r2
    stress(zz, pressure) = -3*z**3/rho**5
    stress(xz, pressure) = -3*x*z**2/rho**5
    stress(yz, pressure) = -3*y*z**2/rho**5
    stress(:, shear_x) = tangential(x, y, z, rho, poisson)
    stress([yy, xx, zz, xy, yz, xz], shear_y) = tangential(y, x, z, rho, poisson)
    stress = stress/(2*pi)
  end function point_load

  !> Cerruti's stress times 2 pi.
  pure function tangential(x, y, z, rho, poisson) result(stress)
    real(wp), intent(in) :: x, y, z, rho, poisson
    real(wp) :: stress(6), near, far

    near = 1/(rho*(rho + z)**2)
    far = 1/(rho**3*(rho + z)**2) + 2/(rho**2*(rho + z)**3)
    stress(xx) = -3*x**3/rho**5 + (1 - 2*poisson)*(x/rho**3 - 3*x*near + x**3*far)
    stress(yy) = -3*x*y**2/rho**5 + (1 - 2*poisson)*(x/rho**3 - x*near + x*y**2*far)
    stress(zz) = -3*x*z**2/rho**5
    stress(xy) = -3*x**2*y/rho**5 + (1 - 2*poisson)*(-y*near + x**2*y*far)
    stress(xz) = -3*x**2*z/rho**5
    stress(yz) = -3*x*y*z/rho**5
  end function tangential

  !> Tractions under the rectangle, none beside it; under pressure a square bears (1 + 2 nu)/2 of it along the surface.
  subroutine at_the_surface()
    real(wp) :: inside(6, 3), outside(6, 3)

    inside = rectangle_stress(0.1_wp, -0.2_wp, 0.0_wp, 1.0_wp, 1.0_wp, 0.3_wp)
    outside = rectangle_stress(0.7_wp, 0.3_wp, 0.0_wp, 1.0_wp, 1.0_wp, 0.3_wp)
    call close_to(inside(zz, pressure), -1.0_wp, 1e-14_wp, "pressure at the surface")
    call close_to(inside(xz, shear_x), -1.0_wp, 1e-14_wp, "shear along x at the surface")
    call close_to(inside(yz, shear_y), -1.0_wp, 1e-14_wp, "shear along y at the surface")
    call close_to(maxval(abs(outside([zz, xz, yz], :))), 0.0_wp, 1e-14_wp, "no traction beside the rectangle")
    inside = rectangle_stress(0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, 1.0_wp, 0.3_wp)
    call close_to(inside(xx, pressure), -0.8_wp, 1e-14_wp, "stress along the surface in the middle of a square")
  end subroutine at_the_surface

  !> A hundred widths away the rectangle is a point load.
  subroutine far_from_it()
    real(wp) :: closed(6, 3), point(6, 3)

    closed = rectangle_stress(80.0_wp, -50.0_wp, 60.0_wp, 1.0_wp, 1.0_wp, 0.3_wp)
    point = point_load(80.0_wp, -50.0_wp, 60.0_wp, 0.3_wp)
    call check(all(abs(closed - point) <= 2e-4_wp*maxval(abs(point))), "a point load from afar")
  end subroutine far_from_it

end program test_rectangle_stress
