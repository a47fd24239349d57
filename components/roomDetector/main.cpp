// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/node/room_detector_node.hpp"
#include "interfaces/runtime/run_component.hpp"

int main(int argc, char** argv) {
  using namespace enfilade;
  return run_component<room_detector::RoomDetectorNode, room_detector::RoomDetectorNodeConfig>("roomDetector",
                                                                                               argc, argv);
}
