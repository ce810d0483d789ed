!> What `interruption` asks of Python, for programs without it: nobody interrupts them.
module no_python
  use, intrinsic :: iso_c_binding, only: c_int, c_null_ptr, c_ptr
  implicit none(type, external)
  private

  public :: ensure_python, release_python, check_signals, exception_set

contains

  !> The lock that there is none of.
  integer(c_int) function ensure_python() bind(c, name="PyGILState_Ensure")
    ensure_python = 0
  end function ensure_python

  !> Gives it back.
  subroutine release_python(state) bind(c, name="PyGILState_Release")
    integer(c_int), value :: state

    if (state /= 0) return
  end subroutine release_python

  !> No signals.
  integer(c_int) function check_signals() bind(c, name="PyErr_CheckSignals")
    check_signals = 0
  end function check_signals

  !> No exceptions.
  type(c_ptr) function exception_set() bind(c, name="PyErr_Occurred")
    exception_set = c_null_ptr
  end function exception_set

end module no_python
