!> Columns of a line contact's film in its present state (`heat_columns`), along the entrainment.
module pyworm_line_columns
  use pyworm_column_sources, only: column_oil, set_heat
  use pyworm_column_work, only: column_work, new_column_work
  use pyworm_film_column, only: film_strip
  use pyworm_film_newton, only: film_contact
  use pyworm_heat_columns, only: heat_columns
  use pyworm_kinds, only: wp
  use pyworm_line_convection, only: bring
  use pyworm_oil_convection, only: most_columns
  use pyworm_shear_fields, only: gather_nodes, shear_columns
  use pyworm_strip_of_points, only: shear_strip
  use pyworm_thermal_properties, only: oil_heat_law
  implicit none(type, external)
  private

  public :: line_columns, new_line_columns, gather_line

  !> Nodes that oil may come from, relative to a column's.
  integer, parameter :: nodes_on(4) = [-2, -1, 1, 2]

  type, extends(heat_columns) :: line_columns
    !> Nodal velocity of body 1's surface [m/s], and first guess of the stress at the middle of the film [Pa].
    real(wp), allocatable :: u1(:), stress(:)
  contains
    procedure :: gather
    procedure :: set_sources
    procedure :: find_upstream
  end type line_columns

contains

  !> Columns in the state of the film; see `line_columns` for the other arguments.
  subroutine new_line_columns(self, film, backward, u1, stress, stat)
    type(line_columns), intent(inout) :: self
    class(film_contact), intent(in) :: film
    logical, intent(in) :: backward
    real(wp), intent(in) :: u1(:), stress(:)
    integer, intent(out) :: stat
    integer :: strip, inner

    self%backward = backward
    self%u1 = u1
    self%stress = stress
    inner = size(u1) - 2
    self%before = [(min((strip - 1)*most_columns, inner), strip=1, (inner - 1)/most_columns + 2)]
    call new_column_work(self%threads, film, stat)
  end subroutine new_line_columns

  !> Sets film, gradient, sliding, temperature and oil of the columns at nodes first..last, without storage; u1 is the
  !> nodal velocity of body 1's surface [m/s]. Ruptured oil has no gradient (`column_sweep.take_gradient`).
  subroutine gather_line(film, u1, first, last, columns, shear, oil)
    class(film_contact), intent(in) :: film
    real(wp), intent(in) :: u1(:)
    integer, intent(in) :: first, last
    type(film_strip), intent(inout) :: columns
    type(shear_strip), intent(inout) :: shear
    type(column_oil), intent(inout) :: oil
    integer :: m

    m = last - first + 1
    call gather_nodes(film, first, last, 1, shear, columns%known)
    oil%p(:m) = film%model%fields%p(first:last, 1)
    where (.not. oil%p(:m) > 0) shear%px(:m) = 0
    oil%u1(:m) = u1(first:last)
    oil%v1(:m) = 0
    oil%pressing(:m) = 0
  end subroutine gather_line

  !> Gathers a strip; see `heat_columns`.
  subroutine gather(self, film, strip, work, nodes)
    class(line_columns), intent(in) :: self
    class(film_contact), intent(in) :: film
    integer, intent(in) :: strip
    type(column_work), intent(inout) :: work
    integer, intent(out) :: nodes(:)
    integer :: i

    associate (first => self%before(strip) + 2, last => self%before(strip + 1) + 1, shear => work%shear)
      shear%tau_x(:last - first + 1) = self%stress(first:last)
      shear%tau_y(:last - first + 1) = 0
      call gather_line(film, self%u1, first, last, work%columns, shear, work%oil)
      nodes = [(i, i=first, last)]
    end associate
  end subroutine gather

  !> Computes shear, absorption and sources of a gathered strip; see `heat_columns`.
  subroutine set_sources(self, film, law, strip, work)
    class(line_columns), intent(inout) :: self
    class(film_contact), intent(in) :: film
    type(oil_heat_law), intent(in) :: law
    integer, intent(in) :: strip
    type(column_work), intent(inout) :: work
    integer :: c, m

    m = work%shear%points
    associate (nodes => film%model%shear%nodes, oil => work%oil, columns => work%columns)
      call shear_columns(film%oil, nodes, oil%p, columns%known, work%shear, oil%mean, oil%softening)
      call set_heat(law, film%oil, nodes, work%shear, oil, columns)
      do c = 1, m
        call bring(nodes%rise(:, 1, :), flow_of(oil, c, film%spacing(1)), self%before(strip) + 1 + c, columns%absorption(c, :), &
          work%inflow(c, :))
      end do
      columns%source(:m, :) = columns%source(:m, :) + (work%inflow(:m, :) + oil%compression(:m, :))
    end associate
  end subroutine set_sources

  !> Convection along x at the levels of a strip's column, per kelvin [W/(m3 K)], with nodes `spacing` [m] apart.
  pure function flow_of(oil, column, spacing) result(flow)
    type(column_oil), intent(in) :: oil
    integer, intent(in) :: column
    real(wp), intent(in) :: spacing
    real(wp) :: flow(size(oil%u, 2))

    flow = oil%capacity(column)*oil%u(column, :)/spacing
  end function flow_of

  !> Finds the nodes from which oil comes; see `heat_columns`.
  subroutine find_upstream(self, film, strip, work, place, weight)
    class(line_columns), intent(in) :: self
    class(film_contact), intent(in) :: film
    integer, intent(in) :: strip
    type(column_work), intent(in) :: work
    integer, intent(out) :: place(:, :, :)
    real(wp), intent(out) :: weight(:, :, :)
    real(wp) :: warm(size(self%u1), size(weight, 2)), absorption(size(weight, 2))
    integer :: c, i, t, from

    warm = 0
    do c = 1, work%shear%points
      i = self%before(strip) + 1 + c
      do t = 1, size(nodes_on)
        place(t, :, c) = i
        weight(t, :, c) = 0
        from = i + nodes_on(t)
        if (from < 1 .or. from > size(self%u1)) cycle
        ! the heat convected if that node alone is 1 K warm
        warm(from, :) = 1
        call bring(warm, flow_of(work%oil, c, film%spacing(1)), i, absorption, weight(t, :, c))
        warm(from, :) = 0
        place(t, :, c) = from
      end do
    end do
  end subroutine find_upstream

end module pyworm_line_columns
