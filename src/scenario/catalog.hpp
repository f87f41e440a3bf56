// SPDX-License-Identifier: MIT
#pragma once
/// \file  Everything that files may say, gathered from the descriptions that also read the files:
/// the generated references cannot differ from the program.
#include <map>
#include <string>
#include <vector>

#include "core/param.hpp"
#include "scenario/plugins.hpp"
#include "scenario/source.hpp"
#include "ubf/spec.hpp"
#include "ubf/state_fields.hpp"

namespace eyrie::scenario {

/// Part of a scenario file.
struct FilePart {
  std::string name;  ///< "flight"
  std::string path;  ///< where it stands: "blue.flights.<name>"; "" for the top level
  std::string help;
  /// What is read by hand has the kind custom and its shape in words as type_name.
  std::vector<ParamInfo> parameters;
};

/// One kind of model.
struct ModelKind {
  std::string folder;     ///< "radars": of data/<folder>/<name>.yaml and data.<folder>.<name>
  std::string type_name;  ///< "radar"
  std::string help;
  std::vector<ParamInfo> parameters;
  std::vector<std::string> names;  ///< of the files there are and of those of plug-ins, sorted
  std::map<std::string, std::string> origins;  ///< the plug-ins of the latter, by name
};

struct Catalog {
  std::vector<FilePart> file;  ///< "scenario", "side", "flight", "player", "convoy", "vehicle"
  std::vector<ubf::NodeInfo> nodes;         ///< in the order of registration
  std::vector<ubf::StateFieldInfo> fields;  ///< that expressions and switches may read
  /// What drivers have besides the standard nodes, and what may be read of their state.
  std::vector<ubf::NodeInfo> driver_nodes;
  std::vector<ubf::StateFieldInfo> driver_fields;
  std::vector<ModelKind> models;  ///< in the order of DataLoader::kinds()
};

/// The names of models come from `source`, everything else from the program and the plug-ins that
/// were loaded into `source`.
[[nodiscard]] Catalog make_catalog(const Source& source, const Plugins& plugins = {});

/// A short list for the terminal: names and one line of help each, grouped.
[[nodiscard]] std::string catalog_text(const Catalog& catalog);

/// The reference with every parameter, docs/reference.md.
[[nodiscard]] std::string catalog_markdown(const Catalog& catalog);

}  // namespace eyrie::scenario
