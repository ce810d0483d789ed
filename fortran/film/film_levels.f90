!> A grid of the film's multigrid and the local model of the linearised Reynolds equation on it.
!>
!> The model couples the five nearest points: diffusion, first-order upwind wedge, and the deflection kernel replaced by a
!> multiple of its centre value. Fields have the direction of the lines that the cycle solves as their first
!> index, (length, count): they are those of the film, transposed if the entrainment is mainly along x.
module pyworm_film_levels
  use pyworm_kinds, only: pp, wp
  use pyworm_film_model, only: film_model
  use pyworm_line_relaxation, only: line_systems, new_line_systems
  use pyworm_reynolds, only: arithmetic_share, film_fields, film_grid
  use pyworm_sheared_couplings, only: couple_row
  use pyworm_status, only: status_ok, status_no_memory
  implicit none(type, external)
  private

  public :: grid_level, new_level, coarsen_entrainment, set_level, set_mobility, model_line, leaving_rate, orient

  !> Local stand-in for the kernel of the deflection over its centre value: it includes the nearest neighbours.
  real(pp), parameter :: kernel_factor = 4.0_pp

  type :: grid_level
    !> Whether lines run along y, across an entrainment along x.
    logical :: transposed = .false.
    !> Spacing over that of the film's grid; points along a line and lines; spacing [m] along a line and between lines.
    integer :: stride = 1, length = 0, count = 0
    real(pp) :: d_along = 0, d_across = 0
    !> Deflection [m/Pa] under a node's pressure in place of the kernel.
    real(pp) :: compliance = 0
    !> Entrainment through the face after a node, along the line and towards the next line [m/s].
    real(pp), allocatable :: along(:, :), across(:, :)
    !> Root of the mobility, pressure, and 1 where it is free to change, else 0.
    real(pp), allocatable :: root(:, :), p(:, :), free(:, :)
    !> 1 where the gap is filled in part: what pressure presses into such a node goes on downstream. Not allocated where it is
    !> full everywhere.
    real(pp), allocatable :: passing(:, :)
    type(line_systems) :: lines
    !> Solution and right-hand side. While a level is built: derivatives of mobility and of
    !> rho h by pressure.
    real(pp), allocatable :: x(:, :), f(:, :)
  end type grid_level

