// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/node/topo_graph_config.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/etc_folder.hpp"

namespace enfilade::topo_graph {
namespace {

const std::string kShipped = enfilade::test::etc_folder() + "topoGraph.yaml";

std::string resolved(const std::string& file, const ConfigOverrides& overrides = {}) {
  std::string text;
  load_config<TopoGraphConfig>(file, overrides, &text);
  return text;
}

TEST(TopoGraphConfig, ShipsTheDefaults) {
  const auto empty =
      std::filesystem::temp_directory_path() / ("topo_config_" + std::to_string(::getpid()) + ".yaml");
  std::ofstream(empty) << "{}\n";
  EXPECT_EQ(resolved(kShipped), resolved(empty));
  std::filesystem::remove(empty);
}

TEST(TopoGraphConfig, ReachesTheCore) {
  const auto config = load_config<TopoGraphConfig>(
      kShipped, {"common_door.door_faces=paper", "door_match.max_distance_m=0.4", "resume=true"});
  EXPECT_EQ(config.graph.fixer.common_door.door_faces, DoorFaces::kPaper);
  EXPECT_EQ(config.graph.fixer.face_match.max_distance_m, 0.4);
  EXPECT_EQ(config.graph.changer.face_match.max_distance_m, 0.4);
  EXPECT_TRUE(config.resume);
}

}  // namespace
}  // namespace enfilade::topo_graph
