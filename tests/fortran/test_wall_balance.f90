module local_surface
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  !> A body whose surface warms where it is heated, by `own` times the flux.
  type, extends(heated_body), public :: local_body
  contains
    procedure :: rise
    procedure :: rise_transposed
  end type local_body

contains

  subroutine rise(self, q, temperature_rise)
    class(local_body), intent(inout) :: self
    real(wp), intent(in) :: q(self%nx, self%ny)
    real(wp), intent(out) :: temperature_rise(self%nx, self%ny)

    temperature_rise = self%own*q
  end subroutine rise

  subroutine rise_transposed(self, weight, by_flux)
    class(local_body), intent(inout) :: self
    real(wp), intent(in) :: weight(self%nx, self%ny)
    real(wp), intent(out) :: by_flux(self%nx, self%ny)

    by_flux = self%own*weight
  end subroutine rise_transposed

end module local_surface
!> Balance of walls and bodies: partition of heat in closed form, symmetries, a direct solution, and
!> iterations counted.
program test_wall_balance
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  use local_surface, only: local_body
  use pyworm_moving_source, only: moving_body, new_moving_body
  use pyworm_status, only: status_ok, status_bad_argument
  use tap, only: check, close_to, done
  use pyworm_wall_balance, only: wall_pair, new_wall_pair, balance_walls
  implicit none(type, external)

  integer :: stat

  call partition(1e-6_wp, 3e-6_wp)
  call partition(1e-6_wp, 1e3_wp)
  call equal_bodies()
  call opposite_motions()
  call against_elimination()
  call worm_contact(1e-2_wp, 5)
  call worm_contact(1e-5_wp, 12)
  call refusals()
  call done()

