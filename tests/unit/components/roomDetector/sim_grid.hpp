// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "interfaces/model/grid.hpp"
#include "tests/unit/components/roomDetector/sim_room.hpp"

namespace enfilade::room_detector::test {

/// A rolling range finder.
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

}  // namespace enfilade::room_detector::test
