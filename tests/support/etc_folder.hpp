// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace enfilade::test {

/// The source tree's `etc/`, closed by a slash. The one place where tests know where they were built.
std::string etc_folder();

}  // namespace enfilade::test
