// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>

#include "interfaces/topics/topic.hpp"

namespace enfilade {

eprosima::fastdds::dds::DataWriterQos writer_qos(const TopicInfo& topic);
eprosima::fastdds::dds::DataReaderQos reader_qos(const TopicInfo& topic);

/// "reliability", "durability" …
const char* policy_name(eprosima::fastdds::dds::QosPolicyId_t policy);

}  // namespace enfilade
