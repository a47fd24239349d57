// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace enfilade {

/// A new empty folder among the system's temporary files, which ends with everything in it when this does.
class ScratchFolder {
 public:
  /// Throws std::system_error where none can be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace enfilade
