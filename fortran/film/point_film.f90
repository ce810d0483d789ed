!> The film of a point contact at a given temperature: one Newton step at a time.
!>
!> Unknowns are the pressure at the nodes and the rigid film h0 in h = h0 + gap + K p. Pressure and net outflow
!> obey p >= 0, r >= 0, p r = 0 (the film ruptures at ambient pressure), solved by a primal-dual active set
!> (semismooth Newton): pressure is free where it is positive or oil flows in. The load balance closes the
!> system. Python owns the loop; each call does one step.
module point_film
  use half_space, only: elastic_half_space, new_half_space
  use interruption, only: interrupted
  use kinds, only: pp, wp
  use krylov, only: linear_system, gmres
  use multigrid, only: film_multigrid, new_film_multigrid, set_entrainment, set_film_multigrid, film_cycle
  use flow_laws, only: flow_law
  use oil_laws, only: oil_law
  use reynolds, only: film_grid, film_fields, new_film_fields, set_film_fields, flow_imbalance, &
    flow_imbalance_change
  use sheared_reynolds, only: sheared_film, new_sheared_film, set_sheared_fields, sheared_imbalance, &
    sheared_imbalance_change
  use status, only: status_ok, status_bad_argument, status_interrupted, status_not_finite, status_no_descent, &
    status_no_memory
  use tally, only: work_tally
  use vectors, only: total
  implicit none(type, external)
  private

  public :: point_contact, new_point_contact, shear_point_contact, entrain, store, film_residual, film_step
  public :: film_direction, move_film, film_balance, bearable, search_step

  !> Most Krylov iterations in one Newton step.
  integer, parameter :: most_krylov = 16
  !> Shortest step tried along a Newton direction.
  real(wp), parameter :: shortest_step = 1.0_wp/64
  !> Growth of the residual that a step may bring: the rupture line's moves raise it for a step or two.
  real(wp), parameter :: most_growth = 2

  !> Work on a contact: convolutions, fields and flows, building the preconditioner, its cycles; all of it,
  !> by the caller.
  type :: film_work
    type(work_tally) :: convolution, flow, building, cycle, whole
  end type film_work

  type, extends(linear_system) :: point_contact
    type(film_grid) :: grid
    type(oil_law) :: oil
    type(elastic_half_space) :: space
    type(film_multigrid) :: cycles
    type(film_fields) :: fields
    !> The flow across the film where the oil is not Newtonian or not of one temperature.
    type(sheared_film), allocatable :: shear
    !> Undeformed gap [m]; true where both surfaces exist.
    real(wp), allocatable :: gap(:, :)
    logical, allocatable :: covered(:, :)
    !> Load [N] and the film [m] below which mobility falls no further.
    real(wp) :: load = 0, floor = 0
    !> Summed wedge flow of the undeformed gap [m/s], by which residuals are measured, and what brings the
    !> load's row to the size of the others [m/(N s)].
    real(wp) :: wedge = 0, load_weight = 0
    !> True where pressure is free in the present step.
    logical, allocatable :: free(:, :)
    !> Net outflow per area [m/s].
    real(wp), allocatable :: imbalance(:, :)
    !> Response of pressure to a rise of the rigid film, by the preconditioner, and its load.
    real(wp), allocatable :: softness(:, :)
    real(wp) :: softness_load = 0
    !> Scratch of one field; the Newton step's right-hand side, then the pressure and rigid film it starts
    !> from; its solution; the Krylov basis.
    real(wp), allocatable :: dh(:, :), right(:), change(:)
    real(pp), allocatable :: basis(:, :)
    type(film_work) :: work
  contains
    procedure :: multiply
    procedure :: precondition
  end type point_contact

