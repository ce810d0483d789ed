!> An approximate solve of the linearised Reynolds equation, by one multigrid V-cycle on a local model.
!>
!> The model is that of `film_levels`. Line Gauss-Seidel smooths, its lines across the
!> entrainment and swept downstream, so that the wedge of the model is solved exactly by a sweep; the
!> coarsest grid is solved by band LU. The cycle preconditions the exact system and affects only its rate of
!> convergence; hence single precision. That of the adjoint solves the transposed model, swept upstream.
!>
!> A cycle is limited by memory traffic. Hence a sweep from zero leaves a residual that only the line
!> after each adds to, which is restricted as it is computed; and the coarse grid's correction is added to a
!> line just before its neighbour is solved against it, since a line's own old values are never read.
module pyworm_multigrid
  use pyworm_kinds, only: pp, wp
  use pyworm_lapack, only: sgbtrf, sgbtrs
  use pyworm_film_levels, only: grid_level, new_level, coarsen_entrainment, set_level, set_mobility, model_line, &
    leaving_rate, orient
  use pyworm_film_model, only: film_model
  use pyworm_line_relaxation, only: factor_line, relax_line, relax_first
  use pyworm_reynolds, only: film_grid
  use pyworm_status, only: status_ok, status_not_converged, status_no_memory
  implicit none(type, external)
  private

  public :: film_multigrid, new_film_multigrid, set_entrainment, set_film_multigrid, film_cycle

  !> Largest sharpening: 4 took the fewest convolutions of 0 to 20 on eleven films (`benchmarks/cost/film.py`), half of
  !> those without.
  real(pp), parameter :: most_sharpening = 4.0_pp
  !> Coarsening ends where a direction has at most this many points.
  integer, parameter :: coarsest_points = 12

  type :: film_multigrid
    !> Whether lines run along y, across an entrainment along x.
    logical :: transposed = .false.
    !> Whether oil mainly moves towards later lines; of the transposed model, towards earlier ones.
    logical :: rising = .true.
    !> Whether the model is transposed.
    logical :: adjoint = .false.
    !> Implicit part of the transient term [1/s], as of `film_grid`.
    real(pp) :: implicit_rate = 0
    type(grid_level), allocatable :: level(:)
    !> How much the finest level's solution is sharpened: see `sharpen`.
    real(pp), allocatable :: sharpening(:, :)
    !> Band LU factors of the coarsest grid.
    real(pp), allocatable :: band(:, :)
    integer, allocatable :: pivots(:)
  end type film_multigrid

