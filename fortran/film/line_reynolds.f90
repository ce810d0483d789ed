!> Reynolds' equation d(rho h um)/dx - d(rho h^3 / (12 eta) dp/dx)/dx + d(rho h)/dt = 0 of a line contact.
!>
!> Node-centred finite volumes as of `reynolds`, in one dimension and of second order: diffusive fluxes with the mean
!> mobility of a face's two nodes, wedge fluxes with second-order upwind rho h. Hot rollers whose walls slip are lost
!> with the scheme of third order, and lines are cheap. The Jacobian is assembled as two bands, one for the change of
!> pressure and one for that of the film. The Poiseuille flow may be that of a sheared film (`line_shear`).
module pyworm_line_reynolds
  use pyworm_kinds, only: wp
  use pyworm_partial_film, only: partial_film
  use pyworm_reynolds, only: film_fields
  use pyworm_status, only: status_ok, status_no_memory
  implicit none(type, external)
  private

  public :: line_grid, line_flow, new_line_flow, newtonian_flow, line_imbalance, line_bands, band_product, &
    transposed_band_product, wedge_weights

  !> Grid of the film: points, spacing [m], and kinematics [m/s].
  type :: line_grid
    integer :: n = 0
    real(wp) :: dx = 0
    !> Entrainment through the face after a node.
    real(wp), allocatable :: u(:)
    !> Explicit [m/s] and implicit [1/s] part of the transient term, as of `film_grid`.
    real(wp), allocatable :: explicit_rate(:)
    real(wp) :: implicit_rate = 0
  end type line_grid

  !> Poiseuille flow through the face after each node, against the pressure gradient [m2/s], and its derivatives by the pressure
  !> of the node before and after [m2/(Pa s)] and by the film there [m/s].
  type :: line_flow
    real(wp), allocatable :: flow(:), before(:), after(:), film_before(:), film_after(:)
  end type line_flow

