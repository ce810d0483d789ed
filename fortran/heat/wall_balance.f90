!> Temperature of the two walls of a film, in balance with the rise of the bodies by the film's heat.
!>
!> The film's flux into its walls, linearised about their present temperature, and the rise by it in the bodies
!> satisfy
!>   T_i = bulk_i + rise_i(q_i),  q_i = flux_i + sum_j admittance_ij (T_j - wall_j),
!> to which a body adds what it remembers of another flux before.
!> The film conducts heat from wall to wall three to ten times as well as a body takes it up over a lubricated
!> contact, so that fixed-point iteration between film and bodies diverges. As an integral equation of the second
!> kind it suits GMRES.
module pyworm_wall_balance
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: pp, wp
  use pyworm_krylov, only: linear_system, gmres
  use pyworm_status, only: status_ok, status_bad_argument, status_no_memory
  implicit none(type, external)
  private

  public :: bounding_body, wall_pair, new_wall_pair, balance_walls

  !> Rise of a node in the preconditioner, over that by the flux on its own cell, since neighbours heat each other.
  !> On a worm's contact the number of iterations is least from 4 to 8 and a third more with 1 or 16.
  real(wp), parameter :: neighbourhood = 4

  !> A body with the temperature [K] of its unheated surface.
  type :: bounding_body
    class(heated_body), allocatable :: surface
    real(wp) :: bulk = 0
    !> Rise by flux at other times less that by the present one at these times [K], (nx, ny); not allocated in a steady state.
    real(wp), allocatable :: remembered(:, :)
  end type bounding_body

  type, extends(linear_system) :: wall_pair
    integer :: nx = 0, ny = 0
    type(bounding_body) :: body(2)
    !> Temperature of the walls [K] and flux into the bodies [W/m2], (nx, ny, 2); derivative of flux i with
    !> respect to wall j [W/(m2 K)], (nx, ny, 2, 2).
    real(wp), allocatable :: wall(:, :, :), flux(:, :, :), admittance(:, :, :, :)
    !> Flux and rise of one wall; residual and change of both walls.
    real(wp), allocatable :: q(:, :), risen(:, :), missed(:, :, :), change(:, :, :)
    !> Krylov basis.
    real(pp), allocatable :: basis(:, :)
  contains
    procedure :: multiply
    procedure :: precondition
  end type wall_pair

