# SPDX-License-Identifier: Apache-2.0
"""The layering check sees wrong arrows, and only those."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "tools/lint/layering.py"


class Layering(unittest.TestCase):
    def check(self, path, include):
        with tempfile.TemporaryDirectory() as root:
            file = Path(root) / path
            file.parent.mkdir(parents=True)
            file.write_text(f"#pragma once\n#include {include}\n")
            result = subprocess.run([sys.executable, str(SCRIPT), root], capture_output=True, text=True, check=False)
            return result.returncode, result.stdout

    def test_wrong_arrows_are_named_with_file_and_line(self):
        wrong = [
            ("components/explorer/core/a.hpp", '"interfaces/bus/bus.hpp"'),
            ("components/explorer/core/a.hpp", "<octomap/octomap.h>"),
            ("components/explorer/core/a.hpp", "<thread>"),
            ("components/explorer/core/a.hpp", "<yaml-cpp/yaml.h>"),
            ("components/explorer/core/a.hpp", '"components/topoGraph/core/topo_graph.hpp"'),
            ("components/explorer/node/a.hpp", '"components/topoGraph/node/topo_graph_node.hpp"'),
            ("components/explorer/node/a.hpp", "<fastdds/dds/domain/DomainParticipant.hpp>"),
            ("interfaces/geometry/a.hpp", '"interfaces/model/room.hpp"'),
            ("interfaces/bus/a.hpp", '"components/explorer/core/drive.hpp"'),
            ("tools/simulator/core/a.hpp", "<chrono>"),
            ("tools/evaluate/maps/a.hpp", '"tools/enfilade/verbs/verbs.hpp"'),
            ("tools/launch/a.hpp", '"tools/evaluate/graph/graph_evaluation.hpp"'),
        ]
        for path, include in wrong:
            with self.subTest(path=path, include=include):
                status, output = self.check(path, include)
                self.assertEqual(status, 1)
                self.assertIn(f"{path}:2:", output)

    def test_a_root_that_is_not_there_is_no_success(self):
        result = subprocess.run([sys.executable, str(SCRIPT), "/nowhere"], capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 1)
        self.assertIn("/nowhere", result.stderr)

    def test_right_arrows_pass(self):
        right = [
            ("components/gridBuilder/core/a.hpp", "<octomap/octomap.h>"),
            ("components/roomDetector/core/a.hpp", "<Eigen/Dense>"),
            ("components/explorer/node/a.hpp", '"interfaces/runtime/node.hpp"'),
            ("interfaces/dds/a.hpp", "<fastdds/dds/domain/DomainParticipant.hpp>"),
            ("tools/simulator/core/a.hpp", "<embree3/rtcore.h>"),
            ("tools/enfilade/verbs/a.cpp", '"tools/evaluate/maps/map_evaluation.hpp"'),
            ("tools/evaluate/maps/a.cpp", '"tools/draw/svg.hpp"'),
        ]
        for path, include in right:
            with self.subTest(path=path, include=include):
                self.assertEqual(self.check(path, include), (0, "\n"))


if __name__ == "__main__":
    unittest.main()
