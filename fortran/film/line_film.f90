!> The film of a line contact: deflection of half-planes, flow in one direction, a band solve before GMRES.
module pyworm_line_film
  use pyworm_band_preconditioner, only: band_model, set_band_model
  use pyworm_film_newton, only: contact_conditions, film_contact, film_status, new_film_contact, weigh_load
  use pyworm_half_plane, only: elastic_half_plane, new_half_plane
  use pyworm_kinds, only: wp
  use pyworm_line_reynolds, only: line_grid, line_flow, new_line_flow, newtonian_flow, line_imbalance, line_bands, &
    band_product, transposed_band_product
  use pyworm_line_shear, only: sheared_flow
  use pyworm_partial_film, only: fill_gap, feed_downstream
  use pyworm_reynolds, only: set_film_fields
  use pyworm_status, only: status_bad_argument, status_ok, status_no_memory
  use pyworm_viscosity_density, only: oil_law
  implicit none(type, external)
  private

  public :: line_contact, new_line_contact, entrain_line

  !> Krylov iterations after which GMRES is restarted.
  integer, parameter :: cycle_length = 60
  !> Weights of the wedge's flow of second order (see `partial_film`).
  real(wp), parameter :: second_order(3) = [-0.5_wp, 1.5_wp, 0.0_wp]

  type, extends(film_contact) :: line_contact
    type(line_grid) :: grid
    !> The grid without entrainment: of a gap that is filled in part the wedge is added apart. Allocatable, lest gfortran
    !> (12.2) release only `grid` (tests/python/test_fortran_types.py).
    type(line_grid), allocatable :: still
    type(elastic_half_plane) :: plane
    type(line_flow) :: flow
    type(band_model) :: bands
    !> Derivatives of the imbalance by pressure and film at the nodes -2 to 2 further on.
    real(wp), allocatable :: by_pressure(:, :), by_film(:, :)
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
  end type line_contact

