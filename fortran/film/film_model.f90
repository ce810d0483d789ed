!> Model of a film: its fields, and the parts that some films have. Without them it is isothermal, Newtonian, full everywhere and
!> between smooth surfaces.
module pyworm_film_model
  use pyworm_flow_laws, only: flow_law
  use pyworm_kinds, only: wp
  use pyworm_partial_film, only: partial_film, new_partial_film
  use pyworm_reynolds, only: film_fields
  use pyworm_rough_surfaces, only: gap_curves, new_rough_film, share_total_pressure => share_pressure
  use pyworm_sheared_reynolds, only: sheared_film, new_sheared_film
  use pyworm_vectors, only: total
  implicit none(type, external)
  private

  public :: film_model

  type :: film_model
    !> With what rough surfaces add.
    type(film_fields) :: fields
    !> Flow through a film that is not Newtonian or not isothermal.
    type(sheared_film), allocatable :: shear
    !> How far the gap is filled where the supply of oil is limited.
    type(partial_film), allocatable :: partial
  contains
    procedure :: is_sheared
    procedure :: is_partial
    procedure :: is_rough
    procedure :: unsolved
    procedure :: share_pressure
    procedure :: summed_pressure
    procedure :: add_shear
    procedure :: add_roughness
    procedure :: limit_supply
  end type film_model

contains

  !> Whether the film has a flow law and levels across it.
  pure logical function is_sheared(self)
    class(film_model), intent(in) :: self

    is_sheared = allocated(self%shear)
  end function is_sheared

  !> Whether the gap may be filled in part.
  pure logical function is_partial(self)
    class(film_model), intent(in) :: self

    is_partial = allocated(self%partial)
  end function is_partial

  !> Whether the surfaces are rough.
  pure logical function is_rough(self)
    class(film_model), intent(in) :: self

    is_rough = self%fields%is_rough()
  end function is_rough

  !> Number of faces whose shear stress did not converge when the flow was last evaluated.
  pure integer function unsolved(self)
    class(film_model), intent(in) :: self

    unsolved = 0
    if (allocated(self%shear)) unsolved = self%shear%unsolved()
  end function unsolved

  !> Shares the total pressure of rough surfaces between oil and asperities, and widens the gap by their roughness.
  subroutine share_pressure(self, covered)
    class(film_model), intent(inout) :: self
    logical, intent(in) :: covered(:, :)

    if (allocated(self%fields%rough)) call share_total_pressure(self%fields%rough, covered, self%fields%p, self%fields%h)
  end subroutine share_pressure

  !> Sum over the nodes of the pressure that bears the load, of rough surfaces that of the asperities too [Pa].
  real(wp) function summed_pressure(self)
    class(film_model), intent(in) :: self

    if (allocated(self%fields%rough)) then
      summed_pressure = total(self%fields%rough%total)
    else
      summed_pressure = total(self%fields%p)
    end if
  end function summed_pressure

  !> Gives the film a flow law and levels; arguments as of `new_sheared_film`.
  subroutine add_shear(self, law, levels, sliding_x, sliding_y, stat)
    class(film_model), intent(inout) :: self
    type(flow_law), intent(in) :: law
    integer, intent(in) :: levels
    real(wp), intent(in) :: sliding_x(:, :), sliding_y(:, :)
    integer, intent(out) :: stat

    if (.not. allocated(self%shear)) allocate (self%shear)
    call new_sheared_film(law, levels, sliding_x, sliding_y, self%shear, stat)
  end subroutine add_shear

  !> Makes the surfaces rough; arguments as of `new_rough_film`.
  subroutine add_roughness(self, curves, boundary_friction, stat)
    class(film_model), intent(inout) :: self
    type(gap_curves), intent(in) :: curves
    real(wp), intent(in) :: boundary_friction
    integer, intent(out) :: stat

    if (.not. allocated(self%fields%rough)) allocate (self%fields%rough)
    call new_rough_film(curves, boundary_friction, size(self%fields%p, 1), size(self%fields%p, 2), self%fields%rough, stat)
  end subroutine add_roughness

  !> Limits the supply of oil; arguments as of `new_partial_film`.
  subroutine limit_supply(self, supply, weights, rate_x, rate_y, stat)
    class(film_model), intent(inout) :: self
    real(wp), contiguous, intent(in) :: supply(:, :), rate_x(:), rate_y(:)
    real(wp), intent(in) :: weights(3)
    integer, intent(out) :: stat

    if (.not. allocated(self%partial)) allocate (self%partial)
    call new_partial_film(size(supply, 1), size(supply, 2), supply, weights, rate_x, rate_y, self%partial, stat)
  end subroutine limit_supply

end module pyworm_film_model
