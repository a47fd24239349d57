# SPDX-License-Identifier: Apache-2.0
"""Bad input ends in one sentence that names the file, line or key, a non-zero exit status, and nothing half-written."""
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import yaml

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

    def refuse_each(self, *commands):
        """(arguments…, words…) each: one sentence with the words, and nothing written."""
        before = sorted(p.name for p in self.folder.rglob("*"))
        for arguments, words in commands:
            with self.subTest(arguments=arguments):
                result = run(*arguments, cwd=self.folder, timeout=60)
                self.assertEqual(result.returncode, 2, result.stdout)
                self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
                for word in words:
                    self.assertIn(word, result.stderr)
        self.assertEqual(sorted(p.name for p in self.folder.rglob("*")), before)

    def test_unknown_verbs_and_options_are_named(self):
        self.refuse_each((["nope"], ["nope"]), (["map", "nope"], ["nope"]), ([], ["--help"]), (["evaluate"], ["evaluate", "--help"]),
                         (["run", PAPER_WORLD, "--bogus"], ["--bogus"]), (["demo", "--input", "a.pcd", "--world", "b"], ["--world"]),
                         (["demo", "--input", "a.pcd", "--speed", "2"], ["--speed"]), (["demo", "--seed", "2", "--input", "a.pcd"], ["--seed"]))

    def test_numbers_are_checked_as_they_are_written(self):
        self.refuse_each((["run", PAPER_WORLD, "--seed", "-1"], ["--seed", "-1"]),
                         (["run", PAPER_WORLD, "--seed", "99999999999"], ["--seed", "99999999999"]),
                         (["run", PAPER_WORLD, "--max-sim-time", "nan"], ["--max-sim-time", "nan"]),
                         (["run", PAPER_WORLD, "--max-sim-time", "1e400"], ["--max-sim-time", "1e400"]),
                         (["demo", "--speed", "nan"], ["--speed", "nan", "0.05 to 100"]), (["demo", "--speed", "0"], ["0.05 to 100"]),
                         (["room", "a.png", "--at", "nan,1"], ["--at", "nan"]),
                         (["map", "export", "a.yaml", "--out", "a.svg", "--rooms", "-1"], ["--rooms", "-1"]),
                         (["map", "mark", "a.yaml", "-1", "closed"], ["-1"]),
                         (["evaluate", "perception", "--rooms", "many"], ["--rooms", "many"]),
                         (["evaluate", "exploration", "--walkers", "nan"], ["--walkers", "nan"]),
                         (["calibrate", "range", "--width", "nan"], ["--width", "nan"]))

    def test_settings_are_named_as_they_were_given(self):
        for verb in (["run", PAPER_WORLD], ["demo", "--domain", str(free_domain())], ["room", "a.png"], ["evaluate", "latency"]):
            self.refuse_each(([*verb, "--set", "roomDetector.nope=1"], ["roomDetector.nope", "etc/roomDetector.yaml"]),
                             ([*verb, "--set", "roomDetector.step_mm=1"], ["roomDetector.step_mm", "did you mean roomDetector.step_m?"]),
                             ([*verb, "--set", "roomDetector.step_m=9"], ["roomDetector.step_m", "0.02 to 0.5"]),
                             ([*verb, "--set", "detector.step_m=1"], ["detector", "roomDetector"]),
                             ([*verb, "--set", "step_m=1"], ["COMPONENT.KEY=VALUE"]))

    def test_a_setting_that_an_option_tells_is_not_dropped_in_silence(self):
        self.file("scan.pcd", "VERSION .7\n")
        world, seed = ["--set", "simulator.world=a.yaml"], ["--set", "simulator.seed=3"]
        self.refuse_each((["run", PAPER_WORLD, *world], ["simulator.world=a.yaml", "WORLD"]),
                         (["run", PAPER_WORLD, "--seed", "2", *seed], ["simulator.seed=3", "--seed"]),
                         (["demo", *world], ["simulator.world=a.yaml", "--world"]),
                         (["demo", "--set", "topoGraph.map_file=a.yaml"], ["topoGraph.map_file=a.yaml", "--out"]),
                         (["demo", "--input", "scan.pcd", "--set", "laser3D.driver=simulator"], ["laser3D.driver=simulator", "--input"]),
                         (["evaluate", "latency", *world], ["simulator.world=a.yaml", "--world"]),
                         (["evaluate", "exploration", *world], ["simulator.world=a.yaml", "--buildings"]))

    def test_files_that_hold_nothing_are_named(self):
        (self.folder / "folder").mkdir()
        self.file("empty", "")
        self.file("empty.pcd", "")
        self.file("hello.yaml", "hello\n")
        for file in ("none", "folder", "empty"):
            self.refuse_each((["run", file], [file]), (["demo", "--world", file], [file]), (["evaluate", "latency", "--world", file], [file]),
                             (["map", "show", file], [file]), (["evaluate", "maps", file], [file]))
        for file in ("none.pcd", "folder", "empty.pcd"):
            self.refuse_each((["demo", "--input", file], [file]), (["room", file], [file]), (["calibrate", "range", "--width", "3", file], [file]))
        self.refuse_each((["run", "hello.yaml"], ["hello.yaml", "'rooms'", "'image'"]), (["room", "hello.yaml"], ["hello.yaml", "image"]))

    def test_places_that_cannot_be_written_are_named_before_any_work(self):
        (self.folder / "folder").mkdir()
        self.file("file", "")
        for verb in (["run", PAPER_WORLD], ["room", "a.png"], ["evaluate", "graph"], ["evaluate", "perception"]):
            self.refuse_each(([*verb, "--json", "folder"], ["--json", "folder"]), ([*verb, "--json", "none/a.json"], ["none/a.json"]),
                             ([*verb, "--json", ""], ["--json"]))
        self.refuse_each((["run", PAPER_WORLD, "--out", "file/a"], ["--out", "file/a"]), (["demo", "--out", "file"], ["--out", "file"]),
                         (["evaluate", "maps", ".", "--svg", "file"], ["--svg", "file"]))

    def test_a_file_full_of_mistakes_is_not_told_to_the_end(self):
        world = self.file("many.yaml", "".join(f"key_{i}: 1\n" for i in range(100)))
        result = run("run", world)
        self.assertEqual(result.returncode, 2)
        self.assertLess(len(result.stderr.splitlines()), 12)
        self.assertIn("more in this file", result.stderr)

    def test_second_instance_on_the_host_is_refused(self):
        arguments = [str(BIN / "topoGraph"), "--domain", str(free_domain())]
        with subprocess.Popen(arguments, stderr=subprocess.PIPE, text=True) as first:
            try:
                self.assertTrue(any("running" in line for line in iter(first.stderr.readline, "")))
                self.assert_refused(self.component("topoGraph"), "topoGraph", first.pid)
                demo = run("demo", "--domain", str(free_domain()), "--out", self.folder / "out")
                self.assertNotEqual(demo.returncode, 0)
                self.assertIn(f"process {first.pid} already runs topoGraph", demo.stderr)
            finally:
                first.terminate()
                first.communicate(timeout=10)
            self.assertEqual(first.returncode, 0)


