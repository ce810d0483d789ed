!> Stress below the surface of a half-plane under pressure and shear traction that are constant on each grid strip: their
!> convolution with the stress below one strip (`strip_stress`), depth by depth.
module pyworm_half_plane_stress
  use, intrinsic :: iso_c_binding, only: c_float_complex
  use pyworm_convolution, only: field_spectrum, kernel_spectrum, new_kernel_transform, spectrum_field
  use pyworm_kinds, only: pp, wp
  use pyworm_padded_transform, only: field_transform
  use pyworm_status, only: status_bad_argument, status_no_memory, status_ok
  use pyworm_strip_stress, only: strip_stress
  implicit none(type, external)
  private

  public :: half_plane_stress

contains

  !> Computes the stress [Pa], (n, component, depth), at `depths` [m] below the nodes under `tractions` [Pa], (n, traction);
  !> the order of both is that of `strip_stress`.
  subroutine half_plane_stress(tractions, dx, depths, stress, stat)
    real(wp), intent(in) :: tractions(:, :), dx, depths(:)
    real(wp), intent(out) :: stress(:, :, :)
    integer, intent(out) :: stat
    type(field_transform) :: transform
    complex(c_float_complex), allocatable :: spectra(:, :, :)
    real(wp), allocatable :: kernels(:, :, :, :)
    real(wp) :: field(size(tractions, 1), 1)
    integer :: t, k, i, n, err

    stress = 0
    stat = status_bad_argument
    if (.not. (dx > 0 .and. all(depths >= 0))) return
    n = size(tractions, 1)
    call new_kernel_transform(transform, n, 1, stat)
    if (stat /= status_ok) return
    stat = status_no_memory
    allocate (spectra(transform%my, transform%mx/2 + 1, 2), kernels(1 - n:n - 1, 1, 3, 2), stat=err)
    if (err /= 0) return
    stat = status_ok
    do t = 1, 2
      field(:, 1) = tractions(:, t)
      call field_spectrum(transform, field, spectra(:, :, t))
    end do
    do k = 1, size(depths)
      do i = 1 - n, n - 1
        kernels(i, 1, :, :) = strip_stress(i*dx, depths(k), dx)
      end do
      call add_products(transform, spectra, kernels, stress(:, :, k))
    end do
  end subroutine half_plane_stress

  !> Computes each component (n, component) by the spectra of both tractions and their kernels (offset, 1, component, traction).
  subroutine add_products(transform, spectra, kernels, stress)
    type(field_transform), intent(inout) :: transform
    complex(c_float_complex), intent(in) :: spectra(:, :, :)
    real(wp), intent(in) :: kernels(:, :, :, :)
    real(wp), intent(out) :: stress(:, :)
    complex(c_float_complex) :: product(size(spectra, 1), size(spectra, 2)), total(size(spectra, 1), size(spectra, 2))
    real(wp) :: field(size(stress, 1), 1), unit
    integer :: component, t

    do component = 1, size(stress, 2)
      total = 0
      do t = 1, size(spectra, 3)
        call kernel_spectrum(transform, kernels(:, :, component, t), unit, product)
        total = total + real(unit, pp)*product*spectra(:, :, t)
      end do
      call spectrum_field(transform, total, 1.0_wp, field)
      stress(:, component) = field(:, 1)
    end do
  end subroutine add_products

end module pyworm_half_plane_stress
