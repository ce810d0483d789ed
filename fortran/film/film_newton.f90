!> Newton's method for the film of a contact at a given temperature, one step at a time: the base of all contacts.
!>
!> Unknowns are the pressure at the nodes and the rigid film h0 in h = h0 + gap + K p. Pressure and net outflow
!> obey p >= 0, r >= 0, p r = 0 (the film ruptures at ambient pressure; where the supply of oil is limited the gap is filled in
!> part there, see `partial_film`), solved by a primal-dual active set (semismooth Newton): pressure is free where it is
!> positive or oil flows in. The load balance closes the system; where bodies are held apart the rigid film is given instead,
!> and does not change. Pressure on the outline is fixed. Python owns the loop; each call makes one step.
!>
!> Between rough surfaces the unknown is the total pressure P; the oil's is what the asperities leave, p = P - p_a(h),
!> with h the gap between the mean planes, and rupture obeys p >= 0, r >= 0, p r = 0. Asperities add no convolution: where the oil
!> has ruptured the row is P = p_a(h). Their pressure is part of each Newton step, since alternating with the film
!> diverges where asperities are stiffer than the bodies.
!>
!> A kind of contact adds its deflection K p, its flow and the approximate solve that precedes the exact Jacobian in
!> GMRES. Fields have shape (nx, ny); a line contact's have ny = 1.
module pyworm_film_newton
  use pyworm_coated_surface, only: elastic_layer
  use pyworm_film_model, only: film_model
  use pyworm_flow_laws, only: flow_law
  use pyworm_interruption, only: interrupted
  use pyworm_kinds, only: pp, wp
  use pyworm_krylov, only: linear_system, gmres
  use pyworm_reynolds, only: new_film_fields
  use pyworm_rough_surfaces, only: gap_curves
  use pyworm_status, only: status_ok, status_bad_argument, status_interrupted, status_not_finite, status_no_descent, &
    status_no_memory
  use pyworm_tally, only: work_tally
  use pyworm_vectors, only: total
  use pyworm_viscosity_density, only: oil_law
  implicit none(type, external)
  private

  public :: contact_conditions, newton_step
  public :: film_contact, film_status, new_film_contact, weigh_load, shear_contact, roughen_contact, set_transient_term
  public :: set_film, evaluate_flow, film_residual, film_residual_at, film_balance_again, film_step, set_ruptured
  public :: change_balance, set_system, film_direction, move_film, film_balance, acceptable, note_progress, search_step
  public :: first_row, last_row

  !> Cycles of GMRES in a Newton step: most need a third of one, sheared films with thick inlets up to three.
  integer, parameter :: most_cycles = 4
  !> Least damping factor of a Newton step.
  real(wp), parameter :: shortest_step = 1.0_wp/64
  !> Largest growth of the residual by a step: a moving rupture line raises it for a step or two. After so many heated steps
  !> that did not reach a new least residual no step may raise it as long as a shorter one lowers it: where viscosity grows
  !> e-fold many times from node to node full steps throw the pressure of single nodes to and fro by half of it, and heat
  !> follows. Of cold films that loses some: an isothermal film of 13 nm in a wide window was not found with it.
  real(wp), parameter :: most_growth = 2
  integer, parameter :: max_idle_steps = 3

  !> Work on a contact: convolutions, fields and flows, building the preconditioner, its solves; `whole` is
  !> timed by the caller.
  type :: film_work
    type(work_tally) :: convolution, flow, building, cycle, whole
  end type film_work

  !> What presses two surfaces together, and the oil between them.
  type :: contact_conditions
    !> Undeformed gap [m]; true where both surfaces exist.
    real(wp), allocatable :: gap(:, :)
    logical, allocatable :: covered(:, :)
    !> Spacing of the nodes along x and y [m], and E' [Pa] with 2/E' = (1-nu1^2)/E1 + (1-nu2^2)/E2.
    real(wp) :: spacing(2) = 0, reduced_modulus = 0
    type(oil_law) :: oil
    !> Load [N], of a line contact for each length [N/m], and the film [m] below which mobility is constant.
    real(wp) :: load = 0, floor = 0
    !> Layers on the bodies, whose E' is that without them.
    type(elastic_layer) :: layers(2) = elastic_layer()
  end type contact_conditions

  !> What a Newton step took: iterations of GMRES, the damping factor, which is the fraction of the step taken (at 0 the state
  !> is unchanged), and of a heated film the largest change of temperature [K].
  type :: newton_step
    integer :: krylov = 0
    real(wp) :: damping = 0, change = 0
  end type newton_step

  type, abstract, extends(linear_system) :: film_contact
    type(oil_law) :: oil
    type(film_model) :: model
    !> Spacing along x and y [m]; that of a line contact along y is 1, so that cells count for each length.
    real(wp) :: spacing(2) = 0
    !> Undeformed gap [m]; true where both surfaces exist and pressure is no boundary value.
    real(wp), allocatable :: gap(:, :)
    logical, allocatable :: covered(:, :)
    !> Load [N], of a line contact for each length [N/m], and the film [m] below which mobility is constant.
    real(wp) :: load = 0, floor = 0
    !> Whether the rigid film is given instead of the load.
    logical :: rigid_film_fixed = .false.
    !> Summed wedge flow of the undeformed gap [m/s], the reference of residuals, and the scale of the load's
    !> row.
    real(wp) :: wedge = 0, load_weight = 0
    !> Least residual and load error of the iteration, and steps since it was reached, up to `max_idle_steps`.
    real(wp) :: least = 0
    integer :: idle_steps = 0
    !> Whether steps that do not lead on are counted in a film without heat too, as between rough surfaces that move.
    logical :: counts_idle_steps = .false.
    !> True where pressure is free in the present step.
    logical, allocatable :: free(:, :)
    !> Net outflow per area [m/s].
    real(wp), allocatable :: imbalance(:, :)
    !> Response of the pressure to a unit rise of the rigid film, by the preconditioner, and its load.
    real(wp), allocatable :: softness(:, :)
    real(wp) :: softness_load = 0
    !> Scratch of one field; the Newton step's right-hand side, then the pressure and rigid film it starts
    !> from; its solution; the Krylov basis, whose columns limit the iterations of a step.
    real(wp), allocatable :: dh(:, :), right(:), change(:)
    real(pp), allocatable :: basis(:, :)
    type(film_work) :: work
  contains
    procedure(of_pressure), deferred :: deflection
    procedure(of_film), deferred :: set_flow
    procedure(linearisation), deferred :: linearise
    procedure(derivative), deferred :: imbalance_change
    procedure(solve), deferred :: relax
    procedure(wedge_flow), deferred :: wedge_flow
    procedure(transient_setter), deferred :: set_transient
    procedure(feeder), deferred :: feed
    procedure(linearisation), deferred :: linearise_adjoint
    procedure(transposed_derivative), deferred :: imbalance_adjoint
    procedure(solve), deferred :: relax_adjoint
    procedure :: multiply
    procedure :: precondition
  end type film_contact

  abstract interface
    !> Elastic deflection w [m] under pressure p [Pa].
    subroutine of_pressure(self, p, w)
      import :: film_contact, wp
      implicit none(type, external)
      class(film_contact), intent(inout) :: self
      real(wp), contiguous, target, intent(in) :: p(:, :)
      real(wp), contiguous, target, intent(out) :: w(:, :)
    end subroutine of_pressure

    !> Evaluates oil, flow and imbalance at the pressure and film of the fields.
    subroutine of_film(self)
      import :: film_contact
      implicit none(type, external)
      class(film_contact), intent(inout) :: self
    end subroutine of_film

    !> Builds the Jacobian and the preconditioner at the flow last set.
    subroutine linearisation(self, stat)
      import :: film_contact
      implicit none(type, external)
      class(film_contact), intent(inout) :: self
      integer, intent(out) :: stat
    end subroutine linearisation

    !> Computes the change of the imbalance by a small change of the oil's pressure and of the film, of rough surfaces the gap
    !> between their mean planes.
    subroutine derivative(self, dp, dh, change)
      import :: film_contact, wp
      implicit none(type, external)
      class(film_contact), intent(inout) :: self
      real(wp), contiguous, intent(in) :: dp(:, :), dh(:, :)
      real(wp), contiguous, intent(out) :: change(:, :)
    end subroutine derivative

    !> Computes what the weights r of the imbalance count by the oil's pressure and by the film, of rough surfaces the gap between
    !> mean planes: the transpose of `derivative`.
    subroutine transposed_derivative(self, r, by_p, by_h)
      import :: film_contact, wp
      implicit none(type, external)
      class(film_contact), intent(inout) :: self
      real(wp), contiguous, intent(in) :: r(:, :)
      real(wp), contiguous, intent(out) :: by_p(:, :), by_h(:, :)
    end subroutine transposed_derivative

    !> Solves approximately for the change of pressure by a change r of the imbalance, at a given rigid film; `relax_adjoint`
    !> solves the transposed model.
    subroutine solve(self, r, dp)
      import :: film_contact, wp
      implicit none(type, external)
      class(film_contact), intent(inout) :: self
      real(wp), contiguous, target, intent(in) :: r(:, :)
      real(wp), contiguous, target, intent(out) :: dp(:, :)
    end subroutine solve

    !> Sums |um . grad g| and the transient term of the gap g over the inner nodes [m/s].
    pure real(wp) function wedge_flow(self)
      import :: film_contact, wp
      implicit none(type, external)
      class(film_contact), intent(in) :: self
    end function wedge_flow

    !> Sets d(rho h)/dt = `implicit_rate` [1/s] rho h + `explicit_rate` [m/s].
    subroutine transient_setter(self, implicit_rate, explicit_rate)
      import :: film_contact, wp
      implicit none(type, external)
      class(film_contact), intent(inout) :: self
      real(wp), intent(in) :: implicit_rate, explicit_rate(:, :)
    end subroutine transient_setter

    !> Limits the oil that enters to a layer of thickness `supply` [m].
    subroutine feeder(self, supply, stat)
      import :: film_contact, wp
      implicit none(type, external)
      class(film_contact), intent(inout) :: self
      real(wp), contiguous, intent(in) :: supply(:, :)
      integer, intent(out) :: stat
    end subroutine feeder
  end interface

