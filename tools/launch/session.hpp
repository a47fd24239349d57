// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "interfaces/dds/dds_bus.hpp"
#include "interfaces/runtime/component_log.hpp"
#include "interfaces/runtime/deployed_clock.hpp"
#include "interfaces/runtime/thread_executor.hpp"
#include "tools/launch/deployment.hpp"

namespace enfilade::launch {

enum class SessionEnd { kDone, kMemberLost, kInterrupted };

/// A deployment together with somebody who listens to it. All callbacks run on one thread. A member whose
/// heartbeat stops though its process lives is ended, so that the deployment starts it again; but not where
/// this process had been stopped as well.
class Session {
 public:
  /// `say` gets one line for each thing that happens to the processes.
  Session(DeploymentConfig deployment, int domain, std::function<void(const std::string&)> say);
  ~Session();

  /// To subscribe on, before run().
  Bus& bus() { return bus_; }
  /// Starts the members and waits until `done()`, asked ten times a second on the callbacks' thread, holds;
  /// or a member is lost for good; or SIGINT or SIGTERM comes. Then stops them all. No callback runs after
  /// it.
  SessionEnd run(const std::function<bool()>& done);

 private:
  std::optional<SessionEnd> look(const std::function<bool()>& done);
  void end_the_hung();

  Deployment deployment_;
  std::function<void(const std::string&)> say_;
  SystemClock clock_;
  ComponentLog log_;
  std::map<std::string, std::chrono::steady_clock::time_point> last_beat_;
  std::chrono::steady_clock::time_point last_look_ = std::chrono::steady_clock::now();
  ThreadExecutor executor_;
  DdsBus bus_;
};

}  // namespace enfilade::launch
