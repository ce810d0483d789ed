!> Thermal stress in a half-space whose surface temperature is steady as seen from the contact.
!>
!> Heat moves with the body at a velocity V and by conduction, V.grad T = kappa lap T (Carslaw and Jaeger 1959). A wave k of
!> the surface temperature decays with depth by s, s^2 = k^2 + i k.V/kappa; Goodier's potential of thermoelastic displacement
!> is (1 + nu) alpha T/((1 - nu)(s^2 - k^2)), and an isothermal field frees the surface of its tractions (Boley and Weiner
!> 1960). Inertia and the heat of deformation are neglected.
module pyworm_thermal_stress
  use, intrinsic :: iso_c_binding, only: c_float_complex
  use pyworm_convolution, only: field_spectrum, spectrum_field
  use pyworm_kinds, only: pp, wp
  use pyworm_padded_transform, only: field_transform, new_field_transform
  use pyworm_status, only: status_bad_argument, status_no_memory, status_ok
  implicit none(type, external)
  private

  public :: thermal_solid, thermal_stress

  !> What the stress depends on: E alpha/(1 - nu) [Pa/K], Poisson's ratio, diffusivity [m2/s], and the velocity of the body's
  !> material past the contact [m/s].
  type :: thermal_solid
    real(wp) :: restrained, poisson, diffusivity, velocity(2)
  end type thermal_solid

  real(wp), parameter :: pi = acos(-1.0_wp)
  !> Wave number of the mean temperature over that of the longest wave: as good as none.
  real(wp), parameter :: mean_number = 1e-6_wp
  !> Depth by wave number beyond which nothing is left in single precision.
  real(wp), parameter :: deepest = 16
  !> Amplitude over the largest below which a wave is left out: less than rounding.
  real(wp), parameter :: smallest = 1e-7_wp
  !> (s - k) times depth below which both waves count as equal.
  real(wp), parameter :: alike = 1e-8_wp

