// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>
#include <cstring>

#include "interfaces/convert/sensing.hpp"

namespace enfilade::wire {

namespace {

constexpr std::uint8_t kFloat32 = 7;  // PointField.FLOAT32
constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
static_assert(sizeof(Point3f) == 12 && std::endian::native == std::endian::little);

std::size_t find_offset(const ros_sensor::PointCloud2_& cloud, const std::string& axis) {
  for (const ros_sensor::PointField_& field : cloud.fields()) {
    if (field.name() != axis) continue;
    if (field.datatype() != kFloat32 || field.count() > 1)
      throw WireError("field " + axis + " of a cloud is no float32");
    if (std::uint64_t{field.offset()} + 4 > cloud.point_step()) {
      throw WireError("field " + axis + " of a cloud lies outside its point");
    }
    return field.offset();
  }
  throw WireError("a cloud has no field " + axis);
}

/// Afterwards no offset computed from the cloud's own sizes lies outside its data.
void check_sizes(const ros_sensor::PointCloud2_& cloud) {
  const std::uint64_t width = cloud.width(), height = cloud.height();
  if (height != 0 && width > kMaxPoints / height)
    throw WireError("a cloud claims more points than are believed");
  if (cloud.row_step() < width * cloud.point_step() || cloud.data().size() != height * cloud.row_step()) {
    throw WireError("a cloud of " + std::to_string(height) + " x " + std::to_string(width) + " points of " +
                    std::to_string(cloud.point_step()) + " bytes, " + std::to_string(cloud.row_step()) +
                    " a row, has " + std::to_string(cloud.data().size()) + " bytes of data");
  }
}

float read_float(const std::uint8_t* bytes, bool big_endian) {
  std::uint32_t word;
  std::memcpy(&word, bytes, sizeof word);
  return std::bit_cast<float>(big_endian ? __builtin_bswap32(word) : word);
}

}  // namespace

ros_sensor::PointCloud2_ to_wire(const PointCloud& cloud) {
  ros_sensor::PointCloud2_ out;
  const auto count = static_cast<std::uint32_t>(cloud.points.size());
  out.header(header_to_wire(cloud.stamp_ns, cloud.frame_id));
  out.height(1);
  out.width(count);
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    ros_sensor::PointField_ field;
    field.name(kAxes[axis]);
    field.offset(4 * axis);
    field.datatype(kFloat32);
    field.count(1);
    out.fields().push_back(field);
  }
  out.is_bigendian(false);
  out.point_step(sizeof(Point3f));
  out.row_step(count * sizeof(Point3f));
  out.data().resize(cloud.points.size() * sizeof(Point3f));
  if (count != 0) std::memcpy(out.data().data(), cloud.points.data(), out.data().size());
  out.is_dense(true);
  return out;
}

PointCloud from_wire(const ros_sensor::PointCloud2_& cloud) {
  check_count(cloud.fields().size(), kMaxPointFields, "point fields");
  check_sizes(cloud);
  const std::size_t x = find_offset(cloud, "x"), y = find_offset(cloud, "y"), z = find_offset(cloud, "z");
  const bool big = cloud.is_bigendian();
  PointCloud out{from_wire(cloud.header().stamp()), checked(cloud.header().frame_id()), {}};
  out.points.reserve(std::size_t{cloud.width()} * cloud.height());
  for (std::size_t row = 0; row < cloud.height(); ++row) {
    const std::uint8_t* point = cloud.data().data() + row * cloud.row_step();
    for (std::size_t column = 0; column < cloud.width(); ++column, point += cloud.point_step()) {
      out.points.push_back(
          {read_float(point + x, big), read_float(point + y, big), read_float(point + z, big)});
    }
  }
  return out;
}

}  // namespace enfilade::wire
