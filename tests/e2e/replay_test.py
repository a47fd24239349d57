# SPDX-License-Identifier: Apache-2.0
"""A recorded 3D scan through laser3D, gridBuilder and roomDetector over DDS."""
import json
import math
import os
import tempfile
import unittest
from pathlib import Path

from support import free_domain, processes_of, run

SCANNER_HEIGHT_M = 1.1
ROOM = (5.2, 4.1, 2.7)  # width, depth, height
YAW = math.radians(11)
CENTRE = (0.4, -0.3)  # of the room, from the scanner
DOOR = (0.2, 1.1, 2.05)  # in the wall y = +depth / 2: from, to along x, height
BEYOND_M = 3.0  # a wall so far behind the door


def cast(origin, direction):
    """Distance to the room's walls, floor and ceiling, through the door to the wall behind it."""
    (w, d, h), (from_x, to_x, lintel) = ROOM, DOOR
    low, high = (-w / 2, -d / 2, 0.0), (w / 2, d / 2, h)

    def leave(low, high):
        return min((high[i] - origin[i]) / v if v > 0 else (low[i] - origin[i]) / v
                   for i, v in enumerate(direction) if abs(v) > 1e-9)

    reach = leave(low, high)
    x, y, z = (origin[i] + reach * direction[i] for i in range(3))
    if abs(y - d / 2) < 1e-6 and from_x < x < to_x and z < lintel:
        reach = leave((-w / 2, -d / 2, 0.0), (w / 2, d / 2 + BEYOND_M, h))
    return reach


def scan():
    """Points of a scanner at the origin, as an ascii PCD."""
    c, s = math.cos(YAW), math.sin(YAW)
    x, y = -CENTRE[0], -CENTRE[1]
    origin = (c * x + s * y, -s * x + c * y, SCANNER_HEIGHT_M)
    points = []
    for pitch in range(-240, 241):
        for step in range(0, 720):
            elevation, azimuth = math.radians(pitch / 3), math.radians(step / 2)
            flat = math.cos(elevation)
            world = (flat * math.cos(azimuth), flat * math.sin(azimuth), math.sin(elevation))
            local = (c * world[0] + s * world[1], -s * world[0] + c * world[1], world[2])
            reach = cast(origin, local)
            points.append(" ".join(f"{reach * v:.4f}" for v in world))
    header = f"VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {len(points)}\nHEIGHT 1\n"
    return header + f"VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {len(points)}\nDATA ascii\n" + "\n".join(points) + "\n"


class Replay(unittest.TestCase):
    def look_at(self, file, folder):
        result = run("demo", "--input", file, "--out", folder, "--domain", free_domain(), timeout=120)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertEqual(processes_of(free_domain()), {})
        self.assertTrue((Path(folder) / "room1-scan1.svg").exists())
        return json.loads((Path(folder) / "report.json").read_text())

    def test_room_and_gap_of_a_generated_scan_are_found_where_they_are(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "room.pcd"
            file.write_text(scan())
            report = self.look_at(file, Path(folder) / "out")
        room = report["rooms"][0]
        for key, true in (("x_m", CENTRE[0]), ("y_m", CENTRE[1]), ("width_m", ROOM[0]), ("height_m", ROOM[1])):
            self.assertAlmostEqual(room[key], true, delta=0.05, msg=key)
        self.assertAlmostEqual(room["yaw_rad"], YAW, delta=math.radians(0.5))
        doors = [gap for gap in report["gaps"] if gap["state"] == "door"]
        self.assertEqual(len(doors), 1, report["gaps"])
        self.assertAlmostEqual(doors[0]["width_m"], DOOR[1] - DOOR[0], delta=0.1)

    @unittest.skipUnless(os.environ.get("ENFILADE_DATA"), "set ENFILADE_DATA to the folder of the public scans")
    def test_recorded_hall_is_found(self):
        file = Path(os.environ["ENFILADE_DATA"]) / "clouds/room_scan1.pcd"
        with tempfile.TemporaryDirectory() as folder:
            room = self.look_at(file, Path(folder) / "out")["rooms"][0]
        self.assertAlmostEqual(room["width_m"], 10.6, delta=0.2)
        self.assertAlmostEqual(room["height_m"], 4.6, delta=0.2)


if __name__ == "__main__":
    unittest.main()
