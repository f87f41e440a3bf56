// SPDX-License-Identifier: MIT
#include "live/exercise.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/assert.hpp"
#include "core/text.hpp"
#include "model/tasking.hpp"

namespace eyrie::live {
namespace {

using Json = nlohmann::json;
using Message = nlohmann::ordered_json;
using net::Clock;
using What = Request::What;
using std::chrono::milliseconds;

constexpr milliseconds kOften(50), kSeldom(1000);  ///< between two messages: at least, at most
constexpr milliseconds kIdle(20);
constexpr std::size_t kMail = 4096;
/// Of which a run, or one message, may have no more: far above what people give.
constexpr std::size_t kMostOrders = 1'000'000, kMostAtOnce = 5'000;

std::string base64_of(const sim::Order& order) {
  return base64({reinterpret_cast<const char*>(&order), sizeof order});
}

constexpr const char* kSteps = "steps: a whole number from 1 to 5000";
constexpr const char* kRate = "rate: a number from 0.1 to 100, or \"max\"";

/// What is wrong with the members of a request; "" if nothing is.
std::string read(const Json& json, Request& request) {
  std::size_t members = 1;
  if (request.what == Request::What::step && json.contains("steps")) {
    const Json& steps = json["steps"];
    if (!steps.is_number_unsigned() || steps < 1u || steps > kMostSteps)
      return kSteps;
    request.steps = steps;
    ++members;
  }
  if (request.what == Request::What::rate) {
    const Json rate = json.value("rate", Json());
    const bool fits = rate.is_number() && rate >= kSlowest && rate <= kFastest;
    if (!fits && rate != "max")
      return kRate;
    request.rate = fits ? rate.get<double>() : 0;
    ++members;
  }
  return request.what == Request::What::order || json.size() == members ? ""
                                                                        : "more than is asked for";
}

}  // namespace

Said request_of(const scenario::Scenario& scenario, net::ViewerId who, std::string_view text) {
  static const std::map<std::string, Request::What, std::less<>> kWords{
      {"play", Request::What::play},
      {"pause", Request::What::pause},
      {"step", Request::What::step},
      {"rate", Request::What::rate},
      {"order", Request::What::order}};
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object())
    return {.request = {}, .garbage = "no JSON object"};
  const auto word = json.find("do");
  const auto known = word != json.end() && word->is_string() ? kWords.find(word->get<std::string>())
                                                             : kWords.end();
  if (known == kWords.end())
    return {.request = {}, .garbage = "do: play, pause, step, rate or order"};
  Said said{.request = {.who = who, .what = known->second}, .garbage = {}};
  said.garbage = read(json, said.request);
  if (said.garbage.empty() && said.request.what == Request::What::order)
    said.request.order = scenario::orders_from_json(scenario, text, 0);
  return said;
}

Exercise::Exercise(scenario::Mission& mission, record::RunFile run, net::WebOptions web,
                   const ExerciseOptions& options)
    : mission_(mission),
      run_(std::move(run)),
      pacing_(mission.run().simulation().dt(), Clock::now()),
      rate_(options.rate),
      outside_(options.outside),
      ended_(options.ended),
      paused_(options.paused),
      mail_(kMail),
      host_(with_channel(std::move(web))) {
  mission_.run().attach(trail_);
}

// By the network's thread.

net::WebOptions Exercise::with_channel(net::WebOptions web) {
  web.channel = {
      .joined = [this](net::ViewerId who) { mail_.put({.who = who, .what = What::joined}, true); },
      .said = [this](net::ViewerId who, std::string_view text) { return hear(who, text); },
      .left = [this](net::ViewerId who) { mail_.put({.who = who, .what = What::left}, true); }};
  return web;
}

std::string Exercise::hear(net::ViewerId who, std::string_view text) {
  Said said = request_of(mission_.scenario(), who, text);
  if (said.garbage.empty() && !mail_.put(std::move(said.request)))
    return "more is asked for than can be done";
  return said.garbage;
}

// By the thread that steps.

void Exercise::keep_time() {
  const double dt = mission_.run().simulation().dt();
  pacing_.go_on(rate_ > 0 ? dt / rate_ : dt, Clock::now());
}

