// SPDX-License-Identifier: Apache-2.0
#include "interfaces/bus/in_process_bus.hpp"

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <utility>

namespace enfilade {

struct ChannelReader {
  std::function<void(const AnyMessage&)> handler;
  InProcessBus::Dispatch dispatch;
};

/// One topic: its readers in the order of subscription and what its writers have kept.
class Channel {
 public:
  /// Writers in the order of participants, then of opening.
  using WriterId = std::pair<int, int>;

  Channel(const TopicInfo& topic, std::type_index type) : topic_(topic), type_(type) {}

  const TopicInfo& topic() const { return topic_; }
  std::type_index type() const { return type_; }

  WriterId add_writer(int participant) {
    const std::lock_guard lock(mutex_);
    const WriterId id{participant, opened_++};
    history_[id];
    return id;
  }

  void remove_writer(WriterId id) {
    const std::lock_guard lock(mutex_);
    history_.erase(id);
  }

  void add_reader(const std::shared_ptr<ChannelReader>& reader) {
    const std::lock_guard lock(mutex_);
    readers_.push_back(reader);
    for (const auto& [id, messages] : history_) {
      for (const AnyMessage& message : messages) deliver(id, reader, message);
    }
  }

  void write(WriterId id, const AnyMessage& message) {
    const std::lock_guard lock(mutex_);
    std::erase_if(readers_, [](const auto& reader) { return reader.expired(); });
    for (const auto& reader : readers_) deliver(id, reader, message);
    if (topic_.qos.latched) keep(history_[id], message);
  }

  int readers() const {
    const std::lock_guard lock(mutex_);
    return static_cast<int>(
        std::ranges::count_if(readers_, [](const auto& reader) { return !reader.expired(); }));
  }

 private:
  static void deliver(WriterId id, const std::weak_ptr<ChannelReader>& to, const AnyMessage& message) {
    const auto reader = to.lock();
    if (!reader) return;
    reader->dispatch(id.first, [to, message] {
      if (const auto alive = to.lock()) alive->handler(message);
    });
  }

  void keep(std::deque<AnyMessage>& messages, const AnyMessage& message) const {
    messages.push_back(message);
    while (messages.size() > static_cast<std::size_t>(topic_.qos.depth)) messages.pop_front();
  }

  TopicInfo topic_;
  std::type_index type_;
  mutable std::mutex mutex_;
  int opened_ = 0;
  std::vector<std::weak_ptr<ChannelReader>> readers_;
  std::map<WriterId, std::deque<AnyMessage>> history_;
};

namespace {

class ChannelWriter : public Writer {
 public:
  ChannelWriter(std::shared_ptr<Channel> channel, int participant, InProcessNetwork::ThroughWire through_wire)
      : channel_(std::move(channel)),
        id_(channel_->add_writer(participant)),
        through_wire_(std::move(through_wire)) {}
  ~ChannelWriter() override { channel_->remove_writer(id_); }
  ChannelWriter(const ChannelWriter&) = delete;
  ChannelWriter& operator=(const ChannelWriter&) = delete;

  void write(AnyMessage message) override {
    channel_->write(id_, through_wire_ ? through_wire_(channel_->topic(), message) : message);
  }
  int matched_readers() const override { return channel_->readers(); }

 private:
  std::shared_ptr<Channel> channel_;
  Channel::WriterId id_;
  InProcessNetwork::ThroughWire through_wire_;
};

void require(bool allowed, const std::string& participant, const char* action, const TopicInfo& topic) {
  if (allowed) return;
  throw std::logic_error(participant + " may not " + action + " " + std::string(topic.name) +
                         ": the topic table (interfaces/topics/topics.hpp) does not list it");
}

}  // namespace

InProcessNetwork::InProcessNetwork(ThroughWire through_wire) : through_wire_(std::move(through_wire)) {}

std::shared_ptr<Channel> InProcessNetwork::channel(const TopicInfo& topic, std::type_index type) {
  const std::lock_guard lock(mutex_);
  auto& channel = channels_[std::string(topic.name)];
  if (!channel) channel = std::make_shared<Channel>(topic, type);
  if (channel->type() != type)
    throw std::logic_error(std::string(topic.name) + " is used with two message types");
  return channel;
}

InProcessBus::InProcessBus(InProcessNetwork& network, std::string participant, int index, Dispatch dispatch)
    : network_(network),
      participant_(std::move(participant)),
      index_(index),
      dispatch_(std::move(dispatch)) {}

InProcessBus::~InProcessBus() = default;

std::unique_ptr<Writer> InProcessBus::open_writer(const TopicInfo& topic, std::type_index type) {
  require(may_write(topic, participant_), participant_, "write", topic);
  return std::make_unique<ChannelWriter>(network_.channel(topic, type), index_, network_.through_wire_);
}

void InProcessBus::open_reader(const TopicInfo& topic, std::type_index type, AnyHandler handler) {
  require(may_read(topic, participant_), participant_, "read", topic);
  const auto channel = network_.channel(topic, type);
  readers_.push_back(std::make_shared<ChannelReader>(ChannelReader{std::move(handler), dispatch_}));
  channel->add_reader(readers_.back());
}

}  // namespace enfilade
