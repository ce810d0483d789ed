!> Tables of flow laws that are known as a curve: of a liquid of several branches (Yasuda 1979) or of a table of one's own.
!>
!> With y the Newtonian stress eta rate and G the stress at which thinning begins, a curve gives tau/G over y/G.
module pyworm_flow_table
  use pyworm_cubic_spline, only: monotone_slopes, spline_coefficients, spline_value
  use pyworm_kinds, only: wp
  use pyworm_thinning_table, only: thinning_table
  implicit none(type, external)
  private

  public :: flow_branch, branches_curve, table_curve, newtonian_ratios, tabulate_flow

  !> Cells of a table for each unit of ln(1 + s), and all: to s = 1e13.
  integer, parameter :: cells_per_log = 20, log_cells = 600
  !> Points of a curve, and ratios eta rate/G of the first and the last.
  integer, parameter, public :: curve_points = 8000
  real(wp), parameter :: first_ratio = 1e-6_wp, last_ratio = 1e16_wp

  !> A branch of a liquid: its part of the viscosity [-], the stress at which it thins over G [-], n and a of Yasuda [-].
  type :: flow_branch
    real(wp) :: fraction = 1, ratio = 1, exponent = 1, yasuda = 2
  end type flow_branch

contains

  !> Ratios eta rate/G at which curves are tabulated, in equal steps of their logarithm.
  pure function newtonian_ratios() result(ratios)
    real(wp) :: ratios(curve_points)
    integer :: i

    ratios = [(first_ratio*(last_ratio/first_ratio)**(real(i, wp)/(curve_points - 1)), i=0, curve_points - 1)]
  end function newtonian_ratios

  !> tau/G = y sum f [1 + (y/r)^a]^((n - 1)/a) over the branches, at y = eta rate/G.
  pure function branches_curve(branches, newtonian) result(stress)
    type(flow_branch), intent(in) :: branches(:)
    real(wp), intent(in) :: newtonian(:)
    real(wp) :: stress(size(newtonian))
    integer :: k

    stress = 0
    do k = 1, size(branches)
      associate (b => branches(k))
        stress = stress + b%fraction*(1 + (newtonian/b%ratio)**b%yasuda)**((b%exponent - 1)/b%yasuda)
      end associate
    end do
    stress = newtonian*stress
  end function branches_curve

  !> tau/G by a table of increasing pairs of eta rate/G and tau/G: monotone cubics of the logarithms. Before the table the oil is
  !> Newtonian, beyond it a power law.
  pure function table_curve(table, newtonian) result(stress)
    real(wp), intent(in) :: table(:, :), newtonian(:)
    real(wp) :: stress(size(newtonian))
    real(wp) :: x(size(table, 2)), y(size(table, 2)), slopes(size(table, 2)), place, inside
    integer :: i, n

    n = size(table, 2)
    x = log(table(1, :))
    y = log(table(2, :))
    slopes = monotone_slopes(x, y)
    do i = 1, size(newtonian)
      place = log(newtonian(i))
      inside = min(max(place, x(1)), x(n))
      stress(i) = exp(spline_value(x, y, slopes, inside) + merge(1.0_wp, slopes(n), place < x(1))*(place - inside))
    end do
  end function table_curve

  !> Tables of the thinning y/tau over (tau/G)^2 and over (y/G)^2, from a curve at increasing ratios `newtonian`.
  pure subroutine tabulate_flow(newtonian, stress, by_stress, by_rate)
    real(wp), intent(in) :: newtonian(:), stress(:)
    type(thinning_table), intent(out) :: by_stress, by_rate
    real(wp) :: thinning(size(newtonian))

    thinning = log(newtonian/stress)
    by_stress = thinning_table(real(cells_per_log, wp), factor_cells(stress, thinning))
    by_rate = thinning_table(real(cells_per_log, wp), factor_cells(newtonian, thinning))
  end subroutine tabulate_flow

  !> Coefficients (power, cell) of the cubic spline of a logarithm over ln(1 + ratio^2).
  pure function factor_cells(ratio, logarithm) result(coefficients)
    real(wp), intent(in) :: ratio(:), logarithm(:)
    real(wp) :: coefficients(4, log_cells)
    real(wp) :: values(0:log_cells), place
    real(wp), dimension(size(ratio) + 1) :: x, y, slopes
    integer :: i, n

    x(1) = 0
    y(1) = 0
    n = 1
    do i = 1, size(ratio)
      place = log_of_one_and(ratio(i)**2)
      if (.not. place > x(n)) cycle ! where stress has a limit ratios differ by less than rounding
      n = n + 1
      x(n) = place
      y(n) = logarithm(i)
    end do
    slopes(:n) = monotone_slopes(x(:n), y(:n))
    do i = 0, log_cells
      place = real(i, wp)/cells_per_log
      values(i) = spline_value(x(:n), y(:n), slopes(:n), min(place, x(n))) + max(place - x(n), 0.0_wp)*slopes(n)
    end do
    coefficients = spline_coefficients(values)
  end function factor_cells

  !> ln(1 + x) without loss at small x (Higham, Accuracy and Stability of Numerical Algorithms, 2002, section 1.14.1).
  elemental real(wp) function log_of_one_and(x)
    real(wp), intent(in) :: x
    real(wp) :: rounded

    rounded = 1 + x
    log_of_one_and = x
    if (rounded > 1) log_of_one_and = x*(log(rounded)/(rounded - 1))
  end function log_of_one_and

end module pyworm_flow_table
