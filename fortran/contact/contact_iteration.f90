!> Newton's iteration of a contact's film on one grid, by stages: isothermal and Newtonian, with the asperities of rough
!> surfaces, with the flow law, with heat.
module pyworm_contact_iteration
  use pyworm_contact_description, only: pyworm_options
  use pyworm_contact_state, only: add_heat, contact_state, is_inner, is_line, set_flow_law
  use pyworm_film_newton, only: film_residual, film_step, newton_step, set_film, set_ruptured
  use pyworm_kinds, only: wp
  use pyworm_rough_surfaces, only: asperity_pressure
  use pyworm_roughness_curves, only: gap_under
  use pyworm_status, only: status_no_descent, status_not_converged, status_ok
  use pyworm_thermal_step, only: heated_step
  implicit none(type, external)
  private

  public :: iteration_end, iterate, add_models, restart, oil_pressure

  !> Balance, over the tolerance, of a film that may take all steps: local slip and heat slow the last ones.
  real(wp), parameter :: near = 6
  !> Relative accuracy of the linear systems of line and point contacts.
  real(wp), parameter :: line_forcing = 1e-3_wp, point_forcing = 0.1_wp
  !> Growth of the residual from which Newton's iteration does not recover.
  real(wp), parameter :: lost_growth = 100
  !> Tolerance of rough surfaces' Newtonian film, from which that of the flow law starts, over the one asked for.
  real(wp), parameter :: loose = 10
  !> Last change of temperature over the largest rise at which heat has converged: this many times the tolerance, not above
  !> nor, since walls are balanced in single precision, below these; and the least rise that counts [K].
  real(wp), parameter :: per_tolerance = 10, largest_warming = 1e-3_wp, least_warming = 1e-7_wp, least_rise = 10.0_wp

  !> Where an iteration ended: residual, missing load over the load, and Newton steps.
  type :: iteration_end
    real(wp) :: residual = huge(1.0_wp), load_error = 1
    integer :: steps = 0
  end type iteration_end

contains

  !> Adds to a Newtonian film roughness, flow law and heat, as far as they are simulated, and solves it again.
  subroutine add_models(contact, options, ended, stat)
    type(contact_state), intent(inout) :: contact
    type(pyworm_options), intent(in) :: options
    type(iteration_end), intent(inout) :: ended
    integer, intent(out) :: stat
    type(pyworm_options) :: looser
    logical :: rough

    stat = status_ok
    if (.not. contact%sheared) return
    rough = allocated(contact%curves)
    if (rough) then
      call start_rough(contact, stat)
      looser = options
      looser%tolerance = loose*options%tolerance
      if (stat == status_ok) call iterate(contact, looser, ended, stat)
      if (stat /= status_ok) return
    end if
    associate (oil => oil_pressure(contact))
      call set_flow_law(contact, .false., stat)
      if (stat == status_ok .and. rough) call restart(contact, oil)
    end associate
    if (stat == status_ok .and. rough .and. contact%heated) call iterate(contact, looser, ended, stat)
    if (stat == status_ok .and. contact%heated) call add_heat(contact, stat)
    if (stat == status_ok) call iterate(contact, options, ended, stat)
  end subroutine add_models

  !> Starts rough surfaces from a smooth film: its pressure is left to the oil, and the bodies are lifted until asperities bear
  !> no more than that. The load is then too large, and Newton's iteration descends the asperities' exponential from above.
  subroutine start_rough(contact, stat)
    type(contact_state), intent(inout) :: contact
    integer, intent(out) :: stat
    real(wp), allocatable :: smooth(:, :)
    integer :: peak(2)

    allocate (smooth, source=contact%p)
    peak = maxloc(smooth)
    associate (h => contact%film%film%model%fields%h)
      contact%h0 = contact%h0 + max(gap_under(contact%curves, maxval(smooth)) - h(peak(1), peak(2)), 0.0_wp)
    end associate
    call set_flow_law(contact, .true., stat)
    if (stat == status_ok) call restart(contact, smooth)
  end subroutine start_rough

  !> Sets the pressure of rough surfaces to one that the oil bears and what asperities bear at the present film on top.
  subroutine restart(contact, oil)
    type(contact_state), intent(inout) :: contact
    real(wp), intent(in) :: oil(:, :)
    integer :: j

    call set_ruptured(contact%film%film, oil <= 0)
    call set_film(contact%film%film, contact%p, contact%h0)
    associate (fields => contact%film%film%model%fields, inner => is_inner(size(oil, 1), size(oil, 2)))
      do j = 1, size(oil, 2)
        where (inner(:, j) .and. contact%p(:, j) > 0)
          contact%p(:, j) = oil(:, j) + asperity_pressure(fields%rough, fields%p, j) + fields%rough%excess(:, j)
        end where
      end do
    end associate
  end subroutine restart

  !> Pressure that the oil bears [Pa].
  function oil_pressure(contact) result(oil)
    type(contact_state), intent(in) :: contact
    real(wp) :: oil(size(contact%p, 1), size(contact%p, 2))
    integer :: j

    oil = contact%p
    associate (fields => contact%film%film%model%fields)
      if (.not. fields%is_rough()) return
      do j = 1, size(oil, 2)
        oil(:, j) = oil(:, j) - asperity_pressure(fields%rough, fields%p, j)
      end do
    end associate
  end function oil_pressure

  !> Makes Newton steps until the present film is within the tolerance and its heat has converged.
  subroutine iterate(contact, options, ended, stat)
    type(contact_state), intent(inout) :: contact
    type(pyworm_options), intent(in) :: options
    type(iteration_end), intent(inout) :: ended
    integer, intent(out) :: stat
    type(newton_step) :: newton
    real(wp) :: warming, warming_tolerance, first, forcing
    logical :: heated
    integer :: steps

    heated = allocated(contact%film%heat)
    forcing = merge(line_forcing, point_forcing, is_line(contact%scene))
    warming = merge(huge(1.0_wp), 0.0_wp, heated)
    warming_tolerance = min(max(per_tolerance*options%tolerance, least_warming), largest_warming)
    associate (residual => ended%residual, load_error => ended%load_error, film => contact%film%film)
      call film_residual(film, contact%p, contact%h0, residual, load_error)
      first = max(residual, 1.0_wp)
      do steps = 0, options%most_steps
        stat = status_ok
        ended%steps = steps
        if (max(residual, abs(load_error)) <= options%tolerance .and. warming <= warming_tolerance) return
        if (steps >= options%most_steps/2 .and. max(residual, abs(load_error)) > near*options%tolerance) exit
        if (steps == options%most_steps .or. .not. residual <= lost_growth*first) exit
        if (heated) then
          call heated_step(film, contact%film%heat, forcing, contact%p, contact%h0, residual, load_error, newton, stat)
          warming = newton%change/max(least_rise, maxval(film%model%shear%nodes%rise))
        else
          call film_step(film, forcing, contact%p, contact%h0, residual, load_error, newton, stat)
        end if
        ! a sweep of heat follows even where no step helps, and another film may belong to its temperatures
        if (stat /= status_ok .and. .not. (heated .and. stat == status_no_descent)) return
      end do
    end associate
    stat = status_not_converged
  end subroutine iterate

end module pyworm_contact_iteration
