!> Imbalance of a sheared film linearised in its temperature, by `film_warming`, and products with fields:
!>   warm_imbalance              r = dR/dT x, the imbalance R (nx, ny), the temperature T (nx, ny, levels)
!>   warm_imbalance_transposed   x = (dR/dT)^T r
!> Of a steady film, full of oil, of a point or a line contact. R is that of all inner nodes: the caller leaves out those at
!> which pressure is not free.
module pyworm_film_warming
  use pyworm_face_flow, only: face_flow, face_strip, face_work, new_face_flow, new_face_work, flow_through, flow_by_temperature, &
    most_faces
  use pyworm_film_newton, only: film_contact, first_row, last_row
  use pyworm_kinds, only: wp
  use pyworm_line_film, only: line_contact
  use pyworm_line_reynolds, only: line_weights => wedge_weights
  use pyworm_line_shear, only: faces_of_line
  use pyworm_point_film, only: point_contact
  use pyworm_reynolds_adjoint, only: upwind_weights
  use pyworm_sheared_oil, only: oil_warming, new_oil_warming
  use pyworm_sheared_reynolds, only: faces_within_row, faces_between_rows
  use pyworm_status, only: status_ok, status_bad_argument, status_no_memory
  implicit none(type, external)
  private

  public :: film_warming, new_film_warming, warm_imbalance, warm_imbalance_transposed

  !> Derivatives of the flow through the faces after the nodes along x and along y by the temperatures of the nodes before and
  !> after [m2/(s K)], (level, node, nx, ny), and of rho h by the mean temperature across the film [m/K].
  type :: film_warming
    real(wp), allocatable :: along_x(:, :, :, :), along_y(:, :, :, :), mass(:, :)
  end type film_warming

