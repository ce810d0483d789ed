"""The pages to sign and that of variants, solved, printed and looked at in Chromium without a window."""

import matplotlib.image
import numpy as np
import pytest
from browser import CHROMIUM, WHY_NOT
from folders import CASES, ROOT
from report_pictures import PRINTABLE, take

from pyworm.cli.main import main

BUILT = ROOT / "build" / "pictures"
"""Pictures of the documentation are taken from here."""

RATED = """
[worm_rating]
oil = "PAG VG 460"
wheel_material = "CuSn12Ni2"
life = "25000 h"
"""


def colours(picture):
    seen = np.rint(matplotlib.image.imread(picture)[..., :3] * 255).astype(int)
    return len(np.unique(seen.reshape(-1, 3), axis=0))


@pytest.fixture(scope="module")
def solved(tmp_path_factory):
    """A unit by its drawing, and with half as much torque again, at three phases."""
    directory = tmp_path_factory.mktemp("results")
    text = (CASES / "worm_drawing.toml").read_text() + RATED
    results = []
    for name, torque in (("as drawn", 300), ("stronger", 450)):
        case = directory / f"{name}.toml"
        case.write_text(text.replace("300 Nm", f"{torque} Nm"))
        how = ("--accuracy", "30 %", "--phase", "0.2", "0.5", "0.8", "--pictures", "none")
        assert main(["run", str(case), *how, "--out", str(directory / name)]) == 0
        results.append(directory / name / "result.nc")
    return results


@pytest.mark.long
@pytest.mark.skipif(CHROMIUM is None, reason=WHY_NOT)
def test_the_pages_to_sign_fit_their_sheets(solved, tmp_path):
    out = tmp_path / "report.html"
    named = ("--drawing", "4711-03", "--customer", "Works & Sons")
    assert main(["report", str(solved[0]), *named, "--out", str(out)]) == 0
    BUILT.mkdir(parents=True, exist_ok=True)
    pictures = {
        ".cover": BUILT / "report_to_sign.png", ".overleaf": BUILT / "report_overleaf.png"
    }  # fmt: skip
    boxes = take(out, pictures, tmp_path / "browser")
    for part, box in boxes.items():
        assert not box["spills"], part
        assert box["width"] <= PRINTABLE[0] and box["height"] <= PRINTABLE[1], (part, box)
        assert colours(pictures[part]) > 50


@pytest.mark.long
@pytest.mark.skipif(CHROMIUM is None, reason=WHY_NOT)
def test_variants_stand_side_by_side(solved, tmp_path):
    out = tmp_path / "variants.html"
    assert main(["report", *map(str, solved), "--out", str(out)]) == 0
    BUILT.mkdir(parents=True, exist_ok=True)
    picture = BUILT / "report_variants.png"
    (box,) = take(out, {"body": picture}, tmp_path / "browser").values()
    assert not box["spills"] and colours(picture) > 50
    text = out.read_text()
    assert "operation.wheel_torque" in text and "450 N m" in text
