!> Status numbers of kernel procedures, which never stop the process and never print.
!> `pyworm/kernel/core.py` turns them into exceptions.
module pyworm_status
  implicit none(type, external)
  private

  integer, parameter, public :: status_ok = 0
  !> An argument is out of range (a size, a spacing, a load).
  integer, parameter, public :: status_bad_argument = 1
  !> A field holds a value that is not finite.
  integer, parameter, public :: status_not_finite = 2
  !> The FFT library made no plan.
  integer, parameter, public :: status_no_plan = 3
  !> An iteration ended before its tolerance was met.
  integer, parameter, public :: status_not_converged = 4
  !> No step along the Newton direction lowered the residual.
  integer, parameter, public :: status_no_descent = 5
  !> Memory does not suffice.
  integer, parameter, public :: status_no_memory = 6
  !> The user interrupted the call (`interruption`); Python raises its exception first.
  integer, parameter, public :: status_interrupted = 7

end module pyworm_status