contains

  !> Balances the walls again and again until nothing is missed; `missed` [K] is what was at first.
  subroutine settle(pair, missed)
    type(wall_pair), intent(inout) :: pair
    real(wp), intent(out) :: missed
    real(wp) :: again, reduction
    integer :: iterations, round

    call balance_walls(pair, 1e-5_wp, missed, iterations, reduction)
    do round = 1, 3
      call balance_walls(pair, 1e-5_wp, again, iterations, reduction)
    end do
  end subroutine settle

  !> Bodies that take up heat where it comes: q1 = Q (1/2 + kappa R2)/(1 + kappa (R1 + R2)), with kappa the
  !> film's conductance; an insulating body leaves all heat to the other one.
  subroutine partition(resistance_1, resistance_2)
    real(wp), intent(in) :: resistance_1, resistance_2
    real(wp), parameter :: heat = 3e7_wp, conductance = 1.6e5_wp
    class(heated_body), allocatable :: first, second
    type(wall_pair) :: pair
    real(wp) :: missed, q

    allocate (first, source=local_body(4, 3, resistance_1))
    allocate (second, source=local_body(4, 3, resistance_2))
    call new_wall_pair(pair, first, 350.0_wp, second, 350.0_wp, 10, stat)
    call check(stat == status_ok, "a pair of walls is made")
    call set_film(pair, spread(spread(heat, 1, 4), 2, 3), spread(spread(conductance, 1, 4), 2, 3))
    call settle(pair, missed)
    q = heat*(0.5_wp + conductance*resistance_2)/(1 + conductance*(resistance_1 + resistance_2))
    call close_to(maxval(abs(pair%flux(:, :, 1) - q)), 0.0_wp, 1e-9_wp*heat, "heat shares between the bodies")
    call close_to(maxval(abs(sum(pair%flux, dim=3) - heat)), 0.0_wp, 1e-9_wp*heat, "and none is lost")
    call close_to(maxval(abs(pair%wall(:, :, 1) - 350 - resistance_1*q)), 0.0_wp, 1e-9_wp*resistance_1*q, "nor wall missed")
    call close_to(missed, heat/2*max(resistance_1, resistance_2), 1e-9_wp*missed, "what the walls missed before")
  end subroutine partition

  !> Two bodies that move alike share the heat equally whatever passes between them.
  subroutine equal_bodies()
    integer, parameter :: n = 15
    type(wall_pair) :: pair
    real(wp) :: missed

    call moving_pair(pair, n, [1.3_wp, 1.3_wp], [-0.4_wp, -0.4_wp])
    call set_film(pair, hertz(n, n), 0.16e6_wp*(1 + hertz(n, n)/1e8_wp))
    call settle(pair, missed)
    call close_to(maxval(abs(pair%flux(:, :, 1) - hertz(n, n)/2)), 0.0_wp, 1.0_wp, "equal bodies take half each")
  end subroutine equal_bodies

  !> Two like bodies that move in opposite directions are mirror images.
  subroutine opposite_motions()
    integer, parameter :: n = 15
    type(wall_pair) :: pair
    real(wp) :: missed

    call moving_pair(pair, n, [1.3_wp, -1.3_wp], [0.0_wp, 0.0_wp])
    call set_film(pair, hertz(n, n), 0.16e6_wp*(1 + hertz(n, n)/1e8_wp))
    call settle(pair, missed)
    call close_to(maxval(abs(pair%wall(:, :, 1) - pair%wall(n:1:-1, :, 2))), 0.0_wp, 1e-6_wp*missed, "mirror images")
    call check(pair%wall(n - 2, n/2, 1) > pair%wall(3, n/2, 1) + 0.1_wp*missed, "which differ")
  end subroutine opposite_motions

  !> Admittances of every kind, solved directly.
  subroutine against_elimination()
    integer, parameter :: n = 7, unknowns = 2*n*n
    type(wall_pair) :: pair
    real(wp) :: a(unknowns, unknowns), b(unknowns), q(n, n), risen(n, n), missed, before(n, n, 2)
    integer :: i, j, wall, other, node

    call moving_pair(pair, n, [3.0_wp, 0.1_wp], [0.0_wp, -0.2_wp])
    call set_film(pair, hertz(n, n), 0.16e6_wp*(1 + hertz(n, n)/1e8_wp))
    pair%admittance(:, :, 1, 1) = 1.3_wp*pair%admittance(:, :, 1, 1)
    pair%admittance(:, :, 2, 1) = 0.8_wp*pair%admittance(:, :, 2, 1)
    pair%wall(:, :, 2) = 340 + hertz(n, n)/1e7_wp
    before = pair%wall

    ! columns: what the walls miss when one node of one wall is a kelvin warmer
    do wall = 1, 2
      do other = 1, 2
        do j = 1, n
          do i = 1, n
            q = 0
            q(i, j) = pair%admittance(i, j, wall, other)
            call pair%body(wall)%surface%rise(q, risen)
            node = i + n*(j - 1) + n*n*(other - 1)
            a(n*n*(wall - 1) + 1:n*n*wall, node) = -reshape(risen, [n*n])
          end do
        end do
      end do
      call pair%body(wall)%surface%rise(pair%flux(:, :, wall), risen)
      b(n*n*(wall - 1) + 1:n*n*wall) = reshape(risen + pair%body(wall)%bulk - pair%wall(:, :, wall), [n*n])
    end do
    do i = 1, unknowns
      a(i, i) = a(i, i) + 1
    end do
    call eliminate(a, b)

    call settle(pair, missed)
    call close_to(maxval(abs(reshape(pair%wall - before, [unknowns]) - b)), 0.0_wp, 1e-6_wp*maxval(abs(b)), &
      "the walls are those of a direct solution")
  end subroutine against_elimination

  !> Gauss's elimination of a diagonally dominant enough system, in place.
  subroutine eliminate(a, b)
    real(wp), intent(inout) :: a(:, :), b(:)
    integer :: i, k

    do k = 1, size(b)
      do i = k + 1, size(b)
        b(i) = b(i) - a(i, k)/a(k, k)*b(k)
        a(i, k:) = a(i, k:) - a(i, k)/a(k, k)*a(k, k:)
      end do
    end do
    do k = size(b), 1, -1
      b(k) = (b(k) - dot_product(a(k, k + 1:), b(k + 1:)))/a(k, k)
    end do
  end subroutine eliminate

  !> Steel worm at 3 m/s along the long axis of a contact of 23 mm by 2.3 mm, bronze wheel at 0.12 m/s across
  !> it, 1 um of oil: few iterations, though the film conducts several times better than the bodies.
  subroutine worm_contact(tolerance, most)
    real(wp), intent(in) :: tolerance
    integer, intent(in) :: most
    integer, parameter :: n = 65
    type(wall_pair) :: pair
    real(wp) :: missed, reduction, before
    integer :: iterations

    call moving_pair(pair, n, [3.0_wp, 0.0_wp], [0.0_wp, 0.12_wp])
    call set_film(pair, hertz(n, n), 0.16_wp/(1e-6_wp + gap(n)))
    call balance_walls(pair, tolerance, before, iterations, reduction)
    call check(iterations <= most .and. reduction <= tolerance, "few iterations suffice")
    call balance_walls(pair, tolerance, missed, iterations, reduction)
    call check(missed < 10*tolerance*before, "the walls are in balance then")
  end subroutine worm_contact

  !> Steel and bronze under a window twice the contact of 23 mm by 2.3 mm.
  subroutine moving_pair(pair, n, u, v)
    type(wall_pair), intent(inout) :: pair
    integer, intent(in) :: n
    real(wp), intent(in) :: u(2), v(2)
    class(heated_body), allocatable :: first, second

    call make(first, n, u(1), v(1))
    call make(second, n, u(2), v(2))
    call new_wall_pair(pair, first, 350.0_wp, second, 350.0_wp, 60, stat)
  end subroutine moving_pair

  subroutine make(body, n, u, v)
    class(heated_body), allocatable, intent(out) :: body
    integer, intent(in) :: n
    real(wp), intent(in) :: u, v
    type(moving_body), allocatable :: moving

    allocate (moving)
    call new_moving_body(moving, n, n, 4*23e-3_wp/(n - 1), 4*2.3e-3_wp/(n - 1), u, v, 47.0_wp, 7900*477.0_wp, stat)
    call move_alloc(moving, body)
  end subroutine make

  !> Heat in Hertz's shape, 1e8 W/m2 at most, over half the window.
  function hertz(nx, ny) result(heat)
    integer, intent(in) :: nx, ny
    real(wp) :: heat(nx, ny)
    integer :: i, j

    do j = 1, ny
      do i = 1, nx
        heat(i, j) = 1e8_wp*sqrt(max(0.0_wp, 1 - (4*(i - 1.0_wp)/(nx - 1) - 2)**2 - (4*(j - 1.0_wp)/(ny - 1) - 2)**2))
      end do
    end do
  end function hertz

  !> Gap [m] outside the contact.
  function gap(n)
    integer, intent(in) :: n
    real(wp) :: gap(n, n)
    integer :: i, j

    do j = 1, n
      do i = 1, n
        gap(i, j) = 23e-6_wp*sqrt(max(0.0_wp, (4*(i - 1.0_wp)/(n - 1) - 2)**2 + (4*(j - 1.0_wp)/(n - 1) - 2)**2 - 1)**3)
      end do
    end do
  end function gap

  !> A film between walls at one temperature that dissipates `heat` [W/m2] and conducts.
  subroutine set_film(pair, heat, conductance)
    type(wall_pair), intent(inout) :: pair
    real(wp), intent(in) :: heat(:, :), conductance(:, :)
    integer :: wall, other

    do wall = 1, 2
      pair%wall(:, :, wall) = 350
      pair%flux(:, :, wall) = heat/2
      do other = 1, 2
        pair%admittance(:, :, wall, other) = merge(-1, 1, wall == other)*conductance
      end do
    end do
  end subroutine set_film

  subroutine refusals()
    class(heated_body), allocatable :: first, second
    type(wall_pair) :: pair

    call new_wall_pair(pair, first, 0.0_wp, second, 0.0_wp, 10, stat)
    call check(stat == status_bad_argument, "bodies are needed")
    allocate (first, source=local_body(4, 3, 1.0_wp))
    allocate (second, source=local_body(4, 5, 1.0_wp))
    call new_wall_pair(pair, first, 0.0_wp, second, 0.0_wp, 10, stat)
    call check(stat == status_bad_argument, "unlike grids are refused")
  end subroutine refusals

end program test_wall_balance
