!> An approximate solve of the linearised Reynolds equation, by one multigrid V-cycle on a local model.
!>
!> The model couples the five nearest points: exact diffusion, first-order upwind wedge, and the deflection kernel
!> replaced by a multiple of its centre value. Line Gauss-Seidel smooths, its lines across the
!> entrainment and swept downstream, so that the wedge of the model is solved exactly by a sweep; the
!> coarsest grid is solved by band LU. The cycle preconditions the exact system and affects only its rate of
!> convergence; hence single precision.
!>
!> Fields of a level have the direction of the lines as their first index: (length, count). They are those of
!> the film transposed if the entrainment is mainly along x.
!>
!> A cycle is limited by memory traffic. Hence a sweep from zero leaves a residual that only the line
!> after each adds to, which is restricted as it is computed; and the coarse grid's correction is added to a
!> line just before its neighbour is solved against it, since a line's own old values are never read.
module multigrid
  use kinds, only: pp, wp
  use lapack, only: sgbtrf, sgbtrs
  use line_relaxation, only: line_systems, new_line_systems, factor_line, relax_line, relax_first
  use reynolds, only: arithmetic_share, film_fields, film_grid
  use status, only: status_ok, status_not_converged, status_no_memory
  implicit none(type, external)
  private

  public :: film_multigrid, new_film_multigrid, set_entrainment, set_film_multigrid, film_cycle

  !> Local stand-in for the kernel of the deflection over its centre value: it includes the nearest neighbours.
  real(pp), parameter :: kernel_factor = 4.0_pp
  !> Largest sharpening: 4 took the fewest convolutions of 0 to 20 on eleven films (`benchmarks/cost/film.py`), half of
  !> those without.
  real(pp), parameter :: most_sharpening = 4.0_pp
  !> Coarsening ends where a direction has at most this many points.
  integer, parameter :: coarsest_points = 12

  type :: grid_level
    !> Points along a line and lines; spacing [m] along a line and between lines.
    integer :: length = 0, count = 0
    real(pp) :: d_along = 0, d_across = 0
    !> Deflection [m/Pa] under a node's pressure in place of the kernel.
    real(pp) :: compliance = 0
    !> Entrainment through the face after a node, along the line and towards the next line [m/s].
    real(pp), allocatable :: along(:, :), across(:, :)
    !> Root of the mobility, pressure, and 1 where it is free to change, else 0.
    real(pp), allocatable :: root(:, :), p(:, :), free(:, :)
    !> Root of the mobility towards the next line where it differs from that within a line.
    real(pp), allocatable :: root_across(:, :)
    type(line_systems) :: lines
    !> Solution and right-hand side. While a level is built: derivatives of mobility and of
    !> rho h by pressure.
    real(pp), allocatable :: x(:, :), f(:, :)
  end type grid_level

  type :: film_multigrid
    !> Whether lines run along y, across an entrainment along x.
    logical :: transposed = .false.
    !> Whether oil mainly moves towards later lines.
    logical :: rising = .true.
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
    integer :: levels, length, count, l, err

    sum_u = sum(grid%u)
    sum_v = sum(grid%v)
    self%transposed = abs(sum_u) >= abs(sum_v)
    self%rising = merge(sum_u, sum_v, self%transposed) >= 0
    length = merge(grid%ny, grid%nx, self%transposed)
    count = merge(grid%nx, grid%ny, self%transposed)
    levels = coarsenings(length, count) + 1
    allocate (self%level(levels))
    do l = 1, levels
      associate (level => self%level(l))
        level%length = length
        level%count = count
        level%d_along = real(merge(grid%dy, grid%dx, self%transposed)*2**(l - 1), pp)
        level%d_across = real(merge(grid%dx, grid%dy, self%transposed)*2**(l - 1), pp)
        level%compliance = kernel_factor*real(centre*2**(l - 1), pp)
        call allocate_level(level, stat)
        if (stat /= status_ok) return
      end associate
      length = (length + 1)/2
      count = (count + 1)/2
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
  pure integer function coarsenings(length, count)
    integer, intent(in) :: length, count
    integer :: n, m

    n = length
    m = count
    coarsenings = 0
    do while (mod(n, 2) == 1 .and. mod(m, 2) == 1 .and. min(n, m) > coarsest_points)
      n = (n + 1)/2
      m = (m + 1)/2
      coarsenings = coarsenings + 1
    end do
  end function coarsenings

  subroutine allocate_level(level, stat)
    type(grid_level), intent(inout) :: level
    integer, intent(out) :: stat
    integer :: n, m, err

    n = level%length
    m = level%count
    allocate (level%along(n, m), level%across(n, m), level%root(n, m), level%p(n, m), level%free(n, m), level%x(n, m), &
      level%f(n, m), source=0.0_pp, stat=err)
    stat = status_no_memory
    if (err == 0) call new_line_systems(n, m, level%lines, stat)
  end subroutine allocate_level

  !> Copies a film's field to the order of the finest level.
  subroutine orient(transposed, field, oriented)
    logical, intent(in) :: transposed
    real(wp), intent(in) :: field(:, :)
    real(pp), intent(out) :: oriented(:, :)
    integer, parameter :: block = 16
    integer :: i, j, k, l

    if (.not. transposed) then
      oriented = real(field, pp)
      return
    end if
    !$omp parallel do private(i, k, l) schedule(static)
    do j = 1, size(field, 2), block
      do i = 1, size(field, 1), block
        do k = i, min(i + block - 1, size(field, 1))
          do l = j, min(j + block - 1, size(field, 2))
            oriented(l, k) = real(field(k, l), pp)
          end do
        end do
      end do
    end do
  end subroutine orient

  !> Entrainment at coarse faces: the mean of the two fine faces that they span.
  pure subroutine coarsen_entrainment(fine, coarse)
    type(grid_level), intent(in) :: fine
    type(grid_level), intent(inout) :: coarse
    integer :: i, j, k, l

    do j = 1, coarse%count
      l = 2*j - 1
      do i = 1, coarse%length
        k = 2*i - 1
        coarse%along(i, j) = (fine%along(k, l) + fine%along(min(k + 1, fine%length), l))/2
        coarse%across(i, j) = (fine%across(k, l) + fine%across(k, min(l + 1, fine%count)))/2
      end do
    end do
  end subroutine coarsen_entrainment

  !> Rebuilds every level about the present fields; `free` is true where pressure may change.
  subroutine set_film_multigrid(self, fields, free, stat)
    type(film_multigrid), intent(inout) :: self
    type(film_fields), intent(in) :: fields
    logical, intent(in) :: free(:, :)
    integer, intent(out) :: stat
    integer :: l, stride

    call set_mobility(self, fields)
    do l = 1, size(self%level)
      stride = 2**(l - 1)
      associate (level => self%level(l))
        call orient(self%transposed, fields%p(::stride, ::stride), level%p)
        call orient(self%transposed, fields%mobility_p(::stride, ::stride) &
          + level%compliance*fields%mobility_h(::stride, ::stride), level%x)
        call orient(self%transposed, fields%rho_p(::stride, ::stride)*fields%h(::stride, ::stride) &
          + level%compliance*fields%rho(::stride, ::stride), level%f)
        call orient(self%transposed, merge(1.0_wp, 0.0_wp, free(::stride, ::stride)), level%free)
        if (allocated(level%root_across)) then
          call set_lines(self, l, level%root_across)
        else
          call set_lines(self, l, level%root)
        end if
        level%x = 0
      end associate
    end do
    call factor_coarsest(self, stat)
  end subroutine set_film_multigrid

  !> Sets the root of the mobility on every level, in one direction or in both.
  subroutine set_mobility(self, fields)
    type(film_multigrid), intent(inout) :: self
    type(film_fields), intent(in) :: fields
    integer :: l

    if (.not. allocated(fields%mobility_y)) then
      call orient_root(fields%mobility, self%level(1)%root)
    else
      if (.not. allocated(self%level(1)%root_across)) self%level(1)%root_across = self%level(1)%root
      if (self%transposed) then
        call orient_root(fields%mobility_y, self%level(1)%root)
        call orient_root(fields%mobility, self%level(1)%root_across)
      else
        call orient_root(fields%mobility, self%level(1)%root)
        call orient_root(fields%mobility_y, self%level(1)%root_across)
      end if
    end if
    do l = 2, size(self%level)
      self%level(l)%root = self%level(l - 1)%root(::2, ::2)
      call restrict(self%level(l - 1)%root, self%level(l)%root)
      if (allocated(self%level(1)%root_across)) then
        self%level(l)%root_across = self%level(l - 1)%root_across(::2, ::2)
        call restrict(self%level(l - 1)%root_across, self%level(l)%root_across)
      end if
    end do

  contains

    !> Copies the root of a mobility to the order of the finest level; ratios of roots must stay finite.
    subroutine orient_root(mobility, root)
      real(wp), intent(in) :: mobility(:, :)
      real(pp), intent(out) :: root(:, :)

      call orient(self%transposed, sqrt(mobility), root)
      root = max(root, tiny(root))
    end subroutine orient_root

  end subroutine set_mobility

  !> The five-point matrix of the local model: factored lines, on the coarsest level a band. Rows where
  !> pressure is not free are those of the identity.
  subroutine set_lines(self, l, root_across)
    type(film_multigrid), intent(inout) :: self
    integer, intent(in) :: l
    real(pp), intent(in) :: root_across(:, :)
    real(pp), dimension(self%level(l)%length) :: centre, left, right, before, after, leave, enter
    integer :: i, j, n

    n = self%level(l)%length
    if (l == size(self%level)) self%band = 0
    associate (level => self%level(l), root => self%level(l)%root, p => self%level(l)%p, free => self%level(l)%free, &
      dm => self%level(l)%x, dq => self%level(l)%f)
      !$omp parallel do private(i, centre, left, right, before, after, leave, enter) schedule(static)
      do j = 2, level%count - 1
        ! through the faces within the line: outflow by a node's pressure, inflow by the next one's
        call face_flow(root(:n - 1, j), root(2:, j), p(:n - 1, j), p(2:, j), dm(:n - 1, j), dm(2:, j), dq(:n - 1, j), &
          dq(2:, j), level%along(:n - 1, j), 1/level%d_along, leave(:n - 1), enter(:n - 1))
        do i = 2, n - 1
          centre(i) = self%implicit_rate*dq(i, j) + leave(i) + enter(i - 1)
          right(i) = -free(i, j)*enter(i)*free(i + 1, j)
          left(i) = -free(i, j)*leave(i - 1)*free(i - 1, j)
        end do
        ! through the faces towards the next line, and from the one before
        call face_flow(root_across(:, j), root_across(:, j + 1), p(:, j), p(:, j + 1), dm(:, j), dm(:, j + 1), &
          dq(:, j), dq(:, j + 1), level%across(:, j), 1/level%d_across, leave, enter)
        do i = 2, n - 1
          centre(i) = centre(i) + leave(i)
          after(i) = -free(i, j)*enter(i)*free(i, j + 1)
        end do
        call face_flow(root_across(:, j - 1), root_across(:, j), p(:, j - 1), p(:, j), dm(:, j - 1), dm(:, j), &
          dq(:, j - 1), dq(:, j), level%across(:, j - 1), 1/level%d_across, leave, enter)
        do i = 2, n - 1
          centre(i) = merge(centre(i) + enter(i), 1.0_pp, free(i, j) > 0)
          before(i) = -free(i, j)*leave(i)*free(i, j - 1)
        end do
        if (l == 1) call set_sharpening(level, j, centre, dq, self%sharpening(:, j))
        if (l == size(self%level)) then
          call set_band(self%band, n, j, centre, left, right, before, after)
        else
          level%lines%before(2:n - 1, j) = before(2:n - 1)
          level%lines%after(2:n - 1, j) = after(2:n - 1)
          call factor_line(level%lines, j, centre, left, right, free(:, j))
        end if
      end do
    end associate
  end subroutine set_lines

  !> Sets the sharpening of line j to the share of the wedge in the flow that leaves a node, times the most.
  pure subroutine set_sharpening(level, j, centre, dq, sharpening)
    type(grid_level), intent(in) :: level
    integer, intent(in) :: j
    real(pp), intent(in) :: centre(:), dq(:, :)
    real(pp), intent(inout) :: sharpening(:)
    real(pp) :: speed
    integer :: i

    do i = 2, level%length - 1
      speed = (max(level%along(i, j), 0.0_pp) - min(level%along(i - 1, j), 0.0_pp))/level%d_along &
        + (max(level%across(i, j), 0.0_pp) - min(level%across(i, j - 1), 0.0_pp))/level%d_across
      sharpening(i) = merge(most_sharpening*min(speed*dq(i, j)/centre(i), 1.0_pp), 0.0_pp, &
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

  !> Computes the flow through faces between nodes 1 and 2 by a pressure change at 1, `leave`, and against it by
  !> one at 2, `enter`.
  elemental subroutine face_flow(root1, root2, p1, p2, dm1, dm2, dq1, dq2, u, per_length, leave, enter)
    real(pp), intent(in) :: root1, root2, p1, p2, dm1, dm2, dq1, dq2, u, per_length
    real(pp), intent(out) :: leave, enter
    real(pp), parameter :: share = real(arithmetic_share, pp)
    real(pp) :: diffusion, drop

    diffusion = (share/2*(root1**2 + root2**2) + (1 - share)*root1*root2)*per_length**2
    drop = (p1 - p2)/2*per_length**2
    leave = diffusion + drop*dm1*(share + (1 - share)*root2/root1) + max(u, 0.0_pp)*dq1*per_length
    enter = diffusion - drop*dm2*(share + (1 - share)*root1/root2) - min(u, 0.0_pp)*dq2*per_length
  end subroutine face_flow

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

  !> Restricts by full weighting at inner points; the outline is unchanged.
  subroutine restrict(fine, coarse)
    real(pp), intent(in) :: fine(:, :)
    real(pp), intent(inout) :: coarse(:, :)
    integer :: i, j, k, l

    !$omp parallel do private(i, k, l) schedule(static)
    do j = 2, size(coarse, 2) - 1
      l = 2*j - 1
      do i = 2, size(coarse, 1) - 1
        k = 2*i - 1
        coarse(i, j) = fine(k, l)/4 &
          + (fine(k - 1, l) + fine(k + 1, l) + fine(k, l - 1) + fine(k, l + 1))/8 &
          + (fine(k - 1, l - 1) + fine(k + 1, l - 1) + fine(k - 1, l + 1) + fine(k + 1, l + 1))/16
      end do
    end do
  end subroutine restrict

end module multigrid
