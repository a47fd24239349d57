// SPDX-License-Identifier: Apache-2.0
#include "tools/enfilade/verbs/verbs.hpp"

#include <iostream>

namespace enfilade {

int run_chosen(const CLI::App& group, const std::vector<Verb>& verbs) {
  for (const Verb& verb : verbs)
    if (verb.command->parsed()) return verb.run();
  const CLI::App* parent = group.get_parent();
  std::cerr << (parent ? parent->get_name() + " " : "") << group.get_name()
            << ": say what to do; --help lists the verbs\n";
  return 2;
}

}  // namespace enfilade
