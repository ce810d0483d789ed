!> What a program said of a contact as the kernel takes it, after checks.
module pyworm_contact_input
  use pyworm_contact_description, only: pyworm_bair_winer, pyworm_carreau, pyworm_carreau_yasuda, pyworm_eyring_limited, &
    pyworm_flow, pyworm_newton, pyworm_oil, pyworm_roughness, pyworm_scene, pyworm_tabulated, pyworm_tabulated_flow
  use pyworm_flow_laws, only: flow_law, law_tabulated, law_tabulated_limited
  use pyworm_flow_table, only: branches_curve, curve_points, flow_branch, newtonian_ratios, table_curve, tabulate_flow
  use pyworm_kinds, only: wp
  use pyworm_rough_surfaces, only: curve_count, gap_curves
  use pyworm_roughness_curves, only: curves_of, curves_through, rough_side
  use pyworm_status, only: status_bad_argument, status_not_finite, status_ok
  use pyworm_tabulated_oil, only: equal_cells, fits_table, pressure_cells, tabulated_property, warmth_cells
  use pyworm_viscosity_density, only: oil_law
  implicit none(type, external)
  private

  public :: complete_scene, oil_of, flow_of, curves_of_roughness

  !> Temperatures below and above the inlet's between which a function is tabulated where nothing else is said [K].
  real(wp), parameter :: colder = 60, warmer = 240
  !> By how much the fractions of a liquid's branches may miss one, and a stress its Newtonian one.
  real(wp), parameter :: fraction_slack = 1e-6_wp, stress_slack = 1e-9_wp
  !> Fewest pairs of a table of stresses.
  integer, parameter :: fewest_pairs = 4

