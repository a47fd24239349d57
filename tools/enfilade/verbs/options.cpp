// SPDX-License-Identifier: Apache-2.0
#include "tools/enfilade/verbs/options.hpp"

#include <ctime>
#include <limits>

#include "interfaces/runtime/config_values.hpp"
#include "tools/support/files.hpp"

namespace enfilade {
namespace {

constexpr int kGreatest = std::numeric_limits<int>::max();

}  // namespace

CLI::Validator number_in(double least, double most) {
  const auto problem = [least, most](std::string& text) { return parse_number(text, least, most).problem; };
  return {problem, format_number(least) + " to " + format_number(most), "number"};
}

CLI::Validator whole_number_in(int least, int most) {
  const auto problem = [least, most](std::string& text) { return parse_integer(text, least, most).problem; };
  return {problem, most == kGreatest ? "whole" : std::to_string(least) + " to " + std::to_string(most),
          "number"};
}

CLI::Validator whole_number() { return whole_number_in(0, kGreatest); }

CLI::Option* add_seed(CLI::App& command, std::uint64_t& seed, const std::string& what) {
  return command.add_option("--seed", seed, what)->check(whole_number());
}

CLI::Option* add_numbers(CLI::App& command, const std::string& name, std::vector<std::uint32_t>& numbers,
                         const std::string& what) {
  return command.add_option(name, numbers, what)->delimiter(',')->check(whole_number());
}

void add_settings(CLI::App& command, std::vector<std::string>& settings) {
  command
      .add_option("--set", settings,
                  "COMPONENT.KEY=VALUE: override one key of etc/COMPONENT.yaml; may be repeated")
      ->allow_extra_args(false)
      ->type_name("TEXT");
}

void add_domain(CLI::App& command, std::optional<int>& domain) {
  command.add_option("--domain", domain, "DDS domain; ENFILADE_DOMAIN, ROS_DOMAIN_ID or 0 by default")
      ->check(whole_number_in(0, 232));
}

CLI::Option* add_output_file(CLI::App& command, const std::string& name, std::string& path,
                             const std::string& what) {
  return command.add_option(name, path, what)->check(why_no_file)->type_name("FILE");
}

CLI::Option* add_output_folder(CLI::App& command, const std::string& name, std::string& path,
                               const std::string& what) {
  return command.add_option(name, path, what)->check(why_no_folder)->type_name("FOLDER");
}

void add_report_files(CLI::App& command, ReportFiles& files) {
  add_output_file(command, "--json", files.json, "Write the figures to this file");
  add_output_file(command, "--markdown", files.markdown, "Write a report to this file");
}

void write(const ReportFiles& files, const std::string& json, const std::string& markdown) {
  if (!files.json.empty()) write_file(files.json, json);
  if (!files.markdown.empty()) write_file(files.markdown, markdown);
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16] = {};
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

}  // namespace enfilade
