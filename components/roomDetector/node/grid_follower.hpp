// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include "interfaces/model/grid.hpp"

namespace enfilade::room_detector {

/// Follows a stream of grid changes without missing one: when the sequence has a gap, holds back what comes
/// until a snapshot fills it.
class GridFollower {
 public:
  struct Handlers {
    std::function<void(const GridChange&)> start;  ///< an empty grid with this tag and resolution begins
    std::function<void(const GridChange&)> apply;  ///< the next change
    std::function<void(const GridChange&)> adopt;  ///< a snapshot after start
    std::function<void()> ask_for_snapshot;
  };
  /// Changes held back at most: ten seconds of scan lines. If more come, the snapshot is asked for anew.
  static constexpr std::size_t kMostHeldBack = 400;

  explicit GridFollower(Handlers handlers) : handlers_(std::move(handlers)) {}

  void take_change(const GridChange& change);
  /// Used only where one is needed: at the start, and after a gap.
  void take_snapshot(const GridChange& snapshot);

  /// What the grid is made from; empty before the first message.
  const std::optional<ZoneTag>& tag() const { return tag_; }
  std::uint64_t sequence() const { return sequence_; }
  bool is_waiting() const { return is_waiting_; }

 private:
  void begin(const GridChange& change);
  void wait_for_snapshot(const GridChange& change);
  void apply(const GridChange& change);

  Handlers handlers_;
  std::optional<ZoneTag> tag_;
  std::uint64_t sequence_ = 0;
  bool is_waiting_ = false;
  std::deque<GridChange> held_back_;
};

}  // namespace enfilade::room_detector
