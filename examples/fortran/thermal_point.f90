!> A steel ball that rolls and slides on a steel disc in an oil that thins and warms.
program thermal_point
  use pyworm_contact, only: wp => pyworm_real, pyworm_body, pyworm_eyring, pyworm_fields, pyworm_film, pyworm_flow, &
    pyworm_found, pyworm_oil, pyworm_ok, pyworm_options, pyworm_read, pyworm_roelands, pyworm_scene, pyworm_setup, pyworm_solve
  implicit none(type, external)
  integer, parameter :: nx = 65, ny = 65
  real(wp), parameter :: radius = 0.01_wp, load = 20.0_wp, modulus = 230e9_wp
  type(pyworm_body), parameter :: steel = pyworm_body(conductivity=47.0_wp, heat_capacity=3.7e6_wp)
  type(pyworm_scene) :: scene
  type(pyworm_oil) :: oil
  type(pyworm_film) :: film
  type(pyworm_found) :: found
  type(pyworm_fields) :: fields
  real(wp) :: a, x(nx), y(ny)
  integer :: i, j, status

  a = (3*load*radius/(2*modulus))**(1/3.0_wp)
  scene = pyworm_scene(dx=6*a/(nx - 1), dy=5*a/(ny - 1), load=load, reduced_modulus=modulus, &
    velocity_1=[1.1_wp, 0.0_wp], velocity_2=[0.9_wp, 0.0_wp])
  x = [(-4.2_wp*a + scene%dx*(i - 1), i=1, nx)]
  y = [(-2.5_wp*a + scene%dy*(j - 1), j=1, ny)]
  scene%gap = spread(x**2, 2, ny)/(2*radius) + spread(y**2, 1, nx)/(2*radius)
  oil = pyworm_oil(pyworm_roelands, viscosity=0.04_wp, exponent=0.6_wp, d1=0.6e-9_wp, d2=1.7e-9_wp, &
    temperature=333.15_wp, thermal_exponent=1.1_wp, expansivity=7e-4_wp, conductivity=0.14_wp, heat_capacity=1.7e6_wp)

  call pyworm_setup(film, scene, oil, status, pyworm_flow(pyworm_eyring, stress=5e6_wp), [steel, steel])
  if (status == pyworm_ok) call pyworm_solve(film, pyworm_options(tolerance=1e-8_wp, accuracy=0.15_wp), found, status)
  if (status /= pyworm_ok) stop 1
  call pyworm_read(film, fields, status)
  print '(a, es23.16)', 'minimum film [m]       ', found%film_min
  print '(a, es23.16)', 'maximum pressure [Pa]  ', found%pressure_max
  print '(a, es23.16)', 'friction coefficient   ', abs(sum(fields%stress_x, mask=fields%p > 0.01_wp*maxval(fields%p))) &
    *scene%dx*scene%dy/load
  print '(a, es23.16)', 'rise in the middle [K] ', maxval(fields%rise(:, :, 4))
end program thermal_point