contains

  !> Makes a steady line contact on a grid of n points; `u` is nodal entrainment [m/s].
  subroutine new_line_contact(self, gap, covered, u, dx, reduced_modulus, oil, load, floor, stat)
    type(line_contact), intent(inout) :: self
    real(wp), intent(in) :: gap(:), u(:)
    logical, intent(in) :: covered(:)
    real(wp), intent(in) :: dx, reduced_modulus, load, floor
    type(oil_law), intent(in) :: oil
    integer, intent(out) :: stat
    type(contact_conditions) :: conditions
    integer :: n, err

    n = size(gap)
    conditions = contact_conditions(reshape(gap, [n, 1]), reshape(covered, [n, 1]), [dx, 1.0_wp], reduced_modulus, oil, load, &
      floor)
    stat = film_status(conditions, reshape(abs(u), [n, 1]))
    if (stat == status_ok) call new_half_plane(self%plane, n, dx, reduced_modulus, stat)
    if (stat == status_ok) call new_film_contact(self, conditions, cycle_length, stat)
    if (stat /= status_ok) return

    self%covered([1, n], 1) = .false.
    self%grid = line_grid(n, dx, (u(:n - 1) + u(2:))/2)
    allocate (self%grid%explicit_rate(n), source=0.0_wp)
    call weigh_load(self)
    call new_line_flow(n, self%flow, stat)
    if (stat /= status_ok) return
    allocate (self%by_pressure(n, -2:2), self%by_film(n, -2:2), stat=err)
    if (err /= 0) stat = status_no_memory
  end subroutine new_line_contact

  !> Sets the nodal entrainment of a line contact whose gap is full to u [m/s]. The reference of residuals remains the first wedge
  !> flow.
  subroutine entrain_line(film, u)
    class(film_contact), intent(inout) :: film
    real(wp), intent(in) :: u(:)

    select type (film)
    type is (line_contact)
      film%grid%u = (u(:size(u) - 1) + u(2:))/2
    end select
  end subroutine entrain_line

  !> Computes the elastic deflection w [m] under pressure p [Pa].
  subroutine deflection(self, p, w)
    class(line_contact), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: p(:, :)
    real(wp), contiguous, target, intent(out) :: w(:, :)

    call self%plane%deflection(p(:, 1), w(:, 1))
  end subroutine deflection

  !> Evaluates oil, flow and imbalance at the pressure and film of the fields.
  subroutine set_flow(self)
    class(line_contact), intent(inout) :: self

    if (self%model%is_sheared()) then
      call sheared_flow(self%grid, self%oil, self%floor, self%model%shear, self%model%fields, self%flow, self%model%is_partial())
    else
      call set_film_fields(self%oil, self%floor, self%model%fields)
      call newtonian_flow(self%grid, self%model%fields, self%flow)
    end if
    if (.not. self%model%is_partial()) then
      call line_imbalance(self%grid, self%model%fields, self%flow, self%imbalance(:, 1))
      return
    end if
    call line_imbalance(self%still, self%model%fields, self%flow, self%imbalance(:, 1))
    self%model%partial%mass = self%model%fields%rho*self%model%fields%h
    call fill_gap(self%model%partial, self%covered, self%model%fields%p, self%grid%implicit_rate, self%imbalance)
  end subroutine set_flow

  !> Builds the bands of the Jacobian and its preconditioner at the flow last set.
  subroutine linearise(self, stat)
    class(line_contact), intent(inout) :: self
    integer, intent(out) :: stat

    call line_bands(self%grid, self%model%fields, self%flow, self%by_pressure, self%by_film, self%model%partial)
    if (self%model%is_rough()) then
      call set_band_model(self%bands, self%by_pressure, self%by_film, self%plane%influence, self%free(:, 1), stat, &
        self%model%fields%rough%stiffness(:, 1))
    else
      call set_band_model(self%bands, self%by_pressure, self%by_film, self%plane%influence, self%free(:, 1), stat)
    end if
  end subroutine linearise

  !> Computes the change of the imbalance by a small change of pressure and film.
  subroutine imbalance_change(self, dp, dh, change)
    class(line_contact), intent(inout) :: self
    real(wp), contiguous, intent(in) :: dp(:, :), dh(:, :)
    real(wp), contiguous, intent(out) :: change(:, :)

    change(:, 1) = band_product(self%by_pressure, dp(:, 1)) + band_product(self%by_film, dh(:, 1))
    if (self%model%is_partial()) call feed_downstream(self%model%partial, self%grid%implicit_rate, change)
  end subroutine imbalance_change

  !> Solves the band model for the pressure.
  subroutine relax(self, r, dp)
    class(line_contact), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: r(:, :)
    real(wp), contiguous, target, intent(out) :: dp(:, :)

    dp(:, 1) = r(:, 1)
    if (.not. self%model%is_rough()) dp(:, 1) = merge(r(:, 1), 0.0_wp, self%free(:, 1))
    call self%bands%solve(dp(:, 1))
  end subroutine relax

  !> The preconditioner of the transposed system is that of the system, factored once (`linearise`).
  subroutine linearise_adjoint(self, stat)
    class(line_contact), intent(inout) :: self
    integer, intent(out) :: stat

    stat = merge(status_ok, status_bad_argument, allocated(self%bands%factors))
  end subroutine linearise_adjoint

  !> Computes what the weights r of the imbalance count by the oil's pressure and by the film.
  subroutine imbalance_adjoint(self, r, by_p, by_h)
    class(line_contact), intent(inout) :: self
    real(wp), contiguous, intent(in) :: r(:, :)
    real(wp), contiguous, intent(out) :: by_p(:, :), by_h(:, :)

    by_p(:, 1) = transposed_band_product(self%by_pressure, r(:, 1))
    by_h(:, 1) = transposed_band_product(self%by_film, r(:, 1))
  end subroutine imbalance_adjoint

  !> Solves the transposed band model.
  subroutine relax_adjoint(self, r, dp)
    class(line_contact), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: r(:, :)
    real(wp), contiguous, target, intent(out) :: dp(:, :)

    dp(:, 1) = r(:, 1)
    call self%bands%solve_transposed(dp(:, 1))
    if (.not. self%model%is_rough()) dp(:, 1) = merge(dp(:, 1), 0.0_wp, self%free(:, 1))
  end subroutine relax_adjoint

  !> Sums |um dg/dx| and the transient term of the gap g over the inner nodes [m/s].
  pure real(wp) function wedge_flow(self)
    class(line_contact), intent(in) :: self
    integer :: n

    n = self%grid%n
    wedge_flow = sum(abs(self%grid%u(2:)*(self%gap(3:, 1) - self%gap(:n - 2, 1))/(2*self%grid%dx)) &
      + abs(self%grid%implicit_rate*self%gap(2:n - 1, 1) + self%grid%explicit_rate(2:n - 1)))
  end function wedge_flow

  !> Sets d(rho h)/dt = `implicit_rate` [1/s] rho h + `explicit_rate` [m/s].
  subroutine set_transient(self, implicit_rate, explicit_rate)
    class(line_contact), intent(inout) :: self
    real(wp), intent(in) :: implicit_rate, explicit_rate(:, :)

    self%grid%implicit_rate = implicit_rate
    self%grid%explicit_rate = explicit_rate(:, 1)
    if (self%model%is_partial()) self%still%explicit_rate = explicit_rate(:, 1)
  end subroutine set_transient

  !> Limits the oil that enters to a layer of thickness `supply` [m].
  subroutine feed(self, supply, stat)
    class(line_contact), intent(inout) :: self
    real(wp), contiguous, intent(in) :: supply(:, :)
    integer, intent(out) :: stat
    real(wp) :: rate(self%grid%n)

    self%still = self%grid
    self%still%u = 0
    self%still%implicit_rate = 0
    rate = [self%grid%u/self%grid%dx, 0.0_wp]
    call self%model%limit_supply(supply, second_order, rate, 0*rate, stat)
  end subroutine feed

end module pyworm_line_film
