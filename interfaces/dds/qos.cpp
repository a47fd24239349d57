// SPDX-License-Identifier: Apache-2.0
#include "interfaces/dds/qos.hpp"

#include <algorithm>
#include <array>

namespace enfilade {

namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::Duration_t;

/// How soon a lost message is asked for again.
const Duration_t kHeartbeatPeriod{0, 50'000'000};
const Duration_t kNoDelay{0, 0};

/// May be larger than one datagram: a thread of Fast DDS sends them, so that the component does not wait for
/// the fragments.
constexpr std::array<std::string_view, 7> kLargeTypes{"sensor_msgs::msg::dds_::PointCloud2_",
                                                      "nav_msgs::msg::dds_::OccupancyGrid_",
                                                      "octomap_msgs::msg::dds_::Octomap_",
                                                      "enfilade_msgs::msg::dds_::GridChange_",
                                                      "enfilade_msgs::msg::dds_::ScanHits_",
                                                      "enfilade_msgs::msg::dds_::TopologicalMap_",
                                                      "enfilade_msgs::srv::dds_::GridSnapshot_Response_"};

bool may_be_large(const TopicInfo& topic) {
  return std::ranges::find(kLargeTypes, topic.wire_type) != kLargeTypes.end();
}

/// What writers and readers have in common.
template <class EntityQos>
EntityQos common_qos(const TopicInfo& topic, int max_samples) {
  EntityQos qos;
  qos.reliability().kind =
      topic.qos.reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind =
      topic.qos.latched ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = topic.qos.depth;
  qos.resource_limits().max_instances = 1;
  qos.resource_limits().max_samples = max_samples;
  qos.resource_limits().max_samples_per_instance = max_samples;
  qos.resource_limits().allocated_samples = std::min(topic.qos.depth, 8);
  qos.liveliness().kind = dds::AUTOMATIC_LIVELINESS_QOS;
  // Buffers that are kept have room for the largest sample that ever was in them.
  qos.endpoint().history_memory_policy =
      may_be_large(topic) ? eprosima::fastrtps::rtps::DYNAMIC_RESERVE_MEMORY_MODE
                          : eprosima::fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  qos.data_sharing().off();
  return qos;
}

}  // namespace

dds::DataWriterQos writer_qos(const TopicInfo& topic) {
  auto qos = common_qos<dds::DataWriterQos>(topic, topic.qos.depth);
  qos.publish_mode().kind =
      may_be_large(topic) ? dds::ASYNCHRONOUS_PUBLISH_MODE : dds::SYNCHRONOUS_PUBLISH_MODE;
  qos.reliable_writer_qos().times.heartbeatPeriod = kHeartbeatPeriod;
  qos.reliable_writer_qos().times.nackResponseDelay = kNoDelay;
  return qos;
}

dds::DataReaderQos reader_qos(const TopicInfo& topic) {
  // Room for what is under way from several writers beyond what is kept.
  auto qos = common_qos<dds::DataReaderQos>(topic, 4 * topic.qos.depth + 16);
  qos.reliable_reader_qos().times.heartbeatResponseDelay = kNoDelay;
  return qos;
}

const char* policy_name(dds::QosPolicyId_t policy) {
  switch (policy) {
    case dds::DURABILITY_QOS_POLICY_ID:
      return "durability";
    case dds::RELIABILITY_QOS_POLICY_ID:
      return "reliability";
    case dds::LIVELINESS_QOS_POLICY_ID:
      return "liveliness";
    case dds::DEADLINE_QOS_POLICY_ID:
      return "deadline";
    case dds::OWNERSHIP_QOS_POLICY_ID:
      return "ownership";
    case dds::DATAREPRESENTATION_QOS_POLICY_ID:
      return "data representation";
    default:
      return "other";
  }
}

}  // namespace enfilade
