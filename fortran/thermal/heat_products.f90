!> Products of the linearised equations of a film's temperature with fields, and of their transpose.
!>
!> With H the equations of `heat_residual`, T the temperature at the nodes and levels, p the pressure of the oil, h the gap (of
!> rough surfaces that between their mean planes) and p_a the pressure of the asperities at the nodes:
!>   heat_by_temperature              y = dH/dT x
!>   heat_by_film                     y = dH/dp dp + dH/dh dh + dH/dp_a dp_a
!>   heat_by_film_transposed          (dH/dp)^T y, (dH/dh)^T y, (dH/dp_a)^T y
!>   heat_transposed                  these, and (dH/dT)^T y
!> Fields of temperature and equations are (nx, ny, levels), the others (nx, ny). The rise of the bodies is in single precision.
!>
!> Where oil flows between rough surfaces p = P - p_a(h), with P the total pressure: by P counts dH/dp, and by h with it
!> dH/dh + (dH/dp - dH/dp_a) times the asperities' stiffness. Where it has ruptured p_a = P: by P counts dH/dp_a.
module pyworm_heat_products
  use pyworm_heat_linearisation, only: heat_linearisation, by_pressure, by_slope_x, by_slope_y, by_gap, before_levels
  use pyworm_heat_columns, only: most_upstream
  use pyworm_kinds, only: wp
  use pyworm_wall_balance, only: wall_pair
  implicit none(type, external)
  private

  public :: heat_by_temperature, heat_by_film, heat_by_film_transposed, heat_transposed

