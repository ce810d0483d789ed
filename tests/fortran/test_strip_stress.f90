!> Stress below a strip against a long rectangle, which is in plane strain, and at the surface.
program test_strip_stress
  use pyworm_kinds, only: wp
  use pyworm_rectangle_stress, only: of_pressure => pressure, of_shear => shear_x, rectangle_stress, x_x => xx, y_y => yy, &
    z_z => zz, x_z => xz
  use pyworm_strip_stress, only: strip_stress
  use tap, only: close_to, done
  implicit none(type, external)

  real(wp), parameter :: poisson = 0.3_wp
  real(wp), parameter :: places(2, 3) = reshape([0.0_wp, 0.6_wp, 0.4_wp, 1.1_wp, -1.7_wp, 0.4_wp], [2, 3])
  integer :: place

  do place = 1, 3
    call against_long_rectangle(places(1, place), places(2, place))
  end do
  call at_the_surface()
  call done()

contains

  subroutine against_long_rectangle(x, z)
    real(wp), intent(in) :: x, z
    real(wp) :: strip(3, 2), long(6, 3), across(2)

    strip = strip_stress(x, z, 1.3_wp)
    long = rectangle_stress(x, 0.0_wp, z, 1.3_wp, 1e9_wp, poisson)
    call close_to(maxval(abs(strip - long([x_x, z_z, x_z], [of_pressure, of_shear]))), 0.0_wp, 1e-8_wp, &
      "strip against a long rectangle")
    across = poisson*(strip(1, :) + strip(2, :))
    call close_to(maxval(abs(across - long(y_y, [of_pressure, of_shear]))), 0.0_wp, 1e-8_wp, "plane strain")
  end subroutine against_long_rectangle

  subroutine at_the_surface()
    real(wp) :: inside(3, 2), beside(3, 2)

    inside = strip_stress(0.2_wp, 0.0_wp, 1.0_wp)
    beside = strip_stress(0.6_wp, 0.0_wp, 1.0_wp)
    call close_to(inside(1, 1), -1.0_wp, 1e-14_wp, "pressure along the surface")
    call close_to(inside(2, 1), -1.0_wp, 1e-14_wp, "pressure at the surface")
    call close_to(inside(3, 2), -1.0_wp, 1e-14_wp, "shear at the surface")
    call close_to(maxval(abs(beside(2:3, :))), 0.0_wp, 1e-14_wp, "no traction beside the strip")
  end subroutine at_the_surface

end program test_strip_stress
