#!/usr/bin/env python3
"""How long the window takes from an input to a changed pixel, on a screen in memory without a graphics card.

    bench/window.py [--program build/gaspard] [--repeat 15]

Starts Xvfb and the program, then pans the mesh, drags a field, drags the knob of the playback bar, and hovers over
a button while a large mesh is being solved. Each input is sent by XTEST; a part of the screen is read every 2 ms
until it differs. Prints the median and the slowest of each in milliseconds, and the CPU milliseconds of the program
per input. Then rotates globes and prints the frames per second. Needs Xvfb and python3-xlib.
"""
import argparse
import os
import statistics
import subprocess
import tempfile
import time

from Xlib import X, display
from Xlib.ext import xtest

SCREEN = ":97"
SIZE = (1400, 900)
SECONDS = 4.0  # for which frames are counted
POLL = 0.002  # seconds; reading without a rest would take a core from the program


class Window:
    """The program on a screen of its own."""

    def __init__(self, program, *arguments):
        self.folder = tempfile.TemporaryDirectory()
        environment = dict(os.environ, DISPLAY=SCREEN, HOME=self.folder.name, XDG_CONFIG_HOME=self.folder.name,
                           LIBGL_ALWAYS_SOFTWARE="1")
        self.screen = subprocess.Popen(["Xvfb", SCREEN, "-screen", "0", "%dx%dx24" % SIZE], stderr=subprocess.DEVNULL)
        time.sleep(1)
        self.program = subprocess.Popen([os.path.abspath(program), "--size", "%dx%d" % SIZE, *arguments],
                                        env=environment, cwd=self.folder.name, stderr=subprocess.DEVNULL)
        self.display = display.Display(SCREEN)
        self.root = self.display.screen().root
        time.sleep(4)  # fonts, first solve

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.program.terminate()
        self.program.wait()
        self.display.close()
        self.screen.terminate()
        self.screen.wait()
        self.folder.cleanup()

    def part(self, area):
        x, y, width, height = area
        return self.root.get_image(x, y, width, height, X.ZPixmap, 0xFFFFFFFF).data

    def move(self, x, y):
        xtest.fake_input(self.display, X.MotionNotify, x=x, y=y)
        self.display.sync()

    def button(self, down):
        """Goes down or up; a hand needs some time before it moves."""
        xtest.fake_input(self.display, X.ButtonPress if down else X.ButtonRelease, 1)
        self.display.sync()
        time.sleep(0.3)

    def key(self, name):
        code = self.display.keysym_to_keycode({"End": 0xFF57, "h": 0x68, "s": 0x73}[name])
        for kind in (X.KeyPress, X.KeyRelease):
            xtest.fake_input(self.display, kind, code)
        self.display.sync()

    def cpu(self):
        fields = open("/proc/%d/stat" % self.program.pid).read().rsplit(")", 1)[1].split()
        return 10.0 * (int(fields[11]) + int(fields[12]))  # ticks of 10 ms

    def cpu_of_threads(self):
        """Milliseconds of the threads that solve, and of all others."""
        solving = others = 0.0
        tasks = "/proc/%d/task" % self.program.pid
        for task in os.listdir(tasks):
            try:
                text = open("%s/%s/stat" % (tasks, task)).read()
            except FileNotFoundError:  # it has ended
                continue
            name, fields = text.split("(", 1)[1].rsplit(")", 1)
            used = 10.0 * (int(fields.split()[11]) + int(fields.split()[12]))
            solving, others = (solving + used, others) if name == "solver" else (solving, others + used)
        return solving, others

    def until_changed(self, area, act, patience=3.0):
        """Milliseconds from act() until the area of the screen differs; None if it does not."""
        before = self.part(area)
        start = time.perf_counter()
        act()
        while time.perf_counter() - start < patience:
            time.sleep(POLL)
            if self.part(area) != before:
                return 1000 * (time.perf_counter() - start)
        return None

    def until_still(self, area, rest=0.4):
        last, since = self.part(area), time.perf_counter()
        while time.perf_counter() - since < rest:
            time.sleep(POLL)
            now = self.part(area)
            if now != last:
                last, since = now, time.perf_counter()

    def frames_per_second(self, area, duration):
        """Of something that moves in the area."""
        last, frames, start = self.part(area), 0, time.perf_counter()
        while time.perf_counter() - start < duration:
            time.sleep(POLL)
            now = self.part(area)
            frames += now != last
            last = now
        return frames / (time.perf_counter() - start)


