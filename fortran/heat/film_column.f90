!> Energy equation across the film, implicit, for a strip of columns (Sharif et al. 2001, eq. 18).
!>
!> In weak form on Gauss-Lobatto levels, with w the weights and S the stiffness of `gauss_lobatto`, each level k
!> obeys
!>   h w_k (absorption_k T_k - source_k) + (conductivity/h) sum_l S_kl T_l + flux into its wall, if it is one = 0.
!> The columns of S add to zero, so that dissipation = convected heat + flux into both walls, to rounding.
!>
!> The source depends on the temperature of the whole column: warmer oil is heated more or less, and lowers the
!> stress everywhere. Its derivative d source_k / d T_l has the form
!>   growth_k delta_kl - sum_s loading_ks relief_ls,
!> s being the two components of the shear stress.
module pyworm_film_column
  use pyworm_gauss_lobatto, only: levels_across
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_bad_argument, status_no_memory
  implicit none(type, external)
  private

  public :: film_strip, new_film_strip, level_residuals, solve_columns, solve_column, warm_walls

  !> Columns solved together: their matrices stay in the first cache, and loops over them are long enough for gfortran to
  !> vectorise as they are; those of 16 it unrolls and shuffles.
  integer, parameter :: lanes = 32
  !> Limits of the linearised growth of heat with temperature, in conductivity/h2, whatever oil convects: where it convects
  !> all heat, a column must not be warmer than its upstream columns by more than their excess. Conduction between the
  !> walls removes pi2 in the first mode across the film (8 for a parabola) and 4 pi2 in the second. The stress falls
  !> where the film warms as a whole: hence a limit on the second mode, and a tighter one on the remainder of the first.
  !> Newton's method diverges with a linearisation that grows faster; the limits affect the rate of convergence, not the
  !> solution.
  real(wp), parameter :: most_growth = 5.0_wp, most_growth_of_all = 1.5_wp
  !> Least pivots of a linearisation, over those of conduction.
  real(wp), parameter :: least_fraction = 0.1_wp

  !> Scratch of the columns solved together, lanes first.
  type :: lane_block
    real(wp) :: thickness(lanes), conductance(lanes)
    real(wp), allocatable :: known(:, :), source(:, :), absorption(:, :), growth(:, :), loading(:, :, :), relief(:, :, :)
    !> Derivative of the levels' balances with respect to temperature, and in the last column their excess of heat.
    real(wp), allocatable :: balances(:, :, :)
    !> Derivative of the inner levels in the elimination, and its pivots.
    real(wp), allocatable :: a(:, :, :), pivot(:, :)
    !> Change of the inner levels' temperature, and its derivatives with respect to the walls, (lanes, n, 3).
    real(wp), allocatable :: change(:, :, :)
  end type lane_block

  !> A strip of m columns of n levels, of which the first `columns` are in use. The caller fills the first part,
  !> `solve_columns` the second.
  type :: film_strip
    integer :: columns = 0
    type(levels_across) :: levels
    !> Least pivots of the inner levels, in conductivity/h.
    real(wp), allocatable :: least_pivot(:)
    !> Film thickness [m] and conductivity of the oil [W/(m K)], (m).
    real(wp), allocatable :: thickness(:), conductivity(:)
    !> Temperature of the two walls [K], (m, 2).
    real(wp), allocatable :: wall(:, :)
    !> rho c times the rate at which oil leaves a level's cell [W/(m3 K)], not negative, (m, n).
    real(wp), allocatable :: absorption(:, :)
    !> Dissipation and convected inflow of heat [W/m3] at the temperature `known` [K], (m, n).
    real(wp), allocatable :: source(:, :), known(:, :)
    !> Derivative of the source: heat with temperature [W/(m3 K)], (m, n); heat with shear stress [W/(m3 Pa)]
    !> and loss of shear stress with a level's temperature [Pa/K], (m, n, 2).
    real(wp), allocatable :: growth(:, :), loading(:, :, :), relief(:, :, :)

    !> Temperature [K], (m, n), and heat flux into the two bodies [W/m2], (m, 2).
    real(wp), allocatable :: temperature(:, :), flux(:, :)
    !> Derivatives with respect to the temperature of wall j: of flux i [W/(m2 K)], (m, 2, 2), and of the
    !> levels' temperature [-], (m, n, 2).
    real(wp), allocatable :: admittance(:, :, :), response(:, :, :)
    !> Scratch: excess of the walls over `known` [K], (m, 2).
    real(wp), allocatable :: wall_rise(:, :)
    type(lane_block) :: work
  end type film_strip

