!> Time steps of a contact's film: d(rho h)/dt by backward differences on its own grid.
!>
!> Of four times the differences through four and through three are blended (BDF2OPT; Vatsa, Carpenter and Lockard 2010, AIAA
!> 2010-122), of fewer it is the difference through all; steps may vary. The weights are those of
!> `pyworm/solver/transient/differences.py`. Heat follows the film as if it were steady.
module pyworm_contact_time
  use pyworm_contact_description, only: pyworm_options
  use pyworm_contact_iteration, only: add_models, iterate, iteration_end, oil_pressure, restart
  use pyworm_contact_state, only: add_heat, contact_state, make_film, set_flow_law
  use pyworm_film_newton, only: set_transient_term
  use pyworm_kinds, only: wp
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

  !> The films of the last times, the latest first.
  type :: film_past
    type(film_record), allocatable :: records(:)
  end type film_past

contains

  !> Remembers the present film as that of a time [s].
  subroutine remember(past, seconds, contact)
    type(film_past), intent(inout) :: past
    real(wp), intent(in) :: seconds
    type(contact_state), intent(in) :: contact
    type(film_record) :: present_film

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
  end subroutine remember

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
    if (contact%heated) rise = contact%film%film%model%shear%nodes%rise
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
