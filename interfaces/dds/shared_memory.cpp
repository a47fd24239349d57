// SPDX-License-Identifier: Apache-2.0
#include "interfaces/dds/shared_memory.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace enfilade {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kPrefixes{"fastrtps_", "fast_datasharing_", "sem.fastrtps_"};

bool is_ours(const fs::path& file) {
  const std::string name = file.filename().string();
  struct stat status {};
  return std::ranges::any_of(kPrefixes, [&](std::string_view prefix) { return name.starts_with(prefix); }) &&
         lstat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == geteuid();
}

std::vector<fs::path> files_of_fast_dds(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (is_ours(entry.path())) files.push_back(entry.path());
  }
  return files;
}

/// A segment lives and dies with its lock `X_el` and its semaphore `sem.X_mutex`, which Fast DDS does not
/// keep open.
std::string segment_of(const fs::path& file) {
  std::string name = file.filename().string();
  if (name.starts_with("sem.")) name.erase(0, 4);
  for (const std::string_view suffix : {"_mutex", "_el"}) {
    if (name.ends_with(suffix)) name.erase(name.size() - suffix.size());
  }
  return name;
}

bool is_process(const fs::path& entry) {
  const std::string name = entry.filename().string();
  return std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
}

/// The segments in `folder` that some process maps or holds open, as far as we may look.
std::set<std::string> segments_in_use(const fs::path& folder) {
  std::set<std::string> used;
  std::error_code error;
  const auto note = [&](const std::string& path) {
    if (const auto at = path.find(folder.string() + "/"); at != std::string::npos)
      used.insert(segment_of(path.substr(at)));
  };
  for (const auto& process : fs::directory_iterator("/proc", error)) {
    if (!is_process(process.path())) continue;
    std::ifstream maps(process.path() / "maps");
    for (std::string line; std::getline(maps, line);) note(line);
    std::error_code gone;
    for (fs::directory_iterator fd(process.path() / "fd", gone), end; !gone && fd != end;
         fd.increment(gone)) {
      std::error_code unreadable;
      note(fs::read_symlink(fd->path(), unreadable).string());
    }
  }
  return used;
}

}  // namespace

std::optional<std::string> why_no_shared_memory(std::size_t bytes, const fs::path& folder) {
  const fs::path file = folder / ("enfilade_probe_" + std::to_string(getpid()));
  const int fd = open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (fd < 0) return folder.string() + " cannot be written: " + std::strerror(errno);
  const int failure = posix_fallocate(fd, 0, static_cast<off_t>(bytes));
  close(fd);
  unlink(file.c_str());
  if (failure == 0) return std::nullopt;
  return folder.string() + " has no room for " + std::to_string(bytes >> 20) +
         " MiB: " + std::strerror(failure);
}

int remove_stale_segments(const fs::path& folder) {
  const std::vector<fs::path> files = files_of_fast_dds(folder);  // before looking who uses them
  const std::set<std::string> used = segments_in_use(folder);
  return static_cast<int>(std::ranges::count_if(files, [&used](const fs::path& file) {
    return !used.contains(segment_of(file)) && unlink(file.c_str()) == 0;
  }));
}

}  // namespace enfilade
