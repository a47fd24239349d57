// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "interfaces/dds/dds_bus.hpp"
#include "interfaces/runtime/component_log.hpp"
#include "interfaces/runtime/deployed_clock.hpp"
#include "interfaces/runtime/service.hpp"
#include "interfaces/runtime/thread_executor.hpp"

namespace enfilade::live {

/// A look at a system that runs: its latched state and the answers to questions, each within a few seconds
/// or not at all. For one thread.
class LiveSystem {
 public:
  explicit LiveSystem(int domain);
  ~LiveSystem();

  /// What a latched topic holds now.
  template <class T>
  std::optional<T> newest(const Topic<T>& topic) {
    auto first = std::make_shared<Once<T>>();
    bus_.subscribe<T>(topic, [first](const T& message) { first->set(message); });
    return first->wait();
  }

  template <class Q, class A>
  std::optional<A> ask(const Service<Q, A>& service, Q request) {
    auto answer = std::make_shared<Once<A>>();
    executor_.post([this, &service, request = std::move(request), answer] {
      auto client = std::make_shared<Client<Q, A>>(context_, service, kRetry_ns);
      clients_.push_back(client);
      client->call(request, [answer](const A& reply) { answer->set(reply); });
    });
    return answer->wait();
  }

 private:
  static constexpr StampNs kRetry_ns = 200'000'000;
  static constexpr std::chrono::seconds kPatience{5};

  /// The first of what may come several times.
  template <class T>
  class Once {
   public:
    void set(const T& value) {
      if (!std::exchange(is_set_, true)) promise_.set_value(value);
    }
    std::optional<T> wait() {
      std::future<T> future = promise_.get_future();
      if (future.wait_for(kPatience) != std::future_status::ready) return std::nullopt;
      return future.get();
    }

   private:
    std::promise<T> promise_;
    bool is_set_ = false;
  };

  struct NoLifecycle : Lifecycle {
    void go_to_emergency(std::string) override {}
    void go_to_restore() override {}
    bool in_emergency() const override { return false; }
  };

  SystemClock clock_;
  ComponentLog log_;
  NoLifecycle lifecycle_;
  std::vector<std::shared_ptr<void>> clients_;  ///< they outlive the bus that calls them
  ThreadExecutor executor_;
  DdsBus bus_;
  NodeContext context_;
};

}  // namespace enfilade::live
