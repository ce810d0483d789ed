!> Heat of the columns of a film: shearing, compression and conduction (Sharif et al. 2001, eq. 18 and appendix), from the
!> shear that `shear_flow` has found. The caller adds convection from other columns, and takes what the oil stores.
module pyworm_column_sources
  use pyworm_film_column, only: film_strip
  use pyworm_kinds, only: wp
  use pyworm_status, only: status_ok, status_no_memory
  use pyworm_thermal_properties, only: oil_heat_law, conductivity, heat_capacity
  use pyworm_viscosity_density, only: oil_law, expansivity
  use pyworm_shear_profile, only: film_velocity, film_heat
  use pyworm_strip_of_points, only: shear_strip
  use pyworm_sheared_oil, only: sheared_oil
  implicit none(type, external)
  private

  public :: column_oil, new_column_oil, set_heat, carried_away

  !> The oil in a strip of columns.
  type :: column_oil
    !> Pressure [Pa] and its rate of change [Pa/s], mean temperature across the film above the inlet's [K], and velocity of
    !> body 1 [m/s].
    real(wp), allocatable :: p(:), pressing(:), mean(:), u1(:), v1(:)
    !> Derivative of the fluidity by temperature at the levels [1/(Pa s K)].
    real(wp), allocatable :: softening(:, :)

    !> Heat capacity [J/(m3 K)], and velocity [m/s] and heat of compression [W/m3] at the levels.
    real(wp), allocatable :: capacity(:), u(:, :), v(:, :), compression(:, :)
  end type column_oil

  !> Rise of temperature [K] beyond which a solution is meaningless.
  real(wp), parameter, public :: hottest = 5e3_wp

contains

  !> Allocates the oil of up to `columns` columns.
  subroutine new_column_oil(columns, levels, self, stat)
    integer, intent(in) :: columns, levels
    type(column_oil), intent(out) :: self
    integer, intent(out) :: stat
    integer :: err

    allocate (self%p(columns), self%pressing(columns), self%mean(columns), self%u1(columns), self%v1(columns), &
      self%capacity(columns), self%softening(columns, levels), self%u(columns, levels), self%v(columns, levels), &
      self%compression(columns, levels), source=0.0_wp, stat=err)
    stat = merge(status_ok, status_no_memory, err == 0)
  end subroutine new_column_oil

  !> Sets film, conduction, dissipation as source, and its derivatives, of columns at the temperature `known` with fixed
  !> walls; of the columns' oil heat capacity, velocity and heat of compression.
  subroutine set_heat(law, oil, nodes, shear, state, columns)
    type(oil_heat_law), intent(in) :: law
    type(oil_law), intent(in) :: oil
    type(sheared_oil), intent(in) :: nodes
    type(shear_strip), intent(inout) :: shear
    type(column_oil), intent(inout) :: state
    type(film_strip), intent(inout) :: columns
    integer :: m, n, k, c

    associate (p => state%p, pressing => state%pressing, mean => state%mean, softening => state%softening, &
        capacity => state%capacity, u => state%u, v => state%v, compression => state%compression)
      m = shear%points
      n = nodes%levels%count
      columns%columns = m
      call film_velocity(nodes%law, nodes%levels, shear, state%u1, state%v1, u, v)
      call film_heat(nodes%levels, shear, columns%source, columns%growth, columns%loading(:, :, 1), columns%loading(:, :, 2), &
        columns%relief(:, :, 1), columns%relief(:, :, 2))
      columns%thickness(:m) = shear%film(:m)
      columns%conductivity(:m) = conductivity(law, p(:m))
      capacity(:m) = heat_capacity(law, p(:m), mean(:m))
      shear%step_x(:m) = expansivity(oil, p(:m))
      do k = 1, n
        do c = 1, m
          columns%growth(c, k) = columns%growth(c, k)*softening(c, k)
          columns%relief(c, k, 1) = columns%relief(c, k, 1)*softening(c, k)
          columns%relief(c, k, 2) = columns%relief(c, k, 2)*softening(c, k)
          compression(c, k) = shear%step_x(c)*(oil%temperature + columns%known(c, k)) &
            *(u(c, k)*shear%px(c) + v(c, k)*shear%py(c) + pressing(c))
        end do
      end do
      columns%wall(:m, 1) = columns%known(:m, 1)
      columns%wall(:m, 2) = columns%known(:m, n)
    end associate
  end subroutine set_heat

  !> Heat `carried` [W/m2] convected away from solved columns, less the inflow and the heat of compression, of which that
  !> stored is taken, `inflow` [W/m3].
  pure subroutine carried_away(columns, inflow, carried)
    type(film_strip), intent(in) :: columns
    real(wp), contiguous, intent(in) :: inflow(:, :)
    real(wp), contiguous, intent(out) :: carried(:)
    integer :: c, k

    carried = 0
    do k = 1, columns%levels%count
      do c = 1, columns%columns
        carried(c) = carried(c) + columns%thickness(c)*columns%levels%weight(k) &
          *(columns%absorption(c, k)*columns%temperature(c, k) - inflow(c, k))
      end do
    end do
  end subroutine carried_away

end module pyworm_column_sources
