"""Chromium without a window, by its own protocol (Chrome DevTools Protocol) over tornado's web socket."""

import asyncio
import base64
import json
import shutil
import subprocess
import time
from contextlib import contextmanager
from pathlib import Path
from typing import Any

CHROMIUM = (
    shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
)

WHY_NOT = "no chromium here (apt install chromium)"

PATIENCE = 60.0
"""How long the browser may take to start or to answer [s]."""


class Page:
    """A page in the browser."""

    def __init__(self, socket: Any) -> None:
        self._socket, self._number = socket, 0
        self.errors: list[str] = []

    async def call(self, method: str, **parameters: Any) -> dict:
        """Answer of a method; errors of the page that arrive on the way are kept."""
        self._number += 1
        number = self._number
        await self._socket.write_message(
            json.dumps({"id": number, "method": method, "params": parameters})
        )
        while True:
            text = await asyncio.wait_for(self._socket.read_message(), PATIENCE)
            message = json.loads(text)
            self._keep_error(message)
            if message.get("id") == number:
                assert "error" not in message, message
                return message["result"]

    def _keep_error(self, message: dict) -> None:
        method, parameters = message.get("method"), message.get("params", {})
        if method == "Runtime.exceptionThrown":
            self.errors.append(json.dumps(parameters["exceptionDetails"])[:500])
        if method == "Log.entryAdded" and parameters["entry"]["level"] == "error":
            self.errors.append(parameters["entry"]["text"])
        if method == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "assert"):
            self.errors.append(json.dumps(parameters["args"])[:500])

    async def open(self, file: Path) -> None:
        """Open a file and wait until it has drawn itself."""
        for domain in ("Page", "Runtime", "Log", "Network"):
            await self.call(f"{domain}.enable")
        await self.call("Performance.enable", timeDomain="threadTicks")
        await self.call("Network.emulateNetworkConditions", offline=True, latency=0,
                        downloadThroughput=-1, uploadThroughput=-1)  # fmt: skip
        await self.call("Page.navigate", url=file.as_uri())
        while await self.run("document.readyState") != "complete":
            await asyncio.sleep(0.02)

    async def processor_time(self) -> float:
        """Processor time of all that the page has done since it was opened [s]."""
        metrics = (await self.call("Performance.getMetrics"))["metrics"]
        return next(one["value"] for one in metrics if one["name"] == "TaskDuration")

    async def run(self, script: str) -> Any:
        """Value of an expression in the page."""
        answer = await self.call("Runtime.evaluate", expression=script, returnByValue=True)
        assert "exceptionDetails" not in answer, answer
        return answer["result"].get("value")

    async def mouse(self, kind: str, x: float, y: float, **more: Any) -> None:
        """A mouse event at a place of the window: mouseMoved, mousePressed, mouseReleased."""
        await self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    async def click(self, x: float, y: float) -> None:
        """A click at a place of the window."""
        for kind in ("mousePressed", "mouseReleased"):
            await self.mouse(kind, x, y, button="left", clickCount=1)

    async def press(self, key: str, code: int) -> None:
        """A key pressed and released: its name and number, such as Tab and 9."""
        for kind in ("rawKeyDown", "keyUp"):
            await self.call("Input.dispatchKeyEvent", type=kind, key=key, code=key,
                            windowsVirtualKeyCode=code)  # fmt: skip

    async def width(self, pixels: int) -> int:
        """Width that the page needs on a screen so wide, by which it scrolls sideways if that is more."""
        await self.call("Emulation.setDeviceMetricsOverride", width=pixels, height=740,
                        deviceScaleFactor=1, mobile=False)  # fmt: skip
        return await self.run("document.documentElement.scrollWidth")

    async def medium(self, name: str) -> None:
        """Show the page as on paper ("print") or on a screen ("screen")."""
        await self.call("Emulation.setEmulatedMedia", media=name)

    async def picture(self, file: Path) -> None:
        """A picture of the whole page."""
        size = (await self.call("Page.getLayoutMetrics"))["cssContentSize"]
        shot = await self.call(
            "Page.captureScreenshot", captureBeyondViewport=True, clip=size | {"scale": 1}
        )
        file.write_bytes(base64.b64decode(shot["data"]))


@contextmanager
def _browser(directory: Path):
    """A browser's address of its pages."""
    flags = (
        "--headless=new",
        "--no-sandbox",
        "--disable-gpu",
        "--hide-scrollbars",
        "--no-first-run",
    )
    process = subprocess.Popen(
        [CHROMIUM, *flags, "--remote-debugging-port=0", "--window-size=1300,900",
         f"--user-data-dir={directory}", "about:blank"],
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip
    try:
        port = directory / "DevToolsActivePort"
        until = time.monotonic() + PATIENCE
        while not port.is_file() or not port.read_text().strip():
            assert process.poll() is None and time.monotonic() < until
            time.sleep(0.05)
        yield f"http://127.0.0.1:{port.read_text().split()[0]}"
    finally:
        process.kill()
        process.wait()


def browse(directory: Path, visit: Any) -> Any:
    """Start a browser with its files in a directory, and return what `visit`, a coroutine of a Page, does."""
    from tornado.httpclient import AsyncHTTPClient
    from tornado.websocket import websocket_connect

    async def visited(address: str) -> Any:
        answer = await AsyncHTTPClient().fetch(f"{address}/json")
        (target,) = [one for one in json.loads(answer.body) if one["type"] == "page"]
        socket = await websocket_connect(target["webSocketDebuggerUrl"], max_message_size=2**28)
        return await visit(Page(socket))

    with _browser(directory) as address:
        return asyncio.run(visited(address))
