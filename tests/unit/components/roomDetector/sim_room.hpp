// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <tuple>
#include <vector>

#include <Eigen/Core>

#include "interfaces/model/grid.hpp"
#include "interfaces/model/room.hpp"

/// A small world of boxes, a rolling range finder and an occupancy grid: enough to show the detector rooms
/// whose truth is known.
namespace enfilade::room_detector::test {

struct Box {
  Eigen::Vector3d low, high;
};

/// A furnished room in its own frame, placed in the zone.
struct SimRoom {
  Pose2 T_zone_room;
  double width_m = 4.0, height_m = 3.0, ceiling_m = 2.6;
  std::vector<Box> boxes;
  std::vector<WallInterval> doors;  ///< true ones

  Rectangle rectangle() const {
    return {T_zone_room.yaw_rad, T_zone_room.x_m, T_zone_room.y_m, width_m, height_m};
  }
};

inline constexpr double kWallThickness = 0.15;

/// An opening in a wall between two heights.
struct Opening {
  WallInterval gap;
  double bottom_m = 0.0, top_m = 2.03;
};

class RoomBuilder {
 public:
  RoomBuilder(double width_m, double height_m, double ceiling_m) {
    room_.width_m = width_m;
    room_.height_m = height_m;
    room_.ceiling_m = ceiling_m;
  }

  RoomBuilder& at(const Pose2& T_zone_room) {
    room_.T_zone_room = T_zone_room;
    return *this;
  }
  RoomBuilder& door(int wall, double from_m, double to_m, double top_m = 2.03) {
    room_.doors.push_back({static_cast<std::uint8_t>(wall), from_m, to_m});
    openings_.push_back({room_.doors.back(), 0.0, top_m});
    return *this;
  }
  RoomBuilder& window(int wall, double from_m, double to_m) {
    openings_.push_back({{static_cast<std::uint8_t>(wall), from_m, to_m}, 0.9, 2.0});
    return *this;
  }
  RoomBuilder& box(double x0, double y0, double x1, double y1, double top_m, double bottom_m = 0.0) {
    room_.boxes.push_back({{x0, y0, bottom_m}, {x1, y1, top_m}});
    return *this;
  }

  SimRoom build() {
    for (int wall = 0; wall < 4; ++wall) add_wall(wall);
    const double x = 0.5 * room_.width_m + 6.0, y = 0.5 * room_.height_m + 6.0;
    room_.boxes.push_back({{-x, -y, -0.2}, {x, y, 0.0}});
    room_.boxes.push_back({{-x, -y, room_.ceiling_m}, {x, y, room_.ceiling_m + 0.2}});
    return room_;
  }

 private:
  void add_wall(int wall) {
    std::vector<Opening> openings;
    for (const Opening& o : openings_) {
      if (o.gap.wall == wall) openings.push_back(o);
    }
    std::sort(openings.begin(), openings.end(),
              [](const Opening& a, const Opening& b) { return a.gap.from_m < b.gap.from_m; });
    const Rectangle r{0.0, 0.0, 0.0, room_.width_m, room_.height_m};
    double at = -kWallThickness;
    for (const Opening& o : openings) {
      add_part(r, wall, at, o.gap.from_m, 0.0, room_.ceiling_m);
      add_part(r, wall, o.gap.from_m, o.gap.to_m, 0.0, o.bottom_m);
      add_part(r, wall, o.gap.from_m, o.gap.to_m, o.top_m, room_.ceiling_m);
      at = o.gap.to_m;
    }
    add_part(r, wall, at, r.wall_length_m(wall) + kWallThickness, 0.0, room_.ceiling_m);
  }

  void add_part(const Rectangle& r, int wall, double from_m, double to_m, double bottom_m, double top_m) {
    if (top_m <= bottom_m) return;
    const Segment s = r.wall(wall);
    const Point2 a = s.from + from_m * s.direction(),
                 b = s.from + to_m * s.direction() + kWallThickness * r.normal(wall);
    room_.boxes.push_back({{std::min(a.x(), b.x()), std::min(a.y(), b.y()), bottom_m},
                           {std::max(a.x(), b.x()), std::max(a.y(), b.y()), top_m}});
  }

