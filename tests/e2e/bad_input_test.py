# SPDX-License-Identifier: Apache-2.0
"""Bad input ends in one sentence that names the file, line or key, a non-zero exit status, and nothing half-written."""
import subprocess
import tempfile
import unittest
from pathlib import Path

from support import BIN, PAPER_WORLD, SOURCE, free_domain, run


class BadInput(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name)

    def file(self, name, text):
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def component(self, name, *arguments):
        return subprocess.run([str(BIN / name), "--domain", str(free_domain()), *map(str, arguments)], capture_output=True,
                              text=True, timeout=30, check=False)

    def assert_refused(self, result, *words):
        self.assertNotEqual(result.returncode, 0)
        self.assertGreater(result.returncode, 0, "ended by a signal")
        for word in words:
            self.assertIn(str(word), result.stderr)
        self.assertLessEqual(len(result.stderr.strip().splitlines()), 3, result.stderr)

    def test_unknown_key_names_file_and_line(self):
        file = self.file("grid.yaml", "resolution_m: 0.05\nresolutoin_m: 0.1\n")
        self.assert_refused(self.component("gridBuilder", "--config", file), f"{file}:2", "resolutoin_m")

    def test_duplicate_key_names_file_and_line(self):
        file = self.file("grid.yaml", "resolution_m: 0.05\nresolution_m: 0.1\n")
        self.assert_refused(self.component("gridBuilder", "--config", file), f"{file}:2", "resolution_m")

    def test_value_out_of_range_names_the_range(self):
        file = self.file("detector.yaml", "step_m: -1\n")
        self.assert_refused(self.component("roomDetector", "--config", file), f"{file}:1", "step_m")

    def test_override_out_of_range_is_refused_by_run_too(self):
        self.assert_refused(run("run", PAPER_WORLD, "--set", "roomDetector.step_m=9"), "step_m")

    def test_kill_of_something_unknown_says_what_to_give(self):
        for kill in ("simulator@3", "explorer", "explorer@soon", "explorer@-1"):
            with self.subTest(kill=kill):
                self.assert_refused(run("run", PAPER_WORLD, "--kill", kill), kill, "COMPONENT@SECONDS")

    def test_missing_configuration_is_named(self):
        self.assert_refused(self.component("topoGraph", "--config", self.folder / "none.yaml"), "none.yaml")

    def test_missing_world_is_named(self):
        self.assert_refused(run("run", self.folder / "none.yaml"), "none.yaml")

    def test_world_without_rooms_is_refused(self):
        world = self.file("empty.yaml", "rooms: []\n")
        self.assert_refused(run("run", world), world)

    def test_world_that_is_not_yaml_names_the_line(self):
        world = self.file("broken.yaml", "rooms:\n  - {name: a\n")
        self.assert_refused(run("run", world), world)

    def test_truncated_cloud_is_refused_and_nothing_is_written(self):
        header = ("VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 100\nHEIGHT 1\n"
                  "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 100\nDATA binary\n")
        cloud = self.file("short.pcd", header.encode() + b"\0" * 600)
        out = self.folder / "out"
        result = run("demo", "--input", cloud, "--out", out, "--domain", free_domain(), timeout=60)
        self.assert_refused(result, cloud)
        self.assertNotIn("started again", result.stdout)
        self.assertFalse((out / "report.json").exists())

    def test_damaged_map_is_refused_and_left_as_it_is(self):
        damaged = self.file("map.yaml", "format: enfilade-map\nversion: 1\nrooms:\n  - {id: one}\n")
        before = damaged.read_bytes()
        result = self.component("topoGraph", "--set", f"map_file={damaged}", "--set", "resume=true")
        self.assert_refused(result, damaged)
        self.assertEqual(damaged.read_bytes(), before)

    def test_report_that_cannot_be_written_is_named(self):
        blocked = self.file("blocked", "")
        self.assert_refused(run("run", PAPER_WORLD, "--quiet", "--max-sim-time", 1, "--json", blocked / "r.json"), "r.json")

    def test_second_instance_on_the_host_is_refused(self):
        arguments = [str(BIN / "topoGraph"), "--domain", str(free_domain())]
        with subprocess.Popen(arguments, stderr=subprocess.PIPE, text=True) as first:
            try:
                self.assertTrue(any("running" in line for line in iter(first.stderr.readline, "")))
                self.assert_refused(self.component("topoGraph"), "topoGraph", first.pid)
            finally:
                first.terminate()
                first.communicate(timeout=10)
            self.assertEqual(first.returncode, 0)


class ShippedFiles(unittest.TestCase):
    def test_every_component_starts_with_the_file_it_ships_with(self):
        for file in sorted((SOURCE / "etc").glob("*.yaml")):
            with self.subTest(file=file.name):
                name = file.stem
                with subprocess.Popen([str(BIN / name), "--config", str(file), "--domain", str(free_domain())],
                                      stderr=subprocess.PIPE, text=True) as process:
                    first_line = process.stderr.readline()
                    process.terminate()
                    rest = process.communicate(timeout=10)[1]
                    self.assertEqual(process.returncode, 0, first_line + rest)


if __name__ == "__main__":
    unittest.main()
