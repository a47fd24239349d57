# SPDX-License-Identifier: Apache-2.0
"""The main job composed in one process: the paper's two rooms, whatever the seed, and rooms in a ring."""
import json
import math
import statistics
import unittest

from support import COMPONENTS, FULL, PAPER_WORLD, RING_WORLD, Finished, explore, without_wall_time

SEEDS = range(1, 21) if FULL else range(1, 6)


class PaperRooms(Finished):
    """Two suites, so that they run side by side."""

    def explore_all_seeds(self, step_m, worst_mean_m):
        errors = []
        for seed in SEEDS:
            with self.subTest(step_m=step_m, seed=seed):
                report = json.loads(explore(PAPER_WORLD, "--seed", seed, "--set", f"roomDetector.step_m={step_m}"))
                self.assert_explored(report)
                self.assertEqual({door["kind"] for door in report["doors"]}, {"passage", "exit"})
                errors.append(report["metrics"]["size_error_mean_m"])
        self.assertLessEqual(statistics.mean(errors), worst_mean_m)


class AtThePapersStep(PaperRooms):
    def test_every_room_and_door_is_found_and_sizes_are_as_good_as_the_papers(self):
        self.explore_all_seeds(0.27, 0.09)


class AtFiveCentimetres(PaperRooms):
    def test_every_room_and_door_is_found_and_sizes_are_within_three_centimetres(self):
        self.explore_all_seeds(0.05, 0.03)


class Loop(Finished):
    """Odometry takes every way and every turn for 3 % shorter than it is, four rooms round."""

    BIAS = [argument for key, value in (("left_radius_scale", 1.03), ("right_radius_scale", 1.03), ("track_scale", 1.0))
            for argument in ("--set", f"simulator.drive.{key}={value}")]

    def test_the_ring_closes_and_every_room_is_where_it_truly_is(self):
        for seed in SEEDS if FULL else SEEDS[:1]:
            with self.subTest(seed=seed):
                report = json.loads(explore(RING_WORLD, "--seed", seed, *self.BIAS))
                self.assert_explored(report)
                for room in report["rooms"]:
                    truth = room["truth"]
                    off_m = math.hypot(room["x_m"] - truth["x_m"], room["y_m"] - truth["y_m"])
                    quarters = (room["yaw_rad"] - truth["yaw_rad"]) / (math.pi / 2)
                    off_rad = abs(quarters - round(quarters)) * math.pi / 2
                    self.assertLessEqual(off_m, 0.05, room)
                    self.assertLessEqual(math.degrees(off_rad), 0.5, room)


class Survival(Finished):
    """A component dies once while room 1 is modelled and once on the way through the building."""

    def test_components_may_be_killed_and_the_rooms_are_the_same(self):
        for component in sorted(set(COMPONENTS) - {"simulator"}):
            with self.subTest(component=component):
                kills = [argument for at_s in (30, 100) for argument in ("--kill", f"{component}@{at_s}")]
                report = json.loads(explore(PAPER_WORLD, "--seed", 2, *kills))
                self.assert_explored(report)
                self.assertLessEqual(report["metrics"]["size_error_max_m"], 0.05)


class Repeatability(unittest.TestCase):
    def test_same_seed_gives_the_same_report_and_so_does_the_wire(self):
        first = without_wall_time(explore(PAPER_WORLD, "--seed", 3))
        self.assertEqual(first, without_wall_time(explore(PAPER_WORLD, "--seed", 3)))
        self.assertEqual(first, without_wall_time(explore(PAPER_WORLD, "--seed", 3, "--wire")))
        self.assertNotEqual(first, without_wall_time(explore(PAPER_WORLD, "--seed", 4)))


if __name__ == "__main__":
    unittest.main()
