// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include "tools/room/survey.hpp"

namespace enfilade::room {
namespace {

constexpr int kDepth = 16;  // of OctoMap's trees
constexpr int kCellOfOrigin = 1 << (kDepth - 1);
constexpr std::size_t kMostCells = 60'000'000;
constexpr double kHeight_m = 12.0;  // of what is looked at, over the floor's lowest cell

/// Where the tree begins, and how large its cells are.
struct TreeHeader {
  double resolution_m = 0.0;
  std::size_t nodes = 0;
  std::size_t data = 0;
};

/// A cube of cells of one state.
struct Cube {
  int x = 0, y = 0, z = 0, side = 1;
  bool occupied = false;
};

TreeHeader read_header(const laser_3d::FileBytes& file) {
  TreeHeader header;
  laser_3d::TextLines lines(file.bytes);
  const auto first = lines.next();
  if (!first || *first != "# Octomap OcTree binary file")
    laser_3d::reject(file, "does not begin like an OctoMap .bt file: save it with octomap's writeBinary");
  while (const auto line = lines.next()) {
    const auto word = laser_3d::words(*line);
    if (word.empty()) continue;
    if (word[0] == "data") {
      header.data = lines.offset();
      break;
    }
    if (word[0] == "id" && (word.size() < 2 || word[1] != "OcTree"))
      laser_3d::reject_line(file, lines.number(), "only trees of the kind OcTree can be read");
    if (word[0] == "size" && word.size() > 1) header.nodes = laser_3d::to_count(word[1]).value_or(0);
    if (word[0] == "res" && word.size() > 1) header.resolution_m = laser_3d::to_number(word[1]).value_or(0.0);
  }
  if (header.data == 0) laser_3d::reject(file, "has no line 'data': the file is cut off; get it again");
  if (!(header.resolution_m >= 0.01 && header.resolution_m <= 1.0))
    laser_3d::reject(file, "its 'res' must lie in 0.01 … 1 m");
  return header;
}

/// OctoMap's binary tree: two bits a child in two bytes a node, depth first: 01 free, 10 occupied, 11 a node
/// of its own, first bit last.
class TreeReader {
 public:
  TreeReader(const laser_3d::FileBytes& file, std::size_t at) : file_(file), at_(at) {}

  std::vector<Cube> read(std::size_t nodes) {
    if (nodes > 0) read_node({0, 0, 0, 1 << kDepth});
    return std::move(cubes_);
  }

 private:
  unsigned byte() {
    if (at_ >= file_.bytes.size())
      laser_3d::reject(file_, "the tree ends in the middle: the file is cut off; get it again");
    return static_cast<unsigned char>(file_.bytes[at_++]);
  }

  void read_node(const Cube& node) {
    if (node.side == 1)
      laser_3d::reject(file_, "the tree is deeper than 16 levels: it is damaged; get it again");
    const unsigned low = byte(), children = low | byte() << 8;
    const int half = node.side / 2;
    const auto child = [&](int i, bool occupied) {
      return Cube{node.x + (i & 1) * half, node.y + (i >> 1 & 1) * half, node.z + (i >> 2 & 1) * half, half,
                  occupied};
    };
    for (int i = 0; i < 8; ++i) {
      const unsigned kind = children >> (2 * i) & 3U;
      if (kind == 1U || kind == 2U) cubes_.push_back(child(i, kind == 2U));
    }
    for (int i = 0; i < 8; ++i) {
      if ((children >> (2 * i) & 3U) == 3U) read_node(child(i, false));
    }
  }

  const laser_3d::FileBytes& file_;
  std::size_t at_;
  std::vector<Cube> cubes_;
};

/// Cell layer of the floor: the lowest that is occupied over a large area. A floor on the border of two
/// layers lies in the fuller one.
int floor_layer(const std::vector<Cube>& cubes) {
  constexpr double kLargeShare = 0.3;  // of the largest layer
  std::map<int, double> area;
  double largest = 0.0;
  for (const Cube& c : cubes) {
    if (!c.occupied) continue;
    area[c.z] += static_cast<double>(c.side) * c.side;
    largest = std::max(largest, area[c.z]);
  }
  for (const auto& [layer, cells] : area) {
    const auto above = area.find(layer + 1);
    const double cells_above = above == area.end() ? 0.0 : above->second;
    if (cells + cells_above >= kLargeShare * largest) return cells_above > cells ? layer + 1 : layer;
  }
  return kCellOfOrigin;
}

void append_cells(const Cube& cube, int floor, Survey& survey) {
  const auto top = static_cast<int>(kHeight_m / survey.resolution_m);
  const CellState state = cube.occupied ? CellState::kOccupied : CellState::kFree;
  const int z_from = std::max(cube.z - floor, -16), z_to = std::min(cube.z - floor + cube.side, top);
  for (int x = cube.x - kCellOfOrigin; x < cube.x - kCellOfOrigin + cube.side; ++x) {
    for (int y = cube.y - kCellOfOrigin; y < cube.y - kCellOfOrigin + cube.side; ++y) {
      for (int z = z_from; z < z_to; ++z)
        survey.cells.push_back(grid_builder::to_grid_cell({x, y, z}, state));
    }
  }
}

}  // namespace

Survey survey_of_octree(const laser_3d::FileBytes& file) {
  const TreeHeader header = read_header(file);
  const std::vector<Cube> cubes = TreeReader(file, header.data).read(header.nodes);
  Survey survey{.resolution_m = header.resolution_m, .is_fused = true};
  const int floor = floor_layer(cubes);
  for (const Cube& cube : cubes) {
    const double volume = std::pow(cube.side, 2) * std::min(cube.side, 400);
    if (volume > static_cast<double>(kMostCells - survey.cells.size()))
      laser_3d::reject(file, "holds more than 60 million cells: save a part of it, or coarser");
    append_cells(cube, floor, survey);
  }
  survey.T_survey_stand = roomiest_place(survey);
  return survey;
}

}  // namespace enfilade::room
