!> A steel ball that rolls on a steel disc in an oil by Barus: nodes a side, window's reach in contact radii, the density's
!> d1 and Barus' alpha [1/Pa] are arguments; prints status, coarsening, films [nm] and errors [%].
program ball
  use pyworm_contact, only: wp => pyworm_real, pyworm_barus, pyworm_fields, pyworm_film, pyworm_found, pyworm_oil, pyworm_ok, &
    pyworm_options, pyworm_read, pyworm_scene, pyworm_setup, pyworm_solve
  implicit none(type, external)
  real(wp), parameter :: radius = 0.01_wp, load = 6.3_wp, modulus = 230e9_wp
  type(pyworm_scene) :: scene
  type(pyworm_film) :: film
  type(pyworm_found) :: found
  type(pyworm_fields) :: fields
  real(wp) :: a, x, y, spacing, reach, d1, alpha
  integer :: i, j, nodes, status, unread

  nodes = nint(argument(1))
  reach = argument(2)
  d1 = argument(3)
  alpha = argument(4)
  a = (3*load*radius/(2*modulus))**(1/3.0_wp)
  spacing = 2*reach*a/(nodes - 1)
  scene = pyworm_scene(dx=spacing, dy=spacing, load=load, reduced_modulus=modulus, velocity_1=[1.0_wp, 0.0_wp], &
    velocity_2=[1.0_wp, 0.0_wp])
  allocate (scene%gap(nodes, nodes))
  do j = 1, nodes
    do i = 1, nodes
      x = spacing*(i - 1) - 1.4_wp*reach*a
      y = spacing*(j - (nodes + 1)/2)
      scene%gap(i, j) = (x**2 + y**2)/(2*radius)
    end do
  end do
  call pyworm_setup(film, scene, pyworm_oil(pyworm_barus, viscosity=0.04_wp, exponent=alpha, d1=d1, d2=1.7e-9_wp), status)
  if (status == pyworm_ok) call pyworm_solve(film, pyworm_options(), found, status)
  call pyworm_read(film, fields, unread)
  if (unread /= pyworm_ok) stop 1
  print '(*(g0, 1x))', status, found%coarsening, found%film_min*1e9_wp, found%film_central*1e9_wp, &
    found%film_min_error*100, found%film_central_error*100, found%window_error*100, minval(fields%h)*1e9_wp, &
    sum(fields%p)*spacing**2/load

contains

  !> A number from the command line.
  real(wp) function argument(place)
    integer, intent(in) :: place
    character(len=32) :: text

    call get_command_argument(place, text)
    read (text, *) argument
  end function argument

end program ball