contains

  !> A scene with all fields that may be left away, of at least `fewest` nodes a side; a side of one node is that of a line.
  subroutine complete_scene(scene, fewest, whole, stat)
    type(pyworm_scene), intent(in) :: scene
    integer, intent(in) :: fewest
    type(pyworm_scene), intent(out) :: whole
    integer, intent(out) :: stat
    integer :: nx, ny

    stat = status_bad_argument
    if (.not. allocated(scene%gap)) return
    nx = size(scene%gap, 1)
    ny = size(scene%gap, 2)
    if (nx < fewest .or. (ny < fewest .and. ny /= 1)) return
    if (.not. min(scene%dx, scene%dy, scene%reduced_modulus, scene%load) > 0) return
    if (.not. fits(scene)) return
    whole = scene
    if (.not. allocated(whole%covered)) allocate (whole%covered(nx, ny), source=.true.)
    if (.not. any(whole%covered)) return
    stat = status_not_finite
    if (.not. all(abs(whole%gap) <= huge(1.0_wp) .or. .not. whole%covered)) return
    ! beyond a body its gap is arbitrary
    where (.not. whole%covered) whole%gap = maxval(whole%gap, mask=whole%covered)
    if (.not. allocated(whole%velocity)) then
      allocate (whole%velocity(nx, ny, 2, 2))
      whole%velocity(:, :, 1, 1) = scene%velocity_1(1)
      whole%velocity(:, :, 2, 1) = scene%velocity_1(2)
      whole%velocity(:, :, 1, 2) = scene%velocity_2(1)
      whole%velocity(:, :, 2, 2) = scene%velocity_2(2)
    end if
    if (all(abs(whole%velocity) <= huge(1.0_wp))) stat = status_ok
  end subroutine complete_scene

  !> Whether the fields of a scene have its shape.
  pure logical function fits(scene)
    type(pyworm_scene), intent(in) :: scene
    integer :: nodes(2)

    nodes = shape(scene%gap)
    fits = .true.
    if (allocated(scene%covered)) fits = all(shape(scene%covered) == nodes)
    if (allocated(scene%supply)) fits = fits .and. all(shape(scene%supply) == nodes)
    if (allocated(scene%velocity)) fits = fits .and. all(shape(scene%velocity) == [nodes, 2, 2])
  end function fits

  !> The oil's law; tables of values, or of a function, in place of constants.
  subroutine oil_of(oil, law, stat)
    type(pyworm_oil), intent(in) :: oil
    type(oil_law), intent(out) :: law
    integer, intent(out) :: stat
    real(wp), allocatable :: pressures(:), temperatures(:), viscosities(:, :)
    real(wp) :: ambient, growth

    stat = status_bad_argument
    law = oil_law(oil%law, oil%viscosity, oil%exponent, oil%pole_pressure, oil%d1, oil%d2, oil%temperature, &
      oil%thermal_exponent, oil%expansivity, oil%expansivity_decay)
    if (oil%law == pyworm_tabulated) then
      call values_of(oil, pressures, temperatures, viscosities)
      if (.not. allocated(viscosities)) return
      if (.not. fits_table(pressures, temperatures, viscosities, oil%temperature)) return
      allocate (law%viscosity_table)
      call tabulated_property(pressures, temperatures, log(viscosities), oil%temperature, .false., law%viscosity_table, &
        ambient, growth)
      law%eta0 = exp(ambient)
      law%exponent = growth
      law%pole_pressure = 1
    end if
    if (allocated(oil%densities)) then
      if (.not. (allocated(oil%pressures) .and. allocated(oil%temperatures))) return
      if (.not. fits_table(oil%pressures, oil%temperatures, oil%densities, oil%temperature)) return
      allocate (law%density_table)
      call tabulated_property(oil%pressures, oil%temperatures, oil%densities, oil%temperature, .true., law%density_table, &
        ambient, growth)
    end if
    if (law%eta0 > 0 .and. law%eta0 <= huge(1.0_wp)) stat = status_ok
  end subroutine oil_of

  !> Viscosities [Pa s] at pressures [Pa] and temperatures [K], given or by the function; not allocated without either.
  subroutine values_of(oil, pressures, temperatures, viscosities)
    type(pyworm_oil), intent(in) :: oil
    real(wp), allocatable, intent(out) :: pressures(:), temperatures(:), viscosities(:, :)
    real(wp) :: coldest, warmest
    integer :: j, k

    if (.not. associated(oil%viscosity_at)) then
      if (.not. (allocated(oil%pressures) .and. allocated(oil%temperatures) .and. allocated(oil%viscosities))) return
      pressures = oil%pressures
      temperatures = oil%temperatures
      viscosities = oil%viscosities
      return
    end if
    coldest = merge(oil%coldest, oil%temperature - colder, oil%coldest > 0)
    warmest = merge(oil%warmest, oil%temperature + warmer, oil%warmest > 0)
    pressures = equal_cells(0.0_wp, oil%largest_pressure, pressure_cells)
    temperatures = equal_cells(coldest, warmest, warmth_cells)
    allocate (viscosities(size(pressures), size(temperatures)))
    do k = 1, size(temperatures)
      do j = 1, size(pressures)
        viscosities(j, k) = oil%viscosity_at(pressures(j), temperatures(k))
      end do
    end do
  end subroutine values_of

  !> The flow law, a curve as its tables.
  subroutine flow_of(flow, law, stat)
    type(pyworm_flow), intent(in) :: flow
    type(flow_law), intent(out) :: law
    integer, intent(out) :: stat
    real(wp) :: newtonian(curve_points), stress(curve_points)
    integer :: k
    logical :: limited

    stat = status_bad_argument
    if (flow%law < pyworm_newton .or. flow%law > pyworm_tabulated_flow) return
    limited = max(flow%limit, flow%limit_pressure) > 0
    if (.not. (min(flow%limit, flow%limit_pressure) >= 0 .and. flow%stress > 0)) return
    if (any(flow%law == [pyworm_bair_winer, pyworm_eyring_limited]) .and. .not. limited) return
    if (.not. flow%exponent > 0 .or. (flow%law == pyworm_carreau .and. flow%exponent > 1)) return
    law = flow_law(flow%law, flow%stress, flow%stress_pressure, flow%stress_temperature, flow%limit, flow%limit_pressure, &
      flow%exponent)
    if (any(flow%law == [pyworm_carreau_yasuda, pyworm_tabulated_flow])) then
      if (.not. has_curve(flow)) return
      newtonian = newtonian_ratios()
      if (flow%law == pyworm_carreau_yasuda) then
        stress = branches_curve([(flow_branch(flow%branches(k)%fraction, flow%branches(k)%ratio, flow%branches(k)%exponent, &
          flow%branches(k)%yasuda), k=1, size(flow%branches))], newtonian)
      else
        stress = table_curve(flow%table, newtonian)
      end if
      law%law = merge(law_tabulated_limited, law_tabulated, limited)
      law%exponent = 1
      call tabulate_flow(newtonian, stress, law%by_stress, law%by_rate)
    end if
    stat = status_ok
  end subroutine flow_of

  !> Whether the branches or the table of a law are those of an oil that thins.
  pure logical function has_curve(flow)
    type(pyworm_flow), intent(in) :: flow
    integer :: n

    has_curve = .false.
    if (flow%law == pyworm_carreau_yasuda) then
      if (.not. allocated(flow%branches)) return
      associate (b => flow%branches)
        has_curve = size(b) > 0 .and. all(b%fraction >= 0) .and. all(min(b%ratio, b%exponent, b%yasuda) > 0) &
          .and. all(b%exponent <= 1) .and. abs(sum(b%fraction) - 1) <= fraction_slack
      end associate
    else if (allocated(flow%table)) then
      n = size(flow%table, 2)
      if (size(flow%table, 1) /= 2 .or. n < fewest_pairs) return
      has_curve = all(flow%table > 0 .and. flow%table <= huge(1.0_wp)) .and. all(flow%table(:, 2:) > flow%table(:, :n - 1)) &
        .and. all(flow%table(2, :) <= flow%table(1, :)*(1 + stress_slack))
    end if
  end function has_curve

  !> Averages over roughness, those given or by the surfaces' constants.
  subroutine curves_of_roughness(roughness, reduced_modulus, curves, stat)
    type(pyworm_roughness), intent(in) :: roughness
    real(wp), intent(in) :: reduced_modulus
    type(gap_curves), intent(out) :: curves
    integer, intent(out) :: stat
    type(rough_side) :: sides(2)
    integer :: k

    stat = status_bad_argument
    if (.not. roughness%boundary_friction >= 0) return
    if (allocated(roughness%curves)) then
      if (size(roughness%curves, 1) /= curve_count .or. size(roughness%curves, 2) < 3) return
      if (.not. min(roughness%curve_scale, roughness%curve_spacing) > 0) return
      curves = curves_through(roughness%curve_scale, roughness%curve_first, roughness%curve_spacing, roughness%curves)
    else
      associate (surface => roughness%surface)
        if (.not. (all(surface%height >= 0) .and. any(surface%height > 0))) return
        if (.not. (any(surface%slope > 0) .or. any(surface%sharpness > 0 .and. surface%density > 0))) return
        if (.not. (all(surface%aspect > 0) .and. all(surface%hardness > 0))) return
        sides = [(rough_side(surface(k)%height, surface(k)%slope, surface(k)%aspect, surface(k)%lay, surface(k)%hardness, &
          surface(k)%sharpness, surface(k)%density), k=1, 2)]
      end associate
      curves = curves_of(sides, reduced_modulus)
    end if
    stat = status_ok
  end subroutine curves_of_roughness

end module pyworm_contact_input
