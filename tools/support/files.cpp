// SPDX-License-Identifier: Apache-2.0
#include "tools/support/files.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

namespace enfilade {
namespace {

namespace fs = std::filesystem;

std::string not_writable(const std::string& path, const std::string& why) {
  return fmt::format("{}: cannot be written ({}), name another place", path, why);
}

std::string reason(int error) { return std::generic_category().message(error); }

/// Why nothing new can be put into `folder`.
std::string why_closed(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return reason(ENOENT);
  if (!fs::is_directory(folder, ignored)) return reason(ENOTDIR);
  return access(folder.c_str(), W_OK | X_OK) == 0 ? "" : reason(errno);
}

/// A device, a pipe, a folder.
bool cannot_be_replaced(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
}

std::error_code write_into(const std::string& path, const std::string& text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (file) return {};
  return {errno != 0 ? errno : EIO, std::generic_category()};
}

}  // namespace

void write_file(const std::string& path, const std::string& text) {
  if (cannot_be_replaced(path)) {
    if (const auto error = write_into(path, text))
      throw std::runtime_error(not_writable(path, error.message()));
    return;
  }
  const std::string temporary = path + ".part";
  std::error_code error = write_into(temporary, text);
  if (!error) fs::rename(temporary, path, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(temporary, ignored);
  throw std::runtime_error(not_writable(path, error.message()));
}

void make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error(not_writable(folder, error.message()));
}

std::string ending_of(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

std::string why_no_file(const std::string& path) {
  std::error_code ignored;
  if (path.empty()) return "the name of a file is empty";
  if (fs::is_directory(path, ignored)) return not_writable(path, reason(EISDIR));
  if (cannot_be_replaced(path))
    return access(path.c_str(), W_OK) == 0 ? "" : not_writable(path, reason(errno));
  const fs::path folder = fs::path(path).parent_path();
  const std::string why = why_closed(folder.empty() ? "." : folder);
  return why.empty() ? "" : not_writable(path, why);
}

std::string why_no_folder(const std::string& path) {
  std::error_code ignored;
  if (path.empty()) return "the name of a folder is empty";
  fs::path there = fs::absolute(path, ignored);
  while (there.has_relative_path() && !fs::exists(there, ignored)) there = there.parent_path();
  const std::string why = why_closed(there);
  return why.empty() ? "" : not_writable(path, why);
}

}  // namespace enfilade
