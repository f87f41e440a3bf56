// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a plug-in includes: a shared library that adds behaviors, arbiters and models to the
/// program (docs/howto/write-a-plugin.md).
///
///   class Dodge final : public eyrie::pilot::Behavior { ... };
///   EYRIE_PLUGIN([](eyrie::scenario::Registrar& registrar) { registrar.add<Dodge>(); })
#include "core/diagnostics.hpp"
#include "core/version.hpp"
#include "driver/state.hpp"
#include "model/library.hpp"
#include "pilot/state.hpp"
#include "pilot/trees.hpp"
#include "scenario/header_print.hpp"
#include "ubf/composite.hpp"

namespace eyrie::scenario {

class PlayerKind;  // scenario/player_kind.hpp
using MakeKind = std::function<std::unique_ptr<PlayerKind>()>;

/// The node types that trees may be made of, one registry per kind of platform; and what makes
/// further kinds, which bring their own.
struct Registries {
  pilot::Registry pilots;
  driver::Registry drivers;
  std::vector<MakeKind> kinds = {};
};

/// A model as a text: what would stand in data/<kind>/<name>.yaml.
struct ModelText {
  std::string kind, name, yaml;
};

/// Takes what a plug-in adds. What it cannot take becomes a problem in words, for whoever loads the
/// plug-in to report.
class Registrar {
 public:
  /// `origin` is what the catalog says of where the nodes come from.
  Registrar(Registries& registries, std::string origin)
      : registries_(registries), origin_(std::move(origin)) {}

  /// A behavior, condition, arbiter, control node or decorator, as Registry::add takes it.
  template <std::derived_from<pilot::Behavior> Node>
  void add() {
    add_to(registries_.pilots, ubf::kNodeType<Node>);
  }
  template <std::derived_from<driver::Behavior> Node>
  void add() {
    add_to(registries_.drivers, ubf::kNodeType<Node>);
  }
  /// A type of node that is made at run time, of pilots or of drivers (Registry::add_type).
  void add_pilot_node(const ubf::NodeType& type) { add_to(registries_.pilots, type); }
  void add_driver_node(const ubf::NodeType& type) { add_to(registries_.drivers, type); }
  /// A kind of player besides aircraft and vehicles.
  void add_kind(MakeKind make) { registries_.kinds.push_back(std::move(make)); }
  /// A model that scenarios may then name as if data/<kind>/<name>.yaml held `yaml`.
  void add_model(std::string kind, std::string name, std::string yaml) {
    models_.push_back({std::move(kind), std::move(name), std::move(yaml)});
  }

  [[nodiscard]] const std::vector<ModelText>& models() const { return models_; }
  [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }

 private:
  template <class Registry>
  void add_to(Registry& registry, const ubf::NodeType& type) {
    try {
      registry.add_type(type, origin_);
    } catch (const std::logic_error& refused) {
      problems_.push_back(refused.what());
    }
  }

  Registries& registries_;
  std::string origin_;
  std::vector<ModelText> models_;
  std::vector<std::string> problems_;
};

inline constexpr std::uint64_t kPluginMagic = 0x4e4947554c505945;  ///< "EYPLUGIN"
/// Version of PluginInfo. Its members up to `format` are the same in all of them.
inline constexpr std::uint32_t kPluginFormat = 1;

/// A fingerprint of what a plug-in and the program hand to each other. Another one means that they
/// were compiled with other headers, or with another kind of standard library.
[[nodiscard]] constexpr std::uint64_t plugin_layout() {
  std::uint64_t hash = kHeaderPrint;  // continued by FNV-1a
  for (const std::size_t size :
       {sizeof(std::string), sizeof(std::function<void()>), sizeof(Registrar), sizeof(Registries),
        sizeof(pilot::State), sizeof(pilot::Agent), sizeof(driver::State), sizeof(driver::Agent)})
    hash = (hash ^ size) * 0x100000001b3;
  return hash;
}

/// The one thing that a plug-in exports, looked at before any of its code is called.
struct PluginInfo {
  std::uint64_t magic = kPluginMagic;
  std::uint32_t format = kPluginFormat;
  const char* version = kVersion;  ///< of the Eyrie that it was compiled with
  std::uint64_t layout = plugin_layout();
  void (*add)(Registrar&) = nullptr;
};

}  // namespace eyrie::scenario

extern "C" __attribute__((visibility("default"))) const eyrie::scenario::PluginInfo eyrie_plugin;

/// Makes the shared library a plug-in: a function that gets a Registrar and adds to it. Once.
#define EYRIE_PLUGIN(...) const eyrie::scenario::PluginInfo eyrie_plugin{.add = __VA_ARGS__};
