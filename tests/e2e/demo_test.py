# SPDX-License-Identifier: Apache-2.0
"""The whole demo: seven processes over DDS, from the command a new user types."""
import json
import os
import signal
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path
from xml.etree import ElementTree

from support import (BIN, COMPONENTS, PAPER_WORLD, SOURCE, Finished, explore, free_domain, processes_of, shared_memory_files,
                     wait_for)

HOUGH_STEP_M = 0.05


class Demo:
    """A demo under way, its output at hand line by line."""

    def __init__(self, folder, *arguments, command=(BIN / "enfilade", "demo")):
        self.domain = free_domain()
        self.folder = Path(folder)
        self.process = subprocess.Popen([*map(str, command), "--domain", str(self.domain), "--out", str(folder), *map(str, arguments)],
                                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.lines = []
        self.reader = threading.Thread(target=lambda: self.lines.extend(self.process.stdout), daemon=True)
        self.reader.start()

    def said(self, text):
        return any(text in line for line in list(self.lines))

    def finish(self, timeout):
        try:
            status = self.process.wait(timeout)
        except subprocess.TimeoutExpired:
            self.process.send_signal(signal.SIGINT)
            self.process.wait(30)
            raise AssertionError("the demo took too long:\n" + self.text()) from None
        self.reader.join(10)
        return status

    def text(self):
        return "".join(self.lines)

    def report(self):
        return json.loads((self.folder / "report.json").read_text())


class WholeDemo(Finished):
    def test_seven_processes_model_both_rooms_and_leave_nothing_behind(self):
        before = shared_memory_files()
        with tempfile.TemporaryDirectory() as folder:
            demo = Demo(folder, "--speed", 5, command=(SOURCE / "deploy/demo",) if BIN.parent.name == "release" else
                        (BIN / "enfilade", "demo"))
            wait_for(lambda: len(processes_of(demo.domain)) == len(COMPONENTS) or demo.process.poll() is not None, 60, "seven processes")
            self.assertEqual(demo.finish(400), 0, demo.text())
            report = demo.report()
            self.assert_explored(report, demo.text())
            self.assert_agrees_with_composed(report)
            self.assert_files(demo.folder)
            self.assertIn("room 1", demo.text())
        self.assertEqual(processes_of(demo.domain), {})
        self.assertEqual(shared_memory_files() - before, set())

    def assert_agrees_with_composed(self, report):
        composed = json.loads(explore(PAPER_WORLD))
        self.assertEqual(len(report["rooms"]), len(composed["rooms"]))
        for mine, other in zip(report["rooms"], composed["rooms"]):
            for key in ("x_m", "y_m", "yaw_rad", "width_m", "height_m"):
                self.assertAlmostEqual(mine[key], other[key], delta=HOUGH_STEP_M)
        kinds = [sorted(door["kind"] for door in r["doors"]) for r in (report, composed)]
        self.assertEqual(*kinds)
        for mine in report["doors"]:
            other = next(d for d in composed["doors"] if d["kind"] == mine["kind"])
            for key in ("x_m", "y_m", "width_m"):
                self.assertAlmostEqual(mine[key], other[key], delta=HOUGH_STEP_M, msg=f"{key} of {mine}")

    def assert_files(self, folder):
        names = {p.name for p in folder.iterdir()}
        self.assertLessEqual({"report.json", "map.yaml", "floorplan.svg", "room1-scan1.svg", "room2-scan1.svg"}, names)
        for picture in folder.glob("*.svg"):
            ElementTree.parse(picture)

    def test_interrupt_stops_everything_within_seconds(self):
        with tempfile.TemporaryDirectory() as folder:
            demo = Demo(folder)
            wait_for(lambda: demo.said("explorer") or demo.process.poll() is not None, 60, "the first event")
            demo.process.send_signal(signal.SIGINT)
            self.assertNotEqual(demo.finish(15), 0)
        self.assertEqual(processes_of(demo.domain), {})


class Survival(Finished):
    PAUSE_S = 9.0  # more than a heartbeat may be late

    def test_it_survives_killed_components_and_a_pause_of_all_processes(self):
        with tempfile.TemporaryDirectory() as folder:
            demo = Demo(folder, "--speed", 5)
            wait_for(lambda: demo.said("sweep 1 ") or demo.process.poll() is not None, 90, "the first sweep")
            self.kill(demo, "gridBuilder")
            wait_for(lambda: demo.said("room 1 fixed") or demo.process.poll() is not None, 200, "room 1")
            self.kill(demo, "explorer")
            self.pause(demo)
            self.assertEqual(demo.finish(400), 0, demo.text())
            self.assertFalse(demo.said("hangs"), demo.text())
            self.assert_explored(demo.report(), demo.text())

    def pause(self, demo):
        """As a laptop that sleeps does."""
        all_of_it = [demo.process.pid, *processes_of(demo.domain).values()]
        for pid in all_of_it:
            os.kill(pid, signal.SIGSTOP)
        time.sleep(self.PAUSE_S)
        for pid in all_of_it:
            os.kill(pid, signal.SIGCONT)

    def kill(self, demo, component):
        old = processes_of(demo.domain)[component]
        os.kill(old, signal.SIGKILL)
        wait_for(lambda: processes_of(demo.domain).get(component, old) != old, 30, f"{component} to be started again")


if __name__ == "__main__":
    unittest.main()
