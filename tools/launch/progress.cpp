// SPDX-License-Identifier: Apache-2.0
#include "tools/launch/progress.hpp"

#include <iostream>

#include <unistd.h>

namespace enfilade::launch {

Progress::Progress() : terminal_(isatty(STDOUT_FILENO) != 0) {}

Progress::~Progress() { wipe(); }

void Progress::wipe() {
  if (terminal_ && !status_.empty()) std::cout << "\r\x1b[K" << std::flush;
}

void Progress::line(const std::string& text) {
  wipe();
  std::cout << text << "\n";
  if (terminal_) std::cout << status_;
  std::cout << std::flush;
}

void Progress::status(const std::string& text) {
  if (!terminal_ || text == status_) return;
  wipe();
  status_ = text;
  std::cout << status_ << std::flush;
}

}  // namespace enfilade::launch
