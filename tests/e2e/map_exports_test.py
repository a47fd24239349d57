# SPDX-License-Identifier: Apache-2.0
"""Every export of `enfilade map` is read back by somebody else's reader."""
import json
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import networkx
import yaml
from osgeo import ogr
from PIL import Image

from map_verbs_test import square_of_rooms
from support import run


def area_of(ring):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:])) / 2


class Exports(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        self.map = self.folder / "house.yaml"
        self.map.write_text(square_of_rooms())

    def export(self, form, *more):
        return self.export_to(f"out.{form}", "--format", form, *more)

    def export_to(self, name, *more):
        out = self.folder / name
        result = run("map", "export", self.map, "--out", out, *more)
        self.assertEqual(result.returncode, 0, result.stderr)
        return out


class MapExports(Exports):
    def map_server(self, form):
        """The picture as map_server would read it: a function from a point to its grey level."""
        image = Image.open(self.export(form, "--resolution", "0.1"))
        told = yaml.safe_load((self.folder / "out.yaml").read_text())
        self.assertEqual(told["image"], f"out.{form}")
        self.assertEqual((told["resolution"], told["negate"], told["mode"]), (0.1, 0, "trinary"))
        x0, y0, yaw = told["origin"]
        self.assertEqual((image.mode, yaw), ("L", 0))
        return image, lambda x, y: image.getpixel((int((x - x0) / 0.1), image.height - 1 - int((y - y0) / 0.1)))

    def test_map_server_pictures(self):
        pictures = []
        for form in ("pgm", "png"):
            image, grey = self.map_server(form)
            self.assertEqual([grey(0, 0), grey(2.1, 1.5), grey(2.1, -0.5), grey(-2.25, -1.8)], [254, 0, 254, 205], form)
            pictures.append(image.tobytes())
        self.assertEqual(*pictures)

    def test_the_ending_of_the_file_tells_the_format(self):
        for name, form in [("a.gml", "indoorgml"), ("a.indoorgml", "indoorgml"), ("a.json", "geojson"), ("a.GeoJSON", "geojson"),
                           ("a.graphml", "graphml"), ("a.SVG", "svg"), ("a.BT", "bt"), ("a.pgm", "pgm")]:
            self.assertEqual(self.export_to(name).read_bytes(), self.export(form).read_bytes(), name)
        for name in ("b.yaml", "c.yml"):
            told = yaml.safe_load(self.export_to(name).read_text())
            self.assertEqual((self.folder / told["image"]).read_bytes(), self.export("pgm").read_bytes(), name)

    def test_neither_picture_nor_yaml_takes_the_place_of_the_map(self):
        image = self.folder / "map.pgm"
        image.write_text(square_of_rooms())
        for source, out in [(self.map, "house.yaml"), (self.map, "house.pgm"), (image, "map.pgm"), (image, "map.yaml")]:
            result = run("map", "export", source, "--out", self.folder / out, "--format", "pgm")
            self.assertEqual(result.returncode, 2, out)
            self.assertIn("would destroy the map", result.stderr)
            self.assertEqual(source.read_text(), square_of_rooms())

    def test_octomap(self):
        """By octomap's own tool: the occupied voxels, as boxes of VRML."""
        file = self.export("bt", "--resolution", "0.1")
        subprocess.run(["bt2vrml", file], check=True, capture_output=True)
        text = Path(f"{file}.wrl").read_text()
        boxes = [tuple(map(float, m)) for m in re.findall(r"translation (\S+) (\S+) (\S+)[^{]*{ geometry Box { size (\S+)", text)]
        self.assertTrue(boxes, text[:500])

        def occupied(*point):
            return any(all(abs(p - c) < size / 2 for p, c in zip(point, centre)) for *centre, size in boxes)
        self.assertTrue(occupied(2.15, 1.55, 0.05))  # the wall between rooms 1 and 2
        self.assertFalse(occupied(2.15, -0.45, 1.95))  # the door in it
        self.assertTrue(occupied(2.15, -0.45, 2.05))  # its lintel
        self.assertFalse(occupied(2.15, 1.55, 2.55))
        self.assertFalse(occupied(0.05, 0.05, 1.05))

    def test_svg_has_every_room_and_dimensions(self):
        text = subprocess.run(["xmllint", "--xpath", "//*[local-name()='text']/text()", self.export("svg")],
                              capture_output=True, text=True, check=True).stdout
        for word in ("hall", "office", "door 4", "4.00 m"):
            self.assertIn(word, text)

    def test_geojson(self):
        """By the rules of RFC 7946: closed rings, counter-clockwise, lines of two positions or more."""
        file = json.loads(self.export("geojson").read_text())
        self.assertEqual(file["type"], "FeatureCollection")
        features = file["features"]
        self.assertEqual({f["type"] for f in features}, {"Feature"})
        rooms = [f for f in features if f["properties"]["kind"] == "room"]
        self.assertEqual([f["properties"]["name"] for f in rooms], ["hall", "Küche <&>", "room 3", "office"])
        for room in rooms:
            self.assertEqual(room["geometry"]["type"], "Polygon")
            ring, = room["geometry"]["coordinates"]
            self.assertEqual(ring[0], ring[-1])
            self.assertAlmostEqual(area_of(ring), 16.0)
        for door in features[4:]:
            self.assertEqual(door["geometry"]["type"], "LineString")
            self.assertGreaterEqual(len(door["geometry"]["coordinates"]), 2)
        self.assertEqual(len(features), 9)

    def test_geojson_is_read_by_gdal(self):
        ogr.UseExceptions()
        file = ogr.Open(str(self.export("geojson")))
        shapes = [(f["kind"], f["name"], f.geometry().Clone()) for f in file.GetLayer()]
        rooms = {name: shape for kind, name, shape in shapes if kind == "room"}
        doors = [shape for kind, _, shape in shapes if kind != "room"]
        self.assertEqual(sorted(rooms), ["Küche <&>", "hall", "office", "room 3"])
        self.assertEqual(len(doors), 5)
        for name, room in rooms.items():
            self.assertAlmostEqual(room.GetArea(), 16.0, msg=name)
            self.assertTrue(any(door.Distance(room) < 1e-6 for door in doors), name)
            self.assertFalse(any(door.Crosses(room) for door in doors), name)

    def test_graphml(self):
        run("map", "mark", self.map, 4, "closed")
        graph = networkx.read_graphml(self.export("graphml"))
        self.assertEqual(set(graph.nodes), {"room1", "room2", "room3", "room4", "beyond_door5"})
        self.assertEqual({frozenset(edge) for edge in graph.edges},
                         {frozenset(edge) for edge in (("room1", "room2"), ("room3", "room4"), ("room1", "room3"),
                                                       ("room2", "room4"), ("room1", "beyond_door5"))})
        self.assertEqual(graph.nodes["room2"]["name"], "Küche <&>")
        self.assertEqual(networkx.shortest_path(graph, "room4", "beyond_door5")[-2:], ["room1", "beyond_door5"])
        self.assertAlmostEqual(graph.edges["room1", "room2"]["length_m"], 2 * (2.0**2 + 0.5**2) ** 0.5 + 0.2, 5)
        self.assertEqual([edge for edge in graph.edges if graph.edges[edge].get("closed")], [("room2", "room4")])

    def test_chosen_rooms_only(self):
        features = json.loads(self.export("geojson", "--rooms", "1,3").read_text())["features"]
        self.assertEqual([f["properties"]["id"] for f in features if f["properties"]["kind"] == "room"], [1, 3])


if __name__ == "__main__":
    unittest.main()
