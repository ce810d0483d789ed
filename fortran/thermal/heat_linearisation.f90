!> Equations of a film's temperature (`heat_residual`), linearised at the present state.
!>
!> What the levels of a column lack depends on the column's own pressure of oil, its gradient, the film and the temperatures,
!> through shear, velocity and the properties of oil, and linearly on the temperature of the nodes upstream. Derivatives of
!> the first kind are central differences of the routines that a sweep uses, so that every law is in them; the shear is
!> solved from that of the state, whose errors cancel in the difference. Where convection changes from one scheme to another
!> within a difference, that of the side without the change counts.
!>
!> Between rough surfaces the film's derivative is that by the gap between mean planes, at constant pressure of the oil.
module pyworm_heat_linearisation
  use pyworm_column_work, only: column_work
  use pyworm_film_newton, only: film_contact, first_row, last_row
  use pyworm_heat_columns, only: heat_columns, strip_residuals, most_upstream
  use pyworm_heat_residual, only: state_columns
  use pyworm_kinds, only: wp
  use pyworm_oil_convection, only: most_columns
  use omp_lib, only: omp_get_thread_num
  use pyworm_status, only: status_ok, status_no_memory
  use pyworm_thermal_properties, only: conductivity
  use pyworm_thermal_step, only: film_heat
  implicit none(type, external)
  private

  public :: heat_linearisation, linearise_heat

  !> Inputs of a column before its temperatures: pressure, its gradient along x and y, and the gap.
  integer, parameter, public :: by_pressure = 1, by_slope_x = 2, by_slope_y = 3, by_gap = 4, before_levels = 4
  !> Step of a difference over the scale of its input: stresses then change by far less than makes slip grow e-fold, a
  !> thousandth of them, and of that of temperatures, over the inlet's: viscosity then changes by a thousandth.
  real(wp), parameter :: relative_step = 1e-6_wp, relative_warming = 1e-5_wp
  !> Least pressure and gradient that are the scale of their steps, over the largest ones.
  real(wp), parameter :: least_pressure = 1e-2_wp, least_slope = 1e-3_wp
  !> Difference of both sides' slopes, over the larger one, beyond which they are those of different schemes.
  real(wp), parameter :: turned = 0.1_wp

  type :: heat_linearisation
    !> Nodes of the grid, levels, and spacing of the nodes [m].
    integer :: nx = 0, ny = 0, levels = 0
    real(wp) :: spacing(2) = 0
    !> Whether the sweep takes the columns in the reverse order, and the numbers of their nodes, along x first.
    logical :: backward = .false.
    integer, allocatable :: node(:)
    !> Derivative of what the levels of a column lack by its inputs, (input, level, column).
    real(wp), allocatable :: block(:, :, :)
    !> Nodes upstream and the derivative by their temperature at the same level [W/(m2 K)], (most_upstream, level, column).
    integer, allocatable :: place(:, :, :)
    real(wp), allocatable :: weight(:, :, :)
    !> Heat of the asperities' friction into each body by their pressure [m/s], (nx, ny); of rough surfaces alone.
    real(wp), allocatable :: rubbing(:, :)
    !> Largest conductance of the film from wall to wall [W/(m2 K)]: over it what a level lacks is of the walls' unit.
    real(wp) :: conductance = 0
  end type heat_linearisation

