!> Newton steps of a heated film: the base of the heat of point and line contacts.
!>
!> Sharif et al. (2001), eqs 18, 19 and 21: heat is conducted across the film, convected along it, made by shearing and
!> by compression. A sweep solves the columns of the film with fixed walls, in the order of the kind of contact, and
!> stores the columns' response to a change of the walls, with which the balance of the walls is then solved for the
!> whole contact: in a thin film the flux depends so strongly on the walls that alternating solves diverge.
!>
!> Conduction along the film is neglected: relative to that across, it is of the order (film over contact length)^2.
module pyworm_thermal_step
  use pyworm_column_sources, only: hottest
  use pyworm_film_newton, only: newton_step, film_contact, film_direction, move_film, film_balance, acceptable, note_progress, &
    search_step, first_row, last_row
  use pyworm_heat_columns, only: heat_columns
  use pyworm_heated_surface, only: heated_body
  use pyworm_interruption, only: interrupted
  use pyworm_kinds, only: wp
  use pyworm_rough_surfaces, only: asperity_pressure
  use pyworm_status, only: status_ok, status_interrupted, status_not_finite, status_no_memory
  use pyworm_tally, only: work_tally
  use pyworm_thermal_properties, only: oil_heat_law
  use pyworm_wall_balance, only: wall_pair, new_wall_pair, balance_walls
  implicit none(type, external)
  private

  public :: film_heat, thermal_contact, new_film_heat, enclose_film, heated_step, heat_sweep, start_temperature, rubbed_heat, &
    entering_oil

  !> Least relaxation factor of a sweep's change.
  real(wp), parameter :: least_fraction = 0.125_wp

  !> Heat of a film; temperatures are those above the inlet's [K].
  type, abstract :: film_heat
    type(oil_heat_law) :: law
    type(wall_pair) :: walls
    !> Fraction of the largest pressure above which temperatures must converge (elsewhere they affect little oil), and
    !> reduction of the walls' imbalance by a sweep.
    real(wp) :: judged_pressure = 0, wall_tolerance = 0
    !> Temperature at the nodes of the grid before a step.
    real(wp), allocatable :: before(:, :, :)
    !> Relaxation factor of a sweep's change, now and in the step before (zero if there was none), and the whole change
    !> of the sweep in the step before [K].
    real(wp) :: fraction = 1, last_fraction = 0
    real(wp), allocatable :: wanted(:, :, :)
    !> Whether temperatures stay as they are given, without a sweep after each step.
    logical :: held = .false.
    type(work_tally) :: work
  contains
    procedure(sweep), deferred :: sweep_columns
    procedure(storage), deferred :: change_with_time
    procedure(reset), deferred :: cool
    procedure(unsolved_columns), deferred :: unsolved
    procedure(convection), deferred :: carried_heat
    procedure(copier), deferred :: copy_columns
  end type film_heat

  !> A film and, where heat is simulated, its temperature.
  type :: thermal_contact
    class(film_contact), allocatable :: film
    class(film_heat), allocatable :: heat
  end type thermal_contact

  abstract interface
    !> Makes one sweep over the columns of a film with fixed walls; `change` is the largest change of temperature [K]
    !> where the pressure exceeds `least` [Pa].
    subroutine sweep(self, film, least, change)
      import :: film_heat, film_contact, wp
      implicit none(type, external)
      class(film_heat), intent(inout) :: self
      class(film_contact), intent(inout) :: film
      real(wp), intent(in) :: least
      real(wp), intent(out) :: change
    end subroutine sweep

    !> Sets rates of change at the nodes: of the oil's temperature at the levels, `warming` [K/s], which stores heat, and of
    !> its pressure, `pressing` [Pa/s].
    subroutine storage(self, warming, pressing, stat)
      import :: film_heat, wp
      implicit none(type, external)
      class(film_heat), intent(inout) :: self
      real(wp), intent(in) :: warming(:, :, :), pressing(:, :)
      integer, intent(out) :: stat
    end subroutine storage

    !> Resets the initial stresses of sweeps.
    subroutine reset(self)
      import :: film_heat
      implicit none(type, external)
      class(film_heat), intent(inout) :: self
    end subroutine reset

    !> Number of columns whose shear stress did not converge in the last sweep.
    pure integer function unsolved_columns(self)
      import :: film_heat
      implicit none(type, external)
      class(film_heat), intent(in) :: self
    end function unsolved_columns

    !> Heat convected or stored by the oil, less that of its compression, at the nodes at the last sweep [W/m2].
    subroutine convection(self, carried)
      import :: film_heat, wp
      implicit none(type, external)
      class(film_heat), intent(in) :: self
      real(wp), intent(out) :: carried(:, :)
    end subroutine convection

    !> Copies the columns in the state of the film, in the order of the main sweep; `status_bad_argument` of oil that stores
    !> heat, whose state is another one.
    subroutine copier(self, film, columns, stat)
      import :: film_heat, film_contact, heat_columns
      implicit none(type, external)
      class(film_heat), intent(in) :: self
      class(film_contact), intent(in) :: film
      class(heat_columns), allocatable, intent(out) :: columns
      integer, intent(out) :: stat
    end subroutine copier
  end interface

