// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/world/grey_image.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <png.h>

namespace enfilade::simulator {
namespace {

constexpr int kMostPixelsPerSide = 20000;

/// The next word of a PGM header; a '#' starts a comment to the end of its line.
int header_number(std::istream& in, const std::string& file) {
  for (in >> std::ws; in.peek() == '#'; in >> std::ws) {
    std::string comment;
    std::getline(in, comment);
  }
  int value = 0;
  if (!(in >> value) || value < 1)
    throw std::runtime_error(file + " has no proper PGM header: save the map again");
  return value;
}

GreyImage read_pgm(std::istream& in, bool binary, const std::string& file) {
  GreyImage image;
  image.columns = header_number(in, file);
  image.rows = header_number(in, file);
  const int brightest = header_number(in, file);
  if (image.columns > kMostPixelsPerSide || image.rows > kMostPixelsPerSide || brightest > 255)
    throw std::runtime_error(
        file + " is too large or has more than 8 bits a pixel: convert it to an 8 bit PGM or PNG");
  in.get();  // one white space ends the header
  const std::size_t size = static_cast<std::size_t>(image.columns) * image.rows;
  image.pixels.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    int value = 0;
    if (binary)
      value = in.get();
    else
      in >> value;
    if (!in || value < 0 || value > brightest)
      throw std::runtime_error(file + " is truncated or damaged: save the map again");
    image.pixels.push_back(static_cast<std::uint8_t>(value * 255 / brightest));
  }
  return image;
}

GreyImage read_png(const std::string& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&png, file.c_str()))
    throw std::runtime_error(file + " is neither a PGM nor a PNG that can be read (" + png.message +
                             "): save the map again");
  png.format = PNG_FORMAT_RGB;
  if (png.width > kMostPixelsPerSide || png.height > kMostPixelsPerSide) {
    png_image_free(&png);
    throw std::runtime_error(file + " is too large for a map");
  }
  std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(png));
  const png_color half_grey{127, 127, 127};
  if (!png_image_finish_read(&png, &half_grey, rgb.data(), 0, nullptr))
    throw std::runtime_error(file + " is damaged (" + png.message + "): save the map again");
  GreyImage image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3)
    image.pixels.push_back(static_cast<std::uint8_t>((rgb[i] + rgb[i + 1] + rgb[i + 2]) / 3));
  return image;
}

}  // namespace

GreyImage read_grey_image(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    throw std::runtime_error(file + " cannot be read: check the path");
  char magic[2] = {};
  in.read(magic, 2);
  if (magic[0] == 'P' && (magic[1] == '2' || magic[1] == '5')) return read_pgm(in, magic[1] == '5', file);
  return read_png(file);
}

}  // namespace enfilade::simulator
