!> Normal deflection of two elastic half-spaces in contact under constant-pressure rectangles.
!>
!> The deflection is a convolution with Love's influence coefficients (Love 1929; Johnson, Contact
!> Mechanics, eq. 3.25), even in both directions, so that zero padding to 2 (n - 1) points is exact and the
!> kernel's transform is real and even: a quarter of it is stored.
!>
!> The two-dimensional transform is done by hand, rows first and then blocks of columns that stay in cache
!> through forward transform, product and backward transform. Rows of padding are never transformed.
module pyworm_half_space
  use, intrinsic :: iso_c_binding, only: c_ptr, c_null_ptr, c_f_pointer, c_associated, c_int, c_size_t, &
    c_double_complex
  use pyworm_fftw, only: fftw_alloc_complex, fftw_free, fftw_plan_many_dft, fftw_plan_many_dft_r2c, &
    fftw_plan_many_dft_c2r, fftw_plan_r2r_2d, fftw_execute_dft, fftw_execute_dft_r2c, fftw_execute_dft_c2r, &
    fftw_execute_r2r, fftw_destroy_plan, FFTW_ESTIMATE, FFTW_FORWARD, FFTW_BACKWARD, FFTW_REDFT00
  use omp_lib, only: omp_get_max_threads, omp_get_thread_num
  use pyworm_kinds, only: wp
  use pyworm_padded_transform, only: padded_size, block_columns
  use pyworm_status, only: status_ok, status_bad_argument, status_no_plan, status_no_memory
  implicit none(type, external)
  private

  public :: elastic_half_space, new_half_space

  real(wp), parameter :: pi = acos(-1.0_wp)
  type :: elastic_half_space
    !> Points and spacing [m] of the grid.
    integer :: nx = 0, ny = 0
    real(wp) :: dx = 0, dy = 0
    !> Deflection [m/Pa] of a node under unit pressure on its own rectangle.
    real(wp) :: centre = 0
    !> Padded points along x and y.
    integer :: mx = 0, my = 0
    !> Transform of the influence coefficients over the padded size [m/Pa], (my/2+1, mx/2+1).
    real(wp), allocatable :: kernel(:, :)
    !> Half spectra of the rows, (mx/2+1, ny), and the same memory as reals, (mx+2, ny).
    complex(c_double_complex), pointer, contiguous :: spectra(:, :) => null()
    real(wp), pointer, contiguous :: rows(:, :) => null()
    !> One block of columns for each thread, (my, block_columns, threads).
    complex(c_double_complex), pointer, contiguous :: columns(:, :, :) => null()
    type(c_ptr) :: rows_forward = c_null_ptr, rows_backward = c_null_ptr
    type(c_ptr) :: columns_forward = c_null_ptr, columns_backward = c_null_ptr
    type(c_ptr) :: spectra_memory = c_null_ptr, columns_memory = c_null_ptr
  contains
    procedure :: deflection
    final :: release
  end type elastic_half_space

