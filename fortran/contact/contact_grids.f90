!> A contact's film by nested iteration, from the coarsest grid that halving the given one allows up to that, and how far off it
!> is: by its changes from grid to grid, and by those from a narrower window.
module pyworm_contact_grids
  use pyworm_contact_description, only: pyworm_found, pyworm_options, pyworm_scene
  use pyworm_contact_iteration, only: add_models, iterate, iteration_end
  use pyworm_contact_state, only: contact_state, guess_dry, is_line, make_film
  use pyworm_cubic_refinement, only: interpolate_cubic
  use pyworm_grid_error, only: grid_error
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_no_descent, status_not_converged, status_not_finite, status_ok
  implicit none(type, external)
  private

  public :: solve_on_grids, halvings, reading, found_by, spoils_a_grid

  !> Fewest nodes a side of a coarser grid, and of the grid that is cut to a narrower window.
  integer, parameter, public :: fewest_nodes = 33
  integer, parameter :: fewest_cut = 49, fewest_cut_line = 257
  !> Sides of the narrower window over those of the window: half the gap of a paraboloid.
  real(wp), parameter :: narrower = sqrt(0.5_wp)
  !> Error of a window over what its films differ by from those of half its reach (in gap). It falls with the power -3/2 of
  !> the reach, and is up to 2.1 times the change to twice the reach (`pyworm/solver/point/contact.py`).
  real(wp), parameter :: window_share = 2.1_wp/2**1.5_wp

