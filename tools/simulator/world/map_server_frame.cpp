// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/world/map_server_frame.hpp"

#include <filesystem>

namespace enfilade::simulator {

CellState MapServerFrame::state_of(std::uint8_t pixel) const {
  const double p = (negate ? pixel : 255 - pixel) / 255.0;
  if (p > occupied_from) return CellState::kOccupied;
  return p < free_below ? CellState::kFree : CellState::kUnexplored;
}

MapServerFrame read_map_server_frame(YamlFields& fields, const std::string& folder, double farthest_m) {
  MapServerFrame frame;
  frame.image = (std::filesystem::path(folder) / fields.text("image")).string();
  frame.resolution_m = fields.number("resolution", 1e-3, 10.0);
  const std::vector<double> origin = fields.numbers("origin", 3, -farthest_m, farthest_m);
  if (!origin.empty()) frame.T_map_corner = {origin[0], origin[1], origin[2]};
  frame.negate = fields.number_or("negate", 0.0, 0.0, 1.0) > 0.5;
  frame.occupied_from = fields.number_or("occupied_thresh", frame.occupied_from, 0.0, 1.0);
  frame.free_below = fields.number_or("free_thresh", frame.free_below, 0.0, 1.0);
  fields.text_or("mode", "trinary");
  return frame;
}

}  // namespace enfilade::simulator
