// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>

#include "interfaces/convert/wire_codec.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade {
namespace {

/// Written by hand after the CDR rules: encapsulation, then every member at a multiple of its size, little
/// endian.
TEST(WireCodec, EncodesALaserScanAsRos2Does) {
  const LaserScan scan{.stamp_ns = 5'000'000'007,
                       .frame_id = "laser",
                       .angle_min_rad = -1.0F,
                       .angle_max_rad = 1.0F,
                       .angle_increment_rad = 0.5F,
                       .time_increment_s = 0.25F,
                       .scan_time_s = 2.0F,
                       .range_min_m = 0.125F,
                       .range_max_m = 32.0F,
                       .ranges_m = {1.5F, std::numeric_limits<float>::infinity()},
                       .intensities = {}};
  const wire::WireBytes expected{
      0x00, 0x01, 0x00, 0x00,                                               // CDR, little endian
      0x05, 0x00, 0x00, 0x00, 0x07, 0x00, 0x00, 0x00,                       // stamp: 5 s, 7 ns
      0x06, 0x00, 0x00, 0x00, 'l',  'a',  's',  'e',  'r',  0x00, 0,    0,  // frame_id, its end, padding to 4
      0x00, 0x00, 0x80, 0xbf,                                               // angle_min -1
      0x00, 0x00, 0x80, 0x3f,                                               // angle_max 1
      0x00, 0x00, 0x00, 0x3f,                                               // angle_increment 1/2
      0x00, 0x00, 0x80, 0x3e,                                               // time_increment 1/4
      0x00, 0x00, 0x00, 0x40,                                               // scan_time 2
      0x00, 0x00, 0x00, 0x3e,                                               // range_min 1/8
      0x00, 0x00, 0x00, 0x42,                                               // range_max 32
      0x02, 0x00, 0x00, 0x00, 0x00, 0x00, 0xc0, 0x3f, 0x00, 0x00, 0x80, 0x7f,  // ranges: 2 of them, 1.5, +inf
      0x00, 0x00, 0x00, 0x00};                                                 // intensities: none
  EXPECT_EQ(wire::codec_of(topics::kScan.info).encode(&scan), expected);
}

TEST(WireCodec, EncodesAVelocityCommandAsRos2Does) {
  const VelocityCommand command{.linear_m_s = 0.5, .angular_rad_s = -2.0};
  wire::WireBytes expected(4 + 6 * 8, 0);
  expected[1] = 0x01;
  expected[4 + 6] = 0xe0, expected[4 + 7] = 0x3f;  // linear.x = 0.5
  expected[4 + 47] = 0xc0;                         // angular.z = -2
  EXPECT_EQ(wire::codec_of(topics::kCmdVel.info).encode(&command), expected);
}

}  // namespace
}  // namespace enfilade
