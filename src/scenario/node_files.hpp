// SPDX-License-Identifier: MIT
#pragma once
#include "scenario/source.hpp"
#include "ubf/registry.hpp"

namespace eyrie::scenario {

/// The file that a value names: from the folder of the file that it stands in, or, typed as part of
/// an option, as it was typed.
[[nodiscard]] std::string file_named(const Value& name);

/// The files that nodes of a scenario are made of, such as networks: beside the file that names
/// them, or, named by an option, as it was typed. They go into run files as the others do.
class NodeFiles final : public ubf::NodeFiles {
 public:
  explicit NodeFiles(Source& source) : source_(source) {}
  [[nodiscard]] std::optional<std::string> read(const Value& name,
                                                Diagnostics& diagnostics) override;

 private:
  Source& source_;
};

}  // namespace eyrie::scenario
