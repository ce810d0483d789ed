!> Shear of a point contact's film at the nodes: the flow across the film that faces have for the flow through them,
!> taken by lines of the grid, along which heat marches too.
module nodal_shear
  use flow_laws, only: stress_scales
  use kinds, only: wp
  use oil_laws, only: oil_law, hot_fluidity
  use point_film, only: point_contact
  use shear_flow, only: shear_strip, new_shear_strip, solve_shear, film_velocity, film_shear_rate, film_heat, flow_factors
  use sheared_reynolds, only: sheared_oil
  use status, only: status_ok
  implicit none(type, external)
  private

  public :: line_cut, take, put, shear_cut, shear_columns, shear_fields, film_profile

  !> Nodes treated together.
  integer, parameter :: most_nodes = 64

  !> Some nodes of one line of the grid.
  type :: line_cut
    !> Whether lines run along y.
    logical :: transposed = .false.
    !> The line, of how many, and its first and last node, of how many.
    integer :: line = 0, lines = 0, first = 0, last = 0, length = 0
  end type line_cut

  !> Fields of a sheared film, (nx, ny), zero on the outline.
  type, public :: shear_field
    !> Stress at the middle of the film [Pa], heat of shearing [W/m2] and the largest shear rate across the film [1/s].
    real(wp), allocatable :: stress_x(:, :), stress_y(:, :), friction(:, :), rate(:, :)
    !> Flow factors D and C along and across the sliding [m3/(Pa s)] (Sharif et al. 2001, eqs 13a and 14a).
    real(wp), allocatable :: along(:, :), across(:, :)
    !> Where the film slips (`shear_flow`).
    integer, allocatable :: slip(:, :)
  end type shear_field

