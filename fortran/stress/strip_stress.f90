!> Stress below a strip of a half-plane under uniform pressure or uniform shear traction, in plane strain and closed form
!> (Johnson, Contact Mechanics, eq. 2.23 and 2.31).
!>
!> Axes and signs are those of `rectangle_stress`. Stresses in the plane do not depend on Poisson's ratio nu; across it
!> sigma_yy = nu (sigma_xx + sigma_zz).
module pyworm_strip_stress
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: strip_stress

  !> Places of the three components in the plane, and of the two tractions, among them.
  integer, parameter :: xx = 1, zz = 2, xz = 3, pressure = 1, shear = 2

  real(wp), parameter :: pi = acos(-1.0_wp)

contains

  !> Stress [-] at depth `z` and offset `x` from the middle of a strip under each unit traction, (component, traction).
  pure function strip_stress(x, z, dx) result(stress)
    real(wp), intent(in) :: x, z, dx
    real(wp) :: stress(3, 2)

    stress = edge_stress(x + dx/2, z) - edge_stress(x - dx/2, z)
  end function strip_stress

  !> Antiderivatives by x of the stress under each unit line load [-], (component, traction).
  pure function edge_stress(x, z) result(stress)
    real(wp), intent(in) :: x, z
    real(wp) :: stress(3, 2)
    real(wp) :: r2, angle

    r2 = x**2 + z**2
    angle = atan2(x, z)
    stress(xx, pressure) = -(angle - x*z/r2)
    stress(zz, pressure) = -(angle + x*z/r2)
    stress(xz, pressure) = z**2/r2
    stress(xx, shear) = -(log(r2) + z**2/r2)
    stress(zz, shear) = z**2/r2
    stress(xz, shear) = -(angle - x*z/r2)
    stress = stress/pi
  end function edge_stress

end module pyworm_strip_stress