contains

  !> Makes the levels of a grid; `centre` [m/Pa] is its kernel's centre value.
  subroutine new_film_multigrid(grid, centre, self, stat)
    type(film_grid), intent(in) :: grid
    real(wp), intent(in) :: centre
    type(film_multigrid), intent(out) :: self
    integer, intent(out) :: stat
    real(wp) :: sum_u, sum_v
    integer :: levels, l, err

    sum_u = sum(grid%u)
    sum_v = sum(grid%v)
    self%transposed = abs(sum_u) >= abs(sum_v)
    self%rising = merge(sum_u, sum_v, self%transposed) >= 0
    levels = coarsenings(grid%nx, grid%ny) + 1
    allocate (self%level(levels))
    do l = 1, levels
      call new_level(grid, self%transposed, 2**(l - 1), centre, self%level(l), stat)
      if (stat /= status_ok) return
    end do
    allocate (self%sharpening(self%level(1)%length, self%level(1)%count), source=0.0_pp, stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
    if (stat /= status_ok) return
    call set_entrainment(self, grid)
    associate (coarsest => self%level(levels))
      allocate (self%band(3*coarsest%length + 1, coarsest%length*coarsest%count), &
        self%pivots(coarsest%length*coarsest%count), stat=err)
    end associate
    stat = merge(status_ok, status_no_memory, err == 0)
  end subroutine new_film_multigrid

  !> Sets the entrainment of all levels; the direction of lines is unchanged.
  subroutine set_entrainment(self, grid)
    type(film_multigrid), intent(inout) :: self
    type(film_grid), intent(in) :: grid
    integer :: l

    call orient(self%transposed, merge(grid%v, grid%u, self%transposed), self%level(1)%along)
    call orient(self%transposed, merge(grid%u, grid%v, self%transposed), self%level(1)%across)
    do l = 2, size(self%level)
      call coarsen_entrainment(self%level(l - 1), self%level(l))
    end do
  end subroutine set_entrainment

  !> Number of times that both directions can be halved.
  pure integer function coarsenings(nx, ny)
    integer, intent(in) :: nx, ny
    integer :: n, m

    n = nx
    m = ny
    coarsenings = 0
    do while (mod(n, 2) == 1 .and. mod(m, 2) == 1 .and. min(n, m) > coarsest_points)
      n = (n + 1)/2
      m = (m + 1)/2
      coarsenings = coarsenings + 1
    end do
  end function coarsenings

  !> Rebuilds every level about the present fields of a film; `free` is true where pressure may change.
  subroutine set_film_multigrid(self, model, free, stat)
    type(film_multigrid), intent(inout) :: self
    type(film_model), intent(in) :: model
    logical, intent(in) :: free(:, :)
    integer, intent(out) :: stat
    integer :: l

    do l = 1, size(self%level)
      call set_level(self%level(l), model, free)
      if (.not. model%is_sheared()) then
        if (l == 1) then
          call set_mobility(self%level(l), model%fields)
        else
          call set_mobility(self%level(l), model%fields, self%level(l - 1))
        end if
      end if
      call set_lines(self, l, model)
      self%level(l)%x = 0
    end do
    call factor_coarsest(self, stat)
  end subroutine set_film_multigrid

  !> Factors the lines of a level, on the coarsest the band. Rows where pressure is not free are those of the identity.
  subroutine set_lines(self, l, model)
    type(film_multigrid), intent(inout) :: self
    integer, intent(in) :: l
    type(film_model), intent(in) :: model
    real(pp), dimension(self%level(l)%length) :: centre, left, right, before, after
    integer :: j, n

    n = self%level(l)%length
    if (l == size(self%level)) self%band = 0
    associate (level => self%level(l))
      !$omp parallel do private(centre, left, right, before, after) schedule(static)
      do j = 2, level%count - 1
        if (self%adjoint) then
          call transposed_line(level, j, self%implicit_rate, model, centre, left, right, before, after)
        else
          call model_line(level, j, self%implicit_rate, model, centre, left, right, before, after)
        end if
        if (l == 1) call set_sharpening(level, j, centre, self%sharpening(:, j))
        if (l == size(self%level)) then
          call set_band(self%band, n, j, centre, left, right, before, after)
        else
          level%lines%before(2:n - 1, j) = before(2:n - 1)
          level%lines%after(2:n - 1, j) = after(2:n - 1)
          call factor_line(level%lines, j, centre, left, right, level%free(:, j))
        end if
      end do
    end associate
  end subroutine set_lines

  !> Column of each node of line j in the model: coefficients as of `model_line` of the transposed one.
  subroutine transposed_line(level, j, implicit_rate, model, centre, left, right, before, after)
    type(grid_level), intent(in) :: level
    integer, intent(in) :: j
    real(pp), intent(in) :: implicit_rate
    type(film_model), intent(in) :: model
    real(pp), dimension(level%length), intent(out) :: centre, left, right, before, after
    real(pp), dimension(level%length) :: main, from_left, from_right, from_before, from_after
    integer :: n

    n = level%length
    call model_line(level, j, implicit_rate, model, centre, from_left, from_right, from_before, from_after)
    left(2) = 0
    left(3:n - 1) = from_right(2:n - 2)
    right(n - 1) = 0
    right(2:n - 2) = from_left(3:n - 1)
    before = 0
    after = 0
    if (j > 2) then
      call model_line(level, j - 1, implicit_rate, model, main, from_left, from_right, from_before, from_after)
      before(2:n - 1) = from_after(2:n - 1)
    end if
    if (j < level%count - 1) then
      call model_line(level, j + 1, implicit_rate, model, main, from_left, from_right, from_before, from_after)
      after(2:n - 1) = from_before(2:n - 1)
    end if
  end subroutine transposed_line

  !> Sets the sharpening of line j to the share of the wedge in the flow that leaves a node, times the most.
  pure subroutine set_sharpening(level, j, centre, sharpening)
    type(grid_level), intent(in) :: level
    integer, intent(in) :: j
    real(pp), intent(in) :: centre(:)
    real(pp), intent(inout) :: sharpening(:)
    integer :: i

    do i = 2, level%length - 1
      sharpening(i) = merge(most_sharpening*min(leaving_rate(level, i, j)*level%f(i, j)/centre(i), 1.0_pp), 0.0_pp, &
        level%free(i, j) > 0 .and. centre(i) > 0)
    end do
  end subroutine set_sharpening

  !> Line j of n points in LAPACK's band storage: element (row, column) stands at (2 n + 1 + row - column,
  !> column).
  pure subroutine set_band(band, n, j, centre, left, right, before, after)
    real(pp), intent(inout) :: band(:, :)
    integer, intent(in) :: n, j
    real(pp), intent(in) :: centre(n), left(n), right(n), before(n), after(n)
    integer :: i, row, diagonal

    diagonal = 2*n + 1
    do i = 2, n - 1
      row = i + n*(j - 1)
      band(diagonal, row) = centre(i)
      band(diagonal + 1, row - 1) = left(i)
      band(diagonal - 1, row + 1) = right(i)
      band(diagonal + n, row - n) = before(i)
      band(diagonal - n, row + n) = after(i)
    end do
  end subroutine set_band

  subroutine factor_coarsest(self, stat)
    type(film_multigrid), intent(inout) :: self
    integer, intent(out) :: stat
    integer :: n, points, info

    associate (level => self%level(size(self%level)), diagonal => self%band(2*self%level(size(self%level))%length + 1, :))
      n = level%length
      points = n*level%count
      ! rows of the outline, which no line has set
      where (.not. abs(diagonal) > 0) diagonal = 1
      call sgbtrf(points, points, n, n, self%band, 3*n + 1, self%pivots, info)
    end associate
    stat = merge(status_ok, status_not_converged, info == 0)
  end subroutine factor_coarsest

  !> Approximates the solution x for the right-hand side f; x is zero where pressure is not free.
  subroutine film_cycle(self, f, x)
    type(film_multigrid), intent(inout) :: self
    real(wp), intent(in) :: f(:, :)
    real(wp), intent(out) :: x(:, :)

    call orient(self%transposed, f, self%level(1)%f)
    call cycle_from(self, 1)
    call sharpen(self%sharpening, self%level(1)%x, self%level(1)%f)
    call orient_back(self%transposed, self%level(1)%f, x)
  end subroutine film_cycle

  !> Adds to x, where the wedge rules, a multiple of its difference from the mean of the four neighbours.
  !>
  !> The deflection by a pressure of wave number k falls as 1/k, and the wedge's flow falls against that of first order; in
  !> the model neither does, so that it solves for too little pressure of short waves.
  subroutine sharpen(sharpening, x, sharp)
    real(pp), contiguous, intent(in) :: sharpening(:, :), x(:, :)
    real(pp), contiguous, intent(inout) :: sharp(:, :)
    integer :: i, j

    sharp(:, [1, size(x, 2)]) = 0
    !$omp parallel do private(i) schedule(static)
    do j = 2, size(x, 2) - 1
      sharp(1, j) = 0
      do i = 2, size(x, 1) - 1
        sharp(i, j) = x(i, j) + sharpening(i, j)*(x(i, j) - (x(i - 1, j) + x(i + 1, j) + x(i, j - 1) + x(i, j + 1))/4)
      end do
      sharp(size(x, 1), j) = 0
    end do
  end subroutine sharpen

  !> Copies a field of the finest level to the order of the film.
  subroutine orient_back(transposed, oriented, field)
    logical, intent(in) :: transposed
    real(pp), intent(in) :: oriented(:, :)
    real(wp), intent(out) :: field(:, :)
    integer, parameter :: block = 16
    integer :: i, j, k, l

    if (.not. transposed) then
      field = oriented
      return
    end if
    !$omp parallel do private(i, k, l) schedule(static)
    do j = 1, size(field, 2), block
      do i = 1, size(field, 1), block
        do l = j, min(j + block - 1, size(field, 2))
          do k = i, min(i + block - 1, size(field, 1))
            field(k, l) = oriented(l, k)
          end do
        end do
      end do
    end do
  end subroutine orient_back

  recursive subroutine cycle_from(self, l)
    type(film_multigrid), intent(inout) :: self
    integer, intent(in) :: l
    integer :: j, first, last, step

    if (l == size(self%level)) then
      call solve_coarsest(self)
      return
    end if
    associate (level => self%level(l), coarser => self%level(l + 1))
      step = merge(1, -1, self%rising)
      first = merge(2, level%count - 1, self%rising)
      last = merge(level%count - 1, 2, self%rising)
      ! from zero, downstream: only the line after each then adds to its residual
      do j = first, last, step
        call relax_first(level%lines, j, self%rising, level%f, level%x)
      end do
      if (self%rising) then
        call restrict_rest(level%lines%after, level%x, 1, coarser%f)
      else
        call restrict_rest(level%lines%before, level%x, -1, coarser%f)
      end if
      call cycle_from(self, l + 1)
      do j = first, last, step
        if (j /= last) call correct_line(coarser%x, j + step, level%lines%work, level%x)
        call relax_line(level%lines, j, level%f, level%x)
      end do
    end associate
  end subroutine cycle_from

  !> Restricts the residual of a sweep from zero by full weighting: x of the line that follows by `step` times its
  !> coupling.
  subroutine restrict_rest(coupling, x, step, coarse)
    real(pp), contiguous, intent(in) :: coupling(:, :), x(:, :)
    integer, intent(in) :: step
    real(pp), contiguous, intent(inout) :: coarse(:, :)
    real(pp) :: row(size(x, 1))
    integer :: i, j, l

    ! the coupling of the outline's lines is zero
    !$omp parallel do private(i, l, row) schedule(static)
    do j = 2, size(coarse, 2) - 1
      l = 2*j - 1
      do i = 2, size(x, 1) - 1
        row(i) = -(coupling(i, l)*x(i, l + step) + (coupling(i, l - 1)*x(i, l - 1 + step) &
          + coupling(i, l + 1)*x(i, l + 1 + step))/2)/2
      end do
      do i = 2, size(coarse, 1) - 1
        coarse(i, j) = (row(2*i - 1) + (row(2*i - 2) + row(2*i))/2)/2
      end do
    end do
  end subroutine restrict_rest

  !> Adds the bilinear interpolant of the coarse field to line j; `row` is workspace. Where pressure is not
  !> free no coupling reads it.
  pure subroutine correct_line(coarse, j, row, fine)
    real(pp), contiguous, intent(in) :: coarse(:, :)
    integer, intent(in) :: j
    real(pp), contiguous, intent(inout) :: row(:), fine(:, :)
    integer :: i, k, n

    k = (j + 1)/2
    n = size(coarse, 1)
    if (mod(j, 2) == 1) then
      row(:n) = coarse(:, k)
    else
      row(:n) = (coarse(:, k) + coarse(:, k + 1))/2
    end if
    do i = 1, n - 1
      fine(2*i - 1, j) = fine(2*i - 1, j) + row(i)
      fine(2*i, j) = fine(2*i, j) + (row(i) + row(i + 1))/2
    end do
  end subroutine correct_line

  subroutine solve_coarsest(self)
    type(film_multigrid), intent(inout) :: self
    real(pp), allocatable :: b(:, :)
    integer :: info, points

    associate (level => self%level(size(self%level)))
      points = level%length*level%count
      allocate (b(points, 1))
      b = reshape(level%f*level%free, [points, 1])
      call sgbtrs("N", points, level%length, level%length, 1, self%band, 3*level%length + 1, self%pivots, b, points, &
        info)
      level%x = reshape(b, [level%length, level%count])
    end associate
  end subroutine solve_coarsest

end module pyworm_multigrid
