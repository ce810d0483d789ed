!> The adjoint of a converged film and its temperature: `film_adjoint` with the temperature at the levels among the unknowns.
!>
!> With R the rows of the film, H the equations of the temperature (`heat_residual`), both zero, and a figure J, all of the
!> pressure and rigid film x, the temperature T and the inputs z,
!>
!>   dJ/dz = J_z - lambda . R_z - mu . H_z,   R_x^T lambda + H_x^T mu = J_x,   R_T^T lambda + H_T^T mu = J_T.
!>
!> GMRES is preceded by the approximate solve of the temperature's equations (`heat_preconditioner`), whose weights then count in
!> that of the film's: in this order heat that thins the film much takes half or a quarter of the iterations of the other. Its
!> vectors are weights times what typical residuals are, so that all parts of its norm are of the figure's unit.
module pyworm_thermal_adjoint
  use pyworm_film_adjoint, only: adjoint_system, film_adjoint, new_adjoint_system, rows_adjoint
  use pyworm_film_newton, only: film_contact, first_row, last_row
  use pyworm_film_warming, only: film_warming, new_film_warming, warm_imbalance_transposed
  use pyworm_heat_linearisation, only: heat_linearisation, linearise_heat
  use pyworm_heat_preconditioner, only: heat_preconditioner, new_heat_preconditioner, solve_heat_transposed
  use pyworm_heat_products, only: heat_by_film_transposed, heat_transposed
  use pyworm_kinds, only: pp, wp
  use pyworm_krylov, only: gmres, linear_system
  use pyworm_status, only: status_bad_argument, status_no_memory, status_not_finite, status_ok
  use pyworm_thermal_step, only: thermal_contact
  implicit none(type, external)
  private

  public :: thermal_adjoint_system, thermal_adjoint, new_thermal_adjoint_system, solve_thermal_adjoint

  !> Iterations after which GMRES is restarted.
  integer, parameter :: cycle_length = 60
  !> Typical residual of a wall's balance [K], and of what a level lacks over the film's conductance.
  real(wp), parameter :: typical_rise = 10

  !> Solution for one figure: with the weights of the temperature's equations, (nx, ny, levels).
  type, extends(film_adjoint) :: thermal_adjoint
    real(wp), allocatable :: heat(:, :, :)
  end type thermal_adjoint

  !> The transposed system of a film and its temperature at their present state.
  type, extends(linear_system) :: thermal_adjoint_system
    type(thermal_contact), pointer :: contact => null()
    type(adjoint_system) :: film
    type(film_warming) :: flow
    type(heat_linearisation) :: heat
    type(heat_preconditioner) :: approximate
    !> Typical imbalance of a node [m/s].
    real(wp) :: typical_imbalance = 0
  contains
    procedure :: multiply
    procedure :: precondition
  end type thermal_adjoint_system

