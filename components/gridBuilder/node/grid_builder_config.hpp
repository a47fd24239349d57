// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/gridBuilder/core/odometry_buffer.hpp"
#include "components/gridBuilder/core/scan_registrar.hpp"
#include "components/gridBuilder/core/zone_gate.hpp"
#include "components/gridBuilder/core/zone_grid.hpp"
#include "components/gridBuilder/node/picture_publisher.hpp"
#include "interfaces/runtime/config.hpp"

namespace enfilade::grid_builder {

struct GridBuilderConfig {
  PeriodConfig period;
  ZoneGateConfig gate;
  ZoneGridConfig grid;
  OdometryBufferConfig odometry;
  ScanRegistrarConfig registration;
  PicturePublisherConfig pictures;
  int max_waiting_lines = 200;  ///< lines that wait for odometry or for the place of the sensor
};

void bind(ConfigBinder& c, GridBuilderConfig& config);

}  // namespace enfilade::grid_builder
