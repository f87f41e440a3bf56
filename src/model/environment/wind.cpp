// SPDX-License-Identifier: MIT
#include "model/environment/wind.hpp"

#include <utility>

#include "core/assert.hpp"
#include "core/math.hpp"

namespace eyrie::model {

std::optional<std::string> Wind::problem(std::span<const WindLayer> layers) {
  for (std::size_t i = 1; i < layers.size(); ++i)
    if (!(layers[i].altitude > layers[i - 1].altitude))
      return "the layers of wind must be listed from low to high, each altitude once";
  return std::nullopt;
}

Wind::Wind(std::span<const WindLayer> layers) {
  EYRIE_THROW_UNLESS(!problem(layers), "layers of wind must be listed from low to high");
  std::vector<double> altitudes;
  for (const WindLayer& layer : layers) {
    const auto [sine, cosine] = math::sin_cos(layer.from);
    altitudes.push_back(layer.altitude);
    velocity_.push_back({-layer.speed * cosine, -layer.speed * sine, 0});
  }
  if (!altitudes.empty())
    altitude_ = Axis(std::move(altitudes));
}

Vec3 Wind::at(double altitude) const {
  if (velocity_.empty())
    return {};
  if (velocity_.size() == 1)
    return velocity_.front();
  const TableCell cell = altitude_.cell(altitude);
  return (1 - cell.fraction) * velocity_[cell.index] + cell.fraction * velocity_[cell.index + 1];
}

}  // namespace eyrie::model
