!> The adjoint of a converged film: how a figure changes by the load and by the gap at each node, and by what else changes the
!> film's equations, all by one linear solve.
!>
!> With R(x; z) = 0 the equations of the film for its pressure and rigid film x (`film_newton`), at given inputs z and a figure
!> J(x; z),
!>
!>   dJ/dz = J_z - lambda . R_z,   R_x^T lambda = J_x
!>
!> (Giles and Pierce, Flow Turbul. Combust. 65 (2000) 393). R_x is Newton's Jacobian with the active set of the converged film;
!> the deflection is its own transpose. GMRES is preceded by the approximate solve of the transposed model of the kind of contact.
!> Rows are those of `film_newton`: the imbalance where pressure is free, between rough surfaces elsewhere the total pressure less
!> that of the asperities, and the load.
module pyworm_film_adjoint
  use pyworm_film_newton, only: change_balance, film_contact, set_system
  use pyworm_kinds, only: pp, wp
  use pyworm_krylov, only: gmres, linear_system
  use pyworm_rough_surfaces, only: rough_film
  use pyworm_status, only: status_bad_argument, status_no_memory, status_not_finite, status_ok
  use pyworm_vectors, only: dot, total
  implicit none(type, external)
  private

  public :: adjoint_system, film_adjoint, new_adjoint_system, solve_adjoint, rows_adjoint

  !> Iterations after which GMRES is restarted.
  integer, parameter :: cycle_length = 30

  !> Solution for one figure.
  type :: film_adjoint
    !> Weight of each row, (nx, ny), and the figure's change by the load on the grid, a negative force of its own left out.
    real(wp), allocatable :: rows(:, :)
    real(wp) :: by_load = 0
    !> The figure's whole change by the undeformed gap at each node.
    real(wp), allocatable :: by_gap(:, :)
    integer :: iterations = 0
    !> Preconditioned residual over that of no solution.
    real(wp) :: reduction = 0
  end type film_adjoint

  !> The transposed system of a film at its present state.
  type, extends(linear_system) :: adjoint_system
    class(film_contact), pointer :: film => null()
    !> Change of the rows by a unit rise of the rigid film; response of the preconditioner to a unit weight of the load's row, and
    !> the product of both.
    real(wp), allocatable :: rise(:, :), leaning(:, :)
    real(wp) :: stiffness = 0
    !> Scratch: what weights of the rows count by pressure, by film, and by the deflection.
    real(wp), allocatable :: by_p(:, :), by_h(:, :), deflected(:, :)
  contains
    procedure :: multiply
    procedure :: precondition
    procedure :: close_film
  end type adjoint_system

