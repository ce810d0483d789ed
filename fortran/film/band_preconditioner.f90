!> Preconditioner of a line contact: its Jacobian with the elastic kernel truncated to a band, solved by band LU.
!>
!> Within the cut-off the model is exact, wedge and mobility included; beyond it the kernel is smooth, and the
!> constant subtracted from it acts on the rigid film. GMRES takes 2 to 4 iterations to a thousandth on the first grids and
!> 8 to 17 at 16641 nodes (M from 0.1 to 500, L from 1 to 25); a step costs about n log n.
!>
!> Rejected by measurement: dense LU of the free nodes, the same Newton steps at 0.1 s each for 1500 nodes and
!> growing with their cube, whole solves 20 to 50 times slower; the kernel's centre value alone in place of the
!> cut-off kernel, 18 to 46 iterations to a millionth where this takes 9 to 14 (1041 nodes).
module pyworm_band_preconditioner
  use pyworm_kinds, only: wp
  use pyworm_lapack, only: dgbtrf, dgbtrs
  use pyworm_status, only: status_ok, status_no_descent
  implicit none(type, external)
  private

  public :: band_model, set_band_model

  !> Distance at which the kernel is truncated [nodes].
  integer, parameter :: reach = 16
  !> Half bandwidth: the stencil reaches two nodes further.
  integer, parameter :: half = reach + 2

  type :: band_model
    !> LU factors in LAPACK's band storage.
    real(wp), allocatable :: factors(:, :)
    integer, allocatable :: pivots(:)
    !> Scale of each row.
    real(wp), allocatable :: row_scale(:)
  contains
    procedure :: solve
    procedure :: solve_transposed
  end type band_model

contains

  !> Factors the model of the Jacobian's bands (see `line_reynolds`) and the kernel by distance in nodes.
  !>
  !> The change of pressure is zero where it is not free. Between rough surfaces pressure is the total, that of the oil rises
  !> with the film by the asperities' `stiffness` [Pa/m], and where it is not free the oil's pressure is unchanged.
  subroutine set_band_model(self, by_pressure, by_film, influence, free, stat, stiffness)
    type(band_model), intent(inout) :: self
    real(wp), intent(in) :: by_pressure(:, -2:), by_film(:, -2:), influence(0:)
    logical, intent(in) :: free(:)
    integer, intent(out) :: stat
    real(wp), intent(in), optional :: stiffness(:)
    real(wp) :: kernel(-reach:reach), row(-half:half), yield(-1:size(free) + 2)
    integer :: i, j, k, n, last, info

    n = size(free)
    last = min(reach, ubound(influence, 1))
    yield = 0
    if (present(stiffness)) yield(1:n) = stiffness
    kernel = 0
    do k = -last, last
      kernel(k) = influence(abs(k)) - influence(last)
    end do
    if (.not. allocated(self%factors)) allocate (self%factors(3*half + 1, n), self%pivots(n), self%row_scale(n))
    self%factors = 0
    do i = 1, n
      row = 0
      if (free(i)) then
        row(-2:2) = by_pressure(i, :)
        do k = -2, 2
          row(k - reach:k + reach) = row(k - reach:k + reach) + (by_film(i, k) + by_pressure(i, k)*yield(i + k))*kernel
        end do
      else
        row(-reach:reach) = yield(i)*kernel
        row(0) = row(0) + 1
      end if
      ! pivoting compares rows, and the mobility of some is that of others times 1e8
      self%row_scale(i) = 1/max(maxval(abs(row)), tiny(1.0_wp))
      do j = max(1, i - half), min(n, i + half)
        self%factors(2*half + 1 + i - j, j) = row(j - i)*self%row_scale(i)
      end do
    end do
    call dgbtrf(n, n, half, half, self%factors, size(self%factors, 1), self%pivots, info)
    stat = merge(status_ok, status_no_descent, info == 0)
  end subroutine set_band_model

  !> Solves the model for one right-hand side, which must be zero where pressure is not free.
  subroutine solve(self, x)
    class(band_model), intent(in) :: self
    real(wp), contiguous, intent(inout) :: x(:)
    integer :: info

    x = x*self%row_scale
    call dgbtrs("N", size(x), half, half, 1, self%factors, size(self%factors, 1), self%pivots, x, size(x), info)
  end subroutine solve

  !> Solves the transposed model for one right-hand side.
  subroutine solve_transposed(self, x)
    class(band_model), intent(in) :: self
    real(wp), contiguous, intent(inout) :: x(:)
    integer :: info

    call dgbtrs("T", size(x), half, half, 1, self%factors, size(self%factors, 1), self%pivots, x, size(x), info)
    x = x*self%row_scale
  end subroutine solve_transposed

end module pyworm_band_preconditioner
