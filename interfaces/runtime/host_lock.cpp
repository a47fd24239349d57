// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/host_lock.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace enfilade {
namespace {

std::string read_pid(int descriptor) {
  std::array<char, 32> text{};
  const ssize_t size = pread(descriptor, text.data(), text.size() - 1, 0);
  std::string pid(text.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
  if (const std::size_t end = pid.find('\n'); end != std::string::npos) pid.resize(end);
  return pid.empty() ? "?" : pid;
}

/// Whether the open file is still the one of that name: its holder removes it on the way out.
bool is_same_file(int descriptor, const std::string& file) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && stat(file.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

int open_lock_file(const std::string& file) {
  const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (descriptor >= 0) return descriptor;
  throw std::runtime_error("the lock file " + file + " cannot be opened (" + std::strerror(errno) +
                           "), make its folder writable");
}

}  // namespace

std::string runtime_folder() {
  const char* base = std::getenv("XDG_RUNTIME_DIR");
  const bool has_base = base != nullptr && *base != '\0' && access(base, W_OK | X_OK) == 0;
  const std::string folder =
      has_base ? std::string(base) + "/enfilade" : "/tmp/enfilade-" + std::to_string(geteuid());
  mkdir(folder.c_str(), 0700);  // judged by what is there afterwards
  struct stat status {};
  if (lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) {
    throw std::runtime_error("the folder " + folder +
                             " cannot be made, set XDG_RUNTIME_DIR to a writable folder");
  }
  if (status.st_uid != geteuid()) {
    throw std::runtime_error("the folder " + folder +
                             " belongs to another user, set XDG_RUNTIME_DIR to one of yours");
  }
  return folder;
}

HostLock::HostLock(const std::string& folder, const std::string& component, int domain)
    : file_(folder + "/" + component + "-" + std::to_string(domain) + ".lock") {
  while (true) {
    descriptor_ = open_lock_file(file_);
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      const std::string pid = read_pid(descriptor_);
      close(descriptor_);
      throw std::runtime_error("process " + pid + " already runs " + component + " in domain " +
                               std::to_string(domain) +
                               " on this host, stop it first or choose another --domain");
    }
    if (is_same_file(descriptor_, file_)) break;
    close(descriptor_);
  }
  const std::string pid = std::to_string(getpid()) + "\n";
  if (ftruncate(descriptor_, 0) != 0 || pwrite(descriptor_, pid.data(), pid.size(), 0) < 0) {
    // The lock holds all the same; only its holder's name is missing.
  }
}

HostLock::~HostLock() {
  unlink(file_.c_str());
  close(descriptor_);
}

}  // namespace enfilade
