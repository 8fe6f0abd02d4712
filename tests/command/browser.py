"""Evaluates JavaScript on a page in headless Chromium, over the pipe of its debugging protocol."""

import fcntl
import json
import os
import subprocess


class Browser:
    """A browser with one page; `errors` holds the errors of the page's console."""

    def __init__(self, program, folder):
        to_browser, self._to = os.pipe()
        self._from, from_browser = os.pipe()

        def place():
            # The browser reads descriptor 3 and writes 4; neither end may be overwritten by these.
            ends = [fcntl.fcntl(end, fcntl.F_DUPFD, 10) for end in (to_browser, from_browser)]
            for end, number in zip(ends, (3, 4)):
                os.dup2(end, number)

        self._process = subprocess.Popen(
            [program, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
             f"--user-data-dir={folder}", "--remote-debugging-pipe", "about:blank"],
            preexec_fn=place, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self._held = b""
        self._count = 0
        self.errors = []
        target = next(one for one in self._ask("Target.getTargets")["targetInfos"]
                      if one["type"] == "page")
        self._session = self._ask("Target.attachToTarget", targetId=target["targetId"],
                                  flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self._ask(domain + ".enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._session = None
        self._ask("Browser.close")
        self._process.wait(timeout=30)

    _session = None

    def _read(self):
        while b"\0" not in self._held:
            part = os.read(self._from, 1 << 20)
            if not part:
                raise EOFError("the browser has gone")
            self._held += part
        message, _, self._held = self._held.partition(b"\0")
        return json.loads(message)

    def _note(self, event):
        what, told = event.get("method"), event.get("params", {})
        if what == "Runtime.exceptionThrown":
            self.errors.append(told["exceptionDetails"].get("exception", {}).get("description", "?"))
        elif what == "Log.entryAdded" and told["entry"]["level"] in ("error", "warning"):
            self.errors.append(told["entry"]["text"])
        elif what == "Runtime.consoleAPICalled" and told["type"] in ("error", "warning", "assert"):
            self.errors.append(str(told["args"]))
        return what

    def _ask(self, what, **told):
        self._count += 1
        question = {"id": self._count, "method": what, "params": told}
        if self._session:
            question["sessionId"] = self._session
        os.write(self._to, json.dumps(question).encode() + b"\0")
        while True:
            answer = self._read()
            self._note(answer)
            if answer.get("id") == self._count:
                if "error" in answer:
                    raise RuntimeError(f"{what}: {answer['error']['message']}")
                return answer["result"]

    def window(self, width=1280, height=800, dark=False):
        self._ask("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=False)
        self._ask("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def open(self, address, **window):
        self.window(**window)
        self._ask("Page.navigate", url=address)
        while self._note(self._read()) != "Page.loadEventFired":
            pass

    def value(self, expression):
        """The value of an expression, or of the promise that it returns."""
        told = self._ask("Runtime.evaluate", expression=expression, awaitPromise=True,
                         returnByValue=True)
        if "exceptionDetails" in told:
            raise RuntimeError(told["exceptionDetails"]["exception"].get("description"))
        return told["result"].get("value")

    def mouse(self, *places, shift=False):
        """Presses the mouse at the first place of the window, moves it over the others and lets go."""
        told = {"button": "left", "buttons": 1, "clickCount": 1, "modifiers": 8 if shift else 0}
        for what, place in [("mousePressed", places[0]), *(("mouseMoved", one) for one in places[1:]),
                            ("mouseReleased", places[-1])]:
            self._ask("Input.dispatchMouseEvent", type=what, x=place[0], y=place[1], **told)

    def wheel(self, place, down):
        self._ask("Input.dispatchMouseEvent", type="mouseWheel", x=place[0], y=place[1], deltaX=0,
                  deltaY=down)

    def touch(self, *moments):
        """Puts fingers at the places of the first moment, moves them to those of the others and lifts
        them."""
        for what, places in [("touchStart", moments[0]), *(("touchMove", one) for one in moments[1:]),
                             ("touchEnd", [])]:
            self._ask("Input.dispatchTouchEvent", type=what,
                      touchPoints=[{"x": x, "y": y, "id": place} for place, (x, y) in enumerate(places)])

    def key(self, name, **told):
        self.value(f"document.dispatchEvent(new KeyboardEvent('keydown', "
                   f"{json.dumps({'key': name, **told})}))")

    def picture(self):
        """A picture of the whole page, as PNG in base 64."""
        return self._ask("Page.captureScreenshot", captureBeyondViewport=True)["data"]
