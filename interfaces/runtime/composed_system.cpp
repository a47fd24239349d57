// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/composed_system.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "interfaces/runtime/service.hpp"

namespace enfilade {

struct ComposedSystem::Participant {
  Participant(ComposedSystem& system, std::string participant, int index)
      : name(std::move(participant)),
        executor(system.scheduler_, index),
        bus(system.network_, name, index,
            [this](int writer, std::function<void()> work) { executor.post_from(writer, std::move(work)); }),
        log(name, system.clock_, system.config_.log) {}

  std::string name;
  VirtualExecutor executor;
  InProcessBus bus;
  ComponentLog log;
  std::unique_ptr<Component> component;  // none for a bare bus
};

ComposedSystem::ComposedSystem(ComposedConfig config)
    : config_(std::move(config)), network_(config_.through_wire) {
  set_process_run_id("");
}

ComposedSystem::~ComposedSystem() {
  for (const auto& [index, participant] : participants_) {
    if (participant->component) participant->component->stop();
  }
}

void ComposedSystem::add(const std::string& name, const PeriodConfig& period, MakeNode make_node) {
  const auto same_name = [&name](const auto& entry) { return entry.second->name == name; };
  if (std::ranges::any_of(participants_, same_name))
    throw std::logic_error(name + " is in the composed system already");
  auto participant = make_participant(name);
  participant->log.attach(participant->bus);
  participant->component =
      std::make_unique<Component>(ComponentConfig{.name = name, .period = period}, participant->bus, clock_,
                                  participant->executor, participant->log, std::move(make_node));
  Component& component = *participant->component;
  participants_[next_index_ - 1] = std::move(participant);
  if (initialized_) component.start();
}

void ComposedSystem::kill(const std::string& name) {
  find(name);
  std::erase_if(participants_, [&name](const auto& entry) { return entry.second->name == name; });
}

Bus& ComposedSystem::bus_as(const std::string& name) {
  for (const auto& [index, participant] : participants_) {
    if (participant->name == name) return participant->bus;
  }
  auto participant = make_participant(name);
  return (participants_[next_index_ - 1] = std::move(participant))->bus;
}

void ComposedSystem::initialize() {
  if (std::exchange(initialized_, true)) return;
  for (const auto& [index, participant] : participants_) {
    if (participant->component) participant->component->start();
  }
}

bool ComposedSystem::run_until(const std::function<bool()>& stop, StampNs deadline_ns) {
  initialize();
  return scheduler_.run_until(stop, deadline_ns);
}

const Component& ComposedSystem::component(const std::string& name) const { return *find(name).component; }

const ComposedSystem::Participant& ComposedSystem::find(const std::string& name) const {
  for (const auto& [index, participant] : participants_) {
    if (participant->name == name && participant->component) return *participant;
  }
  throw std::out_of_range("no component " + name + " in the composed system");
}

std::unique_ptr<ComposedSystem::Participant> ComposedSystem::make_participant(const std::string& name) {
  return std::make_unique<Participant>(*this, name, next_index_++);
}

}  // namespace enfilade
