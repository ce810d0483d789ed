!> Deflection of two half-spaces by `half_space` in single precision, for the products of GMRES with changes of pressure: the
!> film itself, whose residual is to vanish, needs double.
module single_half_space
  use half_space, only: elastic_half_space
  use kinds, only: pp, wp
  use omp_lib, only: omp_get_thread_num
  use padded_transform, only: field_transform, new_field_transform, block_columns, transform_rows, transform_rows_back, &
    transform_columns, transform_columns_back
  use status, only: status_ok, status_no_memory
  implicit none(type, external)
  private

  public :: rounded_half_space, new_rounded_half_space

  type :: rounded_half_space
    type(field_transform) :: transform
    !> Deflection [m/Pa] of a node under unit pressure on its own rectangle, and the transform of the influence coefficients in
    !> its units over the padded size, (my/2+1, mx/2+1).
    real(wp) :: unit = 0
    real(pp), allocatable :: kernel(:, :)
  contains
    procedure :: deflection
  end type rounded_half_space

contains

  !> The rounded half-space of another.
  subroutine new_rounded_half_space(self, exact, stat)
    type(rounded_half_space), intent(inout) :: self
    type(elastic_half_space), intent(in) :: exact
    integer, intent(out) :: stat
    integer :: err

    call new_field_transform(self%transform, exact%nx, exact%ny, exact%mx, exact%my, stat)
    if (stat /= status_ok) return
    self%unit = exact%centre
    allocate (self%kernel(exact%my/2 + 1, exact%mx/2 + 1), stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
    if (err == 0) self%kernel(:, :) = real(exact%kernel/exact%centre, pp)
  end subroutine new_rounded_half_space

  !> Computes the sum w [m] of both bodies' deflections under pressure p [Pa], both (nx, ny).
  subroutine deflection(self, p, w)
    class(rounded_half_space), intent(inout) :: self
    real(wp), intent(in) :: p(self%transform%nx, self%transform%ny)
    real(wp), intent(out) :: w(self%transform%nx, self%transform%ny)
    integer :: first, count, k, half, thread

    half = self%transform%my/2
    call transform_rows(self%transform, p)
    !$omp parallel do private(count, k, thread) schedule(static) num_threads(size(self%transform%columns, 3))
    do first = 1, self%transform%mx/2 + 1, block_columns
      thread = omp_get_thread_num() + 1
      count = min(block_columns, self%transform%mx/2 + 2 - first)
      associate (columns => self%transform%columns(:, :, thread))
        call transform_columns(self%transform, first, count, columns)
        do k = 1, count
          associate (symbol => self%kernel(:, first + k - 1))
            columns(:half + 1, k) = columns(:half + 1, k)*symbol
            columns(half + 2:, k) = columns(half + 2:, k)*symbol(half:2:-1)
          end associate
        end do
        call transform_columns_back(self%transform, first, count, columns)
      end associate
    end do
    call transform_rows_back(self%transform, self%unit, w)
  end subroutine deflection

end module single_half_space
