!> Normal deflection of two elastic half-spaces in line contact under strips of constant pressure.
!>
!> A line load deflects a half-plane by a logarithm, so that only differences of deflection are defined (Johnson,
!> Contact Mechanics, section 2.4). The datum here is the deflection at a distance of the grid's length, the same
!> on every grid over one interval, whatever its spacing.
!>
!> The convolution is done by FFT. Its kernel is even, so that zero padding to 2 (n - 1) points is exact.
module pyworm_half_plane
  use, intrinsic :: iso_c_binding, only: c_associated, c_double_complex, c_f_pointer, c_size_t
  use pyworm_coated_surface, only: are_coated, compliance_ratio, elastic_layer
  use pyworm_fourier_plan, only: fourier_memory, fourier_plan, plan_cosine, plan_field
  use pyworm_padded_transform, only: padded_size
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_bad_argument, status_no_plan, status_no_memory
  implicit none(type, external)
  private

  public :: elastic_half_plane, new_half_plane

  real(wp), parameter :: pi = acos(-1.0_wp)

  type :: elastic_half_plane
    !> Points and spacing [m] of the grid, and points with padding.
    integer :: n = 0, padded = 0
    real(wp) :: dx = 0
    !> Deflection [m/Pa] under unit pressure on one strip, by distance in nodes from 0 to padded/2.
    real(wp), allocatable :: influence(:)
    !> Transform of the influence coefficients over the padded size [m/Pa].
    real(wp), allocatable :: kernel(:)
    !> Half a spectrum, and the same memory as reals.
    complex(c_double_complex), pointer, contiguous :: spectrum(:) => null()
    real(wp), pointer, contiguous :: values(:) => null()
    type(fourier_plan) :: forward, backward
    type(fourier_memory) :: memory
  contains
    procedure :: coat
    procedure :: deflection
  end type elastic_half_plane

contains

  !> Half-plane of a grid; `reduced_modulus` is E' [Pa] with 2/E' = (1-nu1^2)/E1 + (1-nu2^2)/E2.
  subroutine new_half_plane(self, n, dx, reduced_modulus, stat)
    type(elastic_half_plane), intent(inout) :: self
    integer, intent(in) :: n
    real(wp), intent(in) :: dx, reduced_modulus
    integer, intent(out) :: stat
    integer :: half

    stat = status_bad_argument
    if (n < 5 .or. .not. (dx > 0 .and. reduced_modulus > 0)) return
    self%n = n
    self%dx = dx
    self%padded = padded_size(2*(n - 1))
    half = self%padded/2
    stat = status_no_memory
    call self%memory%reserve(int(half + 1, c_size_t))
    if (.not. c_associated(self%memory%address)) return
    call c_f_pointer(self%memory%address, self%spectrum, [half + 1])
    call c_f_pointer(self%memory%address, self%values, [self%padded + 2])

    allocate (self%influence(0:half), self%kernel(0:half))
    call set_influence(self, reduced_modulus)
    call plan_field([self%padded], self%values, self%spectrum, self%forward, self%backward)
    stat = merge(status_ok, status_no_plan, self%forward%made() .and. self%backward%made())
    if (stat == status_ok) call transform_kernel(self, stat)
  end subroutine new_half_plane

  pure subroutine set_influence(self, reduced_modulus)
    type(elastic_half_plane), intent(inout) :: self
    real(wp), intent(in) :: reduced_modulus
    integer :: i

    do i = 0, self%padded/2
      self%influence(i) = -4*self%dx/(pi*reduced_modulus)*(mean_log(i) - log(real(self%n - 1, wp)))
    end do
  end subroutine set_influence

  !> Mean of ln|x| over a strip of unit width whose middle is `i` widths away.
  pure real(wp) function mean_log(i)
    integer, intent(in) :: i
    real(wp) :: near, far

    ! the antiderivative of ln|x| is x ln|x| - x
    near = i - 0.5_wp
    far = i + 0.5_wp
    mean_log = far*log(far) - near*log(abs(near)) - 1
  end function mean_log

  !> Computes the transform of the influence coefficients, a cosine transform of their first half.
  subroutine transform_kernel(self, stat)
    type(elastic_half_plane), intent(inout) :: self
    integer, intent(out) :: stat
    type(fourier_plan) :: plan
    real(wp) :: image(0:self%padded/2)

    call plan_cosine(shape(image), image, self%kernel, plan)
    stat = merge(status_ok, status_no_plan, plan%made())
    if (stat /= status_ok) return
    image = self%influence/self%padded
    call plan%cosine(image, self%kernel)
  end subroutine transform_kernel

  !> Coats bodies whose E' [Pa] without layers is `reduced_modulus`: multiplies the kernel's transform by the ratio of deflections
  !> with layers to those without, and sets the influence coefficients by it. Zero wave number as of `half_space`.
  subroutine coat(self, reduced_modulus, layers, stat)
    class(elastic_half_plane), intent(inout) :: self
    real(wp), intent(in) :: reduced_modulus
    type(elastic_layer), intent(in) :: layers(2)
    integer, intent(out) :: stat
    type(fourier_plan) :: plan
    real(wp) :: image(0:self%padded/2), k
    integer :: i

    stat = status_ok
    if (.not. are_coated(layers)) return
    do i = 0, self%padded/2
      k = 2*pi*i/(self%padded*self%dx)
      if (i == 0) k = 4/(reduced_modulus*self%kernel(0)*self%padded)
      self%kernel(i) = self%kernel(i)*compliance_ratio(layers, reduced_modulus, k)
    end do
    call plan_cosine(shape(image), image, self%influence, plan)
    stat = merge(status_ok, status_no_plan, plan%made())
    if (stat /= status_ok) return
    image = self%kernel
    call plan%cosine(image, self%influence)
  end subroutine coat

  !> Computes the sum w [m] of both bodies' deflections under pressure p [Pa].
  subroutine deflection(self, p, w)
    class(elastic_half_plane), intent(inout) :: self
    real(wp), intent(in) :: p(self%n)
    real(wp), intent(out) :: w(self%n)

    self%values(:self%n) = p
    self%values(self%n + 1:) = 0
    call self%forward%to_spectrum(self%values, self%spectrum)
    self%spectrum = self%spectrum*self%kernel
    call self%backward%to_field(self%spectrum, self%values)
    w = self%values(:self%n)
  end subroutine deflection

end module pyworm_half_plane
