!> Convolution of a field on a grid with any kernel, by fast Fourier transforms in single precision.
!>
!> The kernel need not be even: its transform is complex, and padding to 2n - 1 points is needed. Sums of convolutions of
!> several fields with a kernel each are made of their spectra, whose product is the spectrum of a convolution.
module pyworm_convolution
  use, intrinsic :: iso_c_binding, only: c_float_complex
  use pyworm_kinds, only: pp, wp
  use omp_lib, only: omp_get_thread_num
  use pyworm_padded_transform, only: field_transform, new_field_transform, padded_size, block_columns, transform_row, &
    transform_rows, &
    transform_rows_back, transform_block, transform_columns, transform_columns_back
  use pyworm_status, only: status_ok, status_bad_argument, status_no_memory
  implicit none(type, external)
  private

  public :: grid_convolution, new_grid_convolution, new_kernel_transform, kernel_spectrum, field_spectrum, spectrum_field

  type :: grid_convolution
    type(field_transform) :: transform
    !> Largest value of the kernel, and the transform of the kernel in its units over the padded size, (my, mx/2+1).
    real(wp) :: unit = 0
    complex(c_float_complex), allocatable :: kernel(:, :)
  contains
    procedure :: convolve
    procedure :: convolve_transposed
  end type grid_convolution

