// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/read_file.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace enfilade {
namespace {

[[noreturn]] void refuse_to_read(const std::string& path, int error) {
  const std::string why = error != 0 ? std::generic_category().message(error) : "it cannot be read";
  throw std::runtime_error((path.empty() ? "\"\"" : path) + ": " + why + ", name a file that can be read");
}

}  // namespace

std::string read_file(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse_to_read(path, EISDIR);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse_to_read(path, errno);
  std::ostringstream content;
  // Copying nothing counts as a failure.
  if (file.peek() != std::ifstream::traits_type::eof()) content << file.rdbuf();
  if (file.bad() || !content) refuse_to_read(path, errno);
  return content.str();
}

}  // namespace enfilade
