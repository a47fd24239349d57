// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/node/grid_follower.hpp"

#include <cmath>
#include <utility>

namespace enfilade::room_detector {
namespace {

bool has_resolution(const GridChange& change) {
  return std::isfinite(change.resolution_m) && change.resolution_m > 0.0;
}

}  // namespace

void GridFollower::take_change(const GridChange& change) {
  if (!has_resolution(change)) return;
  if (!tag_ || !(*tag_ == change.tag)) {
    held_back_.clear();
    is_waiting_ = false;
    begin(change);
    if (change.sequence > 1) return wait_for_snapshot(change);
  }
  if (is_waiting_ && held_back_.size() >= kMostHeldBack) {
    held_back_.clear();  // a snapshot asked for now covers them
    wait_for_snapshot(change);
  } else if (is_waiting_) {
    held_back_.push_back(change);
  } else if (change.sequence > sequence_ + 1) {
    wait_for_snapshot(change);
  } else if (change.sequence > sequence_ || change.sequence == 0) {
    apply(change);
  }
}

void GridFollower::take_snapshot(const GridChange& snapshot) {
  const bool follows_stream = tag_ && !is_waiting_;
  if (follows_stream || !has_resolution(snapshot)) return;
  if (tag_ && !(*tag_ == snapshot.tag)) return handlers_.ask_for_snapshot();  // of a grid that is no more
  begin(snapshot);
  sequence_ = snapshot.sequence;
  handlers_.adopt(snapshot);
  is_waiting_ = false;
  for (const GridChange& change : std::exchange(held_back_, {})) take_change(change);
}

void GridFollower::begin(const GridChange& change) {
  tag_ = change.tag;
  sequence_ = 0;
  handlers_.start(change);
}

void GridFollower::wait_for_snapshot(const GridChange& change) {
  is_waiting_ = true;
  held_back_.push_back(change);
  handlers_.ask_for_snapshot();
}

void GridFollower::apply(const GridChange& change) {
  sequence_ = change.sequence;
  handlers_.apply(change);
}

}  // namespace enfilade::room_detector
