// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "interfaces/bus/bus.hpp"
#include "interfaces/dds/dds_config.hpp"
#include "interfaces/runtime/executor.hpp"
#include "interfaces/runtime/log.hpp"

namespace enfilade {

/// What readers of one bus have thrown away since its start.
struct DdsDrops {
  std::uint64_t undecodable = 0;  ///< no messages of their topic's type; one warning a topic
  std::uint64_t overflowed =
      0;  ///< pushed out by newer ones before the executor came to them; not of depth 1
};

/// The bus between processes. Messages are decoded on Fast DDS's threads and wait in a queue of the topic's
/// depth for the executor, which alone runs handlers. After the destructor no handler runs any more.
/// FASTRTPS_DEFAULT_PROFILES_FILE is honoured: transports and lease of its default participant take the place
/// of those in DdsConfig.
class DdsBus : public Bus {
 public:
  /// `component` is the participant's name and decides which topics may be opened. `executor` and `log`
  /// outlive the bus; `log` is used from the constructor and the executor only. Throws std::runtime_error
  /// where no participant can be made.
  DdsBus(const std::string& component, const DdsConfig& config, Executor& executor, Log& log);
  ~DdsBus() override;
  DdsBus(const DdsBus&) = delete;
  DdsBus& operator=(const DdsBus&) = delete;

  DdsDrops drops() const;
  std::uint64_t dropped() const override { return drops().overflowed; }
  bool uses_shared_memory() const;

 protected:
  std::unique_ptr<Writer> open_writer(const TopicInfo& topic, std::type_index type) override;
  void open_reader(const TopicInfo& topic, std::type_index type, AnyHandler handler) override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace enfilade
