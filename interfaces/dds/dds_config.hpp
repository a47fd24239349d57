// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace enfilade {

struct DdsConfig {
  int domain = 0;             ///< 0 … 232
  bool shared_memory = true;  ///< inside the host; UDP is always there too, for ROS 2 peers and other hosts
  std::size_t shm_segment_bytes = std::size_t{32} << 20;  ///< at least four of the largest messages
  std::size_t max_datagram_bytes = 65'500;                ///< larger messages travel in fragments
  double lease_s = 3.0;                                   ///< a silent participant counts as dead after this
};

/// Of a process: without shared memory where the environment says ENFILADE_SHARED_MEMORY=off. Fast DDS 2.9
/// keeps locks in shared memory; a process killed while it holds one can block all the others for good.
DdsConfig deployed_dds_config(int domain);

}  // namespace enfilade