contains

  !> Convolution with `kernel`, response at offset (i, j) from a unit at a node, (1-nx:nx-1, 1-ny:ny-1). A grid of one
  !> row is one too.
  subroutine new_grid_convolution(self, nx, ny, kernel, stat)
    type(grid_convolution), intent(inout) :: self
    integer, intent(in) :: nx, ny
    real(wp), intent(in) :: kernel(1 - nx:nx - 1, 1 - ny:ny - 1)
    integer, intent(out) :: stat
    integer :: err

    call new_kernel_transform(self%transform, nx, ny, stat)
    if (stat /= status_ok) return
    allocate (self%kernel(self%transform%my, self%transform%mx/2 + 1), stat=err)
    if (err /= 0) stat = status_no_memory
    if (err == 0) call kernel_spectrum(self%transform, kernel, self%unit, self%kernel)
  end subroutine new_grid_convolution

  !> Transform of fields of nx by ny points, padded for kernels that are not even.
  subroutine new_kernel_transform(transform, nx, ny, stat)
    type(field_transform), intent(inout) :: transform
    integer, intent(in) :: nx, ny
    integer, intent(out) :: stat

    stat = status_bad_argument
    if (nx < 2 .or. ny < 1) return
    call new_field_transform(transform, nx, ny, padded_size(2*nx - 1), padded_size(2*ny - 1), stat)
  end subroutine new_kernel_transform

  !> Computes the transform (my, mx/2+1) of a kernel in units of its largest value, wrapped round the padded grid and scaled
  !> for both transforms.
  subroutine kernel_spectrum(t, kernel, unit, spectrum)
    type(field_transform), intent(inout) :: t
    real(wp), intent(in) :: kernel(1 - t%nx:, 1 - t%ny:)
    real(wp), intent(out) :: unit
    complex(c_float_complex), intent(out) :: spectrum(:, :)
    integer :: first, count

    unit = maxval(abs(kernel))
    if (.not. unit > 0) unit = 1
    spectrum = 0
    ! there is memory for ny rows: those before the middle first, then the others
    call transform_kernel_rows(t, kernel, 1 - t%ny, -1, unit, spectrum)
    call transform_kernel_rows(t, kernel, 0, t%ny - 1, unit, spectrum)
    do first = 1, t%mx/2 + 1, block_columns
      count = min(block_columns, t%mx/2 + 2 - first)
      associate (columns => t%columns(:, :, 1))
        columns(:, :count) = spectrum(:, first:first + count - 1)
        columns(:, count + 1:) = 0
        call transform_block(t, columns)
        spectrum(:, first:first + count - 1) = columns(:, :count)
      end associate
    end do
  end subroutine kernel_spectrum

  !> Computes the transforms of some rows of a kernel, as rows of its spectrum.
  subroutine transform_kernel_rows(t, kernel, lowest, highest, unit, spectrum)
    type(field_transform), intent(inout) :: t
    real(wp), intent(in) :: kernel(1 - t%nx:, 1 - t%ny:), unit
    integer, intent(in) :: lowest, highest
    complex(c_float_complex), intent(inout) :: spectrum(:, :)
    real(wp) :: scale
    integer :: j, k, first, last

    scale = 1/(unit*t%mx*t%my)
    do j = lowest, highest
      associate (row => t%rows(:, j - lowest + 1))
        row = 0
        row(1:t%nx) = real(kernel(0:, j)*scale, pp)
        row(t%mx - t%nx + 2:t%mx) = real(kernel(:-1, j)*scale, pp)
      end associate
      call transform_row(t, j - lowest + 1)
    end do
    ! blocks of columns, of which cache lines are full
    do first = 1, t%mx/2 + 1, block_columns
      last = min(first + block_columns - 1, t%mx/2 + 1)
      do j = lowest, highest
        do k = first, last
          spectrum(modulo(j, t%my) + 1, k) = t%spectra(k, j - lowest + 1)
        end do
      end do
    end do
  end subroutine transform_kernel_rows

  !> Computes the transform (my, mx/2+1) of a field.
  subroutine field_spectrum(t, field, spectrum)
    type(field_transform), intent(inout) :: t
    real(wp), intent(in) :: field(t%nx, t%ny)
    complex(c_float_complex), intent(out) :: spectrum(:, :)
    integer :: first, count

    call transform_rows(t, field)
    do first = 1, t%mx/2 + 1, block_columns
      count = min(block_columns, t%mx/2 + 2 - first)
      associate (columns => t%columns(:, :, 1))
        call transform_columns(t, first, count, columns)
        spectrum(:, first:first + count - 1) = columns(:, :count)
      end associate
    end do
  end subroutine field_spectrum

  !> Computes the field, times `unit`, of a spectrum (my, mx/2+1); columns that are missing are zero.
  subroutine spectrum_field(t, spectrum, unit, field)
    type(field_transform), intent(inout) :: t
    complex(c_float_complex), intent(in) :: spectrum(:, :)
    real(wp), intent(in) :: unit
    real(wp), intent(out) :: field(t%nx, t%ny)
    integer :: first, count

    t%spectra(size(spectrum, 2) + 1:, :) = 0
    do first = 1, size(spectrum, 2), block_columns
      count = min(block_columns, size(spectrum, 2) + 1 - first)
      associate (columns => t%columns(:, :, 1))
        columns(:, :count) = spectrum(:, first:first + count - 1)
        columns(:, count + 1:) = 0
        call transform_columns_back(t, first, count, columns)
      end associate
    end do
    call transform_rows_back(t, unit, field)
  end subroutine spectrum_field

  !> Computes the convolution `y` of the field `x` with the kernel, both (nx, ny).
  subroutine convolve(self, x, y)
    class(grid_convolution), intent(inout) :: self
    real(wp), intent(in) :: x(self%transform%nx, self%transform%ny)
    real(wp), intent(out) :: y(self%transform%nx, self%transform%ny)

    call apply(self, .false., x, y)
  end subroutine convolve

  !> Computes the product `y` of the transposed convolution with the field `x`, both (nx, ny): the convolution with the
  !> reflected kernel, whose transform is the conjugate one.
  subroutine convolve_transposed(self, x, y)
    class(grid_convolution), intent(inout) :: self
    real(wp), intent(in) :: x(self%transform%nx, self%transform%ny)
    real(wp), intent(out) :: y(self%transform%nx, self%transform%ny)

    call apply(self, .true., x, y)
  end subroutine convolve_transposed

  !> Computes the convolution with the kernel or with the `reflected` one.
  subroutine apply(self, reflected, x, y)
    class(grid_convolution), intent(inout) :: self
    logical, intent(in) :: reflected
    real(wp), intent(in) :: x(self%transform%nx, self%transform%ny)
    real(wp), intent(out) :: y(self%transform%nx, self%transform%ny)
    integer :: first, count, k, thread

    call transform_rows(self%transform, x)
    !$omp parallel do private(count, k, thread) schedule(static) num_threads(size(self%transform%columns, 3))
    do first = 1, self%transform%mx/2 + 1, block_columns
      thread = omp_get_thread_num() + 1
      count = min(block_columns, self%transform%mx/2 + 2 - first)
      associate (columns => self%transform%columns(:, :, thread))
        call transform_columns(self%transform, first, count, columns)
        do k = 1, count
          if (reflected) then
            columns(:, k) = columns(:, k)*conjg(self%kernel(:, first + k - 1))
          else
            columns(:, k) = columns(:, k)*self%kernel(:, first + k - 1)
          end if
        end do
        call transform_columns_back(self%transform, first, count, columns)
      end associate
    end do
    call transform_rows_back(self%transform, self%unit, y)
  end subroutine apply

end module pyworm_convolution
