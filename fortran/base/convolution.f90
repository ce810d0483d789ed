!> Convolution of a field on a grid with any kernel, by fast Fourier transforms.
!>
!> As in `half_space`, the two-dimensional transform is done by hand, rows first and then blocks of columns
!> that stay in cache through forward transform, product and backward transform, and rows of padding are never
!> transformed. Here the kernel need not be even: its transform is complex, and padding to 2n - 1 points is
!> needed.
module convolution
  use, intrinsic :: iso_c_binding, only: c_ptr, c_null_ptr, c_f_pointer, c_associated, c_int, c_size_t, &
    c_double_complex
  use fftw, only: fftw_alloc_complex, fftw_free, fftw_plan_many_dft, fftw_plan_many_dft_r2c, &
    fftw_plan_many_dft_c2r, fftw_execute_dft, fftw_execute_dft_r2c, fftw_execute_dft_c2r, fftw_destroy_plan, &
    FFTW_ESTIMATE, FFTW_FORWARD, FFTW_BACKWARD
  use half_space, only: padded_size
  use kinds, only: wp
  use omp_lib, only: omp_get_max_threads, omp_get_thread_num
  use status, only: status_ok, status_bad_argument, status_no_plan, status_no_memory
  implicit none(type, external)
  private

  public :: grid_convolution, new_grid_convolution

  !> Columns transformed together: enough to fill cache lines, few enough to stay in the first cache.
  integer, parameter :: block_columns = 8

  type :: grid_convolution
    !> Points of the grid, and of the padded one.
    integer :: nx = 0, ny = 0, mx = 0, my = 0
    !> Transform of the kernel over the padded size, (my, mx/2+1).
    complex(c_double_complex), allocatable :: kernel(:, :)
    !> Half spectra of the rows, (mx/2+1, ny), and the same memory as reals, (mx+2, ny).
    complex(c_double_complex), pointer, contiguous :: spectra(:, :) => null()
    real(wp), pointer, contiguous :: rows(:, :) => null()
    !> One block of columns for each thread, (my, block_columns, threads).
    complex(c_double_complex), pointer, contiguous :: columns(:, :, :) => null()
    type(c_ptr) :: rows_forward = c_null_ptr, rows_backward = c_null_ptr
    type(c_ptr) :: columns_forward = c_null_ptr, columns_backward = c_null_ptr
    type(c_ptr) :: spectra_memory = c_null_ptr, columns_memory = c_null_ptr
  contains
    procedure :: convolve
    final :: release
  end type grid_convolution

