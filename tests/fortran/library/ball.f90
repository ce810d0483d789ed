!> A steel ball that rolls on a steel disc in an oil by Barus: nodes a side, window's reach in contact radii, the density's
!> d1 and Barus' alpha [1/Pa] are arguments; prints status, coarsening, films [nm] and errors [%].
program ball
  use pyworm_contact, only: wp => pyworm_real, pyworm_barus, pyworm_conditions, pyworm_found, pyworm_oil, pyworm_ok, &
    pyworm_point, pyworm_read, pyworm_setup, pyworm_solve
  implicit none(type, external)
  real(wp), parameter :: radius = 0.01_wp, load = 6.3_wp, modulus = 230e9_wp, accuracy = 0.02_wp
  real(wp), allocatable :: gap(:, :), p(:, :), h(:, :)
  type(pyworm_point) :: contact
  type(pyworm_found) :: found
  real(wp) :: a, x, y, spacing, reach, d1, alpha
  integer :: i, j, nodes, status

  nodes = nint(argument(1))
  reach = argument(2)
  d1 = argument(3)
  alpha = argument(4)
  a = (3*load*radius/(2*modulus))**(1/3.0_wp)
  spacing = 2*reach*a/(nodes - 1)
  allocate (gap(nodes, nodes), p(nodes, nodes), h(nodes, nodes))
  do j = 1, nodes
    do i = 1, nodes
      x = spacing*(i - 1) - 1.4_wp*reach*a
      y = spacing*(j - (nodes + 1)/2)
      gap(i, j) = (x**2 + y**2)/(2*radius)
    end do
  end do
  call pyworm_setup(contact, gap, spacing, spacing, pyworm_conditions(load, modulus, [1.0_wp, 0.0_wp], [1.0_wp, 0.0_wp]), &
    pyworm_oil(pyworm_barus, viscosity=0.04_wp, exponent=alpha, d1=d1, d2=1.7e-9_wp), status)
  if (status == pyworm_ok) call pyworm_solve(contact, 1e-4_wp, accuracy, found, status)
  call pyworm_read(contact, p, h)
  print '(*(g0, 1x))', status, found%coarsening, found%film_min*1e9_wp, found%film_central*1e9_wp, &
    found%film_min_error*100, found%film_central_error*100, found%window_error*100, minval(h)*1e9_wp, &
    sum(p)*spacing**2/load

contains

  !> A number from the command line.
  real(wp) function argument(place)
    integer, intent(in) :: place
    character(len=32) :: text

    call get_command_argument(place, text)
    read (text, *) argument
  end function argument

end program ball
