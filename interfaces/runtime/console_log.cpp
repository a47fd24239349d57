// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/console_log.hpp"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

namespace enfilade {
namespace {

spdlog::level::level_enum level_of(std::uint8_t level) {
  if (level >= 40) return spdlog::level::err;
  if (level >= 30) return spdlog::level::warn;
  return level >= 20 ? spdlog::level::info : spdlog::level::debug;
}

}  // namespace

LogSink console_sink(const std::string& component, const std::string& level) {
  const auto logger =
      std::make_shared<spdlog::logger>(component, std::make_shared<spdlog::sinks::stderr_sink_mt>());
  logger->set_pattern("%H:%M:%S.%e %-7l %v");
  logger->set_level(spdlog::level::from_str(level));
  return [logger](const LogLine& line) { logger->log(level_of(line.level), "{}", line.text); };
}

}  // namespace enfilade
