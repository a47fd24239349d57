// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmark/perception/fused_building.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "components/laser3D/core/carmen_reader.hpp"

namespace enfilade::bench {
namespace {

using namespace room_detector;
using room_detector::test::Box;

constexpr double kCell_m = 0.05;
constexpr double kHeight_m = 0.025;  // of the layer
constexpr double kMaxRange_m = 12.0;
constexpr std::size_t kPlaces = 200;

/// A level scan from a place: where its beams ended, map frame.
struct LevelScan {
  Point2 from;
  std::vector<Point2> returns;
};
using Building = std::vector<LevelScan>;

Point3f in_layer(const Point2& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(kHeight_m)};
}

ColumnMap fuse(const Building& building) {
  grid_builder::ZoneGrid grid({});
  StampNs stamp_ns = 0;
  for (const LevelScan& scan : building) {
    grid_builder::ScanLine line{.stamp_ns = ++stamp_ns, .origin = in_layer(scan.from)};
    for (const Point2& p : scan.returns) line.hits.push_back(in_layer(p));
    grid.insert(line);
  }
  const WallBandConfig band;
  std::vector<GridCell> cells;
  for (GridCell cell : grid.known_cells()) {
    for (double z = band.wall_band_from_m; z < band.wall_band_to_m - 1e-6; z += kCell_m) {
      cell.z = static_cast<std::int16_t>(std::lround(z / kCell_m));
      cells.push_back(cell);
    }
  }
  ColumnMap map;
  map.clear(kCell_m);
  map.apply(cells);
  return map;
}

/// The robot at `count` of the places the building was scanned from.
void add_inputs(std::vector<SearchInput>& inputs, const Building& building, std::size_t count,
                const HoughConfig& hough) {
  ColumnMap map = fuse(building);
  const WallBandConfig band;
  const WallBand upper{level_of(band.wall_band_from_m, kCell_m), level_of(band.wall_band_to_m, kCell_m),
                       true};
  const SearchInput all = search_input(map, upper, Score::kEvidence, hough, Point2::Zero());
  for (std::size_t i = 0; i < count; ++i) {
    SearchInput input = all;
    input.robot = building[i * building.size() / count].from;
    input.origin = Point2(std::round(input.robot->x()), std::round(input.robot->y()));
    inputs.push_back(input);
  }
}

std::filesystem::path data_folder() {
  const char* folder = std::getenv("ENFILADE_DATA");
  return folder ? folder : "data";
}

laser_3d::FileBytes contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {file.string(), std::string(std::istreambuf_iterator<char>(stream), {})};
}

Building read_building(const std::filesystem::path& file) {
  Building building;
  for (const auto& scan : laser_3d::read_carmen(contents(file)).scans)
    building.push_back({scan.T_map_laser.translation(), laser_3d::returns_of(scan, kMaxRange_m)});
  return building;
}

/// Rooms with furniture on both sides of a corridor along x, walls 0.15 m thick, a door each.
std::vector<Box> office_floor(std::mt19937& random) {
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  std::vector<Box> boxes;
  const auto add = [&](double x0, double y0, double x1, double y1) {
    boxes.push_back({{std::min(x0, x1), std::min(y0, y1), 0.0}, {std::max(x0, x1), std::max(y0, y1), 1.0}});
  };
  for (const double side : {-1.0, 1.0}) {
    for (double x = -18.0; x < 16.0;) {
      const double width = uniform(2.8, 6.5), depth = uniform(3.0, 6.0), y = side * 1.2,
                   far = side * (1.2 + depth);
      const double door = x + uniform(0.3, width - 1.4);
      add(x, y, door, y + side * 0.15);
      add(door + 0.9, y, x + width, y + side * 0.15);
      add(x, far, x + width, far + side * 0.15);
      for (const double wall : {x, x + width - 0.15}) add(wall, y, wall + 0.15, far);
      for (int i = 0; i < 6; ++i) {
        const double fx = x + uniform(0.3, width - 1.4), fy = y + side * uniform(1.0, depth - 1.0);
        if (std::abs(fy - 0.5 * (y + far)) > 0.4)
          add(fx, fy, fx + uniform(0.3, 1.2), fy + side * uniform(0.2, 0.6));
      }
      x += width;
    }
  }
  return boxes;
}

Building scan_office_floor() {
  std::mt19937 random(1);
  const auto boxes = office_floor(random);
  std::normal_distribution<double> noise_m(0.0, 0.015);
  Building building;
  for (int i = 0; i < 400; ++i) {
    LevelScan scan{.from = {-17.0 + 0.085 * i, (i % 3 - 1) * 3.0}};
    for (double beam = 0.0; beam < 360.0; beam += 0.5) {
      const Point2 way(std::cos(radians(beam)), std::sin(radians(beam)));
      const double range =
          test::cast(boxes, {scan.from.x(), scan.from.y(), kHeight_m}, {way.x(), way.y(), 1e-9});
      if (range < kMaxRange_m) scan.returns.push_back(scan.from + (range + noise_m(random)) * way);
    }
    building.push_back(scan);
  }
  return building;
}

}  // namespace

FusedBuildings fused_inputs(const HoughConfig& hough) {
  FusedBuildings all;
  const auto logs = data_folder() / "logs";
  const std::filesystem::path files[] = {logs / "intel_raw_and_corrected.clf",
                                         logs / "csail_raw_and_corrected.clf"};
  if (std::filesystem::exists(files[0]) && std::filesystem::exists(files[1])) {
    for (const auto& file : files) add_inputs(all.inputs, read_building(file), kPlaces / 2, hough);
    all.label = "Intel and CSAIL logs";
  } else {
    add_inputs(all.inputs, scan_office_floor(), kPlaces, hough);
    all.label = "made-up office floor: no logs under " + data_folder().string();
  }
  return all;
}

}  // namespace enfilade::bench
