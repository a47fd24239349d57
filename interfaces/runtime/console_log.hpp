// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "interfaces/runtime/component_log.hpp"

namespace enfilade {

/// Lines on stderr: "12:03:44.250 info    room 1 fixed: …", from `level` ("debug", "info", "warn", "error")
/// up. The name of the component is left to whoever starts it, as `enfilade demo` does.
LogSink console_sink(const std::string& component, const std::string& level);

}  // namespace enfilade