contains

  !> Computes the stress [Pa], (nx, ny, component, depth), at `depths` [m] below some nodes, the `first` on, of a rise of the
  !> surface temperature [K]. The rise repeats periodically; its number of nodes along x is even, and one row stands for a
  !> line contact in plane strain. Components are those of `rectangle_stress`.
  subroutine thermal_stress(rise, spacing, solid, first, depths, stress, stat)
    real(wp), intent(in) :: rise(:, :), spacing(2), depths(:)
    type(thermal_solid), intent(in) :: solid
    integer, intent(in) :: first(2)
    real(wp), intent(out) :: stress(:, :, :, :)
    integer, intent(out) :: stat
    type(field_transform) :: forward, backward
    complex(c_float_complex), allocatable :: spectrum(:, :), below(:, :, :)
    integer :: mx, my, k, component, counted, err

    stress = 0
    mx = size(rise, 1)
    my = size(rise, 2)
    stat = status_bad_argument
    if (.not. (all(spacing > 0) .and. all(depths >= 0) .and. solid%diffusivity > 0)) return
    if (mx < 2 .or. mod(mx, 2) /= 0 .or. any(first < 1 .or. first + [size(stress, 1), size(stress, 2)] - 1 > [mx, my])) return
    call new_field_transform(forward, mx, my, mx, my, stat)
    if (stat == status_ok) call new_field_transform(backward, size(stress, 1), size(stress, 2), mx, my, stat)
    if (stat /= status_ok) return
    stat = status_no_memory
    allocate (spectrum(my, mx/2 + 1), below(my, mx/2 + 1, size(stress, 3)), stat=err)
    if (err /= 0) return
    stat = status_ok
    ! the wanted nodes come first
    call field_spectrum(forward, cshift(cshift(rise, first(1) - 1, 1), first(2) - 1, 2), spectrum)
    spectrum = spectrum*real(solid%restrained/(real(mx, wp)*my), pp)
    do k = 1, size(depths)
      counted = int(min(deepest/max(depths(k), 1e-30_wp)*mx*spacing(1)/(2*pi), mx/2.0_wp)) + 1
      call set_waves(spectrum(:, :counted), mx, spacing, solid, depths(k), below(:, :counted, :))
      do component = 1, size(stress, 3)
        call spectrum_field(backward, below(:, :counted, component), 1.0_wp, stress(:, :, component, k))
      end do
    end do
  end subroutine thermal_stress

  !> Computes the waves (my, mx/2+1, component) of the stress at depth `z` by those of E alpha T/(1 - nu).
  subroutine set_waves(spectrum, mx, spacing, solid, z, below)
    complex(c_float_complex), intent(in) :: spectrum(:, :)
    integer, intent(in) :: mx
    real(wp), intent(in) :: spacing(2), z
    type(thermal_solid), intent(in) :: solid
    complex(c_float_complex), intent(out) :: below(:, :, :)
    complex(c_float_complex) :: column(size(below, 3), size(spectrum, 1))
    real(wp) :: unit(2), longest, number(2), k, counted
    integer :: i, j, my

    my = size(spectrum, 1)
    unit = 2*pi/(spacing*[mx, my])
    counted = smallest**2*maxval(real(spectrum)**2 + aimag(spectrum)**2)
    longest = merge(minval(unit), unit(1), my > 1)
    !$omp parallel do private(j, number, k, column) schedule(static)
    do i = 1, size(spectrum, 2)
      do j = 1, my
        number = unit*[i - 1, modulo(j - 1 + my/2, my) - my/2]
        k = sqrt(number(1)**2 + number(2)**2)
        if (i == 1 .and. j == 1) then
          ! the mean is heated for as long as the longest wave takes to pass
          column(:, j) = wave_stress([mean_number*longest, 0.0_wp], longest*norm2(solid%velocity), solid, z)*spectrum(j, i)
        else if (k*z > deepest .or. real(spectrum(j, i))**2 + aimag(spectrum(j, i))**2 < counted) then
          column(:, j) = 0
        else
          column(:, j) = wave_stress(number, dot_product(number, solid%velocity), solid, z)*spectrum(j, i)
        end if
      end do
      below(:, i, :) = transpose(column)
    end do
  end subroutine set_waves

  !> Stress at a depth below a wave of the temperature over E alpha/(1 - nu) of it, so written that steady heat, s = k, is its
  !> limit. `carried` is k.V. Particular and isothermal part share exp(-k z); `depth` is (1 - exp(-(s - k) z))/(s - k).
  pure function wave_stress(number, carried, solid, z) result(stress)
    real(wp), intent(in) :: number(2), carried, z
    type(thermal_solid), intent(in) :: solid
    complex(c_float_complex) :: stress(6)
    complex(wp) :: s, total, difference, decay, depth, scale, along, across, shear
    real(wp) :: k, direction(2), wide, fall

    k = sqrt(number(1)**2 + number(2)**2)
    direction = number/k
    wide = carried/solid%diffusivity
    s%re = sqrt((sqrt(k**4 + wide**2) + k**2)/2)
    s%im = wide/(2*s%re)
    total = s + k
    fall = exp(-k*z)
    scale = conjg(total)/(total%re**2 + total%im**2) ! 1/(s + k), which the processor divides more slowly
    difference = cmplx(0, wide, wp)*scale
    decay = exp(-difference*z)
    depth = z
    if ((difference%re**2 + difference%im**2)*z**2 > alike**2) depth = (1 - decay)*total*cmplx(0, -1/wide, wp)
    scale = fall*scale
    along = scale*(cmplx(k**2, wide, wp)*depth - difference - k**2*z)
    across = 2*solid%poisson*k*scale - fall*decay
    shear = cmplx(0, k, wp)*scale*(s*depth - k*z)
    associate (c => direction(1), s_ => direction(2))
      stress = cmplx([c**2*along + s_**2*across, s_**2*along + c**2*across, scale*k**2*(z - depth), &
        c*s_*(along - across), c*shear, s_*shear], kind=pp)
    end associate
  end function wave_stress

end module pyworm_thermal_stress
