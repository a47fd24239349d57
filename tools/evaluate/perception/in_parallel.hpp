// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace enfilade::evaluate {

/// Calls work(0) … work(count − 1), each once, on all cores and in no order to rely on. What one throws is
/// thrown again when all have ended.
void in_parallel(int count, const std::function<void(int)>& work);

}  // namespace enfilade::evaluate
