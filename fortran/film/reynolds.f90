!> Reynolds' equation div(rho h um) - div(rho h^3 / (12 eta) grad p) + d(rho h)/dt = 0 on a uniform grid.
!>
!> Node-centred finite volumes: diffusive fluxes with a mean mobility of a face's two nodes that is near the
!> logarithmic one, wedge fluxes with rho h of third order, biased upwind by the sign of the entrainment at the face.
!> Density is taken relative to that at ambient pressure, so that the residual is a volume flow per area [m/s].
module pyworm_reynolds
  use pyworm_kinds, only: wp
  use pyworm_rough_surfaces, only: rough_film
  use pyworm_viscosity_density, only: oil_law, viscosities, densities
  use pyworm_status, only: status_ok, status_no_memory
  implicit none(type, external)
  private

  public :: film_grid, film_fields, new_film_fields, set_film_fields, set_mass_change, flow_imbalance, flow_imbalance_change
  public :: add_wedge, face_mean

  !> Share of the arithmetic mean in the mobility of a face; the rest is the geometric mean. Where mobility is
  !> exponential in pressure, its mean over the pressure between two nodes is the logarithmic one, (a - b)/ln(a/b),
  !> which a third of one and two thirds of the other follow to fourth order in ln(a/b)
  !> (B. C. Carlson, The logarithmic mean, American Mathematical Monthly 79 (1972) 615).
  real(wp), parameter, public :: arithmetic_share = 1.0_wp/3

  !> Rows of a block, whose upwind rows are computed again and lie in the first caches.
  integer, parameter :: strip = 32

  !> Grid of the film: points, spacing [m], and kinematics [m/s].
  type :: film_grid
    integer :: nx = 0, ny = 0
    real(wp) :: dx = 0, dy = 0
    !> Entrainment through the face after a node, along x and along y.
    real(wp), allocatable :: u(:, :), v(:, :)
    !> Transient term d(rho h)/dt = implicit_rate [1/s] rho h + explicit_rate [m/s]; the implicit part is zero where the
    !> rate of change is given.
    real(wp), allocatable :: explicit_rate(:, :)
    real(wp) :: implicit_rate = 0
  end type film_grid

  !> Nodal fields at one pressure and film, with the derivatives that Newton's method needs.
  type :: film_fields
    !> Pressure of the oil [Pa] and film [m], of rough surfaces the mean thickness of the gap.
    real(wp), allocatable :: p(:, :), h(:, :)
    !> What rough surfaces add.
    type(rough_film), allocatable :: rough
    !> Mobility over that of the oil at its inlet's temperature at rest, where heat and thinning are given; else not allocated.
    real(wp), allocatable :: fluidity(:, :)
    !> Slopes of its logarithm by pressure [1/Pa] and film [1/m]; allocated with it.
    real(wp), allocatable :: fluidity_p(:, :), fluidity_h(:, :)
    !> Relative density and its derivative by pressure.
    real(wp), allocatable :: rho(:, :), rho_p(:, :)
    !> Mobility rho h^3 / (12 eta) and its derivatives by pressure and film.
    real(wp), allocatable :: mobility(:, :), mobility_p(:, :), mobility_h(:, :)
  contains
    procedure :: is_rough
  end type film_fields

