// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "tools/launch/process.hpp"

namespace enfilade::launch {

/// One process of a deployment.
struct Member {
  std::string component;  ///< name of its executable
  std::vector<std::string> arguments;
  bool restart = true;  ///< start it again when it ends though nobody asked it to
};

struct DeploymentConfig {
  std::string bin_folder;
  std::string log_folder;  ///< one file a component
  std::vector<Member> members;
  int max_restarts = 5;                           ///< of one member, in all
  std::chrono::milliseconds stop_patience{3000};  ///< from SIGINT to SIGTERM, and from that to SIGKILL
};

/// Starts, watches and stops the processes of one system on this host.
class Deployment {
 public:
  explicit Deployment(DeploymentConfig config);
  ~Deployment();

  void start();
  /// Restarts what has died and may be restarted; returns a line for each thing that happened. To be called
  /// often.
  std::vector<std::string> watch();
  /// Kills the process of one member, if it has one, as if it had died by itself.
  bool end(const std::string& component);
  /// Whether a member is gone for good.
  bool failed() const { return failed_; }
  /// Asks all to stop, waits, insists. Returns a line for each that did not stop in good order.
  std::vector<std::string> stop();

 private:
  struct Slot {
    Member member;
    std::unique_ptr<Process> process;
    int restarts = 0;
  };

  void launch(Slot& slot);
  std::string mourn(Slot& slot, const Ending& ending);
  bool all_ended();
  void signal_all(int number);
  void wait_for_end();

  DeploymentConfig config_;
  std::vector<Slot> slots_;
  bool failed_ = false;
};

}  // namespace enfilade::launch
