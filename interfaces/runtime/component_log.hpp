// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "interfaces/bus/bus.hpp"
#include "interfaces/model/health.hpp"
#include "interfaces/runtime/clock.hpp"
#include "interfaces/runtime/log.hpp"

namespace enfilade {

/// Where lines end up besides rt/rosout: a console, a test's memory, nowhere.
using LogSink = std::function<void(const LogLine&)>;

/// Stamps the lines of one component, hands them to a sink and, from `info` up and once a bus is attached, to
/// rt/rosout. For any thread.
class ComponentLog : public Log {
 public:
  ComponentLog(std::string component, const Clock& clock, LogSink sink);

  /// From now on lines go to rt/rosout too; `detach` before the bus dies.
  void attach(Bus& bus);
  void detach();

  void debug(std::string_view text) override { write(10, text); }
  void info(std::string_view text) override { write(20, text); }
  void warn(std::string_view text) override { write(30, text); }
  void error(std::string_view text) override { write(40, text); }

 private:
  void write(std::uint8_t level, std::string_view text);
  void publish(const LogLine& line);

  std::string component_;
  const Clock& clock_;
  LogSink sink_;
  std::mutex mutex_;
  std::shared_ptr<const Publisher<LogLine>> rosout_;
};

}  // namespace enfilade
