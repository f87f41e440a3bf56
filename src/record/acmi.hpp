// SPDX-License-Identifier: MIT
#pragma once
/// \file  Tacview ACMI 2.2 text: aircraft, missiles, kills, locks, fuel and who is in charge.
/// Format: https://www.tacview.net/documentation/acmi/ (as of 2024-06-20).
#include "disk/sink.hpp"
#include "record/acmi_object.hpp"
#include "scenario/scenario.hpp"
#include "sim/system.hpp"

namespace eyrie::record {

/// Writes a flight recording while a run is flown. Players are sampled at 5 Hz and
/// missiles at 10 Hz; of these samples the file has those that a reader needs who draws straight
/// lines between them (AcmiObject::kTolerance), one in five seconds at least. Births, deaths,
/// events, locks and whom the tree obeys stand at their time. Positions are relative to the
/// reference point, so that seven decimals of a degree (about 1 cm) stay short.
class AcmiWriter final : public sim::Observer {
 public:
  AcmiWriter(const scenario::Scenario& scenario, disk::Sink& sink);

  void begin(const sim::World& world, double dt) override;
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override;
  void finish(const sim::World& world) override;

 private:
  void see_players(const sim::World& world);
  void see_missiles(const sim::World& world);
  void see(PlayerId id, AcmiSample sample);
  [[nodiscard]] AcmiSample player(const scenario::Fleet& fleet, const sim::World& world,
                                  std::size_t row);
  [[nodiscard]] AcmiSample sample_of(const model::Kinematics& k) const;
  [[nodiscard]] std::string introduction(const scenario::Roster::Player& player,
                                         std::string_view type) const;
  void born(const sim::Event& launch, const sim::World& world);
  void gone(PlayerId id);
  void happened(const sim::Event& event, const sim::World& world);
  template <class... T>
  void tell(fmt::format_string<T...> format, T&&... values) {
    lines_.push_back(
        {step_, AcmiLine::Kind::event, fmt::format(format, std::forward<T>(values)...)});
  }
  void pass(const sim::World& world);
  void write_lines();

  const scenario::Scenario& scenario_;
  disk::Sink& sink_;
  std::uint64_t step_ = 0;
  double time_ = 0, dt_ = 0;
  std::uint64_t players_every_ = 10, missiles_every_ = 5, lines_every_ = 250;  // steps
  std::map<std::uint32_t, AcmiObject> objects_;                                ///< by id
  std::map<std::pair<const void*, std::uint32_t>, std::string> labels_;        ///< by tree and node
  std::vector<AcmiLine> lines_;
  std::string written_frame_;
};

}  // namespace eyrie::record
