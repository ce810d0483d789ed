!> Explicit interfaces to the LAPACK and BLAS procedures in use.
module pyworm_lapack
  use pyworm_kinds, only: pp, wp
  implicit none(type, external)
  private

  public :: dgbtrf, dgbtrs, dgemm, dgesv, sgbtrf, sgbtrs

  interface
    !> LU factors of a general band matrix.
    pure subroutine dgbtrf(m, n, kl, ku, ab, ldab, ipiv, info)
      import :: wp
      implicit none(type, external)
      integer, intent(in) :: m, n, kl, ku, ldab
      real(wp), intent(inout) :: ab(ldab, *)
      integer, intent(out) :: ipiv(*)
      integer, intent(out) :: info
    end subroutine dgbtrf

    !> Solution with the factors of dgbtrf.
    pure subroutine dgbtrs(trans, n, kl, ku, nrhs, ab, ldab, ipiv, b, ldb, info)
      import :: wp
      implicit none(type, external)
      character(len=1), intent(in) :: trans
      integer, intent(in) :: n, kl, ku, nrhs, ldab, ldb
      real(wp), intent(in) :: ab(ldab, *)
      integer, intent(in) :: ipiv(*)
      real(wp), intent(inout) :: b(ldb, *)
      integer, intent(out) :: info
    end subroutine dgbtrs

    !> alpha op(a) op(b) + beta c.
    subroutine dgemm(transa, transb, m, n, k, alpha, a, lda, b, ldb, beta, c, ldc)
      import :: wp
      implicit none(type, external)
      character(len=1), intent(in) :: transa, transb
      integer, intent(in) :: m, n, k, lda, ldb, ldc
      real(wp), intent(in) :: alpha, beta, a(lda, *), b(ldb, *)
      real(wp), intent(inout) :: c(ldc, *)
    end subroutine dgemm

    !> Solution of a general system, whose matrix is replaced by its LU factors.
    pure subroutine dgesv(n, nrhs, a, lda, ipiv, b, ldb, info)
      import :: wp
      implicit none(type, external)
      integer, intent(in) :: n, nrhs, lda, ldb
      real(wp), intent(inout) :: a(lda, *), b(ldb, *)
      integer, intent(out) :: ipiv(*)
      integer, intent(out) :: info
    end subroutine dgesv

    !> LU factors of a general band matrix, single precision.
    pure subroutine sgbtrf(m, n, kl, ku, ab, ldab, ipiv, info)
      import :: pp
      implicit none(type, external)
      integer, intent(in) :: m, n, kl, ku, ldab
      real(pp), intent(inout) :: ab(ldab, *)
      integer, intent(out) :: ipiv(*)
      integer, intent(out) :: info
    end subroutine sgbtrf

    !> Solution with the factors of sgbtrf.
    pure subroutine sgbtrs(trans, n, kl, ku, nrhs, ab, ldab, ipiv, b, ldb, info)
      import :: pp
      implicit none(type, external)
      character(len=1), intent(in) :: trans
      integer, intent(in) :: n, kl, ku, nrhs, ldab, ldb
      real(pp), intent(in) :: ab(ldab, *)
      integer, intent(in) :: ipiv(*)
      real(pp), intent(inout) :: b(ldb, *)
      integer, intent(out) :: info
    end subroutine sgbtrs
  end interface

end module pyworm_lapack
