# SPDX-License-Identifier: Apache-2.0
"""Every export of `enfilade map` is read back by somebody else's reader."""
import json
import math
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import networkx
import yaml
from osgeo import ogr
from PIL import Image

from map_verbs_test import MAP, square_of_rooms
from support import run

CORE = "{http://www.opengis.net/indoorgml/1.0/core}"
GML = "{http://www.opengis.net/gml/3.2}"
XLINK = "{http://www.w3.org/1999/xlink}"
XSI = "{http://www.w3.org/2001/XMLSchema-instance}"
FEATURE = "(gml:name )*(gml:boundedBy )?"
# Of indoorgmlcore.xsd 1.0.2: which children an element has, in which order.
CHILDREN = {
    "IndoorFeatures": FEATURE + "(primalSpaceFeatures )?(multiLayeredGraph )?",
    "primalSpaceFeatures": "PrimalSpaceFeatures ",
    "PrimalSpaceFeatures": FEATURE + "(cellSpaceMember )*(cellSpaceBoundaryMember )*",
    "cellSpaceMember": "CellSpace ",
    "CellSpace": FEATURE + "(cellSpaceGeometry )?(duality )?(externalReference )*(partialboundedBy )*",
    "cellSpaceGeometry": "(Geometry3D |Geometry2D )",
    "cellSpaceBoundaryMember": "CellSpaceBoundary ",
    "CellSpaceBoundary": FEATURE + "(duality )?(cellSpaceBoundaryGeometry )?(externalReference )*",
    "cellSpaceBoundaryGeometry": "(geometry3D |geometry2D )",
    "multiLayeredGraph": "MultiLayeredGraph ",
    "MultiLayeredGraph": FEATURE + "(spaceLayers )+(interEdges )*",
    "spaceLayers": FEATURE + "(spaceLayerMember )+",
    "spaceLayerMember": "SpaceLayer ",
    "SpaceLayer": FEATURE + "(usage )*(terminationDate )?(function )*(creationDate )?(class )?(nodes )+(edges )*",
    "nodes": FEATURE + "(stateMember )+",
    "stateMember": "State ",
    "State": FEATURE + "(duality )?(connects )*(geometry )?",
    "edges": FEATURE + "(transitionMember )*",
    "transitionMember": "Transition ",
    "Transition": FEATURE + "(weight )?connects connects (duality )?(geometry )?",
    "Geometry2D": "gml:Polygon ",
    "geometry2D": "gml:LineString ",
    "geometry": "(gml:Point |gml:LineString )",
    "weight": "",
    "duality": "",
    "connects": "",
    "partialboundedBy": "",
    "gml:boundedBy": "gml:Envelope ",
    "gml:Envelope": "gml:lowerCorner gml:upperCorner ",
    "gml:Polygon": "gml:exterior ",
    "gml:exterior": "gml:LinearRing ",
    "gml:LinearRing": "(gml:pos ){4,}",
    "gml:LineString": "(gml:pos ){2,}",
    "gml:Point": "gml:pos ",
    **dict.fromkeys(("gml:name", "gml:pos", "gml:lowerCorner", "gml:upperCorner"), ""),
}

FEATURES = ("IndoorFeatures", "PrimalSpaceFeatures", "CellSpace", "CellSpaceBoundary", "MultiLayeredGraph", "spaceLayers", "SpaceLayer",
            "nodes", "State", "edges", "Transition", "gml:Polygon", "gml:LineString", "gml:Point")


def name_of(element):
    return element.tag.replace(CORE, "").replace(GML, "gml:")


def positions(element):
    return [tuple(map(float, p.text.split())) for p in element.iter(GML + "pos")]


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


