!> Flow through a periodic gap: the factors of its averaged Reynolds equation.
!>
!> With chi_j the answer of the pressure to a mean gradient along j, div(a^3 (e_j + grad chi_j)) = 0 in the cell, the gap
!> conducts PHI_ij h^3 = <a^3 (delta_ij + d chi_j/dx_i)>, and a wall that drags its own roughness along carries
!> <a (delta_ij + d chi_j/dx_i)>: what that is less than the mean gap, the shear flow factor brings (homogenisation,
!> Bayada and Chambat 1988, J. Tribol. 110:402; both need the same chi, as the problem of shear flow is adjoint to it).
!>
!> Control volumes about nodes. The mobility of a face is the harmonic mean of its nodes', as of two slots in a row, and the gap
!> of a face that at which a row of nodes carries what the closed form has: ridges along and across are exact up to the
!> integral over nodes. Conjugate gradients are preconditioned with a W cycle over cells of two by two, between which pressure
!> is constant; that is twice too stiff, hence half the conductance on the coarser grid (Braess 1995, Computing 55:379).
module pyworm_cell_flow
  use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
  use pyworm_interruption, only: interrupted
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_bad_argument, status_interrupted, status_no_memory, status_not_converged, &
    status_not_finite
  implicit none(type, external)
  private

  public :: flow_through

  !> Sweeps on the coarsest grid; smallest grid that is still made; cycles on a coarser grid for each on a finer.
  integer, parameter :: coarsest_sweeps = 20, smallest = 4, cycles = 2

  !> One grid: conductances of the faces to the east and north of each node, the sum of all four and its inverse, and fields.
  type :: flow_grid
    integer :: nx = 0, ny = 0
    real(wp), allocatable :: east(:, :), north(:, :), total(:, :), inverse(:, :), x(:, :), b(:, :), r(:, :)
  end type flow_grid

