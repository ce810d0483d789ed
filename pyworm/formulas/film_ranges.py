"""Ranges of published film formulas, by the ellipticity and the regime of a contact."""

from dataclasses import dataclass
from math import inf

from pyworm.formulas.film import LineGroups, PointGroups
from pyworm.formulas.regimes import PIEZOVISCOUS_ELASTIC, REGIMES, Regime


@dataclass(frozen=True)
class FormulaRange:
    """Contacts for which a formula was made."""

    ellipticity: tuple[float, float] = (0.0, inf)
    """Least and largest ellipticity, axis across over axis along the entrainment [-]."""
    regimes: tuple[str, ...] = REGIMES
    """Regimes of `pyworm.formulas.regimes`."""

    def objection(self, groups: PointGroups | LineGroups, regime: Regime) -> str:
        """Reason why a contact is outside; empty inside. A regime within its uncertainty counts as inside."""
        if isinstance(groups, PointGroups):
            k, (least, most) = float(groups.ellipticity), self.ellipticity
            # the ellipticity of a circle is 1 but for rounding
            if not least * (1 - 1e-9) <= k <= most:
                to = f"{least:g} and more" if most == inf else f"{least:g} to {most:g}"
                return f"ellipticity {k:.2g}, made for {to}"
        if not {regime.name, *regime.close_to} & set(self.regimes):
            return f"{regime.name}, made for {' and '.join(self.regimes)}"
        return ""


FORMULA_RANGES = {
    "hamrock_dowson": FormulaRange((1, 8), (PIEZOVISCOUS_ELASTIC,)),
    "chittenden": FormulaRange(regimes=(PIEZOVISCOUS_ELASTIC,)),
    "nijenbanning_venner_moes": FormulaRange((0.36, inf)),
    "masjedi_khonsari": FormulaRange((1, 8), (PIEZOVISCOUS_ELASTIC,)),
    "dowson_higginson": FormulaRange(regimes=(PIEZOVISCOUS_ELASTIC,)),
    "dowson_toyoda": FormulaRange(regimes=(PIEZOVISCOUS_ELASTIC,)),
    "moes": FormulaRange(),
}
"""Formula of `pyworm.formulas.film` -> its range, as its docstring has it; Nijenbanning, Venner and Moes' to
radii along the entrainment five times those across, up to which it has been compared with solutions."""
