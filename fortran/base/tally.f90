!> How often a part of the work was done, and the processor time that it took.
module tally
  use kinds, only: wp
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

  !> The part begins.
  subroutine start(self)
    class(work_tally), intent(inout) :: self

    call cpu_time(self%began)
  end subroutine start

  !> The part has been done once more.
  subroutine finish(self)
    class(work_tally), intent(inout) :: self
    real(wp) :: now

    call cpu_time(now)
    self%seconds = self%seconds + now - self%began
    self%count = self%count + 1
  end subroutine finish

end module tally
