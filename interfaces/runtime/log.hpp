// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace enfilade {

/// Lines for people: on the console, and from `info` up on rt/rosout.
class Log {
 public:
  virtual ~Log() = default;
  virtual void debug(std::string_view text) = 0;
  /// An event worth a line in the story of a run: "room 1 fixed: 3.19 × 3.78 m, 2 doors".
  virtual void info(std::string_view text) = 0;
  virtual void warn(std::string_view text) = 0;
  virtual void error(std::string_view text) = 0;
};

}  // namespace enfilade
