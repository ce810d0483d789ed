!> The one real kind of the kernel.
module kinds
  use, intrinsic :: iso_c_binding, only: c_double
  implicit none(type, external)
  private

  !> Double precision, the same as C's, so that arrays cross to Python uncopied.
  integer, parameter, public :: wp = c_double

end module kinds
