"""Errichello's speed increaser, printed figures beside ours (docs/evidence/validation.md), in his units.

Run from the repository's root:
    python benchmarks/drives/errichello.py           table, reducer against increaser, addenda, assumptions
    python benchmarks/drives/errichello.py films     simulated films and temperatures (more than ten minutes)
    python benchmarks/drives/errichello.py picture   docs/pictures/errichello.png
"""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

import pyworm
from pyworm.drives.gear_pair.drive import GearPairDrive

sys.path.append(str(Path(__file__).parents[1] / "evidence"))
from evidence_pages import markdown
from evidence_record import record

CASES = {"original": "errichello_speed_increaser", "optimised": "errichello_optimised_addenda"}
MICROINCH = 25.4e-9
PRINTED = {"original": (2.1, 0.073, 439, 418), "optimised": (2.7, 0.097, 302, 563)}
"""Least film [microinch], specific film, largest contact and mean scuffing temperature [degF]."""

SHIFTS = np.arange(0.0, 0.6, 0.01)


def fahrenheit(kelvin):
    return np.asarray(kelvin) * 1.8 - 459.67


def worst(drive: GearPairDrive) -> dict[str, float]:
    """Least films and largest temperatures of the closed forms, and their phases."""
    phases = drive.cycle_phases()
    rating = drive.rating(drive.contacts(phases))
    thin, hot = rating.film_min.argmin(), rating.contact_temperature.argmax()
    return {
        "film": rating.film_min[thin] / MICROINCH,
        "specific film": rating.specific_film[thin],
        "thin at": phases[thin],
        "hottest": float(fahrenheit(rating.contact_temperature[hot])),
        "hot at": phases[hot],
        "Hertz GPa": rating.hertz_pressure.max() / 1e9,
    }


def shifted(drive: GearPairDrive, shift: float) -> GearPairDrive:
    """The same with another profile shift of the pinion, the sum kept."""
    teeth = drive.teeth
    total = teeth.pinion.profile_shift + teeth.gear.profile_shift
    pinion = replace(teeth.pinion, profile_shift=shift)
    gear = replace(teeth.gear, profile_shift=total - shift)
    return replace(drive, teeth=replace(teeth, pinion=pinion, gear=gear))


QUANTITIES = (
    "pitch-line velocity / ft/min",
    "h_min / microinch",
    "specific film thickness",
    "maximum contact temperature / degF",
    "mean scuffing temperature / degF",
    "phase of h_min",
    "phase of the maximum temperature",
)


def table(drives: dict[str, GearPairDrive]) -> None:
    """Printed figures beside ours; places are printed of the original addenda, in words."""
    columns = []
    for name, drive in drives.items():
        ours = worst(drive)
        places = [
            drive.phase_of(getattr(drive.teeth, f"{end}_single")) for end in ("lowest", "highest")
        ]
        original = name == "original"
        words = [f"near {place:.3f}" if original else "" for place in places]
        columns.append((400, *PRINTED[name], *words))
        columns.append(
            (
                f"{drive.pitch_line_velocity / 0.3048 * 60:.0f}",
                f"{ours['film']:.2f}",
                f"{ours['specific film']:.3f}",
                f"{ours['hottest']:.0f}",
                f"{float(fahrenheit(drive.surfaces.scuffing_temperature)):.0f}",
                f"{ours['thin at']:.3f}",
                f"{ours['hot at']:.3f}",
            )
        )
    titles = "original, published", "original, pyworm", "optimised, published", "optimised, pyworm"
    record("errichello", ("quantity", *titles), zip(QUANTITIES, *columns, strict=True))


SIMULATED = (
    "addenda",
    "phase",
    "h_min / microinch",
    "h_min by formula / microinch",
    "friction",
    "T_max of the surfaces / degF",
    "T_max by Blok with that friction / degF",
)


def compare_films(drives: dict[str, GearPairDrive]) -> None:
    """Simulated films and temperatures beside closed forms."""
    rows = []
    for name, drive in drives.items():
        for phase in (0.06, 0.13, 0.31, 0.5, 0.69, 0.87, 0.94):
            solved, rating = simulated(drive, phase), drive.rating(drive.contacts(phase))
            figures = solved.figures
            friction = figures.friction_coefficient.value
            hottest = max(
                figures.temperature_max_body_1.value, figures.temperature_max_body_2.value
            )
            blok = rating.contact_temperature - rating.flash_temperature
            blok += rating.flash_temperature * friction / drive.surfaces.friction_coefficient
            rows.append(
                (
                    name,
                    f"{phase:g}",
                    f"{figures.film_min.value / MICROINCH:.2f}",
                    f"{float(rating.film_min) / MICROINCH:.2f}",
                    f"{friction:.4f}",
                    f"{fahrenheit(hottest):.1f}",
                    f"{float(fahrenheit(blok)):.1f}",
                )
            )
    print(markdown(SIMULATED, rows))


def simulated(drive: GearPairDrive, phase: float):
    scene = drive.scene(phase)
    return pyworm.solve(scene, pyworm.plan(scene, 0.02, ("auto", "-roughness")))


