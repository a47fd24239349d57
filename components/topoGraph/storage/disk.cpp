// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/disk.hpp"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace enfilade::topo_graph {
namespace {

[[noreturn]] void fail_on(const std::string& what, const Disk::Path& path) {
  throw std::system_error(errno, std::generic_category(), "cannot " + what + " " + path.string());
}

class Descriptor {
 public:
  Descriptor(const Disk::Path& path, int flags) : path_(path), fd_(::open(path.c_str(), flags, 0644)) {
    if (fd_ < 0) fail_on("open", path_);
  }
  ~Descriptor() { ::close(fd_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void write_all(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t written = ::write(fd_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail_on("write", path_);
      text.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void sync() const {
    if (::fsync(fd_) != 0) fail_on("sync", path_);
  }

 private:
  Disk::Path path_;
  int fd_;
};

class RealDisk final : public Disk {
 public:
  void create(const Path& path, std::string_view text) override {
    Descriptor(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC).write_all(text);
  }
  void sync(const Path& path) override { Descriptor(path, O_RDONLY | O_CLOEXEC).sync(); }
  void append(const Path& path, std::string_view text) override {
    const Descriptor file(path, O_WRONLY | O_APPEND | O_CLOEXEC);
    file.write_all(text);
    file.sync();
  }
  void rename(const Path& from, const Path& to) override {
    if (::rename(from.c_str(), to.c_str()) != 0) fail_on("replace", to);
  }
  void sync_folder(const Path& folder) override {
    Descriptor(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC).sync();
  }
  bool exists(const Path& path) const noexcept override { return ::access(path.c_str(), F_OK) == 0; }
  bool link(const Path& file, const Path& name) noexcept override {
    return ::link(file.c_str(), name.c_str()) == 0;
  }
  void remove(const Path& path) noexcept override { ::unlink(path.c_str()); }
};

}  // namespace

Disk& real_disk() {
  static RealDisk disk;
  return disk;
}

}  // namespace enfilade::topo_graph
