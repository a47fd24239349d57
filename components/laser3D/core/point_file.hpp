// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "components/laser3D/core/text_lines.hpp"
#include "interfaces/model/sensing.hpp"

namespace enfilade::laser_3d {

/// Points with z up, in metres, as a scanner saw them from `origin`.
struct ScannedPoints {
  std::vector<Point3f> points;  ///< all finite
  Point3f origin;
};

/// Reads a point file by the ending of its name: `.pcd` or `.3d`. Throws std::runtime_error with one sentence
/// that names the file, what is wrong with it and where; never reads outside the bytes given.
ScannedPoints read_points(const FileBytes& file);

/// PCD 0.7 in ascii, binary or binary_compressed; the fields x, y, z anywhere among others, as float or
/// double.
ScannedPoints read_pcd(const FileBytes& file);

/// 3DTK's text format: x y z in centimetres, left-handed with x right, y up and z forward, one point a line
/// (further columns are ignored). Points as far away as the format's sentinel for "no return" are dropped.
ScannedPoints read_3dtk(const FileBytes& file);

}  // namespace enfilade::laser_3d
