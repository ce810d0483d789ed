!> Sensitivities of figures that are sums over the nodes of a film's fields, each with its weights.
module pyworm_figure_adjoint
  use pyworm_film_adjoint, only: adjoint_system, film_adjoint, new_adjoint_system, solve_adjoint
  use pyworm_film_newton, only: film_contact
  use pyworm_kinds, only: wp
  use pyworm_shear_sensitivity, only: add_shear_sensitivity
  use pyworm_status, only: status_bad_argument, status_ok
  implicit none(type, external)
  private

  public :: figure_adjoints

  !> Fields that figures weigh, in this order: pressure, of rough surfaces the total [Pa]; film, of these its mean thickness [m];
  !> pressure of the asperities [Pa]; stress of the oil in mid-film along x and y, a mean over the area [Pa]; heat of its shearing
  !> [W/m2].
  integer, parameter, public :: weighed = 6
  integer, parameter :: of_pressure = 1, of_film = 2, of_asperities = 3, of_stress = 4

contains

  !> Solves the adjoint of a film last evaluated at its solution for figures by their weights (nx, ny, field, figure), to
  !> `tolerance` times the first residual or within `most` iterations.
  subroutine figure_adjoints(film, weights, tolerance, most, found, stat)
    class(film_contact), target, intent(inout) :: film
    real(wp), intent(in) :: weights(:, :, :, :)
    real(wp), intent(in) :: tolerance
    integer, intent(in) :: most
    type(film_adjoint), intent(out) :: found(:)
    integer, intent(out) :: stat
    type(adjoint_system) :: system
    real(wp), dimension(size(weights, 1), size(weights, 2)) :: by_pressure, by_film
    integer :: figure

    stat = status_bad_argument
    if (size(weights, 3) /= weighed .or. size(found) /= size(weights, 4)) return
    call new_adjoint_system(system, film, stat)
    do figure = 1, size(found)
      if (stat == status_ok) call weigh(film, weights(:, :, :, figure), by_pressure, by_film, stat)
      if (stat == status_ok) call solve_adjoint(system, by_pressure, by_film, tolerance, most, found(figure), stat)
    end do
  end subroutine figure_adjoints

  !> Computes how a figure changes by the (total) pressure and by the film, of rough surfaces the gap between mean planes.
  subroutine weigh(film, weight, by_pressure, by_film, stat)
    class(film_contact), intent(in) :: film
    real(wp), intent(in) :: weight(:, :, :)
    real(wp), contiguous, intent(out) :: by_pressure(:, :), by_film(:, :)
    integer, intent(out) :: stat
    real(wp), dimension(size(weight, 1), size(weight, 2)) :: by_oil
    real(wp), allocatable :: by_rise(:, :, :)

    by_oil = 0
    by_film = 0
    stat = status_ok
    if (any(abs(weight(:, :, of_stress:)) > 0)) then
      stat = status_bad_argument
      if (.not. film%model%is_sheared()) return
      allocate (by_rise, mold=film%model%shear%nodes%rise)
      by_rise = 0
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
  end subroutine weigh

end module pyworm_figure_adjoint