contains

  !> Makes the base of the heat of a sheared film; `enclose_film` then sets its temperature.
  !>
  !> The bodies move into the walls, `bulk` being their temperature far below the surface, above the inlet's [K];
  !> `most_iterations` bounds the Krylov iterations of one balance of the walls.
  subroutine new_film_heat(self, film, law, body_1, body_2, bulk, most_iterations, stat)
    class(film_heat), intent(inout) :: self
    class(film_contact), intent(in) :: film
    type(oil_heat_law), intent(in) :: law
    class(heated_body), allocatable, intent(inout) :: body_1, body_2
    real(wp), intent(in) :: bulk(2)
    integer, intent(in) :: most_iterations
    integer, intent(out) :: stat
    integer :: err

    self%law = law
    call new_wall_pair(self%walls, body_1, bulk(1), body_2, bulk(2), most_iterations, stat)
    if (stat /= status_ok) return
    allocate (self%before, self%wanted, mold=film%model%shear%nodes%rise, stat=err)
    if (err /= 0) then
      stat = status_no_memory
      return
    end if
    self%before = 0
    self%wanted = 0
  end subroutine new_film_heat

  !> Gives a film without heat the temperature of its walls before the contact, and that of oil that was with them for long.
  subroutine enclose_film(film, heat)
    class(film_contact), intent(inout) :: film
    class(film_heat), intent(in) :: heat
    real(wp) :: change

    call set_walls(film, heat, 0.0_wp, change)
    call admit_oil(film, heat)
  end subroutine enclose_film

  !> Makes one Newton step of the film from (p, h0), at which it was last evaluated, one sweep of heat at the new film,
  !> and evaluates the film's balance there.
  !>
  !> Arguments are as of `film_step`. The full Newton step is accepted or rejected after its
  !> sweep of heat, so that flows are evaluated once. If it is rejected, the damped step is found at the temperature
  !> before, and the relaxation factor is at most one half: a film that has thinned under the former pressure makes unbounded
  !> heat. Heat is swept even if no step is accepted.
  subroutine heated_step(film, heat, forcing, p, h0, residual, load_error, step, stat)
    class(film_contact), intent(inout) :: film
    class(film_heat), intent(inout) :: heat
    real(wp), intent(in) :: forcing
    real(wp), contiguous, intent(inout) :: p(:, :)
    real(wp), intent(inout) :: h0, residual, load_error
    type(newton_step), intent(out) :: step
    integer, intent(out) :: stat
    real(wp) :: merit, most
    integer :: heat_stat

    step%change = hottest
    merit = residual + abs(load_error)
    call film_direction(film, forcing, p, h0, load_error, step%krylov, stat)
    if (stat /= status_ok) return
    heat%before(:, :, :) = film%model%shear%nodes%rise
    step%damping = 1
    call move_film(film, step%damping, p, h0)
    call warm_film(film, heat, 1.0_wp, residual, load_error, step%change, heat_stat)
    if (heat_stat == status_interrupted) stat = heat_stat
    if (stat /= status_ok) return
    if (heat_stat /= status_ok .or. .not. acceptable(film, merit, residual, load_error)) then
      call set_temperature(film, heat, heat%before)
      call search_step(film, merit, p, h0, residual, load_error, step%damping, stat)
      most = merge(0.5_wp, 1.0_wp, heat%last_fraction > 0)
      call warm_film(film, heat, most, residual, load_error, step%change, heat_stat)
      if (heat_stat /= status_ok) then
        stat = heat_stat
        step%change = hottest
        return
      end if
    end if
    call note_progress(film, residual, load_error)
    heat%last_fraction = heat%fraction
    heat%wanted(:, :, :) = (film%model%shear%nodes%rise - heat%before)/heat%fraction
  end subroutine heated_step

  !> Makes a sweep of heat with a relaxation factor of at most `most`, and evaluates the balance of the film after
  !> it.
  subroutine warm_film(film, heat, most, residual, load_error, change, stat)
    class(film_contact), intent(inout) :: film
    class(film_heat), intent(inout) :: heat
    real(wp), intent(in) :: most
    real(wp), intent(inout) :: residual, load_error
    real(wp), intent(out) :: change
    integer, intent(out) :: stat

    heat%fraction = 1
    call heat_sweep(film, heat, change, stat)
    if (stat /= status_ok) return
    associate (rise => film%model%shear%nodes%rise)
      heat%fraction = min(settling_fraction(film, heat), most)
      if (heat%fraction < 1) call set_temperature(film, heat, heat%before + heat%fraction*(rise - heat%before))
    end associate
    call film_balance(film, residual, load_error)
  end subroutine warm_film

  !> Relaxation factor of a sweep's change, below one where sweeps oscillate or grow, by Aitken's extrapolation over the
  !> nodes with pressure (Kuettler and Wall 2008).
  real(wp) function settling_fraction(film, heat) result(fraction)
    class(film_contact), intent(in) :: film
    class(film_heat), intent(in) :: heat
    real(wp) :: turn, length, least, bend
    integer :: i, j, k

    turn = 0
    length = 0
    least = heat%judged_pressure*maxval(film%model%fields%p)
    associate (rise => film%model%shear%nodes%rise)
      do k = 1, size(rise, 3)
        do j = 1, size(rise, 2)
          do i = 1, size(rise, 1)
            if (.not. film%model%fields%p(i, j) > least) cycle
            ! w - w', w being what this sweep wants to change and w' what the one before did: the new factor is
            ! - factor (w - w').w'/(w - w')**2
            bend = rise(i, j, k) - heat%before(i, j, k) - heat%wanted(i, j, k)
            turn = turn - bend*heat%wanted(i, j, k)
            length = length + bend**2
          end do
        end do
      end do
    end associate
    fraction = 1
    if (heat%last_fraction > 0 .and. length > 0) then
      fraction = min(max(heat%last_fraction*turn/length, least_fraction), 1.0_wp)
    end if
  end function settling_fraction

  !> Makes one sweep over the columns, then balances the walls.
  !>
  !> `change` is the largest change of temperature [K] where there is pressure. If the temperature diverges, the contact
  !> is reset to the temperature of its bodies.
  subroutine heat_sweep(film, heat, change, stat)
    class(film_contact), intent(inout) :: film
    class(film_heat), intent(inout) :: heat
    real(wp), intent(out) :: change
    integer, intent(out) :: stat
    real(wp) :: least, missed, reduction, walls_change
    integer :: iterations

    change = hottest
    stat = status_interrupted
    if (interrupted()) return
    call heat%work%start()
    least = heat%judged_pressure*maxval(film%model%fields%p)
    call heat%sweep_columns(film, least, change)
    if (film%model%is_rough()) call rub(film, heat)
    ! heat of a stress that did not converge must not count as settled
    if (heat%unsolved() > 0) change = hottest
    ! the walls of a diverged film may overflow in single precision
    call judge_temperature(film, heat, stat)
    if (stat == status_ok) then
      call balance_walls(heat%walls, heat%wall_tolerance, missed, iterations, reduction)
      call set_walls(film, heat, least, walls_change)
      change = max(change, walls_change)
      call judge_temperature(film, heat, stat)
    end if
    call heat%work%finish()
  end subroutine heat_sweep

  !> Adds the heat of the asperities' friction to the flux into the walls, half to each.
  subroutine rub(film, heat)
    class(film_contact), intent(in) :: film
    class(film_heat), intent(inout) :: heat
    real(wp) :: rubbed(size(film%gap, 1))
    integer :: j

    associate (flux => heat%walls%flux)
      do j = first_row(film), last_row(film)
        rubbed = rubbed_heat(film, j)
        flux(:, j, 1) = flux(:, j, 1) + rubbed/2
        flux(:, j, 2) = flux(:, j, 2) + rubbed/2
      end do
    end associate
  end subroutine rub

  !> Heat of the asperities' friction in row j of rough surfaces [W/m2].
  pure function rubbed_heat(film, j) result(rubbed)
    class(film_contact), intent(in) :: film
    integer, intent(in) :: j
    real(wp) :: rubbed(size(film%gap, 1))

    associate (nodes => film%model%shear%nodes, rough => film%model%fields%rough)
      rubbed = rough%boundary_friction*asperity_pressure(rough, film%model%fields%p, j) &
        *hypot(nodes%sliding_x(:, j), nodes%sliding_y(:, j))
    end associate
  end function rubbed_heat

  !> Checks that the film is above absolute zero and below the largest rise; if not it is cooled down.
  subroutine judge_temperature(film, heat, stat)
    class(film_contact), intent(inout) :: film
    class(film_heat), intent(inout) :: heat
    integer, intent(out) :: stat
    real(wp) :: change
    integer :: i

    stat = status_ok
    associate (rise => film%model%shear%nodes%rise, walls => heat%walls)
      if (all(rise > -film%oil%temperature .and. rise < hottest)) return
      stat = status_not_finite
      rise = 0
      walls%flux = 0
      walls%admittance = 0
      heat%last_fraction = 0
      call heat%cool()
      do i = 1, 2
        walls%wall(:, :, i) = walls%body(i)%bulk
      end do
    end associate
    call set_walls(film, heat, 0.0_wp, change)
    call admit_oil(film, heat)
  end subroutine judge_temperature

  !> Starts from a temperature above the inlet's [K]: what sweeps before changed says nothing of those to come.
  subroutine start_temperature(film, heat, rise)
    class(film_contact), intent(inout) :: film
    class(film_heat), intent(inout) :: heat
    real(wp), intent(in) :: rise(:, :, :)

    call set_temperature(film, heat, rise)
    heat%last_fraction = 0
  end subroutine start_temperature

  !> Sets the temperature above the inlet's [K], at the levels.
  subroutine set_temperature(film, heat, rise)
    class(film_contact), intent(inout) :: film
    class(film_heat), intent(inout) :: heat
    real(wp), intent(in) :: rise(:, :, :)

    film%model%shear%nodes%rise(:, :, :) = rise
    heat%walls%wall(:, :, 1) = rise(:, :, 1)
    heat%walls%wall(:, :, 2) = rise(:, :, size(rise, 3))
    call admit_oil(film, heat)
  end subroutine set_temperature

  !> Sets the temperature on the outline, with which oil enters: it comes in layers that were with the walls for long, and
  !> are as warm as these before the contact; between the walls it changes as by conduction.
  subroutine admit_oil(film, heat)
    class(film_contact), intent(inout) :: film
    class(film_heat), intent(in) :: heat
    real(wp) :: entering
    integer :: k, nx

    nx = size(film%gap, 1)
    associate (rise => film%model%shear%nodes%rise)
      do k = 2, size(rise, 3) - 1
        entering = entering_oil(film, heat, k)
        rise([1, nx], :, k) = entering
        rise(:, :first_row(film) - 1, k) = entering
        rise(:, last_row(film) + 1:, k) = entering
      end do
    end associate
  end subroutine admit_oil

  !> Temperature of the oil that enters at a level between the walls, above the inlet's [K].
  pure real(wp) function entering_oil(film, heat, level)
    class(film_contact), intent(in) :: film
    class(film_heat), intent(in) :: heat
    integer, intent(in) :: level

    associate (z => film%model%shear%nodes%levels%z(level), body => heat%walls%body)
      entering_oil = (0.5_wp - z)*body(1)%bulk + (0.5_wp + z)*body(2)%bulk
    end associate
  end function entering_oil

  !> Sets the film's walls to those of the balance; the levels between change as by conduction alone, but for those on the
  !> outline (`admit_oil`). `change` is the largest of a wall [K] where the pressure exceeds `least` [Pa].
  subroutine set_walls(film, heat, least, change)
    class(film_contact), intent(inout) :: film
    class(film_heat), intent(in) :: heat
    real(wp), intent(in) :: least
    real(wp), intent(out) :: change
    real(wp) :: change_1(size(film%gap, 1)), change_2(size(film%gap, 1))
    integer :: j, k, inner, first, last

    change = 0
    inner = size(film%gap, 1) - 1
    first = first_row(film)
    last = last_row(film)
    associate (rise => film%model%shear%nodes%rise, levels => film%model%shear%nodes%levels, wall => heat%walls%wall)
      !$omp parallel do private(k, change_1, change_2) reduction(max:change) schedule(static)
      do j = 1, size(rise, 2)
        change_1 = wall(:, j, 1) - rise(:, j, 1)
        change_2 = wall(:, j, 2) - rise(:, j, levels%count)
        change = max(change, maxval(max(abs(change_1), abs(change_2)), mask=film%model%fields%p(:, j) > least))
        rise(:, j, 1) = wall(:, j, 1)
        rise(:, j, levels%count) = wall(:, j, 2)
        if (j < first .or. j > last) cycle
        do k = 2, levels%count - 1
          rise(2:inner, j, k) = rise(2:inner, j, k) + (0.5_wp - levels%z(k))*change_1(2:inner) &
            + (0.5_wp + levels%z(k))*change_2(2:inner)
        end do
      end do
    end associate
  end subroutine set_walls

end module pyworm_thermal_step
