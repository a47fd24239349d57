// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "interfaces/runtime/composed_system.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade {

/// One node on the in-process bus under virtual time. The test plays all other components:
///
///   NodeHarness<GridBuilderNode, GridBuilderConfig> harness("gridBuilder", config);
///   auto& changes = harness.collect(topics::kGridChange);
///   harness.publish(topics::kMotorState, state);
///   harness.advance_s(0.1);
///   ASSERT_EQ(changes.size(), 1u);
///
/// initialize() is called by the first advance_s(), node() or call(). What was published before is lost
/// unless the topic is latched, as between processes. An exception that escapes the node makes advance_s()
/// throw, unless `allow_failures`.
template <class NodeType, class Config>
class NodeHarness {
 public:
  NodeHarness(const std::string& component, const Config& config) : component_(component) {
    system_.tool_bus();
    system_.add(component, config.period, [this, config](const NodeContext& context) {
      auto made = std::make_unique<NodeType>(context, config);
      node_ = made.get();
      return made;
    });
  }

  /// Publishes as the topic's first writer in the topic table.
  template <class T>
  void publish(const Topic<T>& topic, T message) {
    publish_as(first_of(topic.info.writers), topic, std::move(message));
  }

  template <class T>
  void publish_as(const std::string& participant, const Topic<T>& topic, T message) {
    auto& publisher = publishers_[participant + " " + std::string(topic.info.name)];
    if (!publisher) publisher = std::make_shared<Publisher<T>>(system_.bus_as(participant).advertise(topic));
    static_cast<const Publisher<T>*>(publisher.get())->publish(std::move(message));
  }

  /// What anyone publishes on `topic` from now on (and what is latched). Lives as long as the harness; may be
  /// cleared.
  template <class T>
  std::vector<T>& collect(const Topic<T>& topic) {
    const auto messages = std::make_shared<std::vector<T>>();
    collected_.push_back(messages);
    system_.tool_bus().subscribe<T>(topic, [messages](const T& message) { messages->push_back(message); });
    return *messages;
  }

  /// Asks the node's service and waits for the answer, at most `timeout_s` of virtual time.
  template <class Q, class A>
  std::optional<A> call(const Service<Q, A>& service, Q request, double timeout_s = 1.0) {
    node();
    if (request.call == CallId{}) request.call = {"test", ++calls_};
    const auto answer = std::make_shared<std::optional<A>>();
    system_.tool_bus().subscribe<A>(service.reply, [answer, call = request.call](const A& reply) {
      if (reply.call == call) *answer = reply;
    });
    publish(service.request, std::move(request));
    run_until([&answer] { return answer->has_value(); }, timeout_s);
    return *answer;
  }

  /// Lets virtual time pass; all that is due by then is done, what is due right then included.
  void advance_s(double duration_s) { run_until({}, duration_s); }

  /// Lets virtual time pass until `stop()` holds; false if it does not within `timeout_s`.
  bool run_until(const std::function<bool()>& stop, double timeout_s) {
    const bool stopped = system_.run_until(stop, now_ns() + from_seconds(timeout_s));
    if (!allow_failures && system_.component(component_).failures() > 0) {
      throw std::runtime_error(component_ + ": " + (logged_.empty() ? "failed" : logged_.back().text));
    }
    return stopped;
  }

  NodeType& node() {
    system_.initialize();
    return *node_;
  }

  /// Another component's bus, to serve requests on or to subscribe with.
  Bus& bus_as(const std::string& participant) { return system_.bus_as(participant); }
  StampNs now_ns() const { return system_.clock().now_ns(); }
  const Component& component() const { return system_.component(component_); }
  /// All lines the node has logged.
  const std::vector<LogLine>& logged() const { return logged_; }

  bool allow_failures = false;

 private:
  static std::string first_of(std::string_view names) {
    const std::string first(names.substr(0, names.find(' ')));
    if (first.empty() || first == "*") throw std::logic_error("say who publishes: use publish_as()");
    return first;
  }

  std::string component_;
  std::vector<LogLine> logged_;
  NodeType* node_ = nullptr;
  std::uint64_t calls_ = 0;
  ComposedSystem system_{
      {.log = [this](const LogLine& line) { logged_.push_back(line); }, .through_wire = {}}};
  std::map<std::string, std::shared_ptr<void>> publishers_;
  std::deque<std::shared_ptr<void>> collected_;
};

}  // namespace enfilade
