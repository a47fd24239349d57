// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/service.hpp"

#include <optional>

#include <gtest/gtest.h>

#include "interfaces/runtime/composed_system.hpp"
#include "interfaces/topics/topics.hpp"
#include "tests/support/fake_node.hpp"

namespace enfilade {
namespace {

using SnapshotClient = Client<GridSnapshotRequest, GridSnapshotReply>;

struct ServiceTest : testing::Test {
  void add_client() {
    system.add("explorer", {}, FakeNode::make({.initialize = [this](const NodeContext& context) {
                 client.emplace(context, topics::kGridSnapshot);
               }}));
    system.initialize();
  }
  void ask() {
    client->call({}, [this](const GridSnapshotReply& reply) { answers.push_back(reply); });
  }
  void add_server() {
    serve<GridSnapshotRequest, GridSnapshotReply>(system.bus_as("gridBuilder"), topics::kGridSnapshot,
                                                  [this](const GridSnapshotRequest&) {
                                                    ++asked;
                                                    return GridSnapshotReply{};
                                                  });
  }
  void run_to(double t_s) { system.run_until({}, from_seconds(t_s)); }

  std::optional<SnapshotClient> client;
  std::vector<GridSnapshotReply> answers;
  int asked = 0;
  ComposedSystem system;
};

TEST_F(ServiceTest, AnAnswerComesOnceToTheOneWhoAsked) {
  add_server();
  add_client();
  ask();
  EXPECT_TRUE(client->busy());
  run_to(5.0);
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].call.number, 1u);
  EXPECT_EQ(asked, 1);
  EXPECT_FALSE(client->busy());
}

TEST_F(ServiceTest, AQuestionIsRepeatedUntilTheServerAppears) {
  add_client();
  ask();
  run_to(3.5);
  EXPECT_TRUE(answers.empty());
  add_server();
  run_to(4.1);
  EXPECT_EQ(answers.size(), 1u);
  EXPECT_EQ(asked, 1);
}

TEST_F(ServiceTest, AnAnswerToAForgottenQuestionIsIgnored) {
  add_server();
  add_client();
  ask();
  client->cancel();
  run_to(2.0);
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(answers.empty());
}

TEST_F(ServiceTest, RunsOfComposedSystemsDoNotDifferInTheirIds) { EXPECT_EQ(process_run_id(), ""); }

}  // namespace
}  // namespace enfilade