  SimRoom room_;
  std::vector<Opening> openings_;
};

/// Distance along a ray to the nearest box, room frame.
inline double cast(const std::vector<Box>& boxes, const Eigen::Vector3d& from,
                   const Eigen::Vector3d& direction) {
  double nearest = std::numeric_limits<double>::infinity();
  const Eigen::Vector3d inverse = direction.cwiseInverse();
  for (const Box& box : boxes) {
    const Eigen::Array3d a = (box.low - from).cwiseProduct(inverse).array(),
                         b = (box.high - from).cwiseProduct(inverse).array();
    const double enter = a.min(b).maxCoeff(), leave = a.max(b).minCoeff();
    if (leave >= enter && enter > 0.0 && enter < nearest) nearest = enter;
  }
  return nearest;
}

struct SimScanConfig {
  double roll_step_deg = 2.0, beam_step_deg = 0.5, sigma_m = 0.01;
  double outlier_share = 0.002;
  double range_max_m = 12.0;
};

/// An occupancy grid with hits winning over misses within a line, as gridBuilder keeps it.
class SimGrid {
 public:
  explicit SimGrid(double resolution_m = 0.05, unsigned seed = 1)
      : resolution_m_(resolution_m),
        half_(static_cast<int>(12.0 / resolution_m)),
        levels_(static_cast<int>(4.0 / resolution_m)),
        belief_(static_cast<std::size_t>(4 * half_ * half_ * levels_), 0),
        state_(belief_.size(), CellState::kUnexplored),
        random_(seed) {}

  double resolution_m() const { return resolution_m_; }

  /// A full roll of the laser from `T_zone_base`; one ScanHits for each line.
  std::vector<ScanHits> sweep(const SimRoom& room, const Pose2& T_zone_base,
                              const SimScanConfig& config = {}) {
    std::vector<ScanHits> lines;
    for (double roll = -90.0; roll <= 90.0; roll += config.roll_step_deg) {
      lines.push_back(line(room, T_zone_base, radians(roll), config));
    }
    return lines;
  }

  /// Cells changed since the last call.
  GridChange changes() {
    GridChange change{.sequence = ++sequence_, .resolution_m = resolution_m_};
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    for (const std::size_t i : touched_) {
      const CellState now = belief_[i] > 0   ? CellState::kOccupied
                            : belief_[i] < 0 ? CellState::kFree
                                             : CellState::kUnexplored;
      if (now == state_[i]) continue;
      state_[i] = now;
      const auto n = static_cast<std::size_t>(2 * half_), h = static_cast<std::size_t>(levels_);
      change.cells.push_back({static_cast<std::int16_t>(static_cast<int>(i / (n * h)) - half_),
                              static_cast<std::int16_t>(static_cast<int>(i / h % n) - half_),
                              static_cast<std::int16_t>(static_cast<int>(i % h) - 8), now});
    }
    touched_.clear();
    return change;
  }

 private:
  double normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }
  double uniform() { return static_cast<double>(random_() >> 8) / 16777216.0; }

  ScanHits line(const SimRoom& room, const Pose2& T_zone_base, double roll, const SimScanConfig& config) {
    const Pose2 T_room_base = room.T_zone_room.inverse() * T_zone_base;
    const Point2 mount = T_room_base * Point2(0.1, 0.0), zone_mount = T_zone_base * Point2(0.1, 0.0);
    const Eigen::Vector3d from(mount.x(), mount.y(), 0.6), zone_from(zone_mount.x(), zone_mount.y(), 0.6);
    std::map<std::tuple<int, int, int>, std::vector<Eigen::Vector3d>> returns;
    std::vector<std::pair<Eigen::Vector3d, bool>> ends;
    for (double beam = -135.0; beam <= 135.0; beam += config.beam_step_deg) {
      const double a = radians(beam);
      const Eigen::Vector3d base(std::cos(a), std::sin(a) * std::cos(roll), std::sin(a) * std::sin(roll));
      const Point2 flat = rotate(T_room_base.yaw_rad, base.head<2>()),
                   zone_flat = rotate(T_zone_base.yaw_rad, base.head<2>());
      double range = cast(room.boxes, from, {flat.x(), flat.y(), base.z()});
      const bool is_hit = range < config.range_max_m;
      range = is_hit ? range + config.sigma_m * normal() : 8.0;
      if (is_hit && uniform() < config.outlier_share) range *= uniform();
      const Eigen::Vector3d end = zone_from + range * Eigen::Vector3d(zone_flat.x(), zone_flat.y(), base.z());
      ends.emplace_back(end, is_hit);
      if (is_hit) returns[cell_of(end)].push_back(end);
    }
    for (const auto& [end, is_hit] : ends) carve(zone_from, end, returns);
    ScanHits hits{.stamp_ns = ++lines_ * 25'000'000, .T_zone_base = T_zone_base};
    for (const auto& [cell, points] : returns) {
      bump(cell, 2);
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (const auto& p : points) mean += p / static_cast<double>(points.size());
      const Eigen::Vector3f m = mean.cast<float>();
      hits.hits.push_back({m.x(), m.y(), m.z(), static_cast<std::uint16_t>(points.size())});
    }
    return hits;
  }

  std::tuple<int, int, int> cell_of(const Eigen::Vector3d& p) const {
    return {static_cast<int>(std::floor(p.x() / resolution_m_)),
            static_cast<int>(std::floor(p.y() / resolution_m_)),
            static_cast<int>(std::floor(p.z() / resolution_m_))};
  }