contains

  !> Solves the film until residual and load error are within the tolerance, on coarser grids first. Where no film is found on
  !> the given grid, which may not bear a pressure spike that grows from grid to grid, it is that of the finest grid on which
  !> there is one.
  subroutine solve_on_grids(contact, options, found, stat)
    type(contact_state), intent(inout) :: contact
    type(pyworm_options), intent(in) :: options
    type(pyworm_found), intent(out) :: found
    integer, intent(out) :: stat
    type(iteration_end) :: ended
    real(wp), allocatable :: p(:, :)
    real(wp) :: h0
    integer :: coarsest, step

    coarsest = 2**halvings(shape(contact%scene%gap))
    call climb(contact, coarsest, options, found, p, h0, step, stat)
    if (.not. allocated(p)) return
    if (stat /= status_ok .and. .not. spoils_a_grid(stat)) return
    if (step /= contact%step .or. stat /= status_ok) then
      contact%p = p
      contact%h0 = h0
      call make_film(contact, step, stat)
      if (stat == status_ok) call iterate(contact, options, ended, stat)
      if (stat == status_ok) call add_models(contact, options, ended, stat)
      found%residual = ended%residual
      found%load_error = ended%load_error
      if (stat /= status_ok) return
    end if
    call compare_windows(contact, coarsest, options, found)
  end subroutine solve_on_grids

  !> Solves grids from the coarsest to the given one; `p` and `h0` are the Newtonian film at `step` of the finest grid on
  !> which all was found, `p` not allocated without any, and `stat` is that of the given grid.
  subroutine climb(contact, coarsest, options, found, p, h0, step, stat)
    type(contact_state), intent(inout) :: contact
    integer, intent(in) :: coarsest
    type(pyworm_options), intent(in) :: options
    type(pyworm_found), intent(out) :: found
    real(wp), allocatable, intent(out) :: p(:, :)
    real(wp), intent(out) :: h0
    integer, intent(out) :: step, stat
    type(iteration_end) :: ended
    real(wp), allocatable :: readings(:, :), newtonian(:, :)
    real(wp) :: rigid
    integer :: here, centre(2)
    logical :: lost

    h0 = 0
    step = coarsest
    here = coarsest
    centre = minloc(contact%scene%gap(::coarsest, ::coarsest))
    allocate (readings(3, 0))
    lost = .true.
    do
      if (lost) then
        call guess_dry(contact, here, stat)
      else
        call refine(newtonian, allocated(contact%scene%supply), contact%p)
        contact%h0 = rigid
        call make_film(contact, here, stat)
      end if
      if (stat /= status_ok) return
      call iterate(contact, options, ended, stat)
      if (spoils_a_grid(stat) .and. .not. lost) then ! a meniscus may not move from where the coarser grid has it
        call guess_dry(contact, here, stat)
        if (stat == status_ok) call iterate(contact, options, ended, stat)
      end if
      lost = stat /= status_ok
      call keep(contact%p, newtonian)
      rigid = contact%h0
      if (stat == status_ok) call add_models(contact, options, ended, stat)
      if (.not. (stat == status_ok .or. spoils_a_grid(stat))) return
      if (stat == status_ok) then
        readings = reshape([readings, reading(contact, 1 + (centre - 1)*(coarsest/here))], [3, size(readings, 2) + 1])
        found = found_by(readings, ended, here)
        call keep(newtonian, p)
        h0 = rigid
        step = here
      else if (here > 1) then
        deallocate (readings) ! errors are read from grids that follow each other
        allocate (readings(3, 0))
      end if
      if (here == 1) return
      here = here/2
    end do
  end subroutine climb

  !> Copies a field; assigned, gfortran warns of bounds that it does not use.
  pure subroutine keep(field, kept)
    real(wp), intent(in) :: field(:, :)
    real(wp), allocatable, intent(out) :: kept(:, :)

    allocate (kept(size(field, 1), size(field, 2)))
    kept = field
  end subroutine keep

  !> Whether a status says that this grid has no film, and others may.
  pure logical function spoils_a_grid(stat)
    integer, intent(in) :: stat

    spoils_a_grid = any(stat == [status_not_converged, status_no_descent, status_not_finite])
  end function spoils_a_grid

  !> Minimum film where both bodies exist, film at a node, and maximum pressure of the present film.
  pure function reading(contact, node)
    type(contact_state), intent(in) :: contact
    integer, intent(in) :: node(2)
    real(wp) :: reading(3)

    associate (h => contact%film%film%model%fields%h, step => contact%step)
      reading = [minval(h, mask=contact%scene%covered(::step, ::step)), h(node(1), node(2)), maxval(contact%p)]
    end associate
  end function reading

  !> The figures of the last of some grids, with their errors by the grids.
  pure type(pyworm_found) function found_by(readings, ended, coarsening)
    real(wp), intent(in) :: readings(:, :)
    type(iteration_end), intent(in) :: ended
    integer, intent(in) :: coarsening
    integer :: n

    n = size(readings, 2)
    found_by = pyworm_found(film_min=readings(1, n), film_central=readings(2, n), pressure_max=readings(3, n), &
      film_min_error=grid_error(readings(1, :)), film_central_error=grid_error(readings(2, :)), &
      pressure_max_error=grid_error(readings(3, :)), residual=ended%residual, load_error=ended%load_error, &
      steps=ended%steps, coarsening=coarsening)
  end function found_by

  !> Sets the error by the window, from isothermal Newtonian films in this one and in one of half its reach, on a coarse grid,
  !> of a line contact with a narrower inlet alone; it stays unknown where one of them is not found.
  subroutine compare_windows(contact, coarsest, options, found)
    type(contact_state), intent(in) :: contact
    integer, intent(in) :: coarsest
    type(pyworm_options), intent(in) :: options
    type(pyworm_found), intent(inout) :: found
    real(wp) :: films(2, 2)
    integer :: step, nodes(2), centre(2), low(2), high(2), stat
    logical :: forward

    step = coarsest
    associate (gap => contact%scene%gap)
      do while (step > 1 .and. (size(gap, 1) - 1)/step + 1 < merge(fewest_cut_line, fewest_cut, is_line(contact%scene)) &
        .or. step > 1 .and. (size(gap, 2) - 1)/step + 1 < merge(1, fewest_cut, is_line(contact%scene)))
        step = step/2
      end do
      nodes = shape(gap(::step, ::step))
      centre = minloc(gap(::step, ::step))
    end associate
    low = centre - int(narrower*(centre - 1))
    high = centre + int(narrower*(nodes - centre))
    if (is_line(contact%scene)) then ! its outlet may end soon after the contact
      forward = sum(contact%scene%velocity(centre(1), 1, 1, :)) > 0
      low(1) = merge(low(1), 1, forward)
      high(1) = merge(nodes(1), high(1), forward)
    end if
    call films_in(contact, step, [1, 1], nodes, centre, options, films(:, 1), stat)
    if (stat == status_ok) call films_in(contact, step, low, high, centre, options, films(:, 2), stat)
    if (stat == status_ok) found%window_error = window_share*maxval(abs(films(:, 2) - films(:, 1))/films(:, 1))
  end subroutine compare_windows

  !> Minimum film and film at a node of the contact from node `low` to node `high` of a grid, isothermal and Newtonian.
  subroutine films_in(contact, step, low, high, node, options, films, stat)
    type(contact_state), intent(in) :: contact
    integer, intent(in) :: step, low(2), high(2), node(2)
    type(pyworm_options), intent(in) :: options
    real(wp), intent(out) :: films(2)
    integer, intent(out) :: stat
    type(contact_state), allocatable :: part
    type(iteration_end) :: ended
    real(wp) :: figures(3)
    integer :: first(2), last(2)

    films = 0
    first = 1 + (low - 1)*step
    last = 1 + (high - 1)*step
    allocate (part)
    part%oil = contact%oil
    associate (whole => contact%scene)
      part%scene = pyworm_scene(dx=step*whole%dx, dy=step*whole%dy, load=whole%load, reduced_modulus=whole%reduced_modulus)
      part%scene%gap = whole%gap(first(1):last(1):step, first(2):last(2):step)
      part%scene%covered = whole%covered(first(1):last(1):step, first(2):last(2):step)
      part%scene%velocity = whole%velocity(first(1):last(1):step, first(2):last(2):step, :, :)
      if (allocated(whole%supply)) part%scene%supply = whole%supply(first(1):last(1):step, first(2):last(2):step)
    end associate
    call guess_dry(part, 1, stat)
    if (stat == status_ok) call iterate(part, options, ended, stat)
    if (stat /= status_ok) return
    figures = reading(part, node - low + 1)
    films = figures(:2)
  end subroutine films_in

  !> A pressure on the grid of half the spacing; of a limited supply only between nodes that mostly have pressure: a meniscus
  !> that starts a node too far out or too near is found by a step for each node.
  subroutine refine(coarse, supplied, fine)
    real(wp), intent(in) :: coarse(:, :)
    logical, intent(in) :: supplied
    real(wp), allocatable, intent(inout) :: fine(:, :)
    integer :: i, j

    if (allocated(fine)) deallocate (fine)
    allocate (fine(2*size(coarse, 1) - 1, 2*size(coarse, 2) - 1))
    call interpolate_cubic(coarse, fine)
    fine = max(fine, 0.0_wp)
    if (.not. supplied) return
    do j = 1, size(fine, 2)
      do i = 1, size(fine, 1)
        associate (about => coarse((i + 1)/2:i/2 + 1, (j + 1)/2:j/2 + 1))
          if (2*count(about > 0) < size(about)) fine(i, j) = 0
        end associate
      end do
    end do
  end subroutine refine

  !> How often a grid can be halved, its ends kept.
  pure integer function halvings(nodes)
    integer, intent(in) :: nodes(2)
    integer, allocatable :: cells(:)

    halvings = 0
    cells = pack(nodes - 1, nodes > 1)
    do while (all(mod(cells, 2) == 0) .and. minval(cells)/2 + 1 >= fewest_nodes)
      cells = cells/2
      halvings = halvings + 1
    end do
  end function halvings

end module pyworm_contact_grids
