// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace enfilade {

/// What a wrong command line is answered with: one sentence that says what to do. For
/// CLI::App::failure_message.
inline std::string usage_error(const CLI::App* app, const CLI::Error& error) {
  // What a check finds wrong with a value tells by itself what to write.
  const bool says_all = dynamic_cast<const CLI::ValidationError*>(&error) != nullptr;
  return app->get_name() + ": " + error.what() + (says_all ? "\n" : "; --help lists what can be given\n");
}

}  // namespace enfilade