contains

  !> Half-space of a grid; `reduced_modulus` is E' [Pa] with 2/E' = (1-nu1^2)/E1 + (1-nu2^2)/E2.
  subroutine new_half_space(self, nx, ny, dx, dy, reduced_modulus, stat)
    type(elastic_half_space), intent(inout) :: self
    integer, intent(in) :: nx, ny
    real(wp), intent(in) :: dx, dy, reduced_modulus
    integer, intent(out) :: stat
    integer :: err, threads

    stat = status_bad_argument
    if (nx < 3 .or. ny < 3 .or. .not. (dx > 0 .and. dy > 0 .and. reduced_modulus > 0)) return
    self%nx = nx
    self%ny = ny
    self%dx = dx
    self%dy = dy
    self%mx = padded_size(2*(nx - 1))
    self%my = padded_size(2*(ny - 1))

    stat = status_no_memory
    self%spectra_memory = fftw_alloc_complex(int(self%mx/2 + 1, c_size_t)*ny)
    threads = omp_get_max_threads()
    self%columns_memory = fftw_alloc_complex(int(self%my, c_size_t)*block_columns*threads)
    if (.not. (c_associated(self%spectra_memory) .and. c_associated(self%columns_memory))) return
    call c_f_pointer(self%spectra_memory, self%spectra, [self%mx/2 + 1, ny])
    call c_f_pointer(self%spectra_memory, self%rows, [self%mx + 2, ny])
    call c_f_pointer(self%columns_memory, self%columns, [self%my, block_columns, threads])
    allocate (self%kernel(self%my/2 + 1, self%mx/2 + 1), stat=err)
    if (err /= 0) return

    call plan_transforms(self, stat)
    if (stat == status_ok) call transform_kernel(self, reduced_modulus, stat)
  end subroutine new_half_space

  subroutine plan_transforms(self, stat)
    type(elastic_half_space), intent(inout) :: self
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

  !> Computes the transform of the influence coefficients, a cosine transform of their first quadrant.
  subroutine transform_kernel(self, reduced_modulus, stat)
    type(elastic_half_space), intent(inout) :: self
    real(wp), intent(in) :: reduced_modulus
    integer, intent(out) :: stat
    type(c_ptr) :: plan
    real(wp), allocatable :: before(:), after(:)
    integer :: i, j

    !$omp critical (fftw_planner)
    ! C lists dimensions from the slowest to the fastest
    plan = fftw_plan_r2r_2d(self%mx/2 + 1, self%my/2 + 1, self%kernel, self%kernel, &
      FFTW_REDFT00, FFTW_REDFT00, FFTW_ESTIMATE)
    !$omp end critical (fftw_planner)
    stat = status_no_plan
    if (.not. c_associated(plan)) return

    allocate (before(self%my/2 + 2), after(self%my/2 + 2))
    after = corner(-self%dx/2, [((j - 1.5_wp)*self%dy, j=1, self%my/2 + 2)])
    do i = 0, self%mx/2
      ! Love's integral of 1/r over a rectangle, from its antiderivative at the four corners
      before = after
      after = corner((i + 0.5_wp)*self%dx, [((j - 1.5_wp)*self%dy, j=1, self%my/2 + 2)])
      self%kernel(:, i + 1) = after(2:) - after(:self%my/2 + 1) - before(2:) + before(:self%my/2 + 1)
    end do
    self%kernel = self%kernel*2/(pi*reduced_modulus)
    self%centre = self%kernel(1, 1)
    self%kernel = self%kernel/(real(self%mx, wp)*self%my)
    call fftw_execute_r2r(plan, self%kernel, self%kernel)
    !$omp critical (fftw_planner)
    call fftw_destroy_plan(plan)
    !$omp end critical (fftw_planner)
    stat = status_ok
  end subroutine transform_kernel

  !> Antiderivative of 1/r over x and y; no corner of an influence rectangle lies on an axis.
  elemental real(wp) function corner(x, y)
    real(wp), intent(in) :: x, y

    corner = x*asinh(y/abs(x)) + y*asinh(x/abs(y))
  end function corner

  !> Computes the sum w [m] of both bodies' deflections under pressure p [Pa], both (nx, ny).
  subroutine deflection(self, p, w)
    class(elastic_half_space), intent(inout) :: self
    real(wp), intent(in) :: p(self%nx, self%ny)
    real(wp), intent(out) :: w(self%nx, self%ny)
    integer :: j, first, thread

    !$omp parallel do schedule(static)
    do j = 1, self%ny
      self%rows(1:self%nx, j) = p(:, j)
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
      w(:, j) = self%rows(1:self%nx, j)
    end do
  end subroutine deflection

  !> Convolves `count` columns of the half spectra along y, from column `first` on.
  subroutine convolve_columns(self, first, count, columns)
    class(elastic_half_space), intent(inout) :: self
    integer, intent(in) :: first, count
    complex(c_double_complex), contiguous, intent(inout) :: columns(:, :)
    integer :: j, k, half

    half = self%my/2
    do j = 1, self%ny
      do k = 1, count
        columns(j, k) = self%spectra(first + k - 1, j)
      end do
    end do
    columns(:, count + 1:) = 0
    columns(self%ny + 1:, :count) = 0
    call fftw_execute_dft(self%columns_forward, columns, columns)
    do k = 1, count
      associate (symbol => self%kernel(:, first + k - 1))
        columns(:half + 1, k) = columns(:half + 1, k)*symbol
        columns(half + 2:, k) = columns(half + 2:, k)*symbol(half:2:-1)
      end associate
    end do
    call fftw_execute_dft(self%columns_backward, columns, columns)
    do j = 1, self%ny
      do k = 1, count
        self%spectra(first + k - 1, j) = columns(j, k)
      end do
    end do
  end subroutine convolve_columns

  subroutine release(self)
    type(elastic_half_space), intent(inout) :: self

    !$omp critical (fftw_planner)
    if (c_associated(self%rows_forward)) call fftw_destroy_plan(self%rows_forward)
    if (c_associated(self%rows_backward)) call fftw_destroy_plan(self%rows_backward)
    if (c_associated(self%columns_forward)) call fftw_destroy_plan(self%columns_forward)
    if (c_associated(self%columns_backward)) call fftw_destroy_plan(self%columns_backward)
    !$omp end critical (fftw_planner)
    if (c_associated(self%spectra_memory)) call fftw_free(self%spectra_memory)
    if (c_associated(self%columns_memory)) call fftw_free(self%columns_memory)
  end subroutine release

end module pyworm_half_space
