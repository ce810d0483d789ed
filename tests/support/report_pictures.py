"""Pages of a report as a browser prints them: pictures, and whether anything overflows."""

import base64
from pathlib import Path
from typing import Any

from browser import Page, browse

A4 = 794, 1123
"""A sheet [pixels at 96 to the inch]."""

PRINTABLE = 673, 1002
"""A sheet within margins of 16 mm."""

_BOXES = """(selector => [...document.querySelectorAll(selector)].map(of => {
  const box = of.getBoundingClientRect();
  return {x: box.x + scrollX, y: box.y + scrollY, width: box.width, height: box.height,
          spills: [...of.querySelectorAll("table, img, p, ul")].some(
            part => part.getBoundingClientRect().right > box.right + 2)};
}))"""


def take(file: Path, pictures: dict[str, Path], home: Path) -> dict[str, dict[str, Any]]:
    """Pictures of parts of a page as printed on A4; the box of each, and whether anything spills out of it.

    Parameters
    ----------
    file : Path
        The page.
    pictures : dict
        Selector of a part -> where its picture goes.
    home : Path
        Where the browser keeps its files.
    """

    async def visit(page: Page) -> dict[str, dict[str, Any]]:
        width, _ = PRINTABLE
        await page.call("Emulation.setEmulatedMedia", media="print")
        await page.call("Emulation.setDeviceMetricsOverride", width=width, height=1002,
                        deviceScaleFactor=1, mobile=False)  # fmt: skip
        await page.open(file)
        found = {}
        for selector, picture in pictures.items():
            (box,) = await page.run(f"{_BOXES}('{selector}')")
            clip = {key: box[key] for key in ("x", "y", "width", "height")} | {"scale": 1.5}
            clip |= {"x": clip["x"] - 8, "y": max(clip["y"] - 8, 0), "width": clip["width"] + 16}
            shot = await page.call("Page.captureScreenshot", captureBeyondViewport=True, clip=clip)
            picture.write_bytes(base64.b64decode(shot["data"]))
            found[selector] = box
        assert not page.errors, page.errors
        return found

    return browse(home, visit)