contains

  !> A point contact on a grid of (nx, ny) points, in a steady state; `u`, `v` are nodal entrainment [m/s].
  subroutine new_point_contact(self, gap, covered, u, v, dx, dy, reduced_modulus, oil, load, floor, stat)
    type(point_contact), intent(inout) :: self
    real(wp), intent(in) :: gap(:, :), u(:, :), v(:, :)
    logical, intent(in) :: covered(:, :)
    real(wp), intent(in) :: dx, dy, reduced_modulus, load, floor
    type(oil_law), intent(in) :: oil
    integer, intent(out) :: stat
    integer :: nx, ny, err

    nx = size(gap, 1)
    ny = size(gap, 2)
    stat = status_bad_argument
    if (.not. (load > 0 .and. floor > 0 .and. oil%eta0 > 0)) return
    stat = status_not_finite
    if (.not. all(abs(gap) <= huge(1.0_wp)) .or. .not. all(abs(u) + abs(v) <= huge(1.0_wp))) return
    call new_half_space(self%space, nx, ny, dx, dy, reduced_modulus, stat)
    if (stat /= status_ok) return

    self%grid = film_grid(nx, ny, dx, dy, face_mean_x(u), face_mean_y(v))
    allocate (self%grid%squeeze(nx, ny), source=0.0_wp)
    self%oil = oil
    self%gap = gap
    self%covered = covered
    self%covered(1, :) = .false.
    self%covered(nx, :) = .false.
    self%covered(:, 1) = .false.
    self%covered(:, ny) = .false.
    self%load = load
    self%floor = floor
    self%wedge = wedge_flow(self%grid, gap)
    self%load_weight = self%wedge/load/sqrt(real(nx*ny, wp))
    call new_film_fields(nx, ny, self%fields, stat)
    if (stat == status_ok) call new_film_multigrid(self%grid, self%space%centre, self%cycles, stat)
    if (stat /= status_ok) return
    allocate (self%free(nx, ny), self%imbalance(nx, ny), self%softness(nx, ny), self%dh(nx, ny), &
      self%right(nx*ny + 1), self%change(nx*ny + 1), &
      self%basis(nx*ny + 1, most_krylov), stat=err)
    if (err /= 0) stat = status_no_memory
  end subroutine new_point_contact

  !> Changes the nodal entrainment to (u, v) [m/s]. Residuals stay measured by the wedge flow of the first one.
  subroutine entrain(self, u, v)
    type(point_contact), intent(inout) :: self
    real(wp), intent(in) :: u(:, :), v(:, :)

    self%grid%u = face_mean_x(u)
    self%grid%v = face_mean_y(v)
    call set_entrainment(self%cycles, self%grid)
  end subroutine entrain

  !> Lets the oil that the film stores change by `renewal` [1/s] times rho h, and by `squeeze` [m/s].
  subroutine store(self, renewal, squeeze, stat)
    type(point_contact), intent(inout) :: self
    real(wp), intent(in) :: renewal, squeeze(:, :)
    integer, intent(out) :: stat

    stat = status_bad_argument
    if (any(shape(squeeze) /= shape(self%gap))) return
    stat = status_not_finite
    if (.not. (abs(renewal) <= huge(1.0_wp) .and. all(abs(squeeze) <= huge(1.0_wp)))) return
    stat = status_ok
    self%grid%renewal = renewal
    self%grid%squeeze = squeeze
    self%cycles%renewal = real(renewal, pp)
    self%wedge = wedge_flow(self%grid, self%gap)
    self%load_weight = self%wedge/self%load/sqrt(real(size(squeeze), wp))
  end subroutine store

  !> Gives the oil a flow law, in place of any it has, and `levels` levels across the film, all at the inlet temperature.
  !>
  !> `sliding` is the nodal velocity of body 2 relative to body 1 [m/s].
  subroutine shear_point_contact(self, law, levels, sliding_x, sliding_y, stat)
    type(point_contact), intent(inout) :: self
    type(flow_law), intent(in) :: law
    integer, intent(in) :: levels
    real(wp), intent(in) :: sliding_x(:, :), sliding_y(:, :)
    integer, intent(out) :: stat
    integer :: err

    stat = status_not_finite
    if (.not. all(abs(sliding_x) + abs(sliding_y) <= huge(1.0_wp))) return
    if (.not. allocated(self%shear)) allocate (self%shear)
    call new_sheared_film(law, levels, sliding_x, sliding_y, self%shear, stat)
    if (stat /= status_ok .or. allocated(self%fields%mobility_y)) return
    allocate (self%fields%mobility_y(self%grid%nx, self%grid%ny), source=0.0_wp, stat=err)
    if (err /= 0) stat = status_no_memory
  end subroutine shear_point_contact

  !> Mean of each node and the next along x; the last column is not used.
  pure function face_mean_x(a) result(mean)
    real(wp), intent(in) :: a(:, :)
    real(wp) :: mean(size(a, 1), size(a, 2))

    mean = (a + eoshift(a, 1, dim=1))/2
  end function face_mean_x

  !> Mean of each node and the next along y; the last row is not used.
  pure function face_mean_y(a) result(mean)
    real(wp), intent(in) :: a(:, :)
    real(wp) :: mean(size(a, 1), size(a, 2))

    mean = (a + eoshift(a, 1, dim=2))/2
  end function face_mean_y

  !> Evaluates film and imbalance at pressure p [Pa] and rigid film h0 [m].
  !>
  !> `residual` is the imbalance that complementarity leaves, summed, over the summed wedge flow; `load_error`
  !> is the missing load over the load.
  subroutine film_residual(self, p, h0, residual, load_error)
    type(point_contact), intent(inout) :: self
    real(wp), contiguous, intent(in) :: p(:, :)
    real(wp), intent(in) :: h0
    real(wp), intent(out) :: residual, load_error

    call set_film(self, p, h0)
    call film_balance(self, residual, load_error)
  end subroutine film_residual

  !> The film at pressure p [Pa] and rigid film h0 [m]; what flows is not known before `film_balance`.
  subroutine set_film(self, p, h0)
    type(point_contact), intent(inout) :: self
    real(wp), contiguous, intent(in) :: p(:, :)
    real(wp), intent(in) :: h0
    integer :: j

    call self%work%convolution%start()
    call self%space%deflection(p, self%fields%h)
    call self%work%convolution%finish()
    !$omp parallel do schedule(static)
    do j = 1, self%grid%ny
      self%fields%p(:, j) = p(:, j)
      self%fields%h(:, j) = self%fields%h(:, j) + self%gap(:, j) + h0
    end do
  end subroutine set_film

  !> Flow and imbalance at the pressure and film that are held; for the arguments see `film_residual`.
  subroutine film_balance(self, residual, load_error)
    type(point_contact), intent(inout) :: self
    real(wp), intent(out) :: residual, load_error
    integer :: j

    call self%work%flow%start()
    if (allocated(self%shear)) then
      call set_sheared_fields(self%grid, self%oil, self%floor, self%shear, self%fields)
      call sheared_imbalance(self%grid, self%shear, self%fields, self%imbalance)
    else
      call set_film_fields(self%oil, self%floor, self%fields)
      call flow_imbalance(self%grid, self%fields, self%imbalance)
    end if
    associate (p => self%fields%p)
      !$omp parallel do schedule(static)
      do j = 1, self%grid%ny
        self%free(:, j) = self%covered(:, j) .and. (p(:, j) > 0 .or. self%imbalance(:, j) < 0)
        self%dh(:, j) = merge(abs(self%imbalance(:, j)), 0.0_wp, self%free(:, j))
      end do
      residual = total(self%dh)/self%wedge
      ! a film with a stress that was not found is not to count as one that flows by its law
      if (allocated(self%shear)) residual = residual + sum(self%shear%strips%unsolved)
      load_error = 1 - total(p)*self%grid%dx*self%grid%dy/self%load
    end associate
    call self%work%flow%finish()
  end subroutine film_balance

  !> Sum of |um . grad g| and of what the gap stores over the inner nodes [m/s], g being the undeformed gap [m].
  pure real(wp) function wedge_flow(grid, gap)
    type(film_grid), intent(in) :: grid
    real(wp), intent(in) :: gap(:, :)
    integer :: i, j

    wedge_flow = 0
    do j = 2, grid%ny - 1
      do i = 2, grid%nx - 1
        wedge_flow = wedge_flow + abs(grid%u(i, j)*(gap(i + 1, j) - gap(i - 1, j))/(2*grid%dx) &
          + grid%v(i, j)*(gap(i, j + 1) - gap(i, j - 1))/(2*grid%dy)) &
          + abs(grid%renewal*gap(i, j) + grid%squeeze(i, j))
      end do
    end do
  end function wedge_flow

  !> One Newton step from (p, h0), about which `film_residual` was last evaluated; both are replaced.
  !>
  !> The linear system is solved to `forcing` times its right-hand side. `krylov` counts GMRES iterations,
  !> `step` is the share of the Newton step taken. If none is taken the state is as it was.
  subroutine film_step(self, forcing, p, h0, residual, load_error, krylov, step, stat)
    type(point_contact), intent(inout) :: self
    real(wp), intent(in) :: forcing
    real(wp), contiguous, intent(inout) :: p(:, :)
    real(wp), intent(inout) :: h0
    real(wp), intent(inout) :: residual, load_error
    integer, intent(out) :: krylov, stat
    real(wp), intent(out) :: step

    step = 0
    call film_direction(self, forcing, p, h0, load_error, krylov, stat)
    if (stat == status_ok) call search_step(self, residual + abs(load_error), p, h0, residual, load_error, step, stat)
  end subroutine film_step

  !> Newton's step from (p, h0), of which `move_film` takes a share.
  subroutine film_direction(self, forcing, p, h0, load_error, krylov, stat)
    type(point_contact), intent(inout) :: self
    real(wp), intent(in) :: forcing, h0, load_error
    real(wp), contiguous, intent(in) :: p(:, :)
    integer, intent(out) :: krylov, stat
    real(wp) :: reduction
    integer :: j, k, nx, n

    nx = self%grid%nx
    n = size(p)
    krylov = 0
    call self%work%building%start()
    call set_film_multigrid(self%cycles, self%fields, self%free, stat)
    call self%work%building%finish()
    if (stat /= status_ok) return
    call set_softness(self)

    do j = 1, self%grid%ny
      k = nx*(j - 1)
      self%right(k + 1:k + nx) = merge(-self%imbalance(:, j), 0.0_wp, self%free(:, j))
    end do
    self%right(n + 1) = load_error*self%load*self%load_weight
    call gmres(self, self%right, forcing, most_krylov, self%basis, self%change, krylov, reduction)
    if (interrupted()) then
      stat = status_interrupted
      return
    end if
    if (.not. all(abs(self%change) <= huge(1.0_wp))) then
      stat = status_not_finite
      return
    end if

    do j = 1, self%grid%ny
      k = nx*(j - 1)
      self%right(k + 1:k + nx) = p(:, j)
    end do
    self%right(n + 1) = h0
  end subroutine film_direction

  !> Pressure, rigid film and film after a share of the Newton step.
  subroutine move_film(self, share, p, h0)
    type(point_contact), intent(inout) :: self
    real(wp), intent(in) :: share
    real(wp), contiguous, intent(inout) :: p(:, :)
    real(wp), intent(out) :: h0
    integer :: j, k, nx, n

    nx = self%grid%nx
    n = size(p)
    do j = 1, self%grid%ny
      k = nx*(j - 1)
      p(:, j) = max(self%right(k + 1:k + nx) + share*self%change(k + 1:k + nx), 0.0_wp)
    end do
    h0 = self%right(n + 1) + share*self%change(n + 1)
    call set_film(self, p, h0)
  end subroutine move_film

  !> Whether the residual and load error of a film have not grown too much from `merit`, their sum.
  pure logical function bearable(merit, residual, load_error)
    real(wp), intent(in) :: merit, residual, load_error

    bearable = residual + abs(load_error) <= most_growth*merit
  end function bearable

  !> Takes the largest share of Newton's step, by halving, that a film bears; for the arguments see `film_step`.
  subroutine search_step(self, merit, p, h0, residual, load_error, step, stat)
    type(point_contact), intent(inout) :: self
    real(wp), intent(in) :: merit
    real(wp), contiguous, intent(inout) :: p(:, :)
    real(wp), intent(inout) :: h0
    real(wp), intent(out) :: residual, load_error, step
    integer, intent(out) :: stat

    step = 1
    do
      call move_film(self, step, p, h0)
      call film_balance(self, residual, load_error)
      stat = merge(status_ok, status_no_descent, step > 0)
      if (bearable(merit, residual, load_error) .or. .not. step > 0) return
      if (interrupted()) then
        stat = status_interrupted
        return
      end if
      step = merge(step/2, 0.0_wp, step > shortest_step)
    end do
  end subroutine search_step

  !> Pressure by which the preconditioner answers a unit rise of the rigid film.
  subroutine set_softness(self)
    type(point_contact), target, intent(inout) :: self
    real(wp), contiguous, pointer :: start(:, :)

    ! softness, change and dh are free at this point of a step
    self%softness = 0
    self%dh = 1
    start(1:self%grid%nx, 1:self%grid%ny) => self%change(:size(self%dh))
    call imbalance_change(self, self%softness, self%dh, start)
    call self%work%cycle%start()
    call film_cycle(self%cycles, start, self%softness)
    call self%work%cycle%finish()
    self%softness_load = total(self%softness)
  end subroutine set_softness

  !> Change of the imbalance for a small change of pressure and film.
  subroutine imbalance_change(self, dp, dh, change)
    class(point_contact), intent(inout) :: self
    real(wp), contiguous, intent(in) :: dp(:, :), dh(:, :)
    real(wp), contiguous, intent(out) :: change(:, :)

    if (allocated(self%shear)) then
      call sheared_imbalance_change(self%grid, self%shear, self%fields, dp, dh, change)
    else
      call flow_imbalance_change(self%grid, self%fields, dp, dh, change)
    end if
  end subroutine imbalance_change

  !> The Jacobian: (change of pressure, of h0) to (change of imbalance, of load).
  subroutine multiply(self, x, y)
    class(point_contact), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    real(wp), contiguous, pointer :: dp(:, :), dr(:, :)
    integer :: j, n

    n = self%grid%nx*self%grid%ny
    dp(1:self%grid%nx, 1:self%grid%ny) => x(:n)
    dr(1:self%grid%nx, 1:self%grid%ny) => y(:n)
    call self%work%convolution%start()
    call self%space%deflection(dp, self%dh)
    call self%work%convolution%finish()
    call self%work%flow%start()
    !$omp parallel do schedule(static)
    do j = 1, self%grid%ny
      self%dh(:, j) = self%dh(:, j) + x(n + 1)
    end do
    call imbalance_change(self, dp, self%dh, dr)
    !$omp parallel do schedule(static)
    do j = 1, self%grid%ny
      where (.not. self%free(:, j)) dr(:, j) = 0
    end do
    call self%work%flow%finish()
    y(n + 1) = total(dp)*self%grid%dx*self%grid%dy*self%load_weight
  end subroutine multiply

  !> Bordered approximate solve: a multigrid cycle for the pressure, with h0 such that the load comes out.
  subroutine precondition(self, x, y)
    class(point_contact), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    real(wp), contiguous, pointer :: r(:, :), dp(:, :)
    integer :: j, n

    n = self%grid%nx*self%grid%ny
    r(1:self%grid%nx, 1:self%grid%ny) => x(:n)
    dp(1:self%grid%nx, 1:self%grid%ny) => y(:n)
    call self%work%cycle%start()
    call film_cycle(self%cycles, r, dp)
    call self%work%cycle%finish()
    y(n + 1) = (total(dp) - x(n + 1)/(self%grid%dx*self%grid%dy*self%load_weight))/self%softness_load
    !$omp parallel do schedule(static)
    do j = 1, self%grid%ny
      dp(:, j) = dp(:, j) - self%softness(:, j)*y(n + 1)
    end do
  end subroutine precondition

end module point_film