def directions(drives: dict[str, GearPairDrive]) -> None:
    print("\nshare of the path in approach, and normal load with friction 0.1 over that without")
    for name, drive in drives.items():
        for driver, word in (("pinion", "reducer"), ("gear", "increaser")):
            turned = replace(drive, driver=driver)
            contacts = turned.contacts(np.linspace(0, 1, 2001))
            factor = turned.friction_load_factor(contacts, 0.1)
            ends = f"{factor.min():.3f} to {factor.max():.3f}"
            print(f"  {name:9s} {word:9s} {contacts.approach.mean():5.1%}   {ends}")


def addenda(drive: GearPairDrive) -> None:
    print(
        "\npinion's profile shift (sum kept) of the optimised gears: h_min microinch, hottest degF"
    )
    for shift in SHIFTS[::6]:
        ours = worst(shifted(drive, shift))
        print(f"  {shift:.2f}  {ours['film']:.2f}  {ours['hottest']:.0f}")
    best = min(SHIFTS, key=lambda shift: worst(shifted(drive, shift))["hottest"])
    print(f"  least flash temperature at {best:.2f}")


def assumptions(drive: GearPairDrive) -> None:
    print("\nwhat an assumption changes in the original: h_min microinch, hottest degF, Hertz GPa")
    teeth = drive.teeth
    for name, other in (
        ("as shipped", drive),
        ("load factor 1", replace(drive, load_factor=1.0)),
        ("load factor 3", replace(drive, load_factor=3.0)),
        ("face width 10 in", replace(drive, teeth=replace(teeth, face_width=0.254))),
        ("profile shift 0.6", shifted(drive, 0.6)),
        ("profile shift 0.9", shifted(drive, 0.9)),
        (
            "friction 0.12",
            replace(drive, surfaces=replace(drive.surfaces, friction_coefficient=0.12)),
        ),
        ("elastic sharing", replace(drive, load_sharing="elastic")),
        ("uniform sharing", replace(drive, load_sharing="uniform")),
    ):
        ours = worst(other)
        print(f"  {name:18s} {ours['film']:.2f}  {ours['hottest']:.0f}  {ours['Hertz GPa']:.2f}")


def picture(drives: dict[str, GearPairDrive]) -> None:
    figure = Figure(figsize=(10, 7), layout="constrained")
    panels = figure.subplots(2, 2, sharex="col", sharey="row")
    for column, (name, drive) in zip(panels.T, drives.items(), strict=True):
        phases = drive.cycle_phases()
        contacts = drive.contacts(phases)
        rating = drive.rating(contacts)
        roll = np.degrees(contacts.roll_angle)
        film, hot, *_ = PRINTED[name][0], PRINTED[name][2]
        solved = [(phase, simulated(drive, phase)) for phase in np.linspace(0.06, 0.94, 9)]
        rolls = np.interp([phase for phase, _ in solved], phases, roll)
        least = [one.figures.film_min.value / MICROINCH for _, one in solved]
        largest = [one.figures.temperature_max_body_1.value for _, one in solved]
        column[0].plot(
            roll, rating.film_min / MICROINCH, color="tab:green", label="Dowson-Higginson"
        )
        column[0].plot(rolls, least, "o", color="tab:green", label="simulated")
        column[0].axhline(film, color="0.3", linestyle="--", label="minimum, published")
        column[0].set_title(f"{name} addenda, VG {100 if name == 'original' else 220}")
        column[1].plot(
            roll,
            fahrenheit(rating.contact_temperature),
            color="tab:red",
            label="Blok, friction 0.1",
        )
        column[1].plot(
            rolls,
            fahrenheit(largest),
            "o",
            color="black",
            label="simulated, with simulated friction",
        )
        column[1].axhline(hot, color="0.3", linestyle="--", label="maximum, published")
        scuffing = fahrenheit(drive.surfaces.scuffing_temperature)
        column[1].axhline(
            scuffing, color="tab:purple", linestyle=":", label="mean scuffing temperature"
        )
        column[1].set_xlabel("roll angle of the pinion / degrees")
        for end in ("lowest_single", "highest_single", "pitch_point"):
            place = np.interp(drive.phase_of(getattr(drive.teeth, end)), phases, roll)
            for panel in column:
                panel.axvline(place, color="0.75", linewidth=0.8)
            text = {"l": "LPSTC", "h": "HPSTC", "p": "P"}[end[0]]
            column[0].annotate(
                text, (place, 1), xycoords=("data", "axes fraction"), xytext=(2, -2),
                textcoords="offset points", va="top", fontsize="small",
            )  # fmt: skip
    panels[0, 0].set_ylim(0, 6.5)
    panels[1, 0].set_ylim(200, 720)
    panels[0, 0].set_ylabel("minimum film thickness / µin")
    panels[1, 0].set_ylabel("contact temperature / °F")
    for panel in panels[:, 0]:
        panel.legend(frameon=False, loc="upper left", bbox_to_anchor=(0, 0.94), fontsize="small")
    figure.savefig("docs/pictures/errichello.png", dpi=100)


def main() -> None:
    drives = {name: pyworm.load(f"cases/{case}.toml").drive for name, case in CASES.items()}
    parts = {"picture": picture, "films": compare_films}
    if sys.argv[1:]:
        parts[sys.argv[1]](drives)
        return
    table(drives)
    directions(drives)
    addenda(drives["optimised"])
    assumptions(drives["original"])


if __name__ == "__main__":
    main()
