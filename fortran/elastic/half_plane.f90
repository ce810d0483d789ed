!> Normal deflection of two elastic half-spaces in line contact under strips of constant pressure.
!>
!> A line load deflects a half-plane by a logarithm, so only differences of deflection mean anything (Johnson,
!> Contact Mechanics, section 2.4). Here a line load leaves none at the distance of the grid's length: the
!> constant is then the same on every grid over one interval, whatever its spacing.
!>
!> The product with the influence coefficients is done directly. It costs n^2, next to n^3 for the linear system
!> of `line_film`: a transform would save nothing.
module half_plane
  use kinds, only: wp
  use status, only: status_ok, status_bad_argument
  implicit none(type, external)
  private

  public :: elastic_half_plane, new_half_plane

  real(wp), parameter :: pi = acos(-1.0_wp)

  type :: elastic_half_plane
    !> Points and spacing [m] of the grid.
    integer :: n = 0
    real(wp) :: dx = 0
    !> Deflection [m/Pa] under unit pressure on one strip, by signed distance in nodes, -(n + 1) to n + 1: two
    !> more than the grid is long, for the stencils that read it.
    real(wp), allocatable :: influence(:)
  contains
    procedure :: deflection
  end type elastic_half_plane

contains

  !> Half-plane of a grid; `reduced_modulus` is E' [Pa] with 2/E' = (1-nu1^2)/E1 + (1-nu2^2)/E2.
  pure subroutine new_half_plane(self, n, dx, reduced_modulus, stat)
    type(elastic_half_plane), intent(inout) :: self
    integer, intent(in) :: n
    real(wp), intent(in) :: dx, reduced_modulus
    integer, intent(out) :: stat
    integer :: i

    stat = status_bad_argument
    if (n < 5 .or. .not. (dx > 0 .and. reduced_modulus > 0)) return
    self%n = n
    self%dx = dx
    if (allocated(self%influence)) deallocate (self%influence)
    allocate (self%influence(-(n + 1):n + 1))
    do i = 0, n + 1
      self%influence(i) = -4*dx/(pi*reduced_modulus)*(mean_log(i) - log(real(n - 1, wp)))
      self%influence(-i) = self%influence(i)
    end do
    stat = status_ok
  end subroutine new_half_plane

  !> Mean of ln|x| over a strip of unit width whose middle is `i` widths away.
  pure real(wp) function mean_log(i)
    integer, intent(in) :: i
    real(wp) :: near, far

    near = i - 0.5_wp
    far = i + 0.5_wp
    mean_log = far*log(far) - near*log(abs(near)) - 1
  end function mean_log

  !> Deflection w [m] of both bodies together under pressure p [Pa].
  pure subroutine deflection(self, p, w)
    class(elastic_half_plane), intent(in) :: self
    real(wp), contiguous, intent(in) :: p(:)
    real(wp), contiguous, intent(out) :: w(:)
    integer :: j

    w = 0
    do j = 1, self%n
      w = w + p(j)*self%influence(1 - j:self%n - j)
    end do
  end subroutine deflection

end module half_plane
