!> GMRES with right preconditioning (Saad and Schultz 1986; Saad, Iterative Methods, algorithm 9.5).
module krylov
  use kinds, only: wp
  use vectors, only: dot, step_along
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

  !> Solves A x = b until the residual is `tolerance` times |b| or `most` iterations are done.
  !>
  !> `basis` is workspace, (size(b), most + 1); `reduction` is the residual reached over |b|.
  subroutine gmres(system, b, tolerance, most, basis, x, iterations, reduction)
    class(linear_system), intent(inout) :: system
    real(wp), contiguous, intent(in) :: b(:)
    real(wp), intent(in) :: tolerance
    integer, intent(in) :: most
    real(wp), contiguous, target, intent(inout) :: basis(:, :)
    real(wp), contiguous, intent(out) :: x(:)
    integer, intent(out) :: iterations
    real(wp), intent(out) :: reduction
    real(wp) :: hessenberg(most + 1, most), cosine(most), sine(most), projection(most + 1)
    real(wp) :: norm, lift
    integer :: i, j

    x = 0
    iterations = 0
    norm = sqrt(dot(b, b))
    reduction = 0
    if (.not. norm > 0) return
    basis(:, 1) = b/norm
    projection = 0
    projection(1) = norm
    hessenberg = 0
    reduction = 1

    do j = 1, most
      ! x is scratch until the end
      call system%precondition(basis(:, j), x)
      call system%multiply(x, basis(:, j + 1))
      do i = 1, j
        hessenberg(i, j) = dot(basis(:, i), basis(:, j + 1))
        call step_along(-hessenberg(i, j), basis(:, i), basis(:, j + 1))
      end do
      lift = sqrt(dot(basis(:, j + 1), basis(:, j + 1)))
      hessenberg(j + 1, j) = lift
      if (lift > 0) basis(:, j + 1) = basis(:, j + 1)/lift
      do i = 1, j - 1
        call rotate(hessenberg(i, j), hessenberg(i + 1, j), cosine(i), sine(i))
      end do
      norm = hypot(hessenberg(j, j), hessenberg(j + 1, j))
      if (.not. norm > 0) exit
      cosine(j) = hessenberg(j, j)/norm
      sine(j) = hessenberg(j + 1, j)/norm
      call rotate(hessenberg(j, j), hessenberg(j + 1, j), cosine(j), sine(j))
      call rotate(projection(j), projection(j + 1), cosine(j), sine(j))
      iterations = j
      reduction = abs(projection(j + 1))/sqrt(dot(b, b))
      if (reduction <= tolerance .or. .not. lift > 0) exit
    end do

    do i = iterations, 1, -1
      projection(i) = (projection(i) &
        - dot_product(hessenberg(i, i + 1:iterations), projection(i + 1:iterations)))/hessenberg(i, i)
    end do
    ! the basis vector after the last one used holds the combination
    associate (combination => basis(:, iterations + 1))
      combination = 0
      do i = 1, iterations
        call step_along(projection(i), basis(:, i), combination)
      end do
      call system%precondition(combination, x)
    end associate
  end subroutine gmres

  !> Givens rotation of the pair (a, b).
  pure subroutine rotate(a, b, cosine, sine)
    real(wp), intent(inout) :: a, b
    real(wp), intent(in) :: cosine, sine
    real(wp) :: first

    first = a
    a = cosine*first + sine*b
    b = cosine*b - sine*first
  end subroutine rotate

end module krylov
