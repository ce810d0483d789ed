!> Scratch of a thread that computes columns of a film: their temperature, shear and oil.
module pyworm_column_work
  use pyworm_column_sources, only: column_oil, new_column_oil
  use pyworm_film_column, only: film_strip, new_film_strip
  use pyworm_film_newton, only: film_contact
  use pyworm_kinds, only: wp
  use pyworm_oil_convection, only: most_columns
  use omp_lib, only: omp_get_max_threads
  use pyworm_status, only: status_ok, status_no_memory
  use pyworm_strip_of_points, only: shear_strip, new_shear_strip
  implicit none(type, external)
  private

  public :: column_work, new_column_work

  !> Scratch of a thread: columns, their shear and their oil, and at their levels the rate of shear [1/s] and the heat convected
  !> to them [W/m3]; heat of shearing [W/m2].
  type :: column_work
    type(film_strip) :: columns
    type(shear_strip) :: shear
    type(column_oil) :: oil
    real(wp), allocatable :: rate(:, :), inflow(:, :)
    real(wp) :: friction(most_columns) = 0
  end type column_work

contains

  !> Scratch of each thread.
  subroutine new_column_work(threads, film, stat)
    type(column_work), allocatable, intent(out) :: threads(:)
    class(film_contact), intent(in) :: film
    integer, intent(out) :: stat
    integer :: thread, err

    allocate (threads(0:omp_get_max_threads() - 1), stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
    if (stat /= status_ok) return
    associate (levels => film%model%shear%nodes%levels%count)
      do thread = 0, ubound(threads, 1)
        associate (own => threads(thread))
          if (stat == status_ok) call new_film_strip(own%columns, most_columns, film%model%shear%nodes%levels, stat)
          if (stat == status_ok) call new_shear_strip(most_columns, levels, own%shear, stat)
          if (stat == status_ok) call new_column_oil(most_columns, levels, own%oil, stat)
          allocate (own%rate(most_columns, levels), own%inflow(most_columns, levels), stat=err)
          if (err /= 0) stat = status_no_memory
        end associate
      end do
    end associate
  end subroutine new_column_work

end module pyworm_column_work
