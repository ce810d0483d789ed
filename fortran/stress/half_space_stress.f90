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
    complex(c_float_complex), allocatable :: spectra(:, :, :)
    logical :: acting(3)
    integer :: t, k, err

    stress = 0
    stat = status_bad_argument
    if (.not. (dx > 0 .and. dy > 0 .and. all(depths >= 0))) return
    call new_kernel_transform(transform, size(tractions, 1), size(tractions, 2), stat)
    if (stat /= status_ok) return
    stat = status_no_memory
    allocate (spectra(transform%my, transform%mx/2 + 1, 3), stat=err)
    if (err /= 0) return
    do t = 1, 3
      acting(t) = any(abs(tractions(:, :, t)) > 0)
      if (acting(t)) call field_spectrum(transform, tractions(:, :, t), spectra(:, :, t))
    end do
    do k = 1, size(depths)
      call stress_at_depth(transform, spectra, acting, [dx, dy, depths(k)], poisson, stress(:, :, :, k), stat)
      if (stat /= status_ok) return
    end do
  end subroutine half_space_stress

  !> Computes the stress at one depth, the third of `spacing`, by the spectra of the tractions that act.
  subroutine stress_at_depth(transform, spectra, acting, spacing, poisson, stress, stat)
    type(field_transform), intent(inout) :: transform
    complex(c_float_complex), intent(in) :: spectra(:, :, :)
    logical, intent(in) :: acting(3)
    real(wp), intent(in) :: spacing(3), poisson
    real(wp), intent(out) :: stress(:, :, :)
    integer, intent(out) :: stat
    real(wp), allocatable :: corners(:, :, :, :), kernel(:, :)
    complex(c_float_complex), allocatable :: product(:, :), total(:, :)
    real(wp) :: unit
    integer :: component, t, err

    stat = status_no_memory
    associate (nx => transform%nx, ny => transform%ny, shape => [transform%my, transform%mx/2 + 1])
      allocate (corners(0:nx, 0:ny, 6, 3), kernel(1 - nx:nx - 1, 1 - ny:ny - 1), product(shape(1), shape(2)), &
        total(shape(1), shape(2)), stat=err)
    end associate
    if (err /= 0) return
    stat = status_ok
    call set_corners(spacing, poisson, corners)
    do component = 1, 6
      total = 0
      do t = 1, 3
        if (.not. acting(t)) cycle
        call set_kernel(corners(:, :, component, t), parity(component, t), kernel)
        call kernel_spectrum(transform, kernel, unit, product)
        total = total + real(unit, pp)*product*spectra(:, :, t)
      end do
      call spectrum_field(transform, total, 1.0_wp, stress(:, :, component))
    end do
  end subroutine stress_at_depth

  !> Computes the antiderivatives at the corners of the rectangles of one quadrant, from that about the node on.
  subroutine set_corners(spacing, poisson, corners)
    real(wp), intent(in) :: spacing(3), poisson
    real(wp), intent(out) :: corners(0:, 0:, :, :)
    integer :: i, j

    !$omp parallel do schedule(static)
    do j = 0, ubound(corners, 2)
      do i = 0, ubound(corners, 1)
        corners(i, j, :, :) = corner_stress((i - 0.5_wp)*spacing(1), (j - 0.5_wp)*spacing(2), spacing(3), poisson)
      end do
    end do
  end subroutine set_corners

  !> Computes the stress by one traction at all offsets from a rectangle, of a quadrant's corners and the parity.
  pure subroutine set_kernel(corners, parity, kernel)
    real(wp), intent(in) :: corners(0:, 0:)
    integer, intent(in) :: parity(2)
    real(wp), intent(out) :: kernel(1 - ubound(corners, 1):, 1 - ubound(corners, 2):)
    integer :: nx, ny, i, j

    nx = ubound(corners, 1)
    ny = ubound(corners, 2)
    do j = 0, ny - 1
      kernel(0:, j) = corners(1:, j + 1) - corners(:nx - 1, j + 1) - corners(1:, j) + corners(:nx - 1, j)
      do i = 1, nx - 1
        kernel(-i, j) = parity(1)*kernel(i, j)
      end do
      if (j > 0) kernel(:, -j) = parity(2)*kernel(:, j)
    end do
  end subroutine set_kernel

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
