!> Equations of the temperature of a steady film, in its present state.
!>
!> At the inner nodes each level between the walls has the heat that it lacks, E_k of `film_column` [W/m2], as a sweep with
!> the entrainment leaves it at its fixed point. At all nodes the first and the last level have the walls' balance,
!>   T_i - bulk_i - rise_i(q_i) [K],  q_i = -E_i and half the heat of the asperities' friction,
!> and the levels between them at the outline's nodes their temperature less that of the oil that enters [K].
module pyworm_heat_residual
  use pyworm_column_work, only: column_work
  use pyworm_film_newton, only: film_contact, first_row, last_row
  use pyworm_heat_columns, only: heat_columns, strip_residuals
  use pyworm_kinds, only: wp
  use pyworm_oil_convection, only: most_columns
  use omp_lib, only: omp_get_thread_num
  use pyworm_status, only: status_ok, status_bad_argument
  use pyworm_thermal_step, only: film_heat, rubbed_heat, entering_oil
  implicit none(type, external)
  private

  public :: heat_residual, heat_residual_change, spread_residual_change, state_columns

contains

  !> Residuals of all equations, (nx, ny, levels); film and temperature remain as they are.
  !>
  !> `status_bad_argument` of a film whose gap is filled in part, and of one whose oil or bodies remember another state.
  subroutine heat_residual(film, heat, residual, stat)
    class(film_contact), intent(in) :: film
    class(film_heat), intent(inout) :: heat
    real(wp), contiguous, intent(out) :: residual(:, :, :)
    integer, intent(out) :: stat

    call lacking_heat(film, heat, residual, stat)
    if (stat /= status_ok) return
    call wall_residual(film, heat, residual)
    call outline_residual(film, heat, residual)
  end subroutine heat_residual

  !> Change of the residuals from those of another contact at the same pressure and temperature, with the conduction of the
  !> other's bodies (`spread_residual_change` for that of its own).
  !>
  !> The bodies' rise, in single precision, is taken of the change of the flux, so that its rounding is of that.
  subroutine heat_residual_change(film, heat, other_film, other_heat, change, stat)
    class(film_contact), intent(in) :: film, other_film
    class(film_heat), intent(inout) :: heat, other_heat
    real(wp), contiguous, intent(out) :: change(:, :, :)
    integer, intent(out) :: stat
    real(wp), dimension(size(change, 1), size(change, 2), size(change, 3)) :: other
    real(wp), dimension(size(change, 1), size(change, 2)) :: flux, before, rise
    integer :: wall, level

    call lacking_heat(film, heat, change, stat)
    if (stat == status_ok) call lacking_heat(other_film, other_heat, other, stat)
    if (stat /= status_ok) return
    do wall = 1, 2
      level = merge(1, size(change, 3), wall == 1)
      call wall_flux(film, change(:, :, level), flux)
      call wall_flux(other_film, other(:, :, level), before)
      call other_heat%walls%body(wall)%surface%rise(flux - before, rise)
      change(:, :, level) = other_heat%walls%body(wall)%bulk - heat%walls%body(wall)%bulk - rise
      other(:, :, level) = 0
    end do
    call outline_residual(film, heat, change)
    call outline_residual(other_film, other_heat, other)
    change = change - other
  end subroutine heat_residual_change

  !> Change of the walls' residuals from those of another contact by the conduction of the bodies, at the other's flux; zero at the
  !> levels between. It is the difference of whole rises, each rounded to single precision.
  subroutine spread_residual_change(heat, other_film, other_heat, change, stat)
    class(film_heat), intent(inout) :: heat, other_heat
    class(film_contact), intent(in) :: other_film
    real(wp), contiguous, intent(out) :: change(:, :, :)
    integer, intent(out) :: stat
    real(wp), dimension(size(change, 1), size(change, 2)) :: flux, rise, risen
    integer :: wall, level

    call lacking_heat(other_film, other_heat, change, stat)
    if (stat /= status_ok) return
    change(:, :, 2:size(change, 3) - 1) = 0
    do wall = 1, 2
      level = merge(1, size(change, 3), wall == 1)
      call wall_flux(other_film, change(:, :, level), flux)
      call heat%walls%body(wall)%surface%rise(flux, rise)
      call other_heat%walls%body(wall)%surface%rise(flux, risen)
      change(:, :, level) = risen - rise
    end do
  end subroutine spread_residual_change

  !> Heat that the levels of all columns lack.
  subroutine lacking_heat(film, heat, lacked, stat)
    class(film_contact), intent(in) :: film
    class(film_heat), intent(in) :: heat
    real(wp), contiguous, intent(out) :: lacked(:, :, :)
    integer, intent(out) :: stat
    class(heat_columns), allocatable :: columns
    integer :: strip

    call state_columns(film, heat, columns, stat)
    if (stat /= status_ok) return
    lacked = 0
    !$omp parallel do schedule(dynamic)
    do strip = 1, size(columns%before) - 1
      call level_residual(columns, film, heat, strip, columns%threads(omp_get_thread_num()), lacked)
    end do
  end subroutine lacking_heat

  !> Flux into the body at a wall, from the heat that its level lacks.
  subroutine wall_flux(film, lacked, flux)
    class(film_contact), intent(in) :: film
    real(wp), intent(in) :: lacked(:, :)
    real(wp), intent(out) :: flux(:, :)
    integer :: j

    flux = -lacked
    if (.not. film%model%is_rough()) return
    do j = first_row(film), last_row(film)
      flux(:, j) = flux(:, j) + rubbed_heat(film, j)/2
    end do
  end subroutine wall_flux

  !> Columns of a film in its present state; arguments as of `heat_residual`.
  subroutine state_columns(film, heat, columns, stat)
    class(film_contact), intent(in) :: film
    class(film_heat), intent(in) :: heat
    class(heat_columns), allocatable, intent(out) :: columns
    integer, intent(out) :: stat

    stat = status_bad_argument
    associate (body => heat%walls%body)
      if (film%model%is_partial() .or. allocated(body(1)%remembered) .or. allocated(body(2)%remembered)) return
    end associate
    call heat%copy_columns(film, columns, stat)
  end subroutine state_columns

  !> Sets the heat that all levels of a strip lack.
  subroutine level_residual(columns, film, heat, strip, work, residual)
    class(heat_columns), intent(inout) :: columns
    class(film_contact), intent(in) :: film
    class(film_heat), intent(in) :: heat
    integer, intent(in) :: strip
    type(column_work), intent(inout) :: work
    real(wp), intent(inout) :: residual(size(film%gap), film%model%shear%nodes%levels%count)
    real(wp) :: lacked(most_columns, film%model%shear%nodes%levels%count)
    integer :: nodes(columns%before(strip + 1) - columns%before(strip)), k

    call columns%gather(film, strip, work, nodes)
    call strip_residuals(columns, film, heat%law, strip, work, lacked)
    do k = 1, size(residual, 2)
      residual(nodes, k) = lacked(:size(nodes), k)
    end do
  end subroutine level_residual

  !> Replaces the heat that the walls' levels lack by the walls' balance.
  subroutine wall_residual(film, heat, residual)
    class(film_contact), intent(in) :: film
    class(film_heat), intent(inout) :: heat
    real(wp), contiguous, intent(inout) :: residual(:, :, :)
    real(wp) :: flux(size(residual, 1), size(residual, 2)), rise(size(residual, 1), size(residual, 2))
    integer :: wall, level

    do wall = 1, 2
      level = merge(1, size(residual, 3), wall == 1)
      call wall_flux(film, residual(:, :, level), flux)
      call heat%walls%body(wall)%surface%rise(flux, rise)
      residual(:, :, level) = film%model%shear%nodes%rise(:, :, level) - heat%walls%body(wall)%bulk - rise
    end do
  end subroutine wall_residual

  !> Sets the residuals of the levels between the walls on the outline.
  subroutine outline_residual(film, heat, residual)
    class(film_contact), intent(in) :: film
    class(film_heat), intent(in) :: heat
    real(wp), contiguous, intent(inout) :: residual(:, :, :)
    integer :: k, nx

    nx = size(residual, 1)
    associate (rise => film%model%shear%nodes%rise)
      do k = 2, size(residual, 3) - 1
        associate (entering => entering_oil(film, heat, k), first => first_row(film), last => last_row(film))
          residual([1, nx], :, k) = rise([1, nx], :, k) - entering
          residual(:, :first - 1, k) = rise(:, :first - 1, k) - entering
          residual(:, last + 1:, k) = rise(:, last + 1:, k) - entering
        end associate
      end do
    end associate
  end subroutine outline_residual

end module pyworm_heat_residual
