"""An example of every command, the last line of its help."""

import argparse

EXAMPLES = {
    "run": "cases/zi_drive.toml -j 2 --accuracy 5%",
    "new": 'gear.toml --centre-distance "100 mm"',
    "example": "zi_drive",
    "check": "cases/zi_drive.toml --phase 0.5",
    "precision": "cases/point_m20_l10.toml",
    "film": "cases/zi_drive.toml --phase 0.5",
    "duty": "cases/conveyor.toml",
    "sweep": "cases/sweeps/film_of_speed_and_load.toml -j 2",
    "table": "cases/worm_drawing.toml --check 4 -j 2",
    "calibrate": "cases/film_rig.toml --measured films.csv --fit z",
    "design": "cases/designs/addenda.toml",
    "wear": "cases/zi_drive.toml --hours 1000",
    "plot": "results/zi_drive/result.nc --pictures all",
    "report": "results/zi_drive/result.nc --pdf",
    "export": "cases/worm_drawing.toml --formats stl,glb",
    "explore": "results/zi_drive/result.nc",
    "rate": "cases/oil_zi.toml",
    "oil": 'show "PAG VG 460"',
    "oil choose": "cases/oil_zi.toml",
    "oil show": '"PAG VG 460" "PAO VG 220"',
    "oil chart": '"PAG VG 460" "PAO VG 220"',
    "oil list": "",
    "rexs": "cases/worm_drawing.toml --out worm.rexs",
    "setup": 'cases/zi_drive.toml --place "2 mm" --size 30%',
    "surface": "cases/surfaces/ground.toml",
    "doctor": "",
}
"""Command -> arguments of its example."""


def add_examples(parser: argparse.ArgumentParser, before: str = "") -> None:
    """Give every command below a parser its help as a description, and its example as the last line."""
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for choice, below in zip(action._choices_actions, action.choices.values(), strict=True):
                name = f"{before} {choice.dest}".strip()
                sentence = choice.help or ""
                below.description = f"{sentence[:1].upper()}{sentence[1:]}."
                below.epilog = f"Example: pyworm {name} {EXAMPLES[name]}".rstrip()
                add_examples(below, name)
