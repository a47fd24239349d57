// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "components/roomDetector/core/free_map.hpp"
#include "components/roomDetector/core/hough_lattice.hpp"

namespace enfilade::room_detector {

/// What one column of the grid says. The paper's contribution is `occupied`: one for each occupied cell.
struct Vote {
  Point2 position = Point2::Zero();
  int occupied = 0;  ///< ≥ 0, for a wall here
  int free = 0;      ///< ≥ 0, against a wall here
  int interior = 0;  ///< ≥ 0, against a room that has this column inside

  bool operator==(const Vote&) const = default;
};

/// What `score: evidence` holds against a rectangle; the paper's score has none of it.
struct Penalties {
  double per_free = 0.0;  ///< of the free votes under the centre of each bin of the contour
  int per_bin = 0;     ///< toll for each bin of the contour: wall without evidence does not come for nothing
  int near_cells = 0;  ///< free votes so near to something occupied, either way, cost nothing
  int contour_bins = 0;  ///< what is so near to the contour is not inside the room

  bool operator==(const Penalties&) const = default;
};

/// The 3D Hough space (θ, d, p) of section III-A, without its table.
///
/// The paper stores H(θ, d, p), cumulative in p. H_r only ever needs the plane of one θ at a time (α + π/2 is
/// the same plane read the other way), and most planes are never looked at: what is kept are the votes and,
/// for each θ, their sums by line, at constant d and at constant p. A changed column updates two sums for
/// each θ; HoughPlane spells a plane out when it is needed.
class HoughSpace {
 public:
  /// Votes come from the centres of cells that begin at multiples of `cell_m`.
  HoughSpace(const HoughConfig& config, const Point2& origin, double cell_m);

  const HoughLattice& lattice() const { return lattice_; }
  /// Where d = p = 0 lies.
  const Point2& origin() const { return origin_; }
  const std::vector<Vote>& votes() const { return votes_; }
  /// A sum over all votes that tells one set of them from another.
  std::uint64_t fingerprint() const { return fingerprint_; }
  /// Replaces the vote of column `index` (step 2 of the algorithm, for changed cells only).
  void set(std::size_t index, const Vote& vote);
  void set_penalties(const Penalties& penalties);
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
    return bins_at(angle, q.x(), q.y());
  }
  struct Direction {
    double cos, sin;
  };
  const Direction& direction(int angle) const { return directions_[static_cast<std::size_t>(angle)]; }
  /// The same from the origin.
  struct Binning {
    HoughLattice::Binning bin;
    double cos, sin;
    int d(double x_m, double y_m) const { return bin(x_m * cos + y_m * sin); }
    int p(double x_m, double y_m) const { return bin(y_m * cos - x_m * sin); }
    Bins operator()(double x_m, double y_m) const { return {d(x_m, y_m), p(x_m, y_m)}; }
  };
  Binning binning(int angle) const {
    const Direction& n = directions_[static_cast<std::size_t>(angle)];
    return {lattice_.binning(), n.cos, n.sin};
  }
  Bins bins_at(int angle, double x_m, double y_m) const { return binning(angle)(x_m, y_m); }
  Rectangle rectangle(const BinRectangle& r) const;

  /// A vote that speaks for a wall or against an interior, and nothing of the others.
  struct WallVote {
    double x_m, y_m;  ///< from the origin
    int occupied, interior;
  };
  const std::vector<WallVote>& wall_votes() const { return wall_votes_; }
  /// The index of the vote that each of them is of.
  const std::vector<std::size_t>& wall_voters() const { return voter_; }
  const FreeMap& free_map() const { return free_map_; }

  /// Where the centres of the bins of a plane lie in the map of free space: bin (d, p) at start + d · by_d +
  /// p · by_p.
  struct BinCentres {
    std::int32_t x, y, x_by_d, y_by_d;
    std::int32_t x_at(int d, int p) const { return x + d * x_by_d - p * y_by_d; }
    std::int32_t y_at(int d, int p) const { return y + d * y_by_d + p * x_by_d; }
  };
  BinCentres bin_centres(int angle) const;

  /// h₁₂, h₂₃, h₃₄ and h₄₁ of eq. 6–9, and H_r of eq. 5 with what `score: evidence` adds, counted vote by
  /// vote. Each wall includes its first corner, going round the contour, and excludes its last, so that every
  /// bin of the contour counts once.
  struct Terms {
    std::array<int, 4> walls{};
    int score = 0;
  };
  Terms terms(const BinRectangle& r) const;
  std::array<int, 4> walls(const BinRectangle& r) const { return terms(r).walls; }
  int score(const BinRectangle& r) const { return terms(r).score; }

 private:
  void add(const Point2& position, int occupied);
  void charge(const BinRectangle& r, std::array<int, 4>& walls) const;
  void keep_wall_vote(std::size_t index, const Vote& vote);
  std::size_t bins() const { return static_cast<std::size_t>(lattice_.bins()); }
  std::size_t offset(int angle) const { return static_cast<std::size_t>(angle) * bins(); }

  HoughLattice lattice_;
  Point2 origin_;
  std::vector<Direction> directions_;
  std::vector<Vote> votes_;
  std::vector<int> sums_by_d_, sums_by_p_;
  std::vector<WallVote> wall_votes_;
  std::vector<std::size_t> voter_;          // of each wall vote
  std::vector<std::int32_t> wall_vote_of_;  // by vote; -1 = none
  FreeMap free_map_;
  Penalties penalties_;
  std::uint64_t fingerprint_ = 0;
};

}  // namespace enfilade::room_detector
