"""The command line as a contract: exit codes, files, sentences. Usage: contract_test.py PROGRAM [unittest arguments]"""
import csv
import fcntl
import json
import os
import re
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time
import unittest
import xml.etree.ElementTree

PROGRAM = None
DOCS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs")
QUICK = ["--set", "domain.cells=12"]
ALL_FORMATS = "obj,glb,obj-curved,glb-curved,vtu,msh,ply,csv,ugrid,patch,svg,pdf"
PLANE_FORMATS = ALL_FORMATS.replace("patch,", "")


def gaspard(*arguments, cwd=None, environment=None, limit=None, timeout=120):
    def prepare():
        if limit is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
    return subprocess.run([PROGRAM, *arguments], cwd=cwd, env=environment, text=True, capture_output=True,
                          timeout=timeout, preexec_fn=prepare)

# A monitor that cannot be made at t = 0.06.
LATE_FAULT = ("--set", "method.type=newton", "--set", "time.end=0.1", "--set", "monitor.type=formula", "--set",
              "monitor.expression=1 + (t > 0.05 ? log(x - 0.3) : 0)")


class Contract(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.out = os.path.join(self.folder.name, "out")

    def tearDown(self):
        self.folder.cleanup()

    def path(self, name):
        return os.path.join(self.out, name)

    def bytes(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def summary(self):
        with open(self.path("summary.json")) as file:
            return json.load(file)

    def history(self):
        with open(self.path("history.csv")) as file:
            return list(csv.DictReader(file))

    def run_quick(self, *arguments, name="plane-ring", render=False, **options):
        drawing = [] if render else ["--no-render"]
        return gaspard("run", name, "--out", self.out, *drawing, *QUICK, *arguments, **options)

    def refused(self, result, *parts):
        """Exit code 2, one sentence that contains the parts, nothing on standard output, nothing written."""
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        for part in parts:
            self.assertIn(part, result.stderr)
        self.assertFalse(os.path.exists(self.out), "something was written")


class Runs(Contract):
    def test_the_summary_tells_what_a_method_did(self):
        result = self.run_quick("--set", "method.type=auto")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(self.summary()["note"].startswith("1: starting with accelerated relaxation"), self.summary()["note"])

    def test_converges_and_writes_every_file(self):
        result = self.run_quick(render=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(set(os.listdir(self.out)), {"summary.json", "history.csv", "computational.obj", "adapted.obj",
                                                     "adapted.glb", "state.bin", "view.png"})
        summary = self.summary()
        self.assertEqual(set(summary), {
            "scenario", "modified", "domain", "monitor", "method", "cells", "unknowns", "status", "iterations", "residual",
            "equidistribution", "theta", "tangled_cells", "min_jacobian", "max_jacobian", "exact_rms", "exact_rms_nodes",
            "cell_quality", "interpolation", "setup_seconds", "solve_seconds", "cpu_seconds", "seconds_per_iteration", "peak_memory_bytes", "version",
            "inner_iterations", "note"})
        self.assertEqual(summary["status"], "converged")
        self.assertEqual((summary["scenario"], summary["modified"]), ("plane-ring", ["domain.cells"]))
        self.assertEqual(summary["cells"], 144)
        self.assertEqual(summary["unknowns"], 576)
        self.assertLess(summary["residual"], 1e-8)
        self.assertIsNone(summary["exact_rms"])
        history = self.history()
        self.assertEqual(list(history[0]), ["iteration", "residual", "equidistribution", "exact_rms", "min_jacobian",
                                            "tangled_cells", "step_size", "seconds", "inner_iterations", "note"])
        self.assertEqual(len(history), summary["iterations"] + 1)
        self.assertEqual(float(history[-1]["residual"]), summary["residual"])
        seconds = [float(row["seconds"]) for row in history]
        self.assertEqual(seconds, sorted(seconds))
        with open(self.path("adapted.obj")) as file:
            lines = file.read().splitlines()
        self.assertEqual(sum(line.startswith("v ") for line in lines), 13 * 13)
        self.assertEqual(sum(line.startswith("f ") for line in lines), 144)

    def test_default_folder_is_named_after_the_scenario(self):
        result = gaspard("run", "plane-bell", "--no-render", "--quiet", *QUICK, cwd=self.folder.name)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        self.assertTrue(os.path.exists(os.path.join(self.folder.name, "gaspard-out", "plane-bell", "summary.json")))

    def test_files_of_another_run_are_not_replaced(self):
        self.assertEqual(self.run_quick("--set", "monitor.amplitude=2").returncode, 0)
        before = {name: self.bytes(name) for name in os.listdir(self.out)}
        result = self.run_quick(name="plane-bell")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        for part in (self.out, "'plane-ring'", "--out", "--overwrite"):
            self.assertIn(part, result.stderr)
        self.assertEqual({name: self.bytes(name) for name in os.listdir(self.out)}, before)
        result = self.run_quick()
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("replace those of a run with other values", result.stdout)
        open(self.path("view.png"), "w").close()
        result = self.run_quick("--formats", "csv")
        self.assertEqual(set(os.listdir(self.out)), {*before, "adapted.csv", "view.png"}, "of the same values")
        result = self.run_quick("--formats", "csv", "--set", "monitor.amplitude=2")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(set(os.listdir(self.out)), {*before, "adapted.csv", "view.png"}, "nothing is lost")
        self.assertIn("not of this run, but left there: ", result.stdout)
        for name in ("view.png", "adapted.obj"):
            self.assertIn(name, result.stdout)
        self.assertEqual(self.run_quick().returncode, 0)
        result = self.run_quick()
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotIn("replace", result.stdout)
        self.assertEqual(self.run_quick("--overwrite", name="plane-bell").returncode, 0)
        self.assertEqual((self.summary()["scenario"], self.summary()["monitor"]["type"]), ("plane-bell", "bell"))
        # Files that no run wrote, of the names that it would write.
        os.remove(self.path("summary.json"))
        result = self.run_quick(name="plane-bell")
        self.assertEqual(result.returncode, 2)
        self.assertIn("history.csv", result.stderr)
        for name in os.listdir(self.out):
            os.remove(self.path(name))
        with open(self.path("notes.txt"), "w") as file:
            file.write("no file of a run")
        self.assertEqual(self.run_quick(name="plane-bell").returncode, 0)

    def test_the_summary_lists_what_was_modified(self):
        for settings, modified in (([], ["domain.cells"]),
                                   (["--set", "monitor.type=constant", "--tolerance", "1e-6"],
                                    ["domain.cells", "monitor.type", "method.tolerance"]),
                                   (["--set", "domain.cells=60", "--set", "view.color=area"], [])):
            self.assertEqual(self.run_quick(*settings).returncode, 0)
            self.assertEqual((self.summary()["scenario"], self.summary()["modified"]), ("plane-ring", modified))

    def test_the_same_input_gives_the_same_bytes(self):
        names = ["computational.obj", "adapted.obj", "adapted.glb", "adapted.vtu", "adapted.msh", "adapted.ply",
                 "adapted.svg", "residual.svg", "equidistribution.svg", "state.bin", "view.png",
                 "computational-curved.obj", "adapted-curved.obj", "adapted-curved.glb", "computational.ugrid.nc",
                 "adapted.ugrid.nc"]
        formats = ("--formats", PLANE_FORMATS)
        self.run_quick(*formats, render=True)
        first = {name: self.bytes(name) for name in names}
        self.run_quick(*formats, "--threads", "2", render=True)
        for name in names:
            self.assertEqual(first[name], self.bytes(name), name)

    def test_statuses_have_their_exit_codes(self):
        self.assertEqual(self.run_quick("--max-iterations", "3").returncode, 3)
        self.assertEqual(self.summary()["status"], "iteration-limit")
        for step in ("0.8", "2", "5", "10"):
            self.assertEqual(self.run_quick("--set", "method.step_size=" + step).returncode, 4)
            self.assertIn(self.summary()["status"], ("diverged", "tangled"))
        self.assertEqual(self.run_quick("--tolerance", "1e-14", "--set", "domain.cells=32", "--set",
                                        "monitor.amplitude=2", "--set", "monitor.sharpness=20").returncode, 5)
        self.assertEqual(self.summary()["status"], "stalled")

    def test_all_commands_count_the_iterations_of_time_steps(self):
        moving = ("--set", "domain.cells=16", "--set", "monitor.sharpness=60", "--set", "method.type=newton", "--set", "time.end=0.1", "--set",
                  "time.rule=tolerance", "--set", "time.monitor.center_x=center_x + t/2", "--no-render", "--out")

        def rows(folder, name):
            with open(os.path.join(folder, name)) as file:
                return list(csv.DictReader(file))
        self.assertEqual(gaspard("run", "plane-ring", *moving, self.out).returncode, 0)
        history = rows(self.out, "history.csv")
        of_steps = [int(row["step_iterations"]) for row in history if row["step_iterations"]]
        count = len(history) - 1 - len(of_steps) + sum(of_steps)
        self.assertGreater(count, len(history) - 1)
        self.assertEqual(self.summary()["iterations"], count)
        for command, arguments, file in (("study", ("--over", "domain.cells=16"), "study.csv"),
                                         ("why", ("--cells", "16"), "why.csv"),
                                         ("compare", ("--methods", "newton"), "comparison.csv")):
            folder = self.out + "-" + command
            self.assertEqual(gaspard(command, "plane-ring", *arguments, *moving, folder).returncode, 0, command)
            self.assertEqual(int(float(rows(folder, file)[0]["iterations"])), count, command)

    def test_a_monitor_that_cannot_be_made_later_keeps_the_results_before(self):
        result = self.run_quick(*LATE_FAULT)
        self.assertEqual(result.returncode, 2, result.stderr)
        summary = self.summary()
        self.assertEqual(summary["status"], "invalid-input")
        self.assertIn("invalid-input at t = 0.04 after 2 time steps", result.stdout)
        with open(os.path.join(self.out, "history.csv")) as file:
            self.assertEqual(float(list(csv.DictReader(file))[-1]["time"]), 0.04)
        self.assertIn("at t = 0.06", summary["note"])
        self.assertTrue(self.bytes("adapted.obj"))
        sentence = "at t = 0.06"
        again = self.run_quick("--quiet", "--overwrite", *LATE_FAULT)
        self.assertEqual((again.returncode, again.stdout), (2, ""))
        self.assertIn(sentence, again.stderr)
        for command, arguments, code in (("study", ("--over", "domain.cells=8"), 2), ("why", ("--cells", "8"), 2),
                                         ("compare", ("--methods", "newton"), 0)):
            result = gaspard(command, "plane-ring", "--no-render", *LATE_FAULT, *arguments, "--out",
                             self.out + "-" + command)
            self.assertEqual(result.returncode, code, result.stdout + result.stderr)
            self.assertIn(sentence, result.stdout, command)
        film = gaspard("record", "plane-ring", *LATE_FAULT, "--set", "domain.cells=8", "--formats", "csv", "--out",
                       self.out + "-film")
        self.assertEqual(film.returncode, 2)
        self.assertIn(sentence, film.stderr)
        with open(os.path.join(self.out + "-film", "trajectories.csv")) as file:
            self.assertEqual({float(row["time"]) for row in csv.DictReader(file)}, {0, 0.02, 0.04})

    def start(self, *settings, **options):
        """A run in the background, once it blocks signals and has computed for half a second."""
        process = subprocess.Popen([PROGRAM, "run", "plane-ring", "--out", self.out, "--no-render", "--set",
                                    "domain.cells=60", *settings], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True, **options)
        ticks = os.sysconf("SC_CLK_TCK")
        while process.poll() is None:
            with open("/proc/%d/status" % process.pid) as status, open("/proc/%d/stat" % process.pid) as stat:
                blocked = int(re.search(r"SigBlk:\s*(\w+)", status.read()).group(1), 16)
                used = int(stat.read().rsplit(")", 1)[1].split()[11]) / ticks
            if blocked >> (signal.SIGTERM - 1) & 1 and used > 0.5:
                break
            time.sleep(0.02)
        return process

    def test_a_signal_ends_a_program_that_waits_for_its_input(self):
        def prepare():
            for stop in (signal.SIGINT, signal.SIGTERM):
                signal.signal(stop, signal.SIG_DFL)
        for command in (["run", "-"], ["compare", "-"], ["-"]):
            for stop in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(command=command, stop=stop):
                    process = subprocess.Popen([PROGRAM, *command], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                               stderr=subprocess.PIPE, preexec_fn=prepare, cwd=self.folder.name)
                    process.stdin.write(b"# more follows\n")
                    process.stdin.flush()
                    left = b"1"
                    while process.poll() is None and any(left):  # until it has read that
                        time.sleep(0.02)
                        left = fcntl.ioctl(process.stdin, termios.FIONREAD, bytes(4))
                    process.send_signal(stop)
                    try:
                        self.assertIn(process.wait(timeout=20), (130, -stop))
                    finally:
                        process.kill()
                        process.communicate()

    def test_what_was_not_measured_is_not_printed(self):
        for level, printed in (("full", True), ("geometry", False), ("none", False)):
            result = self.run_quick("--set", "method.diagnostics=" + level)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual("equidistribution" in result.stdout, printed, result.stdout)
            self.assertIn(", 0 tangled cells, ", result.stdout)

    def test_an_interrupted_run_keeps_what_there_is(self):
        for stop in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(stop=stop):
                process = self.start("--set", "method.step_size=0.0005", "--set", "method.max_iterations=1000000",
                                     preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL))
                process.send_signal(stop)
                out, err = process.communicate(timeout=60)
                self.assertEqual(process.returncode, 130, err)
                self.assertEqual(self.summary()["status"], "interrupted")
                self.assertEqual(len(self.history()), self.summary()["iterations"] + 1)
                self.assertGreater(self.summary()["iterations"], 0)

    def test_a_run_goes_on_after_its_terminal_if_nohup_started_it(self):
        process = self.start("--set", "method.step_size=0.0005", "--set", "method.max_iterations=3000",
                             preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        process.send_signal(signal.SIGHUP)
        out, err = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 3, err)
        self.assertEqual(self.summary()["status"], "iteration-limit")

    def test_start_goes_on_from_a_state(self):
        self.assertEqual(self.run_quick("--max-iterations", "40").returncode, 3)
        before = self.summary()["residual"]
        state = os.path.join(self.folder.name, "state.bin")
        os.rename(self.path("state.bin"), state)
        self.assertEqual(self.run_quick("--start", state).returncode, 0)
        self.assertEqual(float(self.history()[0]["residual"]), before)

    def test_diagnostics_every_leaves_gaps_but_not_at_the_end(self):
        self.run_quick("--set", "method.diagnostics_every=10")
        history = self.history()
        self.assertEqual(history[1]["equidistribution"], "")
        self.assertNotEqual(history[10]["equidistribution"], "")
        self.assertNotEqual(history[-1]["equidistribution"], "")

    def test_a_patch_that_was_written_is_a_domain(self):
        points = "domain.control_points=0 0, 2 0, 0 1, 2 1.5"
        square = json.dumps({"degrees": [1, 1], "knots": [[0, 0, 1, 1]] * 2,
                             "control_points": [[0, 0], [1, 0], [0, 1], [1, 1]]})
        chosen = ("--set", "domain.type=spline-patch", "--set", "domain.cells=12", "--set", "domain.file=" + square)
        result = gaspard("run", "spline-circle", "--out", self.out, "--no-render", "--quiet", "--formats", "patch",
                         *chosen, "--set", points)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        with open(self.path("adapted-patch.json")) as file:
            patch = json.load(file)
        self.assertEqual(patch["degrees"], [3, 3])
        for corner, place in ((0, [0, 0]), (-1, [2, 1.5])):
            for had, wanted in zip(patch["control_points"][corner], place):
                self.assertAlmostEqual(had, wanted, places=2)
        for name in ("adapted-patch.json", "adapted-patch.xml"):
            again = gaspard("run", "spline-circle", "--out", os.path.join(self.out, "again"), "--no-render", "--quiet",
                            "--formats", "obj", *chosen, "--set", "domain.file=" + self.path(name),
                            "--set", "monitor.type=constant")
            self.assertEqual((again.returncode, again.stderr), (0, ""))
        shutil.rmtree(self.out)
        self.refused(gaspard("run", "spline-circle", "--out", self.out, *chosen, "--set", "domain.control_points=1 2"),
                     "lists 1 points, but the patch has 4")
        self.refused(gaspard("run", "spline-circle", "--out", self.out, *chosen, "--set", "domain.control_points=1, 2"),
                     "points of two numbers")

    def test_formats_and_size(self):
        result = self.run_quick("--formats", "obj", "--size", "320x240", render=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertFalse(os.path.exists(self.path("adapted.glb")))
        with open(self.path("view.png"), "rb") as file:
            header = file.read(24)
        self.assertEqual((int.from_bytes(header[16:20], "big"), int.from_bytes(header[20:24], "big")), (320, 240))

    def test_every_format_and_its_xml(self):
        with_pictures = {"adapted.svg", "residual.svg", "equidistribution.svg"}
        result = self.run_quick("--formats", "vtu,msh,ply,svg")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(set(os.listdir(self.out)), {"summary.json", "history.csv", "state.bin", "adapted.vtu",
                                                     "adapted.msh", "adapted.ply"} | with_pictures)
        piece = xml.etree.ElementTree.parse(self.path("adapted.vtu")).find("UnstructuredGrid/Piece")
        self.assertEqual((piece.get("NumberOfPoints"), piece.get("NumberOfCells")), ("169", "144"))
        for name in with_pictures:
            self.assertTrue(xml.etree.ElementTree.parse(self.path(name)).getroot().tag.endswith("}svg"))
        self.assertIn(b">monitor<", self.bytes("adapted.svg"))
        with open(self.path("adapted.msh")) as file:
            msh = file.read()
        for part in ('1 2 "left"', '1 5 "top"', "$Periodic"):  # plane-ring is periodic
            self.assertIn(part, msh)
        result = self.run_quick("--formats", "msh,svg", "--set", "view.color=area", "--overwrite", name="walls-ring")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(b">cell area<", self.bytes("adapted.svg"))
        with open(self.path("adapted.msh")) as file:
            self.assertNotIn("$Periodic", file.read())

    def test_a_scenario_file_works_like_a_name(self):
        file = os.path.join(self.folder.name, "mine.toml")
        with open(file, "w") as toml:
            toml.write(gaspard("show", "plane-ring", "--set", "domain.cells=8").stdout)
        result = gaspard("run", file, "--out", self.out, "--no-render")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.summary()["cells"], 64)
        self.assertEqual(self.summary()["scenario"], "mine")


class BadInput(Contract):
    def test_whatever_is_typed_the_error_is_one_line_that_can_be_read(self):
        self.refused(self.run_quick("--set", "monitor.type=bell\ncells=3"), "bell cells=3")
        result = self.run_quick("--set", "monitor.\x1b[31m=" + 50000 * "k")
        self.refused(result, "monitor.")
        self.assertNotIn("\x1b", result.stderr)
        self.assertLess(len(result.stderr), 1200)

    def test_cameras_too_close_for_an_svg_and_unknown_backends(self):
        close = "view.camera=centre 0.5 0.5 height 1e-6"
        self.refused(self.run_quick("--formats", "svg", "--set", close), "too small for an SVG")
        os.environ["GASPARD_OFFSCREEN"] = "nonsense"
        try:
            self.refused(self.run_quick(render=True), "GASPARD_OFFSCREEN")
        finally:
            del os.environ["GASPARD_OFFSCREEN"]

    def test_values_out_of_range(self):
        self.refused(self.run_quick("--set", "domain.cells=0"), "domain.cells = 0", "4 to 480")
        self.refused(self.run_quick("--set", "domain.cells=1000000000"), "4 to 480")
        self.refused(self.run_quick("--set", "monitor.amplitude=nan"), "finite")
        self.refused(self.run_quick("--set", "monitor.amplitude=-2"), "monitor.amplitude", "must exceed -1")
        self.refused(self.run_quick("--set", "domain.cells=1.5"), "an integer")
        self.refused(self.run_quick("--tolerance", "0"), "method.tolerance")
        self.refused(self.run_quick("--tolerance", "nan"), "method.tolerance")
        self.refused(self.run_quick("--max-iterations", "-1"), "method.max_iterations")
        self.refused(self.run_quick("--threads", "0"), "--threads")
        self.refused(self.run_quick("--size", "10x10"), "view.width")
        self.refused(self.run_quick("--set", "output.curve_tolerance=0"), "output.curve_tolerance = 0", "10⁻⁵ to 0.1")
        self.refused(self.run_quick("--set", "view.camera=from afar"), "the camera 'from afar' has the word 'from'")
        self.refused(self.run_quick("--set", "view.pick=edge 3"), "neither a cell nor a node")
        self.refused(self.run_quick("--set", "view.cut=x 0.5 and"), "view.cut = 'x 0.5 and' must be planes")
        self.refused(self.run_quick("--set", "view.only=jacobian"), "view.only = 'jacobian' must be conditions")
        self.refused(self.run_quick("--set", "view.layers=i 2"), "view.layers is only for meshes whose cells are a lattice")
        self.refused(self.run_quick("--set", "view.pick=cell 144"), "the mesh has 144 cells")
        self.refused(self.run_quick("--set", "view.range=fixed", "--set", "view.low=2"), "below view.high = 1")
        self.refused(gaspard("plane-ring", "--set", "view.camera=from afar"), "the camera 'from afar'")
        self.refused(self.run_quick("--size", "big"), "--size must be")

    def test_unknown_names_get_the_nearest(self):
        self.refused(self.run_quick("--set", "monitor.amplitud=3"), "'monitor.amplitude'")
        self.refused(self.run_quick("--set", "monitor.type=rong"), "'ring'")
        self.refused(self.run_quick(name="plane-rin"), "'plane-ring'")
        self.refused(self.run_quick("--formats", "obj,gld"), "'glb'")
        self.refused(self.run_quick("--formats", "obj,"), "between commas")
        self.refused(self.run_quick("--formats", "obj,patch"), "requires a spline patch")
        self.refused(gaspard("list", "monitor"), "'monitors'")
        self.refused(gaspard("reproduce", "mcrae-fig20", "--out", self.out), "'mcrae-fig2'")
        self.refused(gaspard("show", "plane-bel"), "'plane-bell'")

    def test_usage(self):
        self.refused(gaspard("run"), "SCENARIO")
        self.refused(gaspard("run", "plane-ring", "--nonsense"), "--nonsense")
        self.refused(self.run_quick("--set", "domain.cells"), "key=value")
        self.refused(self.run_quick("--max-iterations", "many"), "many")
        self.refused(self.run_quick("--seed", "3"), "random")
        self.refused(self.run_quick("--set", "monitor.type=random-bells", "--seed", "-1"), "monitor.seed")
        self.refused(self.run_quick("--set", "pde.epsilon=1"), "reserved")

    def test_broken_toml_names_the_line(self):
        file = os.path.join(self.folder.name, "broken.toml")
        with open(file, "w") as toml:
            toml.write("[domain]\ncells = \n")
        self.refused(gaspard("run", file, "--out", self.out), "broken.toml:2")
        self.refused(gaspard("run", os.path.join(self.folder.name, "none.toml"), "--out", self.out), "none.toml")

    def test_an_unwritable_folder_is_found_before_solving(self):
        blocker = os.path.join(self.folder.name, "file")
        open(blocker, "w").close()
        begin = time.monotonic()
        result = gaspard("run", "plane-bell", "--out", os.path.join(blocker, "below"), "--set", "domain.cells=200")
        self.refused(result, blocker)
        self.assertLess(time.monotonic() - begin, 2, "it was solved first")
        self.refused(gaspard("run", "plane-ring", "--out", "/proc/gaspard"), "/proc/gaspard")

    def test_a_state_that_does_not_fit(self):
        state = os.path.join(self.folder.name, "state.bin")
        with open(state, "wb") as file:
            file.write(b"nothing of the kind")
        self.refused(self.run_quick("--start", state), "state.bin")
        self.refused(self.run_quick("--start", state + "x"), "state.binx")
        elsewhere = os.path.join(self.folder.name, "walls")
        gaspard("run", "walls-ring", "--no-render", "--out", elsewhere, *QUICK)
        self.refused(self.run_quick("--start", os.path.join(elsewhere, "state.bin")), "plane walls")

    def test_arguments_before_a_command_are_not_swallowed(self):
        self.refused(gaspard("--set", "domain.cells=8", "run", "plane-ring", "--out", self.out), "goes after")
        self.refused(gaspard("plane-ring", "list"), "goes after")

    def test_an_empty_scenario_file_is_all_defaults(self):
        file = os.path.join(self.folder.name, "empty.toml")
        open(file, "w").close()
        self.assertEqual(gaspard("show", file).returncode, 0)


class Machine(Contract):
    def test_a_full_disk_is_one_sentence_and_leaves_nothing_half_written(self):
        result = self.run_quick("--formats", PLANE_FORMATS, limit=2000)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        self.assertIn("File too large", result.stderr)
        for name in os.listdir(self.out):
            self.assertLessEqual(os.path.getsize(self.path(name)), 2000)
            self.assertNotIn("tmp", name)
        if os.path.exists(self.path("summary.json")):
            self.summary()

    def test_one_file_that_fails_does_not_keep_the_others(self):
        few = ["--max-iterations", "5"]  # so that history.csv, which has times in it, is small
        self.assertEqual(self.run_quick("--formats", "msh,svg", *few).returncode, 3)
        sizes = {name: os.path.getsize(self.path(name)) for name in os.listdir(self.out)}
        shutil.rmtree(self.out)
        largest = max(sizes, key=sizes.get)
        others = set(sizes) - {largest}
        result = self.run_quick("--formats", "msh,svg", *few, limit=max(sizes[name] for name in others) + 100)
        self.assertEqual(result.returncode, 1)
        self.assertIn(largest, result.stderr)
        self.assertEqual(set(os.listdir(self.out)), others)

    def test_netcdf_fails_like_every_other_format(self):
        few = ["--max-iterations", "5"]
        self.assertEqual(self.run_quick("--formats", "ugrid,obj", *few).returncode, 3)
        sizes = {name: os.path.getsize(self.path(name)) for name in os.listdir(self.out)}
        shutil.rmtree(self.out)
        least = min(sizes["computational.ugrid.nc"], sizes["adapted.ugrid.nc"])
        larger = {name for name, size in sizes.items() if size >= least}
        result = self.run_quick("--formats", "ugrid,obj", *few, limit=least - 1)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        self.assertIn("computational.ugrid.nc", result.stderr)
        self.assertEqual(set(os.listdir(self.out)), set(sizes) - larger)

    def test_a_folder_where_a_file_would_be_written_is_found_before_solving(self):
        def check(name, *command):
            os.makedirs(self.path(name))
            result = gaspard(*command, "--out", self.out)
            self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
            self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
            self.assertIn(self.path(name) + " is a folder", result.stderr)
            self.assertEqual(os.listdir(self.out), [name])
            shutil.rmtree(self.out)
        for name in ("summary.json", "adapted.glb", "view.png"):
            for more in ([], ["--overwrite"]):
                check(name, "run", "plane-ring", "--set", "domain.cells=400", *more)
        check("newton.csv", "compare", "plane-ring", "--set", "domain.cells=400", "--methods", "auto,newton")
        check("mcrae-fig11.csv", "reproduce", "mcrae-fig11")

    def test_a_signal_while_files_are_written_ends_it_after_one_of_them(self):
        formats = "obj,vtu,msh,ply,ugrid,svg"
        process = subprocess.Popen([PROGRAM, "run", "plane-ring", "--out", self.out, "--no-render", "--formats", formats,
                                    "--set", "domain.cells=300", "--max-iterations", "1"], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        while process.poll() is None and not os.path.exists(self.path("summary.json")):
            time.sleep(0.002)
        process.send_signal(signal.SIGTERM)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, err)
        self.assertEqual(len(err.strip().splitlines()), 1, err)
        self.assertIn("interrupted while files were written", err)
        names = os.listdir(self.out)
        self.assertNotIn("adapted.svg", names)
        self.assertEqual([name for name in names if "tmp" in name], [])
        self.summary()

    def test_a_large_image_takes_a_bounded_memory(self):
        process = subprocess.Popen([PROGRAM, "run", "plane-ring", "--out", self.out, "--formats", "obj", "--quiet",
                                    "--size", "8192x4096", *QUICK], stderr=subprocess.PIPE, text=True)
        with process.stderr:
            self.assertEqual(process.stderr.read(), "")
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0)
        self.assertLess(usage.ru_maxrss, 1 << 20)  # KiB; in one piece it takes 1.6 GiB
        with open(self.path("view.png"), "rb") as file:
            self.assertEqual(struct.unpack(">II", file.read(24)[16:]), (8192, 4096))

    def test_a_standard_output_that_takes_nothing_is_noticed(self):
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROGRAM, "show", "plane-ring"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(result.returncode, 1)
        self.assertIn("standard output", result.stderr)

    def test_no_display_is_one_sentence(self):
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        result = gaspard("plane-ring", environment=environment)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        self.assertIn("display", result.stderr)
        self.refused(gaspard("plane-rng", environment=environment), "'plane-ring'")

    def test_no_opengl_still_writes_the_data(self):
        # Libraries of the right names that hold none of the functions stand before the real ones.
        empty = next(line.split()[2] for line in subprocess.run(["ldd", sys.executable], text=True, capture_output=True)
                     .stdout.splitlines() if "libm.so" in line)
        hidden = os.path.join(self.folder.name, "libraries")
        os.mkdir(hidden)
        for name in ("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", "libEGL.so.1", "libEGL.so"):
            shutil.copy(empty, os.path.join(hidden, name))
        environment = dict(os.environ, LD_LIBRARY_PATH=hidden)
        result = self.run_quick(render=True, environment=environment)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("OpenGL", result.stderr)
        self.assertEqual(self.summary()["status"], "converged")
        self.assertFalse(os.path.exists(self.path("view.png")))


class Information(Contract):
    def test_list_names_everything(self):
        text = gaspard("list").stdout
        for word in ("plane-ring", "plane-bell", "walls-ring", "plane", "ring", "bell", "constant", "relaxation", "obj",
                     "glb", "vtu", "msh", "ply", "svg", "ugrid", "output.curve_tolerance", "monitor.sharpness", "method.step_size"):
            self.assertIn(word, text)
        self.assertNotIn("relaxation", gaspard("list", "monitors").stdout)
        for key in ("time.end", "time.rule", "time.path", "time.monitor.KEY"):
            self.assertIn(key, gaspard("list", "time").stdout)

    def test_a_time_of_the_monitor_is_refused_where_time_passes(self):
        result = gaspard("show", "burgers-1d", "--set", "monitor.t=0.5")
        self.assertEqual(result.returncode, 2)
        self.assertIn("monitor.t goes from time.start to time.end and cannot be set; with time.end=0 no time passes",
                      result.stderr)
        still = gaspard("show", "burgers-1d", "--set", "monitor.t=0.5", "--set", "time.end=0")
        self.assertEqual((still.returncode, still.stderr), (0, ""))

    def test_one_time_step_is_one(self):
        result = gaspard("run", "plane-ring", "--set", "method.type=newton", "--set", "domain.cells=8", "--set",
                         "time.end=0.1", "--set", "time.step=0.1", "--set", "time.monitor.radius=0.25 - t/9",
                         "--no-render", "--out", os.path.join(self.folder.name, "one"))
        self.assertIn(" at t = 0.1 after 1 time step: ", result.stdout)

    def test_show_writes_a_monitor_as_a_formula(self):
        text = gaspard("show", "plane-bell", "--set", "monitor.amplitude=7", "--as-formula").stdout
        self.assertIn("expression = '1 + amplitude*sech(sharpness*dist(center_x, center_y)^2)^2'", text)
        self.assertIn("amplitude = 7.0", text)
        file = os.path.join(self.folder.name, "typed.toml")
        with open(file, "w") as toml:
            toml.write(text)
        self.assertEqual(gaspard("show", file).stdout, text)
        self.assertEqual(gaspard("show", file, "--as-formula").stdout, text)
        waves = gaspard("show", "spline-sine-waves", "--as-formula").stdout
        self.assertIn("+ amplitude*exp(-sharpness*abs(y - 0.25 - sin(2*pi*x)/4))'", waves)
        self.refused(gaspard("show", "plane-ring", "--set", "monitor.type=random-bells", "--as-formula"),
                     "'random-bells'")

    def test_a_wrong_formula_is_one_sentence(self):
        wrong = gaspard("run", "plane-ring", "--set", "monitor.type=formula", "--set", "monitor.expression=1 + sine(x)",
                        "--no-render")
        self.refused(wrong, "monitor.expression: unknown function 'sine' at character 5 (did you mean 'sin'?)")

    def test_show_refuses_formulas_and_files_that_run_refuses(self):
        for settings, part in ((("type=formula", "expression=1/0"), "is ∞ at (0, 0)"),
                               (("type=formula", "expression=0-1"), "is −1 at (0, 0)"),
                               (("type=image", "file=gone.png"), "gone.png"),
                               (("type=combine", "a.type=formula", "a.expression=log(x)"), "−∞")):
            options = [option for one in settings for option in ("--set", "monitor." + one)]
            for command in ("show", "run"):
                self.refused(gaspard(command, "plane-ring", *options, cwd=self.folder.name), part)

    def test_show_is_complete_and_reads_back(self):
        text = gaspard("show", "plane-ring", "--set", "monitor.amplitude=3").stdout
        self.assertIn("amplitude = 3.0", text)
        self.assertIn("max_iterations", text)
        file = os.path.join(self.folder.name, "again.toml")
        with open(file, "w") as toml:
            toml.write(text)
        self.assertEqual(gaspard("show", file).stdout, text)

    def test_show_says_whether_something_was_changed(self):
        for settings, ending in (([], ""), (["--set", "view.color=area"], ""), (["--set", "monitor.type=bell"], " (modified)"),
                                 (["--as-formula"], " (modified)")):
            title, description = gaspard("show", "plane-ring", *settings).stdout.splitlines()[:2]
            self.assertEqual(title, "title = 'Ring on the periodic plane%s'" % ending)
            self.assertRegex(description, r"^description = 'A ring .*\)%s'$" % re.escape(ending))

    def test_what_a_view_asks_for_in_vain_is_said(self):
        result = self.run_quick("--set", "view.overlay=exact", render=True)
        self.assertEqual(result.returncode, 0)
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        self.assertIn("view.overlay", result.stderr)

    def test_a_view_that_hides_a_whole_solid_says_so(self):
        result = gaspard("run", "spline-cube", "--set", "domain.cells=6", "--set", "monitor.type=constant", "--set", "view.cut=x -1",
                         "--no-render", "--formats", "ply", "--out", self.out)
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stderr, "gaspard: view.cut leaves nothing to see of the solid\n")
        self.assertTrue(os.path.exists(os.path.join(self.out, "adapted.ply")))

    def test_version_and_help(self):
        self.assertRegex(gaspard("--version").stdout, r"^gaspard \d+\.\d+\.\d+\n$")
        self.assertIn("reproduce", gaspard("--help").stdout)
        self.assertIn("--tolerance", gaspard("run", "--help").stdout)

    def test_reproduce_writes_table_and_picture(self):
        result = gaspard("reproduce", "mcrae-fig2", "--out", self.out)
        self.assertEqual(result.returncode, 0, result.stderr)
        with open(self.path("mcrae-fig2.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(rows[0]), ["row", "quantity", "ours", "published", "difference", "note"])
        self.assertEqual((rows[0]["row"], rows[0]["quantity"], rows[0]["ours"]), ("ring, n = 30", "iterations", "189"))
        self.assertGreater(os.path.getsize(self.path("mcrae-fig2.png")), 10000)
        for name in ("mcrae-fig2", "mcrae-fig3", "mcrae-fig13", "kawecki-fig1"):
            self.assertIn(name, gaspard("reproduce").stdout)

    def test_columns_of_a_reproduced_table_are_below_each_other(self):
        head, *lines = gaspard("reproduce", "mcrae-fig5", "--out", self.out, "--no-render").stdout.splitlines()
        end = head.index("ours") + len("ours")
        rows = [line for line in lines if line.startswith("X2")]
        self.assertTrue(any("rms to the exact mesh, all nodes" in line for line in rows), lines)
        for line in rows:
            self.assertRegex(line[:end], r" [0-9][0-9.e+-]*$")
            self.assertEqual(line[end:].strip(), "", line)

    def test_an_interrupted_reproduction_leaves_nothing(self):
        process = subprocess.Popen([PROGRAM, "reproduce", "mcrae-fig11", "--out", os.path.join(self.out, "below")],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertNotEqual(process.stderr.readline(), "")  # it computes
        self.assertTrue(os.path.exists(self.out))
        process.send_signal(signal.SIGTERM)
        out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out), (130, ""))
        self.assertIn("nothing was written", err)
        self.assertFalse(os.path.exists(self.out))

    def test_compare_writes_table_histories_and_picture(self):
        result = gaspard("compare", "plane-ring", *QUICK, "--methods", "newton,relaxation,auto", "--out", self.out)
        self.assertEqual(result.returncode, 0, result.stderr)
        with open(self.path("comparison.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(rows[0]), ["method", "iterations", "inner_iterations", "cpu_seconds", "residual",
                                         "equidistribution", "tangled_cells", "coarse_iterations", "criterion",
                                         "criterion_value", "status"])
        self.assertEqual([row["method"] for row in rows], ["newton", "relaxation", "auto"])
        for row in rows:
            self.assertEqual(row["status"], "converged")
            self.assertEqual((row["criterion"], row["criterion_value"]), ("residual", row["residual"]))
            self.assertIn(row["method"], result.stdout)
            self.assertAlmostEqual(float(row["equidistribution"]), float(rows[0]["equidistribution"]), places=6)
            with open(self.path(row["method"] + ".csv")) as file:
                self.assertEqual(len(list(csv.DictReader(file))), int(row["iterations"]) + 1)
        self.assertGreater(os.path.getsize(self.path("comparison.png")), 10000)
        self.assertEqual(set(os.listdir(self.out)), {"comparison.csv", "comparison.json", "comparison.png", "newton.csv",
                                                     "relaxation.csv", "auto.csv"})
        with open(self.path("comparison.json")) as file:
            self.assertEqual(json.load(file), {"scenario": "plane-ring", "modified": ["domain.cells"]})
        other = ("compare", "plane-bell", *QUICK, "--methods", "auto", "--no-render", "--out", self.out)
        result = gaspard(*other)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("'plane-ring'", result.stderr)
        result = gaspard(*other, "--overwrite")
        self.assertEqual(result.returncode, 0)
        self.assertIn("not of this run, but left there: comparison.png, ", result.stdout)
        self.assertIn("newton.csv", result.stdout)
        self.assertTrue(os.path.exists(self.path("newton.csv")))
        shutil.rmtree(self.out)
        for methods, part in (("newtn", "newton"), ("auto,auto", "twice"), ("", "method")):
            self.refused(gaspard("compare", "plane-ring", "--methods", methods, "--out", self.out), part)

    def test_a_comparison_that_was_killed_can_be_repeated(self):
        with subprocess.Popen([PROGRAM, "compare", "plane-ring", "--set", "domain.cells=120", "--methods",
                               "newton,auto,relaxation", "--no-render", "--out", self.out], stdout=subprocess.PIPE,
                              text=True) as process:
            for line in ("method", "newton", "auto"):
                self.assertTrue(process.stdout.readline().startswith(line))
            process.kill()
        names = os.listdir(self.out)
        self.assertIn("newton.csv", names)
        self.assertNotIn("comparison.csv", names)
        result = gaspard("compare", "plane-ring", *QUICK, "--methods", "newton", "--no-render", "--out", self.out)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def why(self, *arguments, name="plane-ring"):
        return gaspard("why", name, "--set", "method.type=auto", "--out", self.out, *arguments)

    def test_why_compares_errors_of_both_meshes(self):
        result = self.why("--cells", "30,15")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(set(os.listdir(self.out)), {"why.csv", "why.json", "why.svg", "why.png"})
        with open(self.path("why.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(row["n"], row["cells"], row["norm"]) for row in rows],
                         [(n, str(int(n) ** 2), norm) for n in ("15", "30") for norm in ("l2", "maximum", "h1")])
        for row in rows:
            self.assertEqual(row["status"], "converged")
            self.assertAlmostEqual(float(row["ratio"]), float(row["uniform"]) / float(row["adapted"]), places=12)
            if row["norm"] != "maximum": # of which a lower bound is known
                self.assertLess(float(row["uniform_uncertainty"]), 0.01)
            self.assertIn("%.3e" % float(row["uniform"]), result.stdout)
            self.assertIn("%.3e" % float(row["adapted"]), result.stdout)
        self.assertGreater(float(rows[3]["ratio"]), 1.2)
        with open(self.path("why.json")) as file:
            record = json.load(file)
        self.assertEqual((record["scenario"], record["modified"]), ("plane-ring", ["method.type"]))
        self.assertEqual(record["rows"][1]["adapted"]["l2"], float(rows[3]["adapted"]))
        self.assertIsNone(record["rows"][0]["uniform"]["order"]["l2"])
        svg = xml.etree.ElementTree.parse(self.path("why.svg")).getroot()
        self.assertIn("L2, adapted", "".join(svg.itertext()))
        self.assertGreater(os.path.getsize(self.path("why.png")), 10000)
        # Again, the same bytes; about another scenario only when asked.
        before = self.bytes("why.csv")
        self.assertEqual(self.why("--cells", "15,30", "--no-render").returncode, 0)
        self.assertEqual(self.bytes("why.csv"), before)
        other = self.why("--cells", "8", "--no-render", name="plane-bell")
        self.assertEqual((other.returncode, other.stdout), (2, ""))
        self.assertIn("'plane-ring'", other.stderr)
        self.assertEqual(self.why("--cells", "8", "--no-render", "--overwrite", name="plane-bell").returncode, 0)

    def test_why_says_where_the_monitor_is_another(self):
        result = self.why("--cells", "30,60,120", "--no-render", name="walls-front")
        lines = result.stdout.splitlines()
        smoothed = "The monitor is smoothed over 0.75 cells of the uniform mesh, so that the mesh can follow it."
        self.assertEqual(lines[0], smoothed)
        self.assertEqual([line for line in lines if "note" in line], ["n = 120: the notes above do not apply"])
        self.assertEqual(sum(smoothed in line for line in lines), 1)

    def test_why_refuses_wrong_numbers_of_cells(self):
        for cells, part in (("15,many", "15,30,60"), ("15,15", "twice"), ("1000", "480"), ("2", "4 to 480")):
            self.refused(self.why("--cells", cells), part)
        self.refused(self.why(name="plane-rng"), "plane-ring")

    def test_why_of_a_constant_says_that_there_is_no_error(self):
        result = self.why("--cells", "8", "--set", "monitor.type=constant")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("both meshes interpolate the function exactly", result.stdout)
        self.assertNotIn("why.png", os.listdir(self.out))

    def test_why_has_the_exit_code_of_the_mesh_that_did_not_converge(self):
        result = self.why("--cells", "8,12", "--no-render", "--set", "method.max_iterations=2")
        self.assertEqual(result.returncode, 3, result.stderr)
        with open(self.path("why.csv")) as file:
            self.assertEqual({row["status"] for row in csv.DictReader(file)}, {"iteration-limit"})

    def test_why_is_interrupted_after_meshes_that_were_done(self):
        with subprocess.Popen([PROGRAM, "why", "plane-bell", "--cells", "8,240,480", "--no-render", "--out", self.out],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            while "H1" not in process.stdout.readline():
                pass
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=120)
        self.assertEqual((process.returncode, err), (130, ""))
        with open(self.path("why.csv")) as file:
            self.assertEqual({row["n"] for row in csv.DictReader(file)}, {"8"})

    def test_the_documented_table_of_why_is_what_the_program_prints(self):
        with open(os.path.join(DOCS, "monitors.md")) as file:
            page = file.read()
        command, table = re.search(r"^gaspard why (.*?)\n```\n+(\|.*?)\n\n", page, re.DOTALL | re.MULTILINE).groups()
        documented = [[cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines()[2:]]
        self.assertEqual(len(documented), 9)
        result = gaspard("why", *command.split(), cwd=self.folder.name, timeout=300)
        self.assertEqual(result.returncode, 0, result.stderr)
        with open(os.path.join(self.folder.name, "gaspard-out/plane-ring-why/why.csv")) as file:
            for row, cells in zip(csv.DictReader(file), documented, strict=True):
                self.assertEqual(cells[0], row["n"])
                for name, cell in zip(("uniform", "uniform_order", "adapted", "adapted_order", "ratio"), cells[2:]):
                    if row[name] == "":
                        self.assertEqual(cell, "")
                        continue
                    digits = len(cell.split("e")[0].split(".")[1]) if "." in cell else 0
                    unit = 10.0 ** -digits * float("1e" + (cell.split("e")[1] if "e" in cell else "0"))
                    self.assertAlmostEqual(float(cell), float(row[name]), delta=unit, msg=name)

    def study(self, *arguments, name="layer-1d"):
        return gaspard("study", name, "--out", self.out, *arguments)

    def test_the_svg_has_the_layout_of_the_view(self):
        def drawn(*settings):
            options = [word for setting in settings for word in ("--set", setting)]
            result = gaspard("run", "layer-2d", "--set", "domain.cells=8", "--no-render", "--formats", "svg", "--out",
                             self.out, *options)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            root = xml.etree.ElementTree.parse(self.path("adapted.svg")).getroot()
            return root.get("width"), [element.get("id") for element in root if element.get("id")]
        physical = ["cells", "edges", "contours", "axes", "legend"]
        self.assertEqual(drawn(), ("120mm", physical))
        self.assertEqual(drawn("view.axes=false"), ("120mm", ["cells", "edges", "contours", "legend"]))
        self.assertEqual(drawn(), ("120mm", physical))
        before = self.bytes("adapted.svg")
        self.assertEqual(drawn("view.layout=computational"), ("120mm", physical))
        self.assertNotEqual(self.bytes("adapted.svg"), before)
        computational = self.bytes("adapted.svg")
        self.assertEqual(drawn("view.blend=0"), ("120mm", physical))
        self.assertEqual(self.bytes("adapted.svg"), computational)
        both = ["computational-" + one for one in physical[:4]] + physical
        self.assertEqual(drawn("view.layout=side-by-side"), ("180mm", both))
        self.assertEqual(drawn("view.lines=false"), ("120mm", ["cells", "contours", "axes", "legend"]))

    def test_study_prints_errors_and_orders(self):
        result = self.study("--over", "domain.cells=32,16,64", "--lines", "pde.eps=1,1e-4")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(set(os.listdir(self.out)), {"study.csv", "study.json", "study.svg", "study.png"})
        with open(self.path("study.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(row["pde.eps"], row["domain.cells"]) for row in rows],
                         [(eps, n) for eps in ("1", "1e-04") for n in ("16", "32", "64")])
        lines = [line.split() for line in result.stdout.splitlines()]
        self.assertEqual(lines[1], ["domain.cells", "pde.eps=1", "order", "pde.eps=1e-04", "order"])
        for place, n in enumerate((16, 32, 64)):
            one, other = rows[place], rows[3 + place]
            self.assertEqual(lines[2 + place][:2], [str(n), "%.3e" % float(one["energy_error"])])
            self.assertEqual(lines[2 + place][3], "%.3e" % float(other["energy_error"]))
            self.assertEqual(lines[2 + place][2], "%.2f" % float(one["order"]) if place else "-")
            self.assertAlmostEqual(float(other["bound"]), 0.01 / n)
            run = gaspard("run", "layer-1d", "--set", "domain.cells=%d" % n, "--no-render", "--out", self.path("run"))
            self.assertEqual(run.returncode, 0, run.stderr)
            with open(self.path("run/summary.json")) as file:
                self.assertEqual(json.load(file)["measures"]["energy_error"], float(other["energy_error"]))
        self.assertAlmostEqual(float(rows[5]["order"]), 1, delta=0.01)
        svg = xml.etree.ElementTree.parse(self.path("study.svg")).getroot()
        self.assertIn("√ε / N", "".join(svg.itertext()))
        self.assertGreater(os.path.getsize(self.path("study.png")), 10000)
        before = self.bytes("study.csv")
        again = self.study("--over", "domain.cells=16:64", "--lines", "pde.eps=1,1e-4", "--no-render")
        self.assertEqual((again.returncode, self.bytes("study.csv")), (0, before))
        self.assertIn("not of this run, but left there: study.png", again.stdout)
        self.assertTrue(os.path.exists(self.path("study.png")))
        other = self.study("--no-render", name="layer-1d-convection")
        self.assertEqual((other.returncode, other.stdout), (2, ""))
        self.assertIn("'layer-1d'", other.stderr)

    def test_study_has_defaults_for_problems_with_and_without_layers(self):
        result = self.study("--no-render")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        with open(self.path("study.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 5 * 8)
        self.assertEqual({row["pde.eps"] for row in rows}, {"1", "0.01", "1e-04", "1e-06", "1e-08"})
        sweep = self.study("--over", "monitor.sigma", "--set", "pde.eps=1e-5", "--no-render")
        self.assertEqual((sweep.returncode, sweep.stderr), (0, ""))
        with open(self.path("study.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 6 * 19)
        self.assertEqual({row["pde.eps"] for row in rows}, {"1", "0.01", "1e-04", "1e-05", "1e-06", "1e-08"})
        ring = self.study("--set", "method.type=auto", "--set", "domain.cells=12", "--no-render", "--overwrite",
                          name="plane-ring")
        self.assertEqual((ring.returncode, ring.stderr), (0, ""))
        with open(self.path("study.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["domain.cells"] for row in rows], ["6", "12", "24"])
        self.assertTrue(all(float(row["equidistribution"]) > 0 for row in rows))

    def test_study_refuses_what_is_not_allowed(self):
        for over, part in (("domain.cells=8,0", "1 to 65536"), ("pde.eps=0", "10⁻¹² to 1"), ("cells=8", "cells"),
                           ("monitor.q=0.1:0.9", "number of values"), ("domain.cells=8,8", "twice"),
                           ("monitor.left", "monitor.left=VALUES"), ("monitor.p", "monitor.p")):
            self.refused(self.study("--over", over), part)
        self.refused(self.study("--measure", "energy"), "energy_error")
        self.refused(self.study("--over", "pde.eps=1,1e-4", "--lines", "pde.eps=1"), "pde.eps twice")
        self.refused(self.study(name="layer-2"), "layer-2d")

    def test_study_goes_on_after_a_run_that_fails(self):
        result = self.study("--set", "method.type=shishkin", "--set", "method.layers=both", "--no-render",
                            "--over", "domain.cells=15,16,17")
        self.assertEqual((result.returncode, result.stderr), (2, ""))
        with open(self.path("study.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([bool(row["energy_error"]) for row in rows], [False, True, False])
        self.assertIn("even", rows[0]["note"])
        self.assertIn("domain.cells=15: " + rows[0]["note"], result.stdout)
        limited = self.study("--over", "domain.cells=64", "--set", "method.max_iterations=2", "--no-render")
        self.assertEqual(limited.returncode, 3, limited.stderr)
        self.assertIn("domain.cells=64: iteration-limit after 2 iterations", limited.stdout)

    def test_study_is_interrupted_after_runs_that_were_done(self):
        with subprocess.Popen([PROGRAM, "study", "layer-2d", "--over", "domain.cells=4,256,300,400,500", "--no-render",
                               "--out", self.out], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            while not process.stdout.readline().split()[:1] == ["4"]:
                pass
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=120)
        self.assertEqual((process.returncode, err), (130, ""))
        with open(self.path("study.csv")) as file:
            self.assertEqual({row["domain.cells"] for row in csv.DictReader(file)}, {"4"})

    def test_the_summary_compares_interpolation_errors(self):
        self.assertEqual(self.run_quick("--set", "view.color=interpolation_error", render=True).returncode, 0)
        errors = self.summary()["interpolation"]
        self.assertAlmostEqual(errors["ratio"]["l2"], errors["uniform"]["l2"] / errors["adapted"]["l2"])
        self.run_quick("--set", "monitor.type=constant")
        self.assertIsNone(self.summary()["interpolation"])

    def test_picard_has_the_residual_of_all_methods_and_ends_by_its_increment(self):
        settings = ("--set", "domain.cells=16")
        result = gaspard("run", "spline-circle", *settings, "--no-render", "--out", self.out)
        self.assertEqual(result.returncode, 0, result.stderr)
        last = self.history()[-1]
        self.assertLess(float(last["increment"]), 1e-8)
        self.assertEqual(float(last["residual"]), self.summary()["residual"])
        self.assertIn("residual %.3e, increment %.3e" % (float(last["residual"]), float(last["increment"])), result.stdout)
        # Newton's method measures the same map.
        newton = gaspard("run", "spline-circle", *settings, "--set", "method.type=newton", "--no-render", "--start",
                         self.path("state.bin"), "--out", self.path("newton"))
        self.assertEqual(newton.returncode, 0, newton.stderr)
        with open(self.path("newton/history.csv")) as file:
            first = next(csv.DictReader(file))
        self.assertAlmostEqual(float(first["residual"]), float(last["residual"]), delta=1e-13)

    def test_every_option_is_documented(self):
        with open(os.path.join(DOCS, "command-line.md")) as file:
            page = file.read()
        for command in ([], ["run"], ["compare"], ["why"], ["study"], ["record"], ["list"], ["show"], ["reproduce"]):
            for option in re.findall(r"--[a-z-]+", gaspard(*command, "--help").stdout):
                self.assertIn(option, page, "of gaspard " + " ".join(command))

    def test_every_format_is_documented(self):
        names = re.findall(r"^  ([\w-]+) ", gaspard("list", "formats").stdout, re.MULTILINE)
        self.assertEqual(",".join(names), ALL_FORMATS)
        for page in ("command-line.md", "formats.md"):
            with open(os.path.join(DOCS, page)) as file:
                text = file.read()
            for name in names:
                self.assertIn("`" + name + "`", text, page)


class Files(Contract):
    """Where scenarios and patches come from."""
    SQUARE = {"degrees": [1, 1], "knots": [[0, 0, 1, 1]] * 2, "control_points": [[0, 0], [1, 0], [0, 1], [1, 1]]}
    SCENARIO = "[domain]\ntype = 'spline-patch'\ncells = 8\nfile = '%s'\n" \
               "[monitor]\ntype = 'constant'\n[method]\ntype = 'picard'\n"

    def file(self, name, text):
        path = os.path.join(self.folder.name, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            file.write(text)
        return path

    def quick(self, *arguments, **options):
        return subprocess.run([PROGRAM, "run", *arguments, "--out", self.out, "--no-render", "--formats", "obj"],
                              text=True, capture_output=True, timeout=60, **options)

    def gismo(self, count):
        geometry = """<Geometry type="TensorBSpline2" id="%d"><Basis type="TensorBSplineBasis2">
            <Basis type="BSplineBasis"><KnotVector degree="1">0 0 1 1</KnotVector></Basis>
            <Basis type="BSplineBasis"><KnotVector degree="1">0 0 1 1</KnotVector></Basis></Basis>
            <coefs geoDim="2">%d 0 %d 0 %d 1 %d 1</coefs></Geometry>"""
        each = [geometry % (100 + i, i, i + 1, i, i + 1) for i in range(count)]
        return "<xml>" + "".join(each) + "</xml>"

    def test_paths_are_relative_to_the_scenario(self):
        self.file("sub/p.json", json.dumps(self.SQUARE))
        scenario = self.file("sub/mine.toml", self.SCENARIO % "p.json")
        for cwd in ("/", self.folder.name, os.path.dirname(scenario)):
            self.assertEqual(self.quick(scenario, cwd=cwd).returncode, 0, cwd)
        shutil.rmtree(self.out)
        # On the command line they are relative to the working directory.
        self.file("q.json", json.dumps(self.SQUARE))
        result = self.quick(scenario, "--set", "domain.file=q.json", cwd=self.folder.name)
        self.assertEqual(result.returncode, 0, result.stderr)
        shutil.rmtree(self.out)
        self.refused(self.quick(scenario, "--set", "domain.file=q.json", cwd=os.path.dirname(scenario)), "sub/q.json")
        shown = gaspard("show", scenario)
        self.assertIn(os.path.join(self.folder.name, "sub", "p.json"), shown.stdout)
        again = self.file("elsewhere/again.toml", shown.stdout)
        self.assertEqual(self.quick(again).returncode, 0)

    def test_the_home_folder_is_expanded(self):
        self.file("p.json", json.dumps(self.SQUARE))
        self.file("mine.TOML", self.SCENARIO % "~/p.json")
        environment = dict(os.environ, HOME=self.folder.name)
        result = self.quick("~/mine.TOML", env=environment)
        self.assertEqual(result.returncode, 0, result.stderr)
        del environment["HOME"]
        shutil.rmtree(self.out)
        self.refused(self.quick("~/mine.TOML", env=environment), "HOME is not set")

    def test_a_scenario_from_standard_input(self):
        self.file("p.json", json.dumps(self.SQUARE))
        result = self.quick("-", input=self.SCENARIO % "p.json", cwd=self.folder.name)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.summary()["scenario"], "stdin")
        pipe = os.path.join(self.folder.name, "pipe")
        os.mkfifo(pipe)
        with subprocess.Popen(["sh", "-c", '"$0" show - < "$1"', PROGRAM, pipe], stdout=subprocess.PIPE,
                              text=True) as shown:
            with open(pipe, "w") as writer:
                writer.write("[domain]\ncells = 8\n")
            self.assertIn("\ncells = 8\n", shown.communicate(timeout=20)[0])
        shutil.rmtree(self.out)
        self.refused(self.quick("-", input="[domain]\ncells = 0\n"), "stdin:2: domain.cells = 0")

    def test_show_looks_at_files_and_view(self):
        scenario = self.file("mine.toml", self.SCENARIO % "gone.json" + "[view]\ncamera = 'from afar'\n")
        for command in ("show", "run", "compare"):
            self.refused(gaspard(command, scenario), "mine.toml:10: view.camera: the camera 'from afar'")
            self.refused(gaspard(command, scenario, "--set", "view.camera="), os.path.join(self.folder.name, "gone.json"))
        scenario = self.file("formats.toml", "[output]\nformats = 'obj,gld'\n")
        for command in ("show", "run", "compare"):
            self.refused(gaspard(command, scenario), "formats.toml:2: output.formats: unknown format 'gld'", "'glb'")
        self.refused(gaspard("compare", "plane-ring", "--set", "view.layout=projection", "--out", self.out), "projection")

    def test_a_portable_scenario_needs_no_other_file(self):
        patch = self.file("one.xml", self.gismo(1))
        scenario = self.file("mine.toml", self.SCENARIO % "one.xml")
        text = gaspard("show", scenario, "--portable").stdout
        self.assertIn("data:application/xml;base64,", text)
        self.assertNotIn("one.xml", text)
        os.remove(patch)
        self.refused(gaspard("show", scenario), "one.xml")
        self.assertEqual(gaspard("show", self.file("portable.toml", text)).stdout, text)

    def test_empty_values_are_refused(self):
        for option in ("--out", "--tolerance", "--max-iterations", "--threads", "--seed", "--start", "--formats", "--size"):
            self.refused(gaspard("run", "plane-ring", option, ""), option + " is empty")
        self.refused(gaspard("run", ""), "SCENARIO is empty")
        self.refused(gaspard("compare", "plane-ring", "--out="), "--out")
        self.refused(gaspard("reproduce", "mcrae-fig2", "--out", ""), "--out is empty")
        self.refused(gaspard("run", "plane-ring", "--out"), "--out needs one value")
        for option in (["--out"], ["--out="]):
            self.refused(gaspard("run", "plane-ring", *option, "--no-render", cwd=self.folder.name), "--out has no value before --no-render")
            self.refused(gaspard("run", "plane-ring", *option, "--seed=2", cwd=self.folder.name), "--out has no value before --seed=2")
        self.assertEqual(os.listdir(self.folder.name), [])
        self.refused(gaspard("run", "plane-ring", "--tolerence", "1"), "'--tolerance'")
        self.refused(gaspard("run", "plane-ring", "--quiet=maybe"), "takes no value")
        self.refused(gaspard("run", "plane-ring", "--tolerance", "small", "--out", self.out), "must be a number", "'small'")
        self.refused(gaspard("run", "plane-ring", "--threads", "1.5", "--out", self.out), "--threads must be an integer")

    def test_one_patch_of_several(self):
        many = self.file("many.xml", self.gismo(12))
        scenario = self.file("mine.toml", self.SCENARIO % "many.xml")
        for which, note in (("", "patch 1 of 12 (TensorBSpline2, id 100)"), ("3", "patch 3 of 12 (TensorBSpline2, id 102)"),
                            ("id:111", "patch 12 of 12 (TensorBSpline2, id 111)")):
            result = self.quick(scenario, "--set", "domain.patch=" + which)
            self.assertIn(note, result.stdout)
            self.assertEqual(self.summary()["patch"], note)
        shutil.rmtree(self.out)
        self.refused(self.quick(scenario, "--set", "domain.patch=13"), "many.xml has 12 patches", "from 1 to 12")
        inline = self.file("inline.toml", (self.SCENARIO % "many.xml").replace("cells = 8", "cells = 8\npatch = 2"))
        self.assertIn("patch 2 of 12", self.quick(inline).stdout)
        self.assertTrue(os.path.exists(many))

    def test_bad_patches_are_one_sentence_with_their_name(self):
        text = json.dumps(self.SQUARE)
        for name, content, part in (
                ("large.json", text.replace("[1, 1]]", "[1e400, 1]]"), "1e400"),
                ("key.json", text.replace("}", ', "weight": [1]}'), "did you mean 'weights'?"),
                ("folding.json", text.replace("[0, 1], [1, 1]]}", "[1, 1], [0, 1]]}"), "folds"),
                ("packed.xml.gz", "\x1f", "none of the kinds")):
            scenario = self.file("mine.toml", self.SCENARIO % name)
            self.file(name, content)
            self.refused(self.quick(scenario), os.path.join(self.folder.name, name), part)

    def test_endless_files_stop(self):
        os.symlink("/dev/zero", os.path.join(self.folder.name, "zero.toml"))
        self.refused(self.quick(os.path.join(self.folder.name, "zero.toml")), "larger than 4 MiB")
        scenario = self.file("mine.toml", self.SCENARIO % "/dev/urandom")
        self.refused(self.quick(scenario), "/dev/urandom", "larger than 32 MiB")
        self.refused(self.quick("plane-ring", "--start", "/dev/zero"), "/dev/zero", "larger than 256 MiB")


class Films(Contract):
    def record(self, *arguments, name="plane-ring", size="160x120", **options):
        return gaspard("record", name, "--out", self.out, "--size", size, *QUICK, "--set", "method.type=auto",
                       *arguments, **options)

    def frames(self):
        return sorted(os.listdir(self.path("frames")))

    def test_every_iterate_is_a_frame_of_each_format(self):
        result = self.record("--formats", "png,apng,pvd,glb,csv", "--nodes", "5")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        count = int(re.search(r"after (\d+) iterations; (\d+) frames", result.stdout).group(2))
        self.assertEqual(self.frames(), ["%05d.png" % k for k in range(count)])
        self.assertEqual(self.bytes("film.apng").count(b"fcTL"), count)
        series = xml.etree.ElementTree.parse(self.path("mesh.pvd")).findall(".//DataSet")
        self.assertEqual([float(one.get("timestep")) for one in series], list(range(count)))
        for one in series:
            self.assertTrue(os.path.exists(self.path(one.get("file"))))
        with open(self.path("trajectories.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 5 * count)
        self.assertEqual([rows[0][key] for key in ("frame", "iteration", "node")], ["0", "0", "0"])
        self.assertNotEqual(rows[-1]["x"], rows[4]["x"])
        size, = struct.unpack_from("<I", self.bytes("mesh.glb"), 12)
        model = json.loads(self.bytes("mesh.glb")[20:20 + size])
        self.assertEqual(len(model["meshes"][0]["primitives"][0]["targets"]), count - 1)

    def test_the_same_input_gives_the_same_bytes(self):
        self.record("--frames", "4")
        first = self.bytes("film.apng")
        shutil.rmtree(self.out)
        self.record("--frames", "4")
        self.assertEqual(self.bytes("film.apng"), first)

    def test_a_film_that_was_killed_goes_on(self):
        arguments = ["record", "sphere-x2", "--motion", "turn", "--frames", "40", "--size", "400x400", "--out", self.out]
        with subprocess.Popen([PROGRAM, *arguments]) as process:
            deadline = time.time() + 60
            while time.time() < deadline and not os.path.exists(self.path("frames/00004.png")):
                time.sleep(0.01)
            process.kill()
        done = [name for name in self.frames() if not name.startswith(".")]
        self.assertGreaterEqual(len(done), 5)
        self.assertLess(len(done), 40)
        self.assertFalse(os.path.exists(self.path("film.apng")))
        for name in done:
            self.assertTrue(self.bytes("frames/" + name).endswith(b"IEND\xaeB`\x82"), name)
        times = {name: os.stat(self.path("frames/" + name)).st_mtime_ns for name in done}
        result = gaspard(*arguments, "--resume")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for name, time_ns in times.items():
            self.assertEqual(os.stat(self.path("frames/" + name)).st_mtime_ns, time_ns)
        self.assertEqual(self.bytes("film.apng").count(b"fcTL"), 40)
        self.assertEqual(len(self.frames()), 40, "what the kill left unfinished is gone")

        refused = gaspard(*arguments[:-2], "--out", self.out, "--set", "monitor.ratio=3", "--resume")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("leave out --resume", refused.stderr)
        self.assertEqual(self.bytes("film.apng").count(b"fcTL"), 40)

    def test_a_shorter_film_leaves_no_frames_of_a_longer_one(self):
        self.record("--frames", "6", "--formats", "png")
        self.record("--frames", "3", "--formats", "png")
        self.assertEqual(len(self.frames()), 3)

    def test_frames_of_another_film_are_not_taken_for_its_own(self):
        self.record("--frames", "8", "--formats", "png,pvd,csv")
        os.remove(self.path("frames/00000.png"))
        os.remove(self.path("mesh/00001.vtu"))
        before = {name: self.bytes("frames/" + name) for name in self.frames()}
        result = self.record("--frames", "6", "--formats", "png", "--set", "monitor.amplitude=40")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(self.frames(), ["%05d.png" % k for k in range(6)])
        for name in self.frames()[1:]:
            self.assertNotEqual(self.bytes("frames/" + name), before[name], name)
        self.assertEqual(os.listdir(self.path("mesh")), [])
        for name in ("mesh.pvd", "trajectories.csv"):
            self.assertFalse(os.path.exists(self.path(name)), name)

    def test_resume_notices_other_data(self):
        image = os.path.join(self.folder.name, "data.csv")
        def write(height):
            with open(image, "w") as file:
                file.write("x,y,u\n" + "".join("%g,%g,%g\n" % (i / 8, j / 8, height * (i == j)) for i in range(8)
                                               for j in range(8)))
        field = ["--set", "monitor.type=field", "--set", "monitor.file=" + image, "--frames", "3"]
        write(1)
        self.assertEqual(self.record(*field).returncode, 0)
        self.assertEqual(self.record(*field, "--resume").returncode, 0)
        write(2)
        result = self.record(*field, "--resume")
        self.assertEqual(result.returncode, 2)
        self.assertIn("leave out --resume", result.stderr)

    def test_two_films_in_one_folder_at_a_time_are_refused(self):
        os.makedirs(self.out)
        folder = os.open(self.out, os.O_RDONLY)
        fcntl.flock(folder, fcntl.LOCK_EX)
        result = self.record("--frames", "2")
        os.close(folder)
        self.assertEqual(result.returncode, 2)
        self.assertIn("another program is recording", result.stderr)
        self.assertEqual(os.listdir(self.out), [])

    def test_files_of_the_mesh_have_every_iterate_once(self):
        self.record("--motion", "iterations", "--frames", "60", "--formats", "pvd,glb,csv")
        series = xml.etree.ElementTree.parse(self.path("mesh.pvd")).findall(".//DataSet")
        times = [float(one.get("timestep")) for one in series]
        self.assertEqual(times, sorted(set(times)))
        size, = struct.unpack_from("<I", self.bytes("mesh.glb"), 12)
        model = json.loads(self.bytes("mesh.glb")[20:20 + size])
        self.assertEqual(len(model["meshes"][0]["primitives"][0]["targets"]), len(times) - 1)
        self.record("--frames", "1", "--formats", "glb")
        size, = struct.unpack_from("<I", self.bytes("mesh.glb"), 12)
        self.assertNotIn("animations", json.loads(self.bytes("mesh.glb")[20:20 + size]))

    def test_a_film_of_some_iterates(self):
        self.record("--formats", "pvd", "--first", "1", "--last", "3")
        series = xml.etree.ElementTree.parse(self.path("mesh.pvd")).findall(".//DataSet")
        self.assertEqual([float(one.get("timestep")) for one in series], [1, 2, 3])

    MOVING = ["--set", "method.type=newton", "--set", "time.end=0.5", "--set", "time.step=0.1", "--set",
              "time.monitor.radius=0.25 - t/9"]

    def test_a_film_of_some_times(self):
        result = self.record(*self.MOVING, "--formats", "pvd", "--from-time", "0.2", "--to-time", "0.42")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        series = xml.etree.ElementTree.parse(self.path("mesh.pvd")).findall(".//DataSet")
        self.assertEqual([float(one.get("timestep")) for one in series], [0.2, 0.3, 0.4])

    def test_times_that_are_not_there_are_one_sentence(self):
        for arguments, part in ((["--from-time", "3"], "from 0 to 0.5, not '3'"), (["--to-time", "x"], "from 0 to 0.5"),
                                (["--to-time", "nan"], "from 0 to 0.5"),
                                (["--from-time", "0.4", "--to-time", "0.2"], "is later than"),
                                (["--from-time", "0.2", "--first", "3"], "choose one"),
                                (["--from-time", "0.2", "--motion", "iterations"], "not asked for")):
            self.refused(self.record(*self.MOVING, *arguments), part)
            self.assertFalse(os.path.exists(self.out), arguments)
        self.refused(self.record("--from-time", "0.2"), "needs a scenario with time")

    def test_resume_makes_frames_again_that_are_not_whole(self):
        film = [*self.MOVING, "--set", "view.color=mesh_speed", "--formats", "png"]
        self.assertEqual(self.record(*film).returncode, 0)
        before = {name: self.bytes("frames/" + name) for name in self.frames()}
        self.assertEqual(len(before), 6)
        for name, size in (("00001.png", 0), ("00004.png", len(before["00004.png"]) - 20)):
            os.truncate(self.path("frames/" + name), size)
        self.assertEqual(self.record(*film, "--resume").returncode, 0)
        self.assertEqual({name: self.bytes("frames/" + name) for name in self.frames()}, before,
                         "the colours have the same range")

    def test_frames_of_others_are_not_replaced(self):
        os.makedirs(self.path("frames"))
        with open(self.path("frames/00000.png"), "w") as file:
            file.write("mine")
        result = self.record()
        self.assertEqual(result.returncode, 2)
        self.assertIn("would be replaced", result.stderr)
        self.assertEqual(self.bytes("frames/00000.png"), b"mine")
        self.assertEqual(os.listdir(self.out), ["frames"])

    def test_what_makes_no_sense_is_one_sentence(self):
        for arguments, part in ((["--motion", "turns"], "did you mean 'turn'?"),
                                (["--motion", "turn"], "lies in the plane"),
                                (["--motion", "camera"], "--from and --to"),
                                (["--motion", "camera", "--from", "centre 0 0 height 1", "--to", "nowhere"], "nowhere"),
                                (["--from", "centre 0 0 height 1"], "not asked for"),
                                (["--frames", "3.5"], "whole number"),
                                (["--motion", "turn,camera"], "choose one"),
                                (["--motion", "blend", "--formats", "csv"], "iterations"),
                                (["--formats", "avi"], "unknown format 'avi'"),
                                (["--first", "3", "--last", "2"], "comes after"),
                                (["--first", "900"], "the last one is"), (["--last", "x"], "--last"),
                                (["--frames", "0"], "--frames"), (["--rate", "nan"], "--rate"),
                                (["--resume"], "no film was begun")):
            self.refused(self.record(*arguments), part)
            self.assertFalse(os.path.exists(self.out), arguments)

    def test_what_no_camera_looks_at_does_not_turn(self):
        for name, settings in (("sphere-x2", ["--set", "view.layout=projection"]), ("layer-1d", [])):
            result = gaspard("record", name, "--set", "domain.cells=8", *settings, "--motion", "turn", "--out", self.out)
            self.refused(result, "camera" if settings else "plots")

    def test_without_ffmpeg_it_says_how_to_get_it(self):
        nothing = dict(os.environ, PATH=self.folder.name)
        self.refused(self.record("--formats", "mp4", environment=nothing), "apt install ffmpeg")
        self.assertFalse(os.path.exists(self.out))

    def test_ffmpeg_is_asked_for_the_whole_film(self):
        # A program of that name which notes what it is asked for.
        tool = os.path.join(self.folder.name, "ffmpeg")
        with open(tool, "w") as file:
            file.write("#!/bin/sh\nfor last; do :; done\necho \"$@\" > \"${last#file:}\"\n")
        os.chmod(tool, 0o755)
        path = dict(os.environ, PATH=self.folder.name + ":" + os.environ["PATH"])
        result = self.record("--formats", "mp4,webm,gif", "--frames", "4", "--rate", "5", environment=path)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for name, codec in (("film.mp4", "libx264"), ("film.webm", "libvpx-vp9"), ("film.gif", "palettegen")):
            words = self.bytes(name).decode()
            self.assertIn(codec, words)
            self.assertIn("-framerate 5 ", words)
            self.assertIn("-frames:v 9 ", words)  # the last one stays for a second
        odd = os.path.join(self.folder.name, "50% a:b")
        result = gaspard("record", "plane-ring", "--out", odd, "--size", "64x64", *QUICK, "--formats", "gif", "--frames",
                         "2", environment=path)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        with open(os.path.join(odd, "film.gif")) as file:
            self.assertIn("-i file:" + odd.replace("%", "%%") + "/frames/%05d.png", file.read())
        with open(tool, "w") as file:
            file.write("#!/bin/sh\necho first; echo 'no such codec' >&2; exit 1\n")
        failed = self.record("--formats", "mp4", "--frames", "4", environment=path)
        self.assertEqual(failed.returncode, 1)
        self.assertIn("no such codec", failed.stderr)
        self.assertEqual([name for name in os.listdir(self.out) if "part" in name or "log" in name], [])


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
