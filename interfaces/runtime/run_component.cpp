// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/run_component.hpp"

#include "interfaces/dds/dds_bus.hpp"
#include "interfaces/runtime/process.hpp"

namespace enfilade {

int run_component(const ComponentRecipe& recipe, int argc, char** argv) {
  return run_process(recipe, argc, argv,
                     [](const std::string& component, int domain, Executor& executor, Log& log) {
                       return std::make_unique<DdsBus>(component, deployed_dds_config(domain), executor, log);
                     });
}

}  // namespace enfilade
