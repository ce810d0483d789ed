!> The oil of a sheared film: at each node and level its temperature and fluidity, and the stresses of its flow law.
module pyworm_sheared_oil
  use pyworm_flow_laws, only: flow_law, stress_scales
  use pyworm_gauss_lobatto, only: levels_across, new_levels
  use pyworm_kinds, only: wp
  use pyworm_reynolds, only: arithmetic_share, film_fields
  use pyworm_status, only: status_ok, status_no_memory
  use pyworm_viscosity_density, only: oil_law, hot_density, hot_fluidity, density_by_rise
  implicit none(type, external)
  private

  public :: sheared_oil, new_sheared_oil, set_oil, oil_warming, new_oil_warming

  !> The oil at the nodes.
  type :: sheared_oil
    type(flow_law) :: law
    type(levels_across) :: levels
    !> Share of the arithmetic mean of the nodes' mobilities in that of a face, the rest being the geometric mean.
    real(wp) :: arithmetic = arithmetic_share
    !> Velocity of body 2 relative to body 1 at the nodes [m/s].
    real(wp), allocatable :: sliding_x(:, :), sliding_y(:, :)
    !> Temperature at the levels less that of the inlet [K], third index.
    real(wp), allocatable :: rise(:, :, :)
    !> Fluidity 1/eta at the levels [1/(Pa s)] and its logarithmic derivative by pressure [1/Pa].
    real(wp), allocatable :: fluidity(:, :, :), fluidity_p(:, :, :)
    !> Stress at which the law departs from Newton's and limiting stress [Pa], and their derivatives by pressure.
    real(wp), allocatable :: onset(:, :), onset_p(:, :), limit(:, :), limit_p(:, :)
  end type sheared_oil

  !> Changes of the oil at the nodes by temperature: logarithmic derivative of the fluidity at the levels [1/K], and derivatives by
  !> the mean temperature across the film of density [1/K] and of the stress at which the law departs from Newton's [Pa/K].
  type :: oil_warming
    real(wp), allocatable :: fluidity(:, :, :), rho(:, :), onset(:, :)
  end type oil_warming

contains

  !> Makes the oil at its inlet temperature; `sliding` is the velocity of body 2 relative to body 1 at the nodes [m/s].
  subroutine new_sheared_oil(law, levels, sliding_x, sliding_y, self, stat)
    type(flow_law), intent(in) :: law
    integer, intent(in) :: levels
    real(wp), intent(in) :: sliding_x(:, :), sliding_y(:, :)
    type(sheared_oil), intent(out) :: self
    integer, intent(out) :: stat
    integer :: nx, ny, err

    nx = size(sliding_x, 1)
    ny = size(sliding_x, 2)
    self%law = law
    self%levels = new_levels(levels)
    self%sliding_x = sliding_x
    self%sliding_y = sliding_y
    allocate (self%rise(nx, ny, levels), self%fluidity(nx, ny, levels), self%fluidity_p(nx, ny, levels), self%onset(nx, ny), &
      self%onset_p(nx, ny), self%limit(nx, ny), self%limit_p(nx, ny), source=0.0_wp, stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
  end subroutine new_sheared_oil

  !> Evaluates the oil at the nodes first..last of row j.
  subroutine set_oil(oil, first, last, j, nodes, fields)
    type(oil_law), intent(in) :: oil
    integer, intent(in) :: first, last, j
    type(sheared_oil), intent(inout) :: nodes
    type(film_fields), intent(inout) :: fields
    real(wp) :: mean(first:last)
    real(wp), dimension(first:last, nodes%levels%count) :: rise, fluidity, by_pressure, by_temperature
    integer :: k

    rise = nodes%rise(first:last, j, :)
    associate (p => fields%p(first:last, j))
      call hot_fluidity(oil, p, rise, fluidity, by_pressure, by_temperature)
      mean = 0
      do k = 1, nodes%levels%count
        mean = mean + nodes%levels%weight(k)*rise(:, k)
        nodes%fluidity(first:last, j, k) = fluidity(:, k)
        nodes%fluidity_p(first:last, j, k) = by_pressure(:, k)
      end do
      call hot_density(oil, p, mean, fields%rho(first:last, j), fields%rho_p(first:last, j))
      call stress_scales(nodes%law, p, mean, nodes%onset(first:last, j), nodes%onset_p(first:last, j), &
        nodes%limit(first:last, j), nodes%limit_p(first:last, j))
    end associate
  end subroutine set_oil

  !> Computes the changes of the oil by temperature at the pressure and temperature of the nodes.
  subroutine new_oil_warming(oil, nodes, p, self, stat)
    type(oil_law), intent(in) :: oil
    type(sheared_oil), intent(in) :: nodes
    real(wp), intent(in) :: p(:, :)
    type(oil_warming), intent(out) :: self
    integer, intent(out) :: stat
    real(wp), dimension(size(p, 1), nodes%levels%count) :: fluidity, by_pressure, by_temperature
    integer :: j, err

    allocate (self%fluidity, mold=nodes%fluidity, stat=err)
    if (err == 0) allocate (self%rho, self%onset, mold=nodes%onset, stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
    if (stat /= status_ok) return
    do j = 1, size(p, 2)
      call hot_fluidity(oil, p(:, j), nodes%rise(:, j, :), fluidity, by_pressure, by_temperature)
      self%fluidity(:, j, :) = by_temperature
      self%rho(:, j) = density_by_rise(oil, p(:, j), matmul(nodes%rise(:, j, :), nodes%levels%weight))
      self%onset(:, j) = -nodes%law%reference_decay*nodes%onset(:, j)
    end do
  end subroutine new_oil_warming

end module pyworm_sheared_oil
