!> Deflection of coated bodies over that of bare ones, wave by wave (Burmister 1945; O'Sullivan and King 1988).
!>
!> A bonded layer of thickness h lies on a half-space. Waves much longer than h feel the half-space alone, much shorter ones
!> the layer alone.
module pyworm_coated_surface
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: elastic_layer, layers_of, are_coated, compliance_ratio

  !> A layer: thickness [m], zero of a bare body; Young's moduli [Pa] and Poisson's ratios of the layer and of the body.
  type :: elastic_layer
    real(wp) :: thickness = 0, youngs_modulus(2) = 0, poisson_ratio(2) = 0
  end type elastic_layer

contains

  !> Layers of both bodies from their numbers, in the order of the type's components.
  pure function layers_of(numbers) result(layers)
    real(wp), intent(in) :: numbers(5, 2)
    type(elastic_layer) :: layers(2)
    integer :: i

    layers = [(elastic_layer(numbers(1, i), numbers(2:3, i), numbers(4:5, i)), i=1, 2)]
  end function layers_of

  !> Whether a body has a layer.
  pure logical function are_coated(layers)
    type(elastic_layer), intent(in) :: layers(2)

    are_coated = any(layers%thickness > 0)
  end function are_coated

  !> Deflection of both bodies by a pressure wave of wave number k > 0 [1/m] over that without layers [-]; `reduced_modulus` is
  !> E' [Pa] without them.
  pure real(wp) function compliance_ratio(layers, reduced_modulus, k)
    type(elastic_layer), intent(in) :: layers(2)
    real(wp), intent(in) :: reduced_modulus, k
    integer :: i

    compliance_ratio = 1
    do i = 1, 2
      ! 2/E' is the sum of both bodies' (1 - nu^2)/E
      if (layers(i)%thickness > 0) compliance_ratio = compliance_ratio + added_compliance(layers(i), k)*reduced_modulus/2
    end do
  end function compliance_ratio

  !> (1 - nu^2)/E [1/Pa] of a coated body for a pressure wave, less that of the body below its layer.
  pure real(wp) function added_compliance(layer, k)
    type(elastic_layer), intent(in) :: layer
    real(wp), intent(in) :: k
    real(wp) :: shear_modulus(2), plane(2), ratio, a, b, thick, fall

    associate (nu => layer%poisson_ratio)
      shear_modulus = layer%youngs_modulus/(2*(1 + nu))
      plane = (1 - nu)/(2*shear_modulus)
      ratio = shear_modulus(1)/shear_modulus(2)
      a = 1 - 4*(1 - nu(1))/(1 + ratio*(3 - 4*nu(2)))
      b = (ratio - 1)/(ratio + 3 - 4*nu(1))
      thick = 2*k*layer%thickness
      fall = exp(-thick)
      added_compliance = plane(1)*(1 + 2*thick*b*fall - a*b*fall**2) &
        /(1 - (a + b + b*thick**2)*fall + a*b*fall**2) - plane(2)
    end associate
  end function added_compliance

end module pyworm_coated_surface
