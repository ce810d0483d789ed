"""Rollers of `cases/roller_ref.toml` in motion: limits, energies, both directions, films as they change.

    python benchmarks/drives/roller_engagement.py            # limits, energies, directions: a minute
    python benchmarks/drives/roller_engagement.py --films    # films: five minutes; draws the picture

Films are those of the middle of the contact line, transient to 10 %: entry into the driving section, exit
from it, a load pulse, a reversal of the gear set. The entry is coupled: friction of the rough, heated film in
the equation of motion. The tables are `docs/evidence/data/roller_rotation.csv` and `roller_transients.csv`.
"""

import sys
from dataclasses import replace
from functools import partial
from pathlib import Path
from time import process_time

import numpy as np
from matplotlib.figure import Figure

import pyworm
from pyworm.drives.roller_worm.drive import RollerWormDrive
from pyworm.drives.roller_worm.roller_rotation import RollerRotation, Spun, over_a_turn, over_times
from pyworm.drives.roller_worm.spin_up import energies, spin_up
from pyworm.drives.roller_worm.station_history import StationHistory, station_history
from pyworm.drives.roller_worm.wheel_motion import WheelMotion
from pyworm.plots.layout import add_grids, new_figure, write
from pyworm.scene.line import LineScene, Parabola

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_record import record

ROOT = Path(__file__).parents[2]
CASE = ROOT / "cases" / "roller_ref.toml"
PICTURE = ROOT / "docs" / "pictures" / "roller_engagement.png"

FINE = 1e-8
"""Relative tolerance of the integration."""


def limits(drive: RollerWormDrive) -> list[tuple[str, str]]:
    """Deviation from the balance of moments over the inertia, of smooth surfaces, in mid-mesh."""
    spun, rows = drive.spun("left", rough=False), []
    for share in (1.0, 1e-2, 1e-4, 1e-7):
        worst = {}
        for section, loaded in spun.paths.items():
            angles = (loaded.driving or loaded.idle).wheel_angles[[100, 104, 110]]
            body = replace(spun.body, inertia=share * spun.body.inertia)
            roller = replace(spun, body=body, wheel=WheelMotion(angles[0], drive.turning))
            seconds = (angles - angles[0]) / drive.turning
            found = over_times(roller, seconds[-1], tolerance=FINE)
            worst[section] = max(
                abs(found.speed(time) / drive._turning(section, float(angle)) - 1)
                for time, angle in zip(seconds[1:], angles[1:], strict=True)
            )
        text = ", ".join(f"{section} {value:.1e}" for section, value in worst.items())
        rows.append((f"inertia times {share:g}: deviation from the balance of moments", text))
    return rows


def balances(drive: RollerWormDrive) -> list[tuple[str, str]]:
    """Residual of the energies of both entries and of a whole turn, with a pin."""
    spun, rows = drive.spun("left"), []
    spun = replace(spun, body=replace(spun.body, pin_arm=1e-5))
    for tolerance in (1e-5, FINE):
        turn = over_a_turn(spun, tolerance=tolerance)
        parts = {name: spin_up(turn, name).energies.residual for name in spun.paths}
        if tolerance > FINE:
            parts["whole turn"] = energies(turn, 0.0, turn.end).residual
        text = ", ".join(f"{name} {value:.1e}" for name, value in parts.items())
        rows.append((f"tolerance {tolerance:g}: residual of the energies", text))
    return rows


def directions(drive: RollerWormDrive) -> list[tuple[str, str]]:
    """Spin-up of both directions, and how far the mirrored set is off."""
    mirrored = replace(drive, worm=replace(drive.worm, hand="left"), driving="right")
    reverse = replace(drive, driving="right")
    sets = {"right hand, left drives": drive, "left hand, right drives": mirrored}
    sets["right hand, right drives"] = reverse
    rows, times = [], {}
    for name, each in sets.items():
        for role, section in (("driving", each.driving), ("idling", other(each.driving))):
            found = spin_up(each.rotation(section), section)
            times[name, role] = found
            rows.append(
                (
                    f"{name}: {role} section",
                    f"from {found.entry_speed * 30 / np.pi:.0f} to "
                    f"{found.rolling_speed * 30 / np.pi:.0f} rpm in {found.seconds * 1e3:.3f} ms, "
                    f"{found.sliding_distance * 1e3:.2f} mm, {found.energies.sliding:.4f} J",
                )
            )
    here, there = [*sets][:2]
    worst = max(
        abs(times[there, role].seconds / times[here, role].seconds - 1)
        for role in ("driving", "idling")
    )
    films = max(
        abs(a / b - 1)
        for phase in np.linspace(0, 1, 9)
        for a, b in zip(
            mirrored.state("right", 1 - phase, [0.2, 0.8]).films.minimum,
            drive.state("left", phase, [0.2, 0.8]).films.minimum,
            strict=True,
        )
    )
    rows.append(("mirrored set turning the other way: spin-up times off by", f"{worst:.1e}"))
    rows.append(("  closed-form minimum film thickness off by", f"{films:.1e}"))
    return rows


