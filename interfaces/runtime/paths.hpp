// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace enfilade {

/// The folder of the running program.
std::string executable_folder();

/// The folder of the shipped configuration: ENFILADE_ETC, else <executable>/../../../etc (a checkout), else
/// <executable>/../share/enfilade/etc (an install). Throws std::runtime_error if none is there.
std::string etc_folder();

/// etc_folder()/NAME.yaml.
std::string config_file(const std::string& component);

/// `asked`, else ENFILADE_DOMAIN, else ROS_DOMAIN_ID, else 0. Throws std::runtime_error naming the variable
/// if it is no number in 0 … 232.
int resolve_domain(std::optional<int> asked);

}  // namespace enfilade
