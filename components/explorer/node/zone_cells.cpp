// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/node/zone_cells.hpp"

namespace enfilade::explorer {

ZoneCells::Verdict ZoneCells::take(const GridChange& change) {
  if (tag_ != change.tag) {
    grid_.clear();
    tag_ = change.tag;
    complete_ = change.sequence == 0;
    sequence_ = 0;
    if (complete_) grid_.apply(change.resolution_m, change.cells);
    return complete_ ? Verdict::kTaken : Verdict::kNeedsSnapshot;
  }
  if (complete_ && change.sequence <= sequence_) return Verdict::kTaken;
  if (!complete_ || change.sequence != sequence_ + 1) {
    complete_ = false;
    return Verdict::kNeedsSnapshot;
  }
  sequence_ = change.sequence;
  grid_.apply(change.resolution_m, change.cells);
  return Verdict::kTaken;
}

void ZoneCells::take_snapshot(const GridChange& snapshot) {
  if (complete_ && tag_ == snapshot.tag && snapshot.sequence < sequence_) return;
  grid_.clear();
  grid_.apply(snapshot.resolution_m, snapshot.cells);
  tag_ = snapshot.tag;
  sequence_ = snapshot.sequence;
  complete_ = true;
}

}  // namespace enfilade::explorer
