"""Pages of a report as a browser prints them: pictures, and whether anything overflows."""

import base64
from pathlib import Path
from typing import Any

from browser import Page, browse

PRINTABLE = 673, 1002
"""A sheet of A4 within margins of 16 mm [pixels at 96 to the inch]."""

SHARPNESS = 1.5
"""Pixels of a picture over those."""

_BOXES = """(selector => [...document.querySelectorAll(selector)].map(of => {
  const box = of.getBoundingClientRect();
  return {x: box.x + scrollX, y: box.y + scrollY, width: box.width, height: box.height,
          spills: [...of.querySelectorAll("table, img, p, ul")].some(
            part => part.getBoundingClientRect().right > box.right + 2)};
}))"""


def take(file: Path, pictures: dict[str, Path], home: Path) -> dict[str, dict[str, Any]]:
    """Pictures of parts of a page as printed on A4; the box of each, and whether anything spills out of it.

    Args:
        file: The page.
        pictures: Selector of a part -> where its picture goes.
        home: Where the browser keeps its files.
    """

    async def visit(page: Page) -> dict[str, dict[str, Any]]:
        width, height = PRINTABLE
        metrics = {"width": width, "deviceScaleFactor": SHARPNESS, "mobile": False}
        await page.call("Emulation.setEmulatedMedia", media="print")
        await page.call("Emulation.setDeviceMetricsOverride", height=height, **metrics)
        await page.open(file)
        found = {}
        for selector, picture in pictures.items():
            (box,) = await page.run(f"{_BOXES}('{selector}')")
            # a clip beyond the window is not drawn sharply: the window holds all of it
            lowest = int(box["y"] + box["height"]) + 1
            await page.call("Emulation.setDeviceMetricsOverride", height=lowest, **metrics)
            clip = {key: box[key] for key in ("x", "y", "width", "height")} | {"scale": 1}
            shot = await page.call("Page.captureScreenshot", clip=clip)
            picture.write_bytes(base64.b64decode(shot["data"]))
            found[selector] = box
        assert not page.errors, page.errors
        return found

    return browse(home, visit)
