// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "interfaces/bus/bus.hpp"
#include "interfaces/model/requests.hpp"
#include "interfaces/runtime/node.hpp"

namespace enfilade {

/// Answers every request on `service`. A request may be repeated: `answer` must give the same answer to the
/// same CallId.
template <class Q, class A>
void serve(Bus& bus, const Service<Q, A>& service, std::function<A(const Q&)> answer) {
  auto reply = std::make_shared<Publisher<A>>(bus.advertise(service.reply));
  bus.subscribe<Q>(service.request, [reply, answer = std::move(answer)](const Q& request) {
    A message = answer(request);
    message.call = request.call;
    reply->publish(std::move(message));
  });
}

/// Asks one question at a time and repeats it until it is answered, whichever of the two processes dies in
/// between.
template <class Q, class A>
class Client {
 public:
  /// `retry_ns`: how long to wait for the answer before asking again, on the component's clock.
  Client(const NodeContext& context, const Service<Q, A>& service, StampNs retry_ns = from_seconds(1.0))
      : clock_(context.clock), request_(context.bus.advertise(service.request)), retry_ns_(retry_ns) {
    client_ = context.component + "-" + std::to_string(context.clock.now_ns()) + "-" + run_id();
    context.bus.subscribe<A>(service.reply, [this](const A& reply) { take(reply); });
    context.executor.every(retry_ns, [this] { repeat(); });
  }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  bool busy() const { return pending_.has_value(); }

  /// Sends `request` and calls `done` with its answer. A question still open is forgotten.
  void call(Q request, std::function<void(const A&)> done) {
    request.call = {client_, ++number_};
    pending_ = Pending{request, std::move(done), clock_.now_ns()};
    request_.publish(std::move(request));
  }

  void cancel() { pending_.reset(); }

 private:
  struct Pending {
    Q request;
    std::function<void(const A&)> done;
    StampNs asked_ns;
  };

  static std::string run_id();

  void take(const A& reply) {
    if (!pending_ || !(reply.call == pending_->request.call)) return;
    const auto done = std::move(pending_->done);
    pending_.reset();
    done(reply);
  }

  void repeat() {
    if (!pending_ || clock_.now_ns() - pending_->asked_ns < retry_ns_) return;
    pending_->asked_ns = clock_.now_ns();
    request_.publish(pending_->request);
  }

  const Clock& clock_;
  Publisher<Q> request_;
  StampNs retry_ns_;
  std::string client_;
  std::uint64_t number_ = 0;
  std::optional<Pending> pending_;
};

/// Tells two runs of one component apart: the process id, or nothing in a composed run (see
/// set_process_run_id).
const std::string& process_run_id();
/// Composed runs set it to "" so that every run is the same byte for byte.
void set_process_run_id(std::string id);

template <class Q, class A>
std::string Client<Q, A>::run_id() {
  return process_run_id();
}

}  // namespace enfilade
