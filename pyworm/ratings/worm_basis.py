"""What a rating of a worm gear rests on: standard, edition, clauses, what was not read, and the scope.

Scope and the beginning of the table of contents, clauses 1 to 6, are those that the publishers of ISO/TS
14521:2020 show; its other clauses are numbered from memory.
"""

from pyworm.ratings.worm_loads import RatedWormGear

STANDARD = "ISO/TS 14521:2020"

BASIS = (
    f"Worm gear: {STANDARD}, Calculation of load capacity of worm gears, whose methods are those of DIN "
    "3996:2012.",
    "The standard was not read: all formulas, curves and strengths are from memory or from one public "
    "transcription of DIN 3996 (the worm gear worksheet of MITCalc); clauses are numbered from memory. The "
    "documentation lists each constant with its provenance.",
)
"""Standard and edition of the safeties, and what was not read."""

CLAUSES = {
    "S_W": "clause 8",
    "S_H": "clause 9",
    "S_delta": "clause 10",
    "S_F": "clause 11",
    "S_T": "clause 12",
    "S_M": "no clause, the material's limit",
}
"""Symbol of a safety -> its clause, from memory."""

MIN_CENTRE_DISTANCE, MAX_SLIDING_SPEED, MIN_WEAR_SPEED, MIN_CONTACT_RATIO = 0.05, 25.0, 0.1, 2.1
"""Scope of the standard: centre distance from [m], sliding speed up to, and of wear from [m/s], and contact
ratio above [-]."""


def outside_scope(gear_set: RatedWormGear) -> tuple[str, ...]:
    """What of a worm gear lies outside the standard's scope, a sentence each."""
    speeds = [load.rated.sliding_speed for load in gear_set.loads]
    ratio, distance = gear_set.duty.contact_ratio, gear_set.duty.gear.centre_distance
    found = []
    if distance < MIN_CENTRE_DISTANCE:
        found.append(
            f"a centre distance of {distance * 1e3:.4g} mm, below {MIN_CENTRE_DISTANCE * 1e3:g} mm"
        )
    if max(speeds) > MAX_SLIDING_SPEED:
        found.append(f"a sliding speed of {max(speeds):.3g} m/s, above {MAX_SLIDING_SPEED:g} m/s")
    if min(speeds) < MIN_WEAR_SPEED:
        found.append(
            f"for wear a sliding speed of {min(speeds):.2g} m/s, below {MIN_WEAR_SPEED:g} m/s"
        )
    if ratio is not None and ratio <= MIN_CONTACT_RATIO:
        found.append(f"a contact ratio of {ratio:.3g}, not above {MIN_CONTACT_RATIO:g}")
    return tuple(f"Outside the scope of {STANDARD}: {reason}." for reason in found)
