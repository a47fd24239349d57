// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include "interfaces/dds/dds_config.hpp"
#include "interfaces/topics/topic.hpp"

namespace enfilade {

/// One participant of Fast DDS and everything made in it. Any thread.
class Participant : private eprosima::fastdds::dds::DomainParticipantListener {
 public:
  using Warn = std::function<void(const std::string&)>;

  /// `warn` is called from any thread. Throws std::runtime_error.
  Participant(const std::string& name, const DdsConfig& config, Warn warn);
  ~Participant() override;
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  /// Never null; the listener outlives what it listens to.
  eprosima::fastdds::dds::DataWriter* make_writer(const TopicInfo& topic,
                                                  eprosima::fastdds::dds::DataWriterListener* listener);
  eprosima::fastdds::dds::DataReader* make_reader(const TopicInfo& topic,
                                                  eprosima::fastdds::dds::DataReaderListener* listener);
  void remove(eprosima::fastdds::dds::DataWriter* writer);

  bool uses_shared_memory() const { return shared_memory_; }
  const std::string& name() const { return name_; }

 private:
  void choose_transports(const DdsConfig& config, eprosima::fastdds::dds::DomainParticipantQos& qos);
  eprosima::fastdds::dds::Topic* topic_of(const TopicInfo& topic);
  void on_subscriber_discovery(eprosima::fastdds::dds::DomainParticipant*,
                               eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) override;
  void on_publisher_discovery(eprosima::fastdds::dds::DomainParticipant*,
                              eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;
  void found_type(const std::string& topic, const std::string& type);
  void opened_type(const TopicInfo& topic);
  void warn_of_types(const std::string& topic, const std::string& ours, const std::string& theirs);

  std::string name_;
  Warn warn_;
  bool shared_memory_ = false;
  std::mutex entities_;  ///< entities are made one at a time
  std::mutex types_;     ///< never held while Fast DDS is called
  std::map<std::string, std::string> own_types_;
  std::map<std::string, std::set<std::string>> found_types_;
  eprosima::fastdds::dds::DomainParticipant* participant_ = nullptr;
  eprosima::fastdds::dds::Publisher* publisher_ = nullptr;
  eprosima::fastdds::dds::Subscriber* subscriber_ = nullptr;
};

}  // namespace enfilade
