module small_system
  use pyworm_kinds, only: wp
  use pyworm_krylov, only: linear_system
  implicit none(type, external)
  private

  !> A dense matrix with its diagonal as preconditioner.
  type, extends(linear_system), public :: dense
    real(wp), allocatable :: a(:, :)
  contains
    procedure :: multiply
    procedure :: precondition
  end type dense

contains

  subroutine multiply(self, x, y)
    class(dense), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)

    y = matmul(self%a, x)
  end subroutine multiply

  subroutine precondition(self, x, y)
    class(dense), intent(inout) :: self
    real(wp), contiguous, target, intent(in) :: x(:)
    real(wp), contiguous, target, intent(out) :: y(:)
    integer :: i

    do i = 1, size(x)
      y(i) = x(i)/self%a(i, i)
    end do
  end subroutine precondition

end module small_system
program test_krylov
  use pyworm_kinds, only: pp, wp
  use pyworm_krylov, only: gmres
  use small_system, only: dense
  use tap, only: check, close_to, done
  implicit none(type, external)

  integer, parameter :: n = 12
  type(dense) :: system
  real(wp) :: b(n), x(n), rest(n), start(n), reduction
  real(pp) :: basis(n, n)
  integer :: i, j, iterations

  allocate (system%a(n, n))
  do j = 1, n
    do i = 1, n
      system%a(i, j) = 1/real(1 + abs(i - 2*j), wp)
    end do
    system%a(j, j) = 3 + j
    b(j) = (-1)**j*j
  end do

  ! the basis is kept in single precision
  call gmres(system, b, 1e-12_wp, n, basis, x, iterations, reduction)
  call close_to(norm2(matmul(system%a, x) - b)/norm2(b), 0.0_wp, 1e-6_wp, "a full basis solves the system")
  call gmres(system, b, 0.1_wp, n, basis, x, iterations, reduction)
  call system%precondition(matmul(system%a, x) - b, rest)
  call system%precondition(b, start)
  call close_to(norm2(rest)/norm2(start), reduction, 1e-6_wp, "the reduction told is the true one")
  call check(reduction <= 0.1_wp .and. iterations < n, "it stops at the tolerance")
  call gmres(system, b, 1e-8_wp, 40*n, basis(:, :n/3), x, iterations, reduction)
  call close_to(norm2(matmul(system%a, x) - b)/norm2(b), 0.0_wp, 1e-6_wp, "restarted, a third of a basis does, too")
  call check(reduction <= 1e-8_wp .and. iterations > n/3 .and. iterations < 40*n, "and told where it stopped")
  call gmres(system, 0*b, 0.1_wp, n, basis, x, iterations, reduction)
  call check(iterations == 0 .and. maxval(abs(x)) <= 0, "nothing to solve")
  call done()
end program test_krylov