contains

  !> Makes walls at the bulk temperatures [K] of `first` and `second`, which move into the pair; `most` bounds the
  !> Krylov iterations of one balance.
  subroutine new_wall_pair(self, first, first_bulk, second, second_bulk, most, stat)
    type(wall_pair), intent(inout) :: self
    class(heated_body), allocatable, intent(inout) :: first, second
    real(wp), intent(in) :: first_bulk, second_bulk
    integer, intent(in) :: most
    integer, intent(out) :: stat
    integer :: nx, ny, err

    stat = status_bad_argument
    if (most < 1 .or. .not. (allocated(first) .and. allocated(second))) return
    nx = first%nx
    ny = first%ny
    if (second%nx /= nx .or. second%ny /= ny) return
    self%nx = nx
    self%ny = ny
    call move_alloc(first, self%body(1)%surface)
    call move_alloc(second, self%body(2)%surface)
    self%body(1)%bulk = first_bulk
    self%body(2)%bulk = second_bulk
    allocate (self%wall(nx, ny, 2), self%flux(nx, ny, 2), self%admittance(nx, ny, 2, 2), self%q(nx, ny), &
      self%risen(nx, ny), self%missed(nx, ny, 2), self%change(nx, ny, 2), self%basis(2*nx*ny, most), stat=err)
    stat = status_no_memory
    if (err /= 0) return
    self%wall(:, :, 1) = first_bulk
    self%wall(:, :, 2) = second_bulk
    self%flux = 0
    self%admittance = 0
    stat = status_ok
  end subroutine new_wall_pair

  !> Moves the walls from their present temperature, at which flux and admittance are given, into balance, and
  !> updates the flux.
  !>
  !> `missed` [K] is the largest difference of the bodies' temperature from the walls' before; the balance ends at
  !> `tolerance` times that, in the mean square, or after all iterations; `reduction` is the fraction reached.
  subroutine balance_walls(self, tolerance, missed, iterations, reduction)
    type(wall_pair), target, intent(inout) :: self
    real(wp), intent(in) :: tolerance
    real(wp), intent(out) :: missed
    integer, intent(out) :: iterations
    real(wp), intent(out) :: reduction
    real(wp), contiguous, pointer :: right(:), solution(:)
    integer :: wall

    missed = 0
    do wall = 1, 2
      call self%body(wall)%surface%rise(self%flux(:, :, wall), self%missed(:, :, wall))
      self%missed(:, :, wall) = self%missed(:, :, wall) + self%body(wall)%bulk - self%wall(:, :, wall)
      if (allocated(self%body(wall)%remembered)) self%missed(:, :, wall) = self%missed(:, :, wall) &
        + self%body(wall)%remembered
    end do
    missed = maxval(abs(self%missed))
    right(1:size(self%missed)) => self%missed
    solution(1:size(self%change)) => self%change
    call gmres(self, right, tolerance, size(self%basis, 2), self%basis, solution, iterations, reduction)
    do wall = 1, 2
      call change_flux(self, wall, self%change, self%q)
      self%flux(:, :, wall) = self%flux(:, :, wall) + self%q
    end do
    self%wall = self%wall + self%change
  end subroutine balance_walls

  !> Change `q` [W/m2] of the flux into a wall when both walls change temperature.
  subroutine change_flux(self, wall, change, q)
    class(wall_pair), intent(in) :: self
    integer, intent(in) :: wall
    real(wp), intent(in) :: change(self%nx, self%ny, 2)
    real(wp), intent(out) :: q(self%nx, self%ny)
    integer :: j

    !$omp parallel do schedule(static)
    do j = 1, self%ny
      q(:, j) = self%admittance(:, j, wall, 1)*change(:, j, 1) + self%admittance(:, j, wall, 2)*change(:, j, 2)
    end do
  end subroutine change_flux

  !> Multiplies by the system: change of the walls less the rise of the bodies by it.
  subroutine multiply(self, x, y)
    class(wall_pair), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    real(wp), contiguous, pointer :: change(:, :, :), missed(:, :, :)
    integer :: wall, j

    change(1:self%nx, 1:self%ny, 1:2) => x
    missed(1:self%nx, 1:self%ny, 1:2) => y
    do wall = 1, 2
      call change_flux(self, wall, change, self%q)
      call self%body(wall)%surface%rise(self%q, self%risen)
      !$omp parallel do schedule(static)
      do j = 1, self%ny
        missed(:, j, wall) = change(:, j, wall) - self%risen(:, j)
      end do
    end do
  end subroutine multiply

  !> Solves the system approximately, with the rise of each node by the flux of its neighbourhood alone.
  subroutine precondition(self, x, y)
    class(wall_pair), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    real(wp), contiguous, pointer :: missed(:, :, :), change(:, :, :)
    real(wp) :: rise(2), a11, a12, a21, a22, determinant
    integer :: i, j

    missed(1:self%nx, 1:self%ny, 1:2) => x
    change(1:self%nx, 1:self%ny, 1:2) => y
    rise = neighbourhood*[self%body(1)%surface%own, self%body(2)%surface%own]
    !$omp parallel do private(i, a11, a12, a21, a22, determinant) schedule(static)
    do j = 1, self%ny
      do i = 1, self%nx
        ! (I - rise admittance) change = missed, two equations at a node
        a11 = 1 - rise(1)*self%admittance(i, j, 1, 1)
        a12 = -rise(1)*self%admittance(i, j, 1, 2)
        a21 = -rise(2)*self%admittance(i, j, 2, 1)
        a22 = 1 - rise(2)*self%admittance(i, j, 2, 2)
        determinant = a11*a22 - a12*a21
        change(i, j, 1) = (a22*missed(i, j, 1) - a12*missed(i, j, 2))/determinant
        change(i, j, 2) = (a11*missed(i, j, 2) - a21*missed(i, j, 1))/determinant
      end do
    end do
  end subroutine precondition

end module pyworm_wall_balance
