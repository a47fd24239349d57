// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/pcd_header.hpp"

#include <map>

namespace enfilade::laser_3d {
namespace {

/// More would not fit into memory in any form; keeps all sizes computed from a header far from overflow.
constexpr std::size_t kMostPoints = std::size_t{1} << 31;
constexpr std::size_t kMostCount = std::size_t{1} << 20;
constexpr std::size_t kMostRowBytes = std::size_t{1} << 24;

struct Entry {
  int line = 0;
  std::vector<std::string_view> values;
};
using Entries = std::map<std::string_view, Entry>;

struct Field {
  std::string_view name;
  std::size_t size = 4;
  char type = 'F';
  std::size_t count = 1;
};

Entries read_entries(const FileBytes& file, TextLines& lines) {
  Entries entries;
  while (const auto line = lines.next()) {
    auto values = words(*line);
    if (values.empty() || values[0].starts_with('#')) continue;
    const std::string_view key = values[0] == "COLUMNS" ? "FIELDS" : values[0];
    values.erase(values.begin());
    if (!entries.emplace(key, Entry{lines.number(), std::move(values)}).second)
      reject_line(file, lines.number(), std::string(key) + " appears twice");
    if (key == "DATA") return entries;
    if (lines.number() > 100) break;
  }
  reject_line(file, lines.number() + 1, "the header ends before its line DATA: not a PCD file, or cut off");
}

const Entry& need(const FileBytes& file, const Entries& entries, std::string_view key) {
  const auto found = entries.find(key);
  if (found == entries.end()) reject(file, "the header has no line " + std::string(key));
  if (found->second.values.empty()) reject_line(file, found->second.line, std::string(key) + " has no value");
  return found->second;
}

std::size_t need_count(const FileBytes& file, const Entries& entries, std::string_view key) {
  const Entry& entry = need(file, entries, key);
  const auto count = to_count(entry.values[0]);
  if (!count || *count > kMostPoints) reject_line(file, entry.line, std::string(key) + " is no usable count");
  return *count;
}

/// Calls `set(field, value)` with each field and its value on the line `key`.
template <class Set>
void read_row(const FileBytes& file, const Entry& entry, std::string_view key, std::vector<Field>& fields,
              Set set) {
  if (entry.values.size() != fields.size())
    reject_line(file, entry.line,
                std::string(key) + " has " + std::to_string(entry.values.size()) + " values for " +
                    std::to_string(fields.size()) + " fields");
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (!set(fields[i], entry.values[i]))
      reject_line(file, entry.line,
                  std::string(key) + " holds '" + std::string(entry.values[i]) + "', which is none");
}

std::vector<Field> read_fields(const FileBytes& file, const Entries& entries) {
  std::vector<Field> fields;
  for (const std::string_view name : need(file, entries, "FIELDS").values) fields.push_back({.name = name});
  read_row(file, need(file, entries, "SIZE"), "SIZE", fields, [](Field& field, std::string_view value) {
    field.size = to_count(value).value_or(0);
    return field.size == 1 || field.size == 2 || field.size == 4 || field.size == 8;
  });
  read_row(file, need(file, entries, "TYPE"), "TYPE", fields, [](Field& field, std::string_view value) {
    field.type = value[0];
    return value == "F" || value == "I" || value == "U";
  });
  if (entries.contains("COUNT"))
    read_row(file, need(file, entries, "COUNT"), "COUNT", fields, [](Field& field, std::string_view value) {
      field.count = to_count(value).value_or(0);
      return field.count >= 1 && field.count <= kMostCount;
    });
  return fields;
}

void locate_coordinates(const FileBytes& file, int line, const std::vector<Field>& fields,
                        PcdHeader& header) {
  constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
  std::array<int, 3> seen{};
  for (const Field& field : fields) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (field.name != kNames[axis]) continue;
      const std::string name(field.name);
      if (field.type != 'F' || field.size < 4 || field.count != 1)
        reject_line(file, line,
                    "field " + name + " must be one float or double (TYPE F, SIZE 4 or 8, COUNT 1)");
      if (++seen[axis] > 1) reject_line(file, line, "field " + name + " appears twice");
      header.xyz[axis] = {header.columns, header.row_bytes, field.size == 8};
    }
    header.columns += field.count;
    header.row_bytes += field.count * field.size;
    if (header.row_bytes > kMostRowBytes)
      reject_line(file, line, "a point with all its fields is too large to be read");
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (seen[axis] == 0) reject_line(file, line, "there is no field " + std::string(kNames[axis]));
}

Point3f read_viewpoint(const FileBytes& file, const Entries& entries) {
  if (!entries.contains("VIEWPOINT")) return {};
  const Entry& entry = need(file, entries, "VIEWPOINT");
  if (entry.values.size() != 7)
    reject_line(file, entry.line, "VIEWPOINT must be x y z and a quaternion w x y z");
  std::array<float, 3> xyz{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = to_number(entry.values[i]);
    if (!value || !(*value > -1e6 && *value < 1e6))
      reject_line(file, entry.line, "VIEWPOINT holds no usable number");
    xyz[i] = static_cast<float>(*value);
  }
  return {xyz[0], xyz[1], xyz[2]};
}

PcdEncoding read_encoding(const FileBytes& file, const Entry& data) {
  if (data.values[0] == "ascii") return PcdEncoding::kAscii;
  if (data.values[0] == "binary") return PcdEncoding::kBinary;
  if (data.values[0] == "binary_compressed") return PcdEncoding::kBinaryCompressed;
  reject_line(file, data.line, "DATA must be ascii, binary or binary_compressed");
}

}  // namespace

PcdHeader read_pcd_header(const FileBytes& file) {
  TextLines lines(file.bytes);
  const Entries entries = read_entries(file, lines);
  PcdHeader header;
  locate_coordinates(file, need(file, entries, "FIELDS").line, read_fields(file, entries), header);
  const std::size_t width = need_count(file, entries, "WIDTH"), height = need_count(file, entries, "HEIGHT");
  header.points = width * height;
  if (header.points > kMostPoints) reject(file, "WIDTH times HEIGHT is more points than can be read");
  if (entries.contains("POINTS") && need_count(file, entries, "POINTS") != header.points)
    reject_line(file, entries.at("POINTS").line, "POINTS is not WIDTH times HEIGHT");
  header.origin = read_viewpoint(file, entries);
  header.encoding = read_encoding(file, need(file, entries, "DATA"));
  header.data_offset = lines.offset();
  header.data_line = lines.number();
  return header;
}

}  // namespace enfilade::laser_3d