contains

  !> Makes the grid of every `stride`-th node of the film's; `centre` [m/Pa] is the centre value of the deflection's kernel.
  subroutine new_level(grid, transposed, stride, centre, level, stat)
    type(film_grid), intent(in) :: grid
    logical, intent(in) :: transposed
    integer, intent(in) :: stride
    real(wp), intent(in) :: centre
    type(grid_level), intent(out) :: level
    integer, intent(out) :: stat
    integer :: n, m, err

    level%transposed = transposed
    level%stride = stride
    n = (merge(grid%ny, grid%nx, transposed) - 1)/stride + 1
    m = (merge(grid%nx, grid%ny, transposed) - 1)/stride + 1
    level%length = n
    level%count = m
    level%d_along = real(merge(grid%dy, grid%dx, transposed)*stride, pp)
    level%d_across = real(merge(grid%dx, grid%dy, transposed)*stride, pp)
    level%compliance = kernel_factor*real(centre*stride, pp)
    allocate (level%along(n, m), level%across(n, m), level%root(n, m), level%p(n, m), level%free(n, m), level%x(n, m), &
      level%f(n, m), source=0.0_pp, stat=err)
    stat = status_no_memory
    if (err == 0) call new_line_systems(n, m, level%lines, stat)
  end subroutine new_level

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

  !> Sets the change of rho h by (total) pressure, where pressure is free to change, and how far the gap is filled.
  subroutine set_level(level, model, free)
    type(grid_level), intent(inout) :: level
    type(film_model), intent(in) :: model
    logical, intent(in) :: free(:, :)
    real(wp), allocatable :: fraction(:, :)

    associate (stride => level%stride, fields => model%fields)
      if (model%is_partial()) then
        fraction = reshape(model%partial%fraction, [model%partial%nx, model%partial%ny])
        if (.not. allocated(level%passing)) allocate (level%passing, mold=level%free)
        call orient(level%transposed, merge(1.0_wp, 0.0_wp, fraction(::stride, ::stride) < 1), level%passing)
      end if
      if (fields%is_rough()) then
        associate (stiffness => fields%rough%stiffness(::stride, ::stride), widening => fields%rough%widening(::stride, ::stride))
          call orient(level%transposed, fields%rho_p(::stride, ::stride)*fields%h(::stride, ::stride) &
            *(1 + level%compliance*stiffness) + level%compliance*fields%rho(::stride, ::stride)*widening, level%f)
        end associate
      else
        call orient(level%transposed, fields%rho_p(::stride, ::stride)*fields%h(::stride, ::stride) &
          + level%compliance*fields%rho(::stride, ::stride), level%f)
      end if
      call orient(level%transposed, merge(1.0_wp, 0.0_wp, free(::stride, ::stride)), level%free)
    end associate
  end subroutine set_level

  !> Sets the root of the mobility and its slope, and the pressure, of a film that is isothermal and Newtonian. The mobility
  !> is a mean about the nodes of the next finer grid, if there is one.
  subroutine set_mobility(level, fields, finer)
    type(grid_level), intent(inout) :: level
    type(film_fields), intent(in) :: fields
    type(grid_level), intent(in), optional :: finer

    associate (stride => level%stride)
      call orient(level%transposed, fields%p(::stride, ::stride), level%p)
      call orient(level%transposed, fields%mobility_p(::stride, ::stride) &
        + level%compliance*fields%mobility_h(::stride, ::stride), level%x)
    end associate
    if (present(finer)) then
      level%root = finer%root(::2, ::2)**2
      call restrict(finer%root**2, level%root)
      level%root = sqrt(level%root)
    else
      call orient(level%transposed, sqrt(fields%mobility), level%root)
    end if
    ! ratios of roots must be finite
    level%root = max(level%root, tiny(level%root))
  end subroutine set_mobility

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

  !> Computes the model's row of each node of line j: coefficients of the node, of its neighbours within the line, and of
  !> those in the line before and after. `implicit_rate` is that of `film_grid`.
  subroutine model_line(level, j, implicit_rate, model, centre, left, right, before, after)
    type(grid_level), intent(in) :: level
    integer, intent(in) :: j
    real(pp), intent(in) :: implicit_rate
    type(film_model), intent(in) :: model
    real(pp), dimension(level%length), intent(out) :: centre, left, right, before, after
    real(pp), dimension(level%length) :: leave, enter
    integer :: i, n

    n = level%length
    associate (free => level%free, dq => level%f)
      ! through the faces within the line: outflow by a node's pressure, inflow by the next one's
      call couple(level, j, .false., leave, enter, model)
      do i = 2, n - 1
        centre(i) = implicit_rate*dq(i, j) + leave(i) + enter(i - 1)
        right(i) = -free(i, j)*enter(i)*free(i + 1, j)
        left(i) = -free(i, j)*leave(i - 1)*free(i - 1, j)
      end do
      ! through the faces towards the next line, and from the one before
      call couple(level, j, .true., leave, enter, model)
      do i = 2, n - 1
        centre(i) = centre(i) + leave(i)
        after(i) = -free(i, j)*enter(i)*free(i, j + 1)
      end do
      call couple(level, j - 1, .true., leave, enter, model)
      do i = 2, n - 1
        centre(i) = merge(centre(i) + enter(i), 1.0_pp, free(i, j) > 0)
        before(i) = -free(i, j)*leave(i)*free(i, j - 1)
      end do
    end associate
  end subroutine model_line

  !> Computes the couplings through the faces between the nodes of line j and those of the next line, `across`, or of the same
  !> one: outflow by the pressure of the node before, `leave`, and inflow by that of the node after, `enter`. Nodes without
  !> such a face, and the ends of lines towards the next, are left as they are.
  subroutine couple(level, j, across, leave, enter, model)
    type(grid_level), intent(in) :: level
    integer, intent(in) :: j
    logical, intent(in) :: across
    real(pp), intent(inout) :: leave(level%length), enter(level%length)
    type(film_model), intent(in) :: model
    real(pp) :: spacing
    integer :: first, last, start(2), step(2)

    first = merge(2, 1, across)
    last = level%length - 1
    spacing = merge(level%d_across, level%d_along, across)
    associate (root => level%root, p => level%p, dm => level%x, dq => level%f, i => first + merge(0, 1, across), &
        n => last + merge(0, 1, across), k => j + merge(1, 0, across))
      if (model%is_sheared()) then
        start = merge([j, first], [first, j], level%transposed)
        step = merge([0, 1], [1, 0], level%transposed)
        if (across .neqv. level%transposed) then
          call couple_row(model%shear%along_y, level%stride, start, step, [0, 1], spacing, level%compliance, &
            leave(first:last), enter(first:last), model%fields%rough)
        else
          call couple_row(model%shear%along_x, level%stride, start, step, [1, 0], spacing, level%compliance, &
            leave(first:last), enter(first:last), model%fields%rough)
        end if
      else
        call diffuse(root(first:last, j), root(i:n, k), p(first:last, j), p(i:n, k), dm(first:last, j), dm(i:n, k), 1/spacing, &
          leave(first:last), enter(first:last))
      end if
      if (allocated(level%passing)) then
        if (across) then
          call return_passed(level%passing(first:last, j), level%passing(i:n, k), level%across(first:last, j), &
            leave(first:last), enter(first:last))
        else
          call return_passed(level%passing(first:last, j), level%passing(i:n, k), level%along(first:last, j), &
            leave(first:last), enter(first:last))
        end if
      end if
      if (across) then
        call carry(dq(first:last, j), dq(i:n, k), level%across(first:last, j), 1/spacing, leave(first:last), enter(first:last))
      else
        call carry(dq(first:last, j), dq(i:n, k), level%along(first:last, j), 1/spacing, leave(first:last), enter(first:last))
      end if
    end associate
  end subroutine couple

  !> Computes the couplings by diffusion through the face between nodes 1 and 2, from the root of their mobility, its change
  !> `dm` by pressure, and the pressures.
  elemental subroutine diffuse(root1, root2, p1, p2, dm1, dm2, per_length, leave, enter)
    real(pp), intent(in) :: root1, root2, p1, p2, dm1, dm2, per_length
    real(pp), intent(out) :: leave, enter
    real(pp), parameter :: share = real(arithmetic_share, pp)
    real(pp) :: diffusion, drop

    diffusion = (share/2*(root1**2 + root2**2) + (1 - share)*root1*root2)*per_length**2
    drop = (p1 - p2)/2*per_length**2
    leave = diffusion + drop*dm1*(share + (1 - share)*root2/root1)
    enter = diffusion - drop*dm2*(share + (1 - share)*root1/root2)
  end subroutine diffuse

  !> Removes the couplings by diffusion through a face that oil enters from a gap filled in part: what pressure presses back
  !> comes with the wedge again.
  elemental subroutine return_passed(passing1, passing2, u, leave, enter)
    real(pp), intent(in) :: passing1, passing2, u
    real(pp), intent(inout) :: leave, enter

    if (merge(passing1, passing2, u > 0) > 0) then
      leave = 0
      enter = 0
    end if
  end subroutine return_passed

  !> Adds the couplings by the wedge, upwind to first order; `dq` is the change of rho h by pressure.
  elemental subroutine carry(dq1, dq2, u, per_length, leave, enter)
    real(pp), intent(in) :: dq1, dq2, u, per_length
    real(pp), intent(inout) :: leave, enter

    leave = leave + max(u, 0.0_pp)*dq1*per_length
    enter = enter - min(u, 0.0_pp)*dq2*per_length
  end subroutine carry

  !> Rate at which the wedge takes rho h from node i of line j [1/s].
  elemental real(pp) function leaving_rate(level, i, j)
    type(grid_level), intent(in) :: level
    integer, intent(in) :: i, j

    leaving_rate = (max(level%along(i, j), 0.0_pp) - min(level%along(i - 1, j), 0.0_pp))/level%d_along &
      + (max(level%across(i, j), 0.0_pp) - min(level%across(i, j - 1), 0.0_pp))/level%d_across
  end function leaving_rate

  !> Copies a film's field to the order of a level.
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

end module pyworm_film_levels
