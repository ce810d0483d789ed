!> What a program may say of a contact, and what is refused; prints a line for each check.
program uses
  use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
  use pyworm_contact, only: interruption_query, wp => pyworm_real, pyworm_advance, pyworm_bad_argument, pyworm_bair_winer, &
    pyworm_body, pyworm_branch, pyworm_carreau, pyworm_carreau_yasuda, pyworm_fields, pyworm_film, pyworm_flow, pyworm_found, &
    pyworm_inaccurate, pyworm_interrupt_by, pyworm_interrupted, pyworm_message, pyworm_not_finite, pyworm_oil, pyworm_ok, &
    pyworm_options, pyworm_read, pyworm_roelands, pyworm_rough_surface, pyworm_roughness, pyworm_scene, pyworm_setup, &
    pyworm_solve, pyworm_tabulated, pyworm_tabulated_flow
  implicit none(type, external)
  integer, parameter :: n = 49
  type(pyworm_oil), parameter :: oil = pyworm_oil(pyworm_roelands, viscosity=0.04_wp, exponent=0.6_wp, d1=0.6e-9_wp, &
    d2=1.7e-9_wp, thermal_exponent=1.1_wp, conductivity=0.14_wp, heat_capacity=1.7e6_wp)
  type(pyworm_body), parameter :: steel = pyworm_body(47.0_wp, 3.7e6_wp)
  type(pyworm_film) :: film
  type(pyworm_scene) :: scene, other
  type(pyworm_found) :: found, again
  type(pyworm_fields) :: fields
  procedure(interruption_query), pointer :: asked
  integer :: status

  call pyworm_read(film, fields, status)
  call check(status == pyworm_bad_argument, 'a film that is not set up is not read')
  call pyworm_setup(film, scene, oil, status)
  call check(status == pyworm_bad_argument, 'a scene has a gap')
  scene = ball()
  call pyworm_setup(film, scene, oil, status, bodies=[steel, steel])
  call check(status == pyworm_bad_argument, 'bodies come with a flow law')
  call pyworm_setup(film, scene, pyworm_oil(pyworm_tabulated), status)
  call check(status == pyworm_bad_argument, 'a table has values')
  call refuse_flows()
  call pyworm_setup(film, scene, oil, status, roughness=pyworm_roughness())
  call check(status == pyworm_bad_argument, 'rough surfaces have heights')
  other = scene
  other%gap(3, 3) = ieee_value(1.0_wp, ieee_quiet_nan)
  call pyworm_setup(film, other, oil, status)
  call check(status == pyworm_not_finite, pyworm_message(status))
  other = scene
  allocate (other%supply(2, 2))
  call pyworm_setup(film, other, oil, status)
  call check(status == pyworm_bad_argument, 'fields have one shape')

  call pyworm_setup(film, scene, oil, status)
  call pyworm_advance(film, scene, 1e-3_wp, pyworm_options(), found, status)
  call check(status == pyworm_bad_argument, 'time steps follow a steady film')
  call pyworm_solve(film, pyworm_options(), found, status)
  other = scene
  allocate (other%velocity(n, n, 2, 2), source=0.0_wp)
  other%velocity(:, :, 1, 1) = scene%velocity_1(1)
  other%velocity(:, :, 1, 2) = scene%velocity_2(1)
  call pyworm_setup(film, other, oil, status)
  call pyworm_solve(film, pyworm_options(), again, status)
  call check(abs(found%film_min - again%film_min) <= 0 .and. found%film_min > 0, 'velocities as fields are those of bodies')
  allocate (other%covered(n, n), source=.true.)
  other%covered(:, 30:) = .false.
  call pyworm_setup(film, other, oil, status)
  call pyworm_solve(film, pyworm_options(), again, status)
  call pyworm_read(film, fields, status)
  call check(status == pyworm_ok .and. maxval(fields%p(:, 30:)) <= 0 .and. again%pressure_max > found%pressure_max, &
    'beyond the edge of a body there is no pressure')

  call use_line()
  asked => at_once
  call pyworm_interrupt_by(asked)
  call pyworm_setup(film, scene, oil, status)
  call pyworm_solve(film, pyworm_options(), found, status)
  call check(status == pyworm_interrupted, pyworm_message(status))

