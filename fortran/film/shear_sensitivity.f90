!> How sums of the nodes' stress and heat of shearing change by the state of the film: by pressure, film and temperature.
!>
!> Stress and heat at a node follow from what is there (`shear_fields`): the oil's pressure, its gradient, the film, the share of
!> the area that the oil covers, and the temperatures at the levels. Their derivatives by each are central differences at
!> the node, of all nodes together, so that there is one description of the shear; the gradient's then go to the nodes that it is
!> made of.
module pyworm_shear_sensitivity
  use pyworm_film_newton, only: film_contact, first_row, last_row
  use pyworm_kinds, only: wp
  use pyworm_shear_fields, only: shear_columns, shear_nodes
  use pyworm_shear_profile, only: film_heat
  use pyworm_status, only: status_no_memory, status_ok
  use pyworm_strip_of_points, only: new_shear_strip, shear_strip
  implicit none(type, external)
  private

  public :: add_shear_sensitivity

  !> Nodes treated together.
  integer, parameter :: most_nodes = 64
  !> Relative steps of the differences and that of a temperature [K]: their error is the square of the step, times 1000 for the
  !> pressure in an exponent, and the stresses' (1e-10) over the step.
  real(wp), parameter :: relative_step = 1e-4_wp, pressure_step = 3e-5_wp, warm_step = 1e-2_wp
  !> Least pressure of a step over the largest pressure.
  real(wp), parameter :: least_pressure = 1e-2_wp
  !> Quantities at a node before its temperatures.
  integer, parameter :: pressure = 1, along_x = 2, along_y = 3, film = 4, wetted = 5, quantities = 5

  !> A strip of nodes: its state, quantity last, the steps, the stress found there, and the weights of the figure.
  type :: varied_strip
    integer :: count = 0
    real(wp), allocatable :: state(:, :), step(:, :), stress(:, :), weight(:, :)
    type(shear_strip) :: shear
    !> Scratch of the shear.
    real(wp), allocatable :: mean(:), softening(:, :), heat(:, :), own(:, :), arms(:, :, :)
  end type varied_strip

