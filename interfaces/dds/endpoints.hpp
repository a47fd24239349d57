// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>

#include "interfaces/convert/wire_codec.hpp"
#include "interfaces/dds/inbox.hpp"
#include "interfaces/dds/participant.hpp"

namespace enfilade {

/// The sending end of one topic. Does nothing once its bus is gone.
class DdsWriter : public Writer, private eprosima::fastdds::dds::DataWriterListener {
 public:
  DdsWriter(const TopicInfo& topic, const std::shared_ptr<Participant>& participant, Participant::Warn warn);
  ~DdsWriter() override;

  void write(AnyMessage message) override;
  int matched_readers() const override;

 private:
  void on_offered_incompatible_qos(
      eprosima::fastdds::dds::DataWriter*,
      const eprosima::fastdds::dds::OfferedIncompatibleQosStatus& status) override;

  const wire::WireCodec& codec_;
  std::string topic_;
  Participant::Warn warn_;
  std::weak_ptr<Participant> participant_;
  eprosima::fastdds::dds::DataWriter* writer_ = nullptr;
};

/// Decodes what arrives on one topic, on Fast DDS's threads.
class DdsReader : public eprosima::fastdds::dds::DataReaderListener {
 public:
  DdsReader(const TopicInfo& topic, std::shared_ptr<Inbox> inbox, Participant::Warn warn);

  std::uint64_t undecodable() const { return undecodable_; }
  /// 0 where only the newest message counts.
  std::uint64_t overflowed() const { return keeps_newest_ ? 0 : inbox_->overflowed(); }

 private:
  void on_data_available(eprosima::fastdds::dds::DataReader* reader) override;
  void on_requested_incompatible_qos(
      eprosima::fastdds::dds::DataReader*,
      const eprosima::fastdds::dds::RequestedIncompatibleQosStatus& status) override;
  void take(const wire::WireBytes& bytes);

  const wire::WireCodec& codec_;
  std::string topic_;
  bool keeps_newest_;
  std::shared_ptr<Inbox> inbox_;
  Participant::Warn warn_;
  std::atomic<std::uint64_t> undecodable_ = 0;
};

}  // namespace enfilade
