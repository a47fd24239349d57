// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/component_log.hpp"

#include <utility>

#include "interfaces/topics/topics.hpp"

namespace enfilade {

ComponentLog::ComponentLog(std::string component, const Clock& clock, LogSink sink)
    : component_(std::move(component)), clock_(clock), sink_(std::move(sink)) {}

void ComponentLog::attach(Bus& bus) {
  auto rosout = std::make_shared<const Publisher<LogLine>>(bus.advertise(topics::kRosout));
  const std::lock_guard lock(mutex_);
  rosout_ = std::move(rosout);
}

void ComponentLog::detach() {
  const std::lock_guard lock(mutex_);
  rosout_.reset();
}

void ComponentLog::write(std::uint8_t level, std::string_view text) {
  const LogLine line{clock_.now_ns(), level, component_, std::string(text)};
  if (sink_) sink_(line);
  if (level >= 20) publish(line);
}

void ComponentLog::publish(const LogLine& line) {
  // A bus that cannot send logs that; the line about it must not be sent in turn.
  thread_local bool publishing = false;
  if (publishing) return;
  std::shared_ptr<const Publisher<LogLine>> rosout;
  {
    const std::lock_guard lock(mutex_);
    rosout = rosout_;
  }
  if (!rosout) return;
  publishing = true;
  try {
    rosout->publish(line);
  } catch (...) {
    publishing = false;
    throw;
  }
  publishing = false;
}

}  // namespace enfilade
