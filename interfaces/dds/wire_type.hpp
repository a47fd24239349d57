// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <fastdds/dds/topic/TopicDataType.hpp>

namespace enfilade {

/// A DDS type whose samples are finished bytes (wire::WireBytes): encoding and decoding stay outside Fast
/// DDS, where a corrupted message can be refused in good order. No type object is sent, as ROS 2 does it.
class WireType : public eprosima::fastdds::dds::TopicDataType {
 public:
  explicit WireType(std::string_view name);

  bool serialize(void* sample, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override;
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* sample) override;
  std::function<std::uint32_t()> getSerializedSizeProvider(void* sample) override;
  void* createData() override;
  void deleteData(void* sample) override;
  bool getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) override { return false; }
};

}  // namespace enfilade