contains

  !> Computes what a gap a [m] > 0 conducts [m3] and carries with a wall [m]; both in the order xx, yy, xy.
  !>
  !> Nodes are dx and dy [m] apart, an even number of them a side. Converged when the preconditioned residual is `tolerance`
  !> of the first.
  subroutine flow_through(a, dx, dy, tolerance, most_iterations, conducted, carried, iterations, stat)
    real(wp), contiguous, intent(in) :: a(:, :)
    real(wp), intent(in) :: dx, dy, tolerance
    integer, intent(in) :: most_iterations
    real(wp), intent(out) :: conducted(3), carried(3)
    integer, intent(out) :: iterations, stat
    type(flow_grid), allocatable :: grids(:)
    real(wp), allocatable :: mobility(:, :, :), gap(:, :, :), chi(:, :)
    real(wp) :: pressure(2, 2), drag(2, 2)
    integer :: j, count, err

    conducted = 0
    carried = 0
    iterations = 0
    stat = status_bad_argument
    associate (nx => size(a, 1), ny => size(a, 2))
      if (min(nx, ny) < smallest .or. .not. (dx > 0 .and. dy > 0 .and. tolerance > 0)) return
      stat = status_not_finite
      if (.not. all(ieee_is_finite(a))) return
      stat = status_bad_argument
      if (.not. all(a > 0)) return
      stat = status_no_memory
      allocate (mobility(nx, ny, 2), gap(nx, ny, 2), chi(nx, ny), stat=err)
      if (err /= 0) return
    end associate
    call faces(a, 1, mobility(:, :, 1), gap(:, :, 1))
    call faces(a, 2, mobility(:, :, 2), gap(:, :, 2))
    call new_grids(mobility(:, :, 1)*(dy/dx), mobility(:, :, 2)*(dx/dy), grids, stat)
    if (stat /= status_ok) return

    do j = 1, 2
      ! of a gradient of one over a step
      associate (driven => mobility(:, :, j)*merge(dy, dx, j == 1))
        call solve(grids, driven - cshift(driven, -1, dim=j), tolerance, most_iterations, chi, count, stat)
      end associate
      iterations = max(iterations, count)
      if (stat /= status_ok) return
      pressure(:, j) = averages(mobility, chi, j)
      drag(:, j) = averages(gap, chi, j)
    end do
    conducted = [pressure(1, 1), pressure(2, 2), (pressure(1, 2) + pressure(2, 1))/2]
    carried = [drag(1, 1), drag(2, 2), (drag(1, 2) + drag(2, 1))/2]

  contains

    !> Averages of a factor over faces times the whole gradient, along x and y, of the answer to one along `driving`.
    function averages(factor, answer, driving) result(average)
      real(wp), intent(in) :: factor(:, :, :), answer(:, :)
      integer, intent(in) :: driving
      real(wp) :: average(2), steps(2)
      integer :: i

      steps = [dx, dy]
      do i = 1, 2
        average(i) = sum(factor(:, :, i)*(merge(1.0_wp, 0.0_wp, i == driving) &
          + (cshift(answer, 1, dim=i) - answer)/steps(i)))/size(answer)
      end do
    end function averages

  end subroutine flow_through

  !> Mobility [m3] and gap [m] of the faces behind each node along a dimension.
  pure subroutine faces(a, along, mobility, gap)
    real(wp), intent(in) :: a(:, :)
    integer, intent(in) :: along
    real(wp), intent(out) :: mobility(:, :), gap(:, :)
    real(wp) :: next(size(a, 1), size(a, 2)), ratio(size(a, 1), size(a, 2))

    ! two halves in series: the harmonic mean of the cubes, and the gap that a wall's drag sees through both;
    ! in the smaller gap and its ratio to the larger, so that no power overflows
    next = cshift(a, 1, dim=along)
    ratio = min(a, next)/max(a, next)
    mobility = min(a, next)**3*(2/(1 + ratio**3))
    gap = min(a, next)*((1 + ratio**2)/(1 + ratio**3))
  end subroutine faces

  !> Makes the grids, the finest first; each is half the one before as long as that has an even number of nodes.
  subroutine new_grids(east, north, grids, stat)
    real(wp), intent(in) :: east(:, :), north(:, :)
    type(flow_grid), allocatable, intent(out) :: grids(:)
    integer, intent(out) :: stat
    integer :: nx, ny, count, k, err

    nx = size(east, 1)
    ny = size(east, 2)
    count = 1
    do while (mod(nx, 2) == 0 .and. mod(ny, 2) == 0 .and. min(nx, ny) >= 2*smallest)
      nx = nx/2
      ny = ny/2
      count = count + 1
    end do
    stat = status_no_memory
    allocate (grids(count), stat=err)
    if (err /= 0) return
    do k = 1, count
      nx = size(east, 1)/2**(k - 1)
      ny = size(east, 2)/2**(k - 1)
      associate (grid => grids(k))
        grid%nx = nx
        grid%ny = ny
        allocate (grid%east(nx, ny), grid%north(nx, ny), grid%total(nx, ny), grid%inverse(nx, ny), &
          grid%x(nx, ny), grid%b(nx, ny), grid%r(nx, ny), source=0.0_wp, stat=err)
        if (err /= 0) return
        if (k == 1) then
          grid%east = east
          grid%north = north
        else
          associate (finer => grids(k - 1))
            grid%east = (finer%east(2::2, 1::2) + finer%east(2::2, 2::2))/2
            grid%north = (finer%north(1::2, 2::2) + finer%north(2::2, 2::2))/2
          end associate
        end if
        grid%total = grid%east + cshift(grid%east, -1, dim=1) + grid%north + cshift(grid%north, -1, dim=2)
        grid%inverse = 1/grid%total
      end associate
    end do
    stat = status_ok
  end subroutine new_grids

  !> Solves the finest grid's equations, net outflow x = b, by conjugate gradients.
  subroutine solve(grids, b, tolerance, most_iterations, x, iterations, stat)
    type(flow_grid), intent(inout) :: grids(:)
    real(wp), intent(in) :: b(:, :), tolerance
    integer, intent(in) :: most_iterations
    real(wp), intent(out) :: x(:, :)
    integer, intent(out) :: iterations, stat
    real(wp), allocatable :: r(:, :), z(:, :), d(:, :), q(:, :)
    real(wp) :: norm, last_norm, first, step
    integer :: err

    x = 0
    iterations = 0
    stat = status_no_memory
    allocate (r(size(b, 1), size(b, 2)), source=b, stat=err)
    if (err == 0) allocate (z, d, q, mold=r, stat=err)
    if (err /= 0) return
    first = 0
    last_norm = 1
    d = 0
    do iterations = 0, most_iterations
      call precondition(grids, r, z)
      norm = sum(r*z)
      if (.not. ieee_is_finite(norm)) then
        stat = status_not_finite
        return
      end if
      first = max(first, norm)
      if (abs(norm) <= tolerance**2*first) then
        stat = status_ok
        return
      end if
      ! rounding has spoilt the residual
      if (iterations == most_iterations .or. norm < 0) exit
      if (interrupted()) then
        stat = status_interrupted
        return
      end if
      d = z + (norm/last_norm)*d
      if (iterations == 0) d = z
      last_norm = norm
      call outflow(grids(1), d, q)
      step = norm/sum(d*q)
      x = x + step*d
      r = r - step*q
    end do
    stat = status_not_converged
  end subroutine solve

  !> Net outflow q under a pressure x.
  subroutine outflow(grid, x, q)
    type(flow_grid), intent(in) :: grid
    real(wp), contiguous, intent(in) :: x(:, :)
    real(wp), contiguous, intent(out) :: q(:, :)
    integer :: i, j, west, south, east, north

    do j = 1, grid%ny
      south = merge(grid%ny, j - 1, j == 1)
      north = merge(1, j + 1, j == grid%ny)
      do i = 1, grid%nx
        west = merge(grid%nx, i - 1, i == 1)
        east = merge(1, i + 1, i == grid%nx)
        q(i, j) = grid%total(i, j)*x(i, j) - grid%east(i, j)*x(east, j) - grid%east(west, j)*x(west, j) &
          - grid%north(i, j)*x(i, north) - grid%north(i, south)*x(i, south)
      end do
    end do
  end subroutine outflow

  !> Answer z of one cycle to a residual r.
  subroutine precondition(grids, r, z)
    type(flow_grid), intent(inout) :: grids(:)
    real(wp), contiguous, intent(in) :: r(:, :)
    real(wp), contiguous, intent(out) :: z(:, :)

    grids(1)%b = r
    grids(1)%x = 0
    call cycle_down(grids, 1)
    z = grids(1)%x
  end subroutine precondition

  !> Improves the pressure x of grid k by one cycle.
  recursive subroutine cycle_down(grids, k)
    type(flow_grid), intent(inout) :: grids(:)
    integer, intent(in) :: k
    integer :: sweep_count, i, j

    if (k == size(grids)) then
      do sweep_count = 1, coarsest_sweeps
        call sweep(grids(k), 1)
        call sweep(grids(k), -1)
      end do
      return
    end if
    call sweep(grids(k), 1)
    call outflow(grids(k), grids(k)%x, grids(k)%r)
    associate (fine => grids(k), coarse => grids(k + 1))
      fine%r = fine%b - fine%r
      coarse%b = fine%r(1::2, 1::2) + fine%r(2::2, 1::2) + fine%r(1::2, 2::2) + fine%r(2::2, 2::2)
      coarse%x = 0
    end associate
    do sweep_count = 1, cycles
      call cycle_down(grids, k + 1)
    end do
    associate (fine => grids(k), coarse => grids(k + 1))
      do j = 1, fine%ny
        do i = 1, fine%nx
          fine%x(i, j) = fine%x(i, j) + coarse%x((i + 1)/2, (j + 1)/2)
        end do
      end do
    end associate
    call sweep(grids(k), -1)
  end subroutine cycle_down

  !> Relaxes node by node (Gauss and Seidel), forwards or, with `order` -1, backwards.
  subroutine sweep(grid, order)
    type(flow_grid), intent(inout) :: grid
    integer, intent(in) :: order
    integer :: i, j, west, south, east, north

    do j = merge(1, grid%ny, order > 0), merge(grid%ny, 1, order > 0), order
      south = merge(grid%ny, j - 1, j == 1)
      north = merge(1, j + 1, j == grid%ny)
      do i = merge(1, grid%nx, order > 0), merge(grid%nx, 1, order > 0), order
        west = merge(grid%nx, i - 1, i == 1)
        east = merge(1, i + 1, i == grid%nx)
        grid%x(i, j) = (grid%b(i, j) + grid%east(i, j)*grid%x(east, j) + grid%north(i, j)*grid%x(i, north) &
          + grid%north(i, south)*grid%x(i, south) + grid%east(west, j)*grid%x(west, j))*grid%inverse(i, j)
      end do
    end do
  end subroutine sweep

end module pyworm_cell_flow
