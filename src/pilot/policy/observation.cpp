// SPDX-License-Identifier: MIT
#include "pilot/policy/observation.hpp"

#include "core/math.hpp"
#include "pilot/state.hpp"

namespace eyrie::pilot {
namespace {

/// The value of one field, for one feature after the other.
class FieldValue {
 public:
  explicit FieldValue(double x) : x_(x) {}
  [[nodiscard]] double as(const Feature& feature) {
    if (std::isnan(x_))
      return 0;
    switch (feature.transform) {
      case Transform::linear:
        return to_unit(x_, feature.low, feature.high);
      case Transform::sine:
        return turned().sin;
      case Transform::cosine:
        return turned().cos;
      case Transform::present:
        return 1;
    }
    return 0;
  }

 private:
  const math::SinCos& turned() {
    if (!turned_)
      turned_ = std::isinf(x_) ? math::SinCos{0, 0} : math::sin_cos(x_);
    return *turned_;
  }

  double x_;
  std::optional<math::SinCos> turned_;
};

}  // namespace

const ubf::StateFieldInfo& Feature::info() const {
  return ubf::StateFields<State>::all()[field].info;
}

std::optional<Feature> Feature::read(LayoutLine& line, std::span<const Feature>) {
  static const std::vector<ubf::StateFieldInfo> kInfos = ubf::state_field_infos<State>();
  ubf::FieldNames names;
  const std::string_view name = line.word();
  Feature feature{.field = static_cast<std::uint32_t>(names.find(kInfos, name))};
  if (feature.field == kInfos.size())
    return line.fail(names.unknown(kInfos, name));
  static constexpr auto kTransforms = enum_names<Transform>();
  const std::string_view transform = line.word();
  const std::optional<Transform> found = enum_named<Transform>(transform);
  if (!found)
    return line.fail(transform.empty()
                         ? "expected linear, sine, cosine or present behind the name, got the end"
                         : fmt::format("expected linear, sine, cosine or present, got {}{}",
                                       quote(transform), did_you_mean(transform, kTransforms)));
  feature.transform = *found;
  const Dimension dimension = kInfos[feature.field].unit.dimension;
  if (*found == Transform::linear) {
    const auto range = line.range(dimension);
    if (!range)
      return std::nullopt;
    std::tie(feature.low, feature.high) = *range;
    return line.end() ? std::optional(feature) : std::nullopt;
  }
  if (*found != Transform::present && dimension != Dimension::angle)
    return line.fail(fmt::format("{} is no angle: {} is for angles", quote(name), transform));
  return line.end() ? std::optional(feature) : std::nullopt;
}

std::string Feature::text() const {
  const std::string words = fmt::format("{} {}", info().name, enum_name(transform));
  return transform == Transform::linear
             ? fmt::format("{} {}", words, range_text(low, high, info().unit.dimension))
             : words;
}

void Observation::write(const State& state, float* out) const {
  const ubf::StateField<State>* fields = ubf::StateFields<State>::all().data();
  std::uint32_t last = ~0U;
  FieldValue value(0);
  for (const Feature& feature : items()) {
    if (feature.field != last)  // sine and cosine of one angle stand one after the other
      value = FieldValue(fields[feature.field].read(state));
    last = feature.field;
    *out++ = static_cast<float>(value.as(feature));
  }
}

}  // namespace eyrie::pilot
