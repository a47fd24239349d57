// SPDX-License-Identifier: Apache-2.0
#include "interfaces/dds/endpoints.hpp"

#include <fastdds/dds/subscriber/SampleInfo.hpp>

#include "interfaces/dds/qos.hpp"

namespace enfilade {

namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

}  // namespace

DdsWriter::DdsWriter(const TopicInfo& topic, const std::shared_ptr<Participant>& participant,
                     Participant::Warn warn)
    : codec_(wire::codec_of(topic)), topic_(topic.name), warn_(std::move(warn)), participant_(participant) {
  writer_ = participant->make_writer(topic, this);
}

DdsWriter::~DdsWriter() {
  if (const auto participant = participant_.lock()) participant->remove(writer_);
}

void DdsWriter::write(AnyMessage message) {
  const auto participant = participant_.lock();
  if (!participant) return;
  wire::WireBytes bytes = codec_.encode(message.get());
  if (!writer_->write(&bytes))
    warn_(topic_ + ": Fast DDS did not take a message of " + std::to_string(bytes.size()) + " bytes");
}

int DdsWriter::matched_readers() const {
  const auto participant = participant_.lock();
  dds::PublicationMatchedStatus status;
  if (!participant || writer_->get_publication_matched_status(status) != ReturnCode_t::RETCODE_OK) return 0;
  return status.current_count;
}

void DdsWriter::on_offered_incompatible_qos(dds::DataWriter*,
                                            const dds::OfferedIncompatibleQosStatus& status) {
  warn_(topic_ + ": a reader asks for a " + policy_name(status.last_policy_id) +
        " that we do not offer; no data flows to it");
}

DdsReader::DdsReader(const TopicInfo& topic, std::shared_ptr<Inbox> inbox, Participant::Warn warn)
    : codec_(wire::codec_of(topic)),
      topic_(topic.name),
      keeps_newest_(topic.qos.depth == 1),
      inbox_(std::move(inbox)),
      warn_(std::move(warn)) {}

void DdsReader::on_data_available(dds::DataReader* reader) {
  wire::WireBytes bytes;
  dds::SampleInfo info;
  while (reader->take_next_sample(&bytes, &info) == ReturnCode_t::RETCODE_OK) {
    if (info.valid_data) take(bytes);
  }
}

void DdsReader::take(const wire::WireBytes& bytes) {
  try {
    inbox_->push(codec_.decode(bytes));
  } catch (const wire::WireError& error) {
    if (undecodable_++ == 0)
      warn_(topic_ + ": a message was dropped, as will be all like it: " + error.what());
  }
}

void DdsReader::on_requested_incompatible_qos(dds::DataReader*,
                                              const dds::RequestedIncompatibleQosStatus& status) {
  warn_(topic_ + ": a writer does not offer the " + policy_name(status.last_policy_id) +
        " that we ask for; no data flows from it");
}

}  // namespace enfilade
