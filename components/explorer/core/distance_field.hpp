// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace enfilade::explorer {

/// The exact Euclidean distance, in cells, from each cell of a `width` × `height` raster (row by row) to the
/// nearest cell that is set; a very large number where none is. After Felzenszwalb and Huttenlocher,
/// "Distance Transforms of Sampled Functions" (2012): two passes of lower envelopes of parabolas, linear in
/// the number of cells.
std::vector<float> distance_field(const std::vector<std::uint8_t>& set, int width, int height);

}  // namespace enfilade::explorer
