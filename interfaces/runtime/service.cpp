// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/service.hpp"

#include <unistd.h>

namespace enfilade {
namespace {

std::string& run_id() {
  static std::string id = std::to_string(getpid());
  return id;
}

}  // namespace

const std::string& process_run_id() { return run_id(); }

void set_process_run_id(std::string id) { run_id() = std::move(id); }

}  // namespace enfilade
