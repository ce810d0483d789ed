!> A property of an oil by a table over pressure and temperature: cubic in each cell, with its derivatives.
!>
!> The caller gives the coefficients of a bicubic spline, by which the property and its slopes are continuous. Beyond the
!> last pressure it continues linearly, beyond the last temperatures it stays.
module pyworm_property_table
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: property_table, tabulated, tabulated_cold, tabulate_row

  type :: property_table
    !> Cells for each pascal and each kelvin, and the least temperature above the reference [K].
    real(wp) :: per_pressure = 1, per_rise = 1, first_rise = 0
    !> Coefficients of powers of pressure and of temperature within a cell: (power of p, power of T, cell of p, cell of T).
    real(wp), allocatable :: coefficient(:, :, :, :)
    !> Those at the reference temperature: (power of p, cell of p).
    real(wp), allocatable :: cold(:, :)
  end type property_table

contains

  !> Property `f` at pressure `p` [Pa] and the reference temperature, and its derivative [1/Pa].
  elemental subroutine tabulated_cold(table, p, f, by_pressure)
    type(property_table), intent(in) :: table
    real(wp), intent(in) :: p
    real(wp), intent(out) :: f, by_pressure
    real(wp) :: s, t, slope
    integer :: i

    s = p*table%per_pressure
    i = min(int(max(s, 0.0_wp)), size(table%cold, 2) - 1)
    t = min(max(s - i, 0.0_wp), 1.0_wp)
    associate (c => table%cold(:, i + 1))
      slope = c(2) + t*(2*c(3) + t*3*c(4))
      f = c(1) + t*(c(2) + t*(c(3) + t*c(4))) + slope*(s - i - t)
    end associate
    by_pressure = slope*table%per_pressure
  end subroutine tabulated_cold

  !> Property `f` at pressure `p` [Pa] and `rise` [K] above the reference temperature, with its derivatives [1/Pa] and [1/K].
  elemental subroutine tabulated(table, p, rise, f, by_pressure, by_rise)
    type(property_table), intent(in) :: table
    real(wp), intent(in) :: p, rise
    real(wp), intent(out) :: f, by_pressure, by_rise
    real(wp) :: s, t, v, u, q(4), r(4), slope
    integer :: i, k

    s = p*table%per_pressure
    i = min(int(max(s, 0.0_wp)), size(table%coefficient, 3) - 1)
    t = min(max(s - i, 0.0_wp), 1.0_wp)
    v = (rise - table%first_rise)*table%per_rise
    k = min(int(max(v, 0.0_wp)), size(table%coefficient, 4) - 1)
    u = min(max(v - k, 0.0_wp), 1.0_wp)
    associate (c => table%coefficient(:, :, i + 1, k + 1))
      q = c(:, 1) + u*(c(:, 2) + u*(c(:, 3) + u*c(:, 4)))
      r = c(:, 2) + u*(2*c(:, 3) + u*3*c(:, 4))
    end associate
    slope = q(2) + t*(2*q(3) + t*3*q(4))
    f = q(1) + t*(q(2) + t*(q(3) + t*q(4))) + slope*(s - i - t)
    by_pressure = slope*table%per_pressure
    by_rise = 0
    if (abs(v - k - u) <= 0) by_rise = (r(1) + t*(r(2) + t*(r(3) + t*r(4))))*table%per_rise
  end subroutine tabulated

  !> The same over a row of points; inlined here, its cells are read as vectors.
  pure subroutine tabulate_row(table, count, p, rise, f, by_pressure, by_rise)
    type(property_table), intent(in) :: table
    integer, intent(in) :: count
    real(wp), intent(in) :: p(count), rise(count)
    real(wp), intent(out) :: f(count), by_pressure(count), by_rise(count)
    integer :: m

    do m = 1, count
      call tabulated(table, p(m), rise(m), f(m), by_pressure(m), by_rise(m))
    end do
  end subroutine tabulate_row

end module pyworm_property_table
