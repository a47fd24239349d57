// SPDX-License-Identifier: Apache-2.0
#include "tools/enfilade/live/live_system.hpp"

#include <iostream>

namespace enfilade::live {
namespace {

void warn(const LogLine& line) { std::cerr << "enfilade: " << line.text << "\n"; }

}  // namespace

LiveSystem::LiveSystem(int domain)
    : log_("enfilade", clock_, warn),
      bus_("enfilade", deployed_dds_config(domain), executor_, log_),
      context_{"enfilade", bus_, clock_, executor_, log_, lifecycle_} {
  executor_.start();
}

LiveSystem::~LiveSystem() { executor_.stop(); }

}  // namespace enfilade::live
