// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tools/simulator/world/grey_image.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace enfilade;
  try {
    const auto image = simulator::read_grey_image(fuzz::MemoryFile(fuzz::text_of(data, size)).name());
    fuzz::must(image.columns > 0 && image.rows > 0, "an image that is accepted has pixels");
    fuzz::must(image.pixels.size() == static_cast<std::size_t>(image.columns) * image.rows,
               "all its pixels are there");
  } catch (const std::runtime_error&) {
  }
  return 0;
}
