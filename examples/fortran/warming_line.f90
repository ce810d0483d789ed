!> A steel roller that rolls and slides, whose load rises by half and falls back: its surfaces remember the heat of before.
program warming_line
  use pyworm_contact, only: wp => pyworm_real, pyworm_advance, pyworm_body, pyworm_eyring, pyworm_fields, pyworm_film, &
    pyworm_flow, pyworm_found, pyworm_inaccurate, pyworm_message, pyworm_oil, pyworm_ok, pyworm_options, pyworm_read, &
    pyworm_roelands, pyworm_scene, pyworm_setup, pyworm_solve
  implicit none(type, external)
  integer, parameter :: n = 131, steps = 8
  real(wp), parameter :: pi = acos(-1.0_wp), radius = 0.01_wp, load = 1e5_wp, modulus = 230e9_wp
  type(pyworm_body), parameter :: steel = pyworm_body(conductivity=47.0_wp, heat_capacity=3.7e6_wp)
  type(pyworm_options), parameter :: options = pyworm_options(tolerance=1e-8_wp)
  type(pyworm_scene) :: scene
  type(pyworm_oil) :: oil
  type(pyworm_film) :: film
  type(pyworm_found) :: found
  type(pyworm_fields) :: fields
  real(wp) :: b
  integer :: i, step, status

  b = sqrt(8*load*radius/(pi*modulus))
  scene = pyworm_scene(dx=b/20, load=load, reduced_modulus=modulus, velocity_1=[1.2_wp, 0.0_wp], velocity_2=[0.8_wp, 0.0_wp])
  scene%gap = reshape([((scene%dx*(i - 101))**2/(2*radius), i=1, n)], [n, 1])
  oil = pyworm_oil(pyworm_roelands, viscosity=0.04_wp, exponent=0.6_wp, d1=0.6e-9_wp, d2=1.7e-9_wp, temperature=333.15_wp, &
    thermal_exponent=1.1_wp, expansivity=7e-4_wp, conductivity=0.14_wp, heat_capacity=1.7e6_wp)
  call pyworm_setup(film, scene, oil, status, pyworm_flow(pyworm_eyring, stress=5e6_wp), [steel, steel])
  if (status == pyworm_ok) call pyworm_solve(film, options, found, status)
  do step = 1, steps
    if (status /= pyworm_ok .and. status /= pyworm_inaccurate) then
      print '(a)', pyworm_message(status)
      stop 1
    end if
    scene%load = load*(1 + 0.5_wp*sin(pi*step/steps))
    call pyworm_advance(film, scene, 1.9_wp*b/steps, options, found, status)
    call pyworm_read(film, fields, i)
    print '(i3, 3es24.16)', step, found%film_min, maxval(fields%rise(:, 1, 1)), maxval(fields%rise(:, 1, 7))
  end do
end program warming_line
