!> Status numbers of kernel procedures, which never stop the process and never print, and their texts.
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
  !> A film was found, and is less accurate than asked for.
  integer, parameter, public :: status_inaccurate = 8

  !> Texts of the numbers from `status_ok` on.
  character(len=*), parameter :: texts(0:8) = [character(len=60) :: 'no error', &
    'a size, a spacing, a load or a first guess makes no sense', 'a field holds a value that is not finite', &
    'the FFT library made no plan', 'the iteration ended before its tolerance was met', &
    'no step along the Newton direction lowers the residual', 'there is not enough memory', 'it was interrupted', &
    'the film is less accurate than asked for']

  public :: status_message

contains

  !> Text of a status number.
  pure function status_message(stat) result(message)
    integer, intent(in) :: stat
    character(len=:), allocatable :: message

    message = 'unknown status'
    if (stat >= lbound(texts, 1) .and. stat <= ubound(texts, 1)) message = trim(texts(stat))
  end function status_message

end module pyworm_status
