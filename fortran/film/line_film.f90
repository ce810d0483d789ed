!> The isothermal Newtonian film of a line contact: one Newton step at a time.
!>
!> Unknowns are the pressure at the nodes and the rigid film h0 in h = h0 + gap + K p. Pressure and net outflow
!> obey p >= 0, r >= 0, p r = 0 (the film ruptures at ambient pressure), solved by a primal-dual active set
!> (semismooth Newton): pressure is free where it is positive or oil flows in. The load balance closes the
!> system. Pressure at both ends is kept as it is given. Python owns the loop; each call does one step.
!>
!> Each step solves the exact Jacobian of the free nodes by dense LU.
module line_film
  use half_plane, only: elastic_half_plane, new_half_plane
  use kinds, only: wp
  use lapack, only: dgesv
  use line_reynolds, only: line_grid, line_imbalance, line_bands
  use oil_laws, only: oil_law
  use reynolds, only: film_fields, new_film_fields, set_film_fields
  use status, only: status_ok, status_bad_argument, status_not_finite, status_no_descent, status_no_memory
  implicit none(type, external)
  private

  public :: line_contact, new_line_contact, line_residual, line_step, line_jacobian

  !> Shortest step tried along a Newton direction.
  real(wp), parameter :: shortest_step = 1.0_wp/64

  type :: line_contact
    type(line_grid) :: grid
    type(oil_law) :: oil
    type(elastic_half_plane) :: plane
    type(film_fields) :: fields
    !> Undeformed gap [m]; true where both surfaces exist.
    real(wp), allocatable :: gap(:)
    logical, allocatable :: covered(:)
    !> Load for each length [N/m] and the film [m] below which mobility falls no further.
    real(wp) :: load = 0, floor = 0
    !> True where pressure is free in the present step.
    logical, allocatable :: free(:)
    !> Net outflow per length [m/s].
    real(wp), allocatable :: imbalance(:)
  end type line_contact

