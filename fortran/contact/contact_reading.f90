!> Fields of a contact's film on the grid that was given, interpolated where the film is that of a coarser one.
module pyworm_contact_reading
  use pyworm_contact_description, only: pyworm_fields
  use pyworm_contact_iteration, only: oil_pressure
  use pyworm_contact_state, only: contact_state
  use pyworm_cubic_refinement, only: interpolate_cubic
  use pyworm_kinds, only: wp
  use pyworm_shear_fields, only: nodal_shear, shear_field
  use pyworm_status, only: status_ok
  implicit none(type, external)
  private

  public :: read_fields

contains

  !> Reads all fields that the film has.
  subroutine read_fields(contact, fields, stat)
    type(contact_state), intent(in) :: contact
    type(pyworm_fields), intent(out) :: fields
    integer, intent(out) :: stat
    type(shear_field) :: shear
    integer :: nodes(2), k

    stat = status_ok
    nodes = shape(contact%scene%gap)
    associate (model => contact%film%film%model)
      fields%p = max(on_given_grid(contact%p, nodes), 0.0_wp)
      fields%h = on_given_grid(model%fields%h, nodes)
      fields%asperity_pressure = on_given_grid(contact%p - oil_pressure(contact), nodes)
      allocate (fields%fraction(nodes(1), nodes(2)), source=1.0_wp)
      if (model%is_partial()) fields%fraction = on_given_grid(reshape(model%partial%fraction, shape(contact%p)), nodes)
      if (.not. model%is_sheared()) return
      call nodal_shear(contact%film%film, .false., shear, stat)
      if (stat /= status_ok) return
      fields%stress_x = on_given_grid(shear%stress_x, nodes)
      fields%stress_y = on_given_grid(shear%stress_y, nodes)
      fields%heat = on_given_grid(shear%friction, nodes)
      allocate (fields%rise(nodes(1), nodes(2), size(model%shear%nodes%rise, 3)))
      do k = 1, size(fields%rise, 3)
        fields%rise(:, :, k) = on_given_grid(model%shear%nodes%rise(:, :, k), nodes)
      end do
    end associate
  end subroutine read_fields

  !> A field on its own grid or, by cubics, on a finer one over the same window.
  pure recursive function on_given_grid(field, nodes) result(given)
    real(wp), intent(in) :: field(:, :)
    integer, intent(in) :: nodes(2)
    real(wp) :: given(nodes(1), nodes(2))
    real(wp), allocatable :: finer(:, :)

    if (size(field, 1) >= nodes(1)) then
      given = field
      return
    end if
    allocate (finer(2*size(field, 1) - 1, 2*size(field, 2) - 1))
    call interpolate_cubic(field, finer)
    given = on_given_grid(finer, nodes)
  end function on_given_grid

end module pyworm_contact_reading
