# SPDX-License-Identifier: Apache-2.0
"""`enfilade map`: what its verbs do, and that every wrong input is told in a sentence."""
import re
import tempfile
import unittest
from pathlib import Path

from support import run

MAP = """format: enfilade-map
version: 1
changes: 4
stamp_ns: 0
rooms:
{rooms}doors:
{doors}end: enfilade-map
"""
ROOM = """  - id: {id}
    name: "{name}"
    T_map_room: {{x_m: {x}, y_m: {y}, yaw_rad: 0}}
    width_m: 4
    height_m: 4
    zone_id: {id}
    fixed_ns: 0
"""
DOOR = """  - id: {id}
    kind: passage
    face: {{room: {a}, wall: {wall}, from_m: 1, to_m: 2}}
    other_face: {{room: {b}, wall: {other}, from_m: 2, to_m: 3}}
"""
EXIT = """  - id: {id}
    kind: exit
    face: {{room: {a}, wall: {wall}, from_m: 1, to_m: 2}}
"""


def square_of_rooms():
    """Rooms 1 2 / 3 4 about walls 0.2 m thick, a door in each wall between them, an exit from room 1."""
    names = ["hall", "Küche <&>", "room 3", "office"]
    rooms = "".join(ROOM.format(id=i + 1, name=names[i], x=4.2 * (i % 2), y=4.2 * (i // 2)) for i in range(4))
    doors = "".join(DOOR.format(id=i + 1, a=a, b=b, wall=wall, other=wall + 2)
                    for i, (a, b, wall) in enumerate([(1, 2, 0), (3, 4, 0), (1, 3, 1), (2, 4, 1)]))
    return MAP.format(rooms=rooms, doors=doors + EXIT.format(id=5, a=1, wall=2))


class MapVerbs(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name)
        self.map = self.folder / "house.yaml"
        self.map.write_text(square_of_rooms())

    def done(self, *arguments):
        result = run("map", *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def refused(self, *arguments, words=()):
        result = run("map", *arguments)
        self.assertGreater(result.returncode, 0, result.stdout)
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        for word in words:
            self.assertIn(str(word), result.stderr)

    def test_show_lists_rooms_and_doors(self):
        text = self.done("show", self.map)
        self.assertIn("4 rooms, 5 doors, 64.0 m²", text)
        self.assertRegex(text, r"(?m)^ *4 +office +4\.00 × 4\.00 +4\.20 +4\.20 +0\.00 +2$")

    def test_route_avoids_closed_doors(self):
        short = self.done("route", self.map, "--from", "hall", "--to", "2")
        self.assertIn("door 1", short)
        self.assertRegex(short, r"4\.323 m  in all, through 1 door\n")
        long = self.done("route", self.map, "--from", "-0.5,0.5", "--to", "4.2,0", "--closed", "1")
        self.assertEqual(re.findall(r"door (\d)", long), ["3", "2", "4"])
        shut = run("map", "route", self.map, "--from", "1", "--to", "2", "--closed", "1", "--closed", "3")
        self.assertEqual(shut.returncode, 1)
        self.assertIn("no way", shut.stderr)

    def test_a_door_marked_as_closed_is_avoided_until_it_is_open(self):
        self.done("mark", self.map, "1", "closed")
        self.assertRegex(self.done("show", self.map), r"(?m)^ *1 +passage .* closed$")
        self.assertIn("through 3 doors", self.done("route", self.map, "--from", "hall", "--to", "2"))
        self.done("mark", self.map, "1", "open")
        self.assertIn("through 1 door\n", self.done("route", self.map, "--from", "hall", "--to", "2"))
        self.refused("mark", self.map, "77", "closed", words=[self.map, "77"])
        self.refused("mark", self.map, "1", "ajar", words=["ajar"])

    def test_check_tells_a_sound_map_from_a_broken_one(self):
        self.assertIn("nothing is wrong", self.done("check", self.map))
        self.map.write_text(self.map.read_text().replace("x_m: 4.2, y_m: 0", "x_m: 3.0, y_m: 0"))
        result = run("map", "check", self.map)
        self.assertEqual(result.returncode, 1)
        self.assertIn("rooms 1 and 2 overlap by 1.00 m", result.stdout)

    def test_rename_changes_the_name_alone(self):
        self.done("rename", self.map, "room 3", "Bad \"neu\"")
        self.assertRegex(self.done("show", self.map), r'(?m)^ *3 +Bad "neu" ')
        self.assertIn("nothing is wrong", self.done("check", self.map))
        for name in ("hall", "7", "", "1.5,2", b"\xff"):
            self.refused("rename", self.map, "3", name)

    def test_restore_puts_the_last_good_map_back(self):
        self.refused("restore", self.map, words=[self.map, "not damaged"])
        self.done("rename", self.map, "3", "kitchen")
        whole = self.map.read_text()
        self.map.write_text(whole[:len(whole) // 2])
        self.refused("show", self.map, words=[f"{self.map}:", f"enfilade map restore {self.map}"])
        self.assertIn("4 rooms, 5 doors", self.done("restore", self.map))
        self.assertIn("room 3", self.done("show", self.map))
        self.assertEqual((self.folder / f"{self.map.name}.damaged").read_text(), whole[:len(whole) // 2])

    def test_merge_joins_two_maps_over_their_common_rooms(self):
        def row(first, count, heights, shift):
            rooms = "".join(ROOM.format(id=i + 1, name=f"room {i + 1}", x=4.2 * (first + i) + shift, y=shift)
                            .replace("height_m: 4", f"height_m: {heights[first + i]}") for i in range(count))
            doors = "".join(DOOR.format(id=i + 1, a=i + 1, b=i + 2, wall=0, other=2)
                            .replace("from_m: 1, to_m: 2", f"from_m: {heights[first + i] / 2 - 0.5}, to_m: {heights[first + i] / 2 + 0.5}")
                            .replace("from_m: 2, to_m: 3", f"from_m: {heights[first + i + 1] / 2 - 0.5}, to_m: {heights[first + i + 1] / 2 + 0.5}")
                            for i in range(count - 1))
            return MAP.format(rooms=rooms, doors=doors)
        heights = [4, 5, 6, 4.5, 5.5]
        first, second, out = (self.folder / name for name in ("a.yaml", "b.yaml", "c.yaml"))
        first.write_text(row(0, 3, heights, 0))
        second.write_text(row(1, 4, heights, 2.5))
        self.assertIn("5 rooms, 4 doors", self.done("merge", first, second, "--out", out))
        self.assertIn("nothing is wrong", self.done("check", out))
        self.assertIn("through 4 doors", self.done("route", out, "--from", "1", "--to", "5"))
        self.refused("merge", first, self.map, "--out", self.folder / "d.yaml", words=[first, "in common"])
        self.refused("merge", first, second, "--out", first, words=[first])

    def test_bad_input_is_told_in_one_sentence(self):
        none = self.folder / "none.yaml"
        for verb in (["show"], ["check"], ["route", "--from", "1", "--to", "2"], ["export", "--out", self.folder / "a.svg"]):
            self.refused(verb[0], none, *verb[1:], words=[none])
        self.refused("route", self.map, "--from", "attic", "--to", "1", words=[self.map, "attic"])
        self.refused("route", self.map, "--from", "99,99", "--to", "1", words=[self.map, "99,99"])
        self.refused("route", self.map, "--from", "1", "--to", "2", "--closed", "77", words=["77"])
        self.refused("export", self.map, "--format", "dwg", "--out", self.folder / "a.dwg", words=["dwg"])
        self.refused("export", self.map, "--out", self.folder / "house.pgm", words=[self.map])
        self.refused("export", self.map, "--out", self.folder / "a.pgm", "--resolution", "0", words=["resolution"])
        self.refused("export", self.map, "--out", self.folder / "a.pgm", "--rooms", "1,9", words=["room 9"])
        self.refused("export", self.map, "--out", self.folder / "no/folder/a.svg", words=["a.svg"])
        broken = self.folder / "broken.yaml"
        broken.write_text(self.map.read_text().replace("width_m: 4", "width_m: four", 1))
        self.refused("show", broken, words=[f"{broken}:9", "width_m"])
        self.assertFalse((self.folder / "a.pgm").exists())


if __name__ == "__main__":
    unittest.main()
