// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "components/topoGraph/core/map_problem.hpp"
#include "components/topoGraph/core/optimise/graph_solver.hpp"
#include "components/topoGraph/core/topo_state.hpp"

namespace enfilade::topo_graph {

struct MapMinimiserConfig {
  SolverConfig solver;
  double withdraw_nats =
      15.0;  ///< a new inferred door that strains the rest of the map by more is taken back
  double withdraw_weight = 0.1;  ///< as is an older one that keeps less of its pull
};

struct Minimised {
  bool moved = false;  ///< whether there was anything to minimise
  std::vector<DoorId> withdrawn;
};

/// Global minimisation (eq. 21) of the stored map, and the withdrawal of inferred doors that the rest of the
/// map contradicts.
class MapMinimiser {
 public:
  /// Throws std::invalid_argument where the configuration makes no sense.
  MapMinimiser(const MapMinimiserConfig& config, const UncertaintyConfig& uncertainty);

  /// `fresh`: inferred doors that are new. The zone's frame and reference move with the room in which the
  /// robot is, or from which it came.
  Minimised minimise(TopoState& state, const std::vector<DoorId>& fresh) const;

 private:
  bool accept(TopoState& state, DoorId fresh) const;
  std::vector<DoorId> minimise_once(TopoState& state) const;

  MapMinimiserConfig config_;
  UncertaintyConfig uncertainty_;
  std::shared_ptr<const GraphSolver> solver_;
};

/// Takes back that `door` joins its two rooms. Where a whole room had been taken for a stored one, the room
/// as it was modelled then becomes one of its own.
void withdraw(TopoState& state, DoorId door);

}  // namespace enfilade::topo_graph
