# SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A headless Chromium, driven through chromedriver by the W3C's WebDriver protocol."""

import base64
import json
import pathlib
import re
import shutil
import subprocess
import tempfile
import time
import urllib.error
import urllib.request

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

CHROMIUM = shutil.which("chromium")
DRIVER = shutil.which("chromedriver")
MISSING = "the page is not tested: Debian's packages chromium and chromium-driver are not installed"
ELEMENT = "element-6066-11e4-a52e-4f735466cecf"
FLAGS = ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--window-size=800,640", "--force-device-scale-factor=1",
         "--disable-background-networking", "--no-first-run")
SOFTWARE = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
WITHOUT_WEBGL = ("--disable-3d-apis",)


def pixels_of(png):
    """Rows from the top, columns, and red, green, blue."""
    with tempfile.NamedTemporaryFile(suffix=".png") as file:
        pathlib.Path(file.name).write_bytes(png)
        reader = vtkPNGReader()
        reader.SetFileName(file.name)
        reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3].astype(int)


class Browser:
    """One window. Use it in a with statement."""

    def __init__(self, *flags):
        self.driver = subprocess.Popen([DRIVER, "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, encoding="utf-8")
        self.address = None
        for line in self.driver.stdout:
            port = re.search(r"started successfully on port (\d+)", line)
            if port:
                self.address = f"http://127.0.0.1:{port.group(1)}"
                break
        options = {"binary": CHROMIUM, "args": [*FLAGS, *flags]}
        wanted = {"browserName": "chrome", "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"}}
        try:
            self.session = self.call("POST", "/session", {"capabilities": {"alwaysMatch": wanted}})["sessionId"]
        except BaseException:
            self.driver.kill()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.command("DELETE", "")
        finally:
            self.driver.kill()
            self.driver.wait()
            self.driver.stdout.close()

    def call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.address + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=60) as response:
                return json.load(response)["value"]
        except urllib.error.HTTPError as error:
            raise AssertionError(json.load(error)["value"]["message"]) from error

    def command(self, method, path, body=None):
        return self.call(method, f"/session/{self.session}{path}", body)

    def run(self, script, *arguments):
        """The value that the body of a function returns in the page."""
        return self.command("POST", "/execute/sync", {"script": script, "args": arguments})

    def protocol(self, name, **parameters):
        """A command of Chromium's own protocol."""
        return self.command("POST", "/goog/cdp/execute", {"cmd": name, "params": parameters})

    def open(self, path, state="ready"):
        """Waits for the state that the view says of itself."""
        self.command("POST", "/url", {"url": pathlib.Path(path).resolve().as_uri()})
        end = time.monotonic() + 60
        while (found := self.run("return document.documentElement.dataset.viewer")) != state:
            assert not found and time.monotonic() < end, f"the view is {found} and not {state}: {self.messages()}"
            time.sleep(0.05)

    def find(self, selector):
        return self.command("POST", "/element", {"using": "css selector", "value": selector})[ELEMENT]

    def is_shown(self, selector):
        return self.command("GET", f"/element/{self.find(selector)}/displayed")

    def text(self, selector):
        return self.command("GET", f"/element/{self.find(selector)}/text")

    def picture(self, selector):
        """What the page shows of an element, after the frame that is being drawn."""
        self.run("return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))")
        return pixels_of(base64.b64decode(self.command("GET", f"/element/{self.find(selector)}/screenshot")))

    def click(self, selector):
        self.command("POST", f"/element/{self.find(selector)}/click", {})

    def set(self, selector, value):
        """As a person does: the element tells of its new value."""
        self.run("const e = document.querySelector(arguments[0]); e.value = arguments[1];"
                 "e.dispatchEvent(new Event('input', { bubbles: true }));", selector, value)

    def point(self, selector, steps, kind="mouse"):
        """Actions of a pointer; positions are CSS pixels from the middle of the element."""
        origin = {ELEMENT: self.find(selector)}
        actions = []
        for step in steps:
            if isinstance(step, str):
                actions.append({"type": step, "button": 0})
            else:
                actions.append({"type": "pointerMove", "duration": 30, "x": step[0], "y": step[1], "origin": origin})
        source = {"type": "pointer", "id": kind, "parameters": {"pointerType": kind}, "actions": actions}
        self.command("POST", "/actions", {"actions": [source]})

    def resize(self, width, height):
        self.protocol("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def scroll(self, selector, amount):
        step = {"type": "scroll", "x": 0, "y": 0, "deltaX": 0, "deltaY": amount, "origin": {ELEMENT: self.find(selector)}}
        self.command("POST", "/actions", {"actions": [{"type": "wheel", "id": "wheel", "actions": [step]}]})

    def log(self, kind):
        return self.command("POST", "/se/log", {"type": kind})

    def messages(self):
        """What the page wrote to the console since the last call."""
        return [entry["message"] for entry in self.log("browser")]

    def requests(self):
        """Addresses that the page requested since the last call, without those that hold their content."""
        events = [json.loads(entry["message"])["message"] for entry in self.log("performance")]
        addresses = [event["params"]["request"]["url"] for event in events if event["method"] == "Network.requestWillBeSent"]
        return [address for address in addresses if not address.startswith(("data:", "blob:"))]


def drawn(pixels):
    """Where a picture of the stage shows a surface: darker than the background, which is nearly white."""
    return np.asarray(pixels).min(axis=2) < 225
