!> Flow of a line contact's film with a flow law and a viscosity that varies across the film.
!>
!> The flow through a face is that of `sheared_reynolds`, on a grid of one row without gradient or sliding along
!> it, with the arithmetic mean of the mobility and exact derivatives. For an isothermal Newtonian oil it is that of
!> `line_reynolds` to rounding.
module pyworm_line_shear
  use pyworm_face_flow, only: face_strip, flow_through, most_faces
  use pyworm_kinds, only: wp
  use pyworm_line_reynolds, only: line_grid, line_flow
  use pyworm_viscosity_density, only: oil_law
  use omp_lib, only: omp_get_thread_num
  use pyworm_reynolds, only: film_fields
  use pyworm_sheared_oil, only: set_oil
  use pyworm_sheared_reynolds, only: sheared_film, still_ambient_faces
  implicit none(type, external)
  private

  public :: sheared_flow, faces_of_line

contains

  !> Computes density at the nodes and flow through the faces at the pressure and film of `fields`.
  !>
  !> `film` is of one row. A film below `floor` [m] is replaced by the floor. Where the gap is filled in part, `partial`, nothing
  !> but the wedge flows without pressure.
  subroutine sheared_flow(grid, oil, floor, film, fields, faces, partial)
    type(line_grid), intent(in) :: grid
    type(oil_law), intent(in) :: oil
    real(wp), intent(in) :: floor
    type(sheared_film), intent(inout) :: film
    type(film_fields), intent(inout) :: fields
    type(line_flow), intent(inout) :: faces
    logical, intent(in) :: partial
    integer :: first

    film%work%shear%unsolved = 0
    film%nodes%arithmetic = 1
    !$omp parallel do schedule(static)
    do first = 1, grid%n, most_faces
      call set_oil(oil, first, min(first + most_faces - 1, grid%n), 1, film%nodes, fields)
    end do
    !$omp parallel do schedule(dynamic)
    do first = 1, grid%n - 1, most_faces
      call flow_through_strip(grid, floor, first, min(first + most_faces, grid%n) - 1, fields, film)
    end do
    if (partial) call still_ambient_faces(fields%p, film)
    associate (last => grid%n - 1)
      faces%flow(:) = film%along_x%flow(:last, 1)
      faces%before(:) = film%along_x%before(:last, 1)
      faces%after(:) = film%along_x%after(:last, 1)
      faces%film_before(:) = film%along_x%film_before(:last, 1)
      faces%film_after(:) = film%along_x%film_after(:last, 1)
    end associate
  end subroutine sheared_flow

  !> Computes the flow through the faces after the nodes first..last.
  subroutine flow_through_strip(grid, floor, first, last, fields, film)
    type(line_grid), intent(in) :: grid
    real(wp), intent(in) :: floor
    integer, intent(in) :: first, last
    type(film_fields), intent(in) :: fields
    type(sheared_film), intent(inout) :: film
    type(face_strip) :: faces

    call faces_of_line(grid, fields%p, first, last, faces)
    call flow_through(film%nodes, fields, floor, faces, film%work(omp_get_thread_num()), film%along_x)
  end subroutine flow_through_strip

  !> Sets the strip of the faces after the nodes first..last.
  pure subroutine faces_of_line(grid, p, first, last, faces)
    type(line_grid), intent(in) :: grid
    real(wp), intent(in) :: p(:, :)
    integer, intent(in) :: first, last
    type(face_strip), intent(inout) :: faces

    faces%row = 1
    faces%first = first
    faces%last = last
    faces%per_length = 1/grid%dx
    faces%normal(:last - first + 1) = (p(first + 1:last + 1, 1) - p(first:last, 1))/grid%dx
    faces%aside = 0
  end subroutine faces_of_line

end module pyworm_line_shear
