// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "components/laser3D/core/line_queue.hpp"
#include "components/laser3D/core/replay_cloud.hpp"
#include "components/laser3D/core/roll_interpolator.hpp"
#include "components/laser3D/core/scan_projector.hpp"
#include "interfaces/runtime/config.hpp"

namespace enfilade::laser_3d {

enum class DriverKind { kSimulator, kReplay };

struct ReplayConfig {
  std::string file;   ///< .pcd or .3d
  double rate = 1.0;  ///< 1 = as many lines a second as a scanner gives
  double line_period_s = 0.025;
  double wait_s = 5.0;  ///< for a first reader of rt/points, before the replay begins without one
  ReplayCloudConfig cloud;
};

struct Laser3DConfig {
  PeriodConfig period;
  DriverKind driver = DriverKind::kSimulator;
  double scan_silence_s = 0.5;  ///< no line for longer than this is an emergency
  RollInterpolatorConfig roll;
  LineQueueConfig queue;
  ScanProjectorConfig projector;
  ReplayConfig replay;
};

void bind(ConfigBinder& c, Laser3DConfig& config);

}  // namespace enfilade::laser_3d
