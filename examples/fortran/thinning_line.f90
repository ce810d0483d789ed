!> A steel roller that rolls and slides in liquids with flow laws of one's own: one of two branches, one by a table and limited.
program thinning_line
  use pyworm_contact, only: wp => pyworm_real, pyworm_branch, pyworm_carreau_yasuda, pyworm_fields, pyworm_film, pyworm_flow, &
    pyworm_found, pyworm_inaccurate, pyworm_message, pyworm_oil, pyworm_ok, pyworm_options, pyworm_read, pyworm_roelands, &
    pyworm_scene, pyworm_setup, pyworm_solve, pyworm_tabulated_flow
  implicit none(type, external)
  integer, parameter :: n = 257
  real(wp), parameter :: pi = acos(-1.0_wp), radius = 0.01_wp, load = 1e5_wp, modulus = 230e9_wp
  type(pyworm_oil), parameter :: oil = pyworm_oil(pyworm_roelands, viscosity=0.04_wp, exponent=0.6_wp, d1=0.6e-9_wp, d2=1.7e-9_wp)
  type(pyworm_flow) :: flows(2)
  type(pyworm_scene) :: scene
  type(pyworm_film) :: film
  type(pyworm_found) :: found
  type(pyworm_fields) :: fields
  real(wp) :: b
  integer :: i, k, status

  b = sqrt(8*load*radius/(pi*modulus))
  scene = pyworm_scene(dx=6.5_wp*b/(n - 1), load=load, reduced_modulus=modulus, velocity_1=[1.05_wp, 0.0_wp], &
    velocity_2=[0.95_wp, 0.0_wp])
  scene%gap = reshape([((-5*b + scene%dx*(i - 1))**2/(2*radius), i=1, n)], [n, 1])
  flows(1) = pyworm_flow(pyworm_carreau_yasuda, stress=4e6_wp)
  flows(1)%branches = [pyworm_branch(0.7_wp, 1.0_wp, 0.45_wp, 2.0_wp), pyworm_branch(0.3_wp, 20.0_wp, 0.6_wp, 1.5_wp)]
  flows(2) = pyworm_flow(pyworm_tabulated_flow, stress=5e6_wp, limit_pressure=0.06_wp)
  flows(2)%table = reshape([(10**(0.2_wp*i), asinh(10**(0.2_wp*i)), i=-15, 40)], [2, 56]) ! Eyring's
  do k = 1, 2
    call pyworm_setup(film, scene, oil, status, flows(k))
    if (status == pyworm_ok) call pyworm_solve(film, pyworm_options(tolerance=1e-10_wp), found, status)
    if (status == pyworm_ok .or. status == pyworm_inaccurate) call pyworm_read(film, fields, status)
    if (status /= pyworm_ok) then
      print '(a)', pyworm_message(status)
      stop 1
    end if
    print '(i3, 3es24.16)', k, found%film_min, found%pressure_max, abs(sum(fields%stress_x))*scene%dx/load
  end do
end program thinning_line
