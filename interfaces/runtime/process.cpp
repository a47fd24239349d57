// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/process.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <clocale>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <thread>

#include <malloc.h>
#include <unistd.h>

#include "interfaces/model/counted.hpp"
#include "interfaces/runtime/command_line.hpp"
#include "interfaces/runtime/component.hpp"
#include "interfaces/runtime/component_log.hpp"
#include "interfaces/runtime/console_log.hpp"
#include "interfaces/runtime/deployed_clock.hpp"
#include "interfaces/runtime/host_lock.hpp"
#include "interfaces/runtime/simulated_time.hpp"
#include "interfaces/runtime/stop_signals.hpp"
#include "interfaces/runtime/thread_executor.hpp"

namespace enfilade {
namespace {

using std::chrono::milliseconds;

/// Exit status of a component that would refuse its command line, configuration or input again.
constexpr int kRefused = 2;
constexpr milliseconds kShutdownLimit{1500};  // for the work at hand and Node::shutdown()
constexpr milliseconds kExitLimit{300};       // for leaving the bus; both together stay below 2 s

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// Ends the process when its own good order takes too long.
class Watchdog {
 public:
  Watchdog(milliseconds limit, int exit_status)
      : thread_([this, limit, exit_status] {
          std::unique_lock lock(mutex_);
          if (!wake_.wait_for(lock, limit, [this] { return called_off_; })) std::_Exit(exit_status);
        }) {}
  ~Watchdog() {
    {
      const std::lock_guard lock(mutex_);
      called_off_ = true;
    }
    wake_.notify_all();
    thread_.join();
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  bool called_off_ = false;
  std::thread thread_;
};

/// One component with its thread, clock, log and bus, from start to end.
class Process {
 public:
  Process(const ComponentRecipe& recipe, const CommandLine& line, int domain, const MakeBus& make_bus)
      : sim_time_(line.sim_time),
        log_(recipe.name, clock(), console_sink(recipe.name, line.log_level)),
        executor_(sim_time_ ? &simulated_clock_ : nullptr),
        bus_(make_bus(recipe.name, domain, executor_, log_)),
        component_({.name = recipe.name,
                    .period = recipe.period(),
                    .host = host_name(),
                    .pid = static_cast<std::uint32_t>(getpid()),
                    .wall_now_ns = [this] { return system_clock_.now_ns(); }},
                   *bus_, clock(), executor_, log_, recipe.make_node) {
    log_.attach(*bus_);
  }

  ~Process() { log_.detach(); }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  Log& log() { return log_; }

  /// Returns the exit status after a signal, or after a start that failed.
  int run() {
    component_.announce();
    executor_.every_wall(from_seconds(1.0), [this] { report_dropped(); });
    if (sim_time_) {
      simulated_time_.emplace(SimulatedTimeConfig{.component = component_.name()}, *bus_, simulated_clock_,
                              executor_, [this] { start(); });
      log_.info("waiting for the time of the simulator");
    } else {
      executor_.post([this] { start(); });
    }
    executor_.start();
    while (exit_status_ == 0 && !wait_for_stop_signal(milliseconds(50))) {
    }
    return stop();
  }

 private:
  const Clock& clock() const {
    if (sim_time_) return simulated_clock_;
    return system_clock_;
  }

  void start() {
    try {
      component_.start();
      log_.info("running");
    } catch (const std::exception& e) {
      fail(kRefused, e.what());
    }
  }

  void fail(int exit_status, const std::string& what) {
    log_.error(what);
    exit_status_ = exit_status;
  }

  int stop() {
    executor_.stop([this] { component_.stop(); });
    if (executor_.wait_stopped(kShutdownLimit)) return exit_status_;
    log_.error("does not stop: a call of the component has not returned, ending the process");
    std::_Exit(1);
  }

  void report_dropped() {
    const std::uint64_t dropped = executor_.dropped() + bus_->dropped();
    if (dropped == reported_dropped_) return;
    log_.warn("too slow: " + counted(dropped - reported_dropped_, "message") + " dropped");
    reported_dropped_ = dropped;
  }

  bool sim_time_;
  SystemClock system_clock_;
  SimulatedClock simulated_clock_;
  ComponentLog log_;
  ThreadExecutor executor_;
  std::unique_ptr<Bus> bus_;
  Component component_;
  std::optional<SimulatedTime> simulated_time_;
  std::atomic<int> exit_status_ = 0;
  std::uint64_t reported_dropped_ = 0;
};

int run(const ComponentRecipe& recipe, const CommandLine& line, const MakeBus& make_bus) {
  const int domain = resolve_domain(line.domain, process_environment);
  const std::string file = line.config_file.empty()
                               ? find_config_file(recipe.name, executable_path(), process_environment)
                               : line.config_file;
  const std::string resolved = recipe.load(file, line.overrides);
  const HostLock lock(runtime_folder(), recipe.name, domain);
  std::optional<Watchdog> watchdog;  // outlives the process object, whose end it guards
  Process process(recipe, line, domain, make_bus);
  process.log().info("configuration " + file + ", domain " + std::to_string(domain) + ", pid " +
                     std::to_string(getpid()));
  process.log().debug("resolved configuration:\n" + resolved);
  const int exit_status = process.run();
  watchdog.emplace(kExitLimit, exit_status);
  return exit_status;
}

/// Every line of `what` as a sentence of its own.
void complain(const std::string& component, const std::string& what) {
  std::string text = component + ": ";
  for (const char c : what) text += c == '\n' ? "\n" + component + ": " : std::string(1, c);
  std::fprintf(stderr, "%s\n", text.c_str());
}

/// Left alone, the allocator keeps ever larger blocks to itself once one was freed, up to 32 MB: what a
/// growing table or a large message leaves behind would stay resident.
void give_back_large_blocks() {
#ifdef __GLIBC__
  constexpr int kLarge_bytes = 1 << 18;
  mallopt(M_MMAP_THRESHOLD, kLarge_bytes);
#endif
}

}  // namespace

int run_process(const ComponentRecipe& recipe, int argc, const char* const* argv, const MakeBus& make_bus) {
  std::setlocale(LC_NUMERIC, "C");
  give_back_large_blocks();
  block_stop_signals();
  const auto [line, exit_status] = parse_command_line(recipe.name, argc, argv);
  if (!line) return exit_status;
  try {
    return run(recipe, *line, make_bus);
  } catch (const ConfigError& e) {
    complain(recipe.name, e.what());
    return kRefused;
  } catch (const std::exception& e) {
    complain(recipe.name, e.what());
    return 1;
  }
}

}  // namespace enfilade
