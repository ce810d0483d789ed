"""Forces of a worm drive's mesh on both shafts, each in its own axes."""

import numpy as np

from pyworm.drives.forces import MeshForces, ShaftAxes
from pyworm.drives.worm.flanks.wheel_envelope import WHEEL_AXIS
from pyworm.drives.worm.loads.load_sharing import Shaft
from pyworm.drives.worm.loads.mesh import WormMesh


def worm_forces(mesh: WormMesh, friction: float, driver: Shaft) -> MeshForces:
    """The mean forces of all teeth in mesh, in mid-mesh, under the torque of the wheel.

    With a coefficient of friction, and either shaft driving on the flanks that the mesh has under load; both
    shafts rigid.
    """
    rigid = mesh.with_rigid_shaft
    mean = rigid.force_with(friction if driver == rigid.driver else -friction)
    point, force = mean.point[:, None], mean.force[:, None]
    flank = rigid.worm_flank
    # the worm's thread pushes the wheel along its axis as the worm would turn about it
    across = -float(np.sign(rigid.force_with(0.0).force @ WHEEL_AXIS))
    worm = ShaftAxes("worm", flank.axis_point, flank.axes[:, 0], flank.axes[:, 2])
    wheel = ShaftAxes("wheel", np.zeros(3), -flank.axes[:, 0], across * WHEEL_AXIS)
    return MeshForces(driver, friction, (worm.force(point, force), wheel.force(point, -force)))
