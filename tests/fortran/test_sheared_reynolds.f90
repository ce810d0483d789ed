!> The flow of a sheared film: Newton's in its limit, its Jacobian that of its imbalance.
program test_sheared_reynolds
  use pyworm_flow_laws, only: flow_law, law_newton, law_eyring, law_bair_winer, law_eyring_limited, law_carreau
  use pyworm_film_model, only: film_model
  use pyworm_film_levels, only: grid_level, new_level, set_level, set_mobility, model_line
  use pyworm_kinds, only: pp, wp
  use pyworm_viscosity_density, only: oil_law, law_roelands
  use pyworm_reynolds, only: film_grid, film_fields, new_film_fields, set_film_fields, flow_imbalance, flow_imbalance_change
  use pyworm_sheared_reynolds, only: sheared_film, new_sheared_film, set_sheared_fields, sheared_imbalance, &
    sheared_imbalance_change
  use pyworm_status, only: status_ok
  use tap, only: check, close_to, done
  implicit none(type, external)

  integer, parameter :: nx = 25, ny = 21, levels = 7
  real(wp), parameter :: floor = 1e-9_wp
  !> The worm wheel's oil, with a pressure of some 500 MPa over a millimetre.
  type(oil_law), parameter :: oil = oil_law(law_roelands, 0.227_wp, 0.227_wp, 1.961e8_wp, 0.67e-9_wp, 2.68e-9_wp, &
    333.15_wp, 0.782_wp, 7.1e-4_wp, 1.5e-9_wp)
  real(wp), parameter :: tau0 = 3e6_wp, limit = 1e8_wp
  type(film_grid) :: grid
  type(film_fields) :: fields
  real(wp) :: p(nx, ny), h(nx, ny), sliding_x(nx, ny), sliding_y(nx, ny), rise(nx, ny, levels)
  integer :: stat

  call set_scene()
  call newtonian_limit()
  call jacobian(flow_law(law_newton), "Newtonian")
  call jacobian(flow_law(law_eyring, tau0, 1e-9_wp, 2e-3_wp), "Eyring")
  call jacobian(flow_law(law_bair_winer, limit=1e7_wp, limit_growth=0.1_wp), "Bair and Winer")
  call jacobian(flow_law(law_eyring_limited, tau0, limit=limit), "limited Eyring")
  call jacobian(flow_law(law_eyring_limited, tau0, limit=5e6_wp, limit_growth=0.05_wp, exponent=2.0_wp), &
    "limited Eyring, lambda 2, near its limit")
  call jacobian(flow_law(law_carreau, tau0, exponent=0.42_wp), "Carreau")
  call done()