contains

  !> Adds to `by_p`, `by_film` and `by_rise` how the sum over the nodes of weight(:, :, 1:2) times the area's mean stress [Pa] and
  !> of weight(:, :, 3) times the heat of shearing [W/m2] changes by the oil's pressure, by the film, of rough surfaces the gap
  !> between mean planes at a given pressure of the oil, and by the temperature at the levels.
  subroutine add_shear_sensitivity(contact, weight, by_p, by_film, by_rise, stat)
    class(film_contact), intent(in) :: contact
    real(wp), intent(in) :: weight(:, :, :)
    real(wp), contiguous, intent(inout) :: by_p(:, :), by_film(:, :), by_rise(:, :, :)
    integer, intent(out) :: stat
    type(varied_strip) :: strip
    real(wp), allocatable :: change(:, :)
    integer :: j, first, last, levels

    levels = contact%model%shear%nodes%levels%count
    call new_varied_strip(levels, strip, stat)
    if (stat /= status_ok) return
    allocate (change(most_nodes, quantities + levels))
    do j = first_row(contact), last_row(contact)
      do first = 2, size(contact%gap, 1) - 1, most_nodes
        last = min(first + most_nodes - 1, size(contact%gap, 1) - 1)
        if (.not. any(abs(weight(first:last, j, :)) > 0)) cycle
        call take_strip(contact, weight, first, last, j, strip)
        call vary(contact, strip, change)
        call put_back(contact, first, last, j, change, by_p, by_film, by_rise)
      end do
    end do
  end subroutine add_shear_sensitivity

  !> Allocates a strip.
  subroutine new_varied_strip(levels, strip, stat)
    integer, intent(in) :: levels
    type(varied_strip), intent(out) :: strip
    integer, intent(out) :: stat
    integer :: err

    call new_shear_strip(most_nodes, levels, strip%shear, stat)
    if (stat /= status_ok) return
    allocate (strip%state(most_nodes, quantities + levels), strip%step(most_nodes, quantities + levels), &
      strip%stress(most_nodes, 2), strip%weight(most_nodes, 3), strip%mean(most_nodes), strip%softening(most_nodes, levels), &
      strip%heat(most_nodes, levels), strip%own(most_nodes, levels), strip%arms(most_nodes, levels, 4), stat=err)
    if (err /= 0) stat = status_no_memory
  end subroutine new_varied_strip

  !> Takes the state of the nodes first..last of row j, and sets the steps.
  subroutine take_strip(contact, weight, first, last, j, strip)
    class(film_contact), intent(in) :: contact
    real(wp), intent(in) :: weight(:, :, :)
    integer, intent(in) :: first, last, j
    type(varied_strip), intent(inout) :: strip
    real(wp) :: rise(most_nodes, contact%model%shear%nodes%levels%count), slope(most_nodes), largest
    integer :: m

    m = last - first + 1
    strip%count = m
    strip%weight(:m, :) = weight(first:last, j, :)
    strip%shear%tau_x(:m) = 0
    strip%shear%tau_y(:m) = 0
    call shear_nodes(contact, first, last, j, strip%shear, strip%mean, rise, strip%softening)
    associate (shear => strip%shear, state => strip%state, step => strip%step)
      strip%stress(:m, 1) = shear%tau_x(:m)
      strip%stress(:m, 2) = shear%tau_y(:m)
      state(:m, pressure) = contact%model%fields%p(first:last, j)
      state(:m, along_x) = shear%px(:m)
      state(:m, along_y) = shear%py(:m)
      state(:m, film) = shear%film(:m)
      state(:m, wetted) = shear%wetted(:m)
      state(:m, quantities + 1:) = rise(:m, :)
      largest = maxval(contact%model%fields%p)
      slope(:m) = hypot(shear%px(:m), shear%py(:m)) + 2*hypot(shear%tau_x(:m), shear%tau_y(:m))/shear%film(:m)
      step(:m, pressure) = pressure_step*(state(:m, pressure) + least_pressure*largest)
      step(:m, along_x) = relative_step*max(slope(:m), tiny(largest))
      step(:m, along_y) = step(:m, along_x)
      step(:m, film) = relative_step*state(:m, film)
      step(:m, wetted) = relative_step
      step(:m, quantities + 1:) = warm_step
    end associate
  end subroutine take_strip

  !> Computes the changes of the nodes' sums by each quantity, by central differences.
  subroutine vary(contact, strip, change)
    class(film_contact), intent(in) :: contact
    type(varied_strip), intent(inout) :: strip
    real(wp), intent(out) :: change(:, :)
    real(wp), dimension(most_nodes) :: more, less
    integer :: m, k

    m = strip%count
    do k = 1, size(strip%state, 2)
      if (k == along_y .and. size(contact%gap, 2) == 1) then
        change(:m, k) = 0
        cycle
      end if
      call sum_at(contact, strip, k, 1.0_wp, more)
      call sum_at(contact, strip, k, -1.0_wp, less)
      change(:m, k) = (more(:m) - less(:m))/(2*strip%step(:m, k))
    end do
  end subroutine vary

  !> Computes the nodes' sums with one quantity varied by so many steps.
  subroutine sum_at(contact, strip, quantity, steps, found)
    class(film_contact), intent(in) :: contact
    type(varied_strip), intent(inout) :: strip
    integer, intent(in) :: quantity
    real(wp), intent(in) :: steps
    real(wp), intent(out) :: found(:)
    real(wp) :: state(most_nodes, size(strip%state, 2))
    integer :: m

    m = strip%count
    state(:m, :) = strip%state(:m, :)
    state(:m, quantity) = state(:m, quantity) + steps*strip%step(:m, quantity)
    associate (shear => strip%shear, nodes => contact%model%shear%nodes, arms => strip%arms)
      shear%px(:m) = state(:m, along_x)
      shear%py(:m) = state(:m, along_y)
      shear%film(:m) = state(:m, film)
      shear%wetted(:m) = state(:m, wetted)
      shear%tau_x(:m) = strip%stress(:m, 1)
      shear%tau_y(:m) = strip%stress(:m, 2)
      call shear_columns(contact%oil, nodes, state(:m, pressure), state(:m, quantities + 1:), shear, strip%mean, strip%softening)
      call film_heat(nodes%levels, shear, strip%heat, strip%own, arms(:, :, 1), arms(:, :, 2), arms(:, :, 3), arms(:, :, 4))
      found(:m) = shear%wetted(:m)*(strip%weight(:m, 1)*shear%tau_x(:m) + strip%weight(:m, 2)*shear%tau_y(:m)) &
        + strip%weight(:m, 3)*shear%film(:m)*matmul(strip%heat(:m, :), nodes%levels%weight)
    end associate
  end subroutine sum_at

  !> Adds the changes to those of the nodes' pressure, film and temperatures.
  subroutine put_back(contact, first, last, j, change, by_p, by_film, by_rise)
    class(film_contact), intent(in) :: contact
    integer, intent(in) :: first, last, j
    real(wp), intent(in) :: change(:, :)
    real(wp), contiguous, intent(inout) :: by_p(:, :), by_film(:, :), by_rise(:, :, :)
    real(wp) :: by_gap(most_nodes)
    integer :: m

    m = last - first + 1
    associate (slope_x => change(:m, along_x)/(2*contact%spacing(1)), slope_y => change(:m, along_y)/(2*contact%spacing(2)))
      by_p(first:last, j) = by_p(first:last, j) + change(:m, pressure)
      by_p(first + 1:last + 1, j) = by_p(first + 1:last + 1, j) + slope_x
      by_p(first - 1:last - 1, j) = by_p(first - 1:last - 1, j) - slope_x
      if (size(contact%gap, 2) > 1) then
        by_p(first:last, j + 1) = by_p(first:last, j + 1) + slope_y
        by_p(first:last, j - 1) = by_p(first:last, j - 1) - slope_y
      end if
    end associate
    ! a film below its floor stays there
    by_gap(:m) = merge(change(:m, film), 0.0_wp, contact%model%fields%h(first:last, j) > contact%floor)
    if (contact%model%is_rough()) then
      associate (rough => contact%model%fields%rough)
        by_gap(:m) = by_gap(:m)*rough%widening(first:last, j) - change(:m, wetted)*rough%area_h(first:last, j)
      end associate
    end if
    by_film(first:last, j) = by_film(first:last, j) + by_gap(:m)
    by_rise(first:last, j, :) = by_rise(first:last, j, :) + change(:m, quantities + 1:)
  end subroutine put_back

end module pyworm_shear_sensitivity
