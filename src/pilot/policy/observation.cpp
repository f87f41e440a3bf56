// SPDX-License-Identifier: MIT
#include "pilot/policy/observation.hpp"

#include "core/hash.hpp"
#include "core/math.hpp"
#include "pilot/policy/layout.hpp"
#include "pilot/state.hpp"

namespace eyrie::pilot {
namespace {

std::optional<Feature> read_feature(LayoutLine& line) {
  static const std::vector<ubf::StateFieldInfo> kInfos = ubf::state_field_infos<State>();
  ubf::FieldNames names;
  const std::string_view name = line.word();
  Feature feature{.field = static_cast<std::uint32_t>(names.find(kInfos, name))};
  if (feature.field == kInfos.size()) {
    line.fail(names.unknown(kInfos, name));
    return std::nullopt;
  }
  static constexpr auto kTransforms = enum_names<Transform>();
  const std::string_view transform = line.word();
  const std::optional<Transform> found = enum_named<Transform>(transform);
  if (!found) {
    line.fail(transform.empty()
                  ? "expected linear, sine, cosine or present behind the name, got the end"
                  : fmt::format("expected linear, sine, cosine or present, got {}{}",
                                quote(transform), did_you_mean(transform, kTransforms)));
    return std::nullopt;
  }
  feature.transform = *found;
  const Dimension dimension = kInfos[feature.field].unit.dimension;
  if (*found == Transform::linear) {
    const auto range = line.range(dimension);
    if (!range)
      return std::nullopt;
    std::tie(feature.low, feature.high) = *range;
    return line.end() ? std::optional(feature) : std::nullopt;
  }
  if (*found != Transform::present && dimension != Dimension::angle) {
    line.fail(fmt::format("{} is no angle: {} is for angles", quote(name), transform));
    return std::nullopt;
  }
  return line.end() ? std::optional(feature) : std::nullopt;
}

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

std::optional<Observation> Observation::read(std::string_view text, const Location& where,
                                             Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.count();
  Observation observation;
  read_layout(text, where, diagnostics, [&](LayoutLine& line) {
    if (const auto feature = read_feature(line))
      observation.features_.push_back(*feature);
  });
  return diagnostics.count() == before ? std::optional(std::move(observation)) : std::nullopt;
}

Observation::Observation(std::string_view text, const Location& where) {
  Diagnostics diagnostics;
  auto observation = read(text, where, diagnostics);
  if (!observation)
    throw ConfigError(diagnostics);
  *this = std::move(*observation);
}

void Observation::write(const State& state, float* out) const {
  const ubf::StateField<State>* fields = ubf::StateFields<State>::all().data();
  std::uint32_t last = ~0U;
  double value = 0;
  for (const Feature& feature : features_) {
    if (feature.field != last)  // sine and cosine of one angle stand one after the other
      value = fields[feature.field].read(state);
    last = feature.field;
    *out++ = static_cast<float>(transformed(feature, value));
  }
}

std::string Observation::text() const {
  std::string text;
  for (const Feature& feature : features_) {
    const ubf::StateFieldInfo& info = feature.info();
    text += fmt::format("{} {}", info.name, enum_name(feature.transform));
    if (feature.transform == Transform::linear)
      text += fmt::format(" {} {}", exact_quantity(feature.low, info.unit.dimension),
                          exact_quantity(feature.high, info.unit.dimension));
    text += '\n';
  }
  return text;
}

std::uint64_t Observation::hash() const {
  const std::string all = text();
  return hash_bytes(std::as_bytes(std::span(all)));
}

}  // namespace eyrie::pilot
