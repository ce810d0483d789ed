"""Pictures of a whole mesh cycle, by the kind of drive."""

from pyworm.drives.kinds import module_of
from pyworm.plots.drives.picture import CyclePicture
from pyworm.result.result import Result


def cycle_pictures(result: Result) -> dict[str, CyclePicture]:
    """Name in the file name -> picture of the mesh cycle of a result; empty without one.

    They are `CYCLE_PICTURES` of the module of this package that is named after the kind of drive.
    """
    if result.mesh_cycle is None:
        return {}
    module = module_of(result.mesh_cycle.attrs["drive"], "pyworm.plots.drives")
    return {} if module is None else module.CYCLE_PICTURES