contains

  !> Makes the transposed system of a heated contact that was last evaluated at its solution. A gap that is filled in part,
  !> and oil or bodies that remember another state, are refused.
  subroutine new_thermal_adjoint_system(self, contact, stat)
    type(thermal_adjoint_system), intent(out) :: self
    type(thermal_contact), target, intent(inout) :: contact
    integer, intent(out) :: stat

    stat = status_bad_argument
    if (.not. allocated(contact%heat)) return
    self%contact => contact
    self%typical_imbalance = contact%film%wedge/size(contact%film%gap)
    call linearise_heat(contact%film, contact%heat, self%heat, stat)
    if (stat == status_ok) call new_film_warming(contact%film, self%flow, stat)
    if (stat == status_ok) call new_heat_preconditioner(self%heat, contact%heat%walls, self%approximate, stat)
    if (stat == status_ok) call new_adjoint_system(self%film, contact%film, stat)
  end subroutine new_thermal_adjoint_system

  !> Solves for a figure whose changes by the total pressure, by the gap between mean planes and by the temperature at the levels
  !> are given, to `tolerance` times the first residual or within `most` iterations.
  subroutine solve_thermal_adjoint(self, by_pressure, by_film, by_rise, tolerance, most, found, stat)
    type(thermal_adjoint_system), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: by_pressure(:, :), by_film(:, :)
    real(wp), contiguous, intent(in) :: by_rise(:, :, :)
    real(wp), intent(in) :: tolerance
    integer, intent(in) :: most
    type(thermal_adjoint), intent(out) :: found
    integer, intent(out) :: stat
    real(wp), allocatable :: right(:), solution(:), by_p(:, :), by_h(:, :)
    real(pp), allocatable :: basis(:, :)
    integer :: n, unknowns, err

    n = size(by_pressure)
    unknowns = n + 1 + size(by_rise)
    allocate (right(unknowns), solution(unknowns), basis(unknowns, cycle_length), stat=err)
    if (err == 0) allocate (by_p, by_h, mold=by_pressure, stat=err)
    if (err == 0) allocate (found%heat, mold=by_rise, stat=err)
    stat = status_no_memory
    if (err /= 0) return
    associate (film => self%contact%film)
      call self%film%close_film(by_pressure, by_film, 0.0_wp, right(:n + 1))
      right(n + 2:) = reshape(by_rise, [size(by_rise)])
      call gmres(self, right, tolerance, most, basis, solution, found%iterations, found%reduction)
      stat = status_not_finite
      if (.not. all(abs(solution) <= huge(1.0_wp))) return
      found%rows = reshape(solution(:n), shape(by_pressure))/self%typical_imbalance
      if (.not. film%rigid_film_fixed) found%by_load = solution(n + 1)/self%typical_imbalance*film%load_weight
      call read_heat(self, solution(n + 2:), found%heat)
      call rows_adjoint(film, found%rows, by_p, by_h)
      found%by_gap = by_film - by_h
      call heat_rows_adjoint(self, found%heat, by_p, by_h)
      found%by_gap = found%by_gap - by_h
    end associate
    stat = status_ok
  end subroutine solve_thermal_adjoint

  !> Sets what weights of the temperature's equations count by the total pressure at a given film, and by the gap between mean
  !> planes.
  subroutine heat_rows_adjoint(self, weight, by_p, by_h)
    class(thermal_adjoint_system), intent(inout) :: self
    real(wp), contiguous, intent(in) :: weight(:, :, :)
    real(wp), contiguous, intent(out) :: by_p(:, :), by_h(:, :)
    real(wp) :: by_asperities(size(by_p, 1), size(by_p, 2))

    call heat_by_film_transposed(self%heat, self%contact%heat%walls, weight, by_p, by_h, by_asperities)
    call share_adjoint(self%contact%film, by_asperities, by_p, by_h)
  end subroutine heat_rows_adjoint

  !> Replaces what is counted by the oil's pressure at a given gap, and by the gap, by that of the total pressure.
  subroutine share_adjoint(film, by_asperities, by_p, by_h)
    class(film_contact), intent(in) :: film
    real(wp), intent(in) :: by_asperities(:, :)
    real(wp), intent(inout) :: by_p(:, :), by_h(:, :)

    if (.not. film%model%is_rough()) return
    ! the oil's pressure is the total less the asperities'; where it has ruptured these bear all
    by_h = by_h + merge(film%model%fields%rough%stiffness*(by_p - by_asperities), 0.0_wp, film%free)
    by_p = merge(by_p, by_asperities, film%free)
  end subroutine share_adjoint

  !> Reads the weights of the temperature's equations from a part of a vector.
  pure subroutine read_heat(self, x, weight)
    class(thermal_adjoint_system), intent(in) :: self
    real(wp), intent(in) :: x(:)
    real(wp), intent(out) :: weight(:, :, :)

    weight = reshape(x, shape(weight))/typical_rise
    call scale_levels(self, 1/self%heat%conductance, weight)
  end subroutine read_heat

  !> Multiplies the weights of the levels' equations at the inner nodes by a factor.
  pure subroutine scale_levels(self, factor, weight)
    class(thermal_adjoint_system), intent(in) :: self
    real(wp), intent(in) :: factor
    real(wp), intent(inout) :: weight(:, :, :)

    associate (inner => weight(2:size(weight, 1) - 1, first_row(self%contact%film):last_row(self%contact%film), &
        2:size(weight, 3) - 1))
      inner = factor*inner
    end associate
  end subroutine scale_levels

  !> Multiplies by the transposed Jacobian: weights of the film's rows, of the load's and of the temperature's equations to changes
  !> by pressure, rigid film and temperature.
  subroutine multiply(self, x, y)
    class(thermal_adjoint_system), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    real(wp), dimension(size(self%flow%mass, 1), size(self%flow%mass, 2)) :: by_p, by_h, heat_by_p, heat_by_h, by_asperities, &
      rows
    real(wp), dimension(size(by_p, 1), size(by_p, 2), self%heat%levels) :: weight, by_rise, by_flow
    integer :: n

    n = size(by_p)
    associate (film => self%contact%film)
      rows = reshape(x(:n), shape(rows))/self%typical_imbalance
      call rows_adjoint(film, rows, by_p, by_h)
      call read_heat(self, x(n + 2:), weight)
      call heat_transposed(self%heat, self%contact%heat%walls, weight, heat_by_p, heat_by_h, by_asperities, by_rise)
      call share_adjoint(film, by_asperities, heat_by_p, heat_by_h)
      by_p = by_p + heat_by_p
      by_h = by_h + heat_by_h
      call self%film%close_film(by_p, by_h, x(n + 1)/self%typical_imbalance, y(:n + 1))
      rows = merge(rows, 0.0_wp, film%free)
      call warm_imbalance_transposed(film, self%flow, rows, by_flow)
      y(n + 2:) = reshape(by_rise + by_flow, [size(by_rise)])
    end associate
  end subroutine multiply

  !> Solves the transposed system approximately: for the temperature's weights, then for the film's with what those count.
  subroutine precondition(self, x, y)
    class(thermal_adjoint_system), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    real(wp), dimension(size(self%flow%mass, 1), size(self%flow%mass, 2)) :: by_p, by_h
    real(wp) :: weight(size(by_p, 1), size(by_p, 2), self%heat%levels), rest(size(by_p) + 1)
    integer :: n

    n = size(by_p)
    call solve_heat_transposed(self%heat, self%approximate, x(n + 2:), weight)
    call heat_rows_adjoint(self, weight, by_p, by_h)
    call self%film%close_film(by_p, by_h, 0.0_wp, rest)
    rest = x(:n + 1) - rest
    call self%film%precondition(rest, y(:n + 1))
    y(:n + 1) = self%typical_imbalance*y(:n + 1)
    call scale_levels(self, self%heat%conductance, weight)
    y(n + 2:) = reshape(typical_rise*weight, [size(weight)])
  end subroutine precondition

end module pyworm_thermal_adjoint
