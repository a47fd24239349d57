// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "tests/fuzz/map_texts.hpp"
#include "tests/unit/components/laser3D/pcd_text.hpp"

/// Writes what the fuzz targets start from, a folder each:  make_seeds FOLDER
namespace enfilade::fuzz {
namespace {

namespace fs = std::filesystem;

class SeedFolder {
 public:
  SeedFolder(const fs::path& root, const char* target) : folder_(root / target) {
    fs::create_directories(folder_);
  }

  void add(const std::string& text) {
    std::ofstream out(folder_ / ("seed" + std::to_string(++seeds_)), std::ios::binary);
    if (!(out << text).flush()) throw std::runtime_error("cannot write into " + folder_.string());
  }

 private:
  fs::path folder_;
  int seeds_ = 0;
};

void write_map_seeds(const fs::path& root) {
  SeedFolder maps(root, "map"), journals(root, "journal");
  for (int changes = 0; changes < 12; ++changes) {
    const MapTexts texts = make_map_texts(changes, changes % 4, static_cast<std::uint64_t>(changes));
    std::string input = texts.map;
    for (const std::string& change : texts.changes) input += kSeparator + change;
    maps.add(input);
  }
  const MapTexts texts = map_beside_journal();
  for (std::size_t records = 0; records <= texts.changes.size(); ++records) {
    const std::vector<std::string> first(texts.changes.begin(),
                                         texts.changes.begin() + static_cast<std::ptrdiff_t>(records));
    const std::string journal = journal_with(first, texts.map, 7);
    journals.add(journal);
    journals.add(journal.substr(0, journal.size() - 60));
  }
}

void write_scan_seeds(const fs::path& root) {
  SeedFolder pcd(root, "pcd"), three_dtk(root, "three_dtk"), carmen(root, "carmen");
  const std::vector<Point3f> points{{1.5f, -2.25f, 0.125f}, {0.0f, 3.0f, -1.0f}, {4.0f, 4.0f, 4.0f}};
  pcd.add(laser_3d::ascii_pcd(points));
  pcd.add(laser_3d::binary_pcd(points));
  pcd.add(laser_3d::compressed_pcd(points));
  pcd.add(
      "FIELDS rgb z normal x _ y\nSIZE 4 8 4 4 1 8\nTYPE U F F F U F\nCOUNT 1 1 3 1 5 1\nWIDTH 1\nHEIGHT 1\n"
      "DATA ascii\n1 2.5 0 0 0 -1 9 9 9 9 9 nan\n");
  three_dtk.add("# a scan\n100 20.5 -300\n1e2 -7 4000 17 18\nnan 0 0\n");
  three_dtk.add("0 0 0\r\n-12.25 +3 1.5e1\r\n");
  carmen.add(
      "# a log\nPARAM robot_use_laser on\nFLASER 3 1 2.5 81.83 10 20 0.5 1 2 0.25 976052857.3 nohost "
      "976052857.4\n");
  carmen.add(
      "ODOM 1 2 0.5 0 0 0 7.5 h 0.1\r\n"
      "ROBOTLASER1 0 -1.5 3.0 1.5 30 0.01 0 3 1 0 30.5 1 7 5 6 0.1 4 6 0.2 0 0 0.3 0.4 1e10 1234.5 h 0.2\n");
}

void write_world_seeds(const fs::path& root) {
  SeedFolder worlds(root, "world"), images(root, "image");
  for (const auto& entry : fs::directory_iterator(ENFILADE_WORLDS)) {
    std::ifstream in(entry.path(), std::ios::binary);
    if (entry.path().extension() == ".yaml") worlds.add({std::istreambuf_iterator<char>(in), {}});
  }
  images.add("P2\n# a map\n3 2\n255\n0 254 205\n17 255 0\n");
  images.add(std::string("P5\n3 2\n200\n") + std::string("\0\xc8\1\2\3\4", 6));
}

}  // namespace
}  // namespace enfilade::fuzz

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("usage: make_seeds FOLDER");
  enfilade::fuzz::write_map_seeds(argv[1]);
  enfilade::fuzz::write_scan_seeds(argv[1]);
  enfilade::fuzz::write_world_seeds(argv[1]);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "make_seeds: " << error.what() << "\n";
  return 1;
}
