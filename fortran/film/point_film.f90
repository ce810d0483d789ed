!> The film of a point contact: deflection of half-spaces, flow in two directions, a multigrid cycle before GMRES.
module pyworm_point_film
  use pyworm_film_newton, only: contact_conditions, film_contact, film_status, new_film_contact, evaluate_flow, &
    set_transient_term, weigh_load, change_balance
  use pyworm_half_space, only: elastic_half_space, new_half_space
  use pyworm_kinds, only: pp, wp
  use pyworm_partial_film, only: fill_gap, carry_change
  use pyworm_multigrid, only: film_multigrid, new_film_multigrid, set_entrainment, set_film_multigrid, film_cycle
  use pyworm_reynolds_adjoint, only: flow_imbalance_adjoint, sheared_imbalance_adjoint
  use pyworm_reynolds, only: film_grid, set_film_fields, set_mass_change, flow_imbalance, flow_imbalance_change
  use pyworm_sheared_reynolds, only: set_sheared_fields, still_ambient_faces, sheared_imbalance, sheared_imbalance_change
  use pyworm_status, only: status_ok, status_bad_argument, status_not_finite
  use pyworm_transported_film, only: film_transport, new_film_transport, set_film_transport, transported_pressure
  implicit none(type, external)
  private

  public :: point_contact, new_point_contact, entrain, limit_rate, transport, set_fluidity

  !> Krylov iterations after which GMRES is restarted.
  integer, parameter :: cycle_length = 16
  !> Weights of the wedge's flow of third order (see `partial_film`).
  real(wp), parameter :: third_order(3) = [-1, 5, 2]/6.0_wp

  type, extends(film_contact) :: point_contact
    type(film_grid) :: grid
    !> The grid without entrainment: of a gap that is filled in part the wedge is added apart. Allocatable, lest gfortran
    !> (12.2) release only `grid` (tests/python/test_fortran_types.py).
    type(film_grid), allocatable :: still
    type(elastic_half_space) :: space
    type(film_multigrid) :: cycles
    !> Cycle of the transposed model; made when it is first asked for.
    type(film_multigrid), allocatable :: adjoint_cycles
    !> Solve before the cycle where time steps follow the oil; made by `transport`.
    type(film_transport), allocatable :: transport
  contains
    procedure :: deflection
    procedure :: set_flow
    procedure :: linearise
    procedure :: imbalance_change
    procedure :: relax
    procedure :: wedge_flow
    procedure :: set_transient
    procedure :: feed
    procedure :: linearise_adjoint
    procedure :: imbalance_adjoint
    procedure :: relax_adjoint
  end type point_contact