contains

  !> Convolution with `kernel`, response at offset (i, j) from a unit at a node, (1-nx:nx-1, 1-ny:ny-1). A grid of one
  !> row is one too.
  subroutine new_grid_convolution(self, nx, ny, kernel, stat)
    type(grid_convolution), intent(inout) :: self
    integer, intent(in) :: nx, ny
    real(wp), intent(in) :: kernel(1 - nx:nx - 1, 1 - ny:ny - 1)
    integer, intent(out) :: stat
    integer :: err, threads

    stat = status_bad_argument
    if (nx < 2 .or. ny < 1) return
    self%nx = nx
    self%ny = ny
    self%mx = padded_size(nx + 1)
    self%my = padded_size(ny + 1)

    stat = status_no_memory
    self%spectra_memory = fftw_alloc_complex(int(self%mx/2 + 1, c_size_t)*ny)
    threads = omp_get_max_threads()
    self%columns_memory = fftw_alloc_complex(int(self%my, c_size_t)*block_columns*threads)
    if (.not. (c_associated(self%spectra_memory) .and. c_associated(self%columns_memory))) return
    call c_f_pointer(self%spectra_memory, self%spectra, [self%mx/2 + 1, ny])
    call c_f_pointer(self%spectra_memory, self%rows, [self%mx + 2, ny])
    call c_f_pointer(self%columns_memory, self%columns, [self%my, block_columns, threads])
    allocate (self%kernel(self%my, self%mx/2 + 1), stat=err)
    if (err /= 0) return

    call plan_transforms(self, stat)
    if (stat == status_ok) call transform_kernel(self, kernel)
  end subroutine new_grid_convolution

  subroutine plan_transforms(self, stat)
    type(grid_convolution), intent(inout) :: self
    integer, intent(out) :: stat
    integer(c_int) :: length_x(1), length_y(1)

    length_x = self%mx
    length_y = self%my
    ! FFTW's planner shares state between threads. ESTIMATE makes the same plan in every run.
    !$omp critical (fftw_planner)
    self%rows_forward = fftw_plan_many_dft_r2c(1, length_x, 1, &
      self%rows, [self%mx + 2], 1, self%mx + 2, self%spectra, [self%mx/2 + 1], 1, self%mx/2 + 1, FFTW_ESTIMATE)
    self%rows_backward = fftw_plan_many_dft_c2r(1, length_x, 1, &
      self%spectra, [self%mx/2 + 1], 1, self%mx/2 + 1, self%rows, [self%mx + 2], 1, self%mx + 2, FFTW_ESTIMATE)
    self%columns_forward = fftw_plan_many_dft(1, length_y, block_columns, &
      self%columns, length_y, 1, self%my, self%columns, length_y, 1, self%my, FFTW_FORWARD, FFTW_ESTIMATE)
    self%columns_backward = fftw_plan_many_dft(1, length_y, block_columns, &
      self%columns, length_y, 1, self%my, self%columns, length_y, 1, self%my, FFTW_BACKWARD, FFTW_ESTIMATE)
    !$omp end critical (fftw_planner)
    stat = merge(status_ok, status_no_plan, &
      c_associated(self%rows_forward) .and. c_associated(self%rows_backward) .and. &
      c_associated(self%columns_forward) .and. c_associated(self%columns_backward))
  end subroutine plan_transforms

  !> Computes the transform of the kernel, wrapped round the padded grid and scaled for both transforms.
  subroutine transform_kernel(self, kernel)
    type(grid_convolution), intent(inout) :: self
    real(wp), intent(in) :: kernel(1 - self%nx:, 1 - self%ny:)
    real(wp) :: scale
    integer :: j, slot, first, count

    scale = 1/(real(self%mx, wp)*self%my)
    self%kernel = 0
    do j = 1 - self%ny, self%ny - 1
      slot = modulo(j, self%ny) + 1
      self%rows(:, slot) = 0
      self%rows(1:self%nx, slot) = kernel(0:, j)*scale
      self%rows(self%mx - self%nx + 2:self%mx, slot) = kernel(:-1, j)*scale
      call fftw_execute_dft_r2c(self%rows_forward, self%rows(:, slot), self%spectra(:, slot))
      self%kernel(modulo(j, self%my) + 1, :) = self%spectra(:, slot)
    end do
    do first = 1, self%mx/2 + 1, block_columns
      count = min(block_columns, self%mx/2 + 2 - first)
      associate (columns => self%columns(:, :, 1))
        columns(:, :count) = self%kernel(:, first:first + count - 1)
        columns(:, count + 1:) = 0
        call fftw_execute_dft(self%columns_forward, columns, columns)
        self%kernel(:, first:first + count - 1) = columns(:, :count)
      end associate
    end do
  end subroutine transform_kernel

  !> Computes the convolution `y` of the field `x` with the kernel, both (nx, ny).
  subroutine convolve(self, x, y)
    class(grid_convolution), intent(inout) :: self
    real(wp), intent(in) :: x(self%nx, self%ny)
    real(wp), intent(out) :: y(self%nx, self%ny)
    integer :: j, first, thread

    !$omp parallel do schedule(static)
    do j = 1, self%ny
      self%rows(1:self%nx, j) = x(:, j)
      self%rows(self%nx + 1:self%mx, j) = 0
      call fftw_execute_dft_r2c(self%rows_forward, self%rows(:, j), self%spectra(:, j))
    end do
    !$omp parallel do private(thread) schedule(static) num_threads(size(self%columns, 3))
    do first = 1, self%mx/2 + 1, block_columns
      thread = omp_get_thread_num() + 1
      call convolve_columns(self, first, min(block_columns, self%mx/2 + 2 - first), self%columns(:, :, thread))
    end do
    !$omp parallel do schedule(static)
    do j = 1, self%ny
      call fftw_execute_dft_c2r(self%rows_backward, self%spectra(:, j), self%rows(:, j))
      y(:, j) = self%rows(1:self%nx, j)
    end do
  end subroutine convolve

  !> Convolves `count` columns of the half spectra along y, from column `first` on.
  subroutine convolve_columns(self, first, count, columns)
    class(grid_convolution), intent(inout) :: self
    integer, intent(in) :: first, count
    complex(c_double_complex), contiguous, intent(inout) :: columns(:, :)
    integer :: j, k

    do j = 1, self%ny
      do k = 1, count
        columns(j, k) = self%spectra(first + k - 1, j)
      end do
    end do
    columns(:, count + 1:) = 0
    columns(self%ny + 1:, :count) = 0
    call fftw_execute_dft(self%columns_forward, columns, columns)
    do k = 1, count
      columns(:, k) = columns(:, k)*self%kernel(:, first + k - 1)
    end do
    call fftw_execute_dft(self%columns_backward, columns, columns)
    do j = 1, self%ny
      do k = 1, count
        self%spectra(first + k - 1, j) = columns(j, k)
      end do
    end do
  end subroutine convolve_columns

  subroutine release(self)
    type(grid_convolution), intent(inout) :: self

    !$omp critical (fftw_planner)
    if (c_associated(self%rows_forward)) call fftw_destroy_plan(self%rows_forward)
    if (c_associated(self%rows_backward)) call fftw_destroy_plan(self%rows_backward)
    if (c_associated(self%columns_forward)) call fftw_destroy_plan(self%columns_forward)
    if (c_associated(self%columns_backward)) call fftw_destroy_plan(self%columns_backward)
    !$omp end critical (fftw_planner)
    if (c_associated(self%spectra_memory)) call fftw_free(self%spectra_memory)
    if (c_associated(self%columns_memory)) call fftw_free(self%columns_memory)
  end subroutine release

end module convolution
