// SPDX-License-Identifier: Apache-2.0
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "components/laser3D/core/point_file.hpp"
#include "tests/unit/components/laser3D/pcd_text.hpp"

namespace enfilade::laser_3d {
namespace {

const std::vector<Point3f> kPoints{
    {1.5f, -2.25f, 0.125f}, {0.0f, 3.0f, -1.0f}, {-8.5f, 0.0625f, 2.75f}, {4.0f, 4.0f, 4.0f}};

std::vector<Point3f> points_of(const std::string& bytes) { return read_points({"cloud.pcd", bytes}).points; }

std::string complaint_of(const std::string& bytes, const std::string& name = "cloud.pcd") {
  try {
    read_points({name, bytes});
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(PcdReader, AllThreeEncodingsGiveTheSamePoints) {
  EXPECT_EQ(points_of(ascii_pcd(kPoints)), kPoints);
  EXPECT_EQ(points_of(binary_pcd(kPoints)), kPoints);
  EXPECT_EQ(points_of(compressed_pcd(kPoints)), kPoints);
}

TEST(PcdReader, UnpacksBackReferences) {
  // Four times the point (1, 1, 1): one literal float, then 44 bytes from four back.
  const std::string packed = std::string(1, '\3') + raw(1.0f) + '\xe0' + static_cast<char>(44 - 2 - 7) + '\3';
  const std::string file = pcd_header(4, "binary_compressed") +
                           raw(static_cast<std::uint32_t>(packed.size())) + raw(std::uint32_t{48}) + packed;
  EXPECT_EQ(points_of(file), std::vector<Point3f>(4, Point3f{1.0f, 1.0f, 1.0f}));
}

TEST(PcdReader, FindsDoublesAnywhereAmongOtherFields) {
  const std::string header =
      "VERSION 0.7\nFIELDS rgb z normal x _ y\nSIZE 4 8 4 4 1 8\nTYPE U F F F U F\nCOUNT 1 1 3 1 5 1\nWIDTH "
      "1\nHEIGHT 2\n"
      "POINTS 2\nDATA ";
  const auto row = [](float x, double y, double z) {
    return raw(std::uint32_t{7}) + raw(z) + raw(9.0f) + raw(9.0f) + raw(9.0f) + raw(x) +
           std::string(5, '\1') + raw(y);
  };
  const std::vector<Point3f> expected{{1.0f, 2.0f, 3.0f}, {-1.0f, -2.0f, -3.0f}};
  EXPECT_EQ(points_of(header + "binary\n" + row(1, 2, 3) + row(-1, -2, -3)), expected);
  EXPECT_EQ(points_of(header + "ascii\n7 3 9 9 9 1 1 1 1 1 1 2\n7 -3 9 9 9 -1 1 1 1 1 1 -2\n"), expected);
}

TEST(PcdReader, DropsPointsThatAreNotFinite) {
  EXPECT_EQ(points_of(pcd_header(3, "ascii") + "nan nan nan\n1 2 3\ninf 0 0\n"),
            (std::vector<Point3f>{{1, 2, 3}}));
}

TEST(PcdReader, ReadsWhereTheScannerStood) {
  const std::string file = replaced(ascii_pcd(kPoints), "VIEWPOINT 0 0 0", "VIEWPOINT 1 -2 0.5");
  EXPECT_EQ(read_points({"cloud.pcd", file}).origin, (Point3f{1.0f, -2.0f, 0.5f}));
}

TEST(PcdReader, AFileCutOffAnywhereIsRefused) {
  for (const std::string& whole : {ascii_pcd(kPoints), binary_pcd(kPoints), compressed_pcd(kPoints)})
    for (std::size_t length = 0; length < whole.size(); ++length)
      ASSERT_THROW(points_of(whole.substr(0, length)), std::runtime_error) << length;
}

TEST(PcdReader, ADamagedFileIsReadOrRefusedAndNothingElse) {
  std::mt19937 random(3);
  for (const std::string& whole : {ascii_pcd(kPoints), binary_pcd(kPoints), compressed_pcd(kPoints)})
    for (int i = 0; i < 5000; ++i) {
      std::string damaged = whole;
      for (int k = 0; k < 3; ++k) damaged[random() % damaged.size()] = static_cast<char>(random());
      try {
        points_of(damaged);
      } catch (const std::runtime_error&) {
      }
    }
}

TEST(PcdReader, LyingHeadersAreRefusedWithTheirLine) {
  const std::string good = binary_pcd(kPoints);
  const auto complaint = [&](const std::string& from, const std::string& to) {
    return complaint_of(replaced(good, from, to));
  };
  EXPECT_EQ(complaint("FIELDS x y z", "FIELDS x y w"), "cloud.pcd: line 3: there is no field z");
  EXPECT_EQ(complaint("SIZE 4 4 4", "SIZE 4 4"), "cloud.pcd: line 4: SIZE has 2 values for 3 fields");
  EXPECT_EQ(complaint("SIZE 4 4 4", "SIZE 4 4 3"), "cloud.pcd: line 4: SIZE holds '3', which is none");
  EXPECT_NE(complaint("TYPE F F F", "TYPE F F U").find("field z must be one float or double"),
            std::string::npos);
  EXPECT_NE(complaint("COUNT 1 1 1", "COUNT 1 1 99999999999").find("line 6: COUNT"), std::string::npos);
  EXPECT_EQ(complaint("POINTS 4", "POINTS 5"), "cloud.pcd: line 10: POINTS is not WIDTH times HEIGHT");
  EXPECT_EQ(complaint("WIDTH 4", "WIDTH -4"), "cloud.pcd: line 7: WIDTH is no usable count");
  EXPECT_EQ(complaint("HEIGHT 1\n", ""), "cloud.pcd: the header has no line HEIGHT");
  EXPECT_EQ(complaint("DATA binary", "DATA jpeg"),
            "cloud.pcd: line 11: DATA must be ascii, binary or binary_compressed");
  EXPECT_EQ(complaint("HEIGHT 1", "WIDTH 4"), "cloud.pcd: line 8: WIDTH appears twice");
  const std::string huge =
      replaced(replaced(good, "WIDTH 4", "WIDTH 2000000000"), "POINTS 4", "POINTS 2000000000");
  EXPECT_NE(complaint_of(huge).find("the file is cut off"), std::string::npos);
}

TEST(PcdReader, CompressedSizesThatLieAreRefused) {
  std::string file = compressed_pcd(kPoints);
  const std::size_t data = file.find("DATA binary_compressed\n") + 23;
  std::string longer = file;
  longer.replace(data + 4, 4, raw(std::uint32_t{4'000'000'000u}));
  EXPECT_NE(complaint_of(longer).find("unpack to 4000000000 bytes"), std::string::npos);
  file[data + 8] = '\x3f';  // a back reference where nothing lies behind
  EXPECT_EQ(complaint_of(file), "cloud.pcd: the compressed data are damaged; get the file again");
}

TEST(PointFile, TheEndingMustBeKnownAndAPointMustBeThere) {
  EXPECT_NE(complaint_of("", "cloud.las").find("must be .pcd or .3d"), std::string::npos);
  EXPECT_EQ(complaint_of(pcd_header(1, "ascii") + "nan nan nan\n"), "cloud.pcd: it holds no valid point");
}

}  // namespace
}  // namespace enfilade::laser_3d
