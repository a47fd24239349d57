// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace enfilade::topo_graph {

/// The few things that storing needs of a file system, so that a test can stand in for a disk that loses
/// power. All throw std::system_error naming the file, but where said otherwise.
class Disk {
 public:
  using Path = std::filesystem::path;

  virtual ~Disk() = default;
  /// A new file; there must be none of that name. Durable after sync().
  virtual void create(const Path& path, std::string_view text) = 0;
  virtual void sync(const Path& path) = 0;
  /// Adds to the end of a file, which must be there; durable once it returns. After an exception any part of
  /// the text may be in the file.
  virtual void append(const Path& path, std::string_view text) = 0;
  virtual void rename(const Path& from, const Path& to) = 0;
  /// Makes the names in the folder durable.
  virtual void sync_folder(const Path& folder) = 0;
  virtual bool exists(const Path& path) const noexcept = 0;
  /// A second name for a file; false where there is no such file, or the file system has no second names.
  virtual bool link(const Path& file, const Path& name) noexcept = 0;
  /// Nothing happens where there is no such file.
  virtual void remove(const Path& path) noexcept = 0;
};

/// The operating system's.
Disk& real_disk();

}  // namespace enfilade::topo_graph
