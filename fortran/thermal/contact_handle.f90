!> A contact as an integer that a caller in another language may hold.
module pyworm_contact_handle
  use, intrinsic :: iso_c_binding, only: c_int64_t, c_loc, c_null_ptr, c_f_pointer
  use pyworm_thermal_step, only: thermal_contact
  implicit none(type, external)
  private

  public :: handle_of, contact_of

contains

  !> The contact's address.
  integer(c_int64_t) function handle_of(contact)
    type(thermal_contact), pointer, intent(in) :: contact

    handle_of = transfer(c_loc(contact), handle_of)
  end function handle_of

  !> The contact at an address that `handle_of` gave.
  function contact_of(handle) result(contact)
    integer(c_int64_t), intent(in) :: handle
    type(thermal_contact), pointer :: contact

    call c_f_pointer(transfer(handle, c_null_ptr), contact)
  end function contact_of

end module pyworm_contact_handle
