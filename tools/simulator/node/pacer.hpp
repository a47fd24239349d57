// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "interfaces/model/simulation.hpp"
#include "interfaces/runtime/clock.hpp"

namespace enfilade::simulator {

/// Says how far the world may go. Asked again and again, each time with the time the world has reached.
class Pacer {
 public:
  virtual ~Pacer() = default;
  virtual StampNs allowed_ns(StampNs world_ns) = 0;
  virtual void hear(const SimCredit&) {}
};

/// Composed runs: the world follows a clock that others advance.
class FollowingPacer : public Pacer {
 public:
  explicit FollowingPacer(const Clock& clock) : clock_(clock) {}
  StampNs allowed_ns(StampNs) override { return clock_.now_ns(); }

 private:
  const Clock& clock_;
};

struct CreditPacerConfig {
  double speed =
      1.0;  ///< simulated seconds per second of wall time at most; 0 = as fast as the readers allow
  double credit_window_s = 0.1;  ///< how far the world may run ahead of the slowest reader, > 0
  double credit_lifetime_s =
      1.0;  ///< wall time after which a silent reader is taken for dead and waited for no more
  double wait_for_readers_s =
      20.0;  ///< wall time that the world stands still at most until all of `readers` were heard
  std::vector<std::string> readers{"laser3D", "motorControl", "gridBuilder"};
};

/// Deployed runs: the world owns time. It starts when the readers are there, goes at `speed` of wall time,
/// and never runs more than the window ahead of the slowest reader alive, so that a slow machine slows the
/// world instead of losing scans.
class CreditPacer : public Pacer {
 public:
  CreditPacer(const CreditPacerConfig& config, const Clock& wall_clock);

  StampNs allowed_ns(StampNs world_ns) override;
  void hear(const SimCredit& credit) override;

  bool started() const { return started_; }

 private:
  struct Credit {
    StampNs done_ns = 0;
    StampNs heard_ns = 0;  ///< wall time
  };

  bool all_readers_heard() const;
  StampNs creep(StampNs world_ns, StampNs wall_ns);
  /// How far the readers alive allow.
  StampNs credited_ns(StampNs world_ns, StampNs wall_ns) const;

  CreditPacerConfig config_;
  const Clock& wall_clock_;
  std::map<std::string, Credit> credits_;
  StampNs asked_ns_ = -1;  ///< wall time of the last question
  StampNs first_asked_ns_ = 0;
  StampNs crept_ns_ = 0;   ///< wall time of the last step while waiting
  double paced_ns_ = 0.0;  ///< how far the speed limit allows
  bool started_ = false;
};

}  // namespace enfilade::simulator
