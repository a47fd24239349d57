// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/joint_fit.hpp"

#include <random>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

namespace enfilade::room_detector {
namespace {

constexpr Rectangle kJointRoom{0.3, 0.4, -0.2, 4.2, 3.4};

/// What a laser `bias_m` too long sees of the walls from `T_true`, told as if from `T_believed`.
StandPoints seen_from(const Pose2& T_true, const Pose2& T_believed, double bias_m, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 0.01);
  StandPoints stand{T_believed, {}};
  for (int wall = 0; wall < 4; ++wall) {
    const Segment line = kJointRoom.wall(wall);
    for (double s = 0.01; s < line.length(); s += 0.02) {
      const Point2 way = line.from + s * line.direction() - T_true.translation();
      const Point2 ray = way.normalized();
      const Point2 measured = T_true.translation() + way + (bias_m + noise(random)) * ray;
      const Pose2 T = T_believed * T_true.inverse();
      stand.points.push_back({T * measured, 9.0, rotate(T.yaw_rad, ray)});
    }
  }
  return stand;
}

TEST(JointFit, FindsTheRoomAndWhatOdometryErredBy) {
  const Pose2 first{0.0, 0.1, 0.5}, second{0.2, -0.3, 2.0};
  const Pose2 T_error{0.04, -0.03, radians(2.0)};
  const std::vector<StandPoints> stands{seen_from(first, first, 0.0, 1),
                                        seen_from(second, T_error * second, 0.0, 2)};
  const Rectangle start{0.31, 0.42, -0.21, 4.23, 3.38};
  const auto fit = JointFitter({}, {}).fit(stands, start, 0.075);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->room.rectangle.width_m, kJointRoom.width_m, 0.003);
  EXPECT_NEAR(fit->room.rectangle.height_m, kJointRoom.height_m, 0.003);
  EXPECT_NEAR(fit->room.rectangle.yaw_rad, kJointRoom.yaw_rad, 0.001);
  ASSERT_EQ(fit->corrections.size(), 2u);
  EXPECT_EQ(fit->corrections[0], Pose2{});
  const Pose2 left_over = fit->corrections[1] * T_error;
  EXPECT_NEAR(left_over.yaw_rad, 0.0, 0.001);
  EXPECT_LT((left_over * second.translation() - second.translation()).norm(), 0.004);
}

TEST(JointFit, TellsHowARangeBiasMovesTheWalls) {
  const Pose2 stand{0.0, 0.1, 0.5};
  const auto at = [&](double bias_m) {
    return *JointFitter({}, {}).fit(std::vector{seen_from(stand, stand, bias_m, 3)}, kJointRoom, 0.075);
  };
  const JointFit plain = at(0.0), longer = at(0.01);
  EXPECT_NEAR(longer.room.rectangle.width_m - plain.room.rectangle.width_m,
              0.01 * plain.room.per_range_bias[3], 0.0005);
  EXPECT_NEAR(std::sqrt(plain.room.covariance(3, 3)), 0.017 * plain.room.per_range_bias[3], 0.0005);
}

TEST(JointFit, CovarianceIsThatOfTheErrorsOverManyMeasurements) {
  const Pose2 at{0.5, 0.3, 0.5};
  RectangleFitConfig fit;
  JointFitConfig joint{.range_bias_sigma_m = 0.0, .wall_sigma_m = 0.0};
  joint.range_sigma_m = 0.03;  // the points below are means of nine returns
  double nees = 0.0;
  constexpr int kMeasurements = 200;
  for (int i = 0; i < kMeasurements; ++i) {
    const auto found =
        JointFitter(joint, fit).fit(std::vector{seen_from(at, at, 0.0, 100u + i)}, kJointRoom, 0.075);
    ASSERT_TRUE(found);
    const Rectangle& r = found->room.rectangle;
    Eigen::Matrix<double, 5, 1> e;
    e << r.yaw_rad - kJointRoom.yaw_rad, r.x_m - kJointRoom.x_m, r.y_m - kJointRoom.y_m,
        r.width_m - kJointRoom.width_m, r.height_m - kJointRoom.height_m;
    nees += e.dot(found->room.covariance.ldlt().solve(e)) / kMeasurements;
  }
  EXPECT_NEAR(nees, 5.0, 3.0 * std::sqrt(10.0 / kMeasurements)) << "χ² of five degrees of freedom";
}

TEST(JointFit, IsLessSureOfAWallOfWhichAStretchStandsBack) {
  const Pose2 stand{0.0, 0.1, 0.5};
  StandPoints seen = seen_from(stand, stand, 0.0, 5);
  const JointFitConfig joint{.range_bias_sigma_m = 0.0};
  const auto flat = JointFitter(joint, {}).fit(std::vector{seen}, kJointRoom, 0.075);
  for (WallPoint& p : seen.points) {
    const Point2 q = p.position - kJointRoom.wall(0).midpoint();
    const double along_m = q.dot(kJointRoom.wall(0).direction());
    if (std::abs(q.dot(kJointRoom.normal(0))) < 0.1 && along_m > 0.2 && along_m < 0.9)
      p.position += 0.012 * kJointRoom.normal(0);
  }
  const auto uneven = JointFitter(joint, {}).fit(std::vector{seen}, kJointRoom, 0.075);
  ASSERT_TRUE(flat && uneven);
  const double error_m = std::abs(uneven->room.rectangle.width_m - kJointRoom.width_m);
  EXPECT_GT(error_m, 3.0 * std::sqrt(flat->room.covariance(3, 3))) << "it pulls the wall";
  EXPECT_LT(error_m, 3.0 * std::sqrt(uneven->room.covariance(3, 3))) << "and that is stated";
  EXPECT_LT(uneven->room.covariance(4, 4), 2.0 * flat->room.covariance(4, 4))
      << "the other walls are as before";
}

TEST(JointFit, KnowsNothingOfAWallThatWasNotSeen) {
  const Pose2 stand{0.0, 0.1, 0.5};
  StandPoints seen = seen_from(stand, stand, 0.0, 4);
  std::erase_if(seen.points, [](const WallPoint& p) {
    return (p.position - kJointRoom.wall(0).midpoint()).dot(kJointRoom.normal(0)) > -0.1;
  });
  const auto fit = JointFitter({}, {}).fit(std::vector{seen}, kJointRoom, 0.075);
  ASSERT_TRUE(fit);
  EXPECT_GT(fit->room.covariance(3, 3), 0.5) << "width, m²";
  EXPECT_LT(fit->room.covariance(4, 4), 0.01) << "height";
}

TEST(JointFit, IsNothingWithoutStands) {
  EXPECT_FALSE(JointFitter({}, {}).fit({}, kJointRoom, 0.1));
  EXPECT_FALSE(JointFitter({}, {}).fit(std::vector<StandPoints>(1), kJointRoom, 0.1));
}

}  // namespace
}  // namespace enfilade::room_detector
