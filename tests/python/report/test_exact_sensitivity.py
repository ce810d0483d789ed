"""The report of a run with its sensitivities shows them in place of those by closed forms."""

from dataclasses import replace

import pytest

import pyworm
from pyworm.report.findings import findings
from pyworm.report.page.exact_sensitivity import exact_sensitivity_section
from pyworm.result.key_sensitivities import IN_PROVENANCE, KeySensitivities, KeySensitivity


@pytest.fixture(scope="module")
def result():
    return pyworm.run("cases/line_m20_l10.toml", accuracy=0.1)


def kept(result, name="line_m20_l10"):
    load = KeySensitivity("contact.load", 1e5, "N/m", 1e3, "1%", {"film_min": -1e-12})
    found = KeySensitivities(name, {"film_min": 5e-7}, (load,), {}, "By adjoint solutions.")
    return replace(result, provenance=result.provenance | {IN_PROVENANCE: found.summary()}), found


def test_a_result_holds_its_sensitivities_in_its_file_too(result, tmp_path):
    whole, found = kept(result)
    assert result.sensitivities is None
    path = whole.save(tmp_path / "result.nc")
    read = pyworm.open_result(path).sensitivities
    assert read.keys == found.keys
    assert read.results == found.results


def test_the_report_shows_them(result):
    whole, _ = kept(result)
    section = exact_sensitivity_section(findings(whole))
    (table,) = section.blocks
    assert table.rows[0][0] == "contact.load"
    assert "-0.20" in table.rows[0]
    assert exact_sensitivity_section(findings(result)) is None
    other, _ = kept(result, "another case")
    assert exact_sensitivity_section(findings(other)) is None
