// SPDX-License-Identifier: MIT
#include "pilot/policy/observation.hpp"

#include "core/math.hpp"
#include "pilot/state.hpp"

namespace eyrie::pilot {
namespace {

double transformed(const Feature& feature, double x) {
  if (std::isnan(x))
    return 0;
  switch (feature.transform) {
    case Transform::linear:
      return to_unit(x, feature.low, feature.high);
    case Transform::sine:
      return std::isinf(x) ? 0 : math::sin(x);
    case Transform::cosine:
      return std::isinf(x) ? 0 : math::cos(x);
    case Transform::present:
      return 1;
  }
  return 0;
}

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
  double value = 0;
  for (const Feature& feature : items()) {
    if (feature.field != last)  // sine and cosine of one angle stand one after the other
      value = fields[feature.field].read(state);
    last = feature.field;
    *out++ = static_cast<float>(transformed(feature, value));
  }
}

}  // namespace eyrie::pilot
