// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace enfilade {

/// $XDG_RUNTIME_DIR/enfilade, else /tmp/enfilade-<uid>: of this user and for no other eyes. Made if need be;
/// throws std::runtime_error with one sentence if it cannot be, or belongs to somebody else.
std::string runtime_folder();

/// Held by the one process that runs a component in a DDS domain on this host; let go with the process,
/// however it ends.
class HostLock {
 public:
  /// Throws std::runtime_error with one sentence, naming the process that holds the lock, if another one
  /// does.
  HostLock(const std::string& folder, const std::string& component, int domain);
  ~HostLock();
  HostLock(const HostLock&) = delete;
  HostLock& operator=(const HostLock&) = delete;

 private:
  std::string file_;
  int descriptor_ = -1;
};

}  // namespace enfilade
