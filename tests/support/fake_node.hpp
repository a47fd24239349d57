// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "interfaces/runtime/component.hpp"

namespace enfilade {

/// A node whose behaviour is written in the test. Each call is optional.
struct FakeNode : Node {
  using Call = std::function<void(const NodeContext&)>;
  struct Calls {
    Call initialize, compute, emergency, restore, shutdown;
  };

  FakeNode(const NodeContext& c, Calls calls_in) : context(c), calls(std::move(calls_in)) {}

  void initialize() override { run(calls.initialize); }
  void compute() override { run(calls.compute); }
  void emergency() override { run(calls.emergency); }
  void restore() override { run(calls.restore); }
  void shutdown() override { run(calls.shutdown); }

  static MakeNode make(Calls calls) {
    return [calls = std::move(calls)](const NodeContext& context) {
      return std::make_unique<FakeNode>(context, calls);
    };
  }

  NodeContext context;
  Calls calls;

 private:
  void run(const Call& call) const {
    if (call) call(context);
  }
};

}  // namespace enfilade
