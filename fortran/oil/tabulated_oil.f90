!> Tables of an oil's viscosity and density from values at some pressures and temperatures.
!>
!> The logarithm of the viscosity, and the density, are bicubic splines through the values; the kernel's table has equal
!> cells, in which it is the spline through that one's values (`pyworm/materials/tabulated.py`, which has the same tables).
module pyworm_tabulated_oil
  use pyworm_cubic_spline, only: spline_coefficients, spline_slopes, spline_value
  use pyworm_kinds, only: wp
  use pyworm_property_table, only: property_table
  implicit none(type, external)
  private

  public :: tabulated_property, equal_cells, fits_table

  !> Cells along pressure and temperature.
  integer, parameter, public :: pressure_cells = 192, warmth_cells = 32
  !> Fewest pressures, and the largest that counts as ambient [Pa].
  integer, parameter :: fewest_pressures = 4
  real(wp), parameter :: largest_ambient = 1e6_wp

contains

  !> Points of `cells` equal cells.
  pure function equal_cells(first, last, cells) result(points)
    real(wp), intent(in) :: first, last
    integer, intent(in) :: cells
    real(wp) :: points(cells + 1)
    integer :: i

    points = [(first + (last - first)/cells*i, i=0, cells)]
  end function equal_cells

  !> Whether values at some pressures [Pa] and temperatures [K] make a table whose temperatures hold the reference.
  pure logical function fits_table(pressures, temperatures, values, reference)
    real(wp), intent(in) :: pressures(:), temperatures(:), values(:, :), reference
    integer :: n, m

    n = size(pressures)
    m = size(temperatures)
    fits_table = .false.
    if (n < fewest_pressures .or. m < 1) return
    if (any(shape(values) /= [n, m])) return
    if (.not. (all(pressures(2:) > pressures(:n - 1)) .and. all(temperatures(2:) > temperatures(:m - 1)))) return
    if (.not. (pressures(1) >= 0 .and. pressures(1) <= largest_ambient)) return
    if (.not. (all(values > 0) .and. all(values <= huge(1.0_wp)))) return
    fits_table = m == 1 .or. (reference >= temperatures(1) .and. reference <= temperatures(m))
  end function fits_table

  !> Table of what is `written` (pressure, temperature), as the spline goes on from `reference` [K]: less its value there at
  !> ambient pressure, `ambient`, or over it if it is a `ratio`; `growth` [1/Pa] is its derivative by pressure there.
  pure subroutine tabulated_property(pressures, temperatures, written, reference, ratio, table, ambient, growth)
    real(wp), intent(in) :: pressures(:), temperatures(:), written(:, :), reference
    logical, intent(in) :: ratio
    type(property_table), intent(out) :: table
    real(wp), intent(out) :: ambient, growth
    real(wp) :: along_pressure(pressure_cells + 1, size(temperatures)), slopes(size(pressures)), step
    real(wp) :: there(size(temperatures)), rising(size(temperatures))
    real(wp), allocatable :: warmths(:), values(:, :)
    integer :: j, k

    step = (pressures(size(pressures)) - pressures(1))/pressure_cells
    do j = 1, size(temperatures)
      slopes = spline_slopes(pressures - pressures(1), written(:, j))
      there(j) = written(1, j)
      rising(j) = slopes(1)
      do k = 0, pressure_cells
        along_pressure(k + 1, j) = spline_value(pressures - pressures(1), written(:, j), slopes, step*k)
      end do
    end do
    ambient = along_temperature(temperatures, there, reference)
    growth = along_temperature(temperatures, rising, reference)
    if (size(temperatures) == 1) then
      warmths = [reference, reference + 1]
      values = along_pressure
    else
      warmths = equal_cells(temperatures(1), temperatures(size(temperatures)), warmth_cells)
      allocate (values(pressure_cells + 1, size(warmths)))
      do k = 1, size(values, 1)
        do j = 1, size(warmths)
          values(k, j) = along_temperature(temperatures, along_pressure(k, :), warmths(j))
        end do
      end do
    end if
    if (ratio) then
      values = values/ambient
    else
      values = values - ambient
    end if
    call set_cells(1/step, warmths, reference, values, table)
  end subroutine tabulated_property

  !> Value at a temperature of the spline along temperature; that of a single temperature at every one.
  pure real(wp) function along_temperature(temperatures, values, place)
    real(wp), intent(in) :: temperatures(:), values(:), place

    if (size(temperatures) == 1) then
      along_temperature = values(1)
    else
      along_temperature = spline_value(temperatures, values, spline_slopes(temperatures, values), place)
    end if
  end function along_temperature

  !> Coefficients of a table from its values at the corners of equal cells; those of one temperature do not depend on it.
  pure subroutine set_cells(per_pressure, warmths, reference, values, table)
    real(wp), intent(in) :: per_pressure, warmths(:), reference, values(:, :)
    type(property_table), intent(out) :: table
    real(wp) :: along_pressure(4, pressure_cells, size(values, 2)), place
    integer :: i, j, k, cell

    table%per_pressure = per_pressure
    table%per_rise = 1/(warmths(2) - warmths(1))
    table%first_rise = warmths(1) - reference
    do j = 1, size(values, 2)
      along_pressure(:, :, j) = spline_coefficients(values(:, j))
    end do
    allocate (table%coefficient(4, 4, pressure_cells, size(warmths) - 1), table%cold(4, pressure_cells), source=0.0_wp)
    place = -table%first_rise*table%per_rise
    cell = min(int(place), size(warmths) - 2)
    place = place - cell
    do k = 1, pressure_cells
      do i = 1, 4
        if (size(values, 2) == 1) then
          table%coefficient(i, 1, k, 1) = along_pressure(i, k, 1)
        else
          table%coefficient(i, :, k, :) = spline_coefficients(along_pressure(i, k, :))
        end if
        associate (c => table%coefficient(i, :, k, cell + 1))
          table%cold(i, k) = c(1) + place*(c(2) + place*(c(3) + place*c(4)))
        end associate
      end do
    end do
  end subroutine set_cells

end module pyworm_tabulated_oil
