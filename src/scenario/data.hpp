// SPDX-License-Identifier: MIT
#pragma once
/// \file  Models by name: data/<kind>/<name>.yaml, or the `data:` map of a scenario.
#include "core/bind.hpp"
#include "core/diagnostics.hpp"
#include "core/value.hpp"
#include "model/library.hpp"
#include "scenario/source.hpp"

namespace eyrie::scenario {

/// A kind of model: its folder in data/, what one is called, and its shelf.
template <class Model>
struct KindOfModel {
  std::string_view folder, singular;
  model::Shelf<Model> model::Library::*shelf;
};
template <class Model>  // clang 16 finds it for no aggregate by itself
KindOfModel(const char*, const char*, model::Shelf<Model> model::Library::*)->KindOfModel<Model>;
/// Every kind that has a folder in data/.
inline constexpr std::tuple kKindsOfModels{
    KindOfModel{"aircraft", "aircraft", &model::Library::aircraft},
    KindOfModel{"vehicles", "vehicle", &model::Library::vehicles},
    KindOfModel{"airframes", "airframe", &model::Library::airframes},
    KindOfModel{"radars", "radar", &model::Library::radars},
    KindOfModel{"irsts", "infrared search and track", &model::Library::irsts},
    KindOfModel{"rwr", "radar warning receiver", &model::Library::rwrs},
    KindOfModel{"visual", "visual model", &model::Library::visuals},
    KindOfModel{"iff", "iff", &model::Library::iffs},
    KindOfModel{"datalinks", "datalink", &model::Library::datalinks},
    KindOfModel{"trackers", "tracker", &model::Library::trackers},
    KindOfModel{"missiles", "missile", &model::Library::missiles},
    KindOfModel{"guns", "gun", &model::Library::guns},
    KindOfModel{"countermeasures", "dispenser", &model::Library::dispensers},
    KindOfModel{"jammers", "jammer", &model::Library::jammers}};
template <class Visit>
constexpr void each_kind_of_model(Visit visit) {
  std::apply([&](const auto&... kind) { (visit(kind), ...); }, kKindsOfModels);
}

/// What a document that is no scenario describes by its words, such as "aircraft"; "" if nothing.
[[nodiscard]] std::string_view model_in(const Value& document);

/// Where a model in a scenario's own data says something; else where its rates stand.
[[nodiscard]] Location place_in_data(const Value& document, std::string_view kind,
                                     std::string_view model, std::string_view parameter);

/// Puts models on the shelves of a Library: those of the scenario at once, so that all their
/// mistakes are found, those of files when they are first asked for. A model stands in the
/// scenario's `data: {<kind>: {<name>: {...}}}` or in a file; in both a key `base: <name>` takes
/// everything that is not said from another model of the kind. `source:` is free text about where
/// the numbers come from.
class DataLoader {
 public:
  /// `inline_data` is the scenario's `data:` map, or null.
  DataLoader(model::Library& library, const Value* inline_data, Source& source,
             Diagnostics& diagnostics);

  /// The index of a type with everything that it is put together from. Nothing if there
  /// is a mistake, which is then in the diagnostics: `where` is who asked.
  template <Described Model>
  std::optional<std::uint16_t> load(const std::string& name, const Location& where);

  /// Reads every model of a plug-in, so that its mistakes do not wait for the day it is flown.
  /// Nothing of it stays.
  static void check_plugins(Source source, Diagnostics& diagnostics);

  /// Their folders.
  [[nodiscard]] static std::vector<std::string_view> kinds();

 private:
  /// The document of a model with its bases merged in, or nothing after a mistake.
  std::optional<Value> document(std::string_view kind, const std::string& name,
                                const Location& where, std::vector<std::string>& chain);
  /// What a model is put together from, looked up in its document, and what is made of it.
  template <Described Model>
  void complete(Model& model, const Value& document);
  template <Described Model>
  void part(std::optional<std::uint16_t>& index, const std::optional<std::string>& name,
            const Location& where);
  void check_inline(const Value::Entry& kind);
  void load_any(std::string_view kind, const std::string& name, const Location& where);

  model::Library& library_;
  const Value* inline_;
  Source& source_;
  Diagnostics& diagnostics_;
  std::size_t untold_ = 0;    ///< mistakes of models that were asked for again
  bool only_checks_ = false;  ///< what is costly and finds no mistakes is left out
  std::map<std::pair<std::string, std::string>, bool> failed_;  ///< said once is enough
};

}  // namespace eyrie::scenario
