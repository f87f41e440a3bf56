// SPDX-License-Identifier: MIT
#pragma once
/// \file  Everything that files may say, gathered from the descriptions that also read the files:
/// the generated references cannot differ from the program.
#include <map>
#include <string>
#include <vector>

#include "core/param.hpp"
#include "scenario/player_kind.hpp"
#include "scenario/plugins.hpp"
#include "scenario/source.hpp"
#include "ubf/spec.hpp"
#include "ubf/state_fields.hpp"

namespace eyrie::scenario {

/// One kind of model.
struct ModelKind {
  std::string folder;     ///< "radars": of data/<folder>/<name>.yaml and data.<folder>.<name>
  std::string type_name;  ///< "radar"
  std::string help;
  std::vector<ParamInfo> parameters;
  std::vector<std::string> names;  ///< of the files there are and of those of plug-ins, sorted
  std::map<std::string, std::string> origins;  ///< the plug-ins of the latter, by name
};

/// A kind of player besides aircraft.
struct OtherKind {
  std::string plural;                       ///< "vehicles"
  std::string key;                          ///< of a side: "convoys"
  std::string group;                        ///< its part of the file, by name: "convoy"
  std::vector<ubf::NodeInfo> nodes;         ///< besides the standard ones
  std::vector<ubf::StateFieldInfo> fields;  ///< that expressions and switches may read
};

struct Catalog {
  /// "scenario", "side", "flight", "player", "convoy", "vehicle", and groups of plug-ins.
  std::vector<FilePart> file;
  std::vector<ubf::NodeInfo> nodes;         ///< in the order of registration
  std::vector<ubf::StateFieldInfo> fields;  ///< that expressions and switches may read
  std::vector<OtherKind> others;            ///< vehicles, then those of plug-ins
  std::vector<ModelKind> models;            ///< in the order of DataLoader::kinds()
};

/// The names of models come from `source`, everything else from the program and the plug-ins that
/// were loaded into `source`.
[[nodiscard]] Catalog make_catalog(const Source& source, const Plugins& plugins = {});

/// A short list for the terminal: names and one line of help each, grouped.
[[nodiscard]] std::string catalog_text(const Catalog& catalog);

/// The reference with every parameter, docs/reference.md.
[[nodiscard]] std::string catalog_markdown(const Catalog& catalog);

}  // namespace eyrie::scenario
