// SPDX-License-Identifier: MIT
#include "ubf/vote_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/bind.hpp"
#include "core/math.hpp"

namespace eyrie::ubf {
namespace {

/// The logistic function from 0 to 1 with this steepness rises by three quarters in the middle
/// third.
constexpr double kSteepness = 10;

double logistic(double x) {
  const auto raw = [](double at) { return 1 / (1 + math::exp(kSteepness * (0.5 - at))); };
  return (raw(x) - raw(0)) / (raw(1) - raw(0));
}

/// The whole vote, without what considers.
struct VoteKeys {
  static constexpr std::string_view type_name = "vote";
  static constexpr auto params() {
    return std::tuple{param("least", &VoteKeys::least, range(0, 1000), "never less than this")};
  }
  double least = 0;
};

/// One consideration but for its ends, whose unit is that of the field.
struct ConsiderationKeys {
  static constexpr std::string_view type_name = "vote";
  static constexpr auto params() {
    return std::tuple{
        param("of", &ConsiderationKeys::of, "the state field that is looked at").required(),
        param("curve", &ConsiderationKeys::curve, "how the vote rises between the ends")};
  }
  std::string of;
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
    const Value* product = text.find("product");
    VoteCurve vote;
    VoteKeys keys;
    if (product) {
      static constexpr std::array<std::string_view, 2> kKeys{"most", "product"};
      bind(keys, text, diagnostics_, kKeys);
      read_product(*product, vote);
    } else {
      static constexpr std::array<std::string_view, 5> kKeys{"most", "of", "from", "to", "curve"};
      bind(keys, text, diagnostics_, kKeys);
      static constexpr std::array<std::string_view, 4> kBeside{"most", "least", "from", "to"};
      read_one(text, kBeside, vote);
    }
    vote.least = keys.least;
    return diagnostics_.count() == before ? std::optional(vote) : std::nullopt;
  }

 private:
  void read_product(const Value& list, VoteCurve& curve) {
    if (!list.is_list() || list.items.empty() || list.items.size() > VoteCurve::kMost) {
      diagnostics_.error(list.where,
                         fmt::format("product: expected a list of 1 to {} "
                                     "considerations such as {{of: range, from: 40 "
                                     "nmi, to: 10 nmi}}, got {}",
                                     VoteCurve::kMost,
                                     list.is_list() ? fmt::format("{} of them", list.items.size())
                                                    : list.shown()));
      return;
    }
    static constexpr std::array<std::string_view, 2> kBeside{"from", "to"};
    for (const Value& item : list.items)
      read_one(item, kBeside, curve);
  }
  void read_one(const Value& map, std::span<const std::string_view> beside, VoteCurve& curve) {
    ConsiderationKeys keys;
    // what the keys beside it hold was read, or is read below
    if (beside.size() > 2) {
      Value own = Value::map({}, map.where);
      for (const Value::Entry& e : map.entries)
        if (e.key == "of" || e.key == "curve")
          own.entries.push_back(e);
      bind(keys, own, diagnostics_);
    } else {
      bind(keys, map, diagnostics_, beside);
    }
    const Value* of = map.find("of");
    const auto field = of && of->is_scalar() ? find_(*of) : std::nullopt;
    if (!field)
      return;
    Consideration c{.field = static_cast<std::uint32_t>(*field), .curve = keys.curve};
    const StateFieldInfo& info = fields_[*field];
    if (info.kind == FieldKind::choice)
      diagnostics_.error(of->where, fmt::format("of: {} is one of several names; a vote follows a "
                                                "number or a flag",
                                                quote(info.name)));
    else
      read_ends(map, info, c);
    curve.product.push_back(c);
  }
  void read_ends(const Value& map, const StateFieldInfo& field, Consideration& c) {
    const std::size_t before = diagnostics_.count();
    for (const auto& [key, end] : {std::pair("from", &c.from), {"to", &c.to}}) {
      const Value* value = map.find(key);
      ParamInfo info;
      info.name = key;
      info.unit = field.unit;
      info.limits = range(-1e12, 1e12);
      if (value)
        eyrie::detail::read_number(*end, *value, info, diagnostics_);
      else if (field.kind == FieldKind::number)
        eyrie::detail::report_missing(map, "vote", {}, key, diagnostics_);
    }
    if (c.from == c.to && diagnostics_.count() == before)
      diagnostics_.error(map.where, "'from' and 'to' are the same");
  }

  std::span<const StateFieldInfo> fields_;
  const std::function<std::optional<std::size_t>(const Value&)>& find_;
  Diagnostics& diagnostics_;
};

}  // namespace

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
