"""Made-up lives of contacts whose films are in motion."""

import numpy as np

from pyworm.io.plain_dataset import described

DURATION = 0.02
"""Time of a mesh cycle [s]."""

NODES = 9


def life_dataset(phases, power, load, film=None):
    """A life over some phases with a friction power [W] and a load [N]; its fields are those of a wave."""
    count = len(phases)
    film = np.full(count, 1e-6) if film is None else film
    figures = {"power_loss": power, "film_min": film, "film_central": 1.2 * film}
    figures |= {"pressure_max": np.full(count, 5e8), "friction_coefficient": power / load}
    x = np.linspace(-1e-3, 1e-3, NODES)
    wave = (
        np.exp(-((x[:, None] / 4e-4) ** 2 + (x / 4e-4) ** 2))[None]
        * np.linspace(1, 2, 3)[:, None, None]
    )
    over = ("frame", "node_x", "node_y")
    return described(
        {
            "life_phase": (("instant",), phases),
            "life_load": (("instant",), load),
            "life_entrainment_x": (("instant",), np.full(count, -1.0)),
            "life_entrainment_y": (("instant",), np.full(count, 0.5)),
            **{f"life_{name}": (("instant",), of) for name, of in figures.items()},
            **{f"life_{name}_error": (("instant",), 0.01 * of) for name, of in figures.items()},
            "frame_seconds": (("frame",), DURATION * np.quantile(phases, [0.1, 0.5, 0.9])),
            "frame_x": (over[:2], np.tile(x, (3, 1))),
            "frame_y": (("frame", "node_y"), np.tile(x, (3, 1))),
            "frame_pressure": (over, (3e8 * wave).astype(np.float32)),
            "frame_film": (over, (1e-6 / (0.1 + wave)).astype(np.float32)),
        },
        {"life_seconds": (("instant",), DURATION * phases)},
    )
