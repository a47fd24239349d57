// SPDX-License-Identifier: Apache-2.0
#include "interfaces/dds/dds_config.hpp"

#include <cstdlib>
#include <string_view>

namespace enfilade {

DdsConfig deployed_dds_config(int domain) {
  const char* const wish = std::getenv("ENFILADE_SHARED_MEMORY");
  return {.domain = domain, .shared_memory = wish == nullptr || std::string_view(wish) != "off"};
}

}  // namespace enfilade