contains

  !> Linearises the heat of a film; `stat` as of `heat_residual`.
  subroutine linearise_heat(film, heat, self, stat)
    class(film_contact), intent(in) :: film
    class(film_heat), intent(in) :: heat
    type(heat_linearisation), intent(out) :: self
    integer, intent(out) :: stat
    class(heat_columns), allocatable :: columns
    real(wp) :: steps(3)
    integer :: strip, count, err

    call state_columns(film, heat, columns, stat)
    if (stat /= status_ok) return
    count = columns%before(size(columns%before))
    self%nx = size(film%gap, 1)
    self%ny = size(film%gap, 2)
    self%levels = film%model%shear%nodes%levels%count
    self%spacing = film%spacing
    self%backward = columns%backward
    associate (n => self%levels)
      allocate (self%node(count), self%block(before_levels + n, n, count), self%place(most_upstream, n, count), &
        self%weight(most_upstream, n, count), stat=err)
    end associate
    stat = merge(status_ok, status_no_memory, err == 0)
    if (stat /= status_ok) return
    steps = difference_steps(film)
    !$omp parallel do schedule(dynamic)
    do strip = 1, size(columns%before) - 1
      call linearise_strip(columns, film, heat, strip, steps, columns%threads(omp_get_thread_num()), self)
    end do
    if (film%model%is_rough()) call linearise_rubbing(film, self)
    self%conductance = maxval(conductivity(heat%law, film%model%fields%p)/max(film%model%fields%h, film%floor))
  end subroutine linearise_heat

  !> Least steps of pressure [Pa] and of its gradient [Pa/m], and step of temperature [K].
  pure function difference_steps(film) result(steps)
    class(film_contact), intent(in) :: film
    real(wp) :: steps(3), steepest

    associate (p => film%model%fields%p)
      steepest = maxval(abs(p(2:, :) - p(:size(p, 1) - 1, :)))/film%spacing(1)
      if (size(p, 2) > 1) steepest = max(steepest, maxval(abs(p(:, 2:) - p(:, :size(p, 2) - 1)))/film%spacing(2))
      steps = [relative_step*least_pressure*maxval(p), relative_step*least_slope*steepest, relative_warming*film%oil%temperature]
    end associate
  end function difference_steps

  !> Linearises the columns of a strip.
  subroutine linearise_strip(columns, film, heat, strip, steps, work, self)
    class(heat_columns), intent(inout) :: columns
    class(film_contact), intent(in) :: film
    class(film_heat), intent(in) :: heat
    integer, intent(in) :: strip
    real(wp), intent(in) :: steps(3)
    type(column_work), intent(inout) :: work
    type(heat_linearisation), intent(inout) :: self
    real(wp), dimension(most_columns, self%levels) :: present, less, more
    real(wp), dimension(most_columns) :: stress_x, stress_y, slope_step, down, up
    integer :: first, last, m, c, k, input

    first = columns%before(strip) + 1
    last = columns%before(strip + 1)
    m = last - first + 1
    call columns%gather(film, strip, work, self%node(first:last))
    call strip_residuals(columns, film, heat%law, strip, work, present)
    stress_x(:m) = work%shear%tau_x(:m)
    stress_y(:m) = work%shear%tau_y(:m)
    associate (s => work%shear)
      ! a gradient is felt by the stress at the walls
      slope_step(:m) = max(steps(2), relative_step*(2*hypot(s%tau_x(:m), s%tau_y(:m))/s%film(:m) + hypot(s%px(:m), s%py(:m))))
    end associate
    call columns%find_upstream(film, strip, work, self%place(:, :, first:last), self%weight(:, :, first:last))
    do c = 1, m
      do k = 1, self%levels
        self%weight(:, k, first + c - 1) = -work%columns%thickness(c)*work%columns%levels%weight(k) &
          *self%weight(:, k, first + c - 1)
      end do
    end do
    do input = 1, before_levels + self%levels
      call set_steps(film, input, steps, slope_step(:m), self%node(first:last), down, up)
      call evaluate(-down, less)
      call evaluate(up, more)
      do k = 1, self%levels
        self%block(input, k, first:last) = slope(present(:m, k) - less(:m, k), more(:m, k) - present(:m, k), down(:m), up(:m))
      end do
    end do

  contains

    !> What the levels lack with an input of each column changed.
    subroutine evaluate(change, lacked)
      real(wp), intent(in) :: change(:)
      real(wp), contiguous, intent(out) :: lacked(:, :)
      integer :: nodes(m)

      call columns%gather(film, strip, work, nodes)
      work%shear%tau_x(:m) = stress_x(:m)
      work%shear%tau_y(:m) = stress_y(:m)
      call change_input(film, input, change(:m), nodes, work)
      call strip_residuals(columns, film, heat%law, strip, work, lacked)
    end subroutine evaluate

  end subroutine linearise_strip

  !> Steps of an input down and up at some nodes; pressure is not negative.
  pure subroutine set_steps(film, input, steps, slope_step, nodes, down, up)
    class(film_contact), intent(in) :: film
    integer, intent(in) :: input, nodes(:)
    real(wp), intent(in) :: steps(3), slope_step(:)
    real(wp), intent(inout) :: down(:), up(:)
    integer :: c, i, j

    do c = 1, size(nodes)
      i = modulo(nodes(c) - 1, size(film%gap, 1)) + 1
      j = (nodes(c) - 1)/size(film%gap, 1) + 1
      select case (input)
      case (by_pressure)
        up(c) = max(steps(1), relative_step*film%model%fields%p(i, j))
        down(c) = min(up(c), film%model%fields%p(i, j))
      case (by_slope_x, by_slope_y)
        up(c) = slope_step(c)
        down(c) = slope_step(c)
      case (by_gap)
        up(c) = relative_step*max(film%model%fields%h(i, j), film%floor)
        down(c) = up(c)
      case default
        up(c) = steps(3)
        down(c) = steps(3)
      end select
    end do
  end subroutine set_steps

  !> Changes an input of a gathered strip.
  pure subroutine change_input(film, input, change, nodes, work)
    class(film_contact), intent(in) :: film
    integer, intent(in) :: input, nodes(:)
    real(wp), intent(in) :: change(:)
    type(column_work), intent(inout) :: work
    integer :: m, c, i, j

    m = size(nodes)
    associate (oil => work%oil, shear => work%shear, known => work%columns%known, fields => film%model%fields)
      select case (input)
      case (by_pressure)
        oil%p(:m) = oil%p(:m) + change
      case (by_slope_x)
        shear%px(:m) = shear%px(:m) + merge(change, 0.0_wp, oil%p(:m) > 0)
      case (by_slope_y)
        shear%py(:m) = shear%py(:m) + merge(change, 0.0_wp, oil%p(:m) > 0)
      case (by_gap)
        do c = 1, m
          i = modulo(nodes(c) - 1, size(film%gap, 1)) + 1
          j = (nodes(c) - 1)/size(film%gap, 1) + 1
          associate (follows => merge(1.0_wp, 0.0_wp, fields%h(i, j) > film%floor))
            if (fields%is_rough()) then
              shear%film(c) = shear%film(c) + follows*fields%rough%widening(i, j)*change(c)
              shear%wetted(c) = shear%wetted(c) - fields%rough%area_h(i, j)*change(c)
            else
              shear%film(c) = shear%film(c) + follows*change(c)
            end if
          end associate
        end do
      case default
        known(:m, input - before_levels) = known(:m, input - before_levels) + change
      end select
    end associate
  end subroutine change_input

  !> Derivative by the differences of a function on both sides and their steps: the mean slope, or the smaller if they differ.
  elemental real(wp) function slope(before, after, down, up)
    real(wp), intent(in) :: before, after, down, up
    real(wp) :: from_before, from_after

    slope = (before + after)/(down + up)
    if (.not. down > 0) return
    from_before = before/down
    from_after = after/up
    if (abs(from_after - from_before) <= turned*max(abs(from_before), abs(from_after))) return
    slope = merge(from_before, from_after, abs(from_before) < abs(from_after))
  end function slope

  !> Sets the heat of the asperities' friction by their pressure.
  subroutine linearise_rubbing(film, self)
    class(film_contact), intent(in) :: film
    type(heat_linearisation), intent(inout) :: self
    integer :: j

    allocate (self%rubbing(self%nx, self%ny), source=0.0_wp)
    associate (nodes => film%model%shear%nodes)
      do j = first_row(film), last_row(film)
        self%rubbing(:, j) = film%model%fields%rough%boundary_friction*hypot(nodes%sliding_x(:, j), nodes%sliding_y(:, j))/2
      end do
    end associate
  end subroutine linearise_rubbing

end module pyworm_heat_linearisation