contains

  !> Makes the transposed system of a film that was last evaluated at its solution. A gap that is filled in part is refused.
  subroutine new_adjoint_system(self, film, stat)
    type(adjoint_system), intent(out) :: self
    class(film_contact), target, intent(inout) :: film
    integer, intent(out) :: stat
    real(wp), allocatable :: zero(:, :)
    integer :: nx, ny, err

    stat = status_bad_argument
    if (film%model%is_partial()) return
    nx = size(film%gap, 1)
    ny = size(film%gap, 2)
    self%film => film
    allocate (self%rise(nx, ny), self%leaning(nx, ny), self%by_p(nx, ny), self%by_h(nx, ny), self%deflected(nx, ny), &
      zero(nx, ny), source=0.0_wp, stat=err)
    stat = status_no_memory
    if (err /= 0) return
    call set_system(film, stat)
    if (stat == status_ok) call film%linearise_adjoint(stat)
    if (stat /= status_ok) return
    film%dh = 1
    call change_balance(film, zero, film%dh, self%rise)
    self%by_p = load_column(film)
    call film%relax_adjoint(self%by_p, self%leaning)
    self%stiffness = sum(self%rise*self%leaning)
  end subroutine new_adjoint_system

  !> Change of the load's row by the pressure at each node that may change.
  pure function load_column(film) result(column)
    class(film_contact), intent(in) :: film
    real(wp) :: column(size(film%gap, 1), size(film%gap, 2))

    column = 0
    if (film%rigid_film_fixed) return
    where (changeable(film)) column = film%spacing(1)*film%spacing(2)*film%load_weight
  end function load_column

  !> Where the (total) pressure is unknown.
  pure function changeable(film)
    class(film_contact), intent(in) :: film
    logical :: changeable(size(film%gap, 1), size(film%gap, 2))

    changeable = film%free .or. film%model%is_rough()
  end function changeable

  !> Solves for a figure, J, whose changes by the total pressure and by the gap between mean planes at each node are given, to
  !> `tolerance` times the first residual or within `most` iterations.
  subroutine solve_adjoint(self, by_pressure, by_film, tolerance, most, found, stat)
    type(adjoint_system), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: by_pressure(:, :), by_film(:, :)
    real(wp), intent(in) :: tolerance
    integer, intent(in) :: most
    type(film_adjoint), intent(out) :: found
    integer, intent(out) :: stat
    real(wp), allocatable, target :: right(:), solution(:)
    real(pp), allocatable :: basis(:, :)
    integer :: n, err

    n = size(by_pressure)
    allocate (right(n + 1), solution(n + 1), basis(n + 1, cycle_length), stat=err)
    stat = status_no_memory
    if (err /= 0) return
    call self%close_film(by_pressure, by_film, 0.0_wp, right)
    call gmres(self, right, tolerance, most, basis, solution, found%iterations, found%reduction)
    stat = status_not_finite
    if (.not. all(abs(solution) <= huge(1.0_wp))) return
    found%rows = reshape(solution(:n), shape(by_pressure))
    if (.not. self%film%rigid_film_fixed) found%by_load = solution(n + 1)*self%film%load_weight
    call rows_adjoint(self%film, found%rows, self%by_p, self%by_h)
    found%by_gap = by_film - self%by_h
    stat = status_ok
  end subroutine solve_adjoint

  !> Sets what weights of the rows count by the total pressure at a given film, and by the gap between mean planes: the
  !> transpose of `change_balance`.
  subroutine rows_adjoint(film, rows, by_p, by_h)
    class(film_contact), intent(inout) :: film
    real(wp), contiguous, intent(in) :: rows(:, :)
    real(wp), contiguous, intent(out) :: by_p(:, :), by_h(:, :)

    film%dh = merge(rows, 0.0_wp, film%free)
    call film%imbalance_adjoint(film%dh, by_p, by_h)
    by_p = merge(by_p, 0.0_wp, film%free)
    if (.not. film%model%is_rough()) return
    ! the oil's pressure is the total less the asperities'; where it has ruptured the row is their difference
    where (.not. film%free) by_p = rows
    by_h = by_h + film%model%fields%rough%stiffness*by_p
  end subroutine rows_adjoint

  !> Multiplies by the transposed Jacobian: weights of the rows and of the load's to changes by pressure and by the rigid film.
  subroutine multiply(self, x, y)
    class(adjoint_system), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    real(wp), contiguous, pointer :: rows(:, :)
    integer :: n

    n = size(self%by_p)
    rows(1:size(self%by_p, 1), 1:size(self%by_p, 2)) => x(:n)
    call rows_adjoint(self%film, rows, self%by_p, self%by_h)
    call self%close_film(self%by_p, self%by_h, x(n + 1), y)
  end subroutine multiply

  !> Sets what is counted by the unknown pressures and the rigid film, from that by the pressure at a given film and by the film at
  !> each node; `load_row` is the weight of the load's row.
  subroutine close_film(self, by_p, by_h, load_row, y)
    class(adjoint_system), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: by_p(:, :), by_h(:, :)
    real(wp), intent(in) :: load_row
    real(wp), contiguous, target, intent(out) :: y(:)
    real(wp), contiguous, pointer :: pressures(:, :)
    integer :: n

    n = size(by_p)
    pressures(1:size(by_p, 1), 1:size(by_p, 2)) => y(:n)
    call self%film%deflection(by_h, self%deflected)
    pressures = merge(by_p + self%deflected, 0.0_wp, changeable(self%film)) + load_column(self%film)*load_row
    y(n + 1) = total(by_h)
    if (self%film%rigid_film_fixed) y(n + 1) = y(n + 1) + load_row
  end subroutine close_film

  !> Solves the transposed system approximately: the model of the kind of contact, with the load's row by its Schur complement.
  subroutine precondition(self, x, y)
    class(adjoint_system), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    real(wp), contiguous, pointer :: by_p(:, :), rows(:, :)
    integer :: n

    n = size(self%by_p)
    by_p(1:size(self%by_p, 1), 1:size(self%by_p, 2)) => x(:n)
    rows(1:size(self%by_p, 1), 1:size(self%by_p, 2)) => y(:n)
    call self%film%relax_adjoint(by_p, rows)
    ! the weights of the rows count rise . rows by the rigid film (`change_balance` by it alone)
    y(n + 1) = sum(self%rise*rows) - x(n + 1)
    if (self%film%rigid_film_fixed) then
      y(n + 1) = -y(n + 1)
    else
      y(n + 1) = y(n + 1)/self%stiffness
      rows = rows - self%leaning*y(n + 1)
    end if
  end subroutine precondition

end module pyworm_film_adjoint