contains

  !> Makes a steady point contact; `u`, `v` are nodal entrainment [m/s].
  subroutine new_point_contact(self, conditions, u, v, stat)
    type(point_contact), intent(inout) :: self
    type(contact_conditions), intent(in) :: conditions
    real(wp), intent(in) :: u(:, :), v(:, :)
    integer, intent(out) :: stat
    integer :: nx, ny

    nx = size(conditions%gap, 1)
    ny = size(conditions%gap, 2)
    associate (dx => conditions%spacing(1), dy => conditions%spacing(2))
      stat = film_status(conditions, abs(u) + abs(v))
      if (stat == status_ok) call new_half_space(self%space, nx, ny, dx, dy, conditions%reduced_modulus, stat, &
        conditions%layers)
      if (stat == status_ok) call new_film_contact(self, conditions, cycle_length, stat)
      if (stat /= status_ok) return
      self%grid = film_grid(nx, ny, dx, dy, face_mean_x(u), face_mean_y(v))
    end associate

    self%covered([1, nx], :) = .false.
    self%covered(:, [1, ny]) = .false.
    allocate (self%grid%explicit_rate(nx, ny), source=0.0_wp)
    call weigh_load(self)
    call new_film_multigrid(self%grid, self%space%centre*self%space%centre_ratio, self%cycles, stat)
  end subroutine new_point_contact

  !> Sets the nodal entrainment of a point contact to (u, v) [m/s]. The reference of residuals remains the first wedge
  !> flow.
  subroutine entrain(film, u, v)
    class(film_contact), intent(inout) :: film
    real(wp), intent(in) :: u(:, :), v(:, :)

    select type (film)
    type is (point_contact)
      film%grid%u = face_mean_x(u)
      film%grid%v = face_mean_y(v)
      call set_entrainment(film%cycles, film%grid)
      if (film%model%is_partial()) then
        film%model%partial%rate_x = reshape(film%grid%u/film%grid%dx, [size(u)])
        film%model%partial%rate_y = reshape(film%grid%v/film%grid%dy, [size(v)])
      end if
    end select
  end subroutine entrain

  !> Replaces the explicit part of the transient term [m/s] of a film that was evaluated; its net outflow follows by the change.
  subroutine limit_rate(film, explicit_rate, stat)
    class(film_contact), intent(inout) :: film
    real(wp), intent(in) :: explicit_rate(:, :)
    integer, intent(out) :: stat
    real(wp) :: implicit_rate

    stat = status_bad_argument
    select type (film)
    type is (point_contact)
      film%dh = film%grid%explicit_rate
      implicit_rate = film%grid%implicit_rate
      call set_transient_term(film, implicit_rate, explicit_rate, stat)
      if (stat /= status_ok) return
      if (film%model%is_partial()) then
        ! what fills the gap depends on the rate from node to node
        call evaluate_flow(film)
        return
      end if
      associate (nx => film%grid%nx, ny => film%grid%ny)
        film%imbalance(2:nx - 1, 2:ny - 1) = film%imbalance(2:nx - 1, 2:ny - 1) &
          + (explicit_rate(2:nx - 1, 2:ny - 1) - film%dh(2:nx - 1, 2:ny - 1))
      end associate
    end select
  end subroutine limit_rate

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

  !> Computes the elastic deflection w [m] under pressure p [Pa].
  subroutine deflection(self, p, w)
    class(point_contact), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: p(:, :)
    real(wp), contiguous, target, intent(out) :: w(:, :)

    call self%space%deflection(p, w)
  end subroutine deflection

  !> Evaluates oil, flow and imbalance at the pressure and film of the fields.
  subroutine set_flow(self)
    class(point_contact), intent(inout) :: self

    if (.not. self%model%is_partial()) then
      call set_flow_on(self%grid)
      return
    end if
    call set_flow_on(self%still)
    self%model%partial%mass = self%model%fields%rho*self%model%fields%h
    call fill_gap(self%model%partial, self%covered, self%model%fields%p, self%grid%implicit_rate, self%imbalance)

  contains

    subroutine set_flow_on(grid)
      type(film_grid), intent(in) :: grid

      if (self%model%is_sheared()) then
        call set_sheared_fields(grid, self%oil, self%floor, self%model%shear, self%model%fields)
        if (self%model%is_partial()) call still_ambient_faces(self%model%fields%p, self%model%shear)
        call sheared_imbalance(grid, self%model%shear, self%model%fields, self%imbalance)
      else
        call set_film_fields(self%oil, self%floor, self%model%fields)
        call flow_imbalance(grid, self%model%fields, self%imbalance)
      end if
    end subroutine set_flow_on

  end subroutine set_flow

  !> Builds the preconditioner at the fields last set; the Jacobian is applied without a matrix.
  subroutine linearise(self, stat)
    class(point_contact), intent(inout) :: self
    integer, intent(out) :: stat

    call set_film_multigrid(self%cycles, self%model, self%free, stat)
    if (allocated(self%transport)) call set_film_transport(self%transport, self%model%fields, self%free, &
      self%grid%implicit_rate, self%grid%dx)
  end subroutine linearise

  !> Computes the change of the imbalance by a small change of pressure and film.
  subroutine imbalance_change(self, dp, dh, change)
    class(point_contact), intent(inout) :: self
    real(wp), contiguous, intent(in) :: dp(:, :), dh(:, :)
    real(wp), contiguous, intent(out) :: change(:, :)

    if (.not. self%model%is_partial()) then
      call change_on(self%grid)
      return
    end if
    call change_on(self%still)
    call set_mass_change(self%model%fields, dp, dh, self%model%partial%mass_change)
    call carry_change(self%model%partial, self%grid%implicit_rate, change)

  contains

    subroutine change_on(grid)
      type(film_grid), intent(in) :: grid

      if (self%model%is_sheared()) then
        call sheared_imbalance_change(grid, self%model%shear, self%model%fields, dp, dh, change)
      else
        call flow_imbalance_change(grid, self%model%fields, dp, dh, change)
      end if
    end subroutine change_on

  end subroutine imbalance_change

  !> Builds the preconditioner of the transposed system at the fields last set.
  subroutine linearise_adjoint(self, stat)
    class(point_contact), intent(inout) :: self
    integer, intent(out) :: stat

    stat = status_ok
    if (.not. allocated(self%adjoint_cycles)) then
      allocate (self%adjoint_cycles)
      call new_film_multigrid(self%grid, self%space%centre*self%space%centre_ratio, self%adjoint_cycles, stat)
      self%adjoint_cycles%adjoint = .true.
      self%adjoint_cycles%rising = .not. self%cycles%rising
    end if
    if (stat == status_ok) call set_film_multigrid(self%adjoint_cycles, self%model, self%free, stat)
  end subroutine linearise_adjoint

  !> Computes what the weights r of the imbalance count by the oil's pressure and by the film.
  subroutine imbalance_adjoint(self, r, by_p, by_h)
    class(point_contact), intent(inout) :: self
    real(wp), contiguous, intent(in) :: r(:, :)
    real(wp), contiguous, intent(out) :: by_p(:, :), by_h(:, :)

    if (self%model%is_sheared()) then
      call sheared_imbalance_adjoint(self%grid, self%model%shear, self%model%fields, r, by_p, by_h)
    else
      call flow_imbalance_adjoint(self%grid, self%model%fields, r, by_p, by_h)
    end if
  end subroutine imbalance_adjoint

  !> Makes a multigrid cycle of the transposed model.
  subroutine relax_adjoint(self, r, dp)
    class(point_contact), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: r(:, :)
    real(wp), contiguous, target, intent(out) :: dp(:, :)

    call film_cycle(self%adjoint_cycles, r, dp)
    if (self%model%is_rough()) call bear_ruptured(self, r, dp)
  end subroutine relax_adjoint

  !> Sets the pressure where the oil has ruptured and asperities bear: theirs, and the deflection under a node.
  subroutine bear_ruptured(self, r, dp)
    class(point_contact), intent(in) :: self
    real(wp), intent(in) :: r(:, :)
    real(wp), intent(inout) :: dp(:, :)

    where (.not. self%free) dp = r/(1 + self%cycles%level(1)%compliance*self%model%fields%rough%stiffness)
  end subroutine bear_ruptured

  !> Makes a multigrid cycle for the pressure.
  subroutine relax(self, r, dp)
    class(point_contact), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: r(:, :)
    real(wp), contiguous, target, intent(out) :: dp(:, :)

    if (allocated(self%transport)) then
      call relax_transported(self, r, dp)
      return
    end if
    call film_cycle(self%cycles, r, dp)
    if (self%model%is_rough()) call bear_ruptured(self, r, dp)
  end subroutine relax

  !> Solves approximately for the pressure of a film whose time steps follow the oil: by deflection alone, then by a multigrid
  !> cycle for what is left.
  subroutine relax_transported(self, r, dp)
    class(point_contact), intent(inout) :: self
    real(wp), contiguous, intent(in) :: r(:, :)
    real(wp), contiguous, intent(out) :: dp(:, :)

    associate (t => self%transport)
      call transported_pressure(t, r)
      call self%deflection(t%p, self%dh)
      call change_balance(self, t%p, self%dh, t%rest)
      t%rest = r - t%rest
      call film_cycle(self%cycles, t%rest, dp)
      dp = dp + t%p
    end associate
  end subroutine relax_transported

  !> Prepares a contact of smooth surfaces for time steps along the path of the oil: its entrainment becomes zero, and
  !> `set_transient` gives the mass that arrives.
  subroutine transport(film, stat)
    class(film_contact), intent(inout) :: film
    integer, intent(out) :: stat

    stat = status_bad_argument
    select type (film)
    type is (point_contact)
      if (film%model%is_rough() .or. film%model%is_partial() .or. film%model%is_sheared()) return
      film%grid%u = 0
      film%grid%v = 0
      call set_entrainment(film%cycles, film%grid)
      film%counts_idle_steps = .true.
      allocate (film%transport)
      call new_film_transport(film%transport, film%grid%nx, film%grid%ny, film%spacing, film%space%reduced_modulus, stat)
    end select
  end subroutine transport

  !> Sets the mobility over that of the oil at its inlet's temperature and at rest, at the nodes, and the slopes of its
  !> logarithm by pressure [1/Pa] and film [1/m].
  subroutine set_fluidity(film, fluidity, by_p, by_h, stat)
    class(film_contact), intent(inout) :: film
    real(wp), intent(in) :: fluidity(:, :), by_p(:, :), by_h(:, :)
    integer, intent(out) :: stat

    stat = status_bad_argument
    if (any(shape(fluidity) /= shape(film%gap)) .or. film%model%is_sheared()) return
    stat = status_not_finite
    if (.not. all(fluidity > 0 .and. fluidity <= huge(1.0_wp) .and. abs(by_p) + abs(by_h) <= huge(1.0_wp))) return
    stat = status_ok
    film%model%fields%fluidity = fluidity
    film%model%fields%fluidity_p = by_p
    film%model%fields%fluidity_h = by_h
  end subroutine set_fluidity

  !> Sums |um . grad g| and the transient term of the gap g over the inner nodes [m/s].
  pure real(wp) function wedge_flow(self)
    class(point_contact), intent(in) :: self
    integer :: i, j

    wedge_flow = 0
    associate (grid => self%grid, gap => self%gap)
      do j = 2, grid%ny - 1
        do i = 2, grid%nx - 1
          wedge_flow = wedge_flow + abs(grid%u(i, j)*(gap(i + 1, j) - gap(i - 1, j))/(2*grid%dx) &
            + grid%v(i, j)*(gap(i, j + 1) - gap(i, j - 1))/(2*grid%dy)) &
            + abs(grid%implicit_rate*gap(i, j) + grid%explicit_rate(i, j))
        end do
      end do
    end associate
  end function wedge_flow

  !> Sets d(rho h)/dt = `implicit_rate` [1/s] rho h + `explicit_rate` [m/s].
  subroutine set_transient(self, implicit_rate, explicit_rate)
    class(point_contact), intent(inout) :: self
    real(wp), intent(in) :: implicit_rate, explicit_rate(:, :)

    self%grid%implicit_rate = implicit_rate
    self%grid%explicit_rate = explicit_rate
    if (self%model%is_partial()) self%still%explicit_rate = explicit_rate
    self%cycles%implicit_rate = real(implicit_rate, pp)
  end subroutine set_transient

  !> Limits the oil that enters to a layer of thickness `supply` [m].
  subroutine feed(self, supply, stat)
    class(point_contact), intent(inout) :: self
    real(wp), contiguous, intent(in) :: supply(:, :)
    integer, intent(out) :: stat

    self%still = self%grid
    self%still%u = 0
    self%still%v = 0
    self%still%implicit_rate = 0
    call self%model%limit_supply(supply, third_order, reshape(self%grid%u/self%grid%dx, [size(supply)]), &
      reshape(self%grid%v/self%grid%dy, [size(supply)]), stat)
  end subroutine feed

end module pyworm_point_film
