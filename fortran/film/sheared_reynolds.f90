!> Reynolds' equation of a sheared film: any flow law, and a viscosity that varies across the film.
!>
!>     div(rho h um) - div(rho S) + d(rho h)/dt = 0,   S = int z F(tau)/tau (tau_x, tau_y) dz
!>
!> (Sharif et al. 2001, eqs 10 and 11, in x and y instead of the frame of sliding). S is taken at the faces between
!> nodes, with its exact derivatives by the pressure gradient (a full tensor), pressure and film. Fluidities of a
!> face's two nodes are averaged with weights rho h**3, so that for an isothermal Newtonian oil the scheme is that
!> of `reynolds` to rounding.
!>
!> Between rough surfaces the oil shears over the mean thickness of the gap; the pressure flow factors multiply S, and the
!> shear flow factors carry oil with the rougher wall (Patir and Cheng 1979, their tensors by the lay; see `rough_surfaces`).
module pyworm_sheared_reynolds
  use pyworm_face_flow, only: face_flow, face_strip, face_work, new_face_flow, new_face_work, flow_through, most_faces
  use pyworm_flow_laws, only: flow_law
  use pyworm_kinds, only: wp
  use omp_lib, only: omp_get_max_threads, omp_get_thread_num
  use pyworm_reynolds, only: film_grid, film_fields, set_mass_change, add_wedge
  use pyworm_sheared_oil, only: sheared_oil, new_sheared_oil, set_oil
  use pyworm_status, only: status_ok, status_no_memory
  use pyworm_viscosity_density, only: oil_law
  implicit none(type, external)
  private

  public :: sheared_film, new_sheared_film, set_sheared_fields, sheared_imbalance, sheared_imbalance_change, still_ambient_faces, &
    faces_within_row, faces_between_rows

  type :: sheared_film
    type(sheared_oil) :: nodes
    type(face_flow) :: along_x, along_y
    !> Scratch: rho h, or its change.
    real(wp), allocatable :: mass(:, :)
    !> Scratch of each thread.
    type(face_work), allocatable :: work(:)
  contains
    procedure :: unsolved
  end type sheared_film

