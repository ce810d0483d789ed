!> Time steps of a contact's film: d(rho h)/dt by backward differences on its own grid.
!>
!> Of four times the differences through four and through three are blended (BDF2OPT; Vatsa, Carpenter and Lockard 2010, AIAA
!> 2010-122), of fewer it is the difference through all; steps may vary. The weights are those of
!> `pyworm/solver/transient/differences.py`. Bodies remember the heat of the films before (`residual_rise`); the oil's follows the
!> film as if it were steady.
module pyworm_contact_time
  use pyworm_contact_description, only: pyworm_options
  use pyworm_contact_iteration, only: add_models, iterate, iteration_end, oil_pressure, restart
  use pyworm_contact_state, only: add_heat, contact_state, make_film, set_flow_law
  use pyworm_film_newton, only: set_transient_term
  use pyworm_kinds, only: wp
  use pyworm_remembered_flux, only: moving_axes
  use pyworm_residual_rise, only: chosen_times, onward_flux, residual_rise, surface_past
  use pyworm_status, only: status_ok
  use pyworm_thermal_step, only: start_temperature
  implicit none(type, external)
  private

  public :: film_past, remember, advance, backward_weights

  !> Films from which a rate of change follows, and share of the difference through four values in that which is used.
  integer, parameter :: most_films = 3
  real(wp), parameter :: difference_share = 0.48_wp

  !> The oil at the nodes at one time [s]: film times relative density, as far as the gap is filled [m].
  type :: film_record
    real(wp) :: seconds = 0
    real(wp), allocatable :: content(:, :)
  end type film_record

  !> Heat of both surfaces at one time [s]: flux into each (nx, ny, body) [W/m2] and velocity at the least gap (component, body)
  !> [m/s].
  type :: heat_record
    real(wp) :: seconds = 0
    real(wp), allocatable :: flux(:, :, :)
    real(wp) :: velocity(2, 2) = 0
  end type heat_record

  !> The films of the last times, and the heat of all, the latest first.
  type :: film_past
    type(film_record), allocatable :: records(:)
    type(heat_record), allocatable :: heat(:)
  end type film_past

