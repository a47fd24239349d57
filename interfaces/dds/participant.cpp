// SPDX-License-Identifier: Apache-2.0
#include "interfaces/dds/participant.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <unistd.h>

#include "interfaces/dds/qos.hpp"
#include "interfaces/dds/shared_memory.hpp"
#include "interfaces/dds/wire_type.hpp"

namespace enfilade {

namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;
using eprosima::fastrtps::Duration_t;
using eprosima::fastrtps::types::ReturnCode_t;

constexpr std::uint32_t kSocketBufferBytes = 4 << 20;
constexpr std::size_t kShmOverheadBytes = 4 << 20;  // ports and the segment's own bookkeeping

/// Set unless the profiles file has said otherwise.
void set_lease(double lease_s, dds::DomainParticipantQos& qos) {
  auto& discovery = qos.wire_protocol().builtin.discovery_config;
  const auto untouched = dds::DomainParticipantQos().wire_protocol().builtin.discovery_config.leaseDuration;
  if (!(discovery.leaseDuration == untouched)) return;
  discovery.leaseDuration = Duration_t(static_cast<long double>(lease_s));
  discovery.leaseDuration_announcementperiod = Duration_t(static_cast<long double>(lease_s / 3.0));
}

/// Left to itself Fast DDS gives the lowest free id, which after a SIGKILL is that of the dead participant,
/// and with it the shared memory port that other processes still have mapped: what they send goes into the
/// old one, and the new participant stays unheard. The process id makes the ports of a restarted process new
/// ones. A profiles file may set another. Unique within the process, and small enough for a port of any
/// domain.
void set_participant_id(int domain, dds::DomainParticipantQos& qos) {
  static std::atomic<int> made_before = 0;
  if (qos.wire_protocol().participant_id >= 0) return;
  const int ids = std::min(100, (65535 - 7400 - 250 * domain - 11) / 2);
  qos.wire_protocol().participant_id = (static_cast<int>(getpid()) + made_before++) % std::max(1, ids);
}

std::shared_ptr<rtps::UDPv4TransportDescriptor> udp_transport(const DdsConfig& config) {
  auto udp = std::make_shared<rtps::UDPv4TransportDescriptor>();
  udp->maxMessageSize = static_cast<std::uint32_t>(config.max_datagram_bytes);
  udp->sendBufferSize = kSocketBufferBytes;
  udp->receiveBufferSize = kSocketBufferBytes;
  return udp;
}

std::shared_ptr<rtps::SharedMemTransportDescriptor> shm_transport(const DdsConfig& config) {
  auto shm = std::make_shared<rtps::SharedMemTransportDescriptor>();
  shm->segment_size(static_cast<std::uint32_t>(config.shm_segment_bytes));
  shm->max_message_size(static_cast<std::uint32_t>(config.max_datagram_bytes));
  return shm;
}

}  // namespace

Participant::Participant(const std::string& name, const DdsConfig& config, Warn warn)
    : name_(name), warn_(std::move(warn)) {
  auto* const factory = dds::DomainParticipantFactory::get_instance();
  factory->load_profiles();
  dds::DomainParticipantQos qos;
  factory->get_default_participant_qos(qos);
  qos.name(name);
  qos.properties().properties().emplace_back("enfilade.component", name, true);
  set_lease(config.lease_s, qos);
  set_participant_id(config.domain, qos);
  choose_transports(config, qos);

  participant_ = factory->create_participant(static_cast<std::uint32_t>(config.domain), qos, this,
                                             dds::StatusMask::none());
  if (participant_ == nullptr) {
    throw std::runtime_error("no DDS participant can be made in domain " + std::to_string(config.domain) +
                             ": check the network interfaces and the domain (0 to 232)");
  }
  publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
}

Participant::~Participant() {
  participant_->set_listener(nullptr);
  participant_->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

void Participant::choose_transports(const DdsConfig& config, dds::DomainParticipantQos& qos) {
  if (!qos.transport().use_builtin_transports || !qos.transport().user_transports.empty()) return;
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports.push_back(udp_transport(config));
  if (!config.shared_memory) return;
  if (const auto why = why_no_shared_memory(config.shm_segment_bytes + kShmOverheadBytes)) {
    warn_("running over UDP only, without shared memory: " + *why);
    return;
  }
  qos.transport().user_transports.push_back(shm_transport(config));
  shared_memory_ = true;
}

dds::DataWriter* Participant::make_writer(const TopicInfo& topic, dds::DataWriterListener* listener) {
  opened_type(topic);
  const std::lock_guard lock(entities_);
  auto* const writer = publisher_->create_datawriter(topic_of(topic), writer_qos(topic), listener);
  if (writer == nullptr) throw std::runtime_error("no DDS writer can be made for " + std::string(topic.name));
  return writer;
}

dds::DataReader* Participant::make_reader(const TopicInfo& topic, dds::DataReaderListener* listener) {
  opened_type(topic);
  const std::lock_guard lock(entities_);
  auto* const reader = subscriber_->create_datareader(topic_of(topic), reader_qos(topic), listener);
  if (reader == nullptr) throw std::runtime_error("no DDS reader can be made for " + std::string(topic.name));
  return reader;
}

void Participant::remove(dds::DataWriter* writer) {
  const std::lock_guard lock(entities_);
  publisher_->delete_datawriter(writer);
}

dds::Topic* Participant::topic_of(const TopicInfo& topic) {
  const std::string name(topic.name), type(topic.wire_type);
  if (auto* const known = participant_->lookup_topicdescription(name))
    return dynamic_cast<dds::Topic*>(known);
  if (participant_->find_type(type).empty())
    participant_->register_type(dds::TypeSupport(new WireType(type)), type);
  auto* const made = participant_->create_topic(name, type, dds::TOPIC_QOS_DEFAULT);
  if (made == nullptr) throw std::runtime_error("no DDS topic " + name + " of type " + type + " can be made");
  return made;
}

void Participant::on_subscriber_discovery(dds::DomainParticipant*,
                                          eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) {
  if (info.status != eprosima::fastrtps::rtps::ReaderDiscoveryInfo::DISCOVERED_READER) return;
  found_type(info.info.topicName().to_string(), info.info.typeName().to_string());
}

void Participant::on_publisher_discovery(dds::DomainParticipant*,
                                         eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) {
  if (info.status != eprosima::fastrtps::rtps::WriterDiscoveryInfo::DISCOVERED_WRITER) return;
  found_type(info.info.topicName().to_string(), info.info.typeName().to_string());
}

void Participant::found_type(const std::string& topic, const std::string& type) {
  std::string ours;
  {
    const std::lock_guard lock(types_);
    if (!found_types_[topic].insert(type).second) return;
    if (const auto own = own_types_.find(topic); own != own_types_.end()) ours = own->second;
  }
  warn_of_types(topic, ours, type);
}

void Participant::opened_type(const TopicInfo& topic) {
  const std::string name(topic.name), type(topic.wire_type);
  std::set<std::string> theirs;
  {
    const std::lock_guard lock(types_);
    if (!own_types_.emplace(name, type).second) return;
    theirs = found_types_[name];
  }
  for (const std::string& other : theirs) warn_of_types(name, type, other);
}

void Participant::warn_of_types(const std::string& topic, const std::string& ours,
                                const std::string& theirs) {
  if (ours.empty() || ours == theirs) return;
  warn_(topic + ": somebody has opened it with type " + theirs + " instead of " + ours +
        "; no data flows between us");
}

}  // namespace enfilade