contains

  !> Linearises the flow of a film in the state last evaluated, which it leaves as it is; `status_bad_argument` of a film
  !> without a flow law or filled in part.
  subroutine new_film_warming(film, self, stat)
    class(film_contact), intent(in) :: film
    type(film_warming), intent(out) :: self
    integer, intent(out) :: stat
    type(oil_warming) :: warming
    integer :: nx, ny, levels, err

    stat = status_bad_argument
    if (.not. film%model%is_sheared() .or. film%model%is_partial()) return
    nx = size(film%gap, 1)
    ny = size(film%gap, 2)
    associate (fields => film%model%fields, nodes => film%model%shear%nodes)
      levels = nodes%levels%count
      allocate (self%along_x(levels, 2, nx, ny), self%along_y(levels, 2, nx, merge(ny, 0, ny > 1)), self%mass(nx, ny), &
        source=0.0_wp, stat=err)
      stat = merge(status_ok, status_no_memory, err == 0)
      if (stat == status_ok) call new_oil_warming(film%oil, nodes, fields%p, warming, stat)
      if (stat /= status_ok) return
      self%mass = warming%rho*fields%h
    end associate
    call warm_faces(film, warming, self, stat)
  end subroutine new_film_warming

  !> Sets the derivatives of the flow through all faces.
  subroutine warm_faces(film, warming, self, stat)
    class(film_contact), intent(in) :: film
    type(oil_warming), intent(in) :: warming
    type(film_warming), intent(inout) :: self
    integer, intent(out) :: stat
    type(face_work) :: work
    type(face_strip) :: faces
    type(face_flow) :: along_x, along_y
    integer :: first, j, nx

    nx = size(film%gap, 1)
    associate (fields => film%model%fields, shear => film%model%shear)
      call new_face_work(shear%nodes%levels%count, work, stat)
      if (stat == status_ok) call copy_stress(shear%along_x, along_x, stat)
      if (stat == status_ok) call copy_stress(shear%along_y, along_y, stat)
      if (stat /= status_ok) return
      work%by_stresses = abs(shear%nodes%law%reference_decay) > 0
      select type (film)
      type is (point_contact)
        do j = 1, film%grid%ny - 1
          do first = 1, nx - 1, most_faces
            if (j == 1) exit
            call faces_within_row(film%grid, fields%p, first, j, faces)
            call warm_strip(along_x, self%along_x)
          end do
          do first = 2, nx - 1, most_faces
            call faces_between_rows(film%grid, fields%p, first, j, faces)
            call warm_strip(along_y, self%along_y)
          end do
        end do
      type is (line_contact)
        do first = 1, nx - 1, most_faces
          call faces_of_line(film%grid, fields%p, first, min(first + most_faces, nx) - 1, faces)
          call warm_strip(along_x, self%along_x)
        end do
      end select
    end associate

  contains

    !> Sets the derivatives of the flow through a strip of faces.
    subroutine warm_strip(flows, by_temperature)
      type(face_flow), intent(inout) :: flows
      real(wp), intent(inout) :: by_temperature(:, :, :, :)

      call flow_through(film%model%shear%nodes, film%model%fields, film%floor, faces, work, flows)
      call flow_by_temperature(film%model%shear%nodes, film%model%fields, warming, faces, work, &
        by_temperature(:, :, faces%first:faces%last, faces%row))
    end subroutine warm_strip

  end subroutine warm_faces

  !> Flow with the stresses of another as first guess.
  subroutine copy_stress(from, flows, stat)
    type(face_flow), intent(in) :: from
    type(face_flow), intent(out) :: flows
    integer, intent(out) :: stat

    call new_face_flow(size(from%flow, 1), size(from%flow, 2), flows, stat)
    if (stat /= status_ok) return
    flows%stress_x = from%stress_x
    flows%stress_y = from%stress_y
  end subroutine copy_stress

  !> Change of the imbalance by that of the temperature; zero on the outline.
  subroutine warm_imbalance(film, self, warming, change)
    class(film_contact), intent(in) :: film
    type(film_warming), intent(in) :: self
    real(wp), contiguous, intent(in) :: warming(:, :, :)
    real(wp), contiguous, intent(out) :: change(:, :)
    real(wp) :: mass(size(change, 1), size(change, 2))
    integer :: k

    mass = 0
    do k = 1, size(warming, 3)
      mass = mass + film%model%shear%nodes%levels%weight(k)*warming(:, :, k)
    end do
    mass = self%mass*mass
    change = 0
    call add_flow(film, 1, self%along_x, mass, warming, change)
    if (size(change, 2) > 1) call add_flow(film, 2, self%along_y, mass, warming, change)
    change(:, :first_row(film) - 1) = 0
    change(:, last_row(film) + 1:) = 0
    change([1, size(change, 1)], :) = 0
  end subroutine warm_imbalance

  !> Adds the outflow through the faces in one direction by changes of rho h, `mass`, and of the temperature.
  subroutine add_flow(film, direction, by_temperature, mass, warming, change)
    class(film_contact), intent(in) :: film
    integer, intent(in) :: direction
    real(wp), contiguous, intent(in) :: by_temperature(:, :, :, :), mass(:, :), warming(:, :, :)
    real(wp), contiguous, intent(inout) :: change(:, :)
    real(wp) :: weights(-1:2), flow
    integer :: i, j, t, di, dj

    di = merge(1, 0, direction == 1)
    dj = 1 - di
    do j = merge(first_row(film), 1, direction == 1), last_row(film)
      do i = merge(1, 2, direction == 1), size(mass, 1) - 1
        flow = -sum(by_temperature(:, 1, i, j)*warming(i, j, :) + by_temperature(:, 2, i, j)*warming(i + di, j + dj, :))
        weights = wedge_weights(film, direction, i, j)
        do t = -1, 2
          if (abs(weights(t)) > 0) flow = flow + weights(t)*mass(i + t*di, j + t*dj)
        end do
        flow = flow/film%spacing(direction)
        change(i, j) = change(i, j) + flow
        change(i + di, j + dj) = change(i + di, j + dj) - flow
      end do
    end do
  end subroutine add_flow

  !> Product of the transposed derivative with `weight`, whose values on the outline do not count.
  subroutine warm_imbalance_transposed(film, self, weight, by_warming)
    class(film_contact), intent(in) :: film
    type(film_warming), intent(in) :: self
    real(wp), contiguous, intent(in) :: weight(:, :)
    real(wp), contiguous, intent(out) :: by_warming(:, :, :)
    real(wp), dimension(size(weight, 1), size(weight, 2)) :: inner, by_mass
    integer :: k

    inner = 0
    associate (last => size(weight, 1) - 1, rows => [first_row(film), last_row(film)])
      inner(2:last, rows(1):rows(2)) = weight(2:last, rows(1):rows(2))
    end associate
    by_mass = 0
    by_warming = 0
    call take_flow(film, 1, self%along_x, inner, by_mass, by_warming)
    if (size(weight, 2) > 1) call take_flow(film, 2, self%along_y, inner, by_mass, by_warming)
    by_mass = self%mass*by_mass
    do k = 1, size(by_warming, 3)
      by_warming(:, :, k) = by_warming(:, :, k) + film%model%shear%nodes%levels%weight(k)*by_mass
    end do
  end subroutine warm_imbalance_transposed

  !> Transpose of `add_flow`.
  subroutine take_flow(film, direction, by_temperature, weight, by_mass, by_warming)
    class(film_contact), intent(in) :: film
    integer, intent(in) :: direction
    real(wp), contiguous, intent(in) :: by_temperature(:, :, :, :), weight(:, :)
    real(wp), contiguous, intent(inout) :: by_mass(:, :), by_warming(:, :, :)
    real(wp) :: weights(-1:2), flow
    integer :: i, j, t, di, dj

    di = merge(1, 0, direction == 1)
    dj = 1 - di
    do j = merge(first_row(film), 1, direction == 1), last_row(film)
      do i = merge(1, 2, direction == 1), size(weight, 1) - 1
        flow = (weight(i, j) - weight(i + di, j + dj))/film%spacing(direction)
        by_warming(i, j, :) = by_warming(i, j, :) - flow*by_temperature(:, 1, i, j)
        by_warming(i + di, j + dj, :) = by_warming(i + di, j + dj, :) - flow*by_temperature(:, 2, i, j)
        weights = wedge_weights(film, direction, i, j)
        do t = -1, 2
          if (abs(weights(t)) > 0) by_mass(i + t*di, j + t*dj) = by_mass(i + t*di, j + t*dj) + weights(t)*flow
        end do
      end do
    end do
  end subroutine take_flow

  !> Weights of rho h at the nodes -1 to 2 further on in the wedge's flow through the face after a node [m/s].
  pure function wedge_weights(film, direction, i, j) result(weights)
    class(film_contact), intent(in) :: film
    integer, intent(in) :: direction, i, j
    real(wp) :: weights(4)

    weights = 0
    select type (film)
    type is (point_contact)
      associate (speed => merge(film%grid%u(i, j), film%grid%v(i, j), direction == 1), face => merge(i, j, direction == 1), &
          last => merge(film%grid%nx, film%grid%ny, direction == 1) - 1)
        weights = upwind_weights(speed)
        if (face == 1 .or. face == last) weights = speed*[0.0_wp, 0.5_wp, 0.5_wp, 0.0_wp]
      end associate
    type is (line_contact)
      weights = line_weights(film%grid, i)
    end select
  end function wedge_weights

end module pyworm_film_warming
