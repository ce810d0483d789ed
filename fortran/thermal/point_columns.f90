!> Columns of a point contact's film in its present state (`heat_columns`), in the order of the sweep with the entrainment.
module pyworm_point_columns
  use pyworm_column_sweep, only: swept_columns, enter_sweep, gather_cut => gather, set_cut_sources => set_sources, cut_of_line
  use pyworm_column_work, only: column_work, new_column_work
  use pyworm_film_newton, only: film_contact
  use pyworm_heat_columns, only: heat_columns, most_upstream
  use pyworm_kinds, only: wp
  use pyworm_oil_convection, only: line_cut, carry_level, most_columns
  use pyworm_sweep_order, only: grid_node
  use pyworm_thermal_properties, only: oil_heat_law
  implicit none(type, external)
  private

  public :: point_columns, new_point_columns

  !> Places around a column that `carry_level` may take temperatures from, relative to it: lines on, and nodes along the line.
  integer, parameter :: places = 13
  integer, parameter :: lines_on(places) = [-2, -2, -2, -2, -2, -1, -1, -1, 0, 0, 1, 1, 1]
  integer, parameter :: nodes_on(places) = [-2, -1, 0, 1, 2, -1, 0, 1, -1, 1, -1, 0, 1]
  !> One node in so many is given a temperature when the weights of all columns of a strip are read off at once.
  integer, parameter :: apart = 5

  type, extends(heat_columns) :: point_columns
    !> A copy of the columns of sweeps with the entrainment.
    type(swept_columns), allocatable :: swept
  contains
    procedure :: gather
    procedure :: set_sources
    procedure :: find_upstream
  end type point_columns

contains

  !> Columns in the state of the film, with the stresses that the sweep `main` left as the first guess.
  subroutine new_point_columns(self, film, main, stat)
    type(point_columns), intent(inout) :: self
    class(film_contact), intent(in) :: film
    type(swept_columns), intent(in) :: main
    integer, intent(out) :: stat
    integer :: line, cut, cuts, strip

    self%swept = main
    call enter_sweep(self%swept, film)
    cuts = size(main%onward, 1)
    allocate (self%before(cuts*(main%way%lines - 2) + 1))
    self%before(1) = 0
    do line = 2, main%way%lines - 1
      do cut = 1, cuts
        strip = (line - 2)*cuts + cut
        self%before(strip + 1) = self%before(strip) + min(most_columns, main%way%length - 2 - (cut - 1)*most_columns)
      end do
    end do
    call new_column_work(self%threads, film, stat)
  end subroutine new_point_columns

  !> Line and cut of a strip, and its first and last node on the line.
  pure subroutine find_strip(self, strip, line, cut, first, last)
    class(point_columns), intent(in) :: self
    integer, intent(in) :: strip
    integer, intent(out) :: line, cut, first, last
    integer :: cuts

    cuts = size(self%swept%onward, 1)
    line = 2 + (strip - 1)/cuts
    cut = strip - (line - 2)*cuts
    first = 2 + (cut - 1)*most_columns
    last = first + self%before(strip + 1) - self%before(strip) - 1
  end subroutine find_strip

  !> Gathers a strip; see `heat_columns`.
  subroutine gather(self, film, strip, work, nodes)
    class(point_columns), intent(in) :: self
    class(film_contact), intent(in) :: film
    integer, intent(in) :: strip
    type(column_work), intent(inout) :: work
    integer, intent(out) :: nodes(:)
    integer :: line, cut, first, last, c

    call find_strip(self, strip, line, cut, first, last)
    call gather_cut(self%swept, film, line, first, last, work)
    nodes = [(grid_node(self%swept%way, c, line), c=first, last)]
  end subroutine gather

  !> Computes shear, absorption and sources of a gathered strip; see `heat_columns`.
  subroutine set_sources(self, film, law, strip, work)
    class(point_columns), intent(inout) :: self
    class(film_contact), intent(in) :: film
    type(oil_heat_law), intent(in) :: law
    integer, intent(in) :: strip
    type(column_work), intent(inout) :: work
    integer :: line, cut, first, last

    call find_strip(self, strip, line, cut, first, last)
    call set_cut_sources(self%swept, film, law, line, cut, self%swept%rise(first - 1:last + 1, line, :), work)
  end subroutine set_sources

  !> Finds the nodes from which oil comes; see `heat_columns`.
  subroutine find_upstream(self, film, strip, work, place, weight)
    class(point_columns), intent(in) :: self
    class(film_contact), intent(in) :: film
    integer, intent(in) :: strip
    type(column_work), intent(in) :: work
    integer, intent(out) :: place(:, :, :)
    real(wp), intent(out) :: weight(:, :, :)
    real(wp) :: weights(most_columns, places)
    integer :: line, cut, first, last, c, k, t, found

    call find_strip(self, strip, line, cut, first, last)
    associate (way => self%swept%way, oil => work%oil)
      do k = 1, film%model%shear%nodes%levels%count
        if (way%along_x) then
          call read_weights(cut_of_line(self%swept, line, cut), oil%capacity, oil%v(:, k), oil%u(:, k), weights)
        else
          call read_weights(cut_of_line(self%swept, line, cut), oil%capacity, oil%u(:, k), oil%v(:, k), weights)
        end if
        do c = 1, last - first + 1
          found = 0
          place(:, k, c) = grid_node(way, first + c - 1, line)
          weight(:, k, c) = 0
          do t = 1, places
            if (.not. abs(weights(c, t)) > 0 .or. found == most_upstream) cycle
            found = found + 1
            place(found, k, c) = grid_node(way, first + c - 1 + nodes_on(t), line + lines_on(t))
            weight(found, k, c) = weights(c, t)
          end do
        end do
      end do
    end associate
  end subroutine find_upstream

  !> Weights of the places around a strip's columns in the heat convected to one level [W/(m3 K)], (column, place): that heat
  !> if there alone the oil is 1 K warm.
  subroutine read_weights(part, capacity, along, across, weights)
    type(line_cut), intent(in) :: part
    real(wp), intent(in) :: capacity(:), along(:), across(:)
    real(wp), intent(out) :: weights(:, :)
    real(wp) :: warm(-1:most_columns + 2, -2:1), absorption(most_columns), inflow(most_columns)
    integer :: line, phase, c, t, m

    m = part%columns
    weights = 0
    do line = -2, 1
      do phase = 0, apart - 1
        warm = 0
        warm(:, line) = [(merge(1, 0, modulo(c, apart) == phase), c=-1, most_columns + 2)]
        call carry_level(part, warm(:m + 2, -2), warm(0:m + 1, -1), warm(0:m + 1, 0), warm(0:m + 1, 1), capacity(:m), along(:m), &
          across(:m), absorption(:m), inflow(:m))
        do t = 1, places
          if (lines_on(t) /= line) cycle
          do c = 1, m
            if (modulo(c + nodes_on(t), apart) == phase) weights(c, t) = inflow(c)
          end do
        end do
      end do
    end do
  end subroutine read_weights

end module pyworm_point_columns
