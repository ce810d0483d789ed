!> Normal deflection of two elastic half-spaces in contact under constant-pressure rectangles.
!>
!> The deflection is a convolution with Love's influence coefficients (Love 1929; Johnson, Contact
!> Mechanics, eq. 3.25), even in both directions, so that zero padding to 2 (n - 1) points is exact and the
!> kernel's transform is real and even: a quarter of it is stored.
!>
!> The two-dimensional transform is done by hand, rows first and then blocks of columns that stay in cache
!> through forward transform, product and backward transform. Rows of padding are never transformed.
module pyworm_half_space
  use, intrinsic :: iso_c_binding, only: c_associated, c_double_complex, c_f_pointer, c_size_t
  use pyworm_coated_surface, only: are_coated, compliance_ratio, elastic_layer
  use pyworm_fourier_plan, only: fourier_memory, fourier_plan, plan_columns, plan_cosine, plan_field
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
    !> E' [Pa], with 2/E' = (1-nu1^2)/E1 + (1-nu2^2)/E2.
    real(wp) :: reduced_modulus = 0
    !> Layers on the bodies, whose E' is that without them.
    type(elastic_layer) :: layers(2) = elastic_layer()
    !> Deflection [m/Pa] of a node under unit pressure on its own rectangle.
    real(wp) :: centre = 0
    !> Factor of it by the layers [-].
    real(wp) :: centre_ratio = 1
    !> Padded points along x and y.
    integer :: mx = 0, my = 0
    !> Transform of the influence coefficients over the padded size [m/Pa], (my/2+1, mx/2+1).
    real(wp), allocatable :: kernel(:, :)
    !> Half spectra of the rows, (mx/2+1, ny), and the same memory as reals, (mx+2, ny).
    complex(c_double_complex), pointer, contiguous :: spectra(:, :) => null()
    real(wp), pointer, contiguous :: rows(:, :) => null()
    !> One block of columns for each thread, (my, block_columns, threads).
    complex(c_double_complex), pointer, contiguous :: columns(:, :, :) => null()
    type(fourier_plan) :: rows_forward, rows_backward, columns_forward, columns_backward
    type(fourier_memory) :: spectra_memory, columns_memory
  contains
    procedure :: deflection
  end type elastic_half_space

