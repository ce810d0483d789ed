!> Figures that are sums over the nodes of a film's fields, each with its weights: what they are by the state of the film.
module pyworm_figure_adjoint
  use pyworm_film_newton, only: film_contact
  use pyworm_kinds, only: wp
  use pyworm_shear_sensitivity, only: add_shear_sensitivity
  use pyworm_status, only: status_bad_argument, status_ok
  implicit none(type, external)
  private

  public :: weigh_figure

  !> Fields that figures weigh, in this order: pressure, of rough surfaces the total [Pa]; film, of these its mean thickness [m];
  !> pressure of the asperities [Pa]; stress of the oil in mid-film along x and y, a mean over the area [Pa]; heat of its shearing
  !> [W/m2].
  integer, parameter, public :: weighed = 6
  integer, parameter :: of_pressure = 1, of_film = 2, of_asperities = 3, of_stress = 4

contains

  !> Computes how a figure of `weight` (nx, ny, field) changes by the (total) pressure, by the film, of rough surfaces the gap
  !> between mean planes, and of a sheared film by the temperature at the levels.
  subroutine weigh_figure(film, weight, by_pressure, by_film, by_rise, stat)
    class(film_contact), intent(in) :: film
    real(wp), intent(in) :: weight(:, :, :)
    real(wp), contiguous, intent(out) :: by_pressure(:, :), by_film(:, :), by_rise(:, :, :)
    integer, intent(out) :: stat
    real(wp), dimension(size(weight, 1), size(weight, 2)) :: by_oil

    by_oil = 0
    by_film = 0
    by_rise = 0
    stat = status_ok
    if (any(abs(weight(:, :, of_stress:)) > 0)) then
      stat = status_bad_argument
      if (.not. film%model%is_sheared()) return
      call add_shear_sensitivity(film, weight(:, :, of_stress:), by_oil, by_film, by_rise, stat)
    end if
    if (.not. film%model%is_rough()) then
      by_pressure = weight(:, :, of_pressure) + by_oil
      by_film = by_film + weight(:, :, of_film)
      return
    end if
    ! the oil's pressure is the total less the asperities'; where it has ruptured these bear all
    associate (rough => film%model%fields%rough)
      by_oil = merge(by_oil - weight(:, :, of_asperities), 0.0_wp, film%free)
      by_pressure = weight(:, :, of_pressure) + weight(:, :, of_asperities) + by_oil
      by_film = by_film + rough%widening*weight(:, :, of_film) + rough%stiffness*by_oil
    end associate
  end subroutine weigh_figure

end module pyworm_figure_adjoint
