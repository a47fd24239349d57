// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <random>
#include <vector>

#include "components/roomDetector/core/rectangle_search.hpp"

/// Searches and scores that are slow and obvious, to hold the fast ones against.
namespace enfilade::room_detector::test {

/// Calls visit(rectangle) with every rectangle within the limits, in order.
template <class Visit>
void for_each_rectangle(const HoughSpace& space, const SearchConfig& config,
                        const std::optional<Point2>& robot, Visit visit) {
  const double step = space.lattice().step_m();
  const int n = space.lattice().bins();
  const auto fits = [&](int gap) {
    return gap >= 1 && gap * step >= config.side_min_m - 1e-9 && gap * step <= config.side_max_m + 1e-9;
  };
  for (int a = 0; a < space.lattice().angles(); ++a) {
    const bool is_bound = robot && config.robot_inside;
    const HoughSpace::Bins at = is_bound ? space.bins_of(a, *robot) : HoughSpace::Bins{};
    for (int d12 = 0; d12 < n; ++d12) {
      for (int d34 = d12 + 1; d34 < n; ++d34) {
        if (!fits(d34 - d12) || (is_bound && (at.d <= d12 || at.d >= d34))) continue;
        for (int d41 = 0; d41 < n; ++d41) {
          for (int d23 = d41 + 1; d23 < n; ++d23) {
            if (!fits(d23 - d41) || (is_bound && (at.p <= d41 || at.p >= d23))) continue;
            visit(BinRectangle{a, d12, d34, d41, d23});
          }
        }
      }
    }
  }
}

struct Scored {
  BinRectangle rectangle;
  int score;
};

/// The first rectangle in order that no other one beats.
template <class Score>
std::optional<Scored> argmax(const HoughSpace& space, const SearchConfig& config,
                             const std::optional<Point2>& robot, Score score) {
  std::optional<Scored> best;
  for_each_rectangle(space, config, robot, [&](const BinRectangle& r) {
    const int s = score(r);
    if (!best || s > best->score) best = Scored{r, s};
  });
  return best;
}

/// Weights of the bins of one plane, binned anew, with everything `score: evidence` knows.
class DirectPlane {
 public:
  DirectPlane(const HoughSpace& space, int angle) : space_(space) {
    const int n = space.lattice().bins();
    weight_.assign(static_cast<std::size_t>(n * n), 0);
    interior_ = weight_;
    const auto at = space.bin_centres(angle);
    for (int d = 0; d < n && space.free_map().charges(); ++d) {
      for (int p = 0; p < n; ++p)
        weight_[index(d, p)] -= space.free_map().charge_at(at.x_at(d, p), at.y_at(d, p));
    }
    for (const Vote& vote : space.votes()) {
      const auto b = space.bins_of(angle, vote.position);
      if (!space.lattice().holds(b.d) || !space.lattice().holds(b.p)) continue;
      weight_[index(b.d, b.p)] += vote.occupied;
      interior_[index(b.d, b.p)] += vote.interior;
    }
  }

  int weight(int d, int p) const { return weight_[index(d, p)]; }

  /// Walks along the contour and over the inside.
  int score(const BinRectangle& r) const {
    int sum = 0;
    for (int d = r.d12; d <= r.d34; ++d) {
      for (int p = r.d41; p <= r.d23; ++p) {
        const bool on_contour = d == r.d12 || d == r.d34 || p == r.d41 || p == r.d23;
        const int depth = std::min(std::min(d - r.d12, r.d34 - d), std::min(p - r.d41, r.d23 - p));
        if (on_contour) sum += weight(d, p) - space_.penalties().per_bin;
        if (depth > space_.penalties().contour_bins) sum -= interior_[index(d, p)];
      }
    }
    return sum;
  }

 private:
  std::size_t index(int d, int p) const { return static_cast<std::size_t>(d * space_.lattice().bins() + p); }

  const HoughSpace& space_;
  std::vector<int> weight_, interior_;
};

/// O(A N² W): every pair (d12, d34) of every plane with its line search, and no bounds.
class Exhaustion {
 public:
  Exhaustion(const HoughSpace& space, const SearchConfig& config, const std::optional<Point2>& robot)
      : space_(space), config_(config), robot_(robot) {}

