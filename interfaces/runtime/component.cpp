// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/component.hpp"

#include <utility>

#include "interfaces/topics/topics.hpp"

namespace enfilade {
namespace {

std::string sentence_of(const std::exception_ptr& exception) {
  try {
    std::rethrow_exception(exception);
  } catch (const std::exception& e) {
    return e.what();
  } catch (...) {
    return "an exception without a text";
  }
}

}  // namespace

Component::Component(ComponentConfig config, Bus& bus, const Clock& clock, Executor& executor, Log& log,
                     MakeNode make_node)
    : config_(std::move(config)),
      context_{config_.name, bus, clock, executor, log, *this},
      make_node_(std::move(make_node)),
      heartbeat_(bus.advertise(topics::kHeartbeat)) {
  executor.on_exception([this](const std::exception_ptr& e) { fail("a handler", e); });
}

Component::~Component() = default;

void Component::announce() {
  // Nothing is sent in a composed run, where wall time does not exist.
  context_.executor.every_wall(from_seconds(config_.heartbeat_s), [this] { beat(); });
}

void Component::start() {
  node_ = make_node_(context_);
  node_->initialize();
  if (state_ == LifecycleState::kInitializing) enter(LifecycleState::kComputing);
  context_.executor.every(from_seconds(config_.period.compute_s), [this] { compute(); });
  context_.executor.every(from_seconds(config_.period.emergency_s), [this] { emergency(); });
}

void Component::stop() {
  const bool started = node_ && state_ != LifecycleState::kInitializing;
  enter(LifecycleState::kStopping);
  if (started) guarded("shutdown()", [this] { node_->shutdown(); });
  beat();
}

void Component::go_to_emergency(std::string reason) {
  if (state_ == LifecycleState::kStopping) return;
  if (!in_emergency()) context_.log.warn("emergency: " + reason);
  detail_ = std::move(reason);
  failed_ns_.reset();
  enter(LifecycleState::kEmergency);
}

void Component::go_to_restore() {
  if (!in_emergency()) return;
  enter(LifecycleState::kRestoring);
  context_.executor.post([this] { restore(); });
}

void Component::enter(LifecycleState state) {
  state_ = state;
  if (state != LifecycleState::kEmergency) detail_.clear();
}

void Component::compute() {
  if (state_ != LifecycleState::kComputing) return;
  ++cycles_;
  guarded("compute()", [this] { node_->compute(); });
}

void Component::emergency() {
  if (!in_emergency()) return;
  guarded("emergency()", [this] { node_->emergency(); });
  const bool rested = failed_ns_ && seconds(context_.clock.now_ns() - *failed_ns_) >= config_.rest_s;
  if (rested) go_to_restore();
}

void Component::restore() {
  if (state_ != LifecycleState::kRestoring) return;
  guarded("restore()", [this] { node_->restore(); });
  if (state_ != LifecycleState::kRestoring) return;
  context_.log.info("emergency is over");
  enter(LifecycleState::kComputing);
}

void Component::guarded(const std::string& where, const std::function<void()>& call) {
  try {
    call();
  } catch (...) {
    fail(where, std::current_exception());
  }
}

void Component::fail(const std::string& where, const std::exception_ptr& exception) {
  const std::string reason = where + " failed: " + sentence_of(exception);
  ++failures_;
  context_.log.error(reason);
  if (state_ == LifecycleState::kStopping) return;
  detail_ = reason;
  failed_ns_ = context_.clock.now_ns();
  enter(LifecycleState::kEmergency);
}

void Component::beat() const {
  heartbeat_.publish({.component_name = config_.name,
                      .host = config_.host,
                      .pid = config_.pid,
                      .wall_ns = config_.wall_now_ns ? config_.wall_now_ns() : 0,
                      .state = state_,
                      .cycles = cycles_,
                      .detail = detail_});
}

}  // namespace enfilade