contains

  !> Half-space of a grid; `reduced_modulus` is E' [Pa] with 2/E' = (1-nu1^2)/E1 + (1-nu2^2)/E2, without layers.
  subroutine new_half_space(self, nx, ny, dx, dy, reduced_modulus, stat, layers)
    type(elastic_half_space), intent(inout) :: self
    integer, intent(in) :: nx, ny
    real(wp), intent(in) :: dx, dy, reduced_modulus
    integer, intent(out) :: stat
    type(elastic_layer), intent(in), optional :: layers(2)
    integer :: err, threads

    stat = status_bad_argument
    if (nx < 3 .or. ny < 3 .or. .not. (dx > 0 .and. dy > 0 .and. reduced_modulus > 0)) return
    self%nx = nx
    self%ny = ny
    self%dx = dx
    self%dy = dy
    self%reduced_modulus = reduced_modulus
    if (present(layers)) self%layers = layers
    self%mx = padded_size(2*(nx - 1))
    self%my = padded_size(2*(ny - 1))

    stat = status_no_memory
    threads = omp_get_max_threads()
    call self%spectra_memory%reserve(int(self%mx/2 + 1, c_size_t)*ny)
    call self%columns_memory%reserve(int(self%my, c_size_t)*block_columns*threads)
    if (.not. (c_associated(self%spectra_memory%address) .and. c_associated(self%columns_memory%address))) return
    call c_f_pointer(self%spectra_memory%address, self%spectra, [self%mx/2 + 1, ny])
    call c_f_pointer(self%spectra_memory%address, self%rows, [self%mx + 2, ny])
    call c_f_pointer(self%columns_memory%address, self%columns, [self%my, block_columns, threads])
    allocate (self%kernel(self%my/2 + 1, self%mx/2 + 1), stat=err)
    if (err /= 0) return

    call plan_field([self%mx], self%rows, self%spectra, self%rows_forward, self%rows_backward)
    call plan_columns(self%my, block_columns, self%columns, self%columns_forward, self%columns_backward)
    stat = merge(status_ok, status_no_plan, self%rows_forward%made() .and. self%rows_backward%made() &
      .and. self%columns_forward%made() .and. self%columns_backward%made())
    if (stat == status_ok) call transform_kernel(self, reduced_modulus, stat)
  end subroutine new_half_space

  !> Computes the transform of the influence coefficients, a cosine transform of their first quadrant.
  subroutine transform_kernel(self, reduced_modulus, stat)
    type(elastic_half_space), intent(inout) :: self
    real(wp), intent(in) :: reduced_modulus
    integer, intent(out) :: stat
    type(fourier_plan) :: plan
    real(wp), allocatable :: before(:), after(:)
    integer :: i, j

    call plan_cosine(shape(self%kernel), self%kernel, self%kernel, plan)
    stat = merge(status_ok, status_no_plan, plan%made())
    if (stat /= status_ok) return

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
    call plan%cosine(self%kernel, self%kernel)
    if (are_coated(self%layers)) call coat_kernel(self)
  end subroutine transform_kernel

  !> Multiplies the kernel's transform by the ratio of deflections with layers to those without.
  !>
  !> Below a uniform pressure the padded grid deflects as below a wave of finite length: the wave number that gives this
  !> deflection stands for zero.
  subroutine coat_kernel(self)
    type(elastic_half_space), intent(inout) :: self
    real(wp) :: bare, coated, k
    integer :: i, j, twins

    bare = 0
    coated = 0
    do i = 0, self%mx/2
      do j = 0, self%my/2
        k = 2*pi*hypot(i/(self%mx*self%dx), j/(self%my*self%dy))
        if (i + j == 0) k = 4/(self%reduced_modulus*self%kernel(1, 1)*self%mx*self%my)
        ! waves of the other half of the spectrum along each direction are the same
        twins = merge(1, 2, i == 0 .or. i == self%mx/2)*merge(1, 2, j == 0 .or. j == self%my/2)
        bare = bare + twins*self%kernel(j + 1, i + 1)
        self%kernel(j + 1, i + 1) = self%kernel(j + 1, i + 1)*compliance_ratio(self%layers, self%reduced_modulus, k)
        coated = coated + twins*self%kernel(j + 1, i + 1)
      end do
    end do
    self%centre_ratio = coated/bare
  end subroutine coat_kernel

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
      call self%rows_forward%to_spectrum(self%rows(:, j), self%spectra(:, j))
    end do
    !$omp parallel do private(thread) schedule(static) num_threads(size(self%columns, 3))
    do first = 1, self%mx/2 + 1, block_columns
      thread = omp_get_thread_num() + 1
      call convolve_columns(self, first, min(block_columns, self%mx/2 + 2 - first), self%columns(:, :, thread))
    end do
    !$omp parallel do schedule(static)
    do j = 1, self%ny
      call self%rows_backward%to_field(self%spectra(:, j), self%rows(:, j))
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
    call self%columns_forward%in_place(columns)
    do k = 1, count
      associate (symbol => self%kernel(:, first + k - 1))
        columns(:half + 1, k) = columns(:half + 1, k)*symbol
        columns(half + 2:, k) = columns(half + 2:, k)*symbol(half:2:-1)
      end associate
    end do
    call self%columns_backward%in_place(columns)
    do j = 1, self%ny
      do k = 1, count
        self%spectra(first + k - 1, j) = columns(j, k)
      end do
    end do
  end subroutine convolve_columns

end module pyworm_half_space
