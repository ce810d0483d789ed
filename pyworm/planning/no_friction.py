"""Reason why a contact has no friction coefficient, by the effects that are simulated."""

from collections.abc import Sequence

from pyworm.planning.effects.judgement import Judgement

OF_FRICTION = ("shear-thinning", "limiting-stress", "surface-heating", "film-heating")
"""Effects at least one of which friction needs: that of a Newtonian oil of one temperature, which thickens
exponentially with pressure, is many times what any oil bears."""


def no_friction(effects: Sequence[Judgement]) -> str:
    """Why friction is not found though the oil's data would allow it; empty where they do not."""
    known = {
        effect.name: effect
        for effect in effects
        if effect.name in OF_FRICTION and effect.indicator is not None
    }
    off = [name for name in OF_FRICTION if name in known]
    if not off or any(effect.on for effect in known.values()):
        return ""
    *others, last = off
    names = f"{', '.join(others)} and {last}" if others else last
    return (
        f"the oil's flow law and heat are neglected ({names}), and a Newtonian oil of one temperature would "
        "have many times the friction; it is found with --effects auto or all"
    )
