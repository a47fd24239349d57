// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "components/gridBuilder/core/zone_pictures.hpp"
#include "interfaces/runtime/node.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade::grid_builder {

struct PicturePublisherConfig {
  double period_s = 1.0;  ///< of rt/octomap and rt/local_map, where the grid has changed; 0 = never
  ZonePicturesConfig pictures;
};

/// Publishes the grid as rt/octomap and rt/local_map while somebody reads them. The work is done in slices
/// between which the executor comes to the lines that wait; so a picture may show one line more here than
/// there.
class PicturePublisher {
 public:
  /// `frame` is that of the grid.
  PicturePublisher(const NodeContext& context, const PicturePublisherConfig& config, const ZoneGrid& grid,
                   std::string frame);

  void open();
  void grid_cleared();
  void line_fused(const LineUpdate& update, StampNs stamp_ns, const Pose2& T_zone_base);

 private:
  void tick();
  void work();
  void publish_octree();
  void publish_floor();

  NodeContext context_;
  PicturePublisherConfig config_;
  const ZoneGrid& grid_;
  std::string frame_;
  ZonePictures pictures_;
  bool has_news_ = false, works_ = false;
  StampNs newest_line_ns_ = 0;
  Point2 robot_ = Point2::Zero();
  Publisher<OctreeMap> octomap_;
  Publisher<OccupancyMap> local_map_;
};

}  // namespace enfilade::grid_builder
