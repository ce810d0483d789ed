!> An approximate solve of the linearised Reynolds equation, by one multigrid V-cycle on a local model.
!>
!> The model keeps the five nearest points: diffusion as it is, first-order upwind wedge, and the deflection
!> kernel cut down to a multiple of its centre value. Alternating line Gauss-Seidel, swept downstream, smooths;
!> the coarsest grid is solved by band LU. It preconditions the exact system and decides only how fast that
!> converges, not what to.
module multigrid
  use kinds, only: wp
  use lapack, only: dgbtrf, dgbtrs
  use line_smoother, only: lines, factor_lines, sweep_lines
  use reynolds, only: film_fields, film_grid
  use status, only: status_ok, status_not_converged
  implicit none(type, external)
  private

  public :: film_multigrid, new_film_multigrid, set_film_multigrid, film_cycle

  !> The kernel's stand-in, in units of its centre value: its nearest neighbours count too.
  real(wp), parameter, public :: kernel_share = 4.0_wp
  !> Coarsening ends where a direction has at most this many points.
  integer, parameter :: coarsest_points = 12

  type :: grid_level
    integer :: nx = 0, ny = 0
    real(wp) :: dx = 0, dy = 0
    !> Deflection [m/Pa] of a node by its own pressure.
    real(wp) :: centre = 0
    !> Entrainment at faces and what the model needs at nodes.
    real(wp), allocatable :: u(:, :), v(:, :)
    real(wp), allocatable :: p(:, :), m(:, :), m_p(:, :), m_h(:, :), q_p(:, :), q_h(:, :)
    !> True where pressure is free to change.
    logical, allocatable :: free(:, :)
    !> Five-point matrix: centre, west, east, south, north.
    real(wp), allocatable :: c(:, :), w(:, :), e(:, :), s(:, :), n(:, :)
    type(lines) :: along_x, along_y
    !> Solution, right-hand side, residual; solution and right-hand side transposed.
    real(wp), allocatable :: x(:, :), f(:, :), r(:, :), xt(:, :), ft(:, :)
    !> Whether oil moves towards rising x and y, on the whole.
    logical :: rising_x = .true., rising_y = .true.
  end type grid_level

  type :: film_multigrid
    type(grid_level), allocatable :: level(:)
    !> Band LU factors of the coarsest grid.
    real(wp), allocatable :: band(:, :)
    integer, allocatable :: pivots(:)
  end type film_multigrid

