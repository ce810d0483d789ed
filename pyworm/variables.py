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
