!> Restarted GMRES with left preconditioning (Saad and Schultz 1986; Saad, Iterative Methods, algorithm 9.4).
!>
!> The iteration minimises the preconditioned residual, an estimate of the error. The residual itself is a poor
!> one: its roughest parts, at the rupture line and the pressure spike, are the largest and matter least.
!>
!> The basis, most of the memory traffic of an iteration, is in single precision and orthogonalised by classical
!> Gram-Schmidt, which reads it twice whatever the number of vectors. That limits the reduction of the residual
!> to some 1e-6, far below the forcing of a Newton step.
module pyworm_krylov
  use pyworm_interruption, only: interrupted
  use pyworm_kinds, only: pp, wp
  use pyworm_vectors, only: dot, normalise, project_out, combine
  implicit none(type, external)
  private

  public :: linear_system, gmres

  !> A square system: its product with a vector and an approximate solve of it.
  type, abstract :: linear_system
  contains
    procedure(map), deferred :: multiply
    procedure(map), deferred :: precondition
  end type linear_system

  abstract interface
    subroutine map(self, x, y)
      import :: linear_system, wp
      implicit none(type, external)
      class(linear_system), intent(inout) :: self
      real(wp), contiguous, target, intent(in) :: x(:)
      real(wp), contiguous, target, intent(out) :: y(:)
    end subroutine map
  end interface

contains

  !> Solves A x = b until the preconditioned residual is `tolerance` times that of x = 0, or cycles of iterations
  !> have come to `most`.
  !>
  !> `basis` is workspace, (size(b), iterations after which the method is restarted); `reduction` is the residual reached
  !> over the first.
  subroutine gmres(system, b, tolerance, most, basis, x, iterations, reduction)
    class(linear_system), intent(inout) :: system
    real(wp), contiguous, intent(in) :: b(:)
    real(wp), intent(in) :: tolerance
    integer, intent(in) :: most
    real(pp), contiguous, intent(inout) :: basis(:, :)
    real(wp), contiguous, intent(out) :: x(:)
    integer, intent(out) :: iterations
    real(wp), intent(out) :: reduction
    real(wp), allocatable :: w(:), correction(:)
    real(wp) :: first, rest, norm
    integer :: done, err

    x = 0
    iterations = 0
    reduction = 0
    allocate (w, mold=b)
    call system%precondition(b, w)
    first = sqrt(dot(w, w))
    if (.not. first > 0) return
    call cycle_of_iterations(system, tolerance, first, basis, w, x, iterations, norm)
    reduction = norm/first
    do while (reduction > tolerance .and. iterations < most .and. iterations >= size(basis, 2))
      ! without memory for it the first cycle's solution stands
      err = 0
      if (.not. allocated(correction)) allocate (correction, mold=b, stat=err)
      if (err /= 0) return
      call system%multiply(x, correction)
      correction = b - correction
      call system%precondition(correction, w)
      rest = sqrt(dot(w, w))
      call cycle_of_iterations(system, tolerance*first/rest, rest, basis, w, correction, done, norm)
      if (interrupted() .or. .not. norm < reduction*first) return
      x = x + correction
      iterations = iterations + done
      reduction = norm/first
    end do
  end subroutine gmres

  !> Makes iterations from x = 0 at the preconditioned residual w of norm `start`, both of which are overwritten, until
  !> its norm is `tolerance` times the first or the basis is full. `norm` is that reached.
  subroutine cycle_of_iterations(system, tolerance, start, basis, w, x, iterations, norm)
    class(linear_system), intent(inout) :: system
    real(wp), intent(in) :: tolerance, start
    real(pp), contiguous, intent(inout) :: basis(:, :)
    real(wp), contiguous, intent(inout) :: w(:)
    real(wp), contiguous, intent(inout) :: x(:)
    integer, intent(out) :: iterations
    real(wp), intent(out) :: norm
    real(wp), dimension(size(basis, 2)) :: cosine, sine
    real(wp) :: hessenberg(size(basis, 2) + 1, size(basis, 2)), projection(size(basis, 2) + 1), lift, length
    integer :: i, j

    iterations = 0
    norm = start
    lift = start
    projection = 0
    projection(1) = start
    hessenberg = 0
    do j = 1, size(basis, 2)
      call normalise(lift, w, basis(:, j))
      ! x is scratch until the end
      call system%multiply(w, x)
      call system%precondition(x, w)
      call project_out(basis(:, :j), w, hessenberg(:j, j), lift)
      lift = sqrt(lift)
      hessenberg(j + 1, j) = lift
      ! Givens rotations keep the least squares problem triangular; its residual is the last entry
      do i = 1, j - 1
        call rotate(hessenberg(i, j), hessenberg(i + 1, j), cosine(i), sine(i))
      end do
      length = hypot(hessenberg(j, j), hessenberg(j + 1, j))
      if (.not. length > 0) exit
      cosine(j) = hessenberg(j, j)/length
      sine(j) = hessenberg(j + 1, j)/length
      call rotate(hessenberg(j, j), hessenberg(j + 1, j), cosine(j), sine(j))
      call rotate(projection(j), projection(j + 1), cosine(j), sine(j))
      iterations = j
      norm = abs(projection(j + 1))
      if (norm <= tolerance*start .or. .not. lift > 0) exit
      if (interrupted()) exit
    end do

    do i = iterations, 1, -1
      projection(i) = (projection(i) &
        - dot_product(hessenberg(i, i + 1:iterations), projection(i + 1:iterations)))/hessenberg(i, i)
    end do
    call combine(basis(:, :iterations), projection(:iterations), x)
  end subroutine cycle_of_iterations

  !> Givens rotation of the pair (a, b).
  pure subroutine rotate(a, b, cosine, sine)
    real(wp), intent(inout) :: a, b
    real(wp), intent(in) :: cosine, sine
    real(wp) :: first

    first = a
    a = cosine*first + sine*b
    b = cosine*b - sine*first
  end subroutine rotate

end module pyworm_krylov
