// SPDX-License-Identifier: MIT
#include "pilot/behavior/policy.hpp"

#include "core/math.hpp"
#include "pilot/outside.hpp"

namespace eyrie::pilot {
namespace {

/// The policy in the file that a node names; null after reporting.
std::shared_ptr<const PolicyFile> policy_in(const ubf::NodeSpec& spec, ubf::NodeReader& reader) {
  const Value* name = spec.body->find("file");
  if (!name || !name->is_scalar())
    return nullptr;  // reported with the parameters
  return reader.made_of<PolicyFile>(*name, [&](std::string bytes) {
    Diagnostics wrong;
    auto policy = PolicyFile::read(std::move(bytes), name->text, wrong);
    for (const Diagnostic& one : wrong.sorted())
      reader.error(name->where, one.text());
    return policy ? std::make_shared<const PolicyFile>(std::move(*policy)) : nullptr;
  });
}

/// One evaluation in a state: what comes out.
std::span<const float> evaluate(const PolicyFile& policy, const State& state, std::byte* memory,
                                NetworkNumbers& out) {
  NetworkNumbers seen;
  policy.observation.write(state, seen.data());
  const std::span<float> answer(out.data(), policy.network.outputs());
  policy.network.evaluate({seen.data(), policy.observation.size()},
                          {reinterpret_cast<float*>(memory), policy.network.memory()}, answer);
  return answer;
}

/// Votes in [0, 100] in the place of what came out; NaN abstains.
void make_votes(Votes how, std::span<float> numbers) {
  double most = -math::kInfinity, sum = 0;
  for (const float x : numbers)
    most = static_cast<double>(x) > most ? static_cast<double>(x) : most;
  for (const float x : numbers)
    sum += std::isnan(x) ? 0 : math::exp(static_cast<double>(x) - most);
  const auto share = [&](double x) {
    switch (how) {
      case Votes::sigmoid:
        return 1 / (1 + math::exp(-x));
      case Votes::softmax:
        return math::exp(x - most) / sum;
      case Votes::linear:
        return std::clamp((x + 1) / 2, 0.0, 1.0);
    }
    return 0.0;
  };
  for (float& x : numbers) {
    const double vote = 100 * share(static_cast<double>(x));
    x = std::isnan(vote) ? 0.0F : static_cast<float>(vote);
  }
}

}  // namespace

std::string Policy::problem() const {
  return policy_ ? "" : "a policy needs the file of a network";
}

void Policy::read(const ubf::NodeSpec& spec, ubf::NodeReader& reader) {
  policy_ = policy_in(spec, reader);
  if (policy_ && policy_->votes)
    reader.error(spec.body->where_of("file"),
                 fmt::format("the network of {} votes and commands nothing: it is for learned_vote",
                             quote(file_)));
}

Status Policy::tick(const Tick& t, Proposal& out) const {
  NetworkNumbers numbers;
  const auto units = evaluate(*policy_, t.state, t.memory + memory_begin(), numbers);
  const model::Manual asked = policy_->controls.apply(t.state, units);
  fly_by_hand(asked, t.state, out.action);
  // where it commands nothing it leaves the word to others
  using model::Manual;
  if (!asked.has(Manual::kHeading) && !asked.has(Manual::kAltitude) && !asked.has(Manual::kClimb))
    out.action.mode.reset();
  if (asked.trigger == 0)
    out.action.trigger.reset();
  out.vote = vote_;
  return Status::running;
}

std::string LearnedVote::problem() const {
  return policy_ ? ubf::Arbiter<State, Action>::problem()
                 : "a learned_vote needs the file of a network";
}

void LearnedVote::read(const ubf::NodeSpec& spec, ubf::NodeReader& reader) {
  policy_ = policy_in(spec, reader);
  const Location& where = spec.body->where_of("file");
  if (policy_ && !policy_->votes)
    reader.error(where,
                 fmt::format("the network of {} commands and does not vote: it is for policy",
                             quote(file_)));
  else if (policy_ && policy_->network.outputs() != children_.size())
    reader.error(where, fmt::format("the network of {} gives {} votes, for {} children",
                                    quote(file_), policy_->network.outputs(), children_.size()));
}

Status LearnedVote::tick(const Tick& t, Proposal& out) const {
  NetworkNumbers numbers;
  evaluate(*policy_, t.state, t.memory + memory_begin(), numbers);
  make_votes(*policy_->votes, {numbers.data(), children_.size()});
  if (t.trace) [[unlikely]]
    for (std::size_t i = 0; i < children_.size(); ++i)
      t.trace->voted(children_[i]->index(), numbers[i]);
  float highest = 0;
  const auto outvotes = [&](ubf::NodeIndex i, Proposal& next, ubf::NodeIndex) {
    if (!(numbers[i] > highest))
      return false;
    next.vote = highest = numbers[i];
    return true;
  };
  return hand_on(t, choose(t, out, outvotes), out);
}

}  // namespace eyrie::pilot