contains

  !> Flow laws that no oil has.
  subroutine refuse_flows()
    type(pyworm_flow) :: flows(6)
    integer :: k, refused

    flows(1) = pyworm_flow(7)
    flows(2) = pyworm_flow(pyworm_carreau_yasuda, branches=[pyworm_branch(fraction=0.5_wp, exponent=0.4_wp)])
    flows(3) = pyworm_flow(pyworm_carreau_yasuda)
    flows(4) = pyworm_flow(pyworm_tabulated_flow, table=reshape([1.0_wp, 0.9_wp, 3.0_wp, 3.1_wp, 4.0_wp, 3.2_wp, 5.0_wp, 3.3_wp], &
      [2, 4]))
    flows(5) = pyworm_flow(pyworm_bair_winer)
    flows(6) = pyworm_flow(pyworm_carreau, stress=4e6_wp, exponent=1.5_wp)
    refused = 0
    do k = 1, size(flows)
      call pyworm_setup(film, scene, oil, status, flows(k))
      if (status == pyworm_bad_argument) refused = refused + 1
    end do
    call check(refused == size(flows), 'oils thin, the parts of a liquid are the whole, and a limit is above zero')
  end subroutine refuse_flows

  !> A ball on a disc.
  type(pyworm_scene) function ball() result(rolling)
    real(wp) :: a, x(n), y(n)
    integer :: i

    a = (3*20.0_wp*0.01_wp/(2*230e9_wp))**(1/3.0_wp)
    rolling = pyworm_scene(dx=6*a/(n - 1), dy=5*a/(n - 1), load=20.0_wp, reduced_modulus=230e9_wp, &
      velocity_1=[1.1_wp, 0.0_wp], velocity_2=[0.9_wp, 0.0_wp])
    x = [(-4.2_wp*a + rolling%dx*(i - 1), i=1, n)]
    y = [(-2.5_wp*a + rolling%dy*(i - 1), i=1, n)]
    rolling%gap = (spread(x**2, 2, n) + spread(y**2, 1, n))/0.02_wp
  end function ball

  !> A rough roller in an oil that thins and warms, before and after a rise of its load.
  subroutine use_line()
    integer, parameter :: m = 257
    type(pyworm_roughness) :: ground
    type(pyworm_scene) :: roller
    integer :: i

    roller = pyworm_scene(dx=5e-6_wp, load=1e5_wp, reduced_modulus=230e9_wp, velocity_1=[1.1_wp, 0.0_wp], &
      velocity_2=[0.9_wp, 0.0_wp])
    roller%gap = reshape([((roller%dx*(i - 193))**2/0.02_wp, i=1, m)], [m, 1])
    ground%surface = pyworm_rough_surface(height=0.2e-6_wp, slope=0.02_wp)
    call pyworm_setup(film, roller, oil, status, pyworm_flow(pyworm_carreau, stress=5e6_wp, exponent=0.5_wp), &
      [steel, steel], ground)
    call pyworm_solve(film, pyworm_options(), found, status)
    call check(any(status == [pyworm_ok, pyworm_inaccurate]), 'a line is rough, warm and sheared at once')
    call pyworm_read(film, fields, status)
    call check(maxval(fields%rise) > 1 .and. maxval(fields%asperity_pressure) > 1e6_wp .and. maxval(fields%heat) > 0, &
      'and all its fields are read')
    roller%load = 1.2e5_wp
    call pyworm_advance(film, roller, 1e-4_wp, pyworm_options(), again, status)
    call check(any(status == [pyworm_ok, pyworm_inaccurate]) .and. again%pressure_max > found%pressure_max &
      .and. again%film_min_error < 0.2_wp, 'and goes on in time with an error by the grid')
  end subroutine use_line

  logical function at_once()
    at_once = .true.
  end function at_once

  subroutine check(passed, what)
    logical, intent(in) :: passed
    character(len=*), intent(in) :: what

    print '(a)', merge('ok     ', 'not ok ', passed)//what
  end subroutine check

end program uses
