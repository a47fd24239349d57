// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

/// Options that several verbs have. What can be refused before any work is done, is.
namespace enfilade {

/// Checks of a number as it was written; NaN and "-1" for an unsigned one are refused, too.
CLI::Validator number_in(double least, double most);
CLI::Validator whole_number_in(int least, int most);
CLI::Validator whole_number();

/// --seed, as far as a component's configuration takes it.
CLI::Option* add_seed(CLI::App& command, std::uint64_t& seed, const std::string& what);

/// --set COMPONENT.KEY=VALUE, may be repeated.
void add_settings(CLI::App& command, std::vector<std::string>& settings);

/// Numbers of rooms or doors.
CLI::Option* add_numbers(CLI::App& command, const std::string& name, std::vector<std::uint32_t>& numbers,
                         const std::string& what);

/// --domain; nothing: ENFILADE_DOMAIN, ROS_DOMAIN_ID or 0.
void add_domain(CLI::App& command, std::optional<int>& domain);

/// A file, or a folder with files, that will be written.
CLI::Option* add_output_file(CLI::App& command, const std::string& name, std::string& path,
                             const std::string& what);
CLI::Option* add_output_folder(CLI::App& command, const std::string& name, std::string& path,
                               const std::string& what);

/// What an experiment writes beside its table.
struct ReportFiles {
  std::string json, markdown;  ///< "": not written
};
void add_report_files(CLI::App& command, ReportFiles& files);
void write(const ReportFiles& files, const std::string& json, const std::string& markdown);

/// The date in UTC, for the head of a report: 2026-01-31.
std::string today();

}  // namespace enfilade
