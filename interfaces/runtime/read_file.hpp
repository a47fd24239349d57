// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace enfilade {

/// All bytes of a file. Throws std::runtime_error that names it and says why it cannot be read.
std::string read_file(const std::string& path);

}  // namespace enfilade
