!> Columns of a film in its present state, strip by strip, each alone: the heat that their levels lack, by the routines of a
!> sweep, and what is convected to them from other nodes. Base of the columns of point and line contacts.
!>
!> Columns are those of the inner nodes, in the order of the sweep with the entrainment, or `backward`. Nodes are numbered over
!> the grid along x first. A strip is gathered from the state into a thread's scratch, where its pressure, gradient, film and
!> temperature may be changed before its heat is computed; the state of the film and its heat is never changed.
module pyworm_heat_columns
  use pyworm_column_work, only: column_work
  use pyworm_film_column, only: level_residuals
  use pyworm_film_newton, only: film_contact
  use pyworm_kinds, only: wp
  use pyworm_thermal_properties, only: oil_heat_law
  implicit none(type, external)
  private

  public :: heat_columns, strip_residuals

  !> Nodes of which the oil of a level may come.
  integer, parameter, public :: most_upstream = 4

  type, abstract :: heat_columns
    !> Columns before each strip, and their number after the last.
    integer, allocatable :: before(:)
    !> Whether the sweep takes the columns in the reverse order.
    logical :: backward = .false.
    !> Scratch of each thread, from 0 on.
    type(column_work), allocatable :: threads(:)
  contains
    procedure(gatherer), deferred :: gather
    procedure(evaluation), deferred :: set_sources
    procedure(upstream_finder), deferred :: find_upstream
  end type heat_columns

  abstract interface
    !> Sets film, gradient, sliding, temperature, oil and last stress of a strip; `nodes` are the numbers of its nodes.
    subroutine gatherer(self, film, strip, work, nodes)
      import :: heat_columns, film_contact, column_work
      implicit none(type, external)
      class(heat_columns), intent(in) :: self
      class(film_contact), intent(in) :: film
      integer, intent(in) :: strip
      type(column_work), intent(inout) :: work
      integer, intent(out) :: nodes(:)
    end subroutine gatherer

    !> Computes shear, absorption and sources of a gathered strip.
    subroutine evaluation(self, film, law, strip, work)
      import :: heat_columns, film_contact, oil_heat_law, column_work
      implicit none(type, external)
      class(heat_columns), intent(inout) :: self
      class(film_contact), intent(in) :: film
      type(oil_heat_law), intent(in) :: law
      integer, intent(in) :: strip
      type(column_work), intent(inout) :: work
    end subroutine evaluation

    !> Computes of a strip whose sources are set the nodes `place` from which oil comes to each level, and the derivatives
    !> `weight` by their temperature at that level of the heat convected [W/(m3 K)], (`most_upstream`, levels, columns).
    !>
    !> Where they are fewer, the weight of the others is zero.
    subroutine upstream_finder(self, film, strip, work, place, weight)
      import :: heat_columns, film_contact, column_work, wp
      implicit none(type, external)
      class(heat_columns), intent(in) :: self
      class(film_contact), intent(in) :: film
      integer, intent(in) :: strip
      type(column_work), intent(in) :: work
      integer, intent(out) :: place(:, :, :)
      real(wp), intent(out) :: weight(:, :, :)
    end subroutine upstream_finder
  end interface

contains

  !> Heat that the levels of a gathered strip lack [W/m2], (columns, levels); at the walls without the flux into them.
  subroutine strip_residuals(self, film, law, strip, work, residual)
    class(heat_columns), intent(inout) :: self
    class(film_contact), intent(in) :: film
    type(oil_heat_law), intent(in) :: law
    integer, intent(in) :: strip
    type(column_work), intent(inout) :: work
    real(wp), contiguous, intent(out) :: residual(:, :)

    call self%set_sources(film, law, strip, work)
    call level_residuals(work%columns, residual)
  end subroutine strip_residuals

end module pyworm_heat_columns
