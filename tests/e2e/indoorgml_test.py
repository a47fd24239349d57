# SPDX-License-Identifier: Apache-2.0
"""The IndoorGML export, by the rules of the standard's schema and those that a schema cannot hold."""
import math
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree

from map_exports_test import Exports, area_of
from map_verbs_test import MAP

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
