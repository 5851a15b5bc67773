"""Browsers without a window for the tests of pages: Chromium by its DevTools protocol over a pipe, Firefox by Marionette on the
loopback. Both have open(page), run(script that returns a value), canvas() (the picture of the view) and close()."""

import base64
import io
import json
import os
import shutil
import socket
import subprocess
import time

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-headless-shell") or shutil.which("google-chrome")
FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")
XVFB = shutil.which("xvfb-run")
PATIENCE = 120  # seconds until a view is ready
CANVAS = "return document.querySelector('#view canvas').toDataURL()"
READY = "return document.getElementById('view').dataset.ready === 'yes'"


class Browser:
    def show(self, page):
        """Opens a page with a view and waits until it is drawn."""
        self.open(page)
        end = time.monotonic() + PATIENCE
        while not self.run(READY):
            if time.monotonic() > end:
                raise RuntimeError(f"the view is not ready: {self.run('return document.querySelector(`#view .note`).textContent')}")
            time.sleep(0.1)

    def canvas(self):
        """[height][width][3] of 0 to 255, of what is drawn now."""
        import numpy as np
        from PIL import Image

        self.run("document.getElementById('view').viewer.drawNow()")
        text = self.run(CANVAS)
        return np.asarray(Image.open(io.BytesIO(base64.b64decode(text.split(",")[1]))).convert("RGB"), dtype=float)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


class Chromium(Browser):
    def __init__(self, folder, *options):
        to_browser, from_browser = os.pipe(), os.pipe()

        def connect():  # Chromium reads from 3 and writes to 4
            ends = os.dup(to_browser[0]), os.dup(from_browser[1])
            os.dup2(ends[0], 3)
            os.dup2(ends[1], 4)

        self.process = subprocess.Popen(
            [CHROMIUM, "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--remote-debugging-pipe",
             f"--user-data-dir={folder}/chromium", "--window-size=1000,900", *options, "about:blank"],
            preexec_fn=connect, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser[0])
        os.close(from_browser[1])
        self.to, self.from_ = os.fdopen(to_browser[1], "wb"), os.fdopen(from_browser[0], "rb")
        self.rest, self.number, self.session, self.events = b"", 0, None, []
        pages = [target for target in self.call("Target.getTargets")["targetInfos"] if target["type"] == "page"]
        self.session = self.call("Target.attachToTarget", targetId=pages[0]["targetId"], flatten=True)["sessionId"]
        self.call("Page.enable")
        self.call("Runtime.enable")
        self.call("Emulation.setDeviceMetricsOverride", width=1000, height=900, deviceScaleFactor=1, mobile=False)

    def read(self):
        while b"\0" not in self.rest:
            got = self.from_.read1(1 << 20)
            if not got:
                raise RuntimeError("Chromium has ended")
            self.rest += got
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def call(self, name, **arguments):
        self.number += 1
        message = {"id": self.number, "method": name, "params": arguments, **({"sessionId": self.session} if self.session else {})}
        self.to.write(json.dumps(message).encode() + b"\0")
        self.to.flush()
        while True:
            answer = self.read()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{name}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def open(self, page):
        self.events.clear()
        self.call("Page.navigate", url=f"file://{page}")
        while not any(event.get("method") == "Page.loadEventFired" for event in self.events):
            self.events.append(self.read())

    def run(self, script):
        done = self.call("Runtime.evaluate", expression=f"(() => {{{script}}})()", returnByValue=True)
        if "exceptionDetails" in done:
            raise RuntimeError(str(done["exceptionDetails"]))
        return done["result"].get("value")

    def errors(self):
        return [str(event["params"]["exceptionDetails"]) for event in self.events if event.get("method") == "Runtime.exceptionThrown"]

    def close(self):
        try:
            self.call("Browser.close")
        except (RuntimeError, OSError):
            pass
        self.process.wait(60)
        self.to.close()
        self.from_.close()


PREFERENCES = {"app.update.enabled": False, "browser.shell.checkDefaultBrowser": False, "datareporting.policy.dataSubmissionEnabled": False,
               "toolkit.telemetry.enabled": False, "network.captive-portal-service.enabled": False, "network.connectivity-service.enabled": False,
               "network.proxy.type": 1, "network.proxy.http": "127.0.0.1", "network.proxy.http_port": 9, "network.proxy.ssl": "127.0.0.1",
               "network.proxy.ssl_port": 9, "webgl.force-enabled": True}


class Firefox(Browser):
    """In a virtual display it draws with WebGL; without one it has none."""

    def __init__(self, folder, display=True):
        profile = os.path.join(folder, "firefox" + "_display" * display)
        os.makedirs(profile)
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        with open(os.path.join(profile, "user.js"), "w", encoding="utf-8") as file:
            for name, value in {**PREFERENCES, "marionette.port": port}.items():
                file.write(f"user_pref({json.dumps(name)}, {json.dumps(value)});\n")
        command = [FIREFOX, "--no-remote", "--marionette", "--profile", profile, "--width", "1000", "--height", "1000"]
        command = [XVFB, "-a", "-s", "-screen 0 1200x1100x24", *command] if display else [*command, "--headless"]
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                        env={**os.environ, "HOME": profile, "LIBGL_ALWAYS_SOFTWARE": "1"})
        self.number = 0
        self.connect(port)
        self.call("WebDriver:NewSession")
        self.call("WebDriver:SetWindowRect", width=1000, height=1000)

    def connect(self, port):
        end = time.monotonic() + PATIENCE
        while True:
            try:
                self.socket = socket.create_connection(("127.0.0.1", port))
                break
            except OSError:
                if time.monotonic() > end or self.process.poll() is not None:
                    raise RuntimeError("Firefox does not answer") from None
                time.sleep(0.1)
        self.stream = self.socket.makefile("rb")
        self.read()  # who it is

    def read(self):
        digits = b""
        while (letter := self.stream.read(1)) != b":":
            if not letter:
                raise RuntimeError("Firefox has ended")
            digits += letter
        return json.loads(self.stream.read(int(digits)))

    def call(self, name, **arguments):
        self.number += 1
        message = json.dumps([0, self.number, name, arguments]).encode()
        self.socket.sendall(str(len(message)).encode() + b":" + message)
        _, _, error, result = self.read()
        if error:
            raise RuntimeError(f"{name}: {error}")
        return result

    def open(self, page):
        self.call("WebDriver:Navigate", url=f"file://{page}")

    def run(self, script):
        # In the page's own world, which holds the viewer: `sandbox: null` is that of the test.
        wrapped = f"return window.eval({json.dumps('(() => {' + script + '})()')})"
        return self.call("WebDriver:ExecuteScript", script=wrapped, args=[], sandbox=None)["value"]

    def close(self):
        try:
            self.call("Marionette:Quit", flags=["eForceQuit"])
        except (RuntimeError, OSError):
            pass
        self.process.wait(60)
        self.stream.close()
        self.socket.close()