contains

  !> Makes a film at its inlet temperature; `sliding` is the velocity of body 2 relative to body 1 at the nodes [m/s].
  subroutine new_sheared_film(law, levels, sliding_x, sliding_y, self, stat)
    type(flow_law), intent(in) :: law
    integer, intent(in) :: levels
    real(wp), intent(in) :: sliding_x(:, :), sliding_y(:, :)
    type(sheared_film), intent(out) :: self
    integer, intent(out) :: stat
    integer :: nx, ny, thread, err

    nx = size(sliding_x, 1)
    ny = size(sliding_x, 2)
    call new_sheared_oil(law, levels, sliding_x, sliding_y, self%nodes, stat)
    if (stat == status_ok) call new_face_flow(nx, ny, self%along_x, stat)
    if (stat == status_ok) call new_face_flow(nx, ny, self%along_y, stat)
    allocate (self%mass(nx, ny), source=0.0_wp, stat=err)
    if (err /= 0) stat = status_no_memory
    allocate (self%work(0:omp_get_max_threads() - 1))
    do thread = 0, ubound(self%work, 1)
      if (stat == status_ok) call new_face_work(levels, self%work(thread), stat)
    end do
  end subroutine new_sheared_film

  !> Number of faces whose stress did not converge when the flow was last evaluated.
  pure integer function unsolved(self)
    class(sheared_film), intent(in) :: self

    unsolved = sum(self%work%shear%unsolved)
  end function unsolved

  !> Evaluates fields and face flows at the pressure and film of `fields`.
  !>
  !> `fields` gets the density. A film below `floor` [m] is replaced by the floor.
  subroutine set_sheared_fields(grid, oil, floor, film, fields)
    type(film_grid), intent(in) :: grid
    type(oil_law), intent(in) :: oil
    real(wp), intent(in) :: floor
    type(sheared_film), intent(inout) :: film
    type(film_fields), intent(inout) :: fields
    integer :: j

    film%work%shear%unsolved = 0
    !$omp parallel do schedule(static)
    do j = 1, grid%ny
      call set_oil(oil, 1, grid%nx, j, film%nodes, fields)
    end do
    !$omp parallel do schedule(dynamic, 4)
    do j = 1, grid%ny
      if (j > 1 .and. j < grid%ny) call flow_within_row(grid, floor, j, fields, film)
      if (j < grid%ny) call flow_between_rows(grid, floor, j, fields, film)
    end do
  end subroutine set_sheared_fields

  !> Evaluates the faces of row j, from each node to the next.
  subroutine flow_within_row(grid, floor, j, fields, film)
    type(film_grid), intent(in) :: grid
    real(wp), intent(in) :: floor
    integer, intent(in) :: j
    type(film_fields), intent(in) :: fields
    type(sheared_film), intent(inout) :: film
    type(face_strip) :: faces
    integer :: first

    do first = 1, grid%nx - 1, most_faces
      call faces_within_row(grid, fields%p, first, j, faces)
      call flow_through(film%nodes, fields, floor, faces, film%work(omp_get_thread_num()), film%along_x)
    end do
  end subroutine flow_within_row

  !> Evaluates the faces from the nodes of row j to those of the next.
  subroutine flow_between_rows(grid, floor, j, fields, film)
    type(film_grid), intent(in) :: grid
    real(wp), intent(in) :: floor
    integer, intent(in) :: j
    type(film_fields), intent(in) :: fields
    type(sheared_film), intent(inout) :: film
    type(face_strip) :: faces
    integer :: first

    do first = 2, grid%nx - 1, most_faces
      call faces_between_rows(grid, fields%p, first, j, faces)
      call flow_through(film%nodes, fields, floor, faces, film%work(omp_get_thread_num()), film%along_y)
    end do
  end subroutine flow_between_rows

  !> Sets a strip of faces from the nodes of row j to the next ones in it, from node `first` on.
  pure subroutine faces_within_row(grid, p, first, j, faces)
    type(film_grid), intent(in) :: grid
    real(wp), contiguous, intent(in) :: p(:, :)
    integer, intent(in) :: first, j
    type(face_strip), intent(inout) :: faces
    integer :: i

    faces%row = j
    faces%di = 1
    faces%dj = 0
    faces%per_length = 1/grid%dx
    faces%first = first
    faces%last = min(first + most_faces - 1, grid%nx - 1)
    do i = first, faces%last
      faces%normal(i - first + 1) = (p(i + 1, j) - p(i, j))/grid%dx
      faces%aside(i - first + 1) = (p(i, j + 1) - p(i, j - 1) + p(i + 1, j + 1) - p(i + 1, j - 1))/(4*grid%dy)
    end do
  end subroutine faces_within_row

  !> Sets a strip of faces from the nodes of row j to those of the next row, from node `first` on.
  pure subroutine faces_between_rows(grid, p, first, j, faces)
    type(film_grid), intent(in) :: grid
    real(wp), contiguous, intent(in) :: p(:, :)
    integer, intent(in) :: first, j
    type(face_strip), intent(inout) :: faces
    integer :: i

    faces%row = j
    faces%di = 0
    faces%dj = 1
    faces%per_length = 1/grid%dy
    faces%first = first
    faces%last = min(first + most_faces - 1, grid%nx - 1)
    do i = first, faces%last
      faces%normal(i - first + 1) = (p(i, j + 1) - p(i, j))/grid%dy
      faces%aside(i - first + 1) = (p(i + 1, j) - p(i - 1, j) + p(i + 1, j + 1) - p(i - 1, j + 1))/(4*grid%dx)
    end do
  end subroutine faces_between_rows

  !> Stops the flow between nodes that are both at ambient pressure, where the gap may be filled in part: all that is carried
  !> there is the wedge's.
  subroutine still_ambient_faces(p, film)
    real(wp), contiguous, intent(in) :: p(:, :)
    type(sheared_film), intent(inout) :: film

    call still(film%along_x, .not. (p > 0 .or. eoshift(p, 1, dim=1) > 0))
    call still(film%along_y, .not. (p > 0 .or. eoshift(p, 1, dim=2) > 0))

  contains

    subroutine still(faces, ambient)
      type(face_flow), intent(inout) :: faces
      logical, intent(in) :: ambient(:, :)

      where (ambient)
        faces%flow = 0
        faces%film_before = 0
        faces%film_after = 0
      end where
    end subroutine still

  end subroutine still_ambient_faces

  !> Net volume outflow per area [m/s] of each inner node's cell; zero on the outline.
  subroutine sheared_imbalance(grid, film, fields, imbalance)
    type(film_grid), intent(in) :: grid
    type(sheared_film), intent(inout) :: film
    type(film_fields), intent(in) :: fields
    real(wp), contiguous, intent(out) :: imbalance(:, :)
    integer :: j

    !$omp parallel do schedule(static)
    do j = 1, grid%ny
      film%mass(:, j) = fields%rho(:, j)*fields%h(:, j)
      imbalance(:, j) = grid%implicit_rate*film%mass(:, j) + grid%explicit_rate(:, j)
    end do
    call add_wedge(grid, film%mass, imbalance)
    call take_inflow(grid, film%along_x%flow, film%along_y%flow, imbalance)
  end subroutine sheared_imbalance

  !> Change of the imbalance for a small change of the oil's pressure and the film, of rough surfaces the gap between mean
  !> planes: the exact Jacobian times (dp, dh).
  subroutine sheared_imbalance_change(grid, film, fields, dp, dh, change)
    type(film_grid), intent(in) :: grid
    type(sheared_film), intent(inout) :: film
    type(film_fields), intent(in) :: fields
    real(wp), contiguous, intent(in) :: dp(:, :), dh(:, :)
    real(wp), contiguous, intent(out) :: change(:, :)
    integer :: i, j

    call set_mass_change(fields, dp, dh, film%mass)
    !$omp parallel do schedule(static)
    do j = 1, grid%ny
      change(:, j) = grid%implicit_rate*film%mass(:, j)
    end do
    call add_wedge(grid, film%mass, change)
    associate (x => film%along_x, y => film%along_y, slope_x => 1/(4*grid%dx), slope_y => 1/(4*grid%dy))
      !$omp parallel do private(i) schedule(static)
      do j = 2, grid%ny - 1
        block
          real(wp) :: within(grid%nx), enter(grid%nx), leave(grid%nx)

          do i = 1, grid%nx - 1
            within(i) = x%before(i, j)*dp(i, j) + x%after(i, j)*dp(i + 1, j) + x%film_before(i, j)*dh(i, j) &
              + x%film_after(i, j)*dh(i + 1, j) + x%aside(i, j)*slope_y*(dp(i, j + 1) - dp(i, j - 1) &
              + dp(i + 1, j + 1) - dp(i + 1, j - 1))
          end do
          call change_between(j - 1, enter)
          call change_between(j, leave)
          do i = 2, grid%nx - 1
            change(i, j) = change(i, j) - (within(i) - within(i - 1))/grid%dx - (leave(i) - enter(i))/grid%dy
          end do
        end block
      end do
    end associate

  contains

    !> Computes the change of the flow from the nodes of row j to those of the next.
    pure subroutine change_between(j, flow)
      integer, intent(in) :: j
      real(wp), intent(out) :: flow(:)
      real(wp) :: slope
      integer :: i

      slope = 1/(4*grid%dx)
      flow(1) = 0
      associate (y => film%along_y)
        do i = 2, grid%nx - 1
          flow(i) = y%before(i, j)*dp(i, j) + y%after(i, j)*dp(i, j + 1) + y%film_before(i, j)*dh(i, j) &
            + y%film_after(i, j)*dh(i, j + 1) + y%aside(i, j)*slope*(dp(i + 1, j) - dp(i - 1, j) &
            + dp(i + 1, j + 1) - dp(i - 1, j + 1))
        end do
      end associate
    end subroutine change_between

  end subroutine sheared_imbalance_change

  !> Subtracts the net inflow through the faces after the nodes, along x and along y.
  subroutine take_inflow(grid, along_x, along_y, r)
    type(film_grid), intent(in) :: grid
    real(wp), contiguous, intent(in) :: along_x(:, :), along_y(:, :)
    real(wp), contiguous, intent(inout) :: r(:, :)
    integer :: i, j

    !$omp parallel do private(i) schedule(static)
    do j = 2, grid%ny - 1
      do i = 2, grid%nx - 1
        r(i, j) = r(i, j) - (along_x(i, j) - along_x(i - 1, j))/grid%dx - (along_y(i, j) - along_y(i, j - 1))/grid%dy
      end do
    end do
  end subroutine take_inflow

end module pyworm_sheared_reynolds
