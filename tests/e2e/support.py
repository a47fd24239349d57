# SPDX-License-Identifier: Apache-2.0
"""What the end-to-end tests share: where things are, running the command, looking for leftovers."""
import json
import os
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

SOURCE = Path(os.environ.get("ENFILADE_SOURCE", Path(__file__).resolve().parents[2]))
BIN = Path(os.environ.get("ENFILADE_BIN", SOURCE / "build/release/bin"))
PAPER_WORLD = SOURCE / "etc/worlds/paper_two_rooms.yaml"
RING_WORLD = SOURCE / "etc/worlds/four_rooms_ring.yaml"
FULL = os.environ.get("ENFILADE_FULL") == "1"
COMPONENTS = ["simulator", "motorControl", "laser3D", "gridBuilder", "roomDetector", "topoGraph", "explorer"]


def run(*arguments, timeout=300, **more):
    return subprocess.run([str(BIN / "enfilade"), *(a if isinstance(a, bytes) else str(a) for a in arguments)], capture_output=True, text=True,
                          timeout=timeout, check=False, **more)


def explore(world, *arguments, timeout=300):
    """A composed run; its JSON report as text."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "report.json"
        result = run("run", world, "--quiet", "--json", file, *arguments, timeout=timeout)
        if not file.exists():
            raise AssertionError(f"no report: {result.stderr}")
        return file.read_text()


def without_wall_time(text):
    report = json.loads(text)
    del report["wall_time_s"]
    return json.dumps(report)


def wait_for(condition, timeout, what):
    deadline = time.monotonic() + timeout
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError(f"gave up waiting for {what}")
        time.sleep(0.05)


def processes_of(domain):
    """Pids of components that run in this DDS domain, by name."""
    found = {}
    for pid in filter(str.isdigit, os.listdir("/proc")):
        try:
            words = Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        name = os.path.basename(words[0].decode(errors="replace"))
        if name in COMPONENTS and b"--domain" in words and words[words.index(b"--domain") + 1] == str(domain).encode():
            found[name] = int(pid)
    return found


def shared_memory_files():
    return {f for f in os.listdir("/dev/shm") if "fast" in f}


def free_domain():
    """A DDS domain of this test's own."""
    return 100 + os.getpid() % 100


class Finished(unittest.TestCase):
    def assert_explored(self, report, log=""):
        """`log`: what the run printed, for whoever has to find out why."""
        self.assertTrue(report["finished"], log)
        self.assertEqual(report["collisions"], 0)
        metrics = report["metrics"]
        for rate in ("room_precision", "room_recall", "door_precision", "door_recall"):
            self.assertEqual(metrics[rate], 1.0, f"{rate}: {json.dumps(report, indent=1)}\n{log}")
