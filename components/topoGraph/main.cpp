// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/node/topo_graph_node.hpp"
#include "interfaces/runtime/run_component.hpp"

int main(int argc, char** argv) {
  using namespace enfilade::topo_graph;
  return enfilade::run_component<TopoGraphNode, TopoGraphConfig>("topoGraph", argc, argv);
}
