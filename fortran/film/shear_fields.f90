!> Shear of a film at the nodes, by the model of the flow through the faces.
module pyworm_shear_fields
  use pyworm_film_newton, only: film_contact, first_row, last_row
  use pyworm_flow_laws, only: has_limit, slip_stress, stress_scales
  use pyworm_kinds, only: wp
  use pyworm_viscosity_density, only: oil_law, hot_fluidity
  use pyworm_sharif_flow_factors, only: flow_factors
  use pyworm_shear_profile, only: film_velocity, film_shear_rate, film_heat
  use pyworm_shear_stress, only: solve_shear
  use pyworm_strip_of_points, only: shear_strip, new_shear_strip
  use pyworm_sheared_oil, only: sheared_oil
  use pyworm_status, only: status_ok
  implicit none(type, external)
  private

  public :: shear_nodes, gather_nodes, shear_columns, nodal_shear, film_profile

  !> Nodes treated together.
  integer, parameter :: most_nodes = 64

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

  !> Computes the shear of the inner nodes first..last of row j, from the stress in `shear`.
  !>
  !> `rise` is the levels' temperature and `mean` that across the film, above the inlet's [K]; `softening` is the
  !> derivative of the fluidity by temperature [1/(Pa s K)].
  subroutine shear_nodes(contact, first, last, j, shear, mean, rise, softening)
    class(film_contact), intent(in) :: contact
    integer, intent(in) :: first, last, j
    type(shear_strip), intent(inout) :: shear
    real(wp), contiguous, intent(inout) :: mean(:), rise(:, :), softening(:, :)

    call gather_nodes(contact, first, last, j, shear, rise)
    call shear_columns(contact%oil, contact%model%shear%nodes, contact%model%fields%p(first:last, j), rise, shear, mean, softening)
  end subroutine shear_nodes

  !> Sets film, gradient and sliding of the inner nodes first..last of row j, and their temperature above the inlet's, `rise` [K].
  subroutine gather_nodes(contact, first, last, j, shear, rise)
    class(film_contact), intent(in) :: contact
    integer, intent(in) :: first, last, j
    type(shear_strip), intent(inout) :: shear
    real(wp), contiguous, intent(inout) :: rise(:, :)
    integer :: m

    m = last - first + 1
    shear%points = m
    associate (nodes => contact%model%shear%nodes, p => contact%model%fields%p, dx => contact%spacing(1), dy => contact%spacing(2))
      shear%film(:m) = max(contact%model%fields%h(first:last, j), contact%floor)
      shear%px(:m) = (p(first + 1:last + 1, j) - p(first - 1:last - 1, j))/(2*dx)
      if (size(p, 2) > 1) then
        shear%py(:m) = (p(first:last, j + 1) - p(first:last, j - 1))/(2*dy)
      else
        shear%py(:m) = 0
      end if
      shear%us(:m) = nodes%sliding_x(first:last, j)
      shear%vs(:m) = nodes%sliding_y(first:last, j)
      if (contact%model%is_rough()) shear%wetted(:m) = 1 - contact%model%fields%rough%area(first:last, j)
      rise(:m, :) = nodes%rise(first:last, j, :)
    end associate
  end subroutine gather_nodes

  !> Computes the shear of the columns of a strip from their film, gradient, sliding and initial stress.
  !>
  !> `rise` is the levels' temperature and `mean` that across the film, above the inlet's [K]; `softening` is the
  !> derivative of the fluidity by temperature [1/(Pa s K)].
  subroutine shear_columns(oil, nodes, p, rise, shear, mean, softening)
    type(oil_law), intent(in) :: oil
    type(sheared_oil), intent(in) :: nodes
    real(wp), contiguous, intent(in) :: p(:), rise(:, :)
    type(shear_strip), intent(inout) :: shear
    real(wp), contiguous, intent(inout) :: mean(:), softening(:, :)
    integer :: m, k, failures

    m = shear%points
    mean(:m) = 0
    do k = 1, nodes%levels%count
      mean(:m) = mean(:m) + nodes%levels%weight(k)*rise(:m, k)
    end do
    ! derivatives by pressure are unused: they are written to scratch
    call hot_fluidity(oil, p(:m), rise, shear%fluidity, shear%at_levels, softening)
    softening(:m, :) = softening(:m, :)*shear%fluidity(:m, :)
    call stress_scales(nodes%law, p(:m), mean(:m), shear%reference(:m), shear%step_x(:m), shear%limit(:m), &
      shear%step_y(:m))
    if (has_limit(nodes%law)) call bear_gradient(shear)
    call solve_shear(nodes%law, nodes%levels, shear, failures)
    shear%unsolved = shear%unsolved + failures
  end subroutine shear_columns

  !> Limits gradients beyond which both walls slip. Through faces such a gradient has unbounded flow and no solution
  !> has it; between two faces it comes from a jump of pressure that the grid does not resolve, as at an edge of
  !> rupture.
  pure subroutine bear_gradient(shear)
    type(shear_strip), intent(inout) :: shear
    real(wp) :: fraction
    integer :: i

    do i = 1, shear%points
      fraction = 2*slip_stress(shear%limit(i))/max(shear%film(i)*hypot(shear%px(i), shear%py(i)), 2*slip_stress(shear%limit(i)))
      shear%px(i) = fraction*shear%px(i)
      shear%py(i) = fraction*shear%py(i)
    end do
  end subroutine bear_gradient

  !> Computes the fields of a contact's shear; the flow factors, which cost more than all others, on request. In each row they are
  !> those from the first of the nodes that are `counted` to the last, by default all.
  subroutine nodal_shear(contact, factors_wanted, field, stat, counted)
    class(film_contact), intent(in) :: contact
    logical, intent(in) :: factors_wanted
    type(shear_field), intent(out) :: field
    integer, intent(out) :: stat
    logical, intent(in), optional :: counted(:, :)
    type(shear_strip) :: shear
    real(wp), dimension(most_nodes) :: mean, cosine, sine, along, across, lag_s, lag_r
    real(wp), dimension(most_nodes, contact%model%shear%nodes%levels%count) :: rise, softening, rate, heat, own, loading_x, &
      loading_y, relief_x, relief_y
    integer :: j, first, last, m, ends(2)

    associate (nx => size(contact%gap, 1), ny => size(contact%gap, 2), levels => contact%model%shear%nodes%levels, &
        faces => contact%model%shear%along_x)
      allocate (field%stress_x(nx, ny), field%stress_y(nx, ny), field%friction(nx, ny), field%rate(nx, ny), &
        field%along(nx, ny), field%across(nx, ny), source=0.0_wp)
      allocate (field%slip(nx, ny), source=0)
      call new_shear_strip(most_nodes, levels%count, shear, stat)
      if (stat /= status_ok) return
      do j = first_row(contact), last_row(contact)
        ends = [2, nx - 1]
        if (present(counted)) ends = [max(findloc(counted(:, j), .true., dim=1), 2), &
          min(findloc(counted(:, j), .true., dim=1, back=.true.), nx - 1)]
        do first = ends(1), ends(2), most_nodes
          last = min(first + most_nodes - 1, ends(2))
          m = last - first + 1
          shear%tau_x(:m) = (faces%stress_x(first - 1:last - 1, j) + faces%stress_x(first:last, j))/2
          shear%tau_y(:m) = (faces%stress_y(first - 1:last - 1, j) + faces%stress_y(first:last, j))/2
          call shear_nodes(contact, first, last, j, shear, mean, rise, softening)
          call film_shear_rate(levels, shear, rate)
          call film_heat(levels, shear, heat, own, loading_x, loading_y, relief_x, relief_y)
          field%stress_x(first:last, j) = shear%tau_x(:m)
          field%stress_y(first:last, j) = shear%tau_y(:m)
          field%friction(first:last, j) = shear%film(:m)*matmul(heat(:m, :), levels%weight)
          field%rate(first:last, j) = maxval(rate(:m, :), dim=2)
          field%slip(first:last, j) = shear%slip(:m)
          if (.not. factors_wanted) cycle
          call flow_factors(contact%model%shear%nodes%law, levels, shear, cosine, sine, along, across, lag_s, lag_r)
          field%along(first:last, j) = along(:m)
          field%across(first:last, j) = across(:m)
        end do
      end do
    end associate
  end subroutine nodal_shear

  !> Velocity across the film at inner node (i, j) [m/s], body 1 moving with (u1, v1).
  subroutine film_profile(contact, i, j, u1, v1, u, v, stat)
    class(film_contact), intent(in) :: contact
    integer, intent(in) :: i, j
    real(wp), intent(in) :: u1, v1
    real(wp), intent(out) :: u(:), v(:)
    integer, intent(out) :: stat
    type(shear_strip) :: shear
    real(wp) :: mean(1)
    real(wp), dimension(1, size(u)) :: rise, softening, u_levels, v_levels

    call new_shear_strip(1, size(u), shear, stat)
    if (stat /= status_ok) return
    call shear_nodes(contact, i, i, j, shear, mean, rise, softening)
    call film_velocity(contact%model%shear%nodes%law, contact%model%shear%nodes%levels, shear, [u1], [v1], u_levels, v_levels)
    u = u_levels(1, :)
    v = v_levels(1, :)
  end subroutine film_profile

end module pyworm_shear_fields
