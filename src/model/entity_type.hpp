// SPDX-License-Identifier: MIT
#pragma once
/// \file  What kind of thing something is, for other simulations: the numbers of SISO-REF-010, by
/// which DIS and HLA name every aircraft, vehicle, munition and emitter.
#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>

namespace eyrie::model {

/// "1.2.225.1.5.3" in files: an F-15C. What is left out at the end is 0, which means "other".
struct EntityType {
  std::uint8_t kind = 0;      ///< 1 platform, 2 munition
  std::uint8_t domain = 0;    ///< of a platform: 1 land, 2 air, 3 surface
  std::uint16_t country = 0;  ///< 225 United States, 222 Russia
  std::uint8_t category = 0, subcategory = 0, specific = 0, extra = 0;

  /// In the order in which they are written.
  static constexpr auto parts() {
    using T = EntityType;
    return std::tuple{&T::kind,        &T::domain,   &T::country, &T::category,
                      &T::subcategory, &T::specific, &T::extra};
  }
  friend constexpr auto operator<=>(const EntityType&, const EntityType&) = default;
};

/// Of two to seven numbers between dots; nothing if one of them is too large or it is another text.
[[nodiscard]] std::optional<EntityType> entity_type_of(std::string_view text);
/// Of a number up to 65535; nothing if it is another text.
[[nodiscard]] std::optional<std::uint16_t> emitter_of(std::string_view text);

inline constexpr std::string_view kEntityTypeHelp =
    "SISO-REF-010 number by which other simulations know it";
inline constexpr std::string_view kEmitterHelp =
    "SISO-REF-010 number of its waveform for other simulations (UID 75), in quotes; \"0\": other";

}  // namespace eyrie::model
