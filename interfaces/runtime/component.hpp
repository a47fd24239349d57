// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "interfaces/model/health.hpp"
#include "interfaces/runtime/config.hpp"
#include "interfaces/runtime/node.hpp"

namespace enfilade {

/// Makes a component's node; the context outlives it.
using MakeNode = std::function<std::unique_ptr<Node>(const NodeContext&)>;

struct ComponentConfig {
  std::string name;
  PeriodConfig period;
  double heartbeat_s = 0.5;  ///< wall time; > 0
  double rest_s = 1.0;       ///< after an exception; then the component is restored
  std::string host;
  std::uint32_t pid = 0;
  std::function<StampNs()> wall_now_ns;  ///< for the heartbeat's stamp; without it 0
};

/// Drives one node through its life, deployed and composed alike: initialize once, compute() every period;
/// after go_to_emergency() emergency() every period; after go_to_restore() restore() once and compute()
/// again. An exception from anything but the node's constructor and initialize() is logged and enters
/// emergency, which ends after a rest: one bad message must not end a component's work. An emergency that
/// the node asked for lasts until its emergency() ends it. The heartbeat says why there is one.
///
/// All calls on the executor's thread, but for construction and destruction.
class Component : public Lifecycle {
 public:
  Component(ComponentConfig config, Bus& bus, const Clock& clock, Executor& executor, Log& log,
            MakeNode make_node);
  ~Component() override;
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;

  /// Opens the heartbeat: the component is seen as initializing.
  void announce();
  /// Makes and initializes the node and starts its periods. Passes on what the node throws.
  void start();
  /// Node::shutdown(), if it ever started; then a last heartbeat. The executor must call nothing of the node
  /// afterwards.
  void stop();

  void go_to_emergency(std::string reason) override;
  void go_to_restore() override;
  bool in_emergency() const override { return state_ == LifecycleState::kEmergency; }

  const std::string& name() const { return config_.name; }
  LifecycleState state() const { return state_; }
  std::uint64_t cycles() const { return cycles_; }
  /// Exceptions that have led to emergency.
  int failures() const { return failures_; }

 private:
  void enter(LifecycleState state);
  void compute();
  void emergency();
  void restore();
  void fail(const std::string& where, const std::exception_ptr& exception);
  void guarded(const std::string& where, const std::function<void()>& call);
  void beat() const;

  ComponentConfig config_;
  NodeContext context_;
  MakeNode make_node_;
  Publisher<Heartbeat> heartbeat_;
  std::unique_ptr<Node> node_;
  LifecycleState state_ = LifecycleState::kInitializing;
  std::string detail_;
  std::optional<StampNs> failed_ns_;  ///< of the exception that led to this emergency
  std::uint64_t cycles_ = 0;
  int failures_ = 0;
};

}  // namespace enfilade
