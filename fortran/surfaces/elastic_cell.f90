!> Elastic half-space under a pressure that repeats itself: deflection of a pressure and pressure of a deflection.
!>
!> In wavenumbers, pressure is E' |k| / 4 times deflection (Johnson, Contact Mechanics, section 13.2, with
!> E* = E'/2). The mean of the deflection is left out: it belongs to the bodies' shape, not to one cell of their surface.
module pyworm_elastic_cell
  use, intrinsic :: iso_c_binding, only: c_associated, c_double_complex, c_f_pointer, c_size_t
  use pyworm_fourier_plan, only: fourier_memory, fourier_plan, plan_field
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_bad_argument, status_no_memory, status_no_plan
  implicit none(type, external)
  private

  public :: elastic_surface, new_elastic_surface

  real(wp), parameter :: pi = acos(-1.0_wp)

  !> A periodic cell of nx by ny nodes.
  type :: elastic_surface
    integer :: nx = 0, ny = 0
    !> Deflection over pressure [m/Pa] of each wave, zero of the mean, and pressure over deflection [Pa/m].
    real(wp), allocatable :: compliance(:, :), stiffness(:, :)
    !> One field, and its half spectrum in the same memory.
    real(wp), pointer, contiguous :: field(:, :) => null()
    complex(c_double_complex), pointer, contiguous :: spectrum(:, :) => null()
    type(fourier_plan) :: forward, backward
    type(fourier_memory) :: memory
  contains
    procedure :: deflection
    procedure :: pressure
  end type elastic_surface

contains

  !> Makes a cell of nx by ny nodes, dx and dy [m] apart, on half-spaces of reduced modulus E' [Pa].
  subroutine new_elastic_surface(self, nx, ny, dx, dy, reduced_modulus, stat)
    type(elastic_surface), intent(inout) :: self
    integer, intent(in) :: nx, ny
    real(wp), intent(in) :: dx, dy, reduced_modulus
    integer, intent(out) :: stat
    real(wp) :: kx, ky
    integer :: i, j, err

    stat = status_bad_argument
    if (.not. (nx >= 4 .and. ny >= 4 .and. dx > 0 .and. dy > 0 .and. reduced_modulus > 0)) return
    self%nx = nx
    self%ny = ny
    stat = status_no_memory
    call self%memory%reserve(int(nx/2 + 1, c_size_t)*ny)
    if (.not. c_associated(self%memory%address)) return
    call c_f_pointer(self%memory%address, self%spectrum, [nx/2 + 1, ny])
    call c_f_pointer(self%memory%address, self%field, [2*(nx/2 + 1), ny])
    allocate (self%compliance(nx/2 + 1, ny), self%stiffness(nx/2 + 1, ny), source=0.0_wp, stat=err)
    if (err /= 0) return
    do j = 1, ny
      ky = 2*pi*min(j - 1, ny - j + 1)/(ny*dy)
      do i = 1, nx/2 + 1
        kx = 2*pi*(i - 1)/(nx*dx)
        self%stiffness(i, j) = reduced_modulus*hypot(kx, ky)/4
        if (i + j > 2) self%compliance(i, j) = 1/self%stiffness(i, j)
      end do
    end do
    self%stiffness(1, 1) = min(self%stiffness(2, 1), self%stiffness(1, 2))

    call plan_field([nx, ny], self%field, self%spectrum, self%forward, self%backward)
    stat = merge(status_ok, status_no_plan, self%forward%made() .and. self%backward%made())
  end subroutine new_elastic_surface

  !> Deflection w [m] under pressure p [Pa], both without their mean.
  subroutine deflection(self, p, w)
    class(elastic_surface), intent(inout) :: self
    real(wp), intent(in) :: p(self%nx, self%ny)
    real(wp), intent(out) :: w(self%nx, self%ny)

    self%field(:self%nx, :) = p
    call self%forward%to_spectrum(self%field, self%spectrum)
    self%spectrum = self%spectrum*(self%compliance/(real(self%nx, wp)*self%ny))
    call self%backward%to_field(self%spectrum, self%field)
    w = self%field(:self%nx, :)
  end subroutine deflection

  !> Pressure p [Pa] of a deflection w [m], whose mean is taken to be as stiff as the longest wave.
  subroutine pressure(self, w, p)
    class(elastic_surface), intent(inout) :: self
    real(wp), intent(in) :: w(self%nx, self%ny)
    real(wp), intent(out) :: p(self%nx, self%ny)

    self%field(:self%nx, :) = w
    call self%forward%to_spectrum(self%field, self%spectrum)
    self%spectrum = self%spectrum*(self%stiffness/(real(self%nx, wp)*self%ny))
    call self%backward%to_field(self%spectrum, self%field)
    p = self%field(:self%nx, :)
  end subroutine pressure

end module pyworm_elastic_cell