contains

  !> Shear of the nodes of a cut, from the stress that `shear` holds.
  !>
  !> `rise` is the levels' temperature and `mean` that across the film, above the inlet's [K]; `softening` is the
  !> derivative of the fluidity by temperature [1/(Pa s K)].
  subroutine shear_cut(contact, cut, shear, p, mean, rise, softening)
    type(point_contact), intent(in) :: contact
    type(line_cut), intent(in) :: cut
    type(shear_strip), intent(inout) :: shear
    real(wp), contiguous, intent(out) :: p(:), mean(:), rise(:, :), softening(:, :)
    integer :: m, k

    m = cut%last - cut%first + 1
    shear%points = m
    associate (nodes => contact%shear%nodes)
      call take(contact%fields%p, cut, p)
      call take_gradient(contact, cut, shear%px, shear%py)
      call take(contact%fields%h, cut, shear%film)
      shear%film(:m) = max(shear%film(:m), contact%floor)
      call take(nodes%sliding_x, cut, shear%us)
      call take(nodes%sliding_y, cut, shear%vs)
      do k = 1, nodes%levels%count
        call take(nodes%rise(:, :, k), cut, rise(:, k))
      end do
      call shear_columns(contact%oil, nodes, p, rise, shear, mean, softening)
    end associate
  end subroutine shear_cut

  !> Shear of the columns of a strip that holds their film, gradient, sliding and the stress to start from.
  !>
  !> `rise` is the levels' temperature and `mean` that across the film, above the inlet's [K]; `softening` is the
  !> derivative of the fluidity by temperature [1/(Pa s K)].
  subroutine shear_columns(oil, nodes, p, rise, shear, mean, softening)
    type(oil_law), intent(in) :: oil
    type(sheared_oil), intent(in) :: nodes
    real(wp), contiguous, intent(in) :: p(:), rise(:, :)
    type(shear_strip), intent(inout) :: shear
    real(wp), contiguous, intent(inout) :: mean(:), softening(:, :)
    real(wp) :: by_pressure(size(rise, 1), size(rise, 2)), onset_p(size(p)), limit_p(size(p))
    integer :: m, k, failures

    m = shear%points
    mean(:m) = 0
    do k = 1, nodes%levels%count
      mean(:m) = mean(:m) + nodes%levels%weight(k)*rise(:m, k)
    end do
    call hot_fluidity(oil, p(:m), rise(:m, :), shear%fluidity(:m, :), by_pressure(:m, :), softening(:m, :))
    softening(:m, :) = softening(:m, :)*shear%fluidity(:m, :)
    call stress_scales(nodes%law, p(:m), mean(:m), shear%reference(:m), onset_p(:m), shear%limit(:m), limit_p(:m))
    call solve_shear(nodes%law, nodes%levels, shear, failures)
    shear%unsolved = shear%unsolved + failures
  end subroutine shear_columns

  !> Fields of a contact's shear.
  subroutine shear_fields(contact, field, stat)
    type(point_contact), intent(in) :: contact
    type(shear_field), intent(out) :: field
    integer, intent(out) :: stat
    type(shear_strip) :: shear
    type(line_cut) :: cut
    real(wp), dimension(most_nodes) :: p, mean, cosine, sine, along, across, lag_s, lag_r
    real(wp), dimension(most_nodes, contact%shear%nodes%levels%count) :: rise, softening, rate, heat, own, loading_x, &
      loading_y, relief_x, relief_y
    integer :: j, first, m

    associate (nx => contact%grid%nx, ny => contact%grid%ny, levels => contact%shear%nodes%levels)
      allocate (field%stress_x(nx, ny), field%stress_y(nx, ny), field%friction(nx, ny), field%rate(nx, ny), &
        field%along(nx, ny), field%across(nx, ny), source=0.0_wp)
      allocate (field%slip(nx, ny), source=0)
      call new_shear_strip(most_nodes, levels%count, shear, stat)
      if (stat /= status_ok) return
      do j = 2, ny - 1
        do first = 2, nx - 1, most_nodes
          cut = line_cut(.false., j, ny, first, min(first + most_nodes - 1, nx - 1), nx)
          m = cut%last - first + 1
          shear%tau_x = 0
          shear%tau_y = 0
          call shear_cut(contact, cut, shear, p, mean, rise, softening)
          call film_shear_rate(levels, shear, rate)
          call film_heat(levels, shear, heat, own, loading_x, loading_y, relief_x, relief_y)
          call flow_factors(contact%shear%nodes%law, levels, shear, cosine, sine, along, across, lag_s, lag_r)
          call put(shear%tau_x, cut, field%stress_x)
          call put(shear%tau_y, cut, field%stress_y)
          call put(shear%film(:m)*matmul(heat(:m, :), levels%weight), cut, field%friction)
          call put(maxval(rate(:m, :), dim=2), cut, field%rate)
          call put(along, cut, field%along)
          call put(across, cut, field%across)
          field%slip(first:cut%last, j) = shear%slip(:m)
        end do
      end do
    end associate
  end subroutine shear_fields

  !> Velocity across the film at node (i, j) [m/s], body 1 moving with (u1, v1).
  subroutine film_profile(contact, i, j, u1, v1, u, v, stat)
    type(point_contact), intent(in) :: contact
    integer, intent(in) :: i, j
    real(wp), intent(in) :: u1, v1
    real(wp), intent(out) :: u(:), v(:)
    integer, intent(out) :: stat
    type(shear_strip) :: shear
    real(wp) :: p(1), mean(1)
    real(wp), dimension(1, size(u)) :: rise, softening, u_levels, v_levels

    call new_shear_strip(1, size(u), shear, stat)
    if (stat /= status_ok) return
    call shear_cut(contact, line_cut(.false., j, contact%grid%ny, i, i, contact%grid%nx), shear, p, mean, rise, &
      softening)
    call film_velocity(contact%shear%nodes%law, contact%shear%nodes%levels, shear, [u1], [v1], u_levels, v_levels)
    u = u_levels(1, :)
    v = v_levels(1, :)
  end subroutine film_profile

  !> Pressure gradient at the nodes of a cut [Pa/m].
  pure subroutine take_gradient(contact, cut, px, py)
    type(point_contact), intent(in) :: contact
    type(line_cut), intent(in) :: cut
    real(wp), intent(out) :: px(:), py(:)
    integer :: c, i, j

    associate (p => contact%fields%p)
      do c = cut%first, cut%last
        i = merge(cut%line, c, cut%transposed)
        j = merge(c, cut%line, cut%transposed)
        px(c - cut%first + 1) = (p(i + 1, j) - p(i - 1, j))/(2*contact%grid%dx)
        py(c - cut%first + 1) = (p(i, j + 1) - p(i, j - 1))/(2*contact%grid%dy)
      end do
    end associate
  end subroutine take_gradient

  !> A field's values at the nodes of a cut.
  pure subroutine take(field, cut, values)
    real(wp), intent(in) :: field(:, :)
    type(line_cut), intent(in) :: cut
    real(wp), intent(inout) :: values(:)

    if (cut%transposed) then
      values(:cut%last - cut%first + 1) = field(cut%line, cut%first:cut%last)
    else
      values(:cut%last - cut%first + 1) = field(cut%first:cut%last, cut%line)
    end if
  end subroutine take

  !> Puts values into a field at the nodes of a cut.
  pure subroutine put(values, cut, field)
    real(wp), intent(in) :: values(:)
    type(line_cut), intent(in) :: cut
    real(wp), intent(inout) :: field(:, :)

    if (cut%transposed) then
      field(cut%line, cut%first:cut%last) = values(:cut%last - cut%first + 1)
    else
      field(cut%first:cut%last, cut%line) = values(:cut%last - cut%first + 1)
    end if
  end subroutine put

end module nodal_shear
