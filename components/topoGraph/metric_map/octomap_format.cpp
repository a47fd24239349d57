// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "components/topoGraph/metric_map/map_formats.hpp"

namespace enfilade::topo_graph {
namespace {

constexpr int kDepth = 16;                  // of every OctoMap tree
constexpr int kMiddle = 1 << (kDepth - 1);  // key of coordinate 0

enum class Block { kNothing, kFree, kOccupied, kMixed };

/// A cube of 2^level cells a side; coordinates in cells of the grid, z from the floor.
struct Cube {
  int x, y, z, level;
};

/// Sums over rectangles of cells in constant time.
class StateCounts {
 public:
  explicit StateCounts(const OccupancyGrid& grid)
      : columns_(grid.columns),
        rows_(grid.rows),
        sums_(grid.index(0, grid.rows) + grid.columns + grid.rows + 1) {
    std::size_t next_door = 0;
    for (int row = 0; row < rows_; ++row) {
      Sums line{};
      for (int column = 0; column < columns_; ++column) {
        const bool is_door =
            next_door < grid.doors.size() && grid.doors[next_door].cell == grid.index(column, row);
        if (is_door) ++next_door;
        line[is_door                                    ? 2
             : grid.at(column, row) == CellState::kFree ? 0
                                                        : 1] +=
            is_door || grid.at(column, row) != CellState::kUnexplored;
        Sums& sum = sums_[at(column + 1, row + 1)] = sums_[at(column + 1, row)];
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += line[i];
      }
    }
  }

  /// Free, occupied, door cells in [x0, x1) × [y0, y1), which may reach beyond the grid.
  std::array<std::int32_t, 3> count(int x0, int y0, int x1, int y1) const {
    x0 = std::clamp(x0, 0, columns_), x1 = std::clamp(x1, 0, columns_);
    y0 = std::clamp(y0, 0, rows_), y1 = std::clamp(y1, 0, rows_);
    Sums result{};
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = sums_[at(x1, y1)][i] - sums_[at(x0, y1)][i] - sums_[at(x1, y0)][i] + sums_[at(x0, y0)][i];
    return result;
  }

 private:
  using Sums = std::array<std::int32_t, 3>;
  std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_ + 1) +
           static_cast<std::size_t>(column);
  }

  int columns_, rows_;
  std::vector<Sums> sums_;
};

class OctreeWriter {
 public:
  OctreeWriter(const OccupancyGrid& grid, double ceiling_m)
      : grid_(grid),
        counts_(grid),
        layers_(std::max(1, static_cast<int>(std::lround(ceiling_m / grid.resolution_m)))) {
    key_x_ = kMiddle + static_cast<int>(std::lround(grid.origin.x() / grid.resolution_m));
    key_y_ = kMiddle + static_cast<int>(std::lround(grid.origin.y() / grid.resolution_m));
    const int most = 1 << kDepth;
    if (key_x_ < 0 || key_y_ < 0 || key_x_ + grid.columns > most || key_y_ + grid.rows > most ||
        layers_ > kMiddle)
      throw std::invalid_argument(
          "the map reaches beyond the cells of an OctoMap; ask for a coarser resolution");
  }

  std::string write() {
    write_node({-key_x_, -key_y_, -kMiddle, kDepth});
    return fmt::format(
               "# Octomap OcTree binary file\n# drawn from a topological map\nid OcTree\nsize {}\nres "
               "{}\ndata\n",
               nodes_, grid_.resolution_m) +
           data_;
  }

 private:
  Block look(const Cube& cube) const {
    const int side = 1 << cube.level;
    if (cube.z >= layers_ || cube.z + side <= 0) return Block::kNothing;
    const auto [free, occupied, door] = counts_.count(cube.x, cube.y, cube.x + side, cube.y + side);
    if (free + occupied + door == 0) return Block::kNothing;
    if (cube.level == 0) return door ? look_at_door(cube) : free ? Block::kFree : Block::kOccupied;
    if (cube.z < 0 || cube.z + side > layers_) return Block::kMixed;
    const auto all = static_cast<std::int64_t>(side) * side;
    return free == all ? Block::kFree : occupied == all ? Block::kOccupied : Block::kMixed;
  }

  Block look_at_door(const Cube& cube) const {
    const std::size_t cell = grid_.index(cube.x, cube.y);
    const auto door = std::lower_bound(grid_.doors.begin(), grid_.doors.end(), cell,
                                       [](const DoorCell& d, std::size_t wanted) { return d.cell < wanted; });
    return (cube.z + 0.5) * grid_.resolution_m < door->lintel_m ? Block::kFree : Block::kOccupied;
  }

  /// Two bits a child: 00 nothing, 01 free, 10 occupied, 11 a node of its own (the lower bit comes first);
  /// then the nodes among the children, in their order.
  void write_node(const Cube& cube) {
    ++nodes_;
    const int half = 1 << (cube.level - 1);
    std::array<Block, 8> blocks{};
    unsigned bits = 0;
    const auto child = [&](int i) {
      return Cube{cube.x + (i & 1 ? half : 0), cube.y + (i & 2 ? half : 0), cube.z + (i & 4 ? half : 0),
                  cube.level - 1};
    };
    for (int i = 0; i < 8; ++i) {
      const Block block = blocks[static_cast<std::size_t>(i)] = look(child(i));
      bits |= static_cast<unsigned>(block) << (2 * i);
      nodes_ += block == Block::kFree || block == Block::kOccupied;
    }
    data_ += static_cast<char>(bits & 0xff);
    data_ += static_cast<char>(bits >> 8);
    for (int i = 0; i < 8; ++i)
      if (blocks[static_cast<std::size_t>(i)] == Block::kMixed) write_node(child(i));
  }

  const OccupancyGrid& grid_;
  StateCounts counts_;
  int layers_;
  int key_x_ = 0, key_y_ = 0;  ///< of the grid's first cell
  std::size_t nodes_ = 0;
  std::string data_;
};

}  // namespace

std::string to_octomap(const OccupancyGrid& grid, double ceiling_m) {
  return OctreeWriter(grid, ceiling_m).write();
}

}  // namespace enfilade::topo_graph
