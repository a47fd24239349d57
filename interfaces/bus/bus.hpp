// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <typeindex>
#include <utility>

#include "interfaces/topics/topic.hpp"

namespace enfilade {

/// A message with its type forgotten; Bus puts it back.
using AnyMessage = std::shared_ptr<const void>;

/// The sending end of one topic, as a bus implements it.
class Writer {
 public:
  virtual ~Writer() = default;
  virtual void write(AnyMessage message) = 0;
  /// How many readers are known to listen.
  virtual int matched_readers() const = 0;
};

/// The sending end of one topic. Movable; valid as long as its bus.
template <class T>
class Publisher {
 public:
  Publisher() = default;
  explicit Publisher(std::unique_ptr<Writer> writer) : writer_(std::move(writer)) {}

  void publish(T message) const { writer_->write(std::make_shared<const T>(std::move(message))); }
  int matched_readers() const { return writer_->matched_readers(); }

 private:
  std::unique_ptr<Writer> writer_;
};

/// One component's way to all others: publish and subscribe, typed by the topic table. Two implementations:
/// Fast DDS (interfaces/dds) and in-process (in_process_bus.hpp). Requests are built on it (service.hpp).
///
/// Handlers never run inside `subscribe` or `publish`, only from the component's executor, one at a time, so
/// a node needs no locks. Opening a topic that the table does not give to this component throws
/// std::logic_error.
class Bus {
 public:
  virtual ~Bus() = default;

  /// Messages that readers of this bus have thrown away since its start, because they came faster than they
  /// were handled. Readers that keep only the newest message lose none by that.
  virtual std::uint64_t dropped() const { return 0; }

  template <class T>
  Publisher<T> advertise(const Topic<T>& topic) {
    return Publisher<T>(open_writer(topic.info, typeid(T)));
  }

  template <class T>
  void subscribe(const Topic<T>& topic, std::function<void(const T&)> handler) {
    open_reader(topic.info, typeid(T), [handler = std::move(handler)](const AnyMessage& message) {
      handler(*static_cast<const T*>(message.get()));
    });
  }

 protected:
  using AnyHandler = std::function<void(const AnyMessage&)>;

  virtual std::unique_ptr<Writer> open_writer(const TopicInfo& topic, std::type_index type) = 0;
  virtual void open_reader(const TopicInfo& topic, std::type_index type, AnyHandler handler) = 0;
};

}  // namespace enfilade
