!> Shear of a line contact's film at the nodes: the flow across the film that faces have for the flow through them.
module line_nodal_shear
  use kinds, only: wp
  use line_film, only: line_contact
  use nodal_shear, only: shear_columns
  use shear_flow, only: shear_strip, new_shear_strip, film_velocity, film_shear_rate, film_heat, flow_factors
  use status, only: status_ok
  implicit none(type, external)
  private

  public :: line_shear_field, shear_line_nodes, line_shear_fields, line_film_profile

  !> Nodes treated together.
  integer, parameter :: most_nodes = 64

  !> Fields of a sheared film, (n), zero at both ends.
  type :: line_shear_field
    !> Stress at the middle of the film [Pa], heat of shearing [W/m2], the largest shear rate across the film [1/s].
    real(wp), allocatable :: stress(:), friction(:), rate(:)
    !> Flow factor D [m3/(Pa s)] (Sharif et al. 2001, eq. 13a).
    real(wp), allocatable :: factor(:)
    !> Where the film slips (`shear_flow`).
    integer, allocatable :: slip(:)
  end type line_shear_field

contains

  !> Shear of the inner nodes first..last, from the stress that `shear` holds.
  !>
  !> `rise` is the levels' temperature and `mean` that across the film, above the inlet's [K]; `softening` is the
  !> derivative of the fluidity by temperature [1/(Pa s K)].
  subroutine shear_line_nodes(contact, first, last, shear, mean, rise, softening)
    class(line_contact), intent(in) :: contact
    integer, intent(in) :: first, last
    type(shear_strip), intent(inout) :: shear
    real(wp), contiguous, intent(inout) :: mean(:), rise(:, :), softening(:, :)
    integer :: m

    m = last - first + 1
    shear%points = m
    associate (nodes => contact%shear%nodes, p => contact%fields%p(:, 1))
      shear%film(:m) = max(contact%fields%h(first:last, 1), contact%floor)
      shear%px(:m) = (p(first + 1:last + 1) - p(first - 1:last - 1))/(2*contact%grid%dx)
      shear%py(:m) = 0
      shear%us(:m) = nodes%sliding_x(first:last, 1)
      shear%vs(:m) = 0
      rise(:m, :) = nodes%rise(first:last, 1, :)
      call shear_columns(contact%oil, nodes, p(first:last), rise, shear, mean, softening)
    end associate
  end subroutine shear_line_nodes

  !> Fields of a contact's shear.
  subroutine line_shear_fields(contact, field, stat)
    class(line_contact), intent(in) :: contact
    type(line_shear_field), intent(out) :: field
    integer, intent(out) :: stat
    type(shear_strip) :: shear
    real(wp), dimension(most_nodes) :: mean, cosine, sine, along, across, lag_s, lag_r
    real(wp), dimension(most_nodes, contact%shear%nodes%levels%count) :: rise, softening, rate, heat, own, loading_x, &
      loading_y, relief_x, relief_y
    integer :: first, last, m

    associate (n => contact%grid%n, levels => contact%shear%nodes%levels)
      allocate (field%stress(n), field%friction(n), field%rate(n), field%factor(n), source=0.0_wp)
      allocate (field%slip(n), source=0)
      call new_shear_strip(most_nodes, levels%count, shear, stat)
      if (stat /= status_ok) return
      do first = 2, n - 1, most_nodes
        last = min(first + most_nodes, n) - 1
        m = last - first + 1
        shear%tau_x = 0
        shear%tau_y = 0
        call shear_line_nodes(contact, first, last, shear, mean, rise, softening)
        call film_shear_rate(levels, shear, rate)
        call film_heat(levels, shear, heat, own, loading_x, loading_y, relief_x, relief_y)
        call flow_factors(contact%shear%nodes%law, levels, shear, cosine, sine, along, across, lag_s, lag_r)
        field%stress(first:last) = shear%tau_x(:m)
        field%friction(first:last) = shear%film(:m)*matmul(heat(:m, :), levels%weight)
        field%rate(first:last) = maxval(rate(:m, :), dim=2)
        field%factor(first:last) = along(:m)
        field%slip(first:last) = shear%slip(:m)
      end do
    end associate
  end subroutine line_shear_fields

  !> Velocity across the film at inner node i [m/s], body 1 moving with u1.
  subroutine line_film_profile(contact, i, u1, u, stat)
    class(line_contact), intent(in) :: contact
    integer, intent(in) :: i
    real(wp), intent(in) :: u1
    real(wp), intent(out) :: u(:)
    integer, intent(out) :: stat
    type(shear_strip) :: shear
    real(wp) :: mean(1)
    real(wp), dimension(1, size(u)) :: rise, softening, along, across

    call new_shear_strip(1, size(u), shear, stat)
    if (stat /= status_ok) return
    call shear_line_nodes(contact, i, i, shear, mean, rise, softening)
    call film_velocity(contact%shear%nodes%law, contact%shear%nodes%levels, shear, [u1], [0.0_wp], along, across)
    u = along(1, :)
  end subroutine line_film_profile

end module line_nodal_shear
