!> A steel ball that rolls under a load that rises by half and falls back within one passage of the oil.
program load_pulse
  use pyworm_contact, only: wp => pyworm_real, pyworm_advance, pyworm_barus, pyworm_film, pyworm_found, pyworm_inaccurate, &
    pyworm_message, pyworm_oil, pyworm_ok, pyworm_options, pyworm_scene, pyworm_setup, pyworm_solve
  implicit none(type, external)
  integer, parameter :: n = 65, steps = 8
  real(wp), parameter :: pi = acos(-1.0_wp), radius = 0.01_wp, load = 6.3_wp, modulus = 230e9_wp, speed = 1
  type(pyworm_options), parameter :: options = pyworm_options(tolerance=1e-10_wp)
  type(pyworm_scene) :: scene
  type(pyworm_film) :: film
  type(pyworm_found) :: found
  real(wp) :: a, x(n), y(n), interval
  integer :: i, step, status

  a = (3*load*radius/(2*modulus))**(1/3.0_wp)
  scene = pyworm_scene(dx=6*a/(n - 1), dy=5*a/(n - 1), load=load, reduced_modulus=modulus, velocity_1=[speed, 0.0_wp], &
    velocity_2=[speed, 0.0_wp])
  x = [(-4.2_wp*a + scene%dx*(i - 1), i=1, n)]
  y = [(-2.5_wp*a + scene%dy*(i - 1), i=1, n)]
  scene%gap = spread(x**2, 2, n)/(2*radius) + spread(y**2, 1, n)/(2*radius)
  call pyworm_setup(film, scene, pyworm_oil(pyworm_barus, viscosity=0.04_wp, exponent=16e-9_wp), status)
  if (status == pyworm_ok) call pyworm_solve(film, options, found, status)

  interval = 2*a/speed/steps
  do step = 1, steps
    if (status /= pyworm_ok .and. status /= pyworm_inaccurate) then
      print '(a)', pyworm_message(status)
      stop 1
    end if
    scene%load = load*(1 + 0.5_wp*sin(pi*step/steps))
    call pyworm_advance(film, scene, interval, options, found, status)
    print '(i3, 2es24.16, f9.4)', step, found%film_min, found%film_central, 100*found%film_min_error
  end do
end program load_pulse
