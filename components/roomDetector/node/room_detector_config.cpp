// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/node/room_detector_config.hpp"

namespace enfilade::room_detector {
namespace {

void bind(ConfigBinder& c, HoughConfig& hough) {
  c.number("theta_step_deg", hough.theta_step_deg, 0.1, 15.0);
  c.number("step_m", hough.step_m, 0.02, 0.5);
  c.number("range_m", hough.range_m, 2.0, 40.0);
}

void bind(ConfigBinder& c, WallBandConfig& band) {
  c.choice("band", band.band,
           {{"auto", BandChoice::kAuto}, {"all", BandChoice::kAll}, {"upper", BandChoice::kUpper}});
  c.number("wall_band_from_m", band.wall_band_from_m, 0.2, 5.0);
  c.number("wall_band_to_m", band.wall_band_to_m, 0.3, 6.0);
  c.number("floor_margin_m", band.floor_margin_m, 0.0, 1.0);
  c.number("ceiling_margin_m", band.ceiling_margin_m, 0.0, 1.0);
}

void bind(ConfigBinder& c, WallVotesConfig& votes) {
  c.choice("score", votes.score, {{"paper", Score::kPaper}, {"evidence", Score::kEvidence}});
  c.number("free_weight", votes.free_weight, 0.0, 4.0);
  c.number("interior_share", votes.interior_share, 0.0, 10.0);
  c.number("apart_share", votes.apart_share, 0.0, 10.0);
  c.number("toll_share", votes.toll_share, 0.0, 1.0);
  c.number("contour_margin_m", votes.contour_margin_m, 0.0, 1.0);
}

void bind(ConfigBinder& c, SearchConfig& search) {
  c.choice("search", search.search,
           {{"exact", SearchMethod::kExact},
            {"literal", SearchMethod::kLiteral},
            {"lines", SearchMethod::kLines}});
  c.number("side_min_m", search.side_min_m, 0.3, 20.0);
  c.number("side_max_m", search.side_max_m, 1.0, 40.0);
  c.flag("robot_inside", search.robot_inside);
  c.integer("max_expansions", search.max_expansions, 1, 1'000'000'000);
}

void bind(ConfigBinder& c, RectangleFitConfig& fit) {
  c.number("first_gate_m", fit.first_gate_m, 0.02, 1.0);
  c.number("last_gate_m", fit.last_gate_m, 0.01, 0.5);
  c.number("corner_m", fit.corner_m, 0.0, 1.0);
  c.integer("iterations", fit.iterations, 1, 100);
  c.number("min_wall_weight", fit.min_wall_weight, 1.0, 1e6);
}

void bind(ConfigBinder& c, JointFitConfig& joint) {
  c.number("motion_sigma_m", joint.motion_sigma_m, 0.0001, 1.0);
  c.number("motion_sigma_deg", joint.motion_sigma_deg, 0.001, 30.0);
  c.number("reach_m", joint.reach_m, 0.02, 1.0);
  c.number("range_sigma_m", joint.range_sigma_m, 0.0001, 0.2);
  c.number("range_bias_sigma_m", joint.range_bias_sigma_m, 0.0, 0.2);
  c.number("wall_sigma_m", joint.wall_sigma_m, 0.0, 0.1);
}

void bind(ConfigBinder& c, StandsConfig& stands) {
  c.number("move_m", stands.move_m, 0.0, 1.0);
  c.number("turn_deg", stands.turn_deg, 0.0, 90.0);
  c.integer("most", stands.most, 2, 100);
  c.number("jamb_from_m", stands.jamb_from_m, 0.0, 2.0);
  c.number("jamb_to_m", stands.jamb_to_m, 0.2, 4.0);
  c.number("sensor_forward_m", stands.sensor_forward_m, -2.0, 2.0);
  c.number("sensor_height_m", stands.sensor_height_m, 0.0, 3.0);
}

void bind(ConfigBinder& c, JambFitConfig& jamb) {
  c.number("reach_m", jamb.reach_m, 0.0, 0.5);
  c.number("face_m", jamb.face_m, 0.005, 0.2);
  c.number("reveal_from_m", jamb.reveal_from_m, 0.0, 0.5);
  c.number("reveal_to_m", jamb.reveal_to_m, 0.05, 1.0);
  c.number("reveal_width_m", jamb.reveal_width_m, 0.005, 0.2);
  c.number("min_reveal_m", jamb.min_reveal_m, 0.0, 0.5);
  c.number("min_weight", jamb.min_weight, 1.0, 1e6);
}

void bind(ConfigBinder& c, DoorFinderConfig& doors) {
  c.number("band_from_m", doors.band_from_m, 0.0, 2.0);
  c.number("band_to_m", doors.band_to_m, 0.2, 4.0);
  c.number("max_occupied_share", doors.max_occupied_share, 0.0, 1.0);
  c.number("min_free_share", doors.min_free_share, 0.0, 1.0);
  c.number("sill_m", doors.sill_m, 0.0, 2.0);
  c.number("min_width_m", doors.min_width_m, 0.1, 5.0);
  c.number("max_width_m", doors.max_width_m, 0.2, 20.0);
  c.number("min_unexplored_m", doors.min_unexplored_m, 0.02, 5.0);
  c.number("min_returns_behind", doors.min_returns_behind, 0.0, 1e6);
  c.number("beyond_from_m", doors.beyond_from_m, 0.0, 5.0);
  c.number("beyond_to_m", doors.beyond_to_m, 0.1, 30.0);
  c.group("jamb", [&](ConfigBinder& g) { bind(g, doors.jamb); });
}

}  // namespace

void bind(ConfigBinder& c, RoomDetectorNodeConfig& config) {
  RoomDetectorConfig& d = config.detector;
  c.group("period", [&](ConfigBinder& g) { enfilade::bind(g, config.period); });
  c.flag("every_line", config.every_line);
  c.number("diagnostics_period_s", config.diagnostics_period_s, 0.0, 3600.0);
  bind(c, d.hough);
  bind(c, d.band);
  bind(c, d.votes);
  bind(c, d.search);
  c.integer("search_threads", config.search_threads, 1, 64);
  c.flag("refine", d.refine);
  c.group("fit", [&](ConfigBinder& g) { bind(g, d.fit); });
  c.group("joint", [&](ConfigBinder& g) { bind(g, d.joint); });
  c.group("stands", [&](ConfigBinder& g) { bind(g, d.stands); });
  c.choice("doors", d.doors, {{"paper", DoorMethod::kPaper}, {"evidence", DoorMethod::kEvidence}});
  c.group("door_finder", [&](ConfigBinder& g) {
    bind(g, d.door_finder);
    g.number("beyond_floor_m", d.beyond_floor_m, 0.0, 2.0);
  });
  c.group("paper_doors",
          [&](ConfigBinder& g) { g.number("min_length_m", d.paper_doors.min_length_m, 0.0, 5.0); });
}

}  // namespace enfilade::room_detector
