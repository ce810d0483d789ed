!> Levels across a film: Gauss-Lobatto points with their weights of integration and differentiation.
!>
!> Position z runs over the film from -1/2 at body 1 to 1/2 at body 2; the first and last level are the walls. With n
!> levels integrals of polynomials up to degree 2n - 3 are exact (Canuto et al., Spectral Methods, 2006, sec. 2.3).
module pyworm_gauss_lobatto
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: levels_across, new_levels

  type :: levels_across
    integer :: count = 0
    !> Position, and weight of each level in an integral over the film; the weights add to 1.
    real(wp), allocatable :: z(:), weight(:)
    !> Integrals over the film of the products of two levels' polynomials' slopes: conduction in weak form.
    real(wp), allocatable :: stiffness(:, :)
    !> Integral of each level's polynomial (second index) from body 1 to a level (first index).
    real(wp), allocatable :: integral(:, :)
  end type levels_across

contains

  !> Makes `count` levels, at least 2.
  pure function new_levels(count) result(levels)
    integer, intent(in) :: count
    type(levels_across) :: levels
    real(wp) :: point(count), weight(count), slope(count, count)
    integer :: k, l, q

    call lobatto(count, point, weight)
    levels%count = count
    allocate (levels%z(count), levels%weight(count), levels%stiffness(count, count), levels%integral(count, count))
    levels%z(:) = point/2
    levels%weight(:) = weight/2
    do l = 1, count
      do k = 1, count
        slope(k, l) = 2*lagrange_slope(point, l, k)
      end do
    end do
    do l = 1, count
      do k = 1, count
        levels%stiffness(k, l) = sum(levels%weight*slope(:, k)*slope(:, l))
        levels%integral(k, l) = 0
        do q = 1, count
          levels%integral(k, l) = levels%integral(k, l) &
            + levels%weight(q)*(1 + point(k))/2*lagrange(point, l, -1 + (1 + point(k))*(1 + point(q))/2)
        end do
      end do
    end do
  end function new_levels

  !> Gauss-Lobatto points and weights on (-1, 1): the ends and the extrema of Legendre's polynomial of degree n - 1.
  pure subroutine lobatto(n, point, weight)
    integer, intent(in) :: n
    real(wp), intent(out) :: point(n), weight(n)
    real(wp), parameter :: pi = acos(-1.0_wp)
    !> Newton steps from Chebyshev's points; they converge quadratically.
    integer, parameter :: steps = 30
    real(wp) :: before(n), here(n), last(n)
    integer :: degree, k, step

    point = [(-cos(pi*(k - 1)/(n - 1)), k=1, n)]
    do step = 1, steps
      before = 1
      here = point
      do degree = 2, n - 1
        last = before
        before = here
        here = ((2*degree - 1)*point*before - (degree - 1)*last)/degree
      end do
      point = point - (point*here - before)/(n*here)
    end do
    weight = 2/((n - 1)*n*here**2)
  end subroutine lobatto

  !> Lagrange polynomial of point l at x.
  pure real(wp) function lagrange(point, l, x)
    real(wp), intent(in) :: point(:), x
    integer, intent(in) :: l
    integer :: m

    lagrange = 1
    do m = 1, size(point)
      if (m /= l) lagrange = lagrange*(x - point(m))/(point(l) - point(m))
    end do
  end function lagrange

  !> Slope of the Lagrange polynomial of point l at point k.
  pure real(wp) function lagrange_slope(point, l, k)
    real(wp), intent(in) :: point(:)
    integer, intent(in) :: l, k
    real(wp) :: product
    integer :: m, skipped

    lagrange_slope = 0
    do skipped = 1, size(point)
      if (skipped == l) cycle
      product = 1/(point(l) - point(skipped))
      do m = 1, size(point)
        if (m /= l .and. m /= skipped) product = product*(point(k) - point(m))/(point(l) - point(m))
      end do
      lagrange_slope = lagrange_slope + product
    end do
  end function lagrange_slope

end module pyworm_gauss_lobatto
