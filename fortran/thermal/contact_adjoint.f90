!> Sensitivities of figures by the adjoint of a contact: of its film alone (`film_adjoint`), or of film and temperature together
!> (`thermal_adjoint`).
module pyworm_contact_adjoint
  use pyworm_figure_adjoint, only: weigh_figure, weighed
  use pyworm_film_adjoint, only: adjoint_system, new_adjoint_system, solve_adjoint
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_bad_argument, status_ok
  use pyworm_thermal_adjoint, only: new_thermal_adjoint_system, solve_thermal_adjoint, thermal_adjoint, thermal_adjoint_system
  use pyworm_thermal_step, only: thermal_contact
  implicit none(type, external)
  private

  public :: contact_adjoints

contains

  !> Solves the adjoint of a contact last evaluated at its solution for figures by their weights of its fields, (nx, ny, field,
  !> figure) as of `figure_adjoint`, and of the rise at the levels, (nx, ny, level, figure), to `tolerance` times the first residual
  !> or within `most` iterations.
  subroutine contact_adjoints(contact, weights, rise_weights, tolerance, most, found, stat)
    type(thermal_contact), target, intent(inout) :: contact
    real(wp), intent(in) :: weights(:, :, :, :), rise_weights(:, :, :, :), tolerance
    integer, intent(in) :: most
    type(thermal_adjoint), intent(out) :: found(:)
    integer, intent(out) :: stat
    type(adjoint_system) :: cold
    type(thermal_adjoint_system) :: warm
    real(wp), dimension(size(weights, 1), size(weights, 2)) :: by_pressure, by_film
    real(wp), dimension(size(weights, 1), size(weights, 2), size(rise_weights, 3)) :: by_rise
    integer :: figure

    stat = status_bad_argument
    if (size(weights, 3) /= weighed .or. size(found) /= size(weights, 4)) return
    if (allocated(contact%heat)) then
      call new_thermal_adjoint_system(warm, contact, stat)
    else
      call new_adjoint_system(cold, contact%film, stat)
    end if
    do figure = 1, size(found)
      if (stat == status_ok) call weigh_figure(contact%film, weights(:, :, :, figure), by_pressure, by_film, by_rise, stat)
      if (stat /= status_ok) return
      if (allocated(contact%heat)) then
        by_rise = by_rise + rise_weights(:, :, :, figure)
        call solve_thermal_adjoint(warm, by_pressure, by_film, by_rise, tolerance, most, found(figure), stat)
      else
        call solve_adjoint(cold, by_pressure, by_film, tolerance, most, found(figure)%film_adjoint, stat)
      end if
    end do
  end subroutine contact_adjoints

end module pyworm_contact_adjoint