void Exercise::fly(const Enough& enough) {
  keep_time();
  for (;;) {
    attend();
    if (enough())
      mission_.stop();
    const bool runs = !paused_ && single_ == 0, paced = runs && rate_ > 0;
    precedence_.ask(paced && pacing_.is_kept(Clock::now()));
    if (mission_.outcome() == scenario::Outcome::running) {
      tell_when_due();
      if (!runs && single_ == 0) {
        static_cast<void>(listen());
        wait(Clock::now() + kIdle, enough);
        continue;
      }
      if (paced && Clock::now() < pacing_.due()) {
        wait(pacing_.due(), enough);
        if (mail_.waiting() || enough())
          continue;
      }
    }
    const Clock::time_point begun = Clock::now();
    if (!listen()) {
      wait(begun + kIdle, enough);
      continue;
    }
    if (!mission_.step())
      break;
    if (paced)
      pacing_.made(begun, Clock::now());
    if (single_ && --single_ == 0)
      changed_ = true;
  }
  precedence_.ask(false);
  over_ = changed_ = true;
  if (ended_)
    ended_();
  tell(Clock::now());
}

void Exercise::stay(const Enough& enough) {
  while (!enough()) {
    attend();
    tell_when_due();
    wait(Clock::now() + kIdle, enough);
  }
}

void Exercise::wait(Clock::time_point until, const Enough& enough) {
  precedence_.sleep_until(until, [&] { return mail_.waiting() || enough(); });
}

void Exercise::attend() {
  if (mail_.waiting())
    for (Request& request : mail_.take())
      carry_out(request);
}

void Exercise::carry_out(Request& request) {
  switch (request.what) {
    case What::joined:
      ++viewers_;
      joining_.push_back(request.who);
      changed_ = true;
      break;
    case What::left:
      --viewers_;
      std::erase(joining_, request.who);
      hand_back(request.who);
      changed_ = true;
      break;
    case What::order:
      order(request);
      break;
    default:
      steer(request);
  }
}

void Exercise::steer(const Request& request) {
  if (over_)
    return refuse(request.who, "the mission is over");
  if (outside_ && request.what != What::play)
    return refuse(request.who, "other programs take part, by the clock: they do not wait");
  if (request.what == What::step) {
    single_ = std::min(single_ + request.steps, kMostSteps);
    paused_ = true;
  } else {
    if (request.what == What::rate)
      rate_ = request.rate;
    else
      paused_ = request.what == What::pause;
    single_ = 0;
    keep_time();
  }
  changed_ = true;
}

/// False as long as another program holds the mission.
bool Exercise::listen() {
  if (!outside_ || mission_.outcome() != scenario::Outcome::running)
    return true;
  const Heard heard = outside_();
  EYRIE_DEMAND(give(heard.orders).empty(), "an order for the next step");
  if (frozen_ != heard.frozen) {
    frozen_ = heard.frozen;
    changed_ = true;
    keep_time();
  }
  return !frozen_ || mission_.outcome() != scenario::Outcome::running;
}

/// Leaves those out who cannot do it.
std::string Exercise::problem(Request& request) const {
  auto& [kind, orders, words] = request.order;
  if (over_)
    return "the mission is over";
  if (!words.empty())
    return words;
  const sim::World& world = mission_.run().world();
  scenario::leave_out_unable(request.order, mission_.scenario(), world,
                             mission_.run().orders_for(world.step()));
  if (!words.empty())
    return words;
  if (waiting_ + orders.size() > kMostAtOnce || given_ + orders.size() > kMostOrders)
    return "there are too many orders";
  for (const sim::Order& one : orders) {
    const auto held = held_.find(one.player);
    const bool by_another = held != held_.end() && held->second != request.who;
    if (by_another && (kind == "manual" || kind == "hand_back"))
      return mission_.scenario().roster.name(one.player) + " is flown by somebody else";
  }
  return {};
}

void Exercise::order(Request& request) {
  std::string words = problem(request);
  if (words.empty())
    words = give(request.order.orders);
  if (!words.empty())
    return refuse(request.who, words);
  given_ += request.order.orders.size();
  waiting_ += request.order.orders.size();
  for (const sim::Order& one : request.order.orders) {
    if (request.order.kind == "manual")
      held_[one.player] = request.who;
    else if (request.order.kind == "hand_back")
      held_.erase(one.player);
  }
}

