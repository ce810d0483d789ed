!> The real kinds of the kernel.
module pyworm_kinds
  use, intrinsic :: iso_c_binding, only: c_double, c_float
  implicit none(type, external)
  private

  !> Working precision: double, the same as C's, so that arrays cross to Python uncopied.
  integer, parameter, public :: wp = c_double

  !> Precision of preconditioners, which affect the rate of convergence and not the solution.
  integer, parameter, public :: pp = c_float

end module pyworm_kinds
