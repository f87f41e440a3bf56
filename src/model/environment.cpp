// SPDX-License-Identifier: MIT
#include "model/environment.hpp"

#include <algorithm>

namespace eyrie::model {
namespace {

// the layers by geopotential altitude: U.S. Standard Atmosphere 1976, table 4
constexpr double kTropopause = 11000, kSecondLayer = 20000, kTop = 32000, kBottom = -2000;
constexpr double kLapse = -0.0065, kRise = 0.001;
constexpr double kTropopauseTemperature = kSeaLevelTemperature + kLapse * kTropopause;

// eq. 33a: hydrostatic pressure ratio across a layer with a temperature gradient
double gradient_ratio(double temperature_ratio, double gradient) {
  return math::pow(temperature_ratio, -kGravity / (kGasConstant * gradient));
}

// eq. 33b: the same at constant temperature
double isothermal_ratio(double rise) {
  return math::exp(-kGravity * rise / (kGasConstant * kTropopauseTemperature));
}

double pressure_at(double height) {
  const double temperature = layer_temperature(height);
  if (height <= kTropopause)
    return kSeaLevelPressure * gradient_ratio(temperature / kSeaLevelTemperature, kLapse);
  const double at_tropopause =
      kSeaLevelPressure * gradient_ratio(kTropopauseTemperature / kSeaLevelTemperature, kLapse);
  if (height <= kSecondLayer)
    return at_tropopause * isothermal_ratio(height - kTropopause);
  return at_tropopause * isothermal_ratio(kSecondLayer - kTropopause) *
         gradient_ratio(temperature / kTropopauseTemperature, kRise);
}

}  // namespace

Air standard_air(double altitude) {
  const double height = std::clamp(geopotential(altitude), kBottom, kTop);
  return complete(layer_temperature(height), pressure_at(height));
}

Atmosphere::Atmosphere() {
  static_assert(kLowest == kBottom && kHighest == kTop);
  for (std::size_t i = 0; i <= std::size_t{kPieces}; ++i) {
    const double height = kLowest + kPiece * static_cast<double>(i);
    const double pressure = pressure_at(height);
    const double density = pressure / (kGasConstant * layer_temperature(height));
    const NodeOf<double> node{.pressure = pressure, .slope = -density * kGravity * kPiece};
    if (i < pieces_.size())
      pieces_[i][0] = node;
    if (i > 0)
      pieces_[i - 1][1] = node;
  }
}

Air Atmosphere::at(double altitude) const {
  return air_at(altitude);
}

const Wind kCalm;

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
