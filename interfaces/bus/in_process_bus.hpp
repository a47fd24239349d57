// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <typeindex>
#include <vector>

#include "interfaces/bus/bus.hpp"

namespace enfilade {

class Channel;
struct ChannelReader;

/// The topics that the buses of one process share. A latched topic keeps the last `depth` messages of each
/// writer for late subscribers; they die with the writer, as on DDS. Order depends on nothing but the order
/// of calls.
class InProcessNetwork {
 public:
  /// Replaces each message on its way, e.g. by what is left of it after a trip through the wire types.
  using ThroughWire = std::function<AnyMessage(const TopicInfo&, const AnyMessage&)>;

  explicit InProcessNetwork(ThroughWire through_wire = {});

 private:
  friend class InProcessBus;
  std::shared_ptr<Channel> channel(const TopicInfo& topic, std::type_index type);

  ThroughWire through_wire_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Channel>, std::less<>> channels_;
};

/// One participant's end of an InProcessNetwork.
class InProcessBus : public Bus {
 public:
  /// Runs `work` on the reader's executor; `writer` is the index of the participant that wrote the message.
  using Dispatch = std::function<void(int writer, std::function<void()> work)>;

  /// `index` is unique in the network and breaks ties between messages of the same instant.
  InProcessBus(InProcessNetwork& network, std::string participant, int index, Dispatch dispatch);
  ~InProcessBus() override;

 protected:
  std::unique_ptr<Writer> open_writer(const TopicInfo& topic, std::type_index type) override;
  void open_reader(const TopicInfo& topic, std::type_index type, AnyHandler handler) override;

 private:
  InProcessNetwork& network_;
  std::string participant_;
  int index_;
  Dispatch dispatch_;
  std::vector<std::shared_ptr<ChannelReader>> readers_;
};

}  // namespace enfilade