contains

  !> A contact under load that slides with spin, hot in the middle of the film and unequally at its walls.
  subroutine set_scene()
    real(wp) :: x, y, bump
    integer :: i, j, k

    grid = film_grid(nx, ny, 1e-4_wp, 1.2e-4_wp, implicit_rate=500.0_wp)
    allocate (grid%u(nx, ny), grid%v(nx, ny), grid%explicit_rate(nx, ny))
    call new_film_fields(nx, ny, fields, stat)
    call check(stat == status_ok, "fields are made")
    do j = 1, ny
      do i = 1, nx
        x = (i - nx/2)*grid%dx/1e-3_wp
        y = (j - ny/2)*grid%dy/1e-3_wp
        bump = exp(-2*(x**2 + y**2))
        p(i, j) = 5e8_wp*bump*(1 + 0.2_wp*x)
        h(i, j) = 1e-6_wp*(1 + x**2 + 0.5_wp*y**2 + 0.1_wp*x*y)
        grid%u(i, j) = 1.5_wp - 0.2_wp*y
        grid%v(i, j) = 0.3_wp + 0.2_wp*x
        grid%explicit_rate(i, j) = 1e-4_wp*x
        sliding_x(i, j) = 2.5_wp - 0.4_wp*y
        sliding_y(i, j) = 0.5_wp + 0.4_wp*x
        do k = 1, levels
          rise(i, j, k) = bump*(20 + 30*real((k - 1)*(levels - k), wp)/9 + 4*k)
        end do
      end do
    end do
  end subroutine set_scene

  !> A Newtonian oil of one temperature flows as by `reynolds`, to rounding.
  subroutine newtonian_limit()
    type(sheared_film) :: film
    real(wp) :: plain(nx, ny), sheared(nx, ny), dp(nx, ny), dh(nx, ny)

    call new_sheared_film(flow_law(law_newton), levels, sliding_x, sliding_y, film, stat)
    call check(stat == status_ok, "a film is made")
    fields%p = p
    fields%h = h
    call set_film_fields(oil, floor, fields)
    call flow_imbalance(grid, fields, plain)
    dp = p*(1 - p/4e8_wp)*1e-3_wp
    dh = h*cos(p/1e8_wp)*1e-3_wp
    call set_sheared_fields(grid, oil, floor, film, fields)
    call sheared_imbalance(grid, film, fields, sheared)
    call close_to(maxval(abs(sheared - plain)), 0.0_wp, 1e-12_wp*maxval(abs(plain)), "Newton's limit")
    call sheared_imbalance_change(grid, film, fields, dp, dh, sheared)
    call set_film_fields(oil, floor, fields)
    call flow_imbalance_change(grid, fields, dp, dh, plain)
    call close_to(maxval(abs(sheared - plain)), 0.0_wp, 1e-11_wp*maxval(abs(plain)), "and its Jacobian")
    call preconditioner(film, .true.)
    call preconditioner(film, .false.)
  end subroutine newtonian_limit

  !> The preconditioner's model of the finest grid, too, to its single precision.
  subroutine preconditioner(film, transposed)
    type(sheared_film), intent(in) :: film
    logical, intent(in) :: transposed
    type(grid_level) :: level
    real(pp), dimension(merge(ny, nx, transposed), 5) :: plain, sheared
    type(film_model) :: isothermal, general
    logical :: free(nx, ny)
    integer :: j

    free = .true.
    isothermal%fields = fields
    general%fields = fields
    general%shear = film
    call new_level(grid, transposed, 1, 1e-16_wp, level, stat)
    call set_level(level, isothermal, free)
    call set_mobility(level, fields)
    do j = 2, level%count - 1
      call model_line(level, j, 500.0_pp, isothermal, plain(:, 1), plain(:, 2), plain(:, 3), plain(:, 4), plain(:, 5))
      call model_line(level, j, 500.0_pp, general, sheared(:, 1), sheared(:, 2), sheared(:, 3), sheared(:, 4), sheared(:, 5))
      call check(all(abs(sheared(2:level%length - 1, :) - plain(2:level%length - 1, :)) &
        < 1e-5_pp*maxval(abs(plain(2:level%length - 1, :)))), "and its preconditioner")
    end do
  end subroutine preconditioner

  !> Change of the imbalance against central differences, in a smooth random direction.
  subroutine jacobian(law, what)
    type(flow_law), intent(in) :: law
    character(len=*), intent(in) :: what
    real(wp), parameter :: step = 1e-5_wp
    type(sheared_film) :: film
    real(wp) :: dp(nx, ny), dh(nx, ny), above(nx, ny), below(nx, ny), change(nx, ny)
    integer :: i, j

    call new_sheared_film(law, levels, sliding_x, sliding_y, film, stat)
    film%nodes%rise = rise
    do j = 1, ny
      do i = 1, nx
        dp(i, j) = p(i, j)*sin(0.7_wp*i + 0.3_wp*j**2)
        dh(i, j) = h(i, j)*cos(1.3_wp*i - 0.4_wp*j)
      end do
    end do
    call imbalance_at(film, p + step*dp, h + step*dh, above)
    call imbalance_at(film, p - step*dp, h - step*dh, below)
    call imbalance_at(film, p, h, change)
    call sheared_imbalance_change(grid, film, fields, dp, dh, change)
    call close_to(maxval(abs(change - (above - below)/(2*step))), 0.0_wp, 2e-6_wp*maxval(abs(change)), &
      what//": Jacobian against differences")
  end subroutine jacobian

  subroutine imbalance_at(film, pressure, thickness, imbalance)
    type(sheared_film), intent(inout) :: film
    real(wp), intent(in) :: pressure(:, :), thickness(:, :)
    real(wp), intent(out) :: imbalance(:, :)

    fields%p = pressure
    fields%h = thickness
    call set_sheared_fields(grid, oil, floor, film, fields)
    call sheared_imbalance(grid, film, fields, imbalance)
  end subroutine imbalance_at

end program test_sheared_reynolds
