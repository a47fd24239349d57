// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace enfilade::evaluate {

struct JournalKills {
  int kills = 0;
  int lost_rooms = 0;         ///< announced by a topoGraph, and not in its map after its death
  int announced_rooms = 0;    ///< over all lives, those that a life started with included
  int rooms_at_death = 0;     ///< in the map, over all lives
  int journals_replayed = 0;  ///< deaths after which a part of the map was in the journal alone
};

/// Kills a topoGraph (SIGKILL) that fixes room after room, at random moments, and starts it again with the
/// map it left. A map file that cannot be read is an exception. Only where no other thread runs: it forks.
JournalKills kill_writers(int kills, std::uint64_t seed);

}  // namespace enfilade::evaluate