contains

  !> Remembers the present film as that of a time [s].
  subroutine remember(past, seconds, contact)
    type(film_past), intent(inout) :: past
    real(wp), intent(in) :: seconds
    type(contact_state), intent(in) :: contact
    type(film_record) :: present_film
    type(heat_record), allocatable :: heat(:)

    present_film%seconds = seconds
    associate (model => contact%film%film%model)
      present_film%content = model%fields%rho*model%fields%h
      if (model%is_partial()) present_film%content = present_film%content*reshape(model%partial%fraction, &
        shape(present_film%content))
    end associate
    if (allocated(past%records)) then
      past%records = [present_film, past%records(:min(size(past%records), most_films - 1))]
    else
      past%records = [present_film]
    end if
    if (.not. contact%heated) return
    if (.not. allocated(past%heat)) allocate (past%heat(0))
    allocate (heat(size(past%heat) + 1))
    heat(1)%seconds = seconds
    heat(1)%flux = contact%film%heat%walls%flux
    heat(1)%velocity = velocity_at_contact(contact)
    heat(2:) = past%heat
    call move_alloc(heat, past%heat)
  end subroutine remember

  !> Velocity of both surfaces at the least gap (component, body) [m/s].
  pure function velocity_at_contact(contact) result(velocity)
    type(contact_state), intent(in) :: contact
    real(wp) :: velocity(2, 2)
    integer :: node(2)

    node = minloc(contact%scene%gap)
    velocity = contact%scene%velocity(node(1), node(2), :, :)
  end function velocity_at_contact

  !> Sets what both surfaces of the contact are warmer by, `interval` [s] after the latest heat that is remembered.
  subroutine recall_heat(past, interval, contact)
    type(film_past), intent(in) :: past
    real(wp), intent(in) :: interval
    type(contact_state), intent(inout) :: contact
    type(surface_past) :: surface
    type(moving_axes) :: axes
    real(wp) :: present_flux(size(contact%p, 1), size(contact%p, 2), 2), ahead, velocity(2, 2)
    integer :: before, body, k

    if (.not. allocated(past%heat)) return
    before = min(2, size(past%heat))
    ahead = 0
    if (before == 2) ahead = interval/(past%heat(1)%seconds - past%heat(2)%seconds)
    associate (last => past%heat(1)%flux, earlier => past%heat(before)%flux)
      call onward_flux(last(:, :, 1), last(:, :, 2), earlier(:, :, 1), earlier(:, :, 2), ahead, present_flux(:, :, 1), &
        present_flux(:, :, 2))
    end associate
    velocity = velocity_at_contact(contact)
    axes = moving_axes([0.0_wp, 0.0_wp], contact%step*[contact%scene%dx, contact%scene%dy])
    surface%ages = [0.0_wp, past%heat(1)%seconds - past%heat%seconds + interval]
    if (.not. allocated(contact%residual_rise)) allocate (contact%residual_rise, mold=present_flux)
    do body = 1, 2
      surface%velocities = reshape([velocity(:, body), (past%heat(k)%velocity(:, body), k=1, size(past%heat))], &
        [2, size(surface%ages)])
      associate (solid => contact%bodies(body))
        surface%chosen = chosen_times(surface%ages, shape(contact%p), axes%spacing, velocity(:, body), &
          solid%conductivity/solid%heat_capacity)
        surface%axes = [(axes, k=1, size(surface%chosen))]
        if (allocated(surface%flux)) deallocate (surface%flux)
        allocate (surface%flux(size(contact%p, 1), size(contact%p, 2), size(surface%chosen)))
        surface%flux(:, :, 1) = present_flux(:, :, body)
        do k = 2, size(surface%chosen)
          surface%flux(:, :, k) = past%heat(surface%chosen(k) - 1)%flux(:, :, body)
        end do
        associate (u => contact%scene%velocity(::contact%step, ::contact%step, 1, body), &
            v => contact%scene%velocity(::contact%step, ::contact%step, 2, body))
          call residual_rise(surface, solid%conductivity/solid%heat_capacity, solid%conductivity*solid%heat_capacity, 0.0_wp, &
            u, v, contact%residual_rise(:, :, body))
        end associate
      end associate
    end do
  end subroutine recall_heat

  !> Solves the film `interval` [s] after the latest that is remembered, and remembers it.
  !>
  !> It starts from the film before with all that is simulated or, where that leads nowhere, by stages.
  subroutine advance(contact, past, interval, options, ended, stat)
    type(contact_state), intent(inout) :: contact
    type(film_past), intent(inout) :: past
    real(wp), intent(in) :: interval
    type(pyworm_options), intent(in) :: options
    type(iteration_end), intent(out) :: ended
    integer, intent(out) :: stat
    real(wp), allocatable :: p(:, :), oil(:, :), rise(:, :, :)
    real(wp) :: h0

    allocate (p, source=contact%p)
    h0 = contact%h0
    oil = oil_pressure(contact)
    if (contact%heated) then
      rise = contact%film%film%model%shear%nodes%rise
      call recall_heat(past, interval, contact)
    end if
    call make_changing(contact, past, interval, stat)
    if (stat == status_ok .and. contact%sheared) call set_flow_law(contact, .false., stat)
    if (stat == status_ok .and. contact%heated) then
      call add_heat(contact, stat)
      if (stat == status_ok) call start_temperature(contact%film%film, contact%film%heat, rise)
    end if
    if (stat == status_ok .and. allocated(contact%curves)) call restart(contact, oil)
    if (stat == status_ok) call iterate(contact, options, ended, stat)
    if (stat /= status_ok) then
      contact%p = oil
      contact%h0 = h0
      call make_changing(contact, past, interval, stat)
      if (stat == status_ok) call iterate(contact, options, ended, stat)
      if (stat == status_ok) call add_models(contact, options, ended, stat)
    end if
    if (stat == status_ok) then
      call remember(past, past%records(1)%seconds + interval, contact)
    else
      contact%p = p
      contact%h0 = h0
    end if
  end subroutine advance

  !> Makes the Newtonian film with the rate of change that follows from the films before.
  subroutine make_changing(contact, past, interval, stat)
    type(contact_state), intent(inout) :: contact
    type(film_past), intent(in) :: past
    real(wp), intent(in) :: interval
    integer, intent(out) :: stat
    real(wp), allocatable :: explicit_rate(:, :)
    real(wp) :: weights(size(past%records) + 1)
    integer :: k

    associate (records => past%records)
      weights = backward_weights([records(1)%seconds + interval, records%seconds])
      explicit_rate = weights(2)*records(1)%content
      do k = 2, size(records)
        explicit_rate = explicit_rate + weights(k + 1)*records(k)%content
      end do
    end associate
    call make_film(contact, contact%step, stat)
    if (stat == status_ok) call set_transient_term(contact%film%film, weights(1), explicit_rate, stat)
  end subroutine make_changing

  !> Weights of values at some times [s], the latest first, in their rate of change at the latest [1/s].
  pure function backward_weights(times) result(weights)
    real(wp), intent(in) :: times(:)
    real(wp) :: weights(size(times))

    weights = slope_weights(times)
    if (size(times) <= most_films) return
    weights = difference_share*weights
    weights(:most_films) = weights(:most_films) + (1 - difference_share)*slope_weights(times(:most_films))
  end function backward_weights

  !> Weights of values at some times in the slope at the first of the polynomial through them.
  pure function slope_weights(times) result(weights)
    real(wp), intent(in) :: times(:)
    real(wp) :: weights(size(times))
    integer :: j, k

    weights(1) = 0
    do j = 2, size(times)
      weights(1) = weights(1) + 1/(times(1) - times(j))
      weights(j) = 1/(times(j) - times(1))
      do k = 2, size(times)
        if (k /= j) weights(j) = weights(j)*(times(1) - times(k))/(times(j) - times(k))
      end do
    end do
  end function slope_weights

end module pyworm_contact_time
