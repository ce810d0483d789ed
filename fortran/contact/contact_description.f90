!> What a program says of a contact, and what it is told of the film: types of plain numbers and fields, in SI.
!>
!> Fields have the shape (nx, ny), with ny = 1 of a line contact, whose load is for each length.
module pyworm_contact_description
  use pyworm_kinds, only: wp
  implicit none(type, external)
  private

  public :: viscosity_function

  !> Laws of viscosity, and laws of flow; the numbers are those of `viscosity_density` and, but for the last two, `flow_laws`.
  integer, parameter, public :: pyworm_barus = 1, pyworm_roelands = 2, pyworm_tabulated = 3
  integer, parameter, public :: pyworm_newton = 0, pyworm_eyring = 1, pyworm_bair_winer = 2, pyworm_eyring_limited = 3, &
    pyworm_carreau = 4, pyworm_carreau_yasuda = 5, pyworm_tabulated_flow = 6

  abstract interface
    !> Viscosity [Pa s] at a pressure [Pa] and a temperature [K].
    function viscosity_function(pressure, temperature) result(viscosity)
      import :: wp
      implicit none(type, external)
      real(wp), intent(in) :: pressure, temperature
      real(wp) :: viscosity
    end function viscosity_function
  end interface

  !> Two bodies that are pressed together and move.
  type, public :: pyworm_scene
    !> Undeformed gap [m] on nodes dx and dy [m] apart, and where both bodies exist: everywhere if not allocated.
    real(wp), allocatable :: gap(:, :)
    logical, allocatable :: covered(:, :)
    real(wp) :: dx = 0, dy = 1
    !> Load [N], of a line contact for each length [N/m], and E' [Pa] with 2/E' = (1-nu1^2)/E1 + (1-nu2^2)/E2.
    real(wp) :: load = 0, reduced_modulus = 0
    !> Velocities (u, v) of the surfaces along x and y [m/s], or as a field (nx, ny, component, body), which counts if allocated.
    real(wp) :: velocity_1(2) = 0, velocity_2(2) = 0
    real(wp), allocatable :: velocity(:, :, :, :)
    !> Thickness of the oil layer that enters [m]; if not allocated there is oil in plenty.
    real(wp), allocatable :: supply(:, :)
  end type pyworm_scene

  !> An oil: viscosity and density against pressure and, where heat is simulated, temperature, and its thermal constants.
  type, public :: pyworm_oil
    integer :: law = pyworm_barus
    !> Viscosity at ambient pressure [Pa s]; alpha [1/Pa] of Barus or z [-] of Roelands; his pole pressure [Pa].
    real(wp) :: viscosity = 0, exponent = 0, pole_pressure = 1.96e8_wp
    !> Coefficients [1/Pa] of the density 1 + d1 p/(1 + d2 p).
    real(wp) :: d1 = 0, d2 = 0
    !> Inlet temperature [K], decay of viscosity with temperature (beta [1/K] of Barus, s0 [-] of Roelands),
    !> expansivity [1/K] and its logarithmic decay with pressure [1/Pa].
    real(wp) :: temperature = 313.15_wp, thermal_exponent = 0, expansivity = 0, expansivity_decay = 0
    !> Conductivity [W/(m K)] and volumetric heat capacity [J/(m3 K)], with their growth (`thermal_properties`).
    real(wp) :: conductivity = 0, c1 = 0, c2 = 0, heat_capacity = 0, k1 = 0, k2 = 0, b0 = 0, b1 = 0, b2 = 0
    !> By the law `pyworm_tabulated`: viscosities [Pa s], and densities [kg/m3] if allocated, at pressures [Pa], the first
    !> of them ambient, and temperatures [K], one of them at least.
    real(wp), allocatable :: pressures(:), temperatures(:), viscosities(:, :), densities(:, :)
    !> Or the viscosity as a function, which is tabulated up to a pressure [Pa] and between two temperatures [K]; of the
    !> same temperature below and above the inlet's as `pyworm.TabulatedViscosity.of` where they are zero.
    procedure(viscosity_function), pointer, nopass :: viscosity_at => null()
    real(wp) :: largest_pressure = 3e9_wp, coldest = 0, warmest = 0
  end type pyworm_oil

  !> A branch of a liquid by `pyworm_carreau_yasuda`: its part of the viscosity [-], the stress at which it thins over `stress`
  !> [-], Carreau's n and Yasuda's a, 2 by Carreau [-].
  type, public :: pyworm_branch
    real(wp) :: fraction = 1, ratio = 1, exponent = 1, yasuda = 2
  end type pyworm_branch

  !> How an oil shears: see `flow_laws` and `flow_table`.
  type, public :: pyworm_flow
    integer :: law = pyworm_newton
    !> Stress at which the oil thins, Eyring's or Carreau's [Pa]; limiting stress [Pa] and its growth with pressure [-], of
    !> `pyworm_carreau_yasuda` and `pyworm_tabulated_flow` where one of them is not zero; exponent of the limit or n of
    !> Carreau [-].
    real(wp) :: stress = 1, limit = 0, limit_pressure = 0, exponent = 1
    !> Logarithmic growth of the stress with pressure [1/Pa] and its decay with temperature [1/K].
    real(wp) :: stress_pressure = 0, stress_temperature = 0
    !> Levels across the film.
    integer :: levels = 7
    !> Branches of the liquid by `pyworm_carreau_yasuda`, whose fractions add up to one.
    type(pyworm_branch), allocatable :: branches(:)
    !> By `pyworm_tabulated_flow`: increasing pairs (2, pair) of viscosity times shear rate and shear stress, over `stress` [-].
    real(wp), allocatable :: table(:, :)
  end type pyworm_flow

  !> A solid's surface: conductivity [W/(m K)], volumetric heat capacity [J/(m3 K)], bulk temperature above the
  !> inlet's [K].
  type, public :: pyworm_body
    real(wp) :: conductivity = 0, heat_capacity = 0, bulk_rise = 0
  end type pyworm_body

  !> Roughness of one surface.
  type, public :: pyworm_rough_surface
    !> Root mean square height Rq [m] and slope [-].
    real(wp) :: height = 0, slope = 0
    !> Correlation length along the lay over that across it [-], and angle of the lay from the x axis [rad].
    real(wp) :: aspect = 1, lay = 0
    !> Hardness [Pa]; `huge` of a surface that does not yield.
    real(wp) :: hardness = huge(1.0_wp)
    !> Composite roughness over the radius of asperities of one radius [-], zero if rough on all scales, and such
    !> asperities for each area times radius times composite roughness [-].
    real(wp) :: sharpness = 0, density = 0.04_wp
  end type pyworm_rough_surface

  !> Two rough surfaces, averaged; or the averages themselves.
  type, public :: pyworm_roughness
    type(pyworm_rough_surface) :: surface(2)
    !> Friction coefficient of asperities in contact [-].
    real(wp) :: boundary_friction = 0.1_wp
    !> Averages (curve, row) in place of the surfaces, as of `rough_surfaces`, by rows `curve_spacing` apart from
    !> `curve_first` on in asinh(gap/`curve_scale`).
    real(wp) :: curve_scale = 0, curve_first = 0, curve_spacing = 0
    real(wp), allocatable :: curves(:, :)
  end type pyworm_roughness

  !> How a film is solved.
  type, public :: pyworm_options
    !> Residual of the film and of its load, over flow and load.
    real(wp) :: tolerance = 1e-4_wp
    !> Relative error of the films that is asked for.
    real(wp) :: accuracy = 0.02_wp
    !> Most Newton steps on a grid; half of them where the balance is not near the tolerance.
    integer :: most_steps = 60
  end type pyworm_options

  !> What a solve found, and how far off it may be.
  type, public :: pyworm_found
    !> Minimum film and film at the least gap [m], maximum pressure [Pa], at nodes of the grid that was solved.
    real(wp) :: film_min = 0, film_central = 0, pressure_max = 0
    !> Relative errors of these by the grids' changes; `huge` where one grid alone was solved.
    real(wp) :: film_min_error = huge(1.0_wp), film_central_error = huge(1.0_wp), pressure_max_error = huge(1.0_wp)
    !> Relative error of both films by the window, which ends too near by it; `huge` where that is not known.
    real(wp) :: window_error = huge(1.0_wp)
    !> Residual, missing load over the load, and Newton steps on the grid of the film.
    real(wp) :: residual = huge(1.0_wp), load_error = 1
    integer :: steps = 0
    !> Spacing of the grid of the film over that of the grid given: 1, or a power of two where no film was found on it.
    integer :: coarsening = 1
  end type pyworm_found

  !> Fields of a film at the nodes of the given grid.
  type, public :: pyworm_fields
    !> Pressure [Pa], with that of asperities, and film [m], between rough surfaces the mean thickness of the gap.
    real(wp), allocatable :: p(:, :), h(:, :)
    !> Pressure of the asperities [Pa] and fraction of the gap that oil fills [-].
    real(wp), allocatable :: asperity_pressure(:, :), fraction(:, :)
    !> With a flow law: shear stress at the middle of the film, on body 1 [Pa], and heat of shearing [W/m2].
    real(wp), allocatable :: stress_x(:, :), stress_y(:, :), heat(:, :)
    !> And temperature above the inlet's at the levels [K], third index, from body 1 to body 2.
    real(wp), allocatable :: rise(:, :, :)
  end type pyworm_fields

  !> What a film is made of is the library's affair.
  type, abstract, public :: hidden_film
  end type hidden_film

  !> A film: its contact, and what the last solve found. It is released with its variable.
  type, public :: pyworm_film
    class(hidden_film), allocatable :: hidden
  end type pyworm_film

end module pyworm_contact_description