  std::optional<Scored> argmax() {
    for (int a = 0; a < space_.lattice().angles(); ++a) {
      plane_.build(space_, a);
      const WindowLimits d = limits(robot_ ? space_.bins_of(a, *robot_).d : -1);
      for (int d12 = 0; d12 < plane_.bins() && d12 <= d.last_first; ++d12) {
        for (int d34 = std::max(d12 + d.min_gap, d.first_second);
             d34 < plane_.bins() && d34 <= d12 + d.max_gap; ++d34)
          search_lines(d12, d34, limits(robot_ ? space_.bins_of(a, *robot_).p : -1));
      }
    }
    return best_;
  }

 private:
  WindowLimits limits(int robot) const {
    const double step = space_.lattice().step_m();
    WindowLimits limits{.min_gap = std::max(1, static_cast<int>(std::ceil(config_.side_min_m / step - 1e-9))),
                        .max_gap = static_cast<int>(std::floor(config_.side_max_m / step + 1e-9))};
    if (robot_) limits.last_first = robot - 1;
    if (robot_) limits.first_second = robot + 1;
    return limits;
  }
  void search_lines(int d12, int d34, const WindowLimits& limits) {
    const HoughPlane& h = plane_;
    const int toll = 2 * h.toll();
    const Window w = best_window(
        h.bins(), limits,
        [&](int p) {
          return -h.along_p(d12, p) - h.along_p(d34, p + 1) + h.along_d(d34 + 1, p) - h.along_d(d12 + 1, p) +
                 h.interior_above(d12, d34, p) + toll * p;
        },
        [&](int p) {
          return h.along_p(d12, p) + h.along_p(d34, p + 1) + h.along_d(d34, p) - h.along_d(d12, p) -
                 h.interior_below(d12, d34, p) - toll * p;
        });
    if (w.first < 0) return;
    const BinRectangle r{h.alpha(), d12, d34, w.first, w.second};
    const int score = h.score(r);
    if (!best_ || score > best_->score) best_ = Scored{r, score};
  }

  const HoughSpace& space_;
  SearchConfig config_;
  std::optional<Point2> robot_;
  HoughPlane plane_;
  std::optional<Scored> best_;
};

/// Random worlds: rooms with walls, clutter and noise, or nothing but noise.
class RandomWorld {
 public:
  explicit RandomWorld(unsigned seed) : random_(seed) {}
  double uniform(double a, double b) {
    return a + (b - a) * static_cast<double>(random_() >> 8) / 16777216.0;
  }
  int integer(int a, int b) { return a + static_cast<int>(random_() % static_cast<unsigned>(b - a + 1)); }

  std::vector<Vote> votes(double extent_m, double spacing_m) {
    std::vector<Vote> votes;
    for (int room = integer(0, 3); room > 0; --room) add_room(votes, extent_m, spacing_m);
    for (int clutter = integer(5, 120); clutter > 0; --clutter) {
      votes.push_back({{uniform(-extent_m, extent_m), uniform(-extent_m, extent_m)},
                       integer(0, 4),
                       integer(0, 4),
                       integer(0, 2)});
    }
    return votes;
  }

 private:
  void add_room(std::vector<Vote>& votes, double extent_m, double spacing_m) {
    const Rectangle room{uniform(-kPi, kPi), uniform(-0.4, 0.4) * extent_m, uniform(-0.4, 0.4) * extent_m,
                         uniform(0.3, 1.2) * extent_m, uniform(0.3, 1.2) * extent_m};
    for (int wall = 0; wall < 4; ++wall) {
      if (integer(0, 5) == 0) continue;  // unseen
      for (double s = 0.0; s < room.wall_length_m(wall); s += spacing_m) {
        votes.push_back(
            {room.corner(wall) + s * room.wall(wall).direction(), integer(1, 6), 0, integer(0, 1)});
      }
    }
  }

  std::mt19937 random_;
};

}  // namespace enfilade::room_detector::test
