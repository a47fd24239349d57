// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/journal.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <utility>

#include <zlib.h>

#include "components/topoGraph/storage/change_text.hpp"
#include "components/topoGraph/storage/map_names.hpp"

namespace enfilade::topo_graph {
namespace {

std::string hex(std::uint32_t value) {
  std::array<char, 9> digits{};
  std::snprintf(digits.data(), digits.size(), "%08x", value);
  return digits.data();
}

std::uint32_t read_crc32(const YamlValue& value) {
  const std::string digits = value.text();
  std::uint32_t crc32 = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), crc32, 16);
  if (error != std::errc() || hex(crc32) != digits) value.fail("must be 8 hexadecimal digits");
  return crc32;
}

JournalBase read_header(const std::string& text, const std::string& name) {
  const YamlSource source{name};
  YamlMap map(YamlValue(load_yaml(text, source), source, "the header"));
  const YamlValue format = map.take("format");
  if (format.text() != names::kJournalFormat) format.fail("is not " + std::string(names::kJournalFormat));
  const YamlValue version = map.take("version");
  if (version.text() != std::to_string(names::kJournalVersion))
    version.fail("this program reads version " + std::to_string(names::kJournalVersion) + " only");
  const YamlValue last = map.take("continues");
  last.must_be_on_last_line(text);
  YamlMap continues(last);
  const std::uint64_t record = continues.take("record").count(std::numeric_limits<std::uint64_t>::max() / 2);
  const JournalBase base{record, read_crc32(continues.take("crc32"))};
  continues.finish();
  map.finish();
  return base;
}

/// After the line `continues`.
std::size_t end_of_header(std::string_view text) {
  const std::size_t last_line = text.find("\ncontinues:");
  const std::size_t end = last_line == text.npos ? text.npos : text.find('\n', last_line + 1);
  return end == text.npos ? text.size() : end + 1;
}

std::string opening_start(std::uint64_t number) { return "---  # record " + std::to_string(number) + ", "; }
constexpr std::string_view kOpeningEnd = " bytes\n";

std::string closing_start(std::uint64_t number) {
  return "# record " + std::to_string(number) + " is complete: crc32 ";
}
std::string closing(std::uint64_t number, std::string_view text) {
  return closing_start(number) + hex(crc32_of(text)) + "\n";
}

/// A record's place in the rest of a journal, by its first line.
struct Frame {
  std::size_t text_at = 0, text_bytes = 0, bytes = 0;
};

std::optional<Frame> find_frame(std::string_view rest, std::uint64_t number) {
  const std::string start = opening_start(number);
  const std::size_t line_end = rest.find('\n');
  if (!rest.starts_with(start) || line_end == std::string_view::npos) return std::nullopt;
  Frame frame{.text_at = line_end + 1};
  const char* const line_end_at = rest.data() + frame.text_at;
  const auto [end, error] = std::from_chars(rest.data() + start.size(), line_end_at, frame.text_bytes);
  const bool sound = error == std::errc() && std::string_view(end, line_end_at) == kOpeningEnd;
  if (!sound || frame.text_bytes > kMostMapBytes) return std::nullopt;
  frame.bytes = frame.text_at + frame.text_bytes + closing(number, {}).size();
  return frame;
}

bool closes(std::string_view rest, std::uint64_t number) {
  const std::size_t at = rest.find("\n" + closing_start(number));
  return at != std::string_view::npos && rest.find('\n', at + 1) != std::string_view::npos;
}

/// Whether the rest of a journal is what a crash leaves of one record: cut short, or with holes of zeros
/// where it was not written to the disk. All else is damage.
bool is_torn(std::string_view rest, std::uint64_t number) {
  if (closes(rest, number + 1)) return false;
  if (rest.find('\0') != std::string_view::npos || rest.find('\n') == std::string_view::npos) return true;
  const auto frame = find_frame(rest, number);
  return frame && rest.size() < frame->bytes && !closes(rest, number);
}

int lines_in(std::string_view text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }

std::optional<JournalRecord> find_record(std::string_view rest, std::uint64_t number) {
  const auto frame = find_frame(rest, number);
  if (!frame || rest.size() < frame->bytes) return std::nullopt;
  const std::string_view text = rest.substr(frame->text_at, frame->text_bytes);
  if (!rest.substr(frame->text_at + frame->text_bytes).starts_with(closing(number, text)))
    return std::nullopt;
  return JournalRecord{number, 1, std::string(text)};
}

}  // namespace

std::uint32_t crc32_of(std::string_view text) {
  return static_cast<std::uint32_t>(
      ::crc32_z(0, reinterpret_cast<const unsigned char*>(text.data()), text.size()));
}

std::string journal_header(const JournalBase& base) {
  return "# What has changed since the map file beside this one was written: each document is one change.\n"
         "format: " +
         std::string(names::kJournalFormat) + "\nversion: " + std::to_string(names::kJournalVersion) +
         "\ncontinues: {record: " + std::to_string(base.record) + ", crc32: " + hex(base.crc32) + "}\n";
}

std::string journal_record(std::uint64_t number, std::string_view change) {
  return opening_start(number) + std::to_string(change.size()) + std::string(kOpeningEnd) +
         std::string(change) + closing(number, change);
}

Journal parse_journal(const std::string& text, const std::string& name) {
  const std::size_t header_bytes = end_of_header(text);
  Journal journal{.name = name, .base = read_header(text.substr(0, header_bytes), name)};
  std::string_view rest = std::string_view(text).substr(header_bytes);
  int line = lines_in(text.substr(0, header_bytes));
  while (!rest.empty()) {
    const std::uint64_t number = journal.last_record() + 1;
    auto record = find_record(rest, number);
    if (!record) {
      const std::string what = name + ":" + std::to_string(line + 1) + ": record " + std::to_string(number);
      if (is_torn(rest, number))
        journal.torn = what + " was cut off when it was written, and is left out";
      else
        journal.damage = what + " is damaged";
      break;
    }
    record->line += line;
    line += 2 + lines_in(record->text);
    rest.remove_prefix(find_frame(rest, number)->bytes);
    journal.records.push_back(std::move(*record));
  }
  return journal;
}

std::optional<std::string> replay(const Journal& journal, MapFile& file) {
  for (const JournalRecord& record : journal.records) {
    const auto misfit = [&](const std::string& what) {
      return journal.name + ":" + std::to_string(record.line) + ": record " + std::to_string(record.number) +
             " does not fit the map: " + what;
    };
    if (!file.session) return misfit("it has no session");
    try {
      apply(parse_change(record.text, {journal.name, record.line}), file.map, *file.session);
      file.records = record.number;
    } catch (const std::invalid_argument& error) {
      return misfit(error.what());
    } catch (const MapFileError& error) {
      return error.what();
    }
  }
  return journal.damage;
}

}  // namespace enfilade::topo_graph
