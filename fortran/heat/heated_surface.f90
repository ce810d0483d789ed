!> Base of the models of conduction in a body: the temperature of its surface under a heat flux.
module pyworm_heated_surface
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: heated_body

  !> A body whose surface is heated in the frame of the contact, in the steady state.
  type, abstract :: heated_body
    !> Points of the grid.
    integer :: nx = 0, ny = 0
    !> Temperature rise of a node under unit flux on its own cell [K m2/W].
    real(wp) :: own = 0
  contains
    procedure(rise_under), deferred :: rise
    procedure(rise_under_transposed), deferred :: rise_transposed
  end type heated_body

  abstract interface
    !> Temperature rise [K] of the surface over its bulk under the flux `q` [W/m2] into it; linear in `q`.
    subroutine rise_under(self, q, temperature_rise)
      import :: heated_body, wp
      implicit none(type, external)
      class(heated_body), intent(inout) :: self
      real(wp), intent(in) :: q(self%nx, self%ny)
      real(wp), intent(out) :: temperature_rise(self%nx, self%ny)
    end subroutine rise_under

    !> Product `by_flux` of the transposed operator of `rise` with `weight`: the derivative by the flux [m2/W] of the sum of
    !> the rise weighted so [1/K], to the rounding of `rise`.
    subroutine rise_under_transposed(self, weight, by_flux)
      import :: heated_body, wp
      implicit none(type, external)
      class(heated_body), intent(inout) :: self
      real(wp), intent(in) :: weight(self%nx, self%ny)
      real(wp), intent(out) :: by_flux(self%nx, self%ny)
    end subroutine rise_under_transposed
  end interface

end module pyworm_heated_surface
