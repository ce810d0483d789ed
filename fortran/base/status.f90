!> How a kernel procedure says that it failed: it never stops the process and never prints.
!> Python turns these numbers into sentences in one place, `pyworm/kernel/film.py`.
module status
  implicit none(type, external)
  private

  integer, parameter, public :: status_ok = 0
  !> An argument makes no sense (a size, a spacing, a load).
  integer, parameter, public :: status_bad_argument = 1
  !> A field holds a value that is not finite.
  integer, parameter, public :: status_not_finite = 2
  !> The FFT library made no plan.
  integer, parameter, public :: status_no_plan = 3
  !> An iteration ended before its tolerance was met.
  integer, parameter, public :: status_not_converged = 4
  !> No step along the Newton direction lowered the residual.
  integer, parameter, public :: status_no_descent = 5
  !> The machine has not enough memory.
  integer, parameter, public :: status_no_memory = 6
  !> The user wants no more of it (`interruption`); Python raises that before it sees this.
  integer, parameter, public :: status_interrupted = 7

end module status
