// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/journal.hpp"

#include <algorithm>
#include <cctype>

#include <gtest/gtest.h>

#include "components/topoGraph/storage/change_text.hpp"
#include "tests/unit/components/topoGraph/random_state.hpp"

namespace enfilade::topo_graph {
namespace {

using test::RandomState;

/// A map file, its journal, and the state after each of its records.
struct JournalTexts {
  std::string map, journal;
  std::vector<MapFile> states;
  std::vector<std::size_t> ends;  ///< of the header and of each record
};

JournalTexts make_texts(int records, std::uint64_t seed) {
  RandomState random(seed);
  for (int i = 0; i < 3; ++i) random.change();
  JournalTexts texts;
  texts.states = {{random.state().map, random.state().session, 57}};
  texts.map = to_yaml(texts.states[0]);
  texts.journal = journal_header({57, crc32_of(texts.map)});
  texts.ends = {texts.journal.size()};
  for (int i = 1; i <= records; ++i) {
    const TopoState before = random.state();
    texts.journal += journal_record(57 + i, to_yaml(change_between(before, random.change())));
    texts.states.push_back({random.state().map, random.state().session, static_cast<std::uint64_t>(57 + i)});
    texts.ends.push_back(texts.journal.size());
  }
  return texts;
}

OpenedMap open(const JournalTexts& texts, const std::string& journal) {
  return open_map(texts.map, journal, "map.yaml");
}

std::string error_of(const JournalTexts& texts, const std::string& journal) {
  try {
    open(texts, journal);
  } catch (const MapFileError& error) {
    return error.what();
  }
  return {};
}

/// Every byte of the header and of the lines about a record, some of the text between.
std::size_t step_near(const JournalTexts& texts, std::size_t at) {
  const auto near = [at](std::size_t end) { return at + 50 > end && at < end + 40; };
  return at < texts.ends[0] || std::any_of(texts.ends.begin(), texts.ends.end(), near) ? 1 : 17;
}

bool names_a_line(const std::string& error) {
  const std::string start = "map.yaml.journal:";
  return error.starts_with(start) && std::isdigit(static_cast<unsigned char>(error[start.size()]));
}

TEST(Journal, ContinuesTheMap) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const JournalTexts texts = make_texts(30, seed);
    const OpenedMap opened = open(texts, texts.journal);
    ASSERT_EQ(opened.file, texts.states.back()) << seed;
    EXPECT_EQ(opened.replayed, 30u);
    EXPECT_FALSE(opened.torn);
  }
}

// A crash during an append leaves a beginning of the record, which was not announced.
TEST(Journal, CutOffAnywhereGivesTheStateOfItsWholeRecords) {
  const JournalTexts texts = make_texts(2, 1);
  for (std::size_t length = 0; length < texts.journal.size(); length += step_near(texts, length)) {
    const std::string cut = texts.journal.substr(0, length);
    if (length < texts.ends[0]) {
      ASSERT_TRUE(names_a_line(error_of(texts, cut)) || length + 1 == texts.ends[0]) << length;
      continue;
    }
    std::size_t whole = 0;
    while (texts.ends[whole + 1] <= length) ++whole;
    const OpenedMap opened = open(texts, cut);
    ASSERT_EQ(opened.file, texts.states[whole]) << length;
    ASSERT_EQ(opened.torn.has_value(), length != texts.ends[whole]) << length;
    ASSERT_TRUE(!opened.torn || names_a_line(*opened.torn));
  }
}

// … or parts that were never written, which read as zeros.
TEST(Journal, LeavesOutALastRecordWithHoles) {
  const JournalTexts texts = make_texts(4, 1);
  for (std::size_t at = texts.ends[3]; at + 20 < texts.ends[4]; at += 31) {
    std::string holed = texts.journal;
    holed.replace(at, 20, 20, '\0');
    const OpenedMap opened = open(texts, holed);
    ASSERT_EQ(opened.file, texts.states[3]) << at;
    ASSERT_TRUE(opened.torn);
  }
  std::string holed = texts.journal;
  holed.replace(texts.ends[1] + 30, 20, 20, '\0');
  EXPECT_TRUE(names_a_line(error_of(texts, holed)));  // it was announced: another one follows
}

