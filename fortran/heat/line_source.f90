!> Surface temperature of a half-space that moves past a line contact, in the steady state.
!>
!> A line source warms the surface at a distance x downstream by q/(pi k) exp(p x) K0(p |x|), p = u/(2 kappa) (Jaeger
!> 1942; Carslaw and Jaeger 1959, sec. 10.7): conduction along and into the body, for any velocity. For fast bodies
!> it tends to one-dimensional conduction into depth, q/sqrt(pi k rho c u x). A body at rest has no steady state: its
!> temperature grows as the logarithm of time. The kernel is integrated over cells in closed form.
module pyworm_line_source
  use pyworm_bessel, only: scaled_bessel_k
  use pyworm_convolution, only: grid_convolution, new_grid_convolution
  use pyworm_heated_surface, only: heated_body
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_bad_argument
  implicit none(type, external)
  private

  public :: line_body, new_line_body

  real(wp), parameter :: pi = acos(-1.0_wp)

  type, extends(heated_body) :: line_body
    type(grid_convolution) :: response
  contains
    procedure :: rise
    procedure :: rise_transposed
  end type line_body

contains

  !> Body of `conductivity` [W/(m K)] and `heat_capacity` rho c [J/(m3 K)] whose surface passes a grid of n points with
  !> the velocity u [m/s], not zero; points downstream of a source, in the direction of u, are in its wake.
  subroutine new_line_body(self, n, dx, u, conductivity, heat_capacity, stat)
    type(line_body), intent(inout) :: self
    integer, intent(in) :: n
    real(wp), intent(in) :: dx, u, conductivity, heat_capacity
    integer, intent(out) :: stat
    real(wp) :: p, edge(0:n)
    real(wp), allocatable :: kernel(:, :)
    integer :: i

    stat = status_bad_argument
    if (n < 2 .or. .not. (dx > 0 .and. conductivity > 0 .and. heat_capacity > 0)) return
    if (.not. (abs(u) > 0 .and. abs(u) <= huge(1.0_wp))) return
    self%nx = n
    self%ny = 1
    p = abs(u)*heat_capacity/(2*conductivity)
    allocate (kernel(1 - n:n - 1, 0:0))
    edge(0) = 0
    edge(1:) = wake([((i - 0.5_wp)*p*dx, i=1, n)])
    kernel(0, 0) = edge(1)
    kernel(1:, 0) = edge(2:) - edge(1:n - 1)
    edge(1:) = bow([((i - 0.5_wp)*p*dx, i=1, n)])
    kernel(0, 0) = kernel(0, 0) + edge(1)
    kernel(:-1, 0) = edge(n:2:-1) - edge(n - 1:1:-1)
    kernel = kernel/(pi*conductivity*p)
    if (u < 0) kernel = kernel(n - 1:1 - n:-1, :)
    self%own = kernel(0, 0)
    call new_grid_convolution(self%response, n, 1, kernel, stat)
  end subroutine new_line_body

  !> Integral of exp(x) K0(x) from 0 to x.
  elemental real(wp) function wake(x)
    real(wp), intent(in) :: x
    real(wp) :: k0, k1

    call scaled_bessel_k(x, k0, k1)
    wake = x*(k0 + k1) - 1
  end function wake

  !> Integral of exp(-x) K0(x) from 0 to x.
  elemental real(wp) function bow(x)
    real(wp), intent(in) :: x
    real(wp) :: k0, k1

    call scaled_bessel_k(x, k0, k1)
    bow = 1 + x*exp(-2*min(x, 350.0_wp))*(k0 - k1)
  end function bow

  !> Temperature rise [K] under the flux `q` [W/m2].
  subroutine rise(self, q, temperature_rise)
    class(line_body), intent(inout) :: self
    real(wp), intent(in) :: q(self%nx, self%ny)
    real(wp), intent(out) :: temperature_rise(self%nx, self%ny)

    call self%response%convolve(q, temperature_rise)
  end subroutine rise

  !> Transposed product of `rise` (`heated_surface`).
  subroutine rise_transposed(self, weight, by_flux)
    class(line_body), intent(inout) :: self
    real(wp), intent(in) :: weight(self%nx, self%ny)
    real(wp), intent(out) :: by_flux(self%nx, self%ny)

    call self%response%convolve_transposed(weight, by_flux)
  end subroutine rise_transposed

end module pyworm_line_source