  template <class Returns>
  void carve(const Eigen::Vector3d& from, const Eigen::Vector3d& end, const Returns& returns) {
    const Eigen::Vector3d d = end - from;
    const double length = d.norm();
    auto last = cell_of(from);
    for (double s = 0.0; s < length; s += 0.5 * resolution_m_) {
      const auto cell = cell_of(from + (s / length) * d);
      if (cell == last) continue;
      last = cell;
      if (!returns.contains(cell)) bump(cell, -1);
    }
  }

  void bump(const std::tuple<int, int, int>& cell, int by) {
    const auto [x, y, z] = cell;
    if (std::abs(x) >= half_ || std::abs(y) >= half_ || z < -8 || z + 8 >= levels_) return;
    const auto i = (static_cast<std::size_t>(x + half_) * static_cast<std::size_t>(2 * half_) +
                    static_cast<std::size_t>(y + half_)) *
                       static_cast<std::size_t>(levels_) +
                   static_cast<std::size_t>(z + 8);
    belief_[i] = static_cast<std::int8_t>(std::clamp(belief_[i] + by, -5, 9));
    touched_.push_back(i);
  }

  double resolution_m_;
  int half_, levels_;
  std::vector<std::int8_t> belief_;
  std::vector<CellState> state_;
  std::vector<std::size_t> touched_;
  std::mt19937 random_;
  std::uint64_t sequence_ = 0;
  StampNs lines_ = 0;
};

/// Furnished rooms with two doors and a corridor whose walls prolong those of the room.
class RandomRooms {
 public:
  explicit RandomRooms(unsigned seed) : random_(seed) {}

  double uniform(double a, double b) {
    return a + (b - a) * static_cast<double>(random_() >> 8) / 16777216.0;
  }
  int integer(int a, int b) { return a + static_cast<int>(random_() % static_cast<unsigned>(b - a + 1)); }

  SimRoom next() {
    const double w = uniform(2.6, 6.5), h = uniform(2.6, 6.5);
    RoomBuilder builder(w, h, uniform(2.5, 2.8));
    builder.at({uniform(-1.5, 1.5), uniform(-1.5, 1.5), uniform(-kPi, kPi)});
    const Rectangle r{0, 0, 0, w, h};
    const int first = integer(0, 3);
    std::vector<Point2> thresholds;
    for (const int wall : {first, (first + integer(1, 3)) % 4}) {
      const double from = uniform(0.3, r.wall_length_m(wall) - 1.4);
      const WallInterval gap{static_cast<std::uint8_t>(wall), from, from + uniform(0.75, 1.0)};
      builder.door(wall, gap.from_m, gap.to_m);
      thresholds.push_back(segment_of(r, gap).midpoint());
    }
    add_furniture(builder, w, h, thresholds);
    add_neighbour(builder, w, h);
    return builder.build();
  }

 private:
  void add_furniture(RoomBuilder& builder, double w, double h, const std::vector<Point2>& thresholds) {
    for (int i = integer(4, 8); i > 0; --i) {
      const double sx = uniform(0.3, 1.4), sy = uniform(0.3, 0.7), top = uniform(0.4, 2.0);
      const bool along_x = integer(0, 1);
      const double bx = along_x ? sx : sy, by = along_x ? sy : sx;
      double x = uniform(-0.5 * w, 0.5 * w - bx), y = uniform(-0.5 * h, 0.5 * h - by);
      if (integer(0, 3) > 0)
        (along_x ? y : x) =
            integer(0, 1) ? (along_x ? -0.5 * h : -0.5 * w) : (along_x ? 0.5 * h - by : 0.5 * w - bx);
      const auto covers = [&](const Point2& p, double margin) {
        return p.x() > x - margin && p.x() < x + bx + margin && p.y() > y - margin && p.y() < y + by + margin;
      };
      const bool is_in_the_way =
          covers(Point2::Zero(), 0.9) ||
          std::any_of(thresholds.begin(), thresholds.end(), [&](const Point2& p) { return covers(p, 0.8); });
      if (!is_in_the_way) builder.box(x, y, x + bx, y + by, top);
    }
  }
  /// The room next door shares two lines of wall with this one.
  void add_neighbour(RoomBuilder& builder, double w, double h) {
    const double x = 0.5 * w + kWallThickness, far = x + uniform(1.5, 5.0), t = kWallThickness;
    builder.box(x, 0.5 * h, far, 0.5 * h + t, 2.5)
        .box(x, -0.5 * h - t, far, -0.5 * h, 2.5)
        .box(far, -0.5 * h, far + t, 0.5 * h, 2.5);
  }

  std::mt19937 random_;
};

}  // namespace enfilade::room_detector::test
