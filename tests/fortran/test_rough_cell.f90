!> Contact of, and flow between, periodic rough surfaces against closed forms.
program test_rough_cell
  use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_positive_inf, ieee_quiet_nan
  use pyworm_cell_contact, only: press_flat
  use pyworm_cell_flow, only: flow_through
  use pyworm_elastic_cell, only: elastic_surface, new_elastic_surface
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_bad_argument, status_not_converged, status_not_finite
  use tap, only: check, close_to, done
  implicit none(type, external)

  real(wp), parameter :: pi = acos(-1.0_wp)
  integer, parameter :: n = 256
  real(wp), parameter :: dx = 1.0_wp/n, modulus = 2, wave_height = 0.1_wp, large = 1e30_wp
  integer :: i, j, iterations, stat

  call waves()
  call yielding()
  call ridges(0.3_wp)
  call ridges(0.9_wp)
  call oblique()
  call bumps()
  call refusals()
  call done()

contains

  !> Westergaard's wavy surface: mean pressure p* sin^2(pi b/l) over a contact of width 2 b, p* = pi E* height/l; at full
  !> contact the mean gap is zero.
  subroutine waves()
    type(elastic_surface) :: surface
    real(wp) :: height(n, 4), p(n, 4), gap(n, 4), width, mean
    real(wp), parameter :: separations(3) = [0.01_wp, 0.03_wp, 0.06_wp]

    do j = 1, 4
      height(:, j) = [(wave_height*cos(2*pi*(i - 1)*dx), i=1, n)]
    end do
    call new_elastic_surface(surface, n, 4, dx, dx, modulus, stat)
    do j = 1, size(separations)
      p = 0
      call press_flat(surface, height, separations(j), large, 1e-9_wp, 500, p, gap, iterations, stat)
      call check(stat == status_ok .and. iterations < 40, "a wave converges in a few iterations")
      mean = sum(p)/size(p)
      width = count(p(:, 1) > 0)*dx
      call close_to(mean/(pi*wave_height), sin(pi*width/2)**2, 0.012_wp, "mean pressure of a wave by its contact")
      call close_to(sum(gap)/size(gap), separations(j), 1e-12_wp, "mean gap of an elastic surface is the separation")
      call check(all(gap > -1e-7_wp), "nothing overlaps")
      call close_to(maxval(p)/(2*sqrt(pi*wave_height*mean)), 1.0_wp, 0.005_wp, "largest pressure of a wave by its mean")
    end do
  end subroutine waves

  !> A body so soft that it yields wherever it is touched bears its hardness over the overlap.
  subroutine yielding()
    type(elastic_surface) :: surface
    real(wp) :: height(n, 4), p(n, 4), gap(n, 4)
    real(wp), parameter :: hardness = 1e-6_wp

    do j = 1, 4
      height(:, j) = [(wave_height*cos(2*pi*(i - 1)*dx), i=1, n)]
    end do
    call new_elastic_surface(surface, n, 4, dx, dx, modulus, stat)
    p = 0
    call press_flat(surface, height, 0.05_wp, hardness, 1e-9_wp, 500, p, gap, iterations, stat)
    call check(stat == status_ok, "a yielding wave converges")
    call close_to(sum(p)/size(p)/hardness, acos(0.5_wp)/pi, 2*dx, "hardness over the overlap")
    call close_to(sum(max(gap, 0.0_wp))/size(gap) - 0.05_wp, wave_height*(sin(pi/3) - pi/6)/pi, 1e-4_wp, &
      "what has yielded leaves the gap as wide as that of overlapping surfaces")
  end subroutine yielding

  !> Ridges along and across: the cube's mean, the inverse cube's inverse mean, <a^-2>/<a^-3>; 1 + A cos has <a^3> = 1 + 3 A^2/2,
  !> <a^-2> = (1 - A^2)^(-3/2) and <a^-3> = (1 + A^2/2) (1 - A^2)^(-5/2).
  subroutine ridges(amplitude)
    real(wp), intent(in) :: amplitude
    real(wp) :: a(n, 8), conducted(3), carried(3), inverse

    do j = 1, 8
      a(:, j) = [(1 + amplitude*cos(2*pi*(i - 1)*dx), i=1, n)]
    end do
    call flow_through(a, dx, 3*dx, 1e-9_wp, 200, conducted, carried, iterations, stat)
    call check(stat == status_ok .and. iterations < 40, "flow over ridges converges")
    inverse = (1 + amplitude**2/2)*(1 - amplitude**2)**(-2.5_wp)
    call close_to(conducted(1)*inverse, 1.0_wp, 1e-6_wp, "flow across ridges")
    call close_to(conducted(2)/(1 + 1.5_wp*amplitude**2), 1.0_wp, 1e-6_wp, "flow along ridges")
    call close_to(carried(1)*inverse*(1 - amplitude**2)**1.5_wp, 1.0_wp, 1e-6_wp, "oil dragged by ridges across")
    call close_to(carried(2), 1.0_wp, 1e-6_wp, "oil dragged by ridges along")
    call close_to(conducted(3), 0.0_wp, 1e-9_wp, "straight ridges turn no flow")
  end subroutine ridges

  !> Ridges at 45 degrees have the mean of both factors, and half their difference aside; of second order in the spacing.
  subroutine oblique()
    real(wp) :: a(n, n), conducted(3), carried(3), along, across
    real(wp), parameter :: amplitude = 0.5_wp

    do j = 1, n
      a(:, j) = [(1 + amplitude*cos(2*pi*(i + j)*dx), i=1, n)]
    end do
    call flow_through(a, dx, dx, 1e-9_wp, 200, conducted, carried, iterations, stat)
    call check(stat == status_ok .and. iterations < 40, "flow over oblique ridges converges")
    along = 1 + 1.5_wp*amplitude**2
    across = (1 - amplitude**2)**2.5_wp/(1 + amplitude**2/2)
    call close_to(conducted(1), (along + across)/2, 2e-3_wp, "flow over oblique ridges")
    ! ridges lie along x = -y: what flows in x is turned towards negative y
    call close_to(conducted(3), (across - along)/2, 2e-3_wp, "flow turned by oblique ridges")
  end subroutine oblique

  !> Shallow waves in both directions: second order has 1 - 3/2 of the variance for flow, and 3/2 of it for drag.
  subroutine bumps()
    real(wp) :: a(n, n), conducted(3), carried(3), variance
    real(wp), parameter :: amplitude = 0.02_wp

    do j = 1, n
      a(:, j) = [(1 + amplitude*(cos(8*pi*i*dx) + sin(8*pi*j*dx)), i=1, n)]
    end do
    variance = amplitude**2
    call flow_through(a, dx, dx, 1e-10_wp, 200, conducted, carried, iterations, stat)
    call close_to((1 - conducted(1))/variance, 1.5_wp, 0.01_wp, "flow over bumps, second order")
    call close_to((1 - carried(2))/variance, 1.5_wp, 0.01_wp, "drag by bumps, second order")
  end subroutine bumps

  subroutine refusals()
    type(elastic_surface) :: surface
    real(wp) :: height(8, 8), p(8, 8), gap(8, 8), conducted(3), carried(3)

    call new_elastic_surface(surface, 8, 3, dx, dx, modulus, stat)
    call check(stat == status_bad_argument, "a cell of three nodes is refused")
    call new_elastic_surface(surface, 8, 8, dx, dx, modulus, stat)
    height = 0
    height(3, 4) = 1
    p = 0
    call press_flat(surface, height, 0.1_wp, 0.0_wp, 1e-9_wp, 50, p, gap, iterations, stat)
    call check(stat == status_bad_argument, "no hardness is refused")
    call press_flat(surface, height, 0.1_wp, large, 1e-12_wp, 0, p, gap, iterations, stat)
    call check(stat == status_not_converged, "a contact without iterations does not converge")
    height(1, 1) = ieee_value(0.0_wp, ieee_quiet_nan)
    call press_flat(surface, height, 0.1_wp, large, 1e-9_wp, 50, p, gap, iterations, stat)
    call check(stat == status_not_finite, "a height that is no number is refused")
    gap = 1
    gap(2, 2) = 0
    call flow_through(gap, dx, dx, 1e-8_wp, 50, conducted, carried, iterations, stat)
    call check(stat == status_bad_argument, "a closed gap is refused")
    gap(2, 2) = 0.5_wp
    call flow_through(gap, dx, dx, 1e-12_wp, 0, conducted, carried, iterations, stat)
    call check(stat == status_not_converged, "a flow without iterations does not converge")
    gap(2, 2) = ieee_value(dx, ieee_positive_inf)
    call flow_through(gap, dx, dx, 1e-8_wp, 50, conducted, carried, iterations, stat)
    call check(stat == status_not_finite, "an infinite gap is refused")
  end subroutine refusals

end program test_rough_cell
