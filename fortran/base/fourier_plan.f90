!> Plans of FFTW and memory for them, which end with their owner.
!>
!> Plans are made here alone, one at a time: FFTW's planner shares state between threads. They are estimated and not measured, so
!> that every run has the same plan and the same rounding. Arrays are of any rank, x changing fastest.
module pyworm_fourier_plan
  use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_double_complex, c_float, c_float_complex, c_int, c_loc, &
    c_null_ptr, c_ptr, c_size_t
  use pyworm_fftw, only: fftw_alloc_complex, fftw_destroy_plan, fftw_execute_dft, fftw_execute_dft_c2r, fftw_execute_dft_r2c, &
    fftw_execute_r2r, fftw_free, fftw_plan_dft_c2r, fftw_plan_dft_r2c, fftw_plan_many_dft, fftw_plan_r2r, &
    fftwf_alloc_complex, fftwf_destroy_plan, fftwf_execute_dft, fftwf_execute_dft_c2r, fftwf_execute_dft_r2c, &
    fftwf_plan_dft_c2r, fftwf_plan_dft_r2c, fftwf_plan_many_dft, fftw_backward, fftw_estimate, fftw_forward, fftw_redft00
  implicit none(type, external)
  private

  public :: fourier_plan, fourier_memory, plan_field, plan_field_single, plan_columns, plan_columns_single, plan_cosine

  !> One transform.
  type :: fourier_plan
    private
    type(c_ptr) :: plan = c_null_ptr
    logical :: single = .false.
  contains
    procedure :: made
    procedure :: to_spectrum
    procedure :: to_field
    procedure :: in_place
    procedure :: cosine
    procedure :: to_spectrum_single
    procedure :: to_field_single
    procedure :: in_place_single
    final :: destroy
  end type fourier_plan

  !> Memory that is aligned as vector instructions want it; null where there was none.
  type :: fourier_memory
    type(c_ptr) :: address = c_null_ptr
  contains
    procedure :: reserve
    procedure :: reserve_single
    final :: release
  end type fourier_memory

