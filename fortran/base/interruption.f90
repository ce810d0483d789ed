!> Interruption of a kernel call by the user: Python handles signals only when it is polled.
!>
!> A kernel call may take seconds, in which a keyboard interrupt would wait. Iterations therefore poll here
!> once each, from the thread that Python called and never within a parallel region, and end as soon as they can. Their
!> result does not matter then, since the wrapper of f2py raises the exception that Python has set.
module interruption
  use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_ptr
  implicit none(type, external)
  private

  public :: interrupted

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

  !> True once a signal has made Python raise an exception.
  logical function interrupted()
    integer(c_int) :: state

    state = ensure_python()
    interrupted = c_associated(exception_set())
    if (.not. interrupted) interrupted = check_signals() /= 0
    call release_python(state)
  end function interrupted

end module interruption
