// SPDX-License-Identifier: MIT
#pragma once
/// \file  A type of aircraft: which models it is put together from.
#include "model/entity_type.hpp"
#include "model/flight/airframe.hpp"
#include "model/signature.hpp"
#include "model/weapon/stores.hpp"

namespace eyrie::model {

/// What hangs on one station when a scenario says nothing else.
struct StationFit {
  std::string store;  ///< name of a missile
  std::uint8_t count = 1;

  static constexpr std::string_view type_name = "station";
  static constexpr std::string_view help = "what hangs on one station";
  static constexpr auto params() {
    return Lines{param("store", &StationFit::store, "name of a missile").required(),
                 param("count", &StationFit::count, range(1, 8), "how many of it")};
  }
};

/// Put together from models that files name; whoever loads them looks the names up in the Library.
/// What has no name is not on board.
struct AircraftType {
  std::string label;                ///< what the story and Tacview call it: "F-15C"
  std::string entity_type = "1.2";  ///< see EntityType
  std::string airframe;
  flight::Dynamics dynamics = flight::Dynamics::point_mass;
  Signature signature;
  InfraredSignature infrared;
  std::optional<std::string> radar, irst, rwr, visual, iff, datalink, tracker, gun, dispenser,
      jammer;
  std::optional<std::uint16_t> rounds;  ///< in the drum of the gun, if not as many as its type has
  std::vector<StationFit> stations;

  /// Indices into the shelves of the Library: the names above, looked up.
  struct Indices {
    std::uint16_t airframe = 0;
    std::optional<std::uint16_t> radar, irst, rwr, visual, iff, datalink, tracker, gun, dispenser,
        jammer;
  };
  Indices index;

  static constexpr std::string_view type_name = "aircraft";
  static constexpr std::string_view help =
      "a type of aircraft: which models it is put together from";
  static constexpr auto params() {
    using A = AircraftType;
    return Lines{
        param("label", &A::label, "name in the story and in Tacview").items(1, 40).required(),
        param("entity_type", &A::entity_type, kEntityTypeHelp).items(3, 27),
        param("airframe", &A::airframe, "how it flies").required(),
        param("dynamics", &A::dynamics, "by which equations of motion"),
        param("signature", &A::signature, "how big it looks to radar and eye"),
        param("infrared", &A::infrared, "how bright it is to an infrared seeker"),
        param("radar", &A::radar, "its radar"),
        param("irst", &A::irst, "its infrared search and track"),
        param("rwr", &A::rwr, "its radar warning receiver"),
        param("visual", &A::visual, "the eyes of its crew"),
        param("iff", &A::iff, "its interrogator"),
        param("datalink", &A::datalink, "its datalink"),
        param("tracker", &A::tracker, "its tracker"),
        param("gun", &A::gun, "its gun"),
        param("rounds", &A::rounds, range(1, 10e3),
              "in the drum of its gun, where that is not what the gun's type says"),
        param("dispenser", &A::dispenser, "its dispenser of chaff, flares and towed decoys"),
        param("jammer", &A::jammer, "its jammer"),
        param("stations", &A::stations, "what hangs under it, station by station")
            .items(0, weapon::kMaxStations)};
  }
};

}  // namespace eyrie::model