def other(section: str) -> str:
    """The other section."""
    return "right" if section == "left" else "left"


def film(drive: RollerWormDrive, history: StationHistory, effects: str) -> pyworm.TransientResult:
    """The transient film of a station."""
    fastest = float(np.abs(history.entrainment).max())
    contact = LineScene(
        name="middle of a contact line",
        gap=Parabola(float(history.radius[0])),
        load=float(history.load.max()),
        velocities=(1.05 * fastest, 0.95 * fastest),
        bodies=drive.bodies,
        oil=drive.oil_supplied,
    )
    return pyworm.transient(
        contact, history.times, **history.laws, accuracy="10 %", effects=effects
    )


def scenarios(drive: RollerWormDrive) -> dict[str, tuple[RollerRotation, tuple[float, float]]]:
    """Rotation and window of exit, load pulse and reversal."""
    turn = drive.rotation("left")
    leaves = turn.passages("left")[1]
    mid = float(np.radians(30))
    pulse = WheelMotion(
        mid, drive.turning, (0.0, 3e-4, 4e-4, 5e-4, 1e-3), (1.0,) * 5, (1.0, 1.0, 2.0, 1.0, 1.0)
    )
    back = WheelMotion(mid, drive.turning, (0.0, 1.2e-3), (1.0, -1.0), (1.0, -1.0))
    return {
        "exit": (turn, (leaves - 6e-4, leaves - 1e-5)),
        "load pulse": (over_times(drive.spun("left", pulse), 1e-3), (0.0, 1e-3)),
        "reversal": (over_times(drive.spun("left", back), 1.2e-3), (0.0, 1.2e-3)),
    }


def row_of(name: str, history: StationHistory, found: pyworm.TransientResult, cpu: float) -> dict:
    """Extremes of a film over time."""
    data = found.dataset
    thickness = data["film_min"].values
    least = int(np.nanargmin(thickness))
    row = {
        "case": name,
        "film_min_um": f"{np.nanmin(thickness) * 1e6:.3f}",
        "at_ms": f"{data['time'].values[least] * 1e3:.3f}",
        "film_min_first_um": f"{thickness[np.isfinite(thickness)][0] * 1e6:.3f}",
        "film_min_last_um": f"{thickness[np.isfinite(thickness)][-1] * 1e6:.3f}",
        "entrainment_m_s": f"{history.entrainment.min():.3g} to {history.entrainment.max():.3g}",
        "sliding_max_m_s": f"{np.abs(history.sliding).max():.3g}",
        "load_kN_m": f"{history.load.min() / 1e3:.4g} to {history.load.max() / 1e3:.4g}",
        "cpu_s": f"{cpu:.0f}",
    }
    extremes = {
        "temperature_max_film_C": ("temperature_max_film", -273.15, 1.0),
        "asperity_load_ratio_max": ("asperity_load_fraction", 0.0, 1.0),
    }
    for key, (variable, offset, factor) in extremes.items():
        known = variable in data
        row[key] = f"{(np.nanmax(data[variable].values) + offset) * factor:.4g}" if known else ""
    print(*row.values(), flush=True)
    return row


def rotated(spun: Spun, factor) -> RollerRotation:
    """Rotation over a turn with a factor of the closed-form shear."""
    return over_a_turn(replace(spun, factor=factor))


