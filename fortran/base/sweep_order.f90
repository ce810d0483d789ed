!> Fields in the order of a sweep along the oil's flow: the nodes of a line contiguous in memory, the lines in the order in
!> which oil reaches them. Lines lie across the main direction of the entrainment.
module pyworm_sweep_order
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: sweep_frame, new_sweep_frame, to_sweep, from_sweep, grid_node

  !> Nodes copied together in each direction, so that both sides of a transposition stay in cache.
  integer, parameter :: block = 16

  type :: sweep_frame
    !> Whether lines are columns of constant x, swept along x; whether they are swept against their axis.
    logical :: along_x = .false., backward = .false.
    !> Numbers of nodes of a line and of lines.
    integer :: length = 0, lines = 0
    !> Reciprocal spacing of the nodes on a line, and of the lines, negative if these are swept against their axis [1/m].
    real(wp) :: per_node = 0, per_line = 0
  end type sweep_frame

contains

  !> Order of a sweep over nx by ny nodes, dx and dy apart [m].
  pure type(sweep_frame) function new_sweep_frame(nx, ny, dx, dy, along_x, backward)
    integer, intent(in) :: nx, ny
    real(wp), intent(in) :: dx, dy
    logical, intent(in) :: along_x, backward

    new_sweep_frame%along_x = along_x
    new_sweep_frame%backward = backward
    new_sweep_frame%length = merge(ny, nx, along_x)
    new_sweep_frame%lines = merge(nx, ny, along_x)
    new_sweep_frame%per_node = 1/merge(dy, dx, along_x)
    new_sweep_frame%per_line = merge(-1, 1, backward)/merge(dx, dy, along_x)
  end function new_sweep_frame

  !> Copies a field from the grid, (nx, ny), to the order of the sweep, (length, lines).
  subroutine to_sweep(way, field, swept)
    type(sweep_frame), intent(in) :: way
    real(wp), intent(in) :: field(:, :)
    real(wp), intent(inout) :: swept(:, :)
    integer :: first, nodes, line, node

    if (.not. way%along_x) then
      !$omp parallel do schedule(static)
      do line = 1, way%lines
        swept(:, line) = field(:, place(way, line))
      end do
      return
    end if
    !$omp parallel do private(nodes, line, node) schedule(static)
    do first = 1, way%lines, block
      do nodes = 1, way%length, block
        do line = first, min(first + block - 1, way%lines)
          do node = nodes, min(nodes + block - 1, way%length)
            swept(node, line) = field(place(way, line), node)
          end do
        end do
      end do
    end do
  end subroutine to_sweep

  !> Copies a field from the order of the sweep, (length, lines), to the grid, (nx, ny).
  subroutine from_sweep(way, swept, field)
    type(sweep_frame), intent(in) :: way
    real(wp), intent(in) :: swept(:, :)
    real(wp), intent(inout) :: field(:, :)
    integer :: first, lines, line, node

    if (.not. way%along_x) then
      !$omp parallel do schedule(static)
      do line = 1, way%lines
        field(:, place(way, line)) = swept(:, line)
      end do
      return
    end if
    !$omp parallel do private(lines, line, node) schedule(static)
    do first = 1, way%length, block
      do lines = 1, way%lines, block
        do node = first, min(first + block - 1, way%length)
          do line = lines, min(lines + block - 1, way%lines)
            field(place(way, line), node) = swept(node, line)
          end do
        end do
      end do
    end do
  end subroutine from_sweep

  !> Number of a line's node among those of the grid, along x first.
  pure integer function grid_node(way, node, line)
    type(sweep_frame), intent(in) :: way
    integer, intent(in) :: node, line

    grid_node = merge(place(way, line) + (node - 1)*way%lines, node + (place(way, line) - 1)*way%length, way%along_x)
  end function grid_node

  !> Index on the grid of a line of the sweep.
  pure integer function place(way, line)
    type(sweep_frame), intent(in) :: way
    integer, intent(in) :: line

    place = merge(way%lines + 1 - line, line, way%backward)
  end function place

end module pyworm_sweep_order
