// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "interfaces/runtime/run_component.hpp"

namespace enfilade {

/// Joins a component to the others: its handlers go through `executor`, its complaints to `log`.
using MakeBus = std::function<std::unique_ptr<Bus>(const std::string& component, int domain,
                                                   Executor& executor, Log& log)>;

/// run_component() on whatever bus. SIGINT and SIGTERM stay blocked in the calling thread afterwards.
int run_process(const ComponentRecipe& recipe, int argc, const char* const* argv, const MakeBus& make_bus);

}  // namespace enfilade
