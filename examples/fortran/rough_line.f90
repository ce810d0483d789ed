!> A steel roller whose surfaces are rough, with too little oil: asperities bear a part of the load.
program rough_line
  use pyworm_contact, only: wp => pyworm_real, pyworm_fields, pyworm_film, pyworm_found, pyworm_inaccurate, pyworm_message, &
    pyworm_oil, pyworm_ok, pyworm_options, pyworm_read, pyworm_roelands, pyworm_rough_surface, pyworm_roughness, pyworm_scene, &
    pyworm_setup, pyworm_solve
  implicit none(type, external)
  integer, parameter :: n = 513
  real(wp), parameter :: pi = acos(-1.0_wp), radius = 0.01_wp, load = 1e5_wp, modulus = 230e9_wp
  type(pyworm_roughness) :: ground
  type(pyworm_scene) :: scene
  type(pyworm_oil) :: oil
  type(pyworm_film) :: film
  type(pyworm_found) :: found
  type(pyworm_fields) :: fields
  real(wp) :: b
  integer :: i, status

  b = sqrt(8*load*radius/(pi*modulus))
  scene = pyworm_scene(dx=6.5_wp*b/(n - 1), load=load, reduced_modulus=modulus, velocity_1=[1.1_wp, 0.0_wp], &
    velocity_2=[0.9_wp, 0.0_wp])
  scene%gap = reshape([((-5*b + scene%dx*(i - 1))**2/(2*radius), i=1, n)], [n, 1])
  allocate (scene%supply(n, 1), source=0.6e-6_wp)
  oil = pyworm_oil(pyworm_roelands, viscosity=0.04_wp, exponent=0.6_wp, d1=0.6e-9_wp, d2=1.7e-9_wp)
  ground%surface = pyworm_rough_surface(height=0.15e-6_wp, slope=0.03_wp, hardness=7e9_wp)

  call pyworm_setup(film, scene, oil, status, roughness=ground)
  if (status == pyworm_ok) call pyworm_solve(film, pyworm_options(tolerance=1e-10_wp), found, status)
  if (status == pyworm_ok .or. status == pyworm_inaccurate) call pyworm_read(film, fields, status)
  if (status /= pyworm_ok) then
    print '(a)', pyworm_message(status)
    stop 1
  end if
  print '(a, es23.16)', 'minimum film [m]      ', found%film_min
  print '(a, es23.16)', 'maximum pressure [Pa] ', found%pressure_max
  print '(a, es23.16)', 'asperity load ratio   ', sum(fields%asperity_pressure)*scene%dx/load
  print '(a, f9.4)', 'error by the grid [%] ', 100*found%film_min_error
end program rough_line