TEST(Journal, WithAnyChangedByteIsRefusedOrMeansTheSame) {
  const JournalTexts texts = make_texts(2, 2);
  const std::string odd(
      "\n9#-: \xff"
      "a");
  for (std::size_t at = 0; at < texts.journal.size(); at += step_near(texts, at)) {
    std::string bad = texts.journal;
    bad[at] = odd[at % odd.size()];
    if (bad == texts.journal) continue;
    const std::string error = error_of(texts, bad);
    if (error.empty()) {
      ASSERT_LT(at, texts.ends[0]) << "in a record";  // in the header's comment
      ASSERT_EQ(open(texts, bad).file, texts.states.back()) << at;
    } else {
      ASSERT_TRUE(names_a_line(error)) << error;
    }
  }
}

// In such bytes yaml-cpp finds one document after the other without an end. Found by fuzzing.
TEST(Journal, ThatIsNoYamlIsRefused) {
  const JournalTexts texts = make_texts(0, 2);
  const std::string bytes(
      "# What ha 7, c\n, reco9d s i rcom\xff\xff\xff\0plete: crc32 lorationstandstands\n \n  zone_i 7, "
      "cp0c7}\n",
      91);
  EXPECT_TRUE(names_a_line(error_of(texts, bytes)));
}

TEST(Journal, NamesTheLineOfTheDamagedRecord) {
  JournalTexts texts = make_texts(3, 3);
  const auto line = 1 + std::count(texts.journal.begin(),
                                   texts.journal.begin() + static_cast<std::ptrdiff_t>(texts.ends[1]), '\n');
  ++texts.journal[texts.ends[1] + 40];
  const std::string error = error_of(texts, texts.journal);
  EXPECT_TRUE(error.starts_with("map.yaml.journal:" + std::to_string(line) + ": record 59 is damaged"))
      << error;
}

TEST(Journal, WithoutOneOfItsRecordsIsRefused) {
  const JournalTexts texts = make_texts(3, 4);
  std::string gap = texts.journal;
  gap.erase(texts.ends[1], texts.ends[2] - texts.ends[1]);
  EXPECT_TRUE(names_a_line(error_of(texts, gap)));
}

// A crash between the new map file and its new journal.
TEST(Journal, WhoseRecordsAreInTheMapAlreadyIsPassedOver) {
  JournalTexts texts = make_texts(5, 5);
  texts.map = to_yaml(texts.states.back());
  const OpenedMap opened = open(texts, texts.journal);
  EXPECT_EQ(opened.file, texts.states.back());
  EXPECT_EQ(opened.replayed, 0u);
}

TEST(Journal, OfAnotherMapIsRefused) {
  JournalTexts texts = make_texts(5, 6);
  texts.map = make_texts(0, 7).map;
  EXPECT_NE(error_of(texts, texts.journal).find("of another map.yaml"), std::string::npos);
  texts = make_texts(5, 6);
  texts.map.insert(0, "# by hand\n");
  EXPECT_TRUE(names_a_line(error_of(texts, texts.journal)));
}

TEST(Journal, ThatMakesNoWholeMapIsRefused) {
  JournalTexts texts = make_texts(0, 8);
  const TopoState before{texts.states[0].map, *texts.states[0].session};
  TopoState after = before;
  after.map.rooms.clear();
  texts.journal += journal_record(58, to_yaml(change_between(before, after)));
  EXPECT_NE(error_of(texts, texts.journal).find("do not fit the map"), std::string::npos);
}

}  // namespace
}  // namespace enfilade::topo_graph
