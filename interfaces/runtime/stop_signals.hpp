// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace enfilade {

/// Blocks SIGINT and SIGTERM, in this thread and those it starts, and ignores SIGPIPE. To be called before
/// the first thread is started, so that the signals reach nobody but wait_for_stop_signal().
void block_stop_signals();

/// Whether SIGINT or SIGTERM arrives within `timeout`.
bool wait_for_stop_signal(std::chrono::milliseconds timeout);

}  // namespace enfilade
