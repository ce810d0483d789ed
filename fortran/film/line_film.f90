!> The film of a line contact at a given temperature: one Newton step at a time.
!>
!> Unknowns are the pressure at the nodes and the rigid film h0 in h = h0 + gap + K p. Pressure and net outflow
!> obey p >= 0, r >= 0, p r = 0 (the film ruptures at ambient pressure), solved by a primal-dual active set
!> (semismooth Newton): pressure is free where it is positive or oil flows in. The load balance closes the
!> system. Pressure at both ends is kept as it is given. Python owns the loop; each call does one step.
!>
!> Each step solves the exact Jacobian by GMRES, with `line_preconditioner` before it.
module line_film
  use flow_laws, only: flow_law
  use half_plane, only: elastic_half_plane, new_half_plane
  use kinds, only: pp, wp
  use krylov, only: linear_system, gmres
  use line_preconditioner, only: band_model, set_band_model
  use line_reynolds, only: line_grid, line_flow, new_line_flow, newtonian_flow, line_imbalance, line_bands, &
    band_product
  use line_shear, only: sheared_flow
  use oil_laws, only: oil_law
  use reynolds, only: film_fields, new_film_fields, set_film_fields
  use sheared_reynolds, only: sheared_film, new_sheared_film
  use status, only: status_ok, status_bad_argument, status_not_finite, status_no_descent, status_no_memory
  implicit none(type, external)
  private

  public :: line_contact, new_line_contact, shear_line_contact, store_line, line_residual, set_line_system, line_step

  !> Most Krylov iterations in one Newton step.
  integer, parameter :: most_krylov = 60
  !> Shortest step tried along a Newton direction.
  real(wp), parameter :: shortest_step = 1.0_wp/64
  !> Growth of the residual that a step may bring: the rupture line's moves raise it for a step or two.
  real(wp), parameter :: most_growth = 2

  type, extends(linear_system) :: line_contact
    type(line_grid) :: grid
    type(oil_law) :: oil
    type(elastic_half_plane) :: plane
    type(film_fields) :: fields
    type(line_flow) :: flow
    !> The flow across the film where the oil is not Newtonian or not of one temperature.
    type(sheared_film), allocatable :: shear
    type(band_model) :: model
    !> Undeformed gap [m]; true where both surfaces exist.
    real(wp), allocatable :: gap(:)
    logical, allocatable :: covered(:)
    !> Load for each length [N/m] and the film [m] below which mobility falls no further.
    real(wp) :: load = 0, floor = 0
    !> True where pressure is free in the present step.
    logical, allocatable :: free(:)
    !> Net outflow per length [m/s], and its derivatives by pressure and film at the nodes -2 to 2 further on.
    real(wp), allocatable :: imbalance(:), by_pressure(:, :), by_film(:, :)
    !> Response of pressure to a rise of the rigid film, by the preconditioner.
    real(wp), allocatable :: softness(:)
    !> Krylov basis.
    real(pp), allocatable :: basis(:, :)
  contains
    procedure :: multiply
    procedure :: precondition
  end type line_contact

