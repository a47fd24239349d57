// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/node/grid_builder_node.hpp"
#include "interfaces/runtime/run_component.hpp"

int main(int argc, char** argv) {
  return enfilade::run_component<enfilade::grid_builder::GridBuilderNode,
                                 enfilade::grid_builder::GridBuilderConfig>("gridBuilder", argc, argv);
}