std::string Exercise::give(std::span<const sim::Order> orders) {
  for (sim::Order one : orders) {
    one.step = mission_.run().world().step();
    if (std::string words = mission_.run().submit(one); !words.empty())
      return words;
    fresh_.push_back(one);
  }
  return {};
}

void Exercise::hand_back(net::ViewerId who) {
  for (auto one = held_.begin(); one != held_.end();) {
    if (one->second != who) {
      ++one;
      continue;
    }
    const Message asked{{"order", "hand_back"},
                        {"player", mission_.scenario().roster.name(one->first)}};
    if (!over_)
      static_cast<void>(
          give(scenario::orders_from_json(mission_.scenario(), asked.dump(), 0).orders));
    one = held_.erase(one);
  }
}

void Exercise::refuse(net::ViewerId who, const std::string& words) {
  host_.send(who,
             Message{{"refused", words}}.dump(-1, ' ', false, Message::error_handler_t::replace));
}

// What viewers are told.

void Exercise::tell_when_due() {
  const Clock::time_point now = Clock::now();
  const bool news = changed_ || mission_.run().world().step() != told_step_;
  if (now - told_ >= (news ? kOften : kSeldom))
    tell(now);
}

/// Orders for the next step.
std::size_t Exercise::not_flown() const {
  const auto flown = std::ranges::find_if(
      fresh_, [&](const sim::Order& one) { return one.step >= mission_.run().world().step(); });
  return static_cast<std::size_t>(fresh_.end() - flown);
}

void Exercise::tell(Clock::time_point now) {
  const sim::World& world = mission_.run().world();
  Message news{{"step", world.step()},
               {"rate", rate_ > 0 ? Message(rate_) : Message("max")},
               {"paused", paused_ || frozen_},
               {"viewers", viewers_},
               {"outcome", enum_name(mission_.outcome())}};
  if (outside_)
    news["shared"] = true;
  const auto flown = fresh_.end() - static_cast<std::ptrdiff_t>(not_flown());
  for (auto one = fresh_.begin(); one != flown; ++one)
    news["orders"].push_back(base64_of(*one));
  fresh_.erase(fresh_.begin(), flown);
  waiting_ = std::min(waiting_, fresh_.size());
  if (paused_ || frozen_ || over_ || now - hashed_ >= kSeldom) {
    news["hash"] = hash_text(world.hash());
    hashed_ = now;
  }
  host_.send(news.dump());
  if (!paused_ && !over_ && rate_ > 0 && pacing_.frames() > 0 && now - paced_ >= kSeldom) {
    tell_pacing();
    paced_ = now;
  }
  told_ = now;
  told_step_ = world.step();
  changed_ = !joining_.empty();  // who was greeted learns the rest by the next message
  greet();
}

void Exercise::tell_pacing() {
  const net::Histogram& late = pacing_.late();
  host_.send(Message{{"pacing",
                      {{"frames", pacing_.frames()},
                       {"missed", pacing_.missed()},
                       {"p50", late.percentile(0.5)},
                       {"p99", late.percentile(0.99)},
                       {"p999", late.percentile(0.999)},
                       {"max", late.max()},
                       {"load", pacing_.load()}}}}
                 .dump());
}

void Exercise::greet() {
  if (joining_.empty())
    return;
  const auto bytes = so_far();
  for (const net::ViewerId who : joining_)
    host_.greet(who, bytes);
  joining_.clear();
}

/// With every order that was told, none that was not, and those to come of the scenario.
std::shared_ptr<const std::string> Exercise::so_far() const {
  record::RunFile run = run_;
  run.trail = trail_.trail_to(mission_.run().world());
  const auto orders = mission_.run().orders();
  const auto next = mission_.run().orders_for(mission_.run().world().step());
  run.orders.assign(orders.data(), next.data() + next.size() - not_flown());
  run.orders.insert(run.orders.end(), next.data() + next.size(), orders.data() + orders.size());
  return std::make_shared<std::string>(record::encode(run));
}

}  // namespace eyrie::live
