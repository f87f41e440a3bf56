// SPDX-License-Identifier: MIT
/// The Unified Behavior Framework where it came from: a robot with two wheels and eight range
/// sensors in a room. It needs `ubf` and `core` alone. Four behaviors are blended by their votes
/// into one heading and one speed; a controller turns those into wheel speeds.
/// usage: 07_robot [PATH.svg]     the file gets a drawing of the way it went
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "core/angle.hpp"
#include "core/draw.hpp"
#include "core/hash.hpp"
#include "core/math.hpp"
#include "ubf/agent.hpp"
#include "ubf/standard_nodes.hpp"

using namespace eyrie;

// ------------------------------------------------------------------ the world
struct Point {
  double x = 0, y = 0;  // m
};
struct Box {
  double left, bottom, right, top;  // m
};
constexpr double kWidth = 12, kHeight = 8, kRadius = 0.2, kWheelBase = 0.3;
constexpr double kDt = 0.05, kFastest = 0.6;  // s; m/s of a wheel
constexpr std::array kBoxes{Box{3, 2.6, 4.2, 5.4}, Box{7, 0, 7.8, 3.4}, Box{7, 5, 7.8, 8},
                            Box{9.6, 3.2, 10.4, 4.6}};
constexpr std::array kGoals{Point{5.6, 6.9}, Point{11, 1.2}, Point{8.8, 7}, Point{1.5, 1}};
constexpr Point kCharger{1, 7};
constexpr std::size_t kSensors = 8;
constexpr double kReach = 3;  // m

/// From a place along a unit vector to the next wall or box.
double free_way(const Point& from, double dx, double dy) {
  const auto to_wall = [](double at, double along, double end) {
    return along > 0 ? (end - at) / along : along < 0 ? -at / along : kReach;
  };
  double nearest = std::min({kReach, to_wall(from.x, dx, kWidth), to_wall(from.y, dy, kHeight)});
  for (const Box& box : kBoxes) {  // slabs: inside both intervals at once
    double enter = 0, leave = kReach;
    const auto slab = [&](double at, double along, double low, double high) {
      if (along == 0) {
        if (at < low || at > high)
          leave = -1;
        return;
      }
      const double a = (low - at) / along, b = (high - at) / along;
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    };
    slab(from.x, dx, box.left, box.right);
    slab(from.y, dy, box.bottom, box.top);
    if (enter <= leave)
      nearest = std::min(nearest, enter);
  }
  return nearest;
}

struct Robot {
  Point place{1, 1.5};
  double heading = 0;  // rad, from the x axis to the y axis
  double battery = 1;
  std::size_t goal = 0;
};

// ------------------------------------------------------------------ what it perceives and wants
struct State {
  std::array<double, kSensors> ranges;  // m, counter-clockwise from straight ahead, with noise
  double heading = 0;                   // rad
  double battery = 1;
  double goal_bearing = 0, charger_bearing = 0;    // rad
  double goal_distance = 0, charger_distance = 0;  // m
};
struct Action {
  std::optional<double> heading;  // rad
  std::optional<double> speed;    // m/s
};
template <>
struct eyrie::ubf::ActionTraits<Action> {
  static constexpr auto fields = std::tuple{field<blend::Angle>("heading", &Action::heading, "rad"),
                                            field<blend::Mean>("speed", &Action::speed, "m/s")};
};
using namespace eyrie::ubf;
using RobotTick = Tick<State>;
using Node = Behavior<State, Action>;

