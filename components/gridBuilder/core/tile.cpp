// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/tile.hpp"

namespace enfilade::grid_builder {

std::vector<Tile::Rare>::const_iterator Tile::place_of_rare(std::size_t offset) const {
  return std::lower_bound(rare_.begin(), rare_.end(), offset,
                          [](const Rare& rare, std::size_t wanted) { return rare.offset < wanted; });
}

Cell Tile::find_rare(std::size_t offset) const { return place_of_rare(offset)->cell; }

void Tile::set_rare(std::size_t offset, Cell cell) {
  const auto place = place_of_rare(offset);
  const Rare rare{static_cast<std::uint16_t>(offset), cell};
  if (place != rare_.end() && place->offset == offset)
    rare_[static_cast<std::size_t>(place - rare_.begin())] = rare;
  else
    rare_.insert(place, rare);
}

}  // namespace enfilade::grid_builder
