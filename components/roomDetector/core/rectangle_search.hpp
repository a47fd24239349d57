// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "components/roomDetector/core/around_search.hpp"
#include "components/roomDetector/core/hough_plane.hpp"
#include "components/roomDetector/core/hough_space.hpp"

namespace enfilade::room_detector {

enum class SearchMethod {
  kExact,
  kLiteral,  ///< the paper's loops, for coarse bins: the baseline of the exact search and its oracle
  kLines     ///< by whole lines, as in [4]: the baseline of figure 2
};

struct SearchConfig {
  SearchMethod search = SearchMethod::kExact;
  double side_min_m = 1.5;  ///< "a specific rank of w and h" (III-A)
  double side_max_m = 15.0;
  bool robot_inside = true;    ///< only rectangles with the robot's bin strictly inside count
  int least_score = 1;         ///< what scores less is no room
  int max_expansions = 3'000;  ///< work after which the search gives up proving, 1 to 1.5 µs each: what a
                               ///< scan line every 25 ms leaves time for
};

/// The same for those who can wait for a proof, as tools do that look at one file.
inline constexpr int kPatientExpansions = 20'000;

struct SearchResult {
  BinRectangle rectangle;
  int score = 0;               ///< H_r
  std::array<int, 4> walls{};  ///< h₁₂, h₂₃, h₃₄, h₄₁: what speaks for each wall
  int gap = 0;                 ///< no rectangle scores more than score + gap; 0 = the argmax is proven
  int expansions = 0;          ///< work done
  int planes_opened = 0;

  /// Whether at least one wall shows how far the room goes each way. Two parallel walls alone are a corridor
  /// of which no end has been seen.
  bool is_closed() const { return std::max(walls[0], walls[2]) > 0 && std::max(walls[1], walls[3]) > 0; }
};

/// argmax H_r (step 3 of the algorithm) over all rectangles of the space within the limits, by branch and
/// bound. Exact unless it runs into `max_expansions`; of equally good rectangles the lexicographically first.
/// Empty where no rectangle fits the limits and scores enough.
///
/// The last answer is where the next search begins: while little changes, little is looked at, and nothing
/// where no vote has. It does not change what is found.
class RectangleSearch {
 public:
  /// Throws std::invalid_argument where the literal table of `hough` would be too large.
  explicit RectangleSearch(const SearchConfig& config, const HoughConfig& hough = {}, TaskRunner runner = {});
  std::optional<SearchResult> find_best(const HoughSpace& space, const std::optional<Point2>& robot);

 private:
  std::optional<SearchResult> search(const HoughSpace& space, const std::optional<Point2>& robot,
                                     bool& is_proven);
  void search_each_plane(const HoughSpace& space, const std::optional<Point2>& robot, Incumbent& best) const;
  void search_anywhere(const HoughSpace& space, Incumbent& best);
  std::optional<HoughSpace::Terms> begin_with_last(const HoughSpace& space,
                                                   const std::optional<Point2>& robot, Incumbent& best) const;

  /// What an answer depends on.
  struct Question {
    std::uint64_t votes = 0;
    Penalties penalties;
    Point2 origin = Point2::Zero();
    std::optional<Point2> robot;
    int angles = 0, bins = 0;

    bool operator==(const Question&) const = default;
  };

  SearchConfig config_;
  std::optional<BinRectangle> last_;
  std::optional<Question> question_;  // of answer_, where that is proven
  std::optional<SearchResult> answer_;
  HoughPlane plane_;  // these are kept for their memory
  AroundSearch around_;
};

}  // namespace enfilade::room_detector
