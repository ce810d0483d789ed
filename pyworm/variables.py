"""What the variables of fields, histories and mesh cycles mean: their units and long names."""

import xarray as xr

VARIABLES = {
    "x": ("m", "tangent plane, first direction from the contact point"),
    "y": ("m", "tangent plane, second direction from the contact point"),
    "gap": ("m", "undeformed gap"),
    "covered": ("1", "1 where both surfaces exist"),
    "dry_pressure": ("Pa", "pressure of the dry contact"),
    "pressure": ("Pa", "pressure of the oil"),
    "film": ("m", "film thickness"),
    "entrainment_x": ("m/s", "mean surface velocity along x"),
    "entrainment_y": ("m/s", "mean surface velocity along y"),
    "sliding_x": ("m/s", "velocity of body 1 relative to body 2 along x"),
    "sliding_y": ("m/s", "velocity of body 1 relative to body 2 along y"),
    "shear_stress_x": ("Pa", "shear stress in the middle of the film along x"),
    "shear_stress_y": ("Pa", "shear stress in the middle of the film along y"),
    "shear_rate": ("1/s", "largest shear rate across the film"),
    "friction_power": ("W/m2", "heat made in the film by its shear"),
    "slip": ("1", "limiting stress reached at: 0 no surface, 1 body 1, 2 body 2, 3 both"),
    "flow_factor_sliding": (
        "m3/(Pa s)",
        "flow by pressure gradient along the sliding (h^3/12 eta)",
    ),
    "flow_factor_across": (
        "m3/(Pa s)",
        "flow by pressure gradient across the sliding (h^3/12 eta)",
    ),
    "temperature_body_1": ("K", "temperature of the surface of body 1"),
    "temperature_body_2": ("K", "temperature of the surface of body 2"),
    "temperature_middle": ("K", "temperature in the middle of the film"),
    "level_position": ("1", "place across the film, -1/2 at body 1 to 1/2 at body 2"),
    "profile_x": ("m", "place of the hottest point along x"),
    "profile_y": ("m", "place of the hottest point along y"),
    "profile_temperature": ("K", "temperature across the film at its hottest point"),
    "profile_velocity_x": ("m/s", "velocity across the film at its hottest point along x"),
    "profile_velocity_y": ("m/s", "velocity across the film at its hottest point along y"),
    "tooth_x": ("m", "tangent plane, first direction, over the whole tooth"),
    "tooth_y": ("m", "tangent plane, second direction, over the whole tooth"),
    "tooth_gap": ("m", "undeformed gap over the whole tooth"),
    "tooth_outline_x": ("m", "outline of the tooth along x"),
    "tooth_outline_y": ("m", "outline of the tooth along y"),
    "contact_path_x": ("m", "path of the contact point along x"),
    "contact_path_y": ("m", "path of the contact point along y"),
    "iteration": ("1", "iteration, counted over all grids"),
    "points_x": ("1", "grid points along x"),
    "points_y": ("1", "grid points along y"),
    "residual": ("1", "summed Reynolds residual over the summed wedge flow"),
    "load_error": ("1", "relative load imbalance"),
    "krylov": ("1", "inner iterations of the linear solver"),
    "convolutions": ("1", "convolutions since the step before"),
    "cycles": ("1", "multigrid cycles since the step before"),
    "convolution_seconds": ("s", "processor time of the convolutions"),
    "flow_seconds": ("s", "processor time of fields, flows and their changes"),
    "cycle_seconds": ("s", "processor time of the preconditioner, its building included"),
    "heat_seconds": ("s", "processor time of the columns of heat and of the walls"),
    "vector_seconds": ("s", "processor time of the linear solver's vectors and all else in a step"),
    "phase": ("1", "place in the mesh cycle"),
    "axis": ("1", "axis of the drive"),
    "worm_angle": ("rad", "angle turned by the worm"),
    "wheel_angle": ("rad", "angle turned by the wheel"),
    "transmission_error": ("rad", "angle of the wheel ahead of its mean motion"),
    "point": ("m", "contact point in the axes of the drive"),
    "normal": ("1", "common unit normal in the axes of the drive"),
    "radius_x": ("m", "relative radius of curvature along x"),
    "radius_y": ("m", "relative radius of curvature along y"),
    "roll_angle": ("rad", "roll angle of the pinion"),
    "radius": ("m", "relative radius of curvature across the contact line"),
    "pinion_velocity": ("m/s", "velocity of the pinion's surface across the contact line"),
    "gear_velocity": ("m/s", "velocity of the gear's surface across the contact line"),
    "unit_load": ("N/m", "normal load for each length of the contact line"),
    "friction_load_factor": ("1", "normal load with friction over that without"),
    "load_share": ("1", "share of the normal force that the contact line carries"),
    "pinion_specific_sliding": ("1", "sliding over the velocity of the pinion's surface"),
    "gear_specific_sliding": ("1", "sliding of the gear's surface over its velocity"),
    "closed_form_hertz_pressure": ("Pa", "largest pressure of the dry contact"),
    "closed_form_film_central": ("m", "central film by Dowson and Toyoda"),
    "closed_form_film_min": ("m", "minimum film by Dowson and Higginson"),
    "closed_form_specific_film": ("1", "that minimum film over the composite roughness"),
    "closed_form_flash_temperature": ("K", "Blok's flash temperature, a rise over the bulk's"),
    "closed_form_contact_temperature": ("K", "bulk temperature and Blok's flash temperature"),
}
"""Name -> unit and long name."""


def describe(dataset: xr.Dataset) -> xr.Dataset:
    """A copy of a dataset whose variables carry the units and long names of `VARIABLES`.

    Raises
    ------
    KeyError
        If a variable has no entry: every number we write says what it is.
    """
    described = dataset.copy()
    for name in described.variables:
        unit, long_name = VARIABLES[name]
        described[name].attrs.update(units=unit, long_name=long_name)
    return described
