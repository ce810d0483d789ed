!> Interruption of a kernel call by the user.
!>
!> A kernel call may take seconds, in which a keyboard interrupt would wait. Iterations therefore poll here
!> once each, from the thread that called and never within a parallel region, and end as soon as they can. Whom they
!> ask is the caller's affair: a procedure that is set once, by default none, so that nobody interrupts.
module pyworm_interruption
  implicit none(type, external)
  private

  public :: interrupted, interrupt_by, interruption_query

  abstract interface
    !> True once the present call is to end.
    logical function interruption_query()
      implicit none(type, external)
    end function interruption_query
  end interface

  procedure(interruption_query), pointer :: query => null()

contains

  !> Sets the procedure that is asked; null for none.
  subroutine interrupt_by(asked)
    procedure(interruption_query), pointer, intent(in) :: asked

    query => asked
  end subroutine interrupt_by

  !> Whether the call is to end.
  logical function interrupted()
    interrupted = .false.
    if (associated(query)) interrupted = query()
  end function interrupted

end module pyworm_interruption