double bearing_to(const Point& from, const Point& to) {
  return math::atan2(to.y - from.y, to.x - from.x);
}
double distance(const Point& a, const Point& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

State perceive(const Robot& robot, std::uint64_t step) {
  State s{.ranges = {},
          .heading = robot.heading,
          .battery = robot.battery,
          .goal_bearing = bearing_to(robot.place, kGoals[robot.goal]),
          .charger_bearing = bearing_to(robot.place, kCharger),
          .goal_distance = distance(robot.place, kGoals[robot.goal]),
          .charger_distance = distance(robot.place, kCharger)};
  Draw noise(1, PlayerId{1}, Stream::test, step);
  for (std::size_t i = 0; i < kSensors; ++i) {
    const auto [sine, cosine] = math::sin_cos(robot.heading + kTau * double(i) / kSensors);
    const double range = free_way(robot.place, cosine, sine);
    s.ranges[i] = range * (1 + 0.03 * noise.normal());
  }
  return s;
}

// ------------------------------------------------------------------ behaviors
/// Pushed by everything near, the harder the nearer; the vote is the strength of the push.
struct Avoid : Node {
  static constexpr std::string_view type_name = "avoid", help = "keeps away from what is near";
  Status tick(const RobotTick& t, Proposal<Action>& out) const override {
    double x = 0, y = 0;
    for (std::size_t i = 0; i < kSensors; ++i) {
      const double gap = std::max(t.state.ranges[i] - kRadius, 0.05);
      if (gap > 0.8)
        continue;
      const auto [sine, cosine] = math::sin_cos(t.state.heading + kTau * double(i) / kSensors);
      x -= cosine * (1 / gap - 1 / 0.8);
      y -= sine * (1 / gap - 1 / 0.8);
    }
    const double push = std::sqrt(x * x + y * y);
    if (push == 0)
      return Status::failure;
    out.action.heading = math::atan2(y, x);
    out.action.speed = 0.3;
    out.vote = static_cast<float>(25 * push);
    return Status::running;
  }
};
/// A new heading every four seconds: gets it out of corners in which the others balance.
struct Wander : Node {
  static constexpr std::string_view type_name = "wander", help = "drives about";
  Status tick(const RobotTick& t, Proposal<Action>& out) const override {
    Draw draw(t.seed, t.player, Stream::behavior, t.step / 80);
    out.action.heading = draw.uniform(-kPi, kPi);
    out.action.speed = 0.4;
    out.vote = 12;
    return Status::running;
  }
};
struct GoToGoal : Node {
  static constexpr std::string_view type_name = "go_to_goal", help = "drives to the next goal";
  Status tick(const RobotTick& t, Proposal<Action>& out) const override {
    out.action.heading = t.state.goal_bearing;
    out.action.speed = std::min(kFastest, 0.5 * t.state.goal_distance + 0.1);
    out.vote = 30;
    return Status::running;
  }
};
struct Charging {
  std::uint64_t on = 0;  // 1: until it is full
};
/// Says nothing before the battery is down to what the way to the charger needs; then it is louder
/// than the goal, and on the charger it asks for rest until the battery is full. That it is at it,
/// it remembers in the agent's slab.
struct Recharge : WithMemory<Node, Charging> {
  static constexpr std::string_view type_name = "recharge", help = "sees to the battery";
  Status tick(const RobotTick& t, Proposal<Action>& out) const override {
    Charging& m = memory(t);
    const double way_home = 0.15 + 0.025 * t.state.charger_distance;
    m.on = t.state.battery < way_home || (m.on && t.state.battery < 0.99);
    if (!m.on)
      return Status::failure;
    const bool there = t.state.charger_distance < 0.3;
    out.action.heading = t.state.charger_bearing;
    out.action.speed = there ? 0 : 0.5;
    out.vote = there ? 5000 : 60;
    return Status::running;
  }
};

// ------------------------------------------------------------------ controller and wheels
void drive(Robot& robot, const Action& wanted) {
  const double error = wrap_pi(wanted.heading.value_or(robot.heading) - robot.heading);
  const double turn = std::clamp(2 * error, -2.0, 2.0);  // rad/s
  const double ahead = wanted.speed.value_or(0) * std::max(math::cos(error), 0.0);
  const double most = kFastest - std::fabs(turn) * kWheelBase / 2;
  const double speed = std::clamp(ahead, 0.0, most);
  const double left = speed - turn * kWheelBase / 2, right = speed + turn * kWheelBase / 2;
  const auto [sine, cosine] = math::sin_cos(robot.heading);
  const double v = (left + right) / 2;
  robot.place.x += v * cosine * kDt;
  robot.place.y += v * sine * kDt;
  robot.heading = wrap_pi(robot.heading + (right - left) / kWheelBase * kDt);
  robot.battery -= (0.002 + 0.01 * (std::fabs(left) + std::fabs(right))) * kDt;
  if (distance(robot.place, kCharger) < 0.3)
    robot.battery = std::min(1.0, robot.battery + 0.1 * kDt);
}

double clearance(const Point& p) {
  double nearest = std::min({p.x, kWidth - p.x, p.y, kHeight - p.y});
  for (const Box& box : kBoxes) {
    const Point on{std::clamp(p.x, box.left, box.right), std::clamp(p.y, box.bottom, box.top)};
    nearest = std::min(nearest, distance(p, on));
  }
  return nearest - kRadius;
}

void draw_svg(const std::string& file, const std::vector<Point>& way) {
  constexpr double kScale = 80;
  const auto y = [&](double m) { return kScale * (kHeight - m); };
  std::ofstream out(file);
  out << fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' width='{0}' height='{1}'>\n"
      "<rect width='100%' height='100%' fill='#fafafa' stroke='#333' stroke-width='6'/>\n",
      kScale * kWidth, kScale * kHeight);
  for (const Box& b : kBoxes)
    out << fmt::format("<rect x='{:.0f}' y='{:.0f}' width='{:.0f}' height='{:.0f}' fill='#999'/>\n",
                       kScale * b.left, y(b.top), kScale * (b.right - b.left),
                       kScale * (b.top - b.bottom));
  out << "<polyline fill='none' stroke='#0072b2' stroke-width='2' points='";
  for (const Point& p : way)
    out << fmt::format("{:.1f},{:.1f} ", kScale * p.x, y(p.y));
  out << "'/>\n";
  const auto mark = [&](const Point& p, const std::string& name, const char* color) {
    out << fmt::format(
        "<circle cx='{0:.0f}' cy='{1:.0f}' r='14' fill='{2}'/><text x='{0:.0f}' y='{3:.0f}' "
        "fill='#fff' font-family='sans-serif' font-size='16' text-anchor='middle'>{4}</text>\n",
        kScale * p.x, y(p.y), color, y(p.y) + 6, name);
  };
  mark(kCharger, "C", "#009e73");
  for (std::size_t i = 0; i < kGoals.size(); ++i)
    mark(kGoals[i], std::to_string(i + 1), "#d55e00");
  out << "</svg>\n";
}

