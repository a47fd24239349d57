// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/point_file.hpp"

namespace enfilade::laser_3d {

ScannedPoints read_points(const FileBytes& file) {
  ScannedPoints read;
  if (file.name.ends_with(".pcd")) {
    read = read_pcd(file);
  } else if (file.name.ends_with(".3d")) {
    read = read_3dtk(file);
  } else {
    reject(file, "what kind of points it holds is told by its ending, which must be .pcd or .3d");
  }
  if (read.points.empty()) reject(file, "it holds no valid point");
  return read;
}

}  // namespace enfilade::laser_3d
