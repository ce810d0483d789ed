!> A steel roller on a flat in an oil whose viscosity is a function of one's own.
program line_film
  use own_viscosity, only: viscosity
  use pyworm_contact, only: wp => pyworm_real, pyworm_film, pyworm_found, pyworm_inaccurate, pyworm_message, pyworm_oil, &
    pyworm_ok, pyworm_options, pyworm_scene, pyworm_setup, pyworm_solve, pyworm_tabulated
  implicit none(type, external)
  integer, parameter :: n = 1025
  real(wp), parameter :: pi = acos(-1.0_wp), radius = 0.01_wp, load = 1e5_wp, modulus = 230e9_wp
  type(pyworm_scene) :: scene
  type(pyworm_oil) :: oil
  type(pyworm_film) :: film
  type(pyworm_found) :: found
  real(wp) :: b
  integer :: i, status

  b = sqrt(8*load*radius/(pi*modulus))
  scene = pyworm_scene(dx=6.5_wp*b/(n - 1), load=load, reduced_modulus=modulus, velocity_1=[1.0_wp, 0.0_wp], &
    velocity_2=[1.0_wp, 0.0_wp])
  scene%gap = reshape([((-5*b + scene%dx*(i - 1))**2/(2*radius), i=1, n)], [n, 1]) ! one row of nodes: a line contact
  oil = pyworm_oil(pyworm_tabulated, d1=0.6e-9_wp, d2=1.7e-9_wp, temperature=333.15_wp, viscosity_at=viscosity)

  call pyworm_setup(film, scene, oil, status)
  if (status == pyworm_ok) call pyworm_solve(film, pyworm_options(tolerance=1e-10_wp), found, status)
  if (status /= pyworm_ok .and. status /= pyworm_inaccurate) then
    print '(a)', pyworm_message(status)
    stop 1
  end if
  print '(a, es23.16)', 'minimum film [m]      ', found%film_min
  print '(a, es23.16)', 'central film [m]      ', found%film_central
  print '(a, es23.16)', 'maximum pressure [Pa] ', found%pressure_max
  print '(a, f9.4)', 'error by the grid [%]   ', 100*found%film_min_error
  print '(a, f9.4)', 'error by the window [%] ', 100*found%window_error
end program line_film
