// SPDX-License-Identifier: Apache-2.0
#include "tools/launch/deployment.hpp"

#include <algorithm>
#include <csignal>
#include <thread>

#include <fmt/format.h>

namespace enfilade::launch {

Deployment::Deployment(DeploymentConfig config) : config_(std::move(config)) {
  for (const Member& member : config_.members) slots_.push_back({.member = member, .process = nullptr});
}

Deployment::~Deployment() { stop(); }

void Deployment::start() {
  for (Slot& slot : slots_) launch(slot);
}

void Deployment::launch(Slot& slot) {
  const std::string& name = slot.member.component;
  slot.process = std::make_unique<Process>(config_.bin_folder + "/" + name, slot.member.arguments,
                                           fmt::format("{}/{}.log", config_.log_folder, name));
}

std::vector<std::string> Deployment::watch() {
  std::vector<std::string> lines;
  for (Slot& slot : slots_) {
    if (!slot.process) continue;
    if (const auto ending = slot.process->poll()) lines.push_back(mourn(slot, *ending));
  }
  return lines;
}

bool Deployment::end(const std::string& component) {
  for (Slot& slot : slots_) {
    if (slot.member.component != component || !slot.process) continue;
    slot.process->signal(SIGKILL);
    return true;
  }
  return false;
}

std::string Deployment::mourn(Slot& slot, const Ending& ending) {
  const std::string what = fmt::format("{} {}", slot.member.component, ending.text());
  slot.process.reset();
  // A component that refuses its command line or configuration (exit status 2) would refuse it again.
  const bool hopeless = ending.signal == 0 && ending.exit_status == 2;
  if (slot.member.restart && !hopeless && slot.restarts < config_.max_restarts) {
    ++slot.restarts;
    launch(slot);
    return fmt::format("{}: started again ({} of at most {} times)", what, slot.restarts,
                       config_.max_restarts);
  }
  failed_ = true;
  return fmt::format("{}: see {}/{}.log", what, config_.log_folder, slot.member.component);
}

std::vector<std::string> Deployment::stop() {
  for (const int number : {SIGINT, SIGTERM, SIGKILL}) {
    if (all_ended()) break;
    signal_all(number);
    wait_for_end();
  }
  std::vector<std::string> lines;
  for (Slot& slot : slots_) {
    if (!slot.process) continue;
    const auto ending = slot.process->poll();
    if (ending && !ending->in_good_order())
      lines.push_back(fmt::format("{} {}", slot.member.component, ending->text()));
    slot.process.reset();
  }
  return lines;
}

bool Deployment::all_ended() {
  return std::all_of(slots_.begin(), slots_.end(),
                     [](Slot& slot) { return !slot.process || slot.process->poll(); });
}

void Deployment::signal_all(int number) {
  for (Slot& slot : slots_) {
    if (slot.process) slot.process->signal(number);
  }
}

void Deployment::wait_for_end() {
  const auto deadline = std::chrono::steady_clock::now() + config_.stop_patience;
  while (!all_ended() && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

}  // namespace enfilade::launch
