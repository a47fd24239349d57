// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <png.h>

#include "components/topoGraph/exports/exports.hpp"
#include "components/topoGraph/metric_map/map_formats.hpp"
#include "components/topoGraph/storage/map_file.hpp"
#include "tools/draw/figures.hpp"
#include "tools/enfilade/map/map_commands.hpp"
#include "tools/support/files.hpp"

namespace enfilade::map_tool {
namespace {

namespace fs = std::filesystem;

/// What files of each format end in.
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kFormatOfEnding{
    {{".pgm", "pgm"},
     {".png", "png"},
     {".bt", "bt"},
     {".svg", "svg"},
     {".geojson", "geojson"},
     {".json", "geojson"},
     {".graphml", "graphml"},
     {".indoorgml", "indoorgml"},
     {".gml", "indoorgml"},
     {".yaml", "pgm"},
     {".yml", "pgm"}}};

std::string format_of(const ExportOptions& options) {
  const std::string name = ending_of(options.format.empty() ? options.out : "map." + options.format);
  for (const auto& [ending, format] : kFormatOfEnding)
    if (name == ending) return std::string(format);
  const std::string given = options.format.empty() ? options.out : "--format " + options.format;
  throw std::runtime_error(given +
                           ": tells no format that a map can be written in; give --format pgm, png, bt, svg, "
                           "geojson, graphml or indoorgml");
}

bool is_yaml(const std::string& path) { return ending_of(path) == ".yaml" || ending_of(path) == ".yml"; }

std::string to_png(const topo_graph::OccupancyGrid& grid) {
  const std::vector<std::uint8_t> levels = topo_graph::grey_levels(grid);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(grid.columns);
  image.height = static_cast<png_uint_32>(grid.rows);
  image.format = PNG_FORMAT_GRAY;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string file(size, '\0');
  if (!png_image_write_to_memory(&image, file.data(), &size, 0, levels.data(), 0, nullptr))
    throw std::runtime_error(std::string("the picture cannot be written as PNG: ") + image.message);
  file.resize(size);
  return file;
}

void refuse_overwriting(const std::string& map_file, const std::string& out) {
  if (fs::exists(out) && fs::equivalent(map_file, out))
    throw std::runtime_error("writing " + out + " would destroy the map itself; give --out another name");
}

/// Picture and YAML side by side, whichever of the two `out` names.
std::vector<std::string> write_map_server(const ExportOptions& options, const std::string& format,
                                          const topo_graph::OccupancyGrid& grid) {
  const bool named_yaml = is_yaml(options.out);
  const std::string image =
      named_yaml ? fs::path(options.out).replace_extension(format).string() : options.out;
  const std::string yaml = named_yaml ? options.out : fs::path(image).replace_extension(".yaml").string();
  for (const std::string& out : {image, yaml}) refuse_overwriting(options.file, out);
  write_file(image, format == "png" ? to_png(grid) : topo_graph::to_pgm(grid));
  write_file(yaml, topo_graph::to_map_server_yaml(grid, fs::path(image).filename().string()));
  return {image, yaml};
}

std::string text_of(const ExportOptions& options, const std::string& format, const TopologicalMap& map) {
  const TopologicalMap part = topo_graph::part_of(map, options.rooms);
  if (format == "svg") return draw::draw_floor_plan(part, fs::path(options.file).filename().string());
  if (format == "geojson") return topo_graph::to_geojson(part);
  return format == "graphml" ? topo_graph::to_graphml(part) : topo_graph::to_indoorgml(part);
}

}  // namespace

std::vector<std::string> export_map(const ExportOptions& options) {
  const std::string format = format_of(options);
  const TopologicalMap map = topo_graph::load_map(options.file);
  refuse_overwriting(options.file, options.out);
  try {
    if (format != "pgm" && format != "png" && format != "bt") {
      write_file(options.out, text_of(options, format, map));
      return {options.out};
    }
    const auto grid =
        topo_graph::draw_metric_map(map, {.resolution_m = options.resolution_m, .rooms = options.rooms});
    if (format != "bt") return write_map_server(options, format, grid);
    write_file(options.out, topo_graph::to_octomap(grid));
    return {options.out};
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(options.file + ": " + error.what());
  }
}

}  // namespace enfilade::map_tool