contains

  !> Allocates a strip of columns.
  subroutine new_film_strip(strip, columns, levels, stat)
    type(film_strip), intent(out) :: strip
    integer, intent(in) :: columns
    type(levels_across), intent(in) :: levels
    integer, intent(out) :: stat
    integer :: m, n, err

    m = columns
    n = levels%count
    stat = status_bad_argument
    if (m < 1 .or. n < 3) return
    strip%columns = m
    strip%levels = levels
    strip%least_pivot = least_fraction*conduction_pivots(levels)
    allocate (strip%thickness(m), strip%conductivity(m), strip%wall(m, 2), strip%absorption(m, n), strip%source(m, n), &
      strip%known(m, n), strip%growth(m, n), strip%loading(m, n, 2), strip%relief(m, n, 2), strip%temperature(m, n), &
      strip%flux(m, 2), strip%admittance(m, 2, 2), strip%response(m, n, 2), &
      strip%wall_rise(m, 2), stat=err)
    if (err == 0) allocate (strip%work%known(lanes, n), strip%work%source(lanes, n), strip%work%absorption(lanes, n), &
      strip%work%growth(lanes, n), strip%work%loading(lanes, n, 2), strip%work%relief(lanes, n, 2), &
      strip%work%balances(lanes, n, n + 1), strip%work%a(lanes, n, n), strip%work%pivot(lanes, n), &
      strip%work%change(lanes, n, 3), stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
  end subroutine new_film_strip

  !> Heat that the levels lack at the temperature `known` [W/m2]: the left side of their equations, without flux into the walls.
  pure subroutine level_residuals(strip, residual)
    type(film_strip), intent(in) :: strip
    real(wp), contiguous, intent(out) :: residual(:, :)
    integer :: c, k, l

    associate (levels => strip%levels, known => strip%known)
      do k = 1, levels%count
        do c = 1, strip%columns
          residual(c, k) = strip%thickness(c)*levels%weight(k)*(strip%absorption(c, k)*known(c, k) - strip%source(c, k))
        end do
        do l = 1, levels%count
          do c = 1, strip%columns
            residual(c, k) = residual(c, k) + strip%conductivity(c)/strip%thickness(c)*levels%stiffness(k, l)*known(c, l)
          end do
        end do
      end do
    end associate
  end subroutine level_residuals

  !> Solves for temperature, fluxes and their derivatives with respect to the walls.
  pure subroutine solve_columns(strip)
    type(film_strip), intent(inout) :: strip
    integer :: first

    do first = 1, strip%columns, lanes
      call solve_together(strip, first, min(lanes, strip%columns - first + 1))
    end do
    strip%wall_rise(:strip%columns, 1) = strip%wall(:strip%columns, 1) - strip%known(:strip%columns, 1)
    strip%wall_rise(:strip%columns, 2) = strip%wall(:strip%columns, 2) - strip%known(:strip%columns, strip%levels%count)
    call warm_walls(strip, strip%wall_rise)
  end subroutine solve_columns

  !> Solves one column with its walls as in `known`.
  pure subroutine solve_column(strip, column)
    type(film_strip), intent(inout) :: strip
    integer, intent(in) :: column

    call solve_together(strip, column, 1)
  end subroutine solve_column

  !> Solves `count` columns from `first` on with their walls as in `known`.
  !>
  !> All lanes are computed, so that loops have a fixed length; surplus lanes repeat the last column.
  pure subroutine solve_together(strip, first, count)
    type(film_strip), intent(inout) :: strip
    integer, intent(in) :: first, count
    integer :: k, s, n

    n = strip%levels%count
    associate (work => strip%work)
      call take(first, count, strip%thickness, work%thickness)
      call take(first, count, strip%conductivity, work%conductance)
      work%conductance = work%conductance/work%thickness
      do k = 1, n
        call take(first, count, strip%known(:, k), work%known(:, k))
        call take(first, count, strip%source(:, k), work%source(:, k))
        call take(first, count, strip%absorption(:, k), work%absorption(:, k))
        call take(first, count, strip%growth(:, k), work%growth(:, k))
        do s = 1, 2
          call take(first, count, strip%loading(:, k, s), work%loading(:, k, s))
          call take(first, count, strip%relief(:, k, s), work%relief(:, k, s))
        end do
      end do
      call set_balances(strip%levels, work%thickness, work%conductance, work%known, work%source, work%absorption, &
        work%growth, work%loading, work%relief, work%balances)
      call solve_inner_levels(n, strip%least_pivot, work%conductance, work%balances, work%a, work%pivot, work%change)
    end associate
    call set_walls(strip, first, count)
  end subroutine solve_together

  !> Gathers `count` columns' values from `first` on, one for each lane.
  pure subroutine take(first, count, values, lane)
    integer, intent(in) :: first, count
    real(wp), contiguous, intent(in) :: values(:)
    real(wp), intent(out) :: lane(lanes)

    if (count == lanes) then
      lane = values(first:first + lanes - 1)
    else
      lane(:count) = values(first:first + count - 1)
      lane(count + 1:) = values(first + count - 1)
    end if
  end subroutine take

  !> Pivots of the inner levels in the elimination of conduction alone, in conductivity/h.
  pure function conduction_pivots(levels) result(pivot)
    type(levels_across), intent(in) :: levels
    real(wp) :: pivot(levels%count)
    real(wp) :: s(levels%count, levels%count)
    integer :: k, l

    s = levels%stiffness
    do k = 2, levels%count - 1
      pivot(k) = s(k, k)
      do l = k + 1, levels%count - 1
        s(l, k + 1:) = s(l, k + 1:) - s(l, k)/s(k, k)*s(k, k + 1:)
      end do
    end do
    pivot([1, levels%count]) = 0
  end function conduction_pivots

  !> Computes the derivatives of all levels' balances and their excess at the temperature `known`.
  pure subroutine set_balances(levels, thickness, conductance, known, source, absorption, growth, loading, relief, balances)
    type(levels_across), intent(in) :: levels
    real(wp), intent(in) :: thickness(lanes), conductance(lanes)
    real(wp), dimension(lanes, levels%count), intent(in) :: known, source, absorption, growth
    real(wp), intent(in) :: loading(lanes, levels%count, 2), relief(lanes, levels%count, 2)
    real(wp), intent(out) :: balances(lanes, levels%count, levels%count + 1)
    real(wp), dimension(lanes) :: volume, bound, relief_x, relief_y, excess
    integer :: k, l

    relief_x = 0
    relief_y = 0
    do k = 1, levels%count
      relief_x = relief_x + relief(:, k, 1)
      relief_y = relief_y + relief(:, k, 2)
    end do
    bound = conductance/thickness
    do k = 1, levels%count
      volume = thickness*levels%weight(k)
      excess = volume*(source(:, k) - absorption(:, k)*known(:, k))
      do l = 1, levels%count
        excess = excess - conductance*levels%stiffness(k, l)*known(:, l)
        balances(:, k, l) = conductance*levels%stiffness(k, l) &
          + volume*(loading(:, k, 1)*relief(:, l, 1) + loading(:, k, 2)*relief(:, l, 2))
      end do
      balances(:, k, levels%count + 1) = excess
      ! growth beyond what conduction removes would make Newton's method diverge (`most_growth`)
      balances(:, k, k) = balances(:, k, k) - volume*(min(growth(:, k), most_growth*bound, loading(:, k, 1)*relief_x &
        + loading(:, k, 2)*relief_y + most_growth_of_all*bound) - absorption(:, k))
    end do
  end subroutine set_balances

  !> Solves for the change of the inner levels' temperature, and its derivatives with respect to the
  !> walls.
  !>
  !> Elimination is without pivoting, since conduction is positive definite; heating does not lower a pivot
  !> below `least_fraction` of conduction's.
  pure subroutine solve_inner_levels(n, least_pivot, conductance, balances, a, pivot, change)
    integer, intent(in) :: n
    real(wp), intent(in) :: least_pivot(n), conductance(lanes), balances(lanes, n, n + 1)
    real(wp), intent(inout) :: a(lanes, n, n), pivot(lanes, n)
    real(wp), intent(out) :: change(lanes, n, 3)
    real(wp) :: factor(lanes)
    integer :: k, l, r

    do l = 2, n - 1
      a(:, 2:n - 1, l) = balances(:, 2:n - 1, l)
      change(:, l, 1) = balances(:, l, n + 1)
      change(:, l, 2) = -balances(:, l, 1)
      change(:, l, 3) = -balances(:, l, n)
    end do
    do k = 2, n - 1
      pivot(:, k) = 1/max(a(:, k, k), least_pivot(k)*conductance)
      do r = k + 1, n - 1
        factor = a(:, r, k)*pivot(:, k)
        do l = k + 1, n - 1
          a(:, r, l) = a(:, r, l) - factor*a(:, k, l)
        end do
        change(:, r, 1) = change(:, r, 1) - factor*change(:, k, 1)
        change(:, r, 2) = change(:, r, 2) - factor*change(:, k, 2)
        change(:, r, 3) = change(:, r, 3) - factor*change(:, k, 3)
      end do
    end do
    do k = n - 1, 2, -1
      do l = k + 1, n - 1
        change(:, k, 1) = change(:, k, 1) - a(:, k, l)*change(:, l, 1)
        change(:, k, 2) = change(:, k, 2) - a(:, k, l)*change(:, l, 2)
        change(:, k, 3) = change(:, k, 3) - a(:, k, l)*change(:, l, 3)
      end do
      change(:, k, 1) = change(:, k, 1)*pivot(:, k)
      change(:, k, 2) = change(:, k, 2)*pivot(:, k)
      change(:, k, 3) = change(:, k, 3)*pivot(:, k)
    end do
    change(:, 1, :) = 0
    change(:, n, :) = 0
    change(:, 1, 2) = 1
    change(:, n, 3) = 1
  end subroutine solve_inner_levels

  !> Sets the solution with walls as in `known`, its derivatives, and the flux into the bodies by the balances at
  !> the walls.
  pure subroutine set_walls(strip, first, count)
    type(film_strip), intent(inout) :: strip
    integer, intent(in) :: first, count
    real(wp) :: left(lanes)
    integer :: wall, level, l, side, last

    last = first + count - 1
    associate (balances => strip%work%balances, change => strip%work%change)
      strip%temperature(first:last, :) = strip%known(first:last, :) + change(:count, :, 1)
      strip%response(first:last, :, :) = change(:count, :, 2:3)
      do wall = 1, 2
        level = merge(1, strip%levels%count, wall == 1)
        do side = 1, 3
          left = 0
          if (side == 1) left = balances(:, level, strip%levels%count + 1)
          do l = 1, strip%levels%count
            left = left - balances(:, level, l)*change(:, l, side)
          end do
          if (side == 1) then
            strip%flux(first:last, wall) = left(:count)
          else
            strip%admittance(first:last, wall, side - 1) = left(:count)
          end if
        end do
      end do
    end associate
  end subroutine set_walls

  !> Temperature and fluxes when the walls are `rise` [K], (columns, 2), warmer.
  pure subroutine warm_walls(strip, rise)
    type(film_strip), intent(inout) :: strip
    real(wp), intent(in) :: rise(:, :)
    integer :: wall, k, c

    do wall = 1, 2
      do k = 1, strip%levels%count
        do c = 1, strip%columns
          strip%temperature(c, k) = strip%temperature(c, k) + strip%response(c, k, wall)*rise(c, wall)
        end do
      end do
      do k = 1, 2
        do c = 1, strip%columns
          strip%flux(c, k) = strip%flux(c, k) + strip%admittance(c, k, wall)*rise(c, wall)
        end do
      end do
    end do
  end subroutine warm_walls

end module pyworm_film_column
