// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/carmen_reader.hpp"

#include <cmath>
#include <limits>

namespace enfilade::laser_3d {
namespace {

constexpr std::size_t kMostReadings = 20'000;
/// The scanners that wrote FLASER lines measure less far than this; what they give for "nothing" is more.
constexpr double kNoReturn_m = 80.0;
constexpr double kFarthest_m = 1e6;

/// The words of one line, taken one after the other; a missing or bad one is refused with its place.
class LineWords {
 public:
  LineWords(const FileBytes& file, int line, std::string_view text)
      : file_(file), line_(line), words_(words(text)) {}

  bool empty() const { return words_.empty(); }
  std::string_view keyword() const { return words_.front(); }
  bool at_end() const { return next_ == words_.size(); }

  double number(const char* what) {
    const auto value = to_number(take(what));
    if (!value) fail(what, "is no number");
    return *value;
  }

  double finite(const char* what) {
    const double value = number(what);
    if (!(std::abs(value) <= kFarthest_m * kFarthest_m)) fail(what, "is out of any reasonable range");
    return value;
  }

  Pose2 pose(const char* what) {
    const double x = finite(what), y = finite(what), yaw = finite(what);
    if (std::abs(x) > kFarthest_m || std::abs(y) > kFarthest_m) fail(what, "lies too far away");
    return {x, y, wrap_to_pi(yaw)};
  }

  std::size_t count(const char* what) {
    const auto value = to_count(take(what));
    if (!value) fail(what, "is no count");
    if (*value > kMostReadings) fail(what, "is more than any scanner has");
    return *value;
  }

 private:
  std::string_view take(const char* what) {
    if (at_end()) fail(what, "is missing: the line is cut off; get the log again or remove the line");
    return words_[next_++];
  }

  [[noreturn]] void fail(const char* what, const char* problem) const {
    reject_line(file_, line_, std::string(what) + " of " + std::string(keyword()) + " " + problem);
  }

  const FileBytes& file_;
  int line_;
  std::vector<std::string_view> words_;
  std::size_t next_ = 1;
};

float range_of(double reading_m, double max_range_m) {
  if (std::isnan(reading_m)) return std::numeric_limits<float>::quiet_NaN();
  if (reading_m >= max_range_m) return std::numeric_limits<float>::infinity();
  if (reading_m <= 0.0) return -std::numeric_limits<float>::infinity();
  return static_cast<float>(reading_m);
}

std::vector<float> ranges(LineWords& line, std::size_t count, double max_range_m) {
  std::vector<float> ranges_m;
  for (std::size_t i = 0; i < count; ++i) ranges_m.push_back(range_of(line.number("a range"), max_range_m));
  return ranges_m;
}

/// FLASER n r… x y theta odom_x odom_y odom_theta stamp host logger_stamp: half a circle from right to left.
CarmenScan front_laser(LineWords& line) {
  CarmenScan scan;
  const std::size_t count = line.count("the number of ranges");
  scan.ranges_m = ranges(line, count, kNoReturn_m);
  scan.T_map_laser = line.pose("the pose of the laser");
  scan.T_odom_base = line.pose("the odometry");
  scan.stamp_s = line.finite("the time stamp");
  // 181 and 361 readings have one at each end, 180 and 360 leave the last one out.
  const std::size_t steps = count % 2 == 1 && count > 1 ? count - 1 : count;
  scan.first_angle_rad = -0.5 * kPi;
  scan.angle_step_rad = steps > 0 ? kPi / static_cast<double>(steps) : 0.0;
  return scan;
}

/// ROBOTLASER1 type start fov step max_range accuracy remission_mode n r… m remissions… laser_x y theta
/// robot_x y theta tv rv forward side turn stamp host logger_stamp.
CarmenScan robot_laser(LineWords& line) {
  CarmenScan scan;
  line.number("the type of the laser");
  scan.first_angle_rad = line.finite("the first angle");
  line.number("the field of view");
  scan.angle_step_rad = line.finite("the angle step");
  const double max_range_m = line.number("the maximal range");
  line.number("the accuracy");
  line.number("the remission mode");
  const std::size_t count = line.count("the number of ranges");
  scan.ranges_m = ranges(line, count, max_range_m);
  const std::size_t remissions = line.count("the number of remissions");
  for (std::size_t i = 0; i < remissions; ++i) line.number("a remission");
  scan.T_map_laser = line.pose("the pose of the laser");
  scan.T_odom_base = line.pose("the pose of the robot");
  for (const char* what : {"tv", "rv", "the forward distance", "the side distance", "the turn axis"})
    line.number(what);
  scan.stamp_s = line.finite("the time stamp");
  return scan;
}

CarmenOdometry odometry(LineWords& line) {
  const Pose2 T_odom_base = line.pose("the pose");
  for (const char* what : {"tv", "rv", "the acceleration"}) line.number(what);
  return {line.finite("the time stamp"), T_odom_base};
}

}  // namespace

CarmenLog read_carmen(const FileBytes& file) {
  CarmenLog log;
  TextLines lines(file.bytes);
  while (const auto text = lines.next()) {
    LineWords line(file, lines.number(), *text);
    if (line.empty()) continue;
    if (line.keyword() == "FLASER") log.scans.push_back(front_laser(line));
    if (line.keyword() == "ROBOTLASER1") log.scans.push_back(robot_laser(line));
    if (line.keyword() == "ODOM") log.odometry.push_back(odometry(line));
  }
  if (!lines.at_end())
    reject_line(file, lines.number() + 1, "the line has no end: the file is cut off; get it again");
  if (log.scans.empty())
    reject(file, "it holds no FLASER or ROBOTLASER1 line: give a CARMEN log of a robot with a laser");
  return log;
}

std::vector<Point2> returns_of(const CarmenScan& scan, double max_range_m) {
  std::vector<Point2> returns;
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const double range_m = scan.ranges_m[i];
    if (!(range_m > 0.0 && range_m <= max_range_m)) continue;
    const double angle = scan.first_angle_rad + static_cast<double>(i) * scan.angle_step_rad;
    returns.push_back(scan.T_map_laser * (range_m * Point2(std::cos(angle), std::sin(angle))));
  }
  return returns;
}

}  // namespace enfilade::laser_3d
