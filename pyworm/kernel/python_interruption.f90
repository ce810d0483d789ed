!> Interruption by Python, which handles signals only when it is polled.
!>
!> What an interrupted call gives does not matter, since the wrapper of f2py raises the exception that Python has set.
module python_interruption
  use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_ptr
  use pyworm_interruption, only: interrupt_by, interruption_query
  implicit none(type, external)
  private

  public :: heed_python

  interface
    !> Acquire and release the lock of the interpreter (Python's C interface, "Non-Python created threads").
    integer(c_int) function ensure_python() bind(c, name="PyGILState_Ensure")
      import :: c_int
      implicit none(type, external)
    end function ensure_python

    subroutine release_python(state) bind(c, name="PyGILState_Release")
      import :: c_int
      implicit none(type, external)
      integer(c_int), value :: state
    end subroutine release_python

    !> Lets Python handle pending signals; not zero if a handler raised an exception.
    integer(c_int) function check_signals() bind(c, name="PyErr_CheckSignals")
      import :: c_int
      implicit none(type, external)
    end function check_signals

    !> The exception that is set in this thread, or null.
    type(c_ptr) function exception_set() bind(c, name="PyErr_Occurred")
      import :: c_ptr
      implicit none(type, external)
    end function exception_set
  end interface

contains

  !> Lets kernel calls end once Python raises an exception for a signal.
  subroutine heed_python()
    procedure(interruption_query), pointer :: asked

    asked => signalled
    call interrupt_by(asked)
  end subroutine heed_python

  !> True once a signal has made Python raise an exception.
  logical function signalled()
    integer(c_int) :: state

    state = ensure_python()
    signalled = c_associated(exception_set())
    if (.not. signalled) signalled = check_signals() /= 0
    call release_python(state)
  end function signalled

end module python_interruption
