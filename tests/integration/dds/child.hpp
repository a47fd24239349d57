// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace enfilade::test {

/// A process started from a test; killed with it.
class Child {
 public:
  explicit Child(const std::vector<std::string>& command);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void kill();
  /// Waits for its end: the exit status, or -1 if a signal ended it.
  int wait();

 private:
  pid_t pid_ = 0;
};

}  // namespace enfilade::test