int main(int count, char** arguments) {
  Trees<State, Action> trees;
  trees.add({"robot", make<Fusion<State, Action>>(make<Avoid>(), make<GoToGoal>(), make<Recharge>(),
                                                  make<Wander>())});
  Brain<64> brain;
  Robot robot;
  std::vector<Point> way{robot.place};
  double length = 0, narrowest = clearance(robot.place);
  bool charging = false;
  Action wanted;
  std::uint64_t step = 0;
  for (; step < 40000 && robot.goal < kGoals.size(); ++step) {
    const double time = kDt * static_cast<double>(step);
    if (step % 2 == 0) {  // it decides ten times a second
      const State state = perceive(robot, step);
      Proposal<Action> decided;
      tick_agent(trees, brain,
                 {.state = state,
                  .time = time,
                  .dt = 2 * kDt,
                  .step = step,
                  .seed = 1,
                  .player = PlayerId{1}},
                 decided);
      wanted = decided.action;
    }
    const Point before = robot.place;
    drive(robot, wanted);
    length += distance(before, robot.place);
    narrowest = std::min(narrowest, clearance(robot.place));
    if (step % 10 == 0)
      way.push_back(robot.place);
    const bool at_charger = distance(robot.place, kCharger) < 0.3 && robot.battery < 0.99;
    if (at_charger != charging) {
      fmt::print("{:6.1f} s  {} at {:.0f} %\n", time, at_charger ? "charges" : "drives on",
                 100 * robot.battery);
      charging = at_charger;
    }
    if (distance(robot.place, kGoals[robot.goal]) < 0.3)
      fmt::print("{:6.1f} s  reaches goal {}, battery {:.0f} %\n", time, ++robot.goal,
                 100 * robot.battery);
  }
  Hasher hash;
  hash.bytes(&robot.place, sizeof robot.place);
  fmt::print("{:.1f} m driven, never nearer than {:.2f} m, hash {:016x}\n", length, narrowest,
             hash.value());
  if (count > 1)
    draw_svg(arguments[1], way);
  return robot.goal == kGoals.size() && narrowest > 0 && robot.battery > 0 ? 0 : 1;
}
