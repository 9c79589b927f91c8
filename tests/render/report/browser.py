"""A headless Chromium for tests, spoken to through pipes in the DevTools protocol."""

from __future__ import annotations

import base64
import json
import os
import select
import shutil
import subprocess
from pathlib import Path
from types import TracebackType
from typing import Any, Dict, List, Mapping, Optional, Type

import pytest

__all__ = ["Browser", "Tab", "require_browser"]

# So long may a loaded machine take to answer [s]; nothing is asserted about it.
_PATIENCE = 60.0


def require_browser() -> str:
    """Find the browser, or skip the test."""
    for name in ("chromium", "chromium-browser", "google-chrome"):
        path = shutil.which(name)
        if path is not None:
            return path
    pytest.skip("no Chromium on this machine")


class Browser:
    """One process; leave the block to end it."""

    def __init__(self, folder: Path) -> None:
        to_read, self._to = os.pipe()
        self._from, to_write = os.pipe()
        flags = [
            "--headless=new",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-dev-shm-usage",
            "--disable-background-networking",
            "--disable-component-update",
            "--no-first-run",
            "--hide-scrollbars",
            "--remote-debugging-pipe",
            f"--user-data-dir={folder}",
        ]

        # The protocol is spoken on 3 and 4.
        self._process = subprocess.Popen(
            ["bash", "-c", f'exec "$0" "$@" 3<&{to_read} 4>&{to_write}', require_browser(), *flags, "about:blank"],
            pass_fds=(to_read, to_write),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(to_read)
        os.close(to_write)
        self._buffer = b""
        self._number = 0
        self.told: List[Dict[str, Any]] = []

    def __enter__(self) -> Browser:
        return self

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        try:
            self.call("Browser.close")
            self._process.wait(20.0)
        except (AssertionError, OSError, subprocess.TimeoutExpired):
            self._process.kill()
            self._process.wait()
        os.close(self._to)
        os.close(self._from)

    def call(self, method: str, session: Optional[str] = None, **parameters: Any) -> Dict[str, Any]:
        """Ask for something and give the answer; what is told meanwhile is kept in ``told``."""
        self._number += 1
        number = self._number
        message: Dict[str, Any] = {"id": number, "method": method, "params": parameters}
        if session is not None:
            message["sessionId"] = session
        content = json.dumps(message).encode("utf-8") + b"\0"
        while content:
            content = content[os.write(self._to, content) :]
        while True:
            answer = self._next()
            if answer.get("id") == number:
                assert "error" not in answer, f"{method}: {answer['error']}"
                result: Dict[str, Any] = answer["result"]
                return result
            self.told.append(answer)

    def wait_for(self, method: str, session: str) -> Mapping[str, Any]:
        """Wait until something is told; what was told before counts."""
        while True:
            for each in self.told:
                if each.get("method") == method and each.get("sessionId") == session:
                    self.told.remove(each)
                    return each
            self.told.append(self._next())

    def open(self, page: Path, width: int = 1440, height: int = 900, scheme: str = "light", hash_: str = "") -> Tab:
        """Open a file in a tab of its own and wait until it is drawn."""
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        tab = Tab(self, session)
        for domain in ("Page", "Runtime", "Network", "Log"):
            tab.call(f"{domain}.enable")
        tab.size(width, height)
        tab.media(scheme)
        tab.call("Page.navigate", url=page.resolve().as_uri() + hash_)
        self.wait_for("Page.loadEventFired", session)
        tab.to_front()
        tab.settle()
        return tab

    def _next(self) -> Dict[str, Any]:
        while b"\0" not in self._buffer:
            ready, _, _ = select.select([self._from], [], [], _PATIENCE)
            assert ready, "the browser does not answer"
            piece = os.read(self._from, 1 << 20)
            assert piece, "the browser has ended"
            self._buffer += piece
        content, self._buffer = self._buffer.split(b"\0", 1)
        message: Dict[str, Any] = json.loads(content)
        return message


class Tab:
    """One page."""

    def __init__(self, browser: Browser, session: str) -> None:
        self._browser = browser
        self._session = session

    def call(self, method: str, **parameters: Any) -> Dict[str, Any]:
        """Ask for something."""
        return self._browser.call(method, self._session, **parameters)

    def to_front(self) -> None:
        """Put the page before all others: the browser draws no other one."""
        self.call("Page.bringToFront")

    def size(self, width: int, height: int) -> None:
        """Give the page a window of so many pixels."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def media(self, scheme: str) -> None:
        """Say which colours the system prefers."""
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])

    def settle(self) -> None:
        """Wait until what was asked of the page is drawn."""
        self.run("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(1))))")

    def run(self, script: str) -> Any:
        """Evaluate an expression in the page; promises are waited for."""
        answer = self.call("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        assert "exceptionDetails" not in answer, answer["exceptionDetails"]
        return answer["result"].get("value")

    def press(self, key: str, shift: bool = False) -> None:
        """Press a key where the focus is."""
        letter = {"text": key} if len(key) == 1 else {}
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, modifiers=8 if shift else 0, **letter)
            letter = {}
        self.settle()

    def mouse(self, kind: str, x: float, y: float, **more: Any) -> None:
        """Tell of the mouse: ``mouseMoved``, ``mousePressed``, ``mouseReleased``, ``mouseWheel``."""
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def click(self, x: float, y: float, count: int = 1) -> None:
        """Click once, or the last of several times."""
        self.mouse("mouseMoved", x, y)
        for number in range(1, count + 1):
            self.mouse("mousePressed", x, y, button="left", buttons=1, clickCount=number)
            self.mouse("mouseReleased", x, y, button="left", clickCount=number)
        self.settle()

    def drag(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        """Press at one place, let go at another."""
        self.mouse("mouseMoved", *start)
        self.mouse("mousePressed", *start, button="left", buttons=1, clickCount=1)
        for step in range(1, 5):
            x, y = (a + (b - a) * step / 4.0 for a, b in zip(start, end))
            self.mouse("mouseMoved", x, y, button="left", buttons=1)
        self.mouse("mouseReleased", *end, button="left", clickCount=1)
        self.settle()

    def told(self, method: str) -> List[Dict[str, Any]]:
        """List what the browser told of this page so far."""
        self.settle()
        return [
            each["params"]
            for each in self._browser.told
            if each.get("method") == method and each.get("sessionId") == self._session
        ]

    def complaints(self) -> List[str]:
        """List errors and warnings of any kind, and whatever the page asked a network or a file for."""
        found = [str(each) for each in self.told("Runtime.exceptionThrown")]
        found += [str(each) for each in self.told("Runtime.consoleAPICalled")]
        found += [str(each["entry"]) for each in self.told("Log.entryAdded")]
        found += [str(each) for each in self.told("Page.javascriptDialogOpening")]
        urls = [each["request"]["url"] for each in self.told("Network.requestWillBeSent")]
        return found + [url for url in urls[1:] if not url.startswith("data:")]

    def picture(self, path: Path, whole: bool = False) -> None:
        """Write a screenshot: of the window, or of the whole page in a window as high as that."""
        if whole:
            size = self.call("Page.getLayoutMetrics")["cssContentSize"]
            self.size(int(size["width"]), int(size["height"]))
            self.settle()
        data = self.call("Page.captureScreenshot", format="png")
        path.write_bytes(base64.b64decode(data["data"]))

    def paper(self, path: Path) -> None:
        """Write what would be printed, as PDF."""
        data = self.call("Page.printToPDF", printBackground=True, preferCSSPageSize=True)
        path.write_bytes(base64.b64decode(data["data"]))
