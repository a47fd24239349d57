// SPDX-License-Identifier: Apache-2.0
#include "interfaces/dds/inbox.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace enfilade {
namespace {

/// Keeps work until the test asks for it.
class IdleExecutor : public Executor {
 public:
  void post(std::function<void()> work) override { queue_.push_back(std::move(work)); }
  void every(StampNs, std::function<void()>) override {}
  void every_wall(StampNs, std::function<void()>) override {}

  std::size_t waiting() const { return queue_.size(); }
  void run_all() {
    for (; !queue_.empty(); queue_.pop_front()) queue_.front()();
  }

 private:
  std::deque<std::function<void()>> queue_;
};

class InboxTest : public testing::Test {
 protected:
  void push(int value) { inbox_->push(std::make_shared<const int>(value)); }

  IdleExecutor executor_;
  std::shared_ptr<Gate> gate_ = std::make_shared<Gate>();
  std::vector<int> handled_;
  std::shared_ptr<Inbox> inbox_ = std::make_shared<Inbox>(
      executor_, gate_, 3,
      [this](const AnyMessage& message) { handled_.push_back(*static_cast<const int*>(message.get())); });
};

TEST_F(InboxTest, HandsMessagesOverInOrderWhenTheExecutorComesToThem) {
  push(1);
  push(2);
  EXPECT_TRUE(handled_.empty());
  executor_.run_all();
  EXPECT_EQ(handled_, (std::vector{1, 2}));
}

TEST_F(InboxTest, DropsTheOldestOfTooManyCountsThemAndNeverFloodsTheExecutor) {
  for (int i = 1; i <= 10; ++i) push(i);
  EXPECT_EQ(inbox_->overflowed(), 7U);
  EXPECT_EQ(executor_.waiting(), 3U);
  executor_.run_all();
  EXPECT_EQ(handled_, (std::vector{8, 9, 10}));
}

TEST_F(InboxTest, HandsNothingOverOnceItsGateIsClosed) {
  push(1);
  gate_->close();
  executor_.run_all();
  EXPECT_TRUE(handled_.empty());
}

}  // namespace
}  // namespace enfilade