contains

  !> A line contact on a grid of n points, in a steady state; `u` is nodal entrainment [m/s].
  subroutine new_line_contact(self, gap, covered, u, dx, reduced_modulus, oil, load, floor, stat)
    type(line_contact), intent(inout) :: self
    real(wp), intent(in) :: gap(:), u(:)
    logical, intent(in) :: covered(:)
    real(wp), intent(in) :: dx, reduced_modulus, load, floor
    type(oil_law), intent(in) :: oil
    integer, intent(out) :: stat
    integer :: n, err

    n = size(gap)
    stat = status_bad_argument
    if (.not. (load > 0 .and. floor > 0 .and. oil%eta0 > 0)) return
    stat = status_not_finite
    if (.not. (load <= huge(1.0_wp) .and. all(abs(gap) <= huge(1.0_wp)))) return
    if (.not. all(abs(u) <= huge(1.0_wp))) return
    call new_half_plane(self%plane, n, dx, reduced_modulus, stat)
    if (stat /= status_ok) return

    self%grid = line_grid(n, dx, (u(:n - 1) + u(2:))/2)
    allocate (self%grid%squeeze(n), source=0.0_wp)
    self%oil = oil
    self%gap = gap
    self%covered = covered
    self%covered([1, n]) = .false.
    self%load = load
    self%floor = floor
    call new_film_fields(n, 1, self%fields, stat)
    if (stat == status_ok) call new_line_flow(n, self%flow, stat)
    if (stat /= status_ok) return
    allocate (self%free(n), self%imbalance(n), self%by_pressure(n, -2:2), self%by_film(n, -2:2), self%softness(n), &
      self%basis(n + 1, most_krylov), stat=err)
    if (err /= 0) stat = status_no_memory
  end subroutine new_line_contact

  !> Lets the oil that the film stores change by `renewal` [1/s] times rho h, and by `squeeze` [m/s].
  subroutine store_line(self, renewal, squeeze, stat)
    type(line_contact), intent(inout) :: self
    real(wp), intent(in) :: renewal, squeeze(:)
    integer, intent(out) :: stat

    stat = status_bad_argument
    if (size(squeeze) /= self%grid%n) return
    stat = status_not_finite
    if (.not. (abs(renewal) <= huge(1.0_wp) .and. all(abs(squeeze) <= huge(1.0_wp)))) return
    stat = status_ok
    self%grid%renewal = renewal
    self%grid%squeeze = squeeze
  end subroutine store_line

  !> Gives the oil a flow law and `levels` levels across the film, all at the inlet temperature.
  !>
  !> `sliding` is the nodal velocity of body 2 relative to body 1 [m/s].
  subroutine shear_line_contact(self, law, levels, sliding, stat)
    type(line_contact), intent(inout) :: self
    type(flow_law), intent(in) :: law
    integer, intent(in) :: levels
    real(wp), intent(in) :: sliding(:)
    integer, intent(out) :: stat
    real(wp) :: along(size(sliding), 1), across(size(sliding), 1)

    stat = status_not_finite
    if (.not. all(abs(sliding) <= huge(1.0_wp))) return
    along(:, 1) = sliding
    across = 0
    allocate (self%shear)
    call new_sheared_film(law, levels, along, across, self%shear, stat)
  end subroutine shear_line_contact

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
    if (allocated(self%shear)) then
      call sheared_flow(self%grid, self%oil, self%floor, self%shear, self%fields, self%flow)
    else
      call set_film_fields(self%oil, self%floor, self%fields)
      call newtonian_flow(self%grid, self%fields, self%flow)
    end if
    call line_imbalance(self%grid, self%fields, self%flow, self%imbalance)
    self%free = self%covered .and. (p > 0 .or. self%imbalance < 0)
    residual = sum(abs(self%imbalance), mask=self%free)/wedge_scale(self)
    ! a film with a stress that was not found is not to count as one that flows by its law
    if (allocated(self%shear)) residual = residual + sum(self%shear%strips%unsolved)
    load_error = 1 - sum(p)*self%grid%dx/self%load
  end subroutine line_residual

  !> Sum of |um dg/dx| and of what the gap g stores: what the residual is measured by.
  pure real(wp) function wedge_scale(self)
    type(line_contact), intent(in) :: self
    integer :: n

    n = self%grid%n
    wedge_scale = sum(abs(self%grid%u(2:)*(self%gap(3:) - self%gap(:n - 2))/(2*self%grid%dx)) &
      + abs(self%grid%renewal*self%gap(2:n - 1) + self%grid%squeeze(2:n - 1)))
  end function wedge_scale

  !> One Newton step from (p, h0), about which `line_residual` was last evaluated; both are replaced.
  !>
  !> The linear system is solved to `forcing` times its right-hand side. `krylov` counts GMRES iterations,
  !> `step` is the share of the Newton step taken. If none is taken the state is as it was.
  subroutine line_step(self, forcing, p, h0, residual, load_error, krylov, step, stat)
    type(line_contact), intent(inout) :: self
    real(wp), intent(in) :: forcing
    real(wp), contiguous, intent(inout) :: p(:)
    real(wp), intent(inout) :: h0, residual, load_error
    integer, intent(out) :: krylov, stat
    real(wp), intent(out) :: step
    real(wp) :: start(size(p)), right(size(p) + 1), change(size(p) + 1), start_h0, merit, reduction
    integer :: n

    n = size(p)
    step = 0
    krylov = 0
    call set_line_system(self, stat)
    if (stat /= status_ok) return
    right(:n) = merge(-self%imbalance, 0.0_wp, self%free)
    right(n + 1) = load_error*self%load*load_scale(self)
    call gmres(self, right, forcing, most_krylov, self%basis, change, krylov, reduction)
    stat = status_not_finite
    if (.not. all(abs(change) <= huge(1.0_wp))) return

    start = p
    start_h0 = h0
    merit = residual + abs(load_error)
    step = 1
    do
      p = max(start + step*change(:n), 0.0_wp)
      h0 = start_h0 + step*change(n + 1)
      call line_residual(self, p, h0, residual, load_error)
      if (residual + abs(load_error) <= most_growth*merit) exit
      step = step/2
      if (step < shortest_step) then
        p = start
        h0 = start_h0
        call line_residual(self, p, h0, residual, load_error)
        stat = status_no_descent
        return
      end if
    end do
    stat = status_ok
  end subroutine line_step

  !> Jacobian and preconditioner at the state last evaluated.
  subroutine set_line_system(self, stat)
    type(line_contact), intent(inout) :: self
    integer, intent(out) :: stat

    call line_bands(self%grid, self%fields, self%flow, self%by_pressure, self%by_film)
    call set_band_model(self%model, self%by_pressure, self%by_film, self%plane%influence, self%free, stat)
    if (stat /= status_ok) return
    self%softness = merge(sum(self%by_film, 2), 0.0_wp, self%free)
    call self%model%solve(self%softness)
  end subroutine set_line_system

  !> Brings the load's row to the size of the others.
  pure real(wp) function load_scale(self)
    type(line_contact), intent(in) :: self

    load_scale = wedge_scale(self)/self%load/sqrt(real(self%grid%n, wp))
  end function load_scale

  !> The Jacobian: (change of pressure, of h0) to (change of imbalance, of load).
  subroutine multiply(self, x, y)
    class(line_contact), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    real(wp) :: dh(self%grid%n)
    integer :: n

    n = self%grid%n
    call self%plane%deflection(x(:n), dh)
    dh = dh + x(n + 1)
    y(:n) = merge(band_product(self%by_pressure, x(:n)) + band_product(self%by_film, dh), 0.0_wp, self%free)
    y(n + 1) = sum(x(:n))*self%grid%dx*load_scale(self)
  end subroutine multiply

  !> Bordered approximate solve: the band model for the pressure, with h0 such that the load comes out.
  subroutine precondition(self, x, y)
    class(line_contact), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    integer :: n

    n = self%grid%n
    y(:n) = x(:n)
    call self%model%solve(y(:n))
    y(n + 1) = (sum(y(:n)) - x(n + 1)/(self%grid%dx*load_scale(self)))/sum(self%softness)
    y(:n) = y(:n) - self%softness*y(n + 1)
  end subroutine precondition

end module line_film