def coupled_entry(drive: RollerWormDrive) -> tuple[list, list[dict]]:
    """Rotation, film and rotation again at the entry of the driving section."""
    spun, rows, films = drive.spun("left"), [], []
    rotate = partial(rotated, spun)
    rotations = [drive.rotation("left")]
    begin, _ = rotations[0].passages("left")
    window = begin + 2e-5, begin + 2.2e-3
    for number in range(3):
        began = process_time()
        history = station_history(rotations[-1], "left", 0.5, window)
        found = film(drive, history, "auto")
        films.append((history, found))
        rows.append(row_of(f"entry, pass {number + 1}", history, found, process_time() - began))
        data = found.dataset
        seconds, lost, load = (data[name].values for name in ("time", "power_loss", "load"))
        friction = history.friction_of(seconds, lost, load)
        rotations.append(rotate(history.factor("left", seconds, friction)))
        before, after = (
            np.array([each.speed(time) for time in np.linspace(*window, 300)])
            for each in rotations[-2:]
        )
        rows[-1]["change_of_rotation"] = f"{np.abs(after - before).max() / np.ptp(before):.2e}"
        rows[-1]["spin_up_ms"] = f"{spin_up(rotations[-1], 'left').seconds * 1e3:.3f}"
        print(rows[-1]["change_of_rotation"], rows[-1]["spin_up_ms"], flush=True)
    return films, rows


def picture(films: list, others: dict) -> Figure:
    """Rotation and film of the entry by each pass; films of the other scenarios."""
    figure = new_figure(11, 6.6, "Films of a roller in motion, middle of its contact line")
    panels = figure.subplots(2, 3)
    spin, entry, friction = panels[0]
    for number, (history, found) in enumerate(films):
        name = "closed forms" if number == 0 else f"coupled, pass {number + 1}"
        times = history.times * 1e3
        spin.plot(times, history.speeds * 30e-3 / np.pi, label=name)
        data = found.dataset
        entry.plot(data["time"] * 1e3, data["film_min"] * 1e6, label=f"pass {number + 1}")
        solved = history.friction_of(
            data["time"].values, data["power_loss"].values, data["load"].values
        )
        friction.plot(data["time"] * 1e3, solved, label=f"solved, pass {number + 1}")
    friction.plot(times, history.friction, "k--", label="closed form")
    spin.set_ylabel("rotation / (1000 rpm)")
    entry.set_ylabel("minimum film thickness / µm")
    friction.set_ylabel("friction coefficient")
    friction.set_ylim(bottom=0)
    for axes, title in zip(
        panels[0], ("entry: rotation", "entry: film", "entry: friction"), strict=True
    ):
        axes.set_title(title, fontsize=10)
        axes.legend(frameon=False, fontsize=8)
    for axes, (name, (history, found)) in zip(panels[1], others.items(), strict=True):
        data = found.dataset
        axes.plot(data["time"] * 1e3, data["film_min"] * 1e6, label="minimum film thickness")
        axes.plot(data["time"] * 1e3, data["film_central"] * 1e6, label="central film thickness")
        axes.set_ylabel("film thickness / µm")
        axes.set_ylim(0, 1.15 * float(np.nanmax(data["film_central"])) * 1e6)
        axes.set_title(name, fontsize=10)
        twin = axes.twinx()
        twin.plot(history.times * 1e3, history.load / 1e3, "k:", lw=1)
        twin.plot(history.times * 1e3, 10 * history.entrainment, "k--", lw=0.8)
        twin.set_ylabel("load / (kN/m) (dotted),\n10 × entrainment / (m/s) (dashed)", fontsize=8)
    panels[1, 2].legend(*axes.get_legend_handles_labels(), frameon=False, fontsize=8)
    for axes in panels.flat:
        axes.set_xlabel("time / ms")
    add_grids([*panels.flat])
    return figure


def main() -> None:
    """Print, record and draw."""
    drive = pyworm.load(CASE).drive
    if "--films" not in sys.argv:
        rows = [*limits(drive), *balances(drive), *directions(drive)]
        record("roller_rotation", ("what", "value"), rows)
        return
    others, table = {}, []
    for name, (rotation, window) in scenarios(drive).items():
        began = process_time()
        history = station_history(rotation, "left", 0.5, window)
        found = film(drive, history, "isothermal")
        others[name] = history, found
        table.append(row_of(f"{name}, isothermal", history, found, process_time() - began))
    films, entries = coupled_entry(drive)
    table = [*entries, *table]
    keys = [*entries[0]]
    record(
        "roller_transients", tuple(keys), [tuple(row.get(key, "") for key in keys) for row in table]
    )
    write(picture(films, others), PICTURE)


if __name__ == "__main__":
    main()
