// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/node/laser_3d_node.hpp"
#include "interfaces/runtime/run_component.hpp"

int main(int argc, char** argv) {
  using namespace enfilade::laser_3d;
  return enfilade::run_component<Laser3DNode, Laser3DConfig>("laser3D", argc, argv);
}
