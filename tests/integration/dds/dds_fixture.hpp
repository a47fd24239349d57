// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "interfaces/dds/dds_bus.hpp"
#include "interfaces/runtime/thread_executor.hpp"

namespace enfilade::test {

/// A domain of this process's own.
int own_domain();

/// Gives this process a /dev/shm of its own, of at most `bytes`; false where that is not permitted. Children
/// inherit it.
bool make_private_shared_memory(std::size_t bytes);

/// Whether `condition` comes true within `seconds`; looks a hundred times a second.
bool eventually(const std::function<bool()>& condition, double seconds = 20.0);

class RecordingLog : public Log {
 public:
  void debug(std::string_view) override {}
  void info(std::string_view) override {}
  void warn(std::string_view text) override;
  void error(std::string_view text) override { warn(text); }
  /// How many warnings contain `part`.
  int count(const std::string& part) const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> lines_;
};

/// A component of its own thread on DDS.
struct Peer {
  explicit Peer(const std::string& component, DdsConfig config = {});
  ~Peer();

  RecordingLog log;
  ThreadExecutor executor;
  std::unique_ptr<DdsBus> bus;
};

/// DdsConfig for own_domain().
DdsConfig own_config();

}  // namespace enfilade::test
