// SPDX-License-Identifier: Apache-2.0
#include "tools/enfilade/launch/session.hpp"

#include <atomic>
#include <csignal>
#include <future>

namespace enfilade::launch {
namespace {

std::atomic<bool> interrupted = false;

void note_interrupt(int) { interrupted = true; }

}  // namespace

Session::Session(DeploymentConfig deployment, int domain, std::function<void(const std::string&)> say)
    : deployment_(std::move(deployment)),
      say_(std::move(say)),
      log_("enfilade", clock_, [this](const LogLine& line) { say_(line.text); }),
      bus_("enfilade", DdsConfig{.domain = domain}, executor_, log_) {
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
}

Session::~Session() { executor_.stop(); }

std::optional<SessionEnd> Session::look(const std::function<bool()>& done) {
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
    const auto result = look(done);
    if (!result) return;
    ended = true;
    end.set_value(*result);
  });
  deployment_.start();
  executor_.start();
  const SessionEnd result = end.get_future().get();
  executor_.stop();
  executor_.wait_stopped(std::chrono::seconds(5));
  for (const std::string& line : deployment_.stop()) say_(line);
  return result;
}

}  // namespace enfilade::launch