class IndoorGml(Exports):
    """The structure that the standard's schema asks for, and what it cannot ask for."""

    def read(self):
        file = self.export("indoorgml")
        subprocess.run(["xmllint", "--noout", file], check=True)
        self.root = ElementTree.parse(file).getroot()
        self.by_id = {e.get(GML + "id"): e for e in self.root.iter() if e.get(GML + "id")}
        return self.root

    def linked(self, element, kind):
        """What the xlinks of the children `kind` of `element` lead to."""
        links = [child.get(XLINK + "href") for child in element.findall(CORE + kind)]
        self.assertTrue(all(link.startswith("#") for link in links), links)
        return [self.by_id[link[1:]] for link in links]

    def all(self, kind):
        return list(self.root.iter(CORE + kind))

    def test_the_root_is_what_readers_look_for(self):
        """By its name without a prefix, as the conformance test of OGC does."""
        root = self.read()
        self.assertEqual(root.tag, CORE + "IndoorFeatures")
        self.assertRegex((self.folder / "out.indoorgml").read_text(), r"(?m)^<IndoorFeatures ")
        space, schema = root.get(XSI + "schemaLocation").split()
        self.assertEqual((f"{{{space}}}", schema), (CORE, "http://schemas.opengis.net/indoorgml/1.0/indoorgmlcore.xsd"))

    def test_elements_are_those_of_the_schema_in_its_order(self):
        for element in self.read().iter():
            children = "".join(name_of(child) + " " for child in element)
            self.assertRegex(children, f"^{CHILDREN[name_of(element)]}$", name_of(element))

    def test_every_feature_has_an_id_and_no_two_the_same(self):
        self.read()
        features = [e for e in self.root.iter() if name_of(e) in FEATURES]
        ids = [e.get(GML + "id", "none") for e in features]
        self.assertEqual(len(ids), len(set(ids)))
        self.assertEqual(set(ids), set(self.by_id))
        for name in ids:
            self.assertRegex(name, r"^[A-Za-z_][\w.-]*$")  # xs:ID

    def test_every_link_leads_to_something_in_the_file(self):
        links = [e.get(XLINK + "href") for e in self.read().iter() if e.get(XLINK + "href")]
        self.assertEqual(len(links), 2 * 4 + 2 * 4 + 4 * 2 + 4 * 2 + 4 * 2)
        self.assertEqual({link[0] for link in links}, {"#"})
        self.assertLessEqual({link[1:] for link in links}, set(self.by_id))

    def test_links_lead_from_cells_to_states_and_from_boundaries_to_transitions_and_back(self):
        self.read()
        pairs = {"CellSpace": "State", "State": "CellSpace", "Transition": "CellSpaceBoundary", "CellSpaceBoundary": "Transition"}
        for kind, dual in pairs.items():
            self.assertEqual(len(self.all(kind)), 4, kind)
            for element in self.all(kind):
                other, = self.linked(element, "duality")
                self.assertEqual(name_of(other), dual)
                self.assertIs(self.linked(other, "duality")[0], element)

    def test_a_transition_connects_two_states_which_know_it(self):
        self.read()
        for transition in self.all("Transition"):
            states = self.linked(transition, "connects")
            self.assertEqual([name_of(s) for s in states], ["State", "State"])
            self.assertIsNot(*states)
            self.assertGreater(float(transition.find(CORE + "weight").text), 0)
            boundary, = self.linked(transition, "duality")
            for state in states:
                self.assertIn(transition, self.linked(state, "connects"))
                cell, = self.linked(state, "duality")
                self.assertIn(boundary, self.linked(cell, "partialboundedBy"))
        self.assertEqual(sum(len(self.linked(s, "connects")) for s in self.all("State")), 8)

    def test_coordinates_are_local(self):
        """GML 3.2 allows the labels of axes and units only beside the name of a reference system."""
        self.read()
        for kind in ("Polygon", "LineString", "Point", "Envelope"):
            for geometry in self.root.iter(GML + kind):
                self.assertEqual({k: v for k, v in geometry.attrib.items() if "id" not in k}, {"srsDimension": "2"}, kind)

    def test_geometry_is_closed_turns_left_and_lies_within_the_bounds_whichever_way_rooms_lie(self):
        turned = self.map.read_text().replace("y_m: 4.2, yaw_rad: 0", "y_m: 4.2, yaw_rad: 0.7")
        outline = "    polygon_m: [[-2, -2], [-2, 2], [2, 2], [2, -2]]\n"  # clockwise
        self.map.write_text(turned.replace("    width_m: 4\n    height_m: 4\n", "    width_m: 4\n    height_m: 4\n" + outline, 1))
        self.read()
        low, high = ([float(v) for v in self.root.find(f".//{GML}{corner}").text.split()] for corner in ("lowerCorner", "upperCorner"))
        for kind in ("Polygon", "LineString", "Point"):
            for geometry in self.root.iter(GML + kind):
                line = positions(geometry)
                self.assertFalse([a for a, b in zip(line, line[1:]) if a == b], "the same point twice in a row")
                for point in line:
                    self.assertTrue(all(a <= p <= b for a, p, b in zip(low, point, high)), point)
        for cell in self.all("CellSpace"):
            ring = positions(cell)
            self.assertEqual(ring[0], ring[-1])
            self.assertAlmostEqual(area_of(ring), 16.0, 4)

    def test_geometry_is_planar_closed_and_where_the_rooms_are(self):
        self.read()
        self.assertEqual({len(p) for p in positions(self.root)}, {2})
        for cell in self.all("CellSpace"):
            ring = positions(cell)
            self.assertEqual(ring[0], ring[-1])
            self.assertAlmostEqual(area_of(ring), 16.0)  # counter-clockwise: seen from above
            centre, = positions(self.linked(cell, "duality")[0])
            for i in (0, 1):
                self.assertAlmostEqual(centre[i], sum(p[i] for p in ring[:-1]) / 4)
        low, high = ([float(v) for v in self.root.find(f".//{GML}{corner}").text.split()] for corner in ("lowerCorner", "upperCorner"))
        self.assertEqual((low, high), ([-2.0, -2.0], [6.2, 6.2]))

    def test_ways_run_from_state_to_state_and_weigh_their_length(self):
        self.read()
        for transition in self.all("Transition"):
            way = positions(transition)
            ends = [positions(state)[0] for state in self.linked(transition, "connects")]
            self.assertEqual([way[0], way[-1]], ends)
            length = sum(math.dist(a, b) for a, b in zip(way, way[1:]))
            self.assertAlmostEqual(float(transition.find(CORE + "weight").text), length, 5)

    def test_names_are_kept(self):
        self.read()
        names = [e.text for e in self.root.findall(f".//{CORE}CellSpace/{GML}name")]
        self.assertEqual(names, ["hall", "Küche <&>", "room 3", "office"])

    def test_a_map_without_rooms_has_no_graph(self):
        self.map.write_text(MAP.format(rooms="", doors="").replace("rooms:\n", "rooms: []\n").replace("doors:\n", "doors: []\n"))
        self.test_elements_are_those_of_the_schema_in_its_order()
        self.assertEqual(self.all("MultiLayeredGraph"), [])


if __name__ == "__main__":
    unittest.main()
