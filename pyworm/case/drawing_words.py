"""What drawings, standards and design programs call the keys of a worm drive's drawing."""

from collections.abc import Mapping


def _words(names: Mapping[str, str]) -> dict[str, str]:
    """Each name of some, separated by blanks -> its key."""
    return {name: key for key, some in names.items() for name in some.split()}


OF_DRIVE = _words(
    {
        "centre_distance": "a center_distance axle_distance",
        "threads": "z1 z_1 starts number_of_threads number_of_starts",
        "teeth": "z2 z_2 number_of_teeth",
        "threads and teeth": "i u ratio gear_ratio transmission_ratio",
        "module": "m mx m_x axial_module",
        "diameter_factor": "q diameter_quotient",
        "pressure_angle": "alpha alpha_n alpha_0 normal_pressure_angle",
        "profile_shift": "x x2 x_2 profile_shift_coefficient",
        "face_width": "b b2 b_2 b2H width",
        "profile": "flank flank_form tooth_form worm_type type",
        "hand": "direction hand_of_threads",
        "worm.lead": "lead pz p_z",
        "worm.lead_angle": "lead_angle helix_angle gamma",
        "worm.reference_diameter": "reference_diameter d1 d_1 dm1 d_m1",
        "worm.tip_diameter": "tip_diameter da1 d_a1",
        "worm.root_diameter": "root_diameter df1 d_f1",
        "worm.base_diameter": "base_diameter db1 d_b1",
        "worm.axial_pitch": "axial_pitch px p_x",
        "wheel.reference_diameter": "d2 d_2 dm2 d_m2",
        "wheel.throat_diameter": "throat_diameter da2 d_a2",
        "wheel.outside_diameter": "outside_diameter de2 d_e2",
        "wheel.root_diameter": "df2 d_f2",
        "wheel.groove_radius": "groove_radius rk r_k throat_radius",
    }
)
"""Name in `[drive]` -> the key that it has here."""

OF_WORM = _words(
    {
        "tip_diameter": "addendum outside_diameter da1 d_a1",
        "root_diameter": "dedendum df1 d_f1",
        "reference_diameter": "d1 d_1 dm1 d_m1 pitch_diameter",
        "thickness": "tooth_thickness thread_thickness",
        "fillet_radius": "fillet root_fillet rho_f1 rhof1",
        "drive.threads": "threads starts z1",
        "drive.module": "module",
        "drive.pressure_angle": "pressure_angle",
        "drive.hand": "hand",
        "drive.profile": "profile",
        "drive.shaft.bearing_span": "bearing_span",
        "drive.shaft.diameter": "shaft_diameter",
    }
)
"""Name in `[drive.worm]` -> the key that it has here."""

OF_WHEEL = _words(
    {
        "throat_diameter": "addendum da2 d_a2 tip_diameter",
        "outside_diameter": "de2 d_e2",
        "root_diameter": "dedendum df2 d_f2",
        "reference_diameter": "d2 d_2 pitch_diameter",
        "groove_radius": "rk r_k",
        "fillet_radius": "fillet root_fillet rho_f2 rhof2",
        "drive.teeth": "teeth z2",
        "drive.module": "module",
        "drive.face_width": "face_width b2 width",
        "drive.backlash": "backlash",
        "drive.profile_shift": "profile_shift x2",
    }
)
"""Name in `[drive.wheel]` -> the key that it has here."""

OF_HOB = _words(
    {
        "reference_diameter": "d0 d_0 pitch_diameter",
        "drive.wheel.root_diameter": "outside_diameter da0 d_a0",
        "drive.wheel.fillet_radius": "fillet_radius edge_radius corner_radius tip_rounding rho_a0",
        "drive.pressure_angle": "pressure_angle",
    }
)
"""Name in `[drive.hob]` -> the key that it has here; its tip cuts the wheel's root."""

PROFILES = _words(
    {
        "ZA": "A",
        "ZN": "N",
        "ZI": "I E ZE",
        "ZK": "K",
        "ZC": "C H ZH CAVEX",
    }
)
"""Other name of a profile, in capitals -> the name here; ZH and ZE are those of older issues of DIN 3975."""
