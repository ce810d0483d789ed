!> Fourier transforms of a padded field in single precision, for temperatures of surfaces, whose rounding, 4e-7 of the
!> largest, does not matter. They take half to three quarters of the time of double precision. The film needs that: slipping
!> films and thick ones under light loads are lost with single precision even in the products of GMRES
!> (docs/evidence/speed.md).
!>
!> The two-dimensional transform is done by hand, rows first and then blocks of columns that stay in cache through forward
!> transform, the caller's product with the transform of the kernel, and backward transform. Rows of padding are never
!> transformed.
module pyworm_padded_transform
  use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_float_complex, c_size_t
  use pyworm_fourier_plan, only: fourier_memory, fourier_plan, plan_columns_single, plan_field_single
  use pyworm_kinds, only: pp, wp
  use omp_lib, only: omp_get_max_threads
  use pyworm_status, only: status_ok, status_no_plan, status_no_memory
  implicit none(type, external)
  private

  public :: field_transform, new_field_transform, padded_size, block_columns
  public :: transform_row, transform_rows, transform_rows_back, transform_block, transform_columns, transform_columns_back

  !> Columns transformed together: enough to fill cache lines, few enough to stay in the first cache.
  integer, parameter :: block_columns = 8

  type :: field_transform
    !> Points of the grid, and of the padded one.
    integer :: nx = 0, ny = 0, mx = 0, my = 0
    !> Half spectra of the rows, of which the first mx/2+1 numbers are used, and the same memory as reals, for each of ny rows.
    complex(c_float_complex), pointer, contiguous :: spectra(:, :) => null()
    real(pp), pointer, contiguous :: rows(:, :) => null()
    !> One block of columns for each thread, (my, block_columns, threads).
    complex(c_float_complex), pointer, contiguous :: columns(:, :, :) => null()
    type(fourier_plan) :: rows_forward, rows_backward, columns_forward, columns_backward
    type(fourier_memory) :: spectra_memory, columns_memory
  end type field_transform

contains

  !> Smallest padded size of at least `least` points that FFTW is fast on: a power of two, or 3 or 5 times one. Other sizes
  !> take so much longer for each point that the next such one is faster (docs/evidence/speed.md).
  pure integer function padded_size(least)
    integer, intent(in) :: least
    integer :: odd, size_of_odd

    padded_size = huge(padded_size)
    do odd = 1, 5, 2
      size_of_odd = 2*odd
      do while (size_of_odd < least)
        size_of_odd = 2*size_of_odd
      end do
      padded_size = min(padded_size, size_of_odd)
    end do
  end function padded_size

  !> Transforms of fields of nx by ny points padded to mx by my, both even.
  subroutine new_field_transform(self, nx, ny, mx, my, stat)
    type(field_transform), intent(inout) :: self
    integer, intent(in) :: nx, ny, mx, my
    integer, intent(out) :: stat
    integer :: row_length, threads

    self%nx = nx
    self%ny = ny
    self%mx = mx
    self%my = my
    ! every row is aligned as FFTW's vector instructions want it
    row_length = 2*(mx/4 + 1)
    threads = omp_get_max_threads()
    stat = status_no_memory
    call self%spectra_memory%reserve_single(int(row_length, c_size_t)*ny)
    call self%columns_memory%reserve_single(int(my, c_size_t)*block_columns*threads)
    if (.not. (c_associated(self%spectra_memory%address) .and. c_associated(self%columns_memory%address))) return
    call c_f_pointer(self%spectra_memory%address, self%spectra, [row_length, ny])
    call c_f_pointer(self%spectra_memory%address, self%rows, [2*row_length, ny])
    call c_f_pointer(self%columns_memory%address, self%columns, [my, block_columns, threads])
    call plan_field_single([mx], self%rows, self%spectra, self%rows_forward, self%rows_backward)
    call plan_columns_single(my, block_columns, self%columns, self%columns_forward, self%columns_backward)
    stat = merge(status_ok, status_no_plan, self%rows_forward%made() .and. self%rows_backward%made() &
      .and. self%columns_forward%made() .and. self%columns_backward%made())
  end subroutine new_field_transform

  !> Transforms the rows of a field, (nx, ny).
  subroutine transform_rows(self, field)
    type(field_transform), intent(inout) :: self
    real(wp), intent(in) :: field(self%nx, self%ny)
    integer :: j

    !$omp parallel do schedule(static)
    do j = 1, self%ny
      self%rows(1:self%nx, j) = real(field(:, j), pp)
      self%rows(self%nx + 1:self%mx, j) = 0
      call transform_row(self, j)
    end do
  end subroutine transform_rows

  !> Transforms what was put into a row.
  subroutine transform_row(self, j)
    type(field_transform), intent(inout) :: self
    integer, intent(in) :: j

    call self%rows_forward%to_spectrum_single(self%rows(:, j), self%spectra(:, j))
  end subroutine transform_row

  !> Transforms the rows back into a field, `unit` times what was transformed.
  subroutine transform_rows_back(self, unit, field)
    type(field_transform), intent(inout) :: self
    real(wp), intent(in) :: unit
    real(wp), intent(out) :: field(self%nx, self%ny)
    integer :: j

    !$omp parallel do schedule(static)
    do j = 1, self%ny
      call self%rows_backward%to_field_single(self%spectra(:, j), self%rows(:, j))
      field(:, j) = unit*self%rows(1:self%nx, j)
    end do
  end subroutine transform_rows_back

  !> Transforms along y `count` columns of the half spectra, from column `first` on.
  subroutine transform_columns(self, first, count, columns)
    type(field_transform), intent(in) :: self
    integer, intent(in) :: first, count
    complex(c_float_complex), contiguous, intent(inout) :: columns(:, :)
    integer :: j, k

    do j = 1, self%ny
      do k = 1, count
        columns(j, k) = self%spectra(first + k - 1, j)
      end do
    end do
    columns(:, count + 1:) = 0
    columns(self%ny + 1:, :count) = 0
    call transform_block(self, columns)
  end subroutine transform_columns

  !> Transforms what was put into a block of columns.
  subroutine transform_block(self, columns)
    type(field_transform), intent(in) :: self
    complex(c_float_complex), contiguous, intent(inout) :: columns(:, :)

    call self%columns_forward%in_place_single(columns)
  end subroutine transform_block

  !> Transforms the columns back into the half spectra.
  subroutine transform_columns_back(self, first, count, columns)
    type(field_transform), intent(inout) :: self
    integer, intent(in) :: first, count
    complex(c_float_complex), contiguous, intent(inout) :: columns(:, :)
    integer :: j, k

    call self%columns_backward%in_place_single(columns)
    do j = 1, self%ny
      do k = 1, count
        self%spectra(first + k - 1, j) = columns(j, k)
      end do
    end do
  end subroutine transform_columns_back

end module pyworm_padded_transform
