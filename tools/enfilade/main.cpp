// SPDX-License-Identifier: Apache-2.0
#include <clocale>
#include <iostream>

#include "interfaces/runtime/usage_error.hpp"
#include "tools/enfilade/verbs/verbs.hpp"

/// The one command for people: `enfilade VERB …`, each verb with --help. Exit status: 0 done, 1 not done, 2
/// wrong input.
int main(int argc, char** argv) {
  std::setlocale(LC_NUMERIC, "C");
  CLI::App app("Enfilade: robots that understand buildings", "enfilade");
  app.failure_message(enfilade::usage_error);
  const std::vector<enfilade::Verb> verbs{enfilade::add_run(app),      enfilade::add_demo(app),
                                          enfilade::add_room(app),     enfilade::add_map(app),
                                          enfilade::add_route(app),    enfilade::add_mark(app),
                                          enfilade::add_evaluate(app), enfilade::add_calibrate(app)};
  try {
    app.parse(argc, argv);
    return enfilade::run_chosen(app, verbs);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::cerr << "enfilade: " << error.what() << "\n";
    return 2;
  }
}
