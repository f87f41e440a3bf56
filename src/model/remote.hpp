// SPDX-License-Identifier: MIT
#pragma once
/// \file  Players that another program flies: rows of the same tables, which everybody senses like
/// any other, and which follow what was heard of them. What was heard comes as orders, so a run
/// with them is replayed without the network. Who knows the network makes the orders
/// (dis/others.hpp).
#include "model/columns.hpp"
#include "model/library.hpp"
#include "sim/event.hpp"
#include "sim/system.hpp"

namespace eyrie::model {

/// What was heard last of one: dead reckoning goes on from there.
struct Heard {
  Vec3 position{};             ///< m, local frame
  Vec3 velocity{};             ///< m/s
  Vec3 acceleration{};         ///< m/s^2
  Vec3 angles{};               ///< rad: heading, pitch, roll
  Vec3 spin{};                 ///< rad/s, about the body's axes
  double time = 0;             ///< s, when it was so
  double shot_time = 0;        ///< s, when somebody may have hit it last
  float azimuth = 0;           ///< rad, from the nose: the middle of its beam
  float elevation = 0;         ///< rad, likewise
  PlayerId dwell{};            ///< on whom the beam rests
  PlayerId shooter{};          ///< who may have hit it last
  PlayerId missile{};          ///< with what; none: a gun
  std::uint32_t code = 0;      ///< of a missile: see remote_missile()
  std::uint8_t here = 0;       ///< 0: it has not appeared, or vanished
  std::uint8_t algorithm = 0;  ///< of dead reckoning: 1 to 5 of DIS
  EmissionKind beam = EmissionKind::none;
  std::uint8_t jams = 0;   ///< 1: with its jammer
  std::uint8_t ended = 0;  ///< 1: its last step is this one
  std::uint8_t reserved[3] = {};

  static constexpr auto fields() {
    using H = Heard;
    return field_list(
        field("position", &H::position, "m"), field("velocity", &H::velocity, "m/s"),
        field("acceleration", &H::acceleration, "m/s2"), field("angles", &H::angles, "rad"),
        field("spin", &H::spin, "rad/s"), field("time", &H::time, "s"),
        field("shot_time", &H::shot_time, "s"), field("azimuth", &H::azimuth, "rad"),
        field("elevation", &H::elevation, "rad"), field("dwell", &H::dwell),
        field("shooter", &H::shooter), field("missile", &H::missile), field("code", &H::code),
        field("here", &H::here), field("algorithm", &H::algorithm), field("beam", &H::beam),
        field("jams", &H::jams), field("ended", &H::ended), field("reserved", &H::reserved));
  }
};

/// Beside AircraftColumns and MissileColumns, in the scenarios in which there are such players.
struct RemoteColumns {
  sim::Column<Heard> aircraft, missiles;
  [[nodiscard]] static RemoteColumns define(sim::SchemaBuilder& schema, TableId aircraft,
                                            TableId missiles) {
    return {schema.add_column<Heard>(aircraft, "heard"),
            schema.add_column<Heard>(missiles, "heard")};
  }
};

/// A missile has no id before it is born, and another one in another run: its orders name it by a
/// number of the recording, from 1 on.
[[nodiscard]] constexpr PlayerId remote_missile(std::uint32_t code) {
  return PlayerId{0x8000'0000u | code};
}

// Its orders. Those that name who is gone, or hold what no state of the air war is, are ignored.

enum class RemoteOrder : std::uint16_t {
  place = 32,  ///< where it was; it appears
  motion,
  attitude,
  beam,
  launch,  ///< a missile is born; or, if it was already, this is who launched it at whom
  detonation,
  rounds,  ///< of a gun that hit
  leave,
};

struct RemotePlace {
  Vec3 position;    ///< m, local frame
  float since = 0;  ///< s, from the step of the order to when it was there
  std::uint8_t algorithm = 0, pad[3] = {};
};
struct RemoteMotion {
  Vec3f velocity{};      ///< m/s, local frame
  Vec3f acceleration{};  ///< m/s^2
};
struct RemoteAttitude {
  Vec3f angles{};  ///< rad: heading, pitch, roll
  Vec3f spin{};    ///< rad/s
};
struct RemoteBeam {
  float azimuth = 0, elevation = 0;  ///< rad, from the nose
  PlayerId dwell{};
  EmissionKind kind = EmissionKind::none;
  std::uint8_t jams = 0, pad[2] = {};
};
struct RemoteLaunch {
  PlayerId shooter{}, target{};
  float range = 0;         ///< m
  std::uint16_t type = 0;  ///< index of the MissileType
  Side side = Side::none;
  std::uint8_t pad = 0;
};
/// `order.player` is the missile.
struct RemoteDetonation {
  PlayerId shooter{}, target{};
  Vec3f place{};            ///< m, local frame
  float miss = 0;           ///< m, from the target
  std::uint16_t type = 0;   ///< index of the MissileType
  std::uint8_t lethal = 0;  ///< 1: near the target, which whose it is assesses
  std::uint8_t ending = 0;  ///< otherwise weapon::MissileEnd
};
/// `order.player` is the target.
struct RemoteRounds {
  PlayerId shooter{};
  float damage = 0;
};
enum class RemoteEnd : std::uint8_t { vanished, gone, destroyed };
struct RemoteLeave {
  RemoteEnd end = RemoteEnd::vanished;
};

/// Where dead reckoning has brought it at `time` (s).
void reckon(const Heard& heard, double time, const Reference& reference,
            const Environment& environment, Kinematics& k);

/// Aircraft: orders of all that are remote; act: what they radiate; move: dead reckoning; commit:
/// who may have hit them, and the end of those that were destroyed.
class RemoteSystem final : public sim::System {
 public:
  RemoteSystem(const AircraftColumns& aircraft, const MissileColumns& missiles,
               const RemoteColumns& heard, std::shared_ptr<const Library> library)
      : aircraft_(aircraft), missiles_(missiles), heard_(heard), library_(std::move(library)) {}

  [[nodiscard]] std::string_view name() const override { return "remote"; }
  [[nodiscard]] TableId table() const override { return aircraft_.table; }
  [[nodiscard]] std::span<const sim::OrderKind> accepts() const override;
  void apply_order(sim::World&, const sim::StepInfo&, const sim::Order&,
                   sim::Outbox&) const override;
  void act(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;
  void move(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;
  void commit(sim::World&, const sim::StepInfo&, std::span<const sim::Event>,
              sim::CommitContext&) const override;

 private:
  void launch(sim::World&, const sim::StepInfo&, const sim::Order&, sim::Outbox&) const;
  void detonate(sim::World&, const sim::StepInfo&, const sim::Order&, sim::Outbox&) const;
  void leave(sim::World&, const sim::StepInfo&, const sim::Order&, sim::Outbox&) const;

  AircraftColumns aircraft_;
  MissileColumns missiles_;
  RemoteColumns heard_;
  std::shared_ptr<const Library> library_;
};

/// act: what remote missiles radiate; move: dead reckoning.
class RemoteMissiles final : public sim::System {
 public:
  RemoteMissiles(const MissileColumns& missiles, const RemoteColumns& heard,
                 std::shared_ptr<const Library> library)
      : missiles_(missiles), heard_(heard.missiles), library_(std::move(library)) {}

  [[nodiscard]] std::string_view name() const override { return "remote missile"; }
  [[nodiscard]] TableId table() const override { return missiles_.table; }
  void act(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;
  void move(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;

 private:
  MissileColumns missiles_;
  sim::Column<Heard> heard_;
  std::shared_ptr<const Library> library_;
};

}  // namespace eyrie::model
