// SPDX-License-Identifier: Apache-2.0
#include "interfaces/dds/dds_bus.hpp"

#include <mutex>
#include <set>
#include <stdexcept>
#include <vector>

#include "interfaces/dds/endpoints.hpp"

namespace enfilade {

namespace {

void require(bool allowed, const char* what, const std::string& component, const TopicInfo& topic) {
  if (allowed) return;
  throw std::logic_error(component + " may not " + what + " " + std::string(topic.name) +
                         ": the topic table does not name it");
}

void require_type(const TopicInfo& topic, std::type_index type) {
  if (wire::codec_of(topic).model_type == type) return;
  throw std::logic_error(std::string(topic.name) + " does not carry messages of type " + type.name());
}

/// Says every warning once, on the executor.
class Warnings : public std::enable_shared_from_this<Warnings> {
 public:
  Warnings(Executor& executor, Log& log, std::shared_ptr<Gate> gate)
      : executor_(executor), log_(log), gate_(std::move(gate)) {}

  void say(const std::string& text) {
    {
      const std::lock_guard lock(mutex_);
      if (!said_.insert(text).second || said_.size() > kMost) return;
    }
    executor_.post([self = shared_from_this(), text] { self->gate_->pass([&] { self->log_.warn(text); }); });
  }

 private:
  static constexpr std::size_t kMost = 1000;

  Executor& executor_;
  Log& log_;
  std::shared_ptr<Gate> gate_;
  std::mutex mutex_;
  std::set<std::string> said_;
};

}  // namespace

class DdsBus::Impl {
 public:
  Impl(const std::string& component, const DdsConfig& config, Executor& executor, Log& log)
      : executor_(executor),
        gate_(std::make_shared<Gate>()),
        warnings_(std::make_shared<Warnings>(executor, log, gate_)),
        participant_(std::make_shared<Participant>(component, config, warn())) {}

  ~Impl() {
    gate_->close();
    participant_.reset();  // before the listeners in readers_
  }

  std::unique_ptr<Writer> open_writer(const TopicInfo& topic) {
    return std::make_unique<DdsWriter>(topic, participant_, warn());
  }

  void open_reader(const TopicInfo& topic, AnyHandler handler) {
    const auto depth = static_cast<std::size_t>(topic.qos.depth);
    auto inbox = std::make_shared<Inbox>(executor_, gate_, depth, std::move(handler));
    auto reader = std::make_unique<DdsReader>(topic, std::move(inbox), warn());
    DdsReader* const listener = reader.get();
    {
      const std::lock_guard lock(mutex_);
      readers_.push_back(std::move(reader));
    }
    participant_->make_reader(topic, listener);
  }

  DdsDrops drops() const {
    const std::lock_guard lock(mutex_);
    DdsDrops drops;
    for (const auto& reader : readers_) {
      drops.undecodable += reader->undecodable();
      drops.overflowed += reader->overflowed();
    }
    return drops;
  }

  const Participant& participant() const { return *participant_; }

 private:
  Participant::Warn warn() const {
    return [warnings = warnings_](const std::string& text) { warnings->say(text); };
  }

  Executor& executor_;
  std::shared_ptr<Gate> gate_;
  std::shared_ptr<Warnings> warnings_;
  mutable std::mutex mutex_;
  std::vector<std::unique_ptr<DdsReader>> readers_;
  std::shared_ptr<Participant> participant_;
};

DdsBus::DdsBus(const std::string& component, const DdsConfig& config, Executor& executor, Log& log)
    : impl_(std::make_unique<Impl>(component, config, executor, log)) {}

DdsBus::~DdsBus() = default;

DdsDrops DdsBus::drops() const { return impl_->drops(); }

bool DdsBus::uses_shared_memory() const { return impl_->participant().uses_shared_memory(); }

std::unique_ptr<Writer> DdsBus::open_writer(const TopicInfo& topic, std::type_index type) {
  const std::string& component = impl_->participant().name();
  require(may_write(topic, component), "write", component, topic);
  require_type(topic, type);
  return impl_->open_writer(topic);
}

void DdsBus::open_reader(const TopicInfo& topic, std::type_index type, AnyHandler handler) {
  const std::string& component = impl_->participant().name();
  require(may_read(topic, component), "read", component, topic);
  require_type(topic, type);
  impl_->open_reader(topic, std::move(handler));
}

}  // namespace enfilade
