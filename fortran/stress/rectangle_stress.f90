!> Stress below a rectangle of a half-space under uniform pressure or uniform shear traction, in closed form.
!>
!> Pressure: Love, Phil. Trans. R. Soc. A 228 (1929) 377. Shear traction: the potentials of Boussinesq and Cerruti for it
!> (Johnson, Contact Mechanics, section 3.2; Love 1929), integrated over the rectangle.
!>
!> Stresses are sums of derivatives of the potentials V = int t/R and chi = int t ln(R + z), and for shear of the one whose
!> derivative by z is chi. Each derivative is an antiderivative at the rectangle's four corners. Terms that one coordinate
!> alone enters cancel between corners and are left out, so that each antiderivative is even or odd in x and in y.
!>
!> The half-space is z > 0. Pressure pushes along +z, shear tractions act on the surface along +x and +y: at z = 0,
!> sigma_zz = -p, sigma_xz = -q_x, sigma_yz = -q_y.
module pyworm_rectangle_stress
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: corner_stress, rectangle_stress

  !> Places of the six components among them.
  integer, parameter, public :: xx = 1, yy = 2, zz = 3, xy = 4, xz = 5, yz = 6
  !> Places of the three tractions among them.
  integer, parameter, public :: pressure = 1, shear_x = 2, shear_y = 3

  real(wp), parameter :: pi = acos(-1.0_wp)

contains

  !> Stress [-] at depth `z` and offset (x, y) from the middle of a rectangle under each unit traction, (component, traction).
  pure function rectangle_stress(x, y, z, dx, dy, poisson) result(stress)
    real(wp), intent(in) :: x, y, z, dx, dy, poisson
    real(wp) :: stress(6, 3)

    stress = corner_stress(x + dx/2, y + dy/2, z, poisson, 3) - corner_stress(x - dx/2, y + dy/2, z, poisson, 3) &
      - corner_stress(x + dx/2, y - dy/2, z, poisson, 3) + corner_stress(x - dx/2, y - dy/2, z, poisson, 3)
  end function rectangle_stress

  !> Antiderivatives by x and y of the stress under the first unit tractions [-], (component, traction), at an offset with
  !> neither x nor y zero where z is.
  pure function corner_stress(x, y, z, poisson, tractions) result(stress)
    real(wp), intent(in) :: x, y, z, poisson
    integer, intent(in) :: tractions
    real(wp) :: stress(6, tractions)
    real(wp) :: r, across_x, across_y, v_z

    r = sqrt(x**2 + y**2 + z**2)
    across_x = x**2 + z**2
    across_y = y**2 + z**2
    v_z = -atan2(x*y, z*r)
    stress(xx, pressure) = 2*poisson*v_z + z*x*y/(across_x*r) - (1 - 2*poisson)*chi_xx(x, y, z, r)
    stress(yy, pressure) = 2*poisson*v_z + z*x*y/(across_y*r) - (1 - 2*poisson)*chi_xx(y, x, z, r)
    stress(zz, pressure) = v_z - z*x*y*(r**2 + z**2)/(r*across_x*across_y)
    stress(xy, pressure) = -z/r - (1 - 2*poisson)*log(r + z)
    stress(xz, pressure) = z**2*y/(r*across_x)
    stress(yz, pressure) = z**2*x/(r*across_y)
    if (tractions > pressure) stress(:, shear_x) = shear_corner(x, y, z, r, poisson)
    ! the axes change places
    if (tractions > shear_x) stress([yy, xx, zz, xy, yz, xz], shear_y) = shear_corner(y, x, z, r, poisson)
    stress = stress/(2*pi)
  end function corner_stress

  !> Second derivative of chi by x.
  pure real(wp) function chi_xx(x, y, z, r)
    real(wp), intent(in) :: x, y, z, r

    ! atan(y/x) - atan(z y/(x r)) in one, without the cancellation of r - z
    chi_xx = atan(x*y*(x**2 + y**2)/((r + z)*(x**2*r + z*y**2)))
  end function chi_xx

  !> Antiderivatives of the stress under shear traction along x, times 2 pi.
  pure function shear_corner(x, y, z, r, poisson) result(stress)
    real(wp), intent(in) :: x, y, z, r, poisson
    real(wp) :: stress(6)
    real(wp) :: v_x, v_y, across_x

    across_x = x**2 + z**2
    v_x = asinh(y/sqrt(across_x))
    v_y = asinh(x/sqrt(y**2 + z**2))
    stress(xx) = 2*v_x + 2*poisson*y/(r + z) + z*y*(1/(r*(r + z)) - z/(r*across_x))
    stress(yy) = 2*poisson*(v_x - y/(r + z)) - z*y/(r*(r + z))
    stress(zz) = z**2*y/(r*across_x)
    stress(xy) = v_y - 2*poisson*x/(r + z) - z*x/(r*(r + z))
    stress(xz) = -atan2(x*y, z*r) + z*x*y/(r*across_x)
    stress(yz) = -z/r
  end function shear_corner

end module pyworm_rectangle_stress
