!> The dry contact of a steel ball on a steel flat, beside Hertz' closed form.
program dry_hertz
  use pyworm_contact, only: wp => pyworm_real, pyworm_message, pyworm_ok, pyworm_scene, pyworm_solve_dry
  implicit none(type, external)
  integer, parameter :: n = 129
  real(wp), parameter :: pi = acos(-1.0_wp)
  real(wp), parameter :: radius = 0.01_wp, load = 50.0_wp, modulus = 230e9_wp ! 2/E' = sum of (1 - nu^2)/E
  type(pyworm_scene) :: scene
  real(wp) :: p(n, n), x(n), a, largest, spacing, approach
  integer :: i, j, status

  a = (3*load*radius/(2*modulus))**(1/3.0_wp)
  largest = 3*load/(2*pi*a**2)
  spacing = 3*a/(n - 1)
  x = [(spacing*(i - (n + 1)/2), i=1, n)]
  scene = pyworm_scene(dx=spacing, dy=spacing, load=load, reduced_modulus=modulus)
  allocate (scene%gap(n, n))
  do j = 1, n
    scene%gap(:, j) = (x**2 + x(j)**2)/(2*radius)
  end do

  call pyworm_solve_dry(scene, 1e-6_wp, p, approach, status)
  if (status /= pyworm_ok) then
    print '(a)', pyworm_message(status)
    stop 1
  end if

  print '(a, f8.2, a, f8.2)', 'largest pressure [MPa] ', maxval(p)/1e6_wp, '   Hertz ', largest/1e6_wp
  print '(a, f8.4, a, f8.4)', 'approach [um]          ', approach*1e6_wp, '   Hertz ', a**2/radius*1e6_wp
  print '(a, f8.4)', 'load of the nodes [N]  ', sum(p)*spacing**2
end program dry_hertz