contains

  !> Change of the equations by that of the temperature.
  subroutine heat_by_temperature(self, walls, warming, change)
    type(heat_linearisation), intent(in) :: self
    type(wall_pair), intent(inout) :: walls
    real(wp), intent(in) :: warming(self%nx*self%ny, self%levels)
    real(wp), intent(out) :: change(self%nx*self%ny, self%levels)
    real(wp) :: lacked
    integer :: s, k, t

    change = 0
    !$omp parallel do private(k, t, lacked) schedule(static)
    do s = 1, size(self%node)
      do k = 1, self%levels
        lacked = sum(self%block(before_levels + 1:, k, s)*warming(self%node(s), :))
        do t = 1, most_upstream
          lacked = lacked + self%weight(t, k, s)*warming(self%place(t, k, s), k)
        end do
        change(self%node(s), k) = lacked
      end do
    end do
    call warm_walls(self, walls, change)
    change(:, [1, self%levels]) = change(:, [1, self%levels]) + warming(:, [1, self%levels])
    call add_outline(self, warming, change)
  end subroutine heat_by_temperature

  !> Change of the equations by those of the oil's pressure, of the gap and of the asperities' pressure.
  subroutine heat_by_film(self, walls, dp, dh, asperities, change)
    type(heat_linearisation), intent(in) :: self
    type(wall_pair), intent(inout) :: walls
    real(wp), intent(in) :: dp(self%nx*self%ny), dh(self%nx*self%ny), asperities(self%nx*self%ny)
    real(wp), intent(out) :: change(self%nx*self%ny, self%levels)
    real(wp) :: inputs(before_levels)
    integer :: s, k

    change = 0
    !$omp parallel do private(k, inputs) schedule(static)
    do s = 1, size(self%node)
      associate (node => self%node(s))
        inputs = 0
        inputs(by_pressure) = dp(node)
        inputs(by_slope_x) = (dp(node + 1) - dp(node - 1))/(2*self%spacing(1))
        if (self%ny > 1) inputs(by_slope_y) = (dp(node + self%nx) - dp(node - self%nx))/(2*self%spacing(2))
        inputs(by_gap) = dh(node)
        do k = 1, self%levels
          change(node, k) = sum(self%block(:before_levels, k, s)*inputs)
        end do
      end associate
    end do
    if (allocated(self%rubbing)) then
      do k = 1, self%levels, self%levels - 1
        change(:, k) = change(:, k) - reshape(self%rubbing, [size(dp)])*asperities
      end do
    end if
    call warm_walls(self, walls, change)
  end subroutine heat_by_film

  !> Replaces the change of the heat that the walls' levels lack by that of the walls' balance through the bodies' rise.
  subroutine warm_walls(self, walls, change)
    type(heat_linearisation), intent(in) :: self
    type(wall_pair), intent(inout) :: walls
    real(wp), intent(inout) :: change(self%nx, self%ny, self%levels)
    real(wp) :: rise(self%nx, self%ny)
    integer :: wall, level

    do wall = 1, 2
      level = merge(1, self%levels, wall == 1)
      call walls%body(wall)%surface%rise(change(:, :, level), rise)
      change(:, :, level) = rise
    end do
  end subroutine warm_walls

  !> Adds the fields of the levels between the walls on the outline.
  subroutine add_outline(self, from, to)
    type(heat_linearisation), intent(in) :: self
    real(wp), intent(in) :: from(self%nx, self%ny, self%levels)
    real(wp), intent(inout) :: to(self%nx, self%ny, self%levels)
    integer :: k

    do k = 2, self%levels - 1
      to([1, self%nx], :, k) = to([1, self%nx], :, k) + from([1, self%nx], :, k)
      if (self%ny == 1) cycle
      to(2:self%nx - 1, [1, self%ny], k) = to(2:self%nx - 1, [1, self%ny], k) + from(2:self%nx - 1, [1, self%ny], k)
    end do
  end subroutine add_outline

  !> Sets the transposed product by temperature from the weights of the equations and of the heat that levels lack.
  subroutine set_by_warming(self, weight, lacked, by_warming)
    type(heat_linearisation), intent(in) :: self
    real(wp), intent(in) :: weight(self%nx*self%ny, self%levels), lacked(self%levels, self%nx*self%ny)
    real(wp), intent(out) :: by_warming(self%nx*self%ny, self%levels)
    !> With the levels of a node together.
    real(wp) :: by_levels(self%levels, self%nx*self%ny)
    integer :: s, k, t

    by_levels = 0
    !$omp parallel do private(k) schedule(static)
    do s = 1, size(self%node)
      associate (node => self%node(s))
        do k = 1, self%levels
          by_levels(:, node) = by_levels(:, node) + self%block(before_levels + 1:, k, s)*lacked(k, node)
        end do
      end associate
    end do
    do s = 1, size(self%node)
      do k = 1, self%levels
        do t = 1, most_upstream
          associate (place => self%place(t, k, s))
            by_levels(k, place) = by_levels(k, place) + self%weight(t, k, s)*lacked(k, self%node(s))
          end associate
        end do
      end do
    end do
    by_warming = transpose(by_levels)
    by_warming(:, [1, self%levels]) = by_warming(:, [1, self%levels]) + weight(:, [1, self%levels])
    call add_outline(self, weight, by_warming)
  end subroutine set_by_warming

  !> Transposed products of the derivatives by the oil's pressure, the gap and the asperities' pressure.
  subroutine heat_by_film_transposed(self, walls, weight, by_p, by_h, by_asperities)
    type(heat_linearisation), intent(in) :: self
    type(wall_pair), intent(inout) :: walls
    real(wp), intent(in) :: weight(self%nx*self%ny, self%levels)
    real(wp), intent(out) :: by_p(self%nx*self%ny), by_h(self%nx*self%ny), by_asperities(self%nx*self%ny)
    real(wp) :: lacked(self%levels, self%nx*self%ny)

    call weigh_levels(self, walls, weight, lacked)
    call set_by_film(self, lacked, by_p, by_h, by_asperities)
  end subroutine heat_by_film_transposed

  !> Transposed products of the derivatives by the film and by temperature.
  subroutine heat_transposed(self, walls, weight, by_p, by_h, by_asperities, by_warming)
    type(heat_linearisation), intent(in) :: self
    type(wall_pair), intent(inout) :: walls
    real(wp), intent(in) :: weight(self%nx*self%ny, self%levels)
    real(wp), intent(out) :: by_p(self%nx*self%ny), by_h(self%nx*self%ny), by_asperities(self%nx*self%ny), &
      by_warming(self%nx*self%ny, self%levels)
    real(wp) :: lacked(self%levels, self%nx*self%ny)

    call weigh_levels(self, walls, weight, lacked)
    call set_by_film(self, lacked, by_p, by_h, by_asperities)
    call set_by_warming(self, weight, lacked, by_warming)
  end subroutine heat_transposed

  !> Sets the transposed products by the film from the weights of the heat that levels lack.
  subroutine set_by_film(self, lacked, by_p, by_h, by_asperities)
    type(heat_linearisation), intent(in) :: self
    real(wp), intent(in) :: lacked(self%levels, self%nx*self%ny)
    real(wp), intent(out) :: by_p(self%nx*self%ny), by_h(self%nx*self%ny), by_asperities(self%nx*self%ny)
    real(wp) :: inputs(before_levels)
    integer :: s, k

    by_p = 0
    by_h = 0
    do s = 1, size(self%node)
      associate (node => self%node(s))
        inputs = 0
        do k = 1, self%levels
          inputs = inputs + self%block(:before_levels, k, s)*lacked(k, node)
        end do
        inputs([by_slope_x, by_slope_y]) = inputs([by_slope_x, by_slope_y])/(2*self%spacing)
        by_p(node) = by_p(node) + inputs(by_pressure)
        by_p(node + 1) = by_p(node + 1) + inputs(by_slope_x)
        by_p(node - 1) = by_p(node - 1) - inputs(by_slope_x)
        by_h(node) = inputs(by_gap)
        if (self%ny == 1) cycle
        by_p(node + self%nx) = by_p(node + self%nx) + inputs(by_slope_y)
        by_p(node - self%nx) = by_p(node - self%nx) - inputs(by_slope_y)
      end associate
    end do
    by_asperities = 0
    if (allocated(self%rubbing)) by_asperities = -reshape(self%rubbing, [size(by_p)])*(lacked(1, :) + lacked(self%levels, :))
  end subroutine set_by_film

  !> Weights of the heat that levels lack, with the levels of a node together, from those of the equations: of the walls' levels
  !> through the bodies' rise.
  subroutine weigh_levels(self, walls, weight, lacked)
    type(heat_linearisation), intent(in) :: self
    type(wall_pair), intent(inout) :: walls
    real(wp), intent(in) :: weight(self%nx, self%ny, self%levels)
    real(wp), intent(out) :: lacked(self%levels, self%nx, self%ny)
    real(wp) :: by_flux(self%nx, self%ny)
    integer :: wall, level, k

    do k = 2, self%levels - 1
      lacked(k, :, :) = weight(:, :, k)
    end do
    do wall = 1, 2
      level = merge(1, self%levels, wall == 1)
      call walls%body(wall)%surface%rise_transposed(weight(:, :, level), by_flux)
      lacked(level, :, :) = by_flux
    end do
  end subroutine weigh_levels

end module pyworm_heat_products
