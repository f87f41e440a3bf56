// SPDX-License-Identifier: MIT
#pragma once
/// \file  Everything that files may say, gathered from the descriptions that also read the files:
/// the generated references cannot differ from the program.
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

/// Nodes of one kind, as references put them together.
struct NodeSection {
  ubf::Kind kind;
  std::string_view title, help;
};
inline constexpr std::array kNodeSections{
    NodeSection{ubf::Kind::behavior, "Behaviors", "A behavior proposes an action with a vote."},
    NodeSection{ubf::Kind::condition, "Conditions",
                "A condition succeeds or fails and proposes nothing."},
    NodeSection{ubf::Kind::arbiter, "Arbiters",
                "An arbiter asks all its children and makes one proposal of theirs."},
    NodeSection{ubf::Kind::control, "Control nodes",
                "A control node chooses which children are asked."},
    NodeSection{ubf::Kind::decorator, "Decorators", "A decorator changes what its child answers."}};

struct Catalog {
  std::vector<std::string> scenarios;  ///< that come with Eyrie, by name
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

/// One node with its parameters and how a file writes it; the kind of platform goes with it where
/// several have a node of that name. Nothing if there is none.
[[nodiscard]] std::optional<std::string> node_text(const Catalog& catalog, std::string_view name);
/// The names of all nodes.
[[nodiscard]] std::vector<std::string_view> node_names(const Catalog& catalog);

/// The reference with every parameter, docs/reference.md.
[[nodiscard]] std::string catalog_markdown(const Catalog& catalog);

// A described parameter in words, for the generated references.

/// What a file may write: "length", "whole number", "one of follow, lead", "list of 3 lengths",
/// "table of forces over mach and altitude".
[[nodiscard]] std::string kind_text(const ParamInfo& info);

/// Its limits as a file would write them: "0 m to 50 km", "at least 1 s", "above 0"; "" for none.
/// A list has the limits of its items.
[[nodiscard]] std::string range_text(const ParamInfo& info);

/// "required", or the default as a file would write it; "" where that is no short text.
[[nodiscard]] std::string default_text(const ParamInfo& info);
/// "°/s", "m": the unit of SI, but degrees.
[[nodiscard]] std::string_view shown_symbol(Dimension dimension);

/// Calls `visit(path, info)` for every parameter and, behind it, for those inside it:
/// "start.altitude"; "stations[].store" inside the items of a list.
void each_parameter(std::span<const ParamInfo> parameters,
                    const std::function<void(const std::string&, const ParamInfo&)>& visit,
                    const std::string& prefix = "");

/// The noun of a dimension without its article: "length". For none: "plain number".
[[nodiscard]] std::string_view dimension_word(Dimension dimension);

}  // namespace eyrie::scenario