contains

  !> Plans between a real field of `shape` points and its half spectrum in the same memory.
  subroutine plan_field(shape, field, spectrum, forward, backward)
    integer, intent(in) :: shape(:)
    real(c_double), intent(inout) :: field(*)
    complex(c_double_complex), intent(inout) :: spectrum(*)
    type(fourier_plan), intent(inout) :: forward, backward
    integer(c_int) :: slowest_first(size(shape))

    slowest_first = shape(size(shape):1:-1)
    !$omp critical (fftw_planner)
    forward%plan = fftw_plan_dft_r2c(size(shape), slowest_first, field, spectrum, fftw_estimate)
    backward%plan = fftw_plan_dft_c2r(size(shape), slowest_first, spectrum, field, fftw_estimate)
    !$omp end critical (fftw_planner)
  end subroutine plan_field

  !> Plans of `plan_field` in single precision.
  subroutine plan_field_single(shape, field, spectrum, forward, backward)
    integer, intent(in) :: shape(:)
    real(c_float), intent(inout) :: field(*)
    complex(c_float_complex), intent(inout) :: spectrum(*)
    type(fourier_plan), intent(inout) :: forward, backward
    integer(c_int) :: slowest_first(size(shape))

    slowest_first = shape(size(shape):1:-1)
    forward%single = .true.
    backward%single = .true.
    !$omp critical (fftw_planner)
    forward%plan = fftwf_plan_dft_r2c(size(shape), slowest_first, field, spectrum, fftw_estimate)
    backward%plan = fftwf_plan_dft_c2r(size(shape), slowest_first, spectrum, field, fftw_estimate)
    !$omp end critical (fftw_planner)
  end subroutine plan_field_single

  !> Plans of `count` columns of `length` points, one after another in memory, in place.
  subroutine plan_columns(length, count, columns, forward, backward)
    integer, intent(in) :: length, count
    complex(c_double_complex), target, intent(inout) :: columns(*)
    type(fourier_plan), intent(inout) :: forward, backward
    type(c_ptr) :: memory
    integer(c_int) :: n(1)

    n = length
    memory = c_loc(columns)
    !$omp critical (fftw_planner)
    forward%plan = fftw_plan_many_dft(1, n, count, memory, n, 1, length, memory, n, 1, length, fftw_forward, fftw_estimate)
    backward%plan = fftw_plan_many_dft(1, n, count, memory, n, 1, length, memory, n, 1, length, fftw_backward, fftw_estimate)
    !$omp end critical (fftw_planner)
  end subroutine plan_columns

  !> Plans of `plan_columns` in single precision.
  subroutine plan_columns_single(length, count, columns, forward, backward)
    integer, intent(in) :: length, count
    complex(c_float_complex), target, intent(inout) :: columns(*)
    type(fourier_plan), intent(inout) :: forward, backward
    type(c_ptr) :: memory
    integer(c_int) :: n(1)

    n = length
    memory = c_loc(columns)
    forward%single = .true.
    backward%single = .true.
    !$omp critical (fftw_planner)
    forward%plan = fftwf_plan_many_dft(1, n, count, memory, n, 1, length, memory, n, 1, length, fftw_forward, fftw_estimate)
    backward%plan = fftwf_plan_many_dft(1, n, count, memory, n, 1, length, memory, n, 1, length, fftw_backward, fftw_estimate)
    !$omp end critical (fftw_planner)
  end subroutine plan_columns_single

  !> Plans the cosine transform of a field of `shape` points that is even about its first and last ones.
  subroutine plan_cosine(shape, from, to, plan)
    integer, intent(in) :: shape(:)
    real(c_double), intent(inout) :: from(*), to(*)
    type(fourier_plan), intent(inout) :: plan
    integer(c_int) :: slowest_first(size(shape)), kinds(size(shape))

    slowest_first = shape(size(shape):1:-1)
    kinds = fftw_redft00
    !$omp critical (fftw_planner)
    plan%plan = fftw_plan_r2r(size(shape), slowest_first, from, to, kinds, fftw_estimate)
    !$omp end critical (fftw_planner)
  end subroutine plan_cosine

  !> Whether FFTW has made the plan.
  pure logical function made(self)
    class(fourier_plan), intent(in) :: self

    made = c_associated(self%plan)
  end function made

  !> Transforms a real field into its half spectrum.
  subroutine to_spectrum(self, field, spectrum)
    class(fourier_plan), intent(in) :: self
    real(c_double), intent(inout) :: field(*)
    complex(c_double_complex), intent(inout) :: spectrum(*)

    call fftw_execute_dft_r2c(self%plan, field, spectrum)
  end subroutine to_spectrum

  !> Transforms a half spectrum into a real field.
  subroutine to_field(self, spectrum, field)
    class(fourier_plan), intent(in) :: self
    complex(c_double_complex), intent(inout) :: spectrum(*)
    real(c_double), intent(inout) :: field(*)

    call fftw_execute_dft_c2r(self%plan, spectrum, field)
  end subroutine to_field

  !> Transforms complex columns in place.
  subroutine in_place(self, columns)
    class(fourier_plan), intent(in) :: self
    complex(c_double_complex), target, intent(inout) :: columns(*)

    call fftw_execute_dft(self%plan, c_loc(columns), c_loc(columns))
  end subroutine in_place

  !> Makes the cosine transform.
  subroutine cosine(self, from, to)
    class(fourier_plan), intent(in) :: self
    real(c_double), intent(inout) :: from(*), to(*)

    call fftw_execute_r2r(self%plan, from, to)
  end subroutine cosine

  !> Transforms a real field into its half spectrum, in single precision.
  subroutine to_spectrum_single(self, field, spectrum)
    class(fourier_plan), intent(in) :: self
    real(c_float), intent(inout) :: field(*)
    complex(c_float_complex), intent(inout) :: spectrum(*)

    call fftwf_execute_dft_r2c(self%plan, field, spectrum)
  end subroutine to_spectrum_single

  !> Transforms a half spectrum into a real field, in single precision.
  subroutine to_field_single(self, spectrum, field)
    class(fourier_plan), intent(in) :: self
    complex(c_float_complex), intent(inout) :: spectrum(*)
    real(c_float), intent(inout) :: field(*)

    call fftwf_execute_dft_c2r(self%plan, spectrum, field)
  end subroutine to_field_single

  !> Transforms complex columns in place, in single precision.
  subroutine in_place_single(self, columns)
    class(fourier_plan), intent(in) :: self
    complex(c_float_complex), target, intent(inout) :: columns(*)

    call fftwf_execute_dft(self%plan, c_loc(columns), c_loc(columns))
  end subroutine in_place_single

  !> Destroys a plan.
  subroutine destroy(self)
    type(fourier_plan), intent(inout) :: self

    if (.not. c_associated(self%plan)) return
    !$omp critical (fftw_planner)
    if (self%single) then
      call fftwf_destroy_plan(self%plan)
    else
      call fftw_destroy_plan(self%plan)
    end if
    !$omp end critical (fftw_planner)
    self%plan = c_null_ptr
  end subroutine destroy

  !> Reserves memory of `count` complex numbers.
  subroutine reserve(self, count)
    class(fourier_memory), intent(inout) :: self
    integer(c_size_t), intent(in) :: count

    self%address = fftw_alloc_complex(count)
  end subroutine reserve

  !> Reserves memory of `count` complex numbers of single precision.
  subroutine reserve_single(self, count)
    class(fourier_memory), intent(inout) :: self
    integer(c_size_t), intent(in) :: count

    self%address = fftwf_alloc_complex(count)
  end subroutine reserve_single

  subroutine release(self)
    type(fourier_memory), intent(inout) :: self

    if (c_associated(self%address)) call fftw_free(self%address)
    self%address = c_null_ptr
  end subroutine release

end module pyworm_fourier_plan
