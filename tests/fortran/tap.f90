!> A printer of the Test Anything Protocol: one line a check, the plan at the end.
module tap
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: check, close_to, done

  integer :: checks = 0

contains

  !> One check.
  subroutine check(passed, what)
    logical, intent(in) :: passed
    character(len=*), intent(in) :: what

    checks = checks + 1
    write (*, "(a, i0, a)") merge("ok     ", "not ok ", passed), checks, " - "//what
  end subroutine check

  !> One check of a number, with both printed when it fails.
  subroutine close_to(value, wanted, tolerance, what)
    real(wp), intent(in) :: value, wanted, tolerance
    character(len=*), intent(in) :: what

    call check(abs(value - wanted) <= tolerance, what)
    if (.not. abs(value - wanted) <= tolerance) then
      write (*, "(a, es24.16, a, es24.16, a, es9.2)") "# got ", value, ", wanted ", wanted, " within ", tolerance
    end if
  end subroutine close_to

  !> Prints how many checks there were.
  subroutine done()
    write (*, "(a, i0)") "1..", checks
  end subroutine done

end module tap
