// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/paths.hpp"

#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

namespace enfilade {
namespace {

constexpr int kMaxDomain = 232;  // RTPS: higher ones have no UDP ports

std::optional<int> domain_from(const char* variable) {
  const char* text = std::getenv(variable);
  if (!text || !*text) return std::nullopt;
  int domain = -1;
  const char* end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, domain);
  if (error != std::errc{} || stop != end || domain < 0 || domain > kMaxDomain) {
    throw std::runtime_error(
        fmt::format("{}={}: not a DDS domain: set it to a number from 0 to {}", variable, text, kMaxDomain));
  }
  return domain;
}

}  // namespace

std::string executable_folder() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path().string();
}

std::string etc_folder() {
  if (const char* folder = std::getenv("ENFILADE_ETC"); folder && *folder) return folder;
  const std::filesystem::path bin = executable_folder();
  for (const auto& folder : {bin / "../../../etc", bin / "../share/enfilade/etc"}) {
    if (std::filesystem::is_directory(folder)) return std::filesystem::canonical(folder).string();
  }
  throw std::runtime_error("no configuration folder near " + bin.string() +
                           ": set ENFILADE_ETC to the folder that holds the YAML files");
}

std::string config_file(const std::string& component) { return etc_folder() + "/" + component + ".yaml"; }

int resolve_domain(std::optional<int> asked) {
  if (asked) return *asked;
  if (const auto domain = domain_from("ENFILADE_DOMAIN")) return *domain;
  return domain_from("ROS_DOMAIN_ID").value_or(0);
}

}  // namespace enfilade