contains

  !> Levels of a grid; `centre` [m/Pa] is its kernel's centre value.
  subroutine new_film_multigrid(grid, centre, self)
    type(film_grid), intent(in) :: grid
    real(wp), intent(in) :: centre
    type(film_multigrid), intent(out) :: self
    integer :: levels, nx, ny, l

    levels = 1
    nx = grid%nx
    ny = grid%ny
    do while (mod(nx, 2) == 1 .and. mod(ny, 2) == 1 .and. min(nx, ny) > coarsest_points)
      nx = (nx + 1)/2
      ny = (ny + 1)/2
      levels = levels + 1
    end do
    allocate (self%level(levels))
    nx = grid%nx
    ny = grid%ny
    do l = 1, levels
      associate (level => self%level(l))
        level%nx = nx
        level%ny = ny
        level%dx = grid%dx*2**(l - 1)
        level%dy = grid%dy*2**(l - 1)
        level%centre = centre*2**(l - 1)
        allocate (level%u(nx, ny), level%v(nx, ny), level%p(nx, ny), level%m(nx, ny), level%m_p(nx, ny), &
          level%m_h(nx, ny), level%q_p(nx, ny), level%q_h(nx, ny), level%free(nx, ny), level%c(nx, ny), &
          level%w(nx, ny), level%e(nx, ny), level%s(nx, ny), level%n(nx, ny), level%x(nx, ny), &
          level%f(nx, ny), level%r(nx, ny), level%xt(ny, nx), level%ft(ny, nx))
        if (l == 1) then
          level%u = grid%u
          level%v = grid%v
        else
          call coarsen_entrainment(self%level(l - 1), level)
        end if
        level%rising_x = sum(level%u) >= 0
        level%rising_y = sum(level%v) >= 0
      end associate
      nx = (nx + 1)/2
      ny = (ny + 1)/2
    end do
  end subroutine new_film_multigrid

  !> Entrainment at coarse faces: the mean of the two fine faces that they span.
  pure subroutine coarsen_entrainment(fine, coarse)
    type(grid_level), intent(in) :: fine
    type(grid_level), intent(inout) :: coarse
    integer :: i, j

    do j = 1, coarse%ny
      do i = 1, coarse%nx
        coarse%u(i, j) = (fine%u(2*i - 1, 2*j - 1) + fine%u(min(2*i, fine%nx), 2*j - 1))/2
        coarse%v(i, j) = (fine%v(2*i - 1, 2*j - 1) + fine%v(2*i - 1, min(2*j, fine%ny)))/2
      end do
    end do
  end subroutine coarsen_entrainment

  !> Rebuilds every level about the present fields; `free` is true where pressure may change.
  subroutine set_film_multigrid(self, fields, free, stat)
    type(film_multigrid), intent(inout) :: self
    type(film_fields), intent(in) :: fields
    logical, intent(in) :: free(:, :)
    integer, intent(out) :: stat
    integer :: l

    associate (finest => self%level(1))
      finest%p = fields%p
      finest%m = fields%mobility
      finest%m_p = fields%mobility_p
      finest%m_h = fields%mobility_h
      finest%q_p = fields%rho_p*fields%h
      finest%q_h = fields%rho
      finest%free = free
    end associate
    do l = 1, size(self%level)
      if (l > 1) call coarsen_fields(self%level(l - 1), self%level(l))
      call set_matrix(self%level(l))
      if (l < size(self%level)) call factor_level(self%level(l))
    end do
    call factor_coarsest(self, stat)
  end subroutine set_film_multigrid

  !> Mobility by full weighting, all else by injection.
  pure subroutine coarsen_fields(fine, coarse)
    type(grid_level), intent(in) :: fine
    type(grid_level), intent(inout) :: coarse

    coarse%p = fine%p(::2, ::2)
    coarse%m_p = fine%m_p(::2, ::2)
    coarse%m_h = fine%m_h(::2, ::2)
    coarse%q_p = fine%q_p(::2, ::2)
    coarse%q_h = fine%q_h(::2, ::2)
    coarse%free = fine%free(::2, ::2)
    coarse%m = fine%m(::2, ::2)
    call restrict(fine%m, coarse%m)
  end subroutine coarsen_fields

  !> The five-point matrix of the local model; rows where pressure is not free are those of the identity.
  pure subroutine set_matrix(level)
    type(grid_level), intent(inout) :: level
    real(wp) :: centre, west, east, south, north
    integer :: i, j

    level%c = 1
    level%w = 0
    level%e = 0
    level%s = 0
    level%n = 0
    do j = 2, level%ny - 1
      do i = 2, level%nx - 1
        if (.not. level%free(i, j)) cycle
        centre = 0
        call couple(level, i, j, i + 1, j, 1/level%dx, level%u(i, j), centre, east)
        call couple(level, i, j, i - 1, j, 1/level%dx, -level%u(i - 1, j), centre, west)
        call couple(level, i, j, i, j + 1, 1/level%dy, level%v(i, j), centre, north)
        call couple(level, i, j, i, j - 1, 1/level%dy, -level%v(i, j - 1), centre, south)
        level%c(i, j) = centre
        level%w(i, j) = west
        level%e(i, j) = east
        level%s(i, j) = south
        level%n(i, j) = north
      end do
    end do
  end subroutine set_matrix

  !> Flow from node (i, j) to its neighbour (k, l), `outward` being the entrainment towards the neighbour.
  pure subroutine couple(level, i, j, k, l, per_length, outward, centre, neighbour)
    type(grid_level), intent(in) :: level
    integer, intent(in) :: i, j, k, l
    real(wp), intent(in) :: per_length, outward
    real(wp), intent(inout) :: centre
    real(wp), intent(out) :: neighbour
    real(wp) :: diffusion, drop, share

    share = kernel_share*level%centre
    diffusion = (level%m(i, j) + level%m(k, l))/2*per_length**2
    drop = (level%p(i, j) - level%p(k, l))/2*per_length**2
    centre = centre + diffusion + drop*(level%m_p(i, j) + level%m_h(i, j)*share)
    neighbour = -diffusion
    if (level%free(k, l)) neighbour = neighbour + drop*(level%m_p(k, l) + level%m_h(k, l)*share)
    if (outward > 0) then
      centre = centre + outward*(level%q_p(i, j) + level%q_h(i, j)*share)*per_length
    else
      neighbour = neighbour + outward*(level%q_p(k, l) + level%q_h(k, l)*share)*per_length
    end if
  end subroutine couple

  pure subroutine factor_level(level)
    type(grid_level), intent(inout) :: level

    call factor_lines(level%w, level%c, level%e, level%s, level%n, level%along_x)
    call factor_lines(transpose(level%s), transpose(level%c), transpose(level%n), transpose(level%w), &
      transpose(level%e), level%along_y)
  end subroutine factor_level

  subroutine factor_coarsest(self, stat)
    type(film_multigrid), intent(inout) :: self
    integer, intent(out) :: stat
    integer :: i, j, row, nx, points, info, diagonal

    associate (level => self%level(size(self%level)))
      nx = level%nx
      points = nx*level%ny
      diagonal = 2*nx + 1
      if (.not. allocated(self%band)) allocate (self%band(3*nx + 1, points), self%pivots(points))
      self%band = 0
      ! LAPACK's band storage: element (row, column) stands at (diagonal + row - column, column)
      do j = 1, level%ny
        do i = 1, nx
          row = i + nx*(j - 1)
          self%band(diagonal, row) = level%c(i, j)
          if (i > 1) self%band(diagonal + 1, row - 1) = level%w(i, j)
          if (i < nx) self%band(diagonal - 1, row + 1) = level%e(i, j)
          if (j > 1) self%band(diagonal + nx, row - nx) = level%s(i, j)
          if (j < level%ny) self%band(diagonal - nx, row + nx) = level%n(i, j)
        end do
      end do
      call dgbtrf(points, points, nx, nx, self%band, 3*nx + 1, self%pivots, info)
    end associate
    stat = merge(status_ok, status_not_converged, info == 0)
  end subroutine factor_coarsest

  !> x approximates the solution for the right-hand side f; zero where pressure is not free.
  subroutine film_cycle(self, f, x)
    type(film_multigrid), intent(inout) :: self
    real(wp), intent(in) :: f(:, :)
    real(wp), intent(out) :: x(:, :)

    self%level(1)%f = merge(f, 0.0_wp, self%level(1)%free)
    call cycle_from(self, 1)
    x = self%level(1)%x
  end subroutine film_cycle

  recursive subroutine cycle_from(self, l)
    type(film_multigrid), intent(inout) :: self
    integer, intent(in) :: l

    if (l == size(self%level)) then
      call solve_coarsest(self)
      return
    end if
    self%level(l)%x = 0
    call smooth(self%level(l))
    call residual(self%level(l))
    call restrict(self%level(l)%r, self%level(l + 1)%f)
    where (.not. self%level(l + 1)%free) self%level(l + 1)%f = 0
    call cycle_from(self, l + 1)
    call add_prolonged(self%level(l + 1)%x, self%level(l)%free, self%level(l)%x)
    call smooth(self%level(l))
  end subroutine cycle_from

  subroutine smooth(level)
    type(grid_level), intent(inout) :: level

    level%xt = transpose(level%x)
    level%ft = transpose(level%f)
    call sweep_lines(level%along_y, level%ft, level%rising_x, level%xt)
    level%x = transpose(level%xt)
    call sweep_lines(level%along_x, level%f, level%rising_y, level%x)
  end subroutine smooth

  subroutine residual(level)
    type(grid_level), intent(inout) :: level
    integer :: i, j

    level%r = 0
    do j = 2, level%ny - 1
      do i = 2, level%nx - 1
        level%r(i, j) = level%f(i, j) - level%c(i, j)*level%x(i, j) &
          - level%w(i, j)*level%x(i - 1, j) - level%e(i, j)*level%x(i + 1, j) &
          - level%s(i, j)*level%x(i, j - 1) - level%n(i, j)*level%x(i, j + 1)
      end do
    end do
  end subroutine residual

  subroutine solve_coarsest(self)
    type(film_multigrid), intent(inout) :: self
    real(wp), allocatable :: b(:, :)
    integer :: info, points

    associate (level => self%level(size(self%level)))
      points = level%nx*level%ny
      b = reshape(level%f, [points, 1])
      call dgbtrs("N", points, level%nx, level%nx, 1, self%band, 3*level%nx + 1, self%pivots, b, points, info)
      level%x = reshape(b, [level%nx, level%ny])
    end associate
  end subroutine solve_coarsest

  !> Full weighting at inner points; the outline keeps what it has.
  pure subroutine restrict(fine, coarse)
    real(wp), intent(in) :: fine(:, :)
    real(wp), intent(inout) :: coarse(:, :)
    integer :: i, j, k, l

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

  !> Adds the bilinear interpolant of the coarse field where pressure is free.
  pure subroutine add_prolonged(coarse, free, fine)
    real(wp), intent(in) :: coarse(:, :)
    logical, intent(in) :: free(:, :)
    real(wp), intent(inout) :: fine(:, :)
    real(wp) :: row(size(coarse, 1))
    integer :: i, j, k, n

    n = size(coarse, 1)
    do j = 1, size(fine, 2)
      k = (j + 1)/2
      if (mod(j, 2) == 1) then
        row = coarse(:, k)
      else
        row = (coarse(:, k) + coarse(:, k + 1))/2
      end if
      do i = 1, n
        if (free(2*i - 1, j)) fine(2*i - 1, j) = fine(2*i - 1, j) + row(i)
      end do
      do i = 1, n - 1
        if (free(2*i, j)) fine(2*i, j) = fine(2*i, j) + (row(i) + row(i + 1))/2
      end do
    end do
  end subroutine add_prolonged

end module multigrid