class DemoScript(unittest.TestCase):
    """deploy/demo refuses what is wrong before it installs or builds anything."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        (self.folder / "deploy").mkdir()
        shutil.copy(SOURCE / "deploy/demo", self.folder / "deploy/demo")
        install = self.folder / "deploy/install-deps"
        install.write_text("#!/bin/sh\nexit 99\n")
        install.chmod(0o755)
        (self.folder / "scan.pcd").write_text("VERSION .7\n")
        (self.folder / "empty.pcd").touch()

    def demo(self, *arguments):
        return subprocess.run([self.folder / "deploy/demo", *arguments], cwd=self.folder, capture_output=True, text=True, timeout=30,
                              check=False)

    def test_what_is_wrong_is_named_in_one_sentence(self):
        for arguments, word in [(("--speed", "abc"), "abc"), (("--speed", "0"), "0.05 to 100"), (("--speed=1000",), "0.05 to 100"),
                                (("--speed", "-1"), "-1"), (("--speed",), "value is missing"), (("--input", "nofile"), "nofile"),
                                (("--input", "empty.pcd"), "empty.pcd"), (("--world", "/"), "--world /"), (("--sped", "2"), "--sped"),
                                (("--seed", "-3"), "-3"), (("--seed", "1.5"), "1.5"), (("--domain", "300"), "300"),
                                (("--out", "empty.pcd/a"), "empty.pcd/a"), (("--set", "step_m=2"), "COMPONENT.KEY=VALUE"),
                                (("--speed", "2", "--input", "scan.pcd"), "--speed"), (("--input=scan.pcd", "--seed=2"), "--seed"),
                                (("world.yaml",), "world.yaml")]:
            with self.subTest(arguments=arguments):
                result = self.demo(*arguments)
                self.assertEqual(result.returncode, 2, result.stdout)
                self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
                self.assertIn(word, result.stderr)

    def test_what_is_right_goes_on_to_install_and_build(self):
        for arguments in [(), ("--speed", ".5", "--seed", "7"), ("--input", "scan.pcd", "--out", "new/deep"), ("--speed=100",),
                          ("--set", "explorer.door_attempts=2", "--domain", "0")]:
            with self.subTest(arguments=arguments):
                self.assertEqual(self.demo(*arguments).returncode, 99)


def keys_of(node, prefix=""):
    """All keys of nested maps, dotted."""
    groups = [(f"{prefix}{key}", value) for key, value in node.items()]
    return {k for key, value in groups for k in (keys_of(value, f"{key}.") if isinstance(value, dict) else [key])}


def resolved_in(log):
    """The configuration that a component tells in its log."""
    text = re.search(r"resolved configuration:\n((?:(?!\d\d:).*\n)*)", log).group(1)
    return yaml.safe_load(text)


class ShippedFiles(unittest.TestCase):
    def test_every_component_starts_with_the_file_it_ships_with(self):
        for file in sorted((SOURCE / "etc").glob("*.yaml")):
            with self.subTest(file=file.name):
                name = file.stem
                with subprocess.Popen([str(BIN / name), "--config", str(file), "--domain", str(free_domain()), "--log-level", "debug"],
                                      stderr=subprocess.PIPE, text=True) as process:
                    log = ""
                    for line in iter(process.stderr.readline, ""):
                        log += line
                        if "running" in line:
                            break
                    process.terminate()
                    log += process.communicate(timeout=10)[1]
                    self.assertEqual(process.returncode, 0, log)
                self.assertEqual(keys_of(yaml.safe_load(file.read_text())), keys_of(resolved_in(log)), "the file lists every key")


if __name__ == "__main__":
    unittest.main()
