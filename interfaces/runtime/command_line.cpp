// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/command_line.hpp"

#include <cstdlib>
#include <filesystem>

#include <CLI/CLI.hpp>

#include "interfaces/runtime/config_values.hpp"
#include "interfaces/runtime/usage_error.hpp"

namespace enfilade {
namespace {

constexpr int kMaxDomain = 232;  // the last whose UDP ports exist

}  // namespace

ParsedCommandLine parse_command_line(const std::string& component, int argc, const char* const* argv) {
  CommandLine line;
  int domain = 0;
  CLI::App app{"The component " + component + " of Enfilade. Runs until SIGINT or SIGTERM.", component};
  app.failure_message(usage_error);
  app.add_option("--config", line.config_file, "configuration file (default: etc/" + component + ".yaml)")
      ->type_name("FILE");
  app.add_option("--set", line.overrides, "overrides one key of the configuration, may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  const auto* domain_option =
      app.add_option("--domain", domain,
                     "DDS domain (default: $ENFILADE_DOMAIN, else $ROS_DOMAIN_ID, else 0)")
          ->check(CLI::Range(0, kMaxDomain));
  app.add_flag("--sim-time", line.sim_time, "live in the time of rt/clock, which the simulator publishes");
  app.add_option("--log-level", line.log_level, "least level to print")
      ->check(CLI::IsMember({"debug", "info", "warn", "error"}))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return {{}, app.exit(e) == 0 ? 0 : 2};
  }
  if (!domain_option->empty()) line.domain = domain;
  return {line, 0};
}

std::optional<std::string> process_environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr || *value == '\0' ? std::nullopt : std::optional<std::string>(value);
}

int resolve_domain(std::optional<int> from_command_line, const Environment& environment) {
  if (from_command_line) return *from_command_line;
  for (const char* name : {"ENFILADE_DOMAIN", "ROS_DOMAIN_ID"}) {
    const auto text = environment(name);
    if (!text) continue;
    const auto domain = parse_integer(*text, 0, kMaxDomain);
    if (!domain.value) throw ConfigError(std::string(name) + ": " + domain.problem);
    return *domain.value;
  }
  return 0;
}

std::string find_config_file(const std::string& component, const std::string& executable,
                             const Environment& environment) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(executable).parent_path();
  std::vector<fs::path> places{folder / "../../../etc",
                               folder / "../share/enfilade/etc"};  // checkout, install
  if (const auto etc = environment("ENFILADE_ETC")) places = {*etc};
  std::string looked;
  for (const fs::path& place : places) {
    const fs::path file = (place / (component + ".yaml")).lexically_normal();
    std::error_code ignored;
    if (fs::exists(file, ignored)) return file.string();
    looked += (looked.empty() ? "" : ", ") + file.string();
  }
  throw ConfigError("no configuration file (looked for " + looked + "), name one with --config");
}

std::string executable_path() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).string();
}

}  // namespace enfilade
