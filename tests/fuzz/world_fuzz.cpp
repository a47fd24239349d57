// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tools/simulator/world/load_world.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace enfilade;
  const std::string text = fuzz::text_of(data, size);
  if (text.find("image") != std::string::npos) return 0;  // would open any file that is named
  try {
    simulator::load_world(fuzz::MemoryFile(text).name());
  } catch (const std::runtime_error&) {
  }
  return 0;
}