def measure(name, window, repeat, area, acts, settles=False):
    """With `settles`, each input waits until the area is still, as a mesh at rest is drawn once more, in full."""
    times, before = [], window.cpu()
    for i in range(repeat):
        if settles:
            window.until_still(area)
        took = window.until_changed(area, lambda: acts(i))
        if took is not None:
            times.append(took)
        time.sleep(0.15)
    if not times:
        print("%-44s nothing changed" % name)
        return
    print("%-44s median %4.0f ms, slowest %4.0f ms, CPU %4.0f ms, %d of %d" %
          (name, statistics.median(times), max(times), (window.cpu() - before) / repeat, len(times), repeat))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default="build/gaspard")
    parser.add_argument("--repeat", type=int, default=15)
    options = parser.parse_args()
    mesh = (330, 420, 560, 40)  # across the ring; small, as reading it takes time, too
    with Window(options.program) as window:
        window.move(600, 400), window.button(True)
        measure("pan, n = 60", window, options.repeat, mesh, lambda i: window.move(600 + 12 * (i % 2 + 1), 400 + i))
        window.button(False), window.key("h"), window.until_still(mesh)
        window.move(150, 323), window.button(True)  # the first number of the monitor
        measure("drag a value, n = 60, until it shows", window, options.repeat, (15, 313, 220, 22),
                lambda i: window.move(152 + 3 * i, 323))
        measure("drag a value, n = 60, until the mesh moves", window, options.repeat, mesh,
                lambda i: window.move(152 + 3 * (options.repeat - i), 323))
        window.button(False), window.until_still(mesh)
        window.move(800, 849), window.button(True)  # the knob of the playback bar
        measure("scrub, n = 60", window, options.repeat, mesh, lambda i: window.move(560 + 130 * (2 * i % 5), 849),
                settles=True)
        window.button(False), window.key("End")
    with Window(options.program, "--set", "domain.cells=240", "--set", "method.type=relaxation", "--set",
                "method.tolerance=1e-14", "--set", "method.max_iterations=1000000", "--set",
                "method.step_size=0.001") as window:
        measure("hover over a button while n = 240 is solved", window, options.repeat, (1100, 4, 290, 26),
                lambda i: window.move(1340 if i % 2 else 1250, 16))
    with Window(options.program, "plane-moving-ring", "--set", "domain.cells=120", "--set", "time.step=0.01") as window:
        window.until_still(mesh, rest=5)  # all 1000 time steps are recorded
        window.move(800, 849), window.button(True)
        measure("scrub, 1000 time steps, n = 120", window, options.repeat, mesh,
                lambda i: window.move(560 + 130 * (2 * i % 5) + i, 849), settles=True)
        window.button(False)
    with Window(options.program, "flow-live") as window:
        before = window.cpu_of_threads()
        rate = window.frames_per_second((330, 380, 240, 120), SECONDS)
        solving, picture = (a - b for a, b in zip(window.cpu_of_threads(), before))
        print("%-44s %.1f frames per second; CPU of a frame: %.1f ms to solve, %.1f ms for the picture" %
              ("flow and mesh, n = 60", rate, solving / (SECONDS * rate), picture / (SECONDS * rate)))
    globe = (500, 600, 200, 40)  # below the handles
    for scenario in ("sphere-x16", "sphere-cross"):
        with Window(options.program, scenario) as window:
            window.move(600, 60), window.until_still(globe), window.key("s"), time.sleep(1)
            print("%-44s %.1f frames per second" % ("spin, " + scenario, window.frames_per_second(globe, SECONDS)))


if __name__ == "__main__":
    main()
