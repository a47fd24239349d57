// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace enfilade::launch {

/// Lines of a story with one line below them that keeps changing. On anything but a terminal the changing
/// line is left out.
class Progress {
 public:
  Progress();
  ~Progress();

  /// A line that stays.
  void line(const std::string& text);
  /// What stands in the last line from now on.
  void status(const std::string& text);

 private:
  void wipe();

  bool terminal_;
  std::string status_;
};

}  // namespace enfilade::launch
