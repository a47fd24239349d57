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

TEST(WireCodec, EncodesAnOccupancyGridAsRos2Does) {
  const OccupancyMap map{.stamp_ns = 5'000'000'007,
                         .frame_id = "map",
                         .resolution_m = 0.25F,
                         .columns = 2,
                         .rows = 1,
                         .T_frame_cells = {.x_m = -0.5},
                         .cells = {OccupancyMap::kUnknown, OccupancyMap::kOccupied}};
  wire::WireBytes expected{0x00, 0x01, 0x00, 0x00,                          // CDR, little endian
                           0x05, 0x00, 0x00, 0x00, 0x07, 0x00, 0x00, 0x00,  // stamp: 5 s, 7 ns
                           0x04, 0x00, 0x00, 0x00, 'm',  'a',  'p',  0x00,  // frame_id
                           0x05, 0x00, 0x00, 0x00, 0x07, 0x00, 0x00, 0x00,  // map_load_time
                           0x00, 0x00, 0x80, 0x3e,                          // resolution 1/4
                           0x02, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00,  // width, height
                           0x00, 0x00, 0x00, 0x00};                         // padding to 8
  expected.resize(expected.size() + 7 * 8);
  expected[44 + 6] = 0xe0, expected[44 + 7] = 0xbf;    // origin: x -1/2 …
  expected[44 + 54] = 0xf0, expected[44 + 55] = 0x3f;  // … and a turn by nothing, w 1
  for (const int byte : {0x02, 0x00, 0x00, 0x00, 0xff, 0x64})
    expected.push_back(static_cast<std::uint8_t>(byte));
  EXPECT_EQ(wire::codec_of(topics::kMap.info).encode(&map), expected);
}

TEST(WireCodec, EncodesAnOctomapAsRos2Does) {
  const OctreeMap map{.stamp_ns = 7, .frame_id = "zone", .resolution_m = 0.5, .data = {-2, 3}};
  const wire::WireBytes expected{0x00, 0x01, 0x00, 0x00,                                // CDR, little endian
                                 0x00, 0x00, 0x00, 0x00, 0x07, 0x00, 0x00, 0x00,        // stamp: 7 ns
                                 0x05, 0x00, 0x00, 0x00, 'z',  'o',  'n',  'e',  0x00,  // frame_id
                                 0x01, 0,    0,  // binary, padding to 4
                                 0x07, 0x00, 0x00, 0x00, 'O',  'c',  'T',  'r',  'e',
                                 'e',  0x00, 0,                                   // id, padding to 8
                                 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xe0, 0x3f,  // resolution 1/2
                                 0x02, 0x00, 0x00, 0x00, 0xfe, 0x03};             // data
  EXPECT_EQ(wire::codec_of(topics::kOctomap.info).encode(&map), expected);
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
