// SPDX-License-Identifier: MIT
#include "ubf/vote_curve.hpp"

#include <algorithm>

#include "core/bind.hpp"

namespace eyrie::ubf {
namespace {

/// The logistic function from 0 to 1 with this steepness rises by three quarters in the middle
/// third.
constexpr double kSteepness = 10;

double logistic(double x) {
  const auto raw = [](double at) { return 1 / (1 + math::exp(kSteepness * (0.5 - at))); };
  return (raw(x) - raw(0)) / (raw(1) - raw(0));
}

/// A vote, or one of its considerations, whose ends have the unit of the field.
struct Written {
  static constexpr std::string_view type_name = "vote";
  static constexpr auto params() {
    return Lines{
        param("least", &Written::least, range(0, 1000), "the vote where the product is 0"),
        param("of", &Written::of, "the state field that is looked at").required(),
        param("from", &Written::from, range(-1e12, 1e12), "where there is nothing of the vote"),
        param("to", &Written::to, range(-1e12, 1e12), "where there is all of it"),
        param("curve", &Written::curve, "how the vote rises between the ends")};
  }
  double least = 0;
  std::string of;
  double from = 0, to = 1;
  Curve curve = Curve::linear;
};

class VoteReading {
 public:
  VoteReading(std::span<const StateFieldInfo> fields,
              const std::function<std::optional<std::size_t>(const Value&)>& find,
              Diagnostics& diagnostics)
      : fields_(fields), find_(find), diagnostics_(diagnostics) {}

  std::optional<VoteCurve> read(const Value& text) {
    const std::size_t before = diagnostics_.count();
    VoteCurve vote;
    if (const Value* most = text.find("most"); most && most->is_map())
      diagnostics_.error(most->where, "vote: 'most' is a number such as 40, got a map");
    if (const Value* product = text.find("product")) {
      vote.least = bind(text, nullptr, {"least"}, {"most", "product"}).least;
      read_product(*product, vote);
    } else {
      read_one(text, true, vote);
    }
    return diagnostics_.count() == before ? std::optional(vote) : std::nullopt;
  }

 private:
  using Names = std::vector<std::string_view>;

  /// Binds those of the parameters that are named.
  Written bind(const Value& map, const StateFieldInfo* field, const Names& names,
               const Names& also) {
    std::vector<Parameter> lines;
    for (const std::string_view name : names) {
      Parameter& line = lines.emplace_back(*description_of<Written>().find(name));
      if (name == "from" || name == "to") {
        line.unit = field->unit;
        line.is_required = field->kind == FieldKind::number;
      }
    }
    Written said;
    eyrie::detail::bind({Written::type_name, lines}, &said, map, {}, diagnostics_, also);
    return said;
  }
  void read_product(const Value& list, VoteCurve& curve) {
    if (list.is_list() && !list.items.empty() && list.items.size() <= VoteCurve::kMost) {
      for (const Value& item : list.items)
        read_one(item, false, curve);
      return;
    }
    diagnostics_.error(
        list.where,
        "product: expected a list of 1 to {} considerations such as {{of: range, from: 40 nmi, to: "
        "10 nmi}}, got {}",
        VoteCurve::kMost,
        list.is_list() ? fmt::format("{} of them", list.items.size()) : list.shown());
  }
  /// `whole`: the map is the vote itself.
  void read_one(const Value& map, bool whole, VoteCurve& vote) {
    const std::size_t before = diagnostics_.count();
    const Value* of = map.find("of");
    const auto index = of && of->is_scalar() ? find_(*of) : std::nullopt;
    const StateFieldInfo* field = index ? &fields_[*index] : nullptr;
    const bool has_ends = field && field->kind != FieldKind::choice;
    Names names{"of", "curve"}, also;
    for (const std::string_view end : {"from", "to"})
      (has_ends ? names : also).push_back(end);
    if (whole) {
      names.push_back("least");
      also.push_back("most");
    }
    const Written said = bind(map, field, names, also);
    if (field && !has_ends)
      diagnostics_.error(of->where,
                         "of: {} is one of several names; a vote follows a number or a flag",
                         quote(field->name));
    else if (said.from == said.to && diagnostics_.count() == before)
      diagnostics_.error(map.where, "'from' and 'to' are the same");
    vote.least = whole ? said.least : vote.least;
    vote.product.push_back(
        {static_cast<std::uint32_t>(index.value_or(0)), said.from, said.to, said.curve});
  }

  std::span<const StateFieldInfo> fields_;
  const std::function<std::optional<std::size_t>(const Value&)>& find_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::string VoteCurve::problem() const {
  if (product.empty() || product.size() > kMost)
    return fmt::format("vote: {} considerations, expected 1 to {}", product.size(), kMost);
  if (!(least >= 0 && least <= 1))
    return fmt::format("vote: the least share is {}, expected 0 to 1", least);
  for (const Consideration& one : product)
    if (!(one.from < one.to || one.from > one.to))
      return fmt::format("vote: 'from' and 'to' are {} and {}", one.from, one.to);
  return {};
}

double Consideration::score(double value) const {
  const double x = std::clamp((value - from) / (to - from), 0.0, 1.0);
  if (!(x == x))
    return 0;
  switch (curve) {
    case Curve::linear:
      return x;
    case Curve::quadratic:
      return x * x;
    case Curve::root:
      return std::sqrt(x);
    case Curve::logistic:
      return logistic(x);
  }
  return 0;
}

std::string VoteCurve::text(const Scores& scores, std::span<const StateFieldInfo> fields) const {
  std::string words;
  for (std::size_t i = 0; i < product.size(); ++i)
    words += fmt::format("{}{} {:.2g}", i ? ", " : "", fields[product[i].field].name, scores[i]);
  return words;
}

std::optional<VoteCurve> read_vote(
    const Value& text, std::span<const StateFieldInfo> fields,
    const std::function<std::optional<std::size_t>(const Value&)>& find, Diagnostics& diagnostics) {
  return VoteReading(fields, find, diagnostics).read(text);
}

}  // namespace eyrie::ubf
