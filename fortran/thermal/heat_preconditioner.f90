!> Approximate solution of the linearised equations of a film's temperature, and of the transposed ones.
!>
!> Block Gauss-Seidel, once against the entrainment, over the columns whose oil flows back, and once with it: the columns are solved
!> in this order, each with the temperature upstream of it as far as it is known, and with bodies whose rise at a node is that by
!> the flux on its own cell alone. With four times that rise, as in `wall_balance`, iterations are as many or up to twice as many.
!> The transposed solve is the exact transpose.
module pyworm_heat_preconditioner
  use pyworm_heat_columns, only: most_upstream
  use pyworm_heat_linearisation, only: heat_linearisation, before_levels
  use pyworm_kinds, only: pp, wp
  use pyworm_lapack, only: dgesv
  use pyworm_status, only: status_ok, status_not_finite, status_no_memory
  use pyworm_wall_balance, only: wall_pair
  implicit none(type, external)
  private

  public :: heat_preconditioner, new_heat_preconditioner, solve_heat, solve_heat_transposed

  type :: heat_preconditioner
    !> Transposed inverse of each column's equations at a given temperature upstream, (level, level, column).
    real(pp), allocatable :: inverse(:, :, :)
    !> Equations by the heat that levels lack: one, of the walls' levels the rise of the bodies by the flux on a cell [K m2/W].
    real(wp), allocatable :: scale(:)
    !> Whether oil flows from a column to one that is earlier in the sweep with the entrainment.
    logical, allocatable :: backward(:)
  end type heat_preconditioner

contains

  !> Inverts the columns' equations; `status_not_finite` if one is singular.
  subroutine new_heat_preconditioner(linear, walls, self, stat)
    type(heat_linearisation), intent(in) :: linear
    type(wall_pair), intent(in) :: walls
    type(heat_preconditioner), intent(out) :: self
    integer, intent(out) :: stat
    real(wp), dimension(linear%levels, linear%levels) :: equations, inverse
    integer :: pivots(linear%levels), s, k, info, failures, err

    associate (n => linear%levels)
      allocate (self%inverse(n, n, size(linear%node)), self%scale(n), stat=err)
      stat = merge(status_ok, status_no_memory, err == 0)
      if (stat /= status_ok) return
      call mark_backward(linear, self%backward)
      self%scale = 1
      self%scale(1) = walls%body(1)%surface%own
      self%scale(n) = walls%body(2)%surface%own
      failures = 0
      !$omp parallel do private(equations, inverse, pivots, k, info) reduction(+:failures) schedule(static)
      do s = 1, size(linear%node)
        inverse = 0
        do k = 1, n
          equations(:, k) = self%scale(k)*linear%block(before_levels + 1:, k, s)
          inverse(k, k) = 1
        end do
        equations(1, 1) = equations(1, 1) + 1
        equations(n, n) = equations(n, n) + 1
        call dgesv(n, n, equations, n, pivots, inverse, n, info)
        if (info /= 0) failures = failures + 1
        self%inverse(:, :, s) = real(inverse, pp)
      end do
    end associate
    if (failures > 0) stat = status_not_finite
  end subroutine new_heat_preconditioner

  !> Marks the columns from which oil flows to one that is earlier in the sweep with the entrainment.
  pure subroutine mark_backward(linear, backward)
    type(heat_linearisation), intent(in) :: linear
    logical, allocatable, intent(out) :: backward(:)
    integer :: column(linear%nx*linear%ny), s, k, t

    ! on the outline there are no columns
    column = 0
    column(linear%node) = [(s, s=1, size(linear%node))]
    allocate (backward(size(linear%node)), source=.false.)
    do s = 1, size(linear%node)
      do k = 1, linear%levels
        do t = 1, most_upstream
          associate (upstream => column(linear%place(t, k, s)))
            if (upstream == 0 .or. .not. abs(linear%weight(t, k, s)) > 0) cycle
            if (merge(upstream < s, upstream > s, linear%backward)) backward(upstream) = .true.
          end associate
        end do
      end do
    end do
  end subroutine mark_backward

  !> Solves for the temperature by which the equations change by `change`, approximately; both (nx, ny, levels).
  pure subroutine solve_heat(linear, self, change, warming)
    type(heat_linearisation), intent(in) :: linear
    type(heat_preconditioner), intent(in) :: self
    real(wp), intent(in) :: change(linear%nx*linear%ny, linear%levels)
    real(wp), intent(out) :: warming(linear%nx*linear%ny, linear%levels)
    real(wp) :: rest(linear%levels)
    integer :: sweep, step, s, k, t

    ! on the outline the equations are those of the temperature itself
    warming = change
    warming(linear%node, :) = 0
    do sweep = 1, 2
      do step = 1, size(linear%node)
        s = merge(step, size(linear%node) + 1 - step, (sweep == 1) .eqv. linear%backward)
        if (sweep == 1 .and. .not. self%backward(s)) cycle
        rest = change(linear%node(s), :)
        do k = 1, linear%levels
          do t = 1, most_upstream
            rest(k) = rest(k) - self%scale(k)*linear%weight(t, k, s)*warming(linear%place(t, k, s), k)
          end do
        end do
        warming(linear%node(s), :) = matmul(rest, self%inverse(:, :, s))
      end do
    end do
  end subroutine solve_heat

  !> Transpose of `solve_heat`: solves approximately for the weights of the equations by which the temperature has the
  !> weights `by_warming`. Both sweeps are taken from their ends.
  pure subroutine solve_heat_transposed(linear, self, by_warming, weight)
    type(heat_linearisation), intent(in) :: linear
    type(heat_preconditioner), intent(in) :: self
    real(wp), intent(in) :: by_warming(linear%nx*linear%ny, linear%levels)
    real(wp), intent(out) :: weight(linear%nx*linear%ny, linear%levels)
    !> With the levels of a node together.
    real(wp), dimension(linear%levels, linear%nx*linear%ny) :: rest, found
    real(wp) :: solved(linear%levels), scaled
    integer :: sweep, step, s, k, t

    rest = transpose(by_warming)
    found = 0
    do sweep = 2, 1, -1
      do step = size(linear%node), 1, -1
        s = merge(step, size(linear%node) + 1 - step, (sweep == 1) .eqv. linear%backward)
        if (sweep == 1 .and. .not. self%backward(s)) cycle
        associate (node => linear%node(s))
          solved = 0
          do k = 1, linear%levels
            solved = solved + self%inverse(:, k, s)*rest(k, node)
          end do
          found(:, node) = found(:, node) + solved
          rest(:, node) = 0
        end associate
        do k = 1, linear%levels
          scaled = self%scale(k)*solved(k)
          do t = 1, most_upstream
            associate (place => linear%place(t, k, s))
              rest(k, place) = rest(k, place) - linear%weight(t, k, s)*scaled
            end associate
          end do
        end do
      end do
    end do
    ! what is left of the columns is of a temperature that was not known in the first sweep
    rest(:, linear%node) = found(:, linear%node)
    weight = transpose(rest)
  end subroutine solve_heat_transposed

end module pyworm_heat_preconditioner
