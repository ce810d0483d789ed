!> Estimated errors of the models of conduction against those that they have.
program test_conduction_model
  use pyworm_conduction_model, only: conduction_errors, of_greatest
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  use pyworm_moving_source, only: moving_body, new_moving_body
  use pyworm_surface_path, only: fast_body, new_fast_body
  use tap, only: check, close_to, done
  implicit none(type, external)

  integer, parameter :: n = 129
  !> Semi-axes [m], a quarter of the window, and diffusivity [m2/s] of a body with a conductivity of 1 W/(m K).
  real(wp), parameter :: semi_x = 3e-3_wp, semi_y = 1e-3_wp, kappa = 1e-5_wp
  real(wp) :: x(n, n), y(n, n), heat(n, n)
  integer :: i, j

  do j = 1, n
    do i = 1, n
      x(i, j) = 4*semi_x*((i - 1.0_wp)/(n - 1) - 0.5_wp)
      y(i, j) = 4*semi_y*((j - 1.0_wp)/(n - 1) - 0.5_wp)
      heat(i, j) = sqrt(max(0.0_wp, 1 - (x(i, j)/semi_x)**2 - (y(i, j)/semi_y)**2))
    end do
  end do

  call one_velocity(1.0_wp, 0.0_wp)
  call one_velocity(0.0_wp, 1.0_wp)
  call turning("direction varies", 1 + 0*x, 0.2_wp*x/semi_x)
  call turning("speed varies", 1 + 0.2_wp*x/semi_x, 0*x)
  call turning("a turn across the contact", -0.2_wp*y/semi_x, 1 + 0.2_wp*x/semi_x)
  call spinning()
  call without_heat()
  call done()

contains

  !> A surface with one velocity: the path model's error, conduction all round being exact.
  subroutine one_velocity(cosine, sine)
    real(wp), intent(in) :: cosine, sine
    type(moving_body) :: exact
    type(fast_body) :: paths
    real(wp) :: u(n, n), v(n, n), mean_u, mean_v, uniform, along_paths, found, greatest, speed
    integer :: stat

    speed = 50*kappa/semi_y
    u = speed*cosine
    v = speed*sine
    call conduction_errors(u, v, heat, semi_x, semi_y, kappa, mean_u, mean_v, uniform, along_paths)
    call close_to(hypot(mean_u - speed*cosine, mean_v - speed*sine), 0.0_wp, 1e-12_wp*speed, "the mean of one velocity")
    call close_to(uniform, 0.0_wp, 1e-12_wp, "one velocity is uniform")
    call new_moving_body(exact, n, n, 4*semi_x/(n - 1), 4*semi_y/(n - 1), u(1, 1), v(1, 1), 1.0_wp, 1/kappa, stat)
    call new_fast_body(paths, 4*semi_x/(n - 1), 4*semi_y/(n - 1), u, v, 1.0_wp, 1/kappa, stat)
    call compare(paths, exact, found, greatest)
    write (*, "(a, 2f8.4)") "# paths ", along_paths, found
    call check(found < 1.5_wp*along_paths .and. found > along_paths/4, "conduction along paths")
    call check(greatest < of_greatest*along_paths, "greatest rise by paths")
  end subroutine one_velocity

  !> A surface that nothing presses on yet has the mean velocity of its window.
  subroutine without_heat()
    real(wp) :: mean_u, mean_v, uniform, along_paths

    call conduction_errors(1 + x/semi_x, 2 + 0*y, 0*heat, semi_x, semi_y, kappa, mean_u, mean_v, uniform, along_paths)
    call close_to(mean_u, 1.0_wp, 1e-12_wp, "mean velocity without heat, along")
    call close_to(mean_v, 2.0_wp, 1e-12_wp, "mean velocity without heat, across")
    call check(uniform > 0 .and. uniform < 1, "error of a uniform velocity without heat")
  end subroutine without_heat

  !> A surface so fast that conduction along its paths is nothing: the error of one velocity.
  subroutine turning(what, u, v)
    character(len=*), intent(in) :: what
    real(wp), intent(in) :: u(n, n), v(n, n)
    real(wp), parameter :: speed = 1e3_wp
    type(moving_body) :: one
    type(fast_body) :: paths
    real(wp) :: mean_u, mean_v, uniform, along_paths, found, greatest
    integer :: stat

    call conduction_errors(speed*u, speed*v, heat, semi_x, semi_y, kappa, mean_u, mean_v, uniform, along_paths)
    call new_moving_body(one, n, n, 4*semi_x/(n - 1), 4*semi_y/(n - 1), mean_u, mean_v, 1.0_wp, 1/kappa, stat)
    call new_fast_body(paths, 4*semi_x/(n - 1), 4*semi_y/(n - 1), speed*u, speed*v, 1.0_wp, 1/kappa, stat)
    call compare(one, paths, found, greatest)
    write (*, "(a, 2f8.4)") "# "//what, uniform, found
    call check(found < 1.5_wp*uniform .and. found > uniform/1.5_wp, what)
    call check(greatest < of_greatest*uniform, what//", greatest rise")
    call check(along_paths < uniform/10, "fast surfaces that turn need paths")
  end subroutine turning

  !> A surface that turns on the spot has no paths to follow, and does not matter if it is slow.
  subroutine spinning()
    real(wp) :: mean_u, mean_v, uniform, along_paths, slow

    call conduction_errors(-y, x, heat, semi_x, semi_y, kappa, mean_u, mean_v, uniform, along_paths)
    call check(along_paths > 1, "no path leads through a spin")
    slow = uniform
    call conduction_errors(-y/1e3_wp, x/1e3_wp, heat, semi_x, semi_y, kappa, mean_u, mean_v, uniform, along_paths)
    call check(uniform < slow .and. uniform < 1e-3_wp, "a slow spin is as good as rest")
  end subroutine spinning

  !> Largest difference of two models where more than half of the greatest flux enters, and that of their greatest rises,
  !> over the greatest rise.
  subroutine compare(model, reference, largest, greatest)
    class(heated_body), intent(inout) :: model, reference
    real(wp), intent(out) :: largest, greatest
    real(wp) :: rise(n, n), exact(n, n)

    call model%rise(heat, rise)
    call reference%rise(heat, exact)
    largest = maxval(abs(rise - exact), mask=heat > 0.5_wp)/maxval(exact)
    greatest = abs(maxval(rise) - maxval(exact))/maxval(exact)
  end subroutine compare

end program test_conduction_model
