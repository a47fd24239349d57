// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "interfaces/bus/in_process_bus.hpp"
#include "interfaces/runtime/component.hpp"
#include "interfaces/runtime/component_log.hpp"
#include "interfaces/runtime/virtual_time.hpp"

namespace enfilade {

struct ComposedConfig {
  LogSink log;                                 ///< every line of every component; none = quiet
  InProcessNetwork::ThroughWire through_wire;  ///< see InProcessNetwork
};

/// Any set of nodes in one process, on the in-process bus and one virtual clock that starts at 0: as fast as
/// the CPU allows, and the same calls give the same run byte for byte. Single threaded.
class ComposedSystem {
 public:
  explicit ComposedSystem(ComposedConfig config = {});
  /// Ends every node with shutdown(), in the order of adding.
  ~ComposedSystem();
  ComposedSystem(const ComposedSystem&) = delete;
  ComposedSystem& operator=(const ComposedSystem&) = delete;

  /// Adds a component; in a running system it starts at once. The order of adding breaks ties in time.
  void add(const std::string& name, const PeriodConfig& period, MakeNode make_node);
  /// Takes a component out without a word to it, as SIGKILL does. It may be added again. Not from inside a
  /// callback.
  void kill(const std::string& name);

  /// A participant without a node, for tests that play a component; made on first use.
  Bus& bus_as(const std::string& participant);
  /// A participant that may read everything.
  Bus& tool_bus() { return bus_as("enfilade"); }

  /// initialize() of every node, in the order of adding. Done by the first run_until() if not before.
  void initialize();
  /// Runs until `stop()` holds (true) or simulated time reaches `deadline_ns` (false).
  bool run_until(const std::function<bool()>& stop, StampNs deadline_ns);

  const VirtualClock& clock() const { return clock_; }
  /// Throws std::out_of_range for a name that was not added.
  const Component& component(const std::string& name) const;

 private:
  struct Participant;
  const Participant& find(const std::string& name) const;
  std::unique_ptr<Participant> make_participant(const std::string& name);

  ComposedConfig config_;
  VirtualScheduler scheduler_;
  VirtualClock clock_{scheduler_};
  InProcessNetwork network_;
  int next_index_ = 0;
  bool initialized_ = false;
  std::map<int, std::unique_ptr<Participant>> participants_;  // by index, which is the order of adding
};

}  // namespace enfilade
