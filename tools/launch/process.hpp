// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace enfilade::launch {

/// How a process ended: its exit status, or the signal that ended it.
struct Ending {
  int exit_status = 0;
  int signal = 0;

  /// After a stop that was asked for, or of its own accord without complaint.
  bool in_good_order() const { return signal == 0 && exit_status == 0; }
  std::string text() const;
};

/// A child process with its own process group; its output is appended to a file. Ends with its parent,
/// however that ends.
class Process {
 public:
  /// Throws std::runtime_error if the program cannot be started.
  Process(const std::string& program, const std::vector<std::string>& arguments, const std::string& log_file);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t pid() const { return pid_; }
  /// The ending, once there is one. Never blocks.
  std::optional<Ending> poll();
  void signal(int number);

 private:
  pid_t pid_ = -1;
  std::optional<Ending> ending_;
};

}  // namespace enfilade::launch
