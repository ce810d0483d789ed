!> The procedures of FFTW 3 that the kernel calls (M. Frigo and S. G. Johnson, FFTW 3.3 manual, sections 4.3 to 4.5).
!>
!> Interfaces of their own instead of FFTW's `fftw3.f03`, which compilers do not find by themselves: a transform in place takes
!> its memory by address, since one array may not be associated with two arguments that are written.
module pyworm_fftw
  use, intrinsic :: iso_c_binding, only: c_double, c_double_complex, c_float, c_float_complex, c_int, c_ptr, c_size_t
  implicit none(type, external)
  private

  public :: fftw_alloc_complex, fftw_free, fftw_destroy_plan, fftw_plan_many_dft, fftw_plan_dft_r2c, fftw_plan_dft_c2r, &
    fftw_plan_r2r, fftw_execute_dft, fftw_execute_dft_r2c, fftw_execute_dft_c2r, fftw_execute_r2r
  public :: fftwf_alloc_complex, fftwf_destroy_plan, fftwf_plan_many_dft, fftwf_plan_dft_r2c, fftwf_plan_dft_c2r, &
    fftwf_execute_dft, fftwf_execute_dft_r2c, fftwf_execute_dft_c2r

  !> Directions, the flag of a plan that is estimated, and the cosine transform of even data (`fftw3.h`).
  integer(c_int), parameter, public :: fftw_forward = -1, fftw_backward = 1, fftw_estimate = 64, fftw_redft00 = 3

  interface
    type(c_ptr) function fftw_alloc_complex(n) bind(c, name="fftw_alloc_complex")
      import :: c_ptr, c_size_t
      implicit none(type, external)
      integer(c_size_t), value :: n
    end function fftw_alloc_complex

    type(c_ptr) function fftwf_alloc_complex(n) bind(c, name="fftwf_alloc_complex")
      import :: c_ptr, c_size_t
      implicit none(type, external)
      integer(c_size_t), value :: n
    end function fftwf_alloc_complex

    subroutine fftw_free(p) bind(c, name="fftw_free")
      import :: c_ptr
      implicit none(type, external)
      type(c_ptr), value :: p
    end subroutine fftw_free

    subroutine fftw_destroy_plan(p) bind(c, name="fftw_destroy_plan")
      import :: c_ptr
      implicit none(type, external)
      type(c_ptr), value :: p
    end subroutine fftw_destroy_plan

    subroutine fftwf_destroy_plan(p) bind(c, name="fftwf_destroy_plan")
      import :: c_ptr
      implicit none(type, external)
      type(c_ptr), value :: p
    end subroutine fftwf_destroy_plan

    !> Plan of `howmany` transforms; `in` and `out` are addresses, the same of a transform in place.
    type(c_ptr) function fftw_plan_many_dft(rank, n, howmany, in, inembed, istride, idist, out, onembed, ostride, odist, &
        sign, flags) bind(c, name="fftw_plan_many_dft")
      import :: c_int, c_ptr
      implicit none(type, external)
      integer(c_int), value :: rank, howmany, istride, idist, ostride, odist, sign, flags
      integer(c_int), intent(in) :: n(*), inembed(*), onembed(*)
      type(c_ptr), value :: in, out
    end function fftw_plan_many_dft

    type(c_ptr) function fftwf_plan_many_dft(rank, n, howmany, in, inembed, istride, idist, out, onembed, ostride, odist, &
        sign, flags) bind(c, name="fftwf_plan_many_dft")
      import :: c_int, c_ptr
      implicit none(type, external)
      integer(c_int), value :: rank, howmany, istride, idist, ostride, odist, sign, flags
      integer(c_int), intent(in) :: n(*), inembed(*), onembed(*)
      type(c_ptr), value :: in, out
    end function fftwf_plan_many_dft

    type(c_ptr) function fftw_plan_dft_r2c(rank, n, in, out, flags) bind(c, name="fftw_plan_dft_r2c")
      import :: c_double, c_double_complex, c_int, c_ptr
      implicit none(type, external)
      integer(c_int), value :: rank, flags
      integer(c_int), intent(in) :: n(*)
      real(c_double), intent(inout) :: in(*)
      complex(c_double_complex), intent(inout) :: out(*)
    end function fftw_plan_dft_r2c

    type(c_ptr) function fftwf_plan_dft_r2c(rank, n, in, out, flags) bind(c, name="fftwf_plan_dft_r2c")
      import :: c_float, c_float_complex, c_int, c_ptr
      implicit none(type, external)
      integer(c_int), value :: rank, flags
      integer(c_int), intent(in) :: n(*)
      real(c_float), intent(inout) :: in(*)
      complex(c_float_complex), intent(inout) :: out(*)
    end function fftwf_plan_dft_r2c

    type(c_ptr) function fftw_plan_dft_c2r(rank, n, in, out, flags) bind(c, name="fftw_plan_dft_c2r")
      import :: c_double, c_double_complex, c_int, c_ptr
      implicit none(type, external)
      integer(c_int), value :: rank, flags
      integer(c_int), intent(in) :: n(*)
      complex(c_double_complex), intent(inout) :: in(*)
      real(c_double), intent(inout) :: out(*)
    end function fftw_plan_dft_c2r

    type(c_ptr) function fftwf_plan_dft_c2r(rank, n, in, out, flags) bind(c, name="fftwf_plan_dft_c2r")
      import :: c_float, c_float_complex, c_int, c_ptr
      implicit none(type, external)
      integer(c_int), value :: rank, flags
      integer(c_int), intent(in) :: n(*)
      complex(c_float_complex), intent(inout) :: in(*)
      real(c_float), intent(inout) :: out(*)
    end function fftwf_plan_dft_c2r

    type(c_ptr) function fftw_plan_r2r(rank, n, in, out, kind, flags) bind(c, name="fftw_plan_r2r")
      import :: c_double, c_int, c_ptr
      implicit none(type, external)
      integer(c_int), value :: rank, flags
      integer(c_int), intent(in) :: n(*), kind(*)
      real(c_double), intent(inout) :: in(*), out(*)
    end function fftw_plan_r2r

    !> Complex transform between two addresses, the same of one in place.
    subroutine fftw_execute_dft(p, in, out) bind(c, name="fftw_execute_dft")
      import :: c_ptr
      implicit none(type, external)
      type(c_ptr), value :: p, in, out
    end subroutine fftw_execute_dft

    subroutine fftwf_execute_dft(p, in, out) bind(c, name="fftwf_execute_dft")
      import :: c_ptr
      implicit none(type, external)
      type(c_ptr), value :: p, in, out
    end subroutine fftwf_execute_dft

    subroutine fftw_execute_dft_r2c(p, in, out) bind(c, name="fftw_execute_dft_r2c")
      import :: c_double, c_double_complex, c_ptr
      implicit none(type, external)
      type(c_ptr), value :: p
      real(c_double), intent(inout) :: in(*)
      complex(c_double_complex), intent(inout) :: out(*)
    end subroutine fftw_execute_dft_r2c

    subroutine fftwf_execute_dft_r2c(p, in, out) bind(c, name="fftwf_execute_dft_r2c")
      import :: c_float, c_float_complex, c_ptr
      implicit none(type, external)
      type(c_ptr), value :: p
      real(c_float), intent(inout) :: in(*)
      complex(c_float_complex), intent(inout) :: out(*)
    end subroutine fftwf_execute_dft_r2c

    subroutine fftw_execute_dft_c2r(p, in, out) bind(c, name="fftw_execute_dft_c2r")
      import :: c_double, c_double_complex, c_ptr
      implicit none(type, external)
      type(c_ptr), value :: p
      complex(c_double_complex), intent(inout) :: in(*)
      real(c_double), intent(inout) :: out(*)
    end subroutine fftw_execute_dft_c2r

    subroutine fftwf_execute_dft_c2r(p, in, out) bind(c, name="fftwf_execute_dft_c2r")
      import :: c_float, c_float_complex, c_ptr
      implicit none(type, external)
      type(c_ptr), value :: p
      complex(c_float_complex), intent(inout) :: in(*)
      real(c_float), intent(inout) :: out(*)
    end subroutine fftwf_execute_dft_c2r

    subroutine fftw_execute_r2r(p, in, out) bind(c, name="fftw_execute_r2r")
      import :: c_double, c_ptr
      implicit none(type, external)
      type(c_ptr), value :: p
      real(c_double), intent(inout) :: in(*), out(*)
    end subroutine fftw_execute_r2r
  end interface

end module pyworm_fftw
