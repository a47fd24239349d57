# SPDX-License-Identifier: Apache-2.0
"""`enfilade route` and `enfilade mark` ask a topoGraph that runs, over DDS."""
import re
import signal
import subprocess
import tempfile
import unittest
from pathlib import Path

from map_verbs_test import square_of_rooms
from support import BIN, free_domain, run


class LiveVerbs(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.map = Path(temporary.name) / "house.yaml"
        self.map.write_text(square_of_rooms())

    def start(self):
        process = subprocess.Popen([BIN / "topoGraph", "--domain", str(free_domain()), "--set", f"map_file={self.map}",
                                    "--set", "resume=true", "--set", "locate=true"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait, 30)
        self.addCleanup(process.kill)
        return process

    def stop(self, process):
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(30), 0)

    def ask(self, *arguments):
        return run(*arguments, "--domain", free_domain(), timeout=60)

    def doors(self, *arguments):
        result = self.ask("route", *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return re.findall(r"door (\d)", result.stdout)

    def test_a_running_map_is_asked_for_ways_and_told_of_closed_doors(self):
        process = self.start()
        self.assertEqual(self.doors("hall", "2"), ["1"])
        self.assertEqual(self.doors("-0.5,0.5", "4.2,0", "--closed", "1"), ["3", "2", "4"])
        self.assertEqual(self.ask("mark", 1, "closed").stdout, "door 1 is closed\n")
        self.assertEqual(self.doors("hall", "2"), ["3", "2", "4"])
        nowhere = self.ask("route", "99,99", "1")
        self.assertEqual((nowhere.returncode, nowhere.stderr),
                         (1, "enfilade route: the point 99.000,99.000 lies in no room\n"))
        unknown = self.ask("mark", 77, "closed")
        self.assertEqual((unknown.returncode, unknown.stderr), (1, "enfilade mark: there is no door 77\n"))
        self.stop(process)
        self.assertRegex(run("map", "show", self.map).stdout, r"(?m)^ *1 +passage .* closed$")
        process = self.start()  # what was marked is remembered
        self.assertEqual(self.doors("hall", "2"), ["3", "2", "4"])
        self.assertEqual(self.ask("mark", 1, "open").returncode, 0)
        self.assertEqual(self.doors("hall", "2"), ["1"])
        self.stop(process)

    def test_nobody_there_is_told_with_the_domain(self):
        result = self.ask("mark", 1, "closed")
        self.assertEqual(result.returncode, 1)
        self.assertIn(f"no topoGraph answers in DDS domain {free_domain()}", result.stderr)


if __name__ == "__main__":
    unittest.main()
