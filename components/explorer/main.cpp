// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/node/explorer_node.hpp"
#include "interfaces/runtime/run_component.hpp"

int main(int argc, char** argv) {
  using namespace enfilade::explorer;
  return enfilade::run_component<ExplorerNode, ExplorerConfig>("explorer", argc, argv);
}
