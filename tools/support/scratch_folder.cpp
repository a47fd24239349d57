// SPDX-License-Identifier: Apache-2.0
#include "tools/support/scratch_folder.hpp"

#include <cerrno>
#include <string>
#include <system_error>

#include <stdlib.h>

namespace enfilade {

ScratchFolder::ScratchFolder() {
  std::string name = std::filesystem::temp_directory_path() / "enfilade-XXXXXX";
  if (!mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), "cannot make " + name);
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace enfilade