contains

  !> Allocates the flow between n nodes.
  subroutine new_line_flow(n, faces, stat)
    integer, intent(in) :: n
    type(line_flow), intent(out) :: faces
    integer, intent(out) :: stat
    integer :: err

    allocate (faces%flow(n - 1), faces%before(n - 1), faces%after(n - 1), faces%film_before(n - 1), &
      faces%film_after(n - 1), stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
  end subroutine new_line_flow

  !> Computes the flow of an isothermal Newtonian oil from the mobility in `fields`.
  pure subroutine newtonian_flow(grid, fields, faces)
    type(line_grid), intent(in) :: grid
    type(film_fields), intent(in) :: fields
    type(line_flow), intent(inout) :: faces
    real(wp) :: mobility, gradient
    integer :: i

    do i = 1, grid%n - 1
      mobility = (fields%mobility(i, 1) + fields%mobility(i + 1, 1))/(2*grid%dx)
      gradient = (fields%p(i + 1, 1) - fields%p(i, 1))/(2*grid%dx)
      faces%flow(i) = mobility*(fields%p(i + 1, 1) - fields%p(i, 1))
      faces%before(i) = fields%mobility_p(i, 1)*gradient - mobility
      faces%after(i) = fields%mobility_p(i + 1, 1)*gradient + mobility
      faces%film_before(i) = fields%mobility_h(i, 1)*gradient
      faces%film_after(i) = fields%mobility_h(i + 1, 1)*gradient
    end do
  end subroutine newtonian_flow

  !> Net volume outflow per length [m/s] of each inner node's cell; zero at both ends.
  pure subroutine line_imbalance(grid, fields, faces, imbalance)
    type(line_grid), intent(in) :: grid
    type(film_fields), intent(in) :: fields
    type(line_flow), intent(in) :: faces
    real(wp), contiguous, intent(out) :: imbalance(:)
    real(wp) :: flux(grid%n - 1)
    integer :: i, first, last

    do i = 1, grid%n - 1
      first = max(i - 1, 1)
      last = min(i + 2, grid%n)
      associate (weights => wedge_weights(grid, i), rho => fields%rho(first:last, 1), h => fields%h(first:last, 1))
        flux(i) = sum(weights(first - i + 2:last - i + 2)*rho*h)
      end associate
      flux(i) = flux(i) - faces%flow(i)
    end do
    imbalance(1) = 0
    imbalance(grid%n) = 0
    do i = 2, grid%n - 1
      imbalance(i) = (flux(i) - flux(i - 1))/grid%dx + grid%implicit_rate*fields%rho(i, 1)*fields%h(i, 1) + grid%explicit_rate(i)
    end do
  end subroutine line_imbalance

  !> Derivatives of the imbalance at node i by the oil's pressure and by the film, of rough surfaces the gap between mean planes,
  !> at node i + k, k from -2 to 2.
  !>
  !> Entries that would belong to a node beyond an end are zero, and so are the rows of both ends. In a gap that is filled in
  !> part, `partial`, they are those at fixed fractions.
  pure subroutine line_bands(grid, fields, faces, by_pressure, by_film, partial)
    type(line_grid), intent(in) :: grid
    type(film_fields), intent(in) :: fields
    type(line_flow), intent(in) :: faces
    real(wp), intent(out) :: by_pressure(:, -2:), by_film(:, -2:)
    type(partial_film), intent(in), optional :: partial
    real(wp) :: weight(-1:2), p(-1:2), h(-1:2), widening(grid%n), fraction(grid%n)
    integer :: i, k, node

    fraction = 1
    if (present(partial)) fraction = partial%fraction
    widening = 1
    if (fields%is_rough()) widening = fields%rough%widening(:, 1)
    by_pressure = 0
    by_film = 0
    do i = 1, grid%n - 1
      weight = wedge_weights(grid, i)
      if (present(partial)) weight = partial%follow_x(i)*weight
      p = 0
      h = 0
      do k = max(-1, 1 - i), min(2, grid%n - i)
        node = i + k
        p(k) = weight(k)*fields%rho_p(node, 1)*fields%h(node, 1)
        h(k) = weight(k)*fields%rho(node, 1)*widening(node)
      end do
      p(0:1) = p(0:1) - [faces%before(i), faces%after(i)]
      h(0:1) = h(0:1) - [faces%film_before(i), faces%film_after(i)]
      ! what flows through the face leaves node i and enters node i + 1
      by_pressure(i, -1:2) = by_pressure(i, -1:2) + p/grid%dx
      by_film(i, -1:2) = by_film(i, -1:2) + h/grid%dx
      by_pressure(i + 1, -2:1) = by_pressure(i + 1, -2:1) - p/grid%dx
      by_film(i + 1, -2:1) = by_film(i + 1, -2:1) - h/grid%dx
    end do
    by_pressure(:, 0) = by_pressure(:, 0) + grid%implicit_rate*fraction*fields%rho_p(:, 1)*fields%h(:, 1)
    by_film(:, 0) = by_film(:, 0) + grid%implicit_rate*fraction*fields%rho(:, 1)*widening
    do i = 1, grid%n, grid%n - 1
      by_pressure(i, :) = 0
      by_film(i, :) = 0
    end do
  end subroutine line_bands

  !> Multiplies such a band with the changes at the nodes.
  pure function band_product(band, change) result(product)
    real(wp), intent(in) :: band(:, -2:), change(:)
    real(wp) :: product(size(change))
    integer :: k, n

    n = size(change)
    product = 0
    do k = -2, 2
      associate (first => max(1, 1 - k), last => min(n, n - k))
        product(first:last) = product(first:last) + band(first:last, k)*change(first + k:last + k)
      end associate
    end do
  end function band_product

  !> Multiplies the transpose of such a band with weights of the nodes' imbalance.
  pure function transposed_band_product(band, weight) result(product)
    real(wp), intent(in) :: band(:, -2:), weight(:)
    real(wp) :: product(size(weight))
    integer :: k, n

    n = size(weight)
    product = 0
    do k = -2, 2
      associate (first => max(1, 1 - k), last => min(n, n - k))
        product(first + k:last + k) = product(first + k:last + k) + band(first:last, k)*weight(first:last)
      end associate
    end do
  end function transposed_band_product

  !> Wedge flow through the face after node i as weights of rho h at the nodes i - 1 to i + 2: upwind to second
  !> order, next to an end the mean of the face's two nodes.
  pure function wedge_weights(grid, i) result(weights)
    type(line_grid), intent(in) :: grid
    integer, intent(in) :: i
    real(wp) :: weights(4)

    if (i == 1 .or. i == grid%n - 1) then
      weights = grid%u(i)*[0.0_wp, 0.5_wp, 0.5_wp, 0.0_wp]
    else if (grid%u(i) > 0) then
      weights = grid%u(i)*[-0.5_wp, 1.5_wp, 0.0_wp, 0.0_wp]
    else
      weights = grid%u(i)*[0.0_wp, 0.0_wp, 1.5_wp, -0.5_wp]
    end if
  end function wedge_weights

end module pyworm_line_reynolds
