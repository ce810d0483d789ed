!> Pressure of a half-space by its deflection, approximately: a preconditioner where viscous oil is transported.
!>
!> A pressure wave of wave number q deflects two half-spaces by 4 p/(E' q), with E' as of `half_space`, and
!> compresses the oil between them. Both are divided out in the Fourier transform; what the field's ends do to each other is left
!> to the iteration that this precedes.
module pyworm_elastic_inverse
  use pyworm_kinds, only: pp, wp
  use omp_lib, only: omp_get_thread_num
  use pyworm_padded_transform, only: field_transform, new_field_transform, padded_size, block_columns, transform_rows, &
    transform_rows_back, transform_columns, transform_columns_back
  use pyworm_status, only: status_ok, status_no_memory
  implicit none(type, external)
  private

  public :: elastic_inverse, new_elastic_inverse, set_compression

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Wave number of the mean over that of the longest wave: the mean of 1/q over the cell of the spectrum about zero.
  real(wp), parameter :: mean_wave = 0.28_wp

  type :: elastic_inverse
    type(field_transform) :: transform
    !> E'/4 [Pa], and spacing of the spectrum along x and y [1/m].
    real(wp) :: stiffness = 0, wave(2) = 0
    !> Pressure by deflection over the padded size [Pa/m], (my, mx/2+1).
    real(pp), allocatable :: symbol(:, :)
  contains
    procedure :: pressure
  end type elastic_inverse

contains

  !> Inverse on a grid; `reduced_modulus` is E' [Pa] as of `new_half_space`.
  subroutine new_elastic_inverse(self, nx, ny, dx, dy, reduced_modulus, stat)
    type(elastic_inverse), intent(inout) :: self
    integer, intent(in) :: nx, ny
    real(wp), intent(in) :: dx, dy, reduced_modulus
    integer, intent(out) :: stat
    integer :: err

    call new_field_transform(self%transform, nx, ny, padded_size(nx), padded_size(ny), stat)
    if (stat /= status_ok) return
    self%stiffness = reduced_modulus/4
    self%wave = 2*pi/[self%transform%mx*dx, self%transform%my*dy]
    allocate (self%symbol(self%transform%my, self%transform%mx/2 + 1), source=0.0_pp, stat=err)
    if (err /= 0) stat = status_no_memory
  end subroutine new_elastic_inverse

  !> Sets the compression of the film by pressure [m/Pa], and its mobility over the rate of the time step [m3/Pa].
  subroutine set_compression(self, compression, mobility)
    type(elastic_inverse), intent(inout) :: self
    real(wp), intent(in) :: compression, mobility
    real(wp) :: q
    integer :: i, j

    associate (t => self%transform)
      do i = 0, t%mx/2
        do j = 0, t%my - 1
          q = hypot(i*self%wave(1), min(j, t%my - j)*self%wave(2))
          if (.not. q > 0) q = mean_wave*minval(self%wave)
          self%symbol(j + 1, i + 1) = real(1/((1/(self%stiffness*q) + compression + mobility*q**2)*t%mx*t%my), pp)
        end do
      end do
    end associate
  end subroutine set_compression

  !> Computes the pressure p [Pa] of a deflection and compression w [m], both (nx, ny).
  subroutine pressure(self, w, p)
    class(elastic_inverse), intent(inout) :: self
    real(wp), intent(in) :: w(self%transform%nx, self%transform%ny)
    real(wp), intent(out) :: p(self%transform%nx, self%transform%ny)
    integer :: first, count, thread, k

    call transform_rows(self%transform, w)
    !$omp parallel do private(count, k, thread) schedule(static) num_threads(size(self%transform%columns, 3))
    do first = 1, self%transform%mx/2 + 1, block_columns
      thread = omp_get_thread_num() + 1
      count = min(block_columns, self%transform%mx/2 + 2 - first)
      associate (columns => self%transform%columns(:, :, thread))
        call transform_columns(self%transform, first, count, columns)
        do k = 1, count
          columns(:, k) = columns(:, k)*self%symbol(:, first + k - 1)
        end do
        call transform_columns_back(self%transform, first, count, columns)
      end associate
    end do
    call transform_rows_back(self%transform, 1.0_wp, p)
  end subroutine pressure

end module pyworm_elastic_inverse