contains

  !> Checks the conditions of a contact, and the nodal speed of entrainment [m/s].
  pure integer function film_status(conditions, speed)
    type(contact_conditions), intent(in) :: conditions
    real(wp), intent(in) :: speed(:, :)

    film_status = status_bad_argument
    if (.not. (conditions%load > 0 .and. conditions%floor > 0 .and. conditions%oil%eta0 > 0)) return
    film_status = status_not_finite
    if (.not. (conditions%load <= huge(1.0_wp) .and. all(abs(conditions%gap) <= huge(1.0_wp)))) return
    if (all(speed <= huge(1.0_wp))) film_status = status_ok
  end function film_status

  !> Makes the base of a contact, whose GMRES is restarted after `cycle_length` iterations. The caller removes
  !> the outline from what is covered.
  subroutine new_film_contact(self, conditions, cycle_length, stat)
    class(film_contact), intent(inout) :: self
    type(contact_conditions), intent(in) :: conditions
    integer, intent(in) :: cycle_length
    integer, intent(out) :: stat
    integer :: nx, ny, err

    nx = size(conditions%gap, 1)
    ny = size(conditions%gap, 2)
    self%spacing = conditions%spacing
    self%oil = conditions%oil
    self%gap = conditions%gap
    self%covered = conditions%covered
    self%load = conditions%load
    self%floor = conditions%floor
    call new_film_fields(nx, ny, self%model%fields, stat)
    if (stat /= status_ok) return
    allocate (self%free(nx, ny), self%imbalance(nx, ny), self%softness(nx, ny), self%dh(nx, ny), &
      self%right(nx*ny + 1), self%change(nx*ny + 1), self%basis(nx*ny + 1, cycle_length), stat=err)
    if (err /= 0) stat = status_no_memory
  end subroutine new_film_contact

  !> First row of nodes that are not on the outline; a line contact has one row.
  pure integer function first_row(self)
    class(film_contact), intent(in) :: self

    first_row = min(2, size(self%gap, 2))
  end function first_row

  !> Last row of nodes that are not on the outline.
  pure integer function last_row(self)
    class(film_contact), intent(in) :: self

    last_row = max(size(self%gap, 2) - 1, 1)
  end function last_row

  !> Sets the summed wedge flow and the scale of the load's row.
  subroutine weigh_load(self)
    class(film_contact), intent(inout) :: self

    self%wedge = self%wedge_flow()
    self%load_weight = self%wedge/self%load/sqrt(real(size(self%gap), wp))
  end subroutine weigh_load

  !> Sets the transient term d(rho h)/dt = `implicit_rate` [1/s] rho h + `explicit_rate` [m/s], after checks.
  subroutine set_transient_term(self, implicit_rate, explicit_rate, stat)
    class(film_contact), intent(inout) :: self
    real(wp), intent(in) :: implicit_rate, explicit_rate(:, :)
    integer, intent(out) :: stat

    stat = status_bad_argument
    if (any(shape(explicit_rate) /= shape(self%gap))) return
    stat = status_not_finite
    if (.not. (abs(implicit_rate) <= huge(1.0_wp) .and. all(abs(explicit_rate) <= huge(1.0_wp)))) return
    stat = status_ok
    call self%set_transient(implicit_rate, explicit_rate)
    call weigh_load(self)
  end subroutine set_transient_term

  !> Sets the flow law of the oil and `levels` levels across the film, all at the inlet temperature.
  !>
  !> `sliding` is the nodal velocity of body 2 relative to body 1 [m/s].
  subroutine shear_contact(self, law, levels, sliding_x, sliding_y, stat)
    class(film_contact), intent(inout) :: self
    type(flow_law), intent(in) :: law
    integer, intent(in) :: levels
    real(wp), intent(in) :: sliding_x(:, :), sliding_y(:, :)
    integer, intent(out) :: stat

    stat = status_not_finite
    if (.not. all(abs(sliding_x) + abs(sliding_y) <= huge(1.0_wp))) return
    call self%model%add_shear(law, levels, sliding_x, sliding_y, stat)
  end subroutine shear_contact

  !> Makes the surfaces of a contact with a flow law rough.
  subroutine roughen_contact(self, curves, boundary_friction, stat)
    class(film_contact), intent(inout) :: self
    type(gap_curves), intent(in) :: curves
    real(wp), intent(in) :: boundary_friction
    integer, intent(out) :: stat

    stat = status_bad_argument
    if (.not. self%model%is_sheared()) return
    call self%model%add_roughness(curves, boundary_friction, stat)
  end subroutine roughen_contact

  !> Evaluates film and imbalance at pressure p [Pa] and rigid film h0 [m].
  !>
  !> `residual` is the summed residual of complementarity over the summed wedge flow; `load_error` is the missing
  !> load over the load.
  subroutine film_residual(self, p, h0, residual, load_error)
    class(film_contact), intent(inout) :: self
    real(wp), contiguous, intent(in) :: p(:, :)
    real(wp), intent(in) :: h0
    real(wp), intent(out) :: residual, load_error

    call set_film(self, p, h0)
    call begin_iteration(self, residual, load_error)
  end subroutine film_residual

  !> As `film_residual` at the pressure and film of another contact with the same nodes, gap and moduli, whose rigid film is h0;
  !> the flow of smooth surfaces is not linearised.
  subroutine film_residual_at(self, other, h0, residual, load_error)
    class(film_contact), intent(inout) :: self
    class(film_contact), intent(in) :: other
    real(wp), intent(in) :: h0
    real(wp), intent(out) :: residual, load_error

    if (self%model%is_rough()) then
      ! its own asperities share the total pressure and widen the gap
      call set_film(self, other%model%fields%rough%total, h0)
    else
      self%model%fields%p = other%model%fields%p
      self%model%fields%h = other%model%fields%h
    end if
    if (self%model%is_sheared()) self%model%shear%work%flow_alone = .true.
    call begin_iteration(self, residual, load_error)
    if (self%model%is_sheared()) self%model%shear%work%flow_alone = .false.
  end subroutine film_residual_at

  !> Begins an iteration anew from the flow last set, whose net outflow may have changed since; arguments as of `film_residual`.
  !>
  !> Unlike at the start of an iteration the oil's pressure between rough surfaces follows from their balance already, and the
  !> rupture line may move in the next step.
  subroutine film_balance_again(self, residual, load_error)
    class(film_contact), intent(inout) :: self
    real(wp), intent(out) :: residual, load_error

    call judge_balance(self, residual, load_error)
    self%least = residual + abs(load_error)
    self%idle_steps = 0
  end subroutine film_balance_again

  !> Evaluates the balance of a film that an iteration starts from; arguments as of `film_residual`.
  subroutine begin_iteration(self, residual, load_error)
    class(film_contact), intent(inout) :: self
    real(wp), intent(out) :: residual, load_error

    call evaluate_flow(self)
    call film_balance_again(self, residual, load_error)
    if (self%model%is_rough()) self%free = self%covered .and. .not. self%model%fields%rough%ruptured
  end subroutine begin_iteration

  !> Sets where the oil has ruptured between rough surfaces, before `film_residual`: a rupture line that starts at the wrong
  !> place moves by a node a step, and the oil's small part of a pressure that asperities bear does not show it.
  subroutine set_ruptured(self, ruptured)
    class(film_contact), intent(inout) :: self
    logical, intent(in) :: ruptured(:, :)

    if (self%model%is_rough()) self%model%fields%rough%ruptured = self%covered .and. ruptured
  end subroutine set_ruptured

  !> Sets the film at pressure p [Pa] and rigid film h0 [m]; `film_balance` evaluates its flow.
  subroutine set_film(self, p, h0)
    class(film_contact), intent(inout) :: self
    real(wp), contiguous, intent(in) :: p(:, :)
    real(wp), intent(in) :: h0
    integer :: j

    call self%work%convolution%start()
    call self%deflection(p, self%model%fields%h)
    call self%work%convolution%finish()
    !$omp parallel do schedule(static)
    do j = 1, size(p, 2)
      self%model%fields%p(:, j) = p(:, j)
      self%model%fields%h(:, j) = self%model%fields%h(:, j) + self%gap(:, j) + h0
    end do
    call self%model%share_pressure(self%covered)
  end subroutine set_film

  !> Evaluates flow and imbalance at the present pressure and film; arguments as of `film_residual`.
  subroutine film_balance(self, residual, load_error)
    class(film_contact), intent(inout) :: self
    real(wp), intent(out) :: residual, load_error

    call evaluate_flow(self)
    call judge_balance(self, residual, load_error)
  end subroutine film_balance

  !> Evaluates oil, flow and imbalance at the present pressure and film, and counts that work.
  subroutine evaluate_flow(self)
    class(film_contact), intent(inout) :: self

    call self%work%flow%start()
    call self%set_flow()
    call self%work%flow%finish()
  end subroutine evaluate_flow

  !> Sets where pressure is free, and the residuals, by the net outflow of the present film; arguments as of `film_residual`.
  subroutine judge_balance(self, residual, load_error)
    class(film_contact), intent(inout) :: self
    real(wp), intent(out) :: residual, load_error
    integer :: j

    associate (p => self%model%fields%p)
      !$omp parallel do schedule(static)
      do j = 1, size(p, 2)
        ! p > 0 or r < 0: the active set that makes Newton's method for p r = 0 semismooth (Hintermueller, Ito and Kunisch,
        ! SIAM J. Optim. 13 (2002) 865)
        self%free(:, j) = self%covered(:, j) .and. (p(:, j) > 0 .or. self%imbalance(:, j) < 0)
        self%dh(:, j) = merge(abs(self%imbalance(:, j)), 0.0_wp, self%free(:, j))
      end do
      residual = total(self%dh)/self%wedge
      ! a film whose stress did not converge must not count as solved
      residual = residual + self%model%unsolved()
    end associate
    load_error = 1 - self%model%summed_pressure()*self%spacing(1)*self%spacing(2)/self%load
    if (self%model%is_rough()) then
      self%dh = abs(self%model%fields%rough%excess)
      residual = residual + total(self%dh)*self%spacing(1)*self%spacing(2)/self%load
    end if
    if (self%rigid_film_fixed) load_error = 0
  end subroutine judge_balance

  !> Makes one Newton step from (p, h0), at which `film_residual` was last evaluated; both are replaced.
  !>
  !> The linear system is solved to `forcing` times its right-hand side.
  subroutine film_step(self, forcing, p, h0, residual, load_error, step, stat)
    class(film_contact), intent(inout) :: self
    real(wp), intent(in) :: forcing
    real(wp), contiguous, intent(inout) :: p(:, :)
    real(wp), intent(inout) :: h0
    real(wp), intent(inout) :: residual, load_error
    type(newton_step), intent(out) :: step
    integer, intent(out) :: stat

    call film_direction(self, forcing, p, h0, load_error, step%krylov, stat)
    if (stat == status_ok) call search_step(self, residual + abs(load_error), p, h0, residual, load_error, step%damping, stat)
    if (self%counts_idle_steps) call note_progress(self, residual, load_error)
  end subroutine film_step

  !> Notes after a heated step whether it reached a new least residual. Once `max_idle_steps` are made it stays so until no step
  !> lowers the residual (`search_step`), or the film is started again.
  pure subroutine note_progress(self, residual, load_error)
    class(film_contact), intent(inout) :: self
    real(wp), intent(in) :: residual, load_error

    if (self%idle_steps >= max_idle_steps) return
    self%idle_steps = merge(0, self%idle_steps + 1, residual + abs(load_error) < self%least)
    self%least = min(self%least, residual + abs(load_error))
  end subroutine note_progress

  !> Computes the Newton step from (p, h0), which `move_film` applies with a damping factor.
  subroutine film_direction(self, forcing, p, h0, load_error, krylov, stat)
    class(film_contact), intent(inout) :: self
    real(wp), intent(in) :: forcing, h0, load_error
    real(wp), contiguous, intent(in) :: p(:, :)
    integer, intent(out) :: krylov, stat
    real(wp) :: reduction
    integer :: j, k, nx, n

    nx = size(p, 1)
    n = size(p)
    krylov = 0
    call set_system(self, stat)
    if (stat /= status_ok) return
    do j = 1, size(p, 2)
      k = nx*(j - 1)
      self%right(k + 1:k + nx) = merge(-self%imbalance(:, j), 0.0_wp, self%free(:, j))
    end do
    if (self%model%is_rough()) then
      call add_asperity_residual(self, self%right(:n))
      self%model%fields%rough%ruptured = self%covered .and. .not. self%free
    end if
    self%right(n + 1) = load_error*self%load*self%load_weight
    call gmres(self, self%right, forcing, most_cycles*size(self%basis, 2), self%basis, self%change, krylov, reduction)
    if (interrupted()) then
      stat = status_interrupted
      return
    end if
    if (.not. all(abs(self%change) <= huge(1.0_wp))) then
      stat = status_not_finite
      return
    end if

    do j = 1, size(p, 2)
      k = nx*(j - 1)
      self%right(k + 1:k + nx) = p(:, j)
    end do
    self%right(n + 1) = h0
  end subroutine film_direction

  !> Adds to the right-hand side what the asperities' pressure exceeds the total by: the oil there has ambient pressure, from
  !> which the change of its pressure counts.
  subroutine add_asperity_residual(self, right)
    class(film_contact), target, intent(inout) :: self
    real(wp), contiguous, target, intent(inout) :: right(:)
    real(wp), contiguous, pointer :: r(:, :), change(:, :)

    r(1:size(self%gap, 1), 1:size(self%gap, 2)) => right
    change(1:size(self%gap, 1), 1:size(self%gap, 2)) => self%change(:size(right))
    self%dh = 0
    call change_balance(self, self%model%fields%rough%excess, self%dh, change)
    r = r + change
  end subroutine add_asperity_residual

  !> Computes the change of the imbalance, where pressure is free, by a small change of total pressure and of the gap between mean
  !> planes. Elsewhere it is the change of the pressure of the oil [Pa], of smooth surfaces zero.
  subroutine change_balance(self, dp, dh, change)
    class(film_contact), intent(inout) :: self
    real(wp), contiguous, intent(in) :: dp(:, :), dh(:, :)
    real(wp), contiguous, intent(out) :: change(:, :)
    integer :: j

    if (self%model%is_rough()) then
      associate (rough => self%model%fields%rough)
        !$omp parallel do schedule(static)
        do j = 1, size(dp, 2)
          rough%change(:, j) = merge(dp(:, j) + rough%stiffness(:, j)*dh(:, j), 0.0_wp, self%free(:, j))
        end do
        call self%imbalance_change(rough%change, dh, change)
        !$omp parallel do schedule(static)
        do j = 1, size(dp, 2)
          where (.not. self%free(:, j)) change(:, j) = dp(:, j) + rough%stiffness(:, j)*dh(:, j)
        end do
      end associate
    else
      call self%imbalance_change(dp, dh, change)
      !$omp parallel do schedule(static)
      do j = 1, size(dp, 2)
        where (.not. self%free(:, j)) change(:, j) = 0
      end do
    end if
  end subroutine change_balance

  !> Sets pressure, rigid film and film to those after the damped Newton step.
  subroutine move_film(self, damping, p, h0)
    class(film_contact), intent(inout) :: self
    real(wp), intent(in) :: damping
    real(wp), contiguous, intent(inout) :: p(:, :)
    real(wp), intent(out) :: h0
    integer :: j, k, nx, n

    nx = size(p, 1)
    n = size(p)
    do j = 1, size(p, 2)
      k = nx*(j - 1)
      p(:, j) = max(self%right(k + 1:k + nx) + damping*self%change(k + 1:k + nx), 0.0_wp)
    end do
    h0 = self%right(n + 1) + damping*self%change(n + 1)
    call set_film(self, p, h0)
  end subroutine move_film

  !> Whether the residual and load error of a film have not grown too much from `merit`, their sum.
  pure logical function acceptable(self, merit, residual, load_error)
    class(film_contact), intent(in) :: self
    real(wp), intent(in) :: merit, residual, load_error

    acceptable = residual + abs(load_error) <= merge(most_growth, 1.0_wp, self%idle_steps < max_idle_steps)*merit
  end function acceptable

  !> Takes the Newton step with the largest damping factor, by halving, at which the residual does not grow too much;
  !> arguments as of `film_step`.
  subroutine search_step(self, merit, p, h0, residual, load_error, step, stat)
    class(film_contact), intent(inout) :: self
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
      if (acceptable(self, merit, residual, load_error) .or. .not. step > 0) return
      if (interrupted()) then
        stat = status_interrupted
        return
      end if
      step = merge(step/2, 0.0_wp, step > shortest_step)
      if (.not. step > 0 .and. self%idle_steps >= max_idle_steps) then
        ! no step lowers the residual: a rupture line has to move first, and the count begins anew
        self%idle_steps = 0
        step = 1
      end if
    end do
  end subroutine search_step

  !> Builds Jacobian and preconditioner, with its border, at the film last evaluated.
  subroutine set_system(self, stat)
    class(film_contact), intent(inout) :: self
    integer, intent(out) :: stat

    call self%work%building%start()
    call self%linearise(stat)
    call self%work%building%finish()
    if (stat == status_ok) call set_softness(self)
  end subroutine set_system

  !> Computes the response of the preconditioner to a unit rise of the rigid film.
  subroutine set_softness(self)
    class(film_contact), target, intent(inout) :: self
    real(wp), contiguous, pointer :: start(:, :)

    ! softness, change and dh are free at this point of a step
    self%softness = 0
    self%dh = 1
    start(1:size(self%dh, 1), 1:size(self%dh, 2)) => self%change(:size(self%dh))
    call change_balance(self, self%softness, self%dh, start)
    call self%work%cycle%start()
    call self%relax(start, self%softness)
    call self%work%cycle%finish()
    self%softness_load = total(self%softness)
  end subroutine set_softness

  !> Multiplies by the Jacobian: (change of pressure, of h0) to (change of imbalance, of load).
  subroutine multiply(self, x, y)
    class(film_contact), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    real(wp), contiguous, pointer :: dp(:, :), dr(:, :)
    integer :: j, n

    n = size(self%gap)
    dp(1:size(self%gap, 1), 1:size(self%gap, 2)) => x(:n)
    dr(1:size(self%gap, 1), 1:size(self%gap, 2)) => y(:n)
    call self%work%convolution%start()
    call self%deflection(dp, self%dh)
    call self%work%convolution%finish()
    call self%work%flow%start()
    !$omp parallel do schedule(static)
    do j = 1, size(dp, 2)
      self%dh(:, j) = self%dh(:, j) + x(n + 1)
    end do
    call change_balance(self, dp, self%dh, dr)
    call self%work%flow%finish()
    y(n + 1) = total(dp)*self%spacing(1)*self%spacing(2)*self%load_weight
    if (self%rigid_film_fixed) y(n + 1) = x(n + 1)
  end subroutine multiply

  !> Solves the bordered system approximately: `relax` for the pressure, with h0 such that the load is met.
  subroutine precondition(self, x, y)
    class(film_contact), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    real(wp), contiguous, pointer :: r(:, :), dp(:, :)
    integer :: j, n

    n = size(self%gap)
    r(1:size(self%gap, 1), 1:size(self%gap, 2)) => x(:n)
    dp(1:size(self%gap, 1), 1:size(self%gap, 2)) => y(:n)
    call self%work%cycle%start()
    call self%relax(r, dp)
    call self%work%cycle%finish()
    ! the border by its Schur complement: the pressure less what the rise of the rigid film takes has the load asked for
    y(n + 1) = (total(dp) - x(n + 1)/(self%spacing(1)*self%spacing(2)*self%load_weight))/self%softness_load
    if (self%rigid_film_fixed) y(n + 1) = x(n + 1)
    !$omp parallel do schedule(static)
    do j = 1, size(dp, 2)
      dp(:, j) = dp(:, j) - self%softness(:, j)*y(n + 1)
    end do
  end subroutine precondition

end module pyworm_film_newton
