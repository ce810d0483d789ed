!> Stress below the surface of a half-space under pressure and shear tractions that are constant on each grid rectangle: their
!> convolution with the stress below one rectangle (`rectangle_stress`), depth by depth.
module pyworm_half_space_stress
  use, intrinsic :: iso_c_binding, only: c_float_complex
  use pyworm_convolution, only: field_spectrum, kernel_spectrum, new_kernel_transform, spectrum_field
  use pyworm_kinds, only: pp, wp
  use pyworm_padded_transform, only: field_transform
  use pyworm_rectangle_stress, only: corner_stress, shear_x, shear_y, xy, xz, yz
  use pyworm_status, only: status_bad_argument, status_no_memory, status_ok
  implicit none(type, external)
  private

  public :: half_space_stress

contains

  !> Computes the stress [Pa], (nx, ny, component, depth), at `depths` [m] below the nodes under `tractions` [Pa], (nx, ny,
  !> traction); the order of both is that of `rectangle_stress`.
  subroutine half_space_stress(tractions, dx, dy, poisson, depths, stress, stat)
    real(wp), intent(in) :: tractions(:, :, :)
    real(wp), intent(in) :: dx, dy, poisson, depths(:)
    real(wp), intent(out) :: stress(:, :, :, :)
    integer, intent(out) :: stat
    type(field_transform) :: transform
    complex(c_float_complex), allocatable :: spectra(:, :, :), spectrum(:, :)
    real(wp), allocatable :: corners(:, :, :, :), kernel(:, :)
    integer :: t, k, component, acting, err

    stress = 0
    stat = status_bad_argument
    if (.not. (dx > 0 .and. dy > 0 .and. all(depths >= 0))) return
    call new_kernel_transform(transform, size(tractions, 1), size(tractions, 2), stat)
    if (stat /= status_ok) return
    stat = status_no_memory
    acting = merge(3, 1, any(abs(tractions(:, :, 2:)) > 0))
    associate (nx => transform%nx, ny => transform%ny, mx => transform%mx, my => transform%my)
      allocate (corners(0:nx, 0:ny, 6, acting), kernel(1 - nx:nx - 1, 1 - ny:ny - 1), spectrum(my, mx/2 + 1), &
        spectra(my, mx/2 + 1, acting), stat=err)
    end associate
    if (err /= 0) return
    stat = status_ok
    do t = 1, acting
      call field_spectrum(transform, tractions(:, :, t), spectra(:, :, t))
    end do
    do k = 1, size(depths)
      call set_corners([dx, dy, depths(k)], poisson, corners)
      do component = 1, 6
        call set_kernel(corners(:, :, component, :), component, kernel)
        call convolve_component(transform, kernel, component, spectra, spectrum, stress(:, :, component, k))
      end do
    end do
  end subroutine half_space_stress

  !> Computes the antiderivatives at the corners of the rectangles of one quadrant, from that about the node on.
  subroutine set_corners(spacing, poisson, corners)
    real(wp), intent(in) :: spacing(3), poisson
    real(wp), intent(out) :: corners(0:, 0:, :, :)
    integer :: i, j

    !$omp parallel do schedule(static)
    do j = 0, ubound(corners, 2)
      do i = 0, ubound(corners, 1)
        corners(i, j, :, :) = corner_stress((i - 0.5_wp)*spacing(1), (j - 0.5_wp)*spacing(2), spacing(3), poisson, size(corners, 4))
      end do
    end do
  end subroutine set_corners

  !> Computes a component of the stress by all tractions together at all offsets from a rectangle, of a quadrant's
  !> corners (0:nx, 0:ny, traction). Their parities differ, so that they can be told apart in the spectrum.
  subroutine set_kernel(corners, component, kernel)
    real(wp), intent(in) :: corners(0:, 0:, :)
    integer, intent(in) :: component
    real(wp), intent(out) :: kernel(1 - ubound(corners, 1):, 1 - ubound(corners, 2):)
    real(wp) :: quadrant(0:ubound(corners, 1) - 1)
    integer :: t, nx, ny, j, even(2)

    nx = ubound(corners, 1)
    ny = ubound(corners, 2)
    kernel = 0
    do t = 1, size(corners, 3)
      even = parity(component, t)
      do j = 0, ny - 1
        quadrant = corners(1:, j + 1, t) - corners(:nx - 1, j + 1, t) - corners(1:, j, t) + corners(:nx - 1, j, t)
        kernel(0:, j) = kernel(0:, j) + quadrant
        kernel(:-1, j) = kernel(:-1, j) + even(1)*quadrant(nx - 1:1:-1)
        if (j == 0) cycle
        kernel(0:, -j) = kernel(0:, -j) + even(2)*quadrant
        kernel(:-1, -j) = kernel(:-1, -j) + product(even)*quadrant(nx - 1:1:-1)
      end do
    end do
  end subroutine set_kernel

  !> Computes a component of the stress by the spectra of the tractions and the kernel of all.
  subroutine convolve_component(transform, kernel, component, spectra, spectrum, stress)
    type(field_transform), intent(inout) :: transform
    real(wp), intent(in) :: kernel(:, :)
    integer, intent(in) :: component
    complex(c_float_complex), intent(in) :: spectra(:, :, :)
    complex(c_float_complex), intent(out) :: spectrum(:, :)
    real(wp), intent(out) :: stress(:, :)
    complex(c_float_complex) :: mirrored(size(spectra, 1)), total(size(spectra, 1))
    real(wp) :: unit
    integer :: t, k, my, even(2)

    call kernel_spectrum(transform, kernel, unit, spectrum)
    my = size(spectrum, 1)
    do k = 1, size(spectrum, 2)
      mirrored(1) = spectrum(1, k)
      mirrored(2:) = spectrum(my:2:-1, k)
      total = 0
      do t = 1, size(spectra, 3)
        even = parity(component, t)
        ! parts even and odd in y; of each the real one is even in x where it is even in y, odd where it is odd
        if (product(even) == 1) then
          total = total + spectra(:, k, t)*(real(spectrum(:, k), pp) + even(2)*real(mirrored, pp))/2
        else
          total = total + spectra(:, k, t)*cmplx(0, aimag(spectrum(:, k)) + even(2)*aimag(mirrored), pp)/2
        end if
      end do
      spectrum(:, k) = total
    end do
    call spectrum_field(transform, spectrum, unit, stress)
  end subroutine convolve_component

  !> Parity by x and y, 1 or -1, of a component of the stress below a rectangle under a traction.
  pure function parity(component, traction)
    integer, intent(in) :: component, traction
    integer :: parity(2)

    parity = 1
    if (component == xy .or. component == xz) parity(1) = -1
    if (component == xy .or. component == yz) parity(2) = -1
    if (traction == shear_x) parity(1) = -parity(1)
    if (traction == shear_y) parity(2) = -parity(2)
  end function parity

end module pyworm_half_space_stress
