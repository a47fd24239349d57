// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace enfilade::room_detector {

/// Entries by their `key`, kept in the order in which they were first asked for.
template <class Entry>
class KeyedTable {
 public:
  const std::deque<Entry>& entries() const { return entries_; }
  /// The entry with this key; a new one where there is none.
  Entry& at(std::uint64_t key) {
    if (last_ < entries_.size() && entries_[last_].key == key) return entries_[last_];
    if (4 * (entries_.size() + 1) > 3 * slots_.size()) grow();
    std::size_t slot = slot_of(key);
    for (; slots_[slot] != 0; slot = (slot + 1) & (slots_.size() - 1)) {
      last_ = slots_[slot] - 1;
      if (entries_[last_].key == key) return entries_[last_];
    }
    last_ = entries_.size();
    entries_.emplace_back().key = key;
    slots_[slot] = static_cast<std::uint32_t>(entries_.size());
    return entries_.back();
  }

 private:
  std::size_t slot_of(std::uint64_t key) const {
    key ^= key >> 31;
    key *= 0x9e3779b97f4a7c15ULL;
    return static_cast<std::size_t>(key >> 32) & (slots_.size() - 1);
  }
  void grow() {
    slots_.assign(slots_.empty() ? 1024 : 2 * slots_.size(), 0);
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      std::size_t slot = slot_of(entries_[i].key);
      while (slots_[slot] != 0) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = static_cast<std::uint32_t>(i + 1);
    }
  }

  std::vector<std::uint32_t> slots_;  // 1 + place among the entries, by hash of the key; 0 = none
  std::size_t last_ = 0;              // the entry asked for last: often the next one, too
  std::deque<Entry> entries_;         // never copied to grow: there may be many MB of them
};

}  // namespace enfilade::room_detector
