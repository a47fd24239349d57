// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/optimise/spanning_tree.hpp"

#include <algorithm>
#include <limits>
#include <queue>

#include <Eigen/LU>

#include "components/topoGraph/core/optimise/door_residual.hpp"
#include "interfaces/geometry/square.hpp"

namespace enfilade::topo_graph {
namespace {

constexpr double kLeverM = 10.0;          // at which an error of direction weighs against one of position
constexpr double kGate = 16.3;            // 99.9 % of chi-squared with three degrees of freedom
constexpr std::size_t kMaxSettled = 400;  // rooms looked at around a loop door

struct Edge {
  std::size_t to = 0;
  Pose2 T_from_to;
  double variance_position = 0.0;
  double variance_yaw = 0.0;

  double cost() const { return variance_position + square(kLeverM) * variance_yaw; }
};

using Edges = std::vector<std::vector<Edge>>;

struct Reached {
  double cost = std::numeric_limits<double>::infinity();
  std::size_t from = 0;
  const Edge* edge = nullptr;  ///< the last one on the way
};

void add_both_ways(Edges& edges, std::size_t from, const Edge& edge) {
  Edge back = edge;
  back.to = from;
  back.T_from_to = edge.T_from_to.inverse();
  edges[from].push_back(edge);
  edges[edge.to].push_back(back);
}

Edge door_edge(const GraphProblem& problem, const DoorFactor& door) {
  const RoomNode &a = problem.rooms[door.a.room], &b = problem.rooms[door.b.room];
  const double position = square(door.sigma_position_m) +
                          std::max(square(door.sigma_thickness_m),
                                   square(door.a.sigma_offset_m) + square(door.b.sigma_offset_m)) +
                          0.25 * (square(std::max(a.sigma_width_m, a.sigma_height_m)) +
                                  square(std::max(b.sigma_width_m, b.sigma_height_m)));
  const double reach = square(0.5 * std::max(b.width_m, b.height_m));  // the door's turn moves b's centre
  const double yaw = square(door.sigma_direction_rad);
  return {door.b.room, pose_through(door, a, b), position + reach * yaw, yaw};
}

/// Dijkstra from `start`, until `goal` is settled or `max_settled` rooms are. Scratch memory is the caller's,
/// so that many short searches cost only what they touch.
class Search {
 public:
  explicit Search(std::size_t rooms) : reached_(rooms) {}

  bool run(const Edges& edges, std::size_t start, std::size_t goal, std::size_t max_settled) {
    for (const std::size_t room : touched_) reached_[room] = {};
    touched_.assign(1, start);
    reached_[start].cost = 0.0;
    Queue queue;
    queue.emplace(0.0, start);
    for (std::size_t settled = 0; !queue.empty() && settled < max_settled;) {
      const auto [cost, room] = queue.top();
      queue.pop();
      if (cost > reached_[room].cost) continue;
      if (room == goal) return true;
      ++settled;
      for (const Edge& edge : edges[room]) relax(queue, room, cost, edge);
    }
    return false;
  }

  const Reached& at(std::size_t room) const { return reached_[room]; }
  const std::vector<std::size_t>& touched() const { return touched_; }

 private:
  using Item = std::pair<double, std::size_t>;
  using Queue = std::priority_queue<Item, std::vector<Item>, std::greater<>>;

  void relax(Queue& queue, std::size_t room, double cost, const Edge& edge) {
    Reached& next = reached_[edge.to];
    if (cost + edge.cost() >= next.cost) return;
    if (!next.edge) touched_.push_back(edge.to);
    next = {cost + edge.cost(), room, &edge};
    queue.emplace(next.cost, edge.to);
  }

  std::vector<Reached> reached_;
  std::vector<std::size_t> touched_;
};

/// A relative pose with its covariance (x, y, yaw).
struct Uncertain {
  Pose2 pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

void append(Uncertain& chain, const Edge& edge) {
  const Point2 arm = rotate(chain.pose.yaw_rad, edge.T_from_to.translation());
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F(0, 2) = -arm.y();
  F(1, 2) = arm.x();
  chain.covariance = F * chain.covariance * F.transpose();
  chain.covariance.diagonal() +=
      Eigen::Vector3d(edge.variance_position, edge.variance_position, edge.variance_yaw);
  chain.pose = chain.pose * edge.T_from_to;
}

Uncertain chain_to(const Search& search, std::size_t start, std::size_t goal) {
  std::vector<const Edge*> way;
  for (std::size_t room = goal; room != start; room = search.at(room).from)
    way.push_back(search.at(room).edge);
  Uncertain chain;
  for (auto edge = way.rbegin(); edge != way.rend(); ++edge) append(chain, **edge);
  return chain;
}

bool agree(const Uncertain& chain, const Edge& loop) {
  Uncertain direct;
  append(direct, loop);
  const Eigen::Vector3d off(chain.pose.x_m - direct.pose.x_m, chain.pose.y_m - direct.pose.y_m,
                            wrap_to_pi(chain.pose.yaw_rad - direct.pose.yaw_rad));
  const Eigen::Matrix3d covariance = chain.covariance + direct.covariance;
  return off.dot(covariance.inverse() * off) <= kGate;
}

/// Short loops first: what they confirm shortens the way around the longer ones.
std::vector<const DoorFactor*> loops_by_length(const GraphProblem& problem) {
  std::vector<const DoorFactor*> loops;
  for (const DoorFactor& door : problem.doors)
    if (door.loop) loops.push_back(&door);
  const auto length = [](const DoorFactor* door) {
    return std::max(door->a.room, door->b.room) - std::min(door->a.room, door->b.room);
  };
  std::stable_sort(loops.begin(), loops.end(),
                   [&](const DoorFactor* a, const DoorFactor* b) { return length(a) < length(b); });
  return loops;
}

Edges trusted_edges(const GraphProblem& problem, Search& search) {
  Edges edges(problem.rooms.size());
  for (const OdometryFactor& odometry : problem.odometry)
    add_both_ways(
        edges, odometry.from,
        {odometry.to, odometry.T_from_to, square(odometry.sigma_position_m), square(odometry.sigma_yaw_rad)});
  for (const DoorFactor& door : problem.doors)
    if (!door.loop) add_both_ways(edges, door.a.room, door_edge(problem, door));
  for (const DoorFactor* door : loops_by_length(problem)) {
    const Edge edge = door_edge(problem, *door);
    const bool met = search.run(edges, door->a.room, door->b.room, kMaxSettled);
    if (met && agree(chain_to(search, door->a.room, door->b.room), edge))
      add_both_ways(edges, door->a.room, edge);
  }
  return edges;
}

}  // namespace

std::vector<Pose2> tree_poses(const GraphProblem& problem) {
  const std::size_t count = problem.rooms.size();
  std::vector<Pose2> poses;
  for (const RoomNode& room : problem.rooms) poses.push_back(room.T_map_room);
  if (count == 0) return poses;
  Search search(count);
  const Edges edges = trusted_edges(problem, search);
  search.run(edges, 0, count, count + 1);
  std::vector<std::size_t> order = search.touched();
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return search.at(a).cost < search.at(b).cost; });
  for (const std::size_t room : order) {
    const Reached& reached = search.at(room);
    if (reached.edge) poses[room] = poses[reached.from] * reached.edge->T_from_to;
  }
  return poses;
}

}  // namespace enfilade::topo_graph