contains

  !> A line contact on a grid of n points; `u` is nodal entrainment [m/s].
  subroutine new_line_contact(self, gap, covered, u, squeeze, dx, reduced_modulus, oil, load, floor, stat)
    type(line_contact), intent(inout) :: self
    real(wp), intent(in) :: gap(:), u(:), squeeze(:)
    logical, intent(in) :: covered(:)
    real(wp), intent(in) :: dx, reduced_modulus, load, floor
    type(oil_law), intent(in) :: oil
    integer, intent(out) :: stat
    integer :: n

    n = size(gap)
    stat = status_bad_argument
    if (.not. (load > 0 .and. floor > 0 .and. oil%eta0 > 0)) return
    stat = status_not_finite
    if (.not. (load <= huge(1.0_wp) .and. all(abs(gap) <= huge(1.0_wp)))) return
    if (.not. all(abs(u) + abs(squeeze) <= huge(1.0_wp))) return
    call new_half_plane(self%plane, n, dx, reduced_modulus, stat)
    if (stat /= status_ok) return

    self%grid = line_grid(n, dx, (u(:n - 1) + u(2:))/2, squeeze)
    self%oil = oil
    self%gap = gap
    self%covered = covered
    self%covered([1, n]) = .false.
    self%load = load
    self%floor = floor
    call new_film_fields(n, 1, self%fields)
    allocate (self%free(n), self%imbalance(n))
  end subroutine new_line_contact

  !> Evaluates film and imbalance at pressure p [Pa] and rigid film h0 [m].
  !>
  !> `residual` is the imbalance that complementarity leaves, summed, over the summed wedge flow; `load_error`
  !> is the missing load over the load.
  subroutine line_residual(self, p, h0, residual, load_error)
    type(line_contact), intent(inout) :: self
    real(wp), contiguous, intent(in) :: p(:)
    real(wp), intent(in) :: h0
    real(wp), intent(out) :: residual, load_error

    self%fields%p(:, 1) = p
    call self%plane%deflection(p, self%fields%h(:, 1))
    self%fields%h(:, 1) = self%fields%h(:, 1) + self%gap + h0
    call set_film_fields(self%oil, self%floor, self%fields)
    call line_imbalance(self%grid, self%fields, self%imbalance)
    self%free = self%covered .and. (p > 0 .or. self%imbalance < 0)
    residual = sum(abs(self%imbalance), mask=self%free)/wedge_scale(self)
    load_error = 1 - sum(p)*self%grid%dx/self%load
  end subroutine line_residual

  !> Sum of |um dh/dx|: what the residual is measured by.
  pure real(wp) function wedge_scale(self)
    type(line_contact), intent(in) :: self
    integer :: n

    n = self%grid%n
    wedge_scale = sum(abs(self%grid%u(2:)*(self%gap(3:) - self%gap(:n - 2))/(2*self%grid%dx)) &
      + abs(self%grid%squeeze(2:n - 1)))
  end function wedge_scale

  !> One Newton step from (p, h0), about which `line_residual` was last evaluated; both are replaced.
  !>
  !> `step` is the share of the Newton step taken.
  subroutine line_step(self, p, h0, residual, load_error, step, stat)
    type(line_contact), intent(inout) :: self
    real(wp), contiguous, intent(inout) :: p(:)
    real(wp), intent(inout) :: h0, residual, load_error
    real(wp), intent(out) :: step
    integer, intent(out) :: stat
    real(wp) :: start(size(p)), change(size(p)), change_h0, start_h0, merit

    step = 0
    call newton_direction(self, load_error, change, change_h0, stat)
    if (stat /= status_ok) return

    start = p
    start_h0 = h0
    merit = residual + abs(load_error)
    step = 1
    do
      p = max(start + step*change, 0.0_wp)
      h0 = start_h0 + step*change_h0
      call line_residual(self, p, h0, residual, load_error)
      if (residual + abs(load_error) <= 2*merit) exit
      if (step < shortest_step) then
        stat = status_no_descent
        return
      end if
      step = step/2
    end do
  end subroutine line_step

  !> Change of pressure and rigid film that removes imbalance and missing load to first order.
  subroutine newton_direction(self, load_error, change, change_h0, stat)
    type(line_contact), intent(in) :: self
    real(wp), intent(in) :: load_error
    real(wp), intent(out) :: change(:), change_h0
    integer, intent(out) :: stat
    integer :: nodes(count(self%free)), pivots(count(self%free) + 1)
    real(wp) :: right(count(self%free) + 1, 1), row_scale
    real(wp), allocatable :: matrix(:, :)
    integer :: i, m, info

    change = 0
    change_h0 = 0
    nodes = pack([(i, i=1, self%grid%n)], self%free)
    m = size(nodes)
    stat = status_no_memory
    allocate (matrix(m + 1, m + 1), stat=info)
    if (info /= 0) return
    call line_jacobian(self, nodes, matrix)
    stat = status_not_finite
    if (.not. all(abs(matrix) <= huge(1.0_wp))) return

    ! pivoting compares rows: the load's is brought to the size of the others
    row_scale = maxval(abs(matrix(:m, :m)))/self%grid%dx
    matrix(m + 1, :) = matrix(m + 1, :)*row_scale
    right(:m, 1) = -self%imbalance(nodes)
    right(m + 1, 1) = load_error*self%load*row_scale
    call dgesv(m + 1, 1, matrix, m + 1, pivots, right, m + 1, info)
    stat = status_no_descent
    if (info /= 0) return
    stat = status_not_finite
    if (.not. all(abs(right) <= huge(1.0_wp))) return
    change(nodes) = right(:m, 1)
    change_h0 = right(m + 1, 1)
    stat = status_ok
  end subroutine newton_direction

  !> Derivatives of (imbalance at `nodes`, load) by (pressure at `nodes`, h0), at the state last evaluated.
  subroutine line_jacobian(self, nodes, matrix)
    type(line_contact), intent(in) :: self
    integer, intent(in) :: nodes(:)
    real(wp), contiguous, intent(out) :: matrix(:, :)
    real(wp) :: by_pressure(self%grid%n, -2:2), by_film(self%grid%n, -2:2), column(self%grid%n)
    integer :: j, k, m, n, node

    n = self%grid%n
    m = size(nodes)
    call line_bands(self%grid, self%fields, by_pressure, by_film)
    do j = 1, m
      node = nodes(j)
      column = 0
      do k = -2, 2
        column = column + by_film(:, k)*self%plane%influence(1 + k - node:n + k - node)
        if (node - k >= 1 .and. node - k <= n) column(node - k) = column(node - k) + by_pressure(node - k, k)
      end do
      matrix(:m, j) = column(nodes)
    end do
    column = sum(by_film, 2)
    matrix(:m, m + 1) = column(nodes)
    matrix(m + 1, :m) = self%grid%dx
    matrix(m + 1, m + 1) = 0
  end subroutine line_jacobian

end module line_film
