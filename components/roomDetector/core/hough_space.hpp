// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "components/roomDetector/core/hough_lattice.hpp"

namespace enfilade::room_detector {

/// What one column of the grid says. The paper's contribution is `occupied`: one for each occupied cell.
struct Vote {
  Point2 position = Point2::Zero();
  int occupied = 0;  ///< ≥ 0, for a wall here
  int free = 0;      ///< ≥ 0, against a wall here; counts in bins that hold nothing occupied
  int interior = 0;  ///< ≥ 0, against a room that has this column inside

  bool operator==(const Vote&) const = default;
};

/// What `score: evidence` holds against a rectangle; the paper's score has none of it.
struct Penalties {
  double per_free = 0.0;  ///< for each free vote in a bin of the contour that has no occupied one
  int per_bin = 0;    ///< toll for each bin of the contour: wall without evidence does not come for nothing
  int near_bins = 0;  ///< a bin with something occupied so near, either way, pays for no free votes
  int contour_bins = 0;  ///< what is so near to the contour is not inside the room
};

/// The 3D Hough space (θ, d, p) of section III-A, without its table.
///
/// The paper stores H(θ, d, p), cumulative in p. H_r only ever needs the plane of one θ at a time (α + π/2 is
/// the same plane read the other way), and most planes are never looked at: what is kept are the votes and,
/// for each θ, their sums by line, at constant d and at constant p. A changed column updates two sums for
/// each θ; HoughPlane spells a plane out when it is needed.
class HoughSpace {
 public:
  HoughSpace(const HoughConfig& config, const Point2& origin);

  const HoughLattice& lattice() const { return lattice_; }
  /// Where d = p = 0 lies.
  const Point2& origin() const { return origin_; }
  const std::vector<Vote>& votes() const { return votes_; }
  /// Replaces the vote of column `index` (step 2 of the algorithm, for changed cells only).
  void set(std::size_t index, const Vote& vote);
  void set_penalties(const Penalties& penalties) { penalties_ = penalties; }
  const Penalties& penalties() const { return penalties_; }

  /// Sum of `occupied` over each line of constant d (constant p) of plane `angle`, inside the space.
  std::span<const int> sums_by_d(int angle) const { return {&sums_by_d_[offset(angle)], bins()}; }
  std::span<const int> sums_by_p(int angle) const { return {&sums_by_p_[offset(angle)], bins()}; }

  /// The bins (d, p) of a point given in the frame of the votes: eq. 2 and the equality in eq. 3.
  struct Bins {
    int d = 0, p = 0;
  };
  Bins bins_of(int angle, const Point2& position) const {
    const Point2 q = position - origin_;
    const Direction& n = directions_[static_cast<std::size_t>(angle)];
    return {lattice_.bin(q.x() * n.cos + q.y() * n.sin), lattice_.bin(q.y() * n.cos - q.x() * n.sin)};
  }
  Rectangle rectangle(const BinRectangle& r) const;

 private:
  struct Direction {
    double cos, sin;
  };
  void add(const Point2& position, int occupied);
  std::size_t bins() const { return static_cast<std::size_t>(lattice_.bins()); }
  std::size_t offset(int angle) const { return static_cast<std::size_t>(angle) * bins(); }

  HoughLattice lattice_;
  Point2 origin_;
  std::vector<Direction> directions_;
  std::vector<Vote> votes_;
  std::vector<int> sums_by_d_, sums_by_p_;
  Penalties penalties_;
};

}  // namespace enfilade::room_detector
