// SPDX-License-Identifier: Apache-2.0
#include "interfaces/topics/topics.hpp"

namespace enfilade {
namespace {

constexpr std::string_view kTools = "enfilade";

}  // namespace

bool lists(std::string_view names, std::string_view name) {
  while (!names.empty()) {
    const std::size_t space = names.find(' ');
    const std::string_view entry = names.substr(0, space);
    if (entry == name || (entry == "*" && name != "simulator" && name != kTools)) return true;
    names = space == std::string_view::npos ? std::string_view{} : names.substr(space + 1);
  }
  return false;
}

bool is_tool(std::string_view participant) { return participant.starts_with(kTools); }

bool may_write(const TopicInfo& topic, std::string_view participant) {
  return lists(topic.writers, is_tool(participant) ? kTools : participant);
}

bool may_read(const TopicInfo& topic, std::string_view participant) {
  return is_tool(participant) || lists(topic.readers, participant);
}

std::vector<TopicInfo> topics::table() {
  std::vector<TopicInfo> rows;
  for_each_topic([&rows](const auto& topic) { rows.push_back(topic.info); });
  return rows;
}

}  // namespace enfilade
