"""Sensitivity of the results to the numbers of the case, as `pyworm run --sensitivities` found it."""

from pyworm.report.console.key_sensitivities import sensitivities_tables
from pyworm.report.findings import Findings
from pyworm.report.page.content import Section


def exact_sensitivity_section(found: Findings) -> Section | None:
    """The table of a run with its sensitivities; None of another, and of another case than the solved one."""
    kept = found.result.sensitivities
    if kept is None or kept.case_name != found.case.name:
        return None
    return Section("Sensitivity", tuple(sensitivities_tables(kept)))
