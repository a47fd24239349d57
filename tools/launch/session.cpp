// SPDX-License-Identifier: Apache-2.0
#include "tools/launch/session.hpp"

#include <atomic>
#include <csignal>
#include <exception>
#include <future>
#include <utility>

#include "interfaces/dds/shared_memory.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade::launch {
namespace {

std::atomic<bool> interrupted = false;

/// Heartbeats come twice a second from the thread that does the work.
constexpr std::chrono::seconds kHungAfter{8};
constexpr std::chrono::seconds kPausedAfter{2};  // between two looks, ten of which come in a second

void note_interrupt(int) { interrupted = true; }

}  // namespace

Session::Session(DeploymentConfig deployment, int domain, std::function<void(const std::string&)> say)
    : deployment_(std::move(deployment)),
      say_(std::move(say)),
      log_("enfilade", clock_, [this](const LogLine& line) { say_(line.text); }),
      bus_("enfilade", deployed_dds_config(domain), executor_, log_) {
  remove_stale_segments();
  bus_.subscribe<Heartbeat>(topics::kHeartbeat, [this](const Heartbeat& beat) {
    last_beat_[beat.component_name] = std::chrono::steady_clock::now();
  });
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
}

Session::~Session() { executor_.stop(); }

/// Who has not looked for a while was stopped itself, and perhaps the whole machine was: then nobody hangs
/// yet.
void Session::end_the_hung() {
  const auto now = std::chrono::steady_clock::now();
  const bool was_paused = now - std::exchange(last_look_, now) > kPausedAfter;
  if (was_paused)
    for (auto& [component, beat] : last_beat_) beat = now;
  for (auto& [component, beat] : last_beat_) {
    if (now - beat < kHungAfter) continue;
    beat = now;  // its successor gets as long
    if (deployment_.end(component)) say_(component + " hangs: ended");
  }
}

std::optional<SessionEnd> Session::look(const std::function<bool()>& done) {
  end_the_hung();
  for (const std::string& line : deployment_.watch()) say_(line);
  if (interrupted) return SessionEnd::kInterrupted;
  if (deployment_.failed()) return SessionEnd::kMemberLost;
  if (done()) return SessionEnd::kDone;
  return std::nullopt;
}

SessionEnd Session::run(const std::function<bool()>& done) {
  std::promise<SessionEnd> end;
  bool ended = false;
  executor_.every_wall(from_seconds(0.1), [&] {
    if (ended) return;
    try {
      const auto result = look(done);
      if (!result) return;
      end.set_value(*result);
    } catch (...) {
      end.set_exception(std::current_exception());
    }
    ended = true;
  });
  deployment_.start();
  executor_.start();
  std::future<SessionEnd> result = end.get_future();
  result.wait();
  executor_.stop();
  executor_.wait_stopped(std::chrono::seconds(5));
  for (const std::string& line : deployment_.stop()) say_(line);
  remove_stale_segments();
  return result.get();
}

}  // namespace enfilade::launch
