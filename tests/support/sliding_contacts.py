"""Stress below sliding Hertzian contacts by other means than the kernel's: line and circular, nu enters."""

import numpy as np

TOWARDS = np.polynomial.legendre.leggauss(200)


def sliding_line(x, z, friction):
    """Components xx, zz, xz below a cylinder of p0 = a = 1 whose friction acts along x (McEwen 1949).

    As in Johnson, Contact Mechanics, eq. 4.49 and 7.8.
    """
    root = np.hypot(1 - x**2 + z**2, 2 * x * z)
    m = np.sqrt((root + 1 - x**2 + z**2) / 2)
    n = x * z / m  # without the cancellation of its own root
    whole = m**2 + n**2
    xx = 2 * z - m * (1 + (z**2 + n**2) / whole)
    zz = -m * (1 - (z**2 + n**2) / whole)
    xz = -n * (m**2 - z**2) / whole
    along = n * (2 - (z**2 - m**2) / whole) - 2 * x
    return np.array([xx + friction * along, zz + friction * xz, xz + friction * xx])


def sliding_sphere(x, y, z, friction, nu):
    """Six components below a sphere of p0 = a = 1 whose friction acts along x (Hamilton and Goodman 1966).

    The pressure sqrt(1 - r^2) has the potential of sources at z = -i t of weight pi (1 - t^2)/2, -1 < t < 1
    (superposed disks, whose potential is that of uniform ones), so that each potential of a point force gives
    the contact's by quadrature over t.
    """
    nodes, weights = TOWARDS
    total = 0.0
    for t, weight in zip(nodes, weights, strict=True):
        field = _point_force(x, y, z, z + 1j * t, friction, nu)
        total = total + weight * np.pi * (1 - t**2) / 2 * field
    return np.real(total) / (2 * np.pi)


def _point_force(x, y, z, w, f, nu):
    """Stress by a unit force and f times one along x, times 2 pi, its potentials at the complex depth w.

    Boussinesq's and Cerruti's potentials as in Johnson, Contact Mechanics, section 3.2.
    """
    r = np.sqrt(x**2 + y**2 + w**2)
    s = r + w
    v_x, v_y, v_z = -x / r**3, -y / r**3, -w / r**3
    v_xx, v_yy, v_zz = (3 * c**2 / r**5 - 1 / r**3 for c in (x, y, w))
    v_xy, v_xz, v_yz = (3 * c / r**5 for c in (x * y, x * w, y * w))
    # chi = ln(r + w)
    chi_xx, chi_yy = (1 / (r * s) - c**2 * (1 / (r**3 * s) + 1 / (r * s) ** 2) for c in (x, y))
    third = 1 / (r**3 * s) + 1 / (r * s) ** 2
    chi_xy = -x * y * third
    # derivative of `third` by x is x times this
    fall = -(3 / (r**5 * s) + 1 / (r**4 * s**2) + 2 / (r**4 * s**2) + 2 / (r**3 * s**3))
    chi_xxx = -3 * x * third - x**3 * fall
    chi_xxy = -y * third - x**2 * y * fall
    chi_xyy = -x * third - x * y**2 * fall
    # psi = w ln(r + w) - r, psi_x = -x/(r + w)
    psi_xxx = 3 * x / (r * s**2) - x**3 * (1 / (r**3 * s**2) + 2 / (r**2 * s**3))
    psi_xxy = y / (r * s**2) - x**2 * y * (1 / (r**3 * s**2) + 2 / (r**2 * s**3))
    psi_xyy = x / (r * s**2) - x * y**2 * (1 / (r**3 * s**2) + 2 / (r**2 * s**3))
    normal = np.array(
        [
            2 * nu * v_z - z * v_xx - (1 - 2 * nu) * chi_xx,
            2 * nu * v_z - z * v_yy - (1 - 2 * nu) * chi_yy,
            v_z - z * v_zz,
            -z * v_xy - (1 - 2 * nu) * chi_xy,
            -z * v_xz,
            -z * v_yz,
        ]
    )
    along = np.array(
        [
            2 * (1 + nu) * v_x + 2 * nu * psi_xxx - z * chi_xxx,
            2 * nu * v_x + 2 * nu * psi_xyy - z * chi_xyy,
            -z * v_xz,
            v_y + 2 * nu * psi_xxy - z * chi_xxy,
            v_z - z * v_xx,
            -z * v_xy,
        ]
    )
    return normal + f * along