contains

  !> Allocates the fields of a grid.
  subroutine new_film_fields(nx, ny, fields, stat)
    integer, intent(in) :: nx, ny
    type(film_fields), intent(out) :: fields
    integer, intent(out) :: stat
    integer :: err

    allocate (fields%p(nx, ny), fields%h(nx, ny), fields%rho(nx, ny), fields%rho_p(nx, ny), &
      fields%mobility(nx, ny), fields%mobility_p(nx, ny), fields%mobility_h(nx, ny), source=0.0_wp, stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
  end subroutine new_film_fields

  !> Whether the surfaces are rough.
  pure logical function is_rough(self)
    class(film_fields), intent(in) :: self

    is_rough = allocated(self%rough)
  end function is_rough

  !> Evaluates the fields at their pressure and film.
  !>
  !> A film below `floor` [m] has the mobility of the floor, since films on coarse grids and in Newton steps may be
  !> negative.
  subroutine set_film_fields(oil, floor, fields)
    type(oil_law), intent(in) :: oil
    real(wp), intent(in) :: floor
    type(film_fields), intent(inout) :: fields
    real(wp), dimension(size(fields%p, 1)) :: eta, slope
    integer :: j

    !$omp parallel do private(eta, slope) schedule(static)
    do j = 1, size(fields%p, 2)
      call viscosities(oil, fields%p(:, j), eta, slope)
      call densities(oil, fields%p(:, j), fields%rho(:, j), fields%rho_p(:, j))
      call set_mobility(size(eta), fields%h(:, j), floor, fields%rho(:, j), fields%rho_p(:, j), eta, slope, &
        fields%mobility(:, j), fields%mobility_p(:, j), fields%mobility_h(:, j))
      if (allocated(fields%fluidity)) then
        fields%mobility(:, j) = fields%mobility(:, j)*fields%fluidity(:, j)
        fields%mobility_p(:, j) = fields%mobility_p(:, j)*fields%fluidity(:, j) &
          + fields%mobility(:, j)*fields%fluidity_p(:, j)
        fields%mobility_h(:, j) = fields%mobility_h(:, j)*fields%fluidity(:, j) &
          + fields%mobility(:, j)*fields%fluidity_h(:, j)
      end if
    end do
  end subroutine set_film_fields

  !> Computes a row's mobility and its derivatives.
  pure subroutine set_mobility(n, h, floor, rho, rho_p, eta, slope, m, m_p, m_h)
    integer, intent(in) :: n
    real(wp), dimension(n), intent(in) :: h, rho, rho_p, eta, slope
    real(wp), intent(in) :: floor
    real(wp), dimension(n), intent(out) :: m, m_p, m_h
    real(wp) :: thickness
    integer :: i

    do i = 1, n
      thickness = max(h(i), floor)
      m(i) = rho(i)*thickness**3/(12*eta(i))
      m_p(i) = m(i)*(rho_p(i)/rho(i) - slope(i))
      m_h(i) = merge(3*m(i)/thickness, 0.0_wp, h(i) > floor)
    end do
  end subroutine set_mobility

  !> Computes the change of rho h by a small change of the oil's pressure and of the film, of rough surfaces the gap between
  !> their mean planes.
  subroutine set_mass_change(fields, dp, dh, change)
    type(film_fields), intent(in) :: fields
    real(wp), contiguous, intent(in) :: dp(:, :), dh(:, :)
    real(wp), contiguous, intent(out) :: change(:, :)
    integer :: j

    !$omp parallel do schedule(static)
    do j = 1, size(dp, 2)
      change(:, j) = fields%rho(:, j)*dh(:, j)
      if (fields%is_rough()) change(:, j) = change(:, j)*fields%rough%widening(:, j)
      change(:, j) = change(:, j) + fields%rho_p(:, j)*fields%h(:, j)*dp(:, j)
    end do
  end subroutine set_mass_change

  !> Net volume outflow per area [m/s] of each inner node's cell; zero on the outline.
  subroutine flow_imbalance(grid, fields, imbalance)
    type(film_grid), intent(in) :: grid
    type(film_fields), intent(in) :: fields
    real(wp), contiguous, intent(out) :: imbalance(:, :)
    integer :: first

    call clear_outline(imbalance)
    !$omp parallel do schedule(static)
    do first = 2, grid%ny - 1, strip
      call imbalance_of_rows(grid, fields, first, min(first + strip, grid%ny) - 1, imbalance)
    end do
  end subroutine flow_imbalance

  !> Change of the imbalance for a small change of pressure and film: the exact Jacobian times (dp, dh).
  subroutine flow_imbalance_change(grid, fields, dp, dh, change)
    type(film_grid), intent(in) :: grid
    type(film_fields), intent(in) :: fields
    real(wp), contiguous, intent(in) :: dp(:, :), dh(:, :)
    real(wp), contiguous, intent(out) :: change(:, :)
    integer :: first

    call clear_outline(change)
    !$omp parallel do schedule(static)
    do first = 2, grid%ny - 1, strip
      call change_of_rows(grid, fields, dp, dh, first, min(first + strip, grid%ny) - 1, change)
    end do
  end subroutine flow_imbalance_change

  !> Adds div(q um) to what r holds at the inner nodes; r becomes zero on the outline.
  subroutine add_wedge(grid, q, r)
    type(film_grid), intent(in) :: grid
    real(wp), contiguous, intent(in) :: q(:, :)
    real(wp), contiguous, intent(inout) :: r(:, :)
    integer :: first

    call clear_outline(r)
    !$omp parallel do schedule(static)
    do first = 2, grid%ny - 1, strip
      call add_wedge_of_rows(grid, q, first, min(first + strip, grid%ny) - 1, r)
    end do
  end subroutine add_wedge

  !> Adds div(q um) for rows `first` to `last`.
  pure subroutine add_wedge_of_rows(grid, q, first, last, r)
    type(film_grid), intent(in) :: grid
    real(wp), contiguous, intent(in) :: q(:, :)
    integer, intent(in) :: first, last
    real(wp), contiguous, intent(inout) :: r(:, :)
    real(wp) :: rows(grid%nx, 0:4), before(grid%nx), after(grid%nx), transient(grid%nx), flux(grid%nx)
    integer :: j, k

    do j = max(first - 2, 1), first + 1
      rows(:, mod(j, 5)) = q(:, j)
    end do
    call wedge_to_next_row(grid, first - 1, rows, before)
    do j = first, last
      k = min(j + 2, grid%ny)
      rows(:, mod(k, 5)) = q(:, k)
      call wedge_to_next_row(grid, j, rows, after)
      transient = r(:, j)
      call set_wedge(grid%nx, grid%dx, grid%u(:, j), q(:, j), before, after, transient, flux, r(:, j))
      before = after
    end do
  end subroutine add_wedge_of_rows

  !> Computes the imbalance of rows `first` to `last`.
  pure subroutine imbalance_of_rows(grid, fields, first, last, imbalance)
    type(film_grid), intent(in) :: grid
    type(film_fields), intent(in) :: fields
    integer, intent(in) :: first, last
    real(wp), contiguous, intent(inout) :: imbalance(:, :)
    !> rho h of row j at mod(j, 5), root of the mobility at mod(j, 3); wedge flow to the row and to the next.
    real(wp) :: mass(grid%nx, 0:4), root(grid%nx, 0:2), before(grid%nx), after(grid%nx), transient(grid%nx), &
      flux(grid%nx)
    integer :: j, k

    do j = max(first - 2, 1), first + 1
      mass(:, mod(j, 5)) = fields%rho(:, j)*fields%h(:, j)
    end do
    do j = first - 1, first
      root(:, mod(j, 3)) = sqrt(fields%mobility(:, j))
    end do
    call wedge_to_next_row(grid, first - 1, mass, before)
    do j = first, last
      k = min(j + 2, grid%ny)
      mass(:, mod(k, 5)) = fields%rho(:, k)*fields%h(:, k)
      root(:, mod(j + 1, 3)) = sqrt(fields%mobility(:, j + 1))
      call wedge_to_next_row(grid, j, mass, after)
      transient = grid%implicit_rate*mass(:, mod(j, 5)) + grid%explicit_rate(:, j)
      call set_wedge(grid%nx, grid%dx, grid%u(:, j), mass(:, mod(j, 5)), before, after, &
        transient, flux, imbalance(:, j))
      call add_diffusion(grid, j, root, fields%p(:, j - 1:j + 1), imbalance(:, j))
      before = after
    end do
  end subroutine imbalance_of_rows

  !> Computes the change of the imbalance of rows `first` to `last`.
  pure subroutine change_of_rows(grid, fields, dp, dh, first, last, change)
    type(film_grid), intent(in) :: grid
    type(film_fields), intent(in) :: fields
    real(wp), contiguous, intent(in) :: dp(:, :), dh(:, :)
    integer, intent(in) :: first, last
    real(wp), contiguous, intent(inout) :: change(:, :)
    !> Change of rho h of row j at mod(j, 5); root of the mobility and its change at mod(j, 3); wedge flow to the
    !> row and to the next.
    real(wp), dimension(grid%nx, 0:2) :: root, root_change
    real(wp) :: mass(grid%nx, 0:4), before(grid%nx), after(grid%nx), transient(grid%nx), flux(grid%nx)
    integer :: j, k

    do j = max(first - 2, 1), first + 1
      mass(:, mod(j, 5)) = fields%rho_p(:, j)*fields%h(:, j)*dp(:, j) + fields%rho(:, j)*dh(:, j)
    end do
    do j = first - 1, first
      call set_root(grid%nx, fields%mobility(:, j), fields%mobility_p(:, j), fields%mobility_h(:, j), dp(:, j), &
        dh(:, j), root(:, mod(j, 3)), root_change(:, mod(j, 3)))
    end do
    call wedge_to_next_row(grid, first - 1, mass, before)
    do j = first, last
      k = min(j + 2, grid%ny)
      mass(:, mod(k, 5)) = fields%rho_p(:, k)*fields%h(:, k)*dp(:, k) + fields%rho(:, k)*dh(:, k)
      k = j + 1
      call set_root(grid%nx, fields%mobility(:, k), fields%mobility_p(:, k), fields%mobility_h(:, k), dp(:, k), &
        dh(:, k), root(:, mod(k, 3)), root_change(:, mod(k, 3)))
      call wedge_to_next_row(grid, j, mass, after)
      transient = grid%implicit_rate*mass(:, mod(j, 5))
      call set_wedge(grid%nx, grid%dx, grid%u(:, j), mass(:, mod(j, 5)), before, after, &
        transient, flux, change(:, j))
      call add_diffusion(grid, j, root, dp(:, j - 1:j + 1), change(:, j))
      call add_diffusion_change(grid, j, root, root_change, fields%p(:, j - 1:j + 1), change(:, j))
      before = after
    end do
  end subroutine change_of_rows

  !> Computes the root of a row's mobility and its change.
  pure subroutine set_root(n, mobility, mobility_p, mobility_h, dp, dh, root, change)
    integer, intent(in) :: n
    real(wp), dimension(n), intent(in) :: mobility, mobility_p, mobility_h, dp, dh
    real(wp), dimension(n), intent(out) :: root, change

    root = sqrt(mobility)
    change = (mobility_p*dp + mobility_h*dh)/(2*root)
  end subroutine set_root

  !> Adds -div(m grad p) to the r of row j, with p of the row before, the row itself and the next; the root of m of row j is at
  !> mod(j, 3).
  pure subroutine add_diffusion(grid, j, root, p, r)
    type(film_grid), intent(in) :: grid
    integer, intent(in) :: j
    real(wp), intent(in) :: root(grid%nx, 0:2), p(grid%nx, -1:1)
    real(wp), intent(inout) :: r(grid%nx)
    real(wp) :: along_x, along_y
    integer :: i, before, here, after

    along_x = 1/grid%dx**2
    along_y = 1/grid%dy**2
    before = mod(j - 1, 3)
    here = mod(j, 3)
    after = mod(j + 1, 3)
    do i = 2, grid%nx - 1
      associate (m => root(i, here), here_p => p(i, 0))
        r(i) = r(i) + along_x*(face_mean(m, root(i + 1, here))*(here_p - p(i + 1, 0)) &
          + face_mean(m, root(i - 1, here))*(here_p - p(i - 1, 0))) &
          + along_y*(face_mean(m, root(i, after))*(here_p - p(i, 1)) + face_mean(m, root(i, before))*(here_p - p(i, -1)))
      end associate
    end do
  end subroutine add_diffusion

  !> Adds the change of -div(m grad p) by that of m at the same p to the r of row j; arguments as of `add_diffusion`, with the
  !> change of the root of m.
  pure subroutine add_diffusion_change(grid, j, root, change, p, r)
    type(film_grid), intent(in) :: grid
    integer, intent(in) :: j
    real(wp), intent(in) :: root(grid%nx, 0:2), change(grid%nx, 0:2), p(grid%nx, -1:1)
    real(wp), intent(inout) :: r(grid%nx)
    real(wp) :: along_x, along_y
    integer :: i, before, here, after

    along_x = 1/grid%dx**2
    along_y = 1/grid%dy**2
    before = mod(j - 1, 3)
    here = mod(j, 3)
    after = mod(j + 1, 3)
    do i = 2, grid%nx - 1
      associate (m => root(i, here), dm => change(i, here), here_p => p(i, 0))
        r(i) = r(i) + along_x*(mean_change(m, root(i + 1, here), dm, change(i + 1, here))*(here_p - p(i + 1, 0)) &
          + mean_change(m, root(i - 1, here), dm, change(i - 1, here))*(here_p - p(i - 1, 0))) &
          + along_y*(mean_change(m, root(i, after), dm, change(i, after))*(here_p - p(i, 1)) &
          + mean_change(m, root(i, before), dm, change(i, before))*(here_p - p(i, -1)))
      end associate
    end do
  end subroutine add_diffusion_change

  !> Mobility of a face from the roots of those of its two nodes.
  pure real(wp) function face_mean(a, b)
    real(wp), intent(in) :: a, b

    face_mean = arithmetic_share/2*(a**2 + b**2) + (1 - arithmetic_share)*a*b
  end function face_mean

  !> Change of `face_mean` by those of the roots.
  pure real(wp) function mean_change(a, b, da, db)
    real(wp), intent(in) :: a, b, da, db

    mean_change = arithmetic_share*(a*da + b*db) + (1 - arithmetic_share)*(a*db + b*da)
  end function mean_change

  !> Sets a row's r to the transient term of its cells plus div(q um), with q biased upwind to third order; next to
  !> the outline q is the mean of a face's two nodes; `flux` is workspace.
  pure subroutine set_wedge(nx, dx, u, q, before, after, transient, flux, r)
    integer, intent(in) :: nx
    real(wp), intent(in) :: dx, u(nx), q(nx), before(nx), after(nx), transient(nx)
    real(wp), intent(inout) :: flux(nx), r(nx)
    integer :: i

    flux(1) = u(1)*(q(1) + q(2))/2
    flux(nx - 1) = u(nx - 1)*(q(nx - 1) + q(nx))/2
    do i = 2, nx - 2
      flux(i) = upwind(u(i), q(i - 1), q(i), q(i + 1), q(i + 2))
    end do
    do i = 2, nx - 1
      r(i) = transient(i) + (flux(i) - flux(i - 1))*(1/dx) + after(i) - before(i)
    end do
  end subroutine set_wedge

  !> Wedge flow through the faces between row j and the next, per spacing [m/s]; q of row k stands at mod(k, 5).
  pure subroutine wedge_to_next_row(grid, j, q, flux)
    type(film_grid), intent(in) :: grid
    integer, intent(in) :: j
    real(wp), intent(in) :: q(grid%nx, 0:4)
    real(wp), intent(out) :: flux(grid%nx)
    integer :: i

    associate (v => grid%v(:, j), q2 => q(:, mod(j, 5)), q3 => q(:, mod(j + 1, 5)))
      if (j == 1 .or. j == grid%ny - 1) then
        flux = v*(q2 + q3)/(2*grid%dy)
      else
        associate (q1 => q(:, mod(j - 1, 5)), q4 => q(:, mod(j + 2, 5)))
          do i = 1, grid%nx
            flux(i) = upwind(v(i), q1(i), q2(i), q3(i), q4(i))*(1/grid%dy)
          end do
        end associate
      end if
    end associate
  end subroutine wedge_to_next_row

  !> Flow of q through a face between the second and the third of four nodes.
  pure real(wp) function upwind(u, q1, q2, q3, q4)
    real(wp), intent(in) :: u, q1, q2, q3, q4

    upwind = (max(u, 0.0_wp)*(5*q2 + 2*q3 - q1) + min(u, 0.0_wp)*(5*q3 + 2*q2 - q4))*(1/6.0_wp)
  end function upwind

  pure subroutine clear_outline(r)
    real(wp), contiguous, intent(inout) :: r(:, :)

    r(1, :) = 0
    r(size(r, 1), :) = 0
    r(:, 1) = 0
    r(:, size(r, 2)) = 0
  end subroutine clear_outline

end module pyworm_reynolds
