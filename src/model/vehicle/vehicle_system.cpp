// SPDX-License-Identifier: MIT
#include "model/vehicle/vehicle_system.hpp"

#include <algorithm>

#include "model/datalink/datalink.hpp"
#include "model/events.hpp"
#include "model/kinematics.hpp"
#include "model/vehicle/lookout.hpp"
#include "model/vehicle/vehicle.hpp"

namespace eyrie::model::vehicle {
namespace {

/// m; the aerial stands on the roof.
constexpr double kAerial = 4;

/// Whether a mate's radio is heard.
bool reaches(const datalink::Datalink& datalink, const Kinematics& own, const Kinematics& other) {
  const double reach = std::min(
      datalink.range, horizon_range(own.altitude + kAerial, other.altitude + kAerial, kRadioEarth));
  return norm2(other.position - own.position) <= reach * reach;
}

}  // namespace

VehicleSystem::VehicleSystem(const VehicleColumns& vehicles, const AircraftColumns& aircraft,
                             std::shared_ptr<const Library> library, double dt)
    : vehicles_(vehicles), aircraft_(aircraft), library_(std::move(library)) {
  EYRIE_THROW_UNLESS(problems_of(*library_, dt).empty(), "a sensor that does not fit the step");
  for (std::size_t i = 0; i < library_->vehicles.size(); ++i) {
    const auto& index = library_->vehicles[i].index;
    Suite& suite = suites_.emplace_back();
    if (index.visual) {
      suite.visual = &library_->visuals[*index.visual];
      suite.visual_steps = sim::period_steps(suite.visual->rate, dt).steps;
    }
    if (index.datalink) {
      suite.datalink = &library_->datalinks[*index.datalink];
      suite.datalink_steps = sim::period_steps(suite.datalink->rate, dt).steps;
    }
  }
  for (std::size_t i = 0; i < library_->aircraft.size(); ++i)
    signatures_.push_back(&library_->aircraft[i].signature);
}

void VehicleSystem::perceive(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                             sim::Outbox&) const {
  const sim::World& truth = world;
  const Sky sky{truth.ids(aircraft_.table), truth.rows(aircraft_.fit),
                truth.rows(aircraft_.kinematics), signatures_};
  const auto ids = truth.ids(vehicles_.table);
  const auto fit = truth.rows(vehicles_.fit);
  const auto kinematics = truth.rows(vehicles_.kinematics);
  const auto sent = truth.rows(vehicles_.sent);
  const auto states = world.rows(vehicles_.datalink);
  const auto lookout = world.rows(vehicles_.lookout);
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    const Suite& suite = suites_[fit[i].type];
    // what mates tell
    if (suite.datalink != nullptr) {
      datalink::DatalinkState& state = states[i];
      if (state.count == 0)
        start(state, library_->flights[fit[i].flight].members, ids[i], info.time());
      for (std::uint32_t m = 0; m < state.count; ++m) {
        datalink::Mate& mate = state.members[m];
        const auto row = truth.row(vehicles_.table, mate.id);
        if (m == state.self || !row)
          continue;
        const datalink::DatalinkMessage* message = datalink::receive(
            mate, *suite.datalink, sent[*row],
            reaches(*suite.datalink, kinematics[i], kinematics[*row]), info.time(),
            Draw(info.seed, ids[i], Stream::datalink, info.step, mate.id.value));
        if (message)
          warn(lookout[i], kinematics[i].position, *message);
      }
      datalink::check_silence(state, *suite.datalink, info.time());
    }
    // what the own eyes see
    if (suite.visual != nullptr && sim::due(info.step, ids[i], suite.visual_steps))
      look_up(*suite.visual,
              {.own = kinematics[i],
               .id = ids[i],
               .side = fit[i].side,
               .seed = info.seed,
               .step = info.step,
               .time = info.time()},
              sky, lookout[i]);
  }
}

void VehicleSystem::act(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                        sim::Outbox&) const {
  const auto ids = world.ids(vehicles_.table);
  const auto fit = world.rows(vehicles_.fit);
  const auto kinematics = world.rows(vehicles_.kinematics);
  const auto lookout = world.rows(vehicles_.lookout);
  const auto sent = world.rows(vehicles_.sent);
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    const Suite& suite = suites_[fit[i].type];
    if (suite.datalink != nullptr && sim::due(info.step, ids[i], suite.datalink_steps))
      datalink::transmit(sent[i],
                         {.time = info.time(),
                          .position = kinematics[i].position,
                          .velocity = kinematics[i].velocity},
                         as_tracks(lookout[i]));
  }
}

void VehicleSystem::move(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                         sim::Outbox&) const {
  const auto fit = world.rows(vehicles_.fit);
  const auto command = world.rows(vehicles_.command);
  const auto kinematics = world.rows(vehicles_.kinematics);
  const auto driving = world.rows(vehicles_.driving);
  for (std::size_t i = chunk.begin; i < chunk.end; ++i)
    drive(library_->vehicles[fit[i].type], library_->reference,
          library_->flights[fit[i].flight].routes, command[i], info.dt, kinematics[i], driving[i]);
}

}  // namespace eyrie::model::vehicle
