!> Count and processor time of one part of the work.
module pyworm_tally
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: work_tally

  type :: work_tally
    integer :: count = 0
    !> Processor time of all threads [s].
    real(wp) :: seconds = 0
    real(wp), private :: began = 0
  contains
    procedure :: start
    procedure :: finish
  end type work_tally

contains

  !> Starts the clock of the part.
  subroutine start(self)
    class(work_tally), intent(inout) :: self

    call cpu_time(self%began)
  end subroutine start

  !> Stops the clock of the part and counts it.
  subroutine finish(self)
    class(work_tally), intent(inout) :: self
    real(wp) :: now

    call cpu_time(now)
    self%seconds = self%seconds + now - self%began
    self%count = self%count + 1
  end subroutine finish

end module pyworm_tally
