// SPDX-License-Identifier: Apache-2.0
#include "tests/support/etc_folder.hpp"

namespace enfilade::test {

std::string etc_folder() { return ENFILADE_SOURCE_DIR "/etc/"; }

}  // namespace enfilade::test
