// SPDX-License-Identifier: MIT
/// \file  Any text as a campaign and as a search: it is read and its cells have a value for each
/// factor, which reads back as what it sets; or it is refused by a ConfigError that a terminal can
/// show.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "campaign/search.hpp"
#include "core/text.hpp"
#include "core/yaml.hpp"
#include "fuzz/demand.hpp"

namespace {

using namespace eyrie;
using fuzz::demand;

/// Many cells cost time and tell nothing more.
bool is_small(const campaign::Spec& spec) {
  double cells = spec.design.cells.value_or(1);
  for (const campaign::Factor& f : spec.factors)
    cells *= static_cast<double>(std::max<std::size_t>(1, f.levels.size()));
  return cells < 2000;
}

/// A text is read by this, or refused.
template <class Read>
void read_or_refuse(const Read& read) {
  try {
    read();
  } catch (const ConfigError& refusal) {
    demand(!refusal.diagnostics().ok());
    for (const Diagnostic& one : refusal.diagnostics().sorted())
      demand(printable(one.text()) == one.text());
  }
}

void read_campaign(const std::string& text) {
  const campaign::Spec spec = campaign::parse_spec(text, "campaign.yaml");
  for (const campaign::Factor& factor : spec.factors)
    for (const campaign::Level& level : factor.levels)
      for (std::size_t i = 0; i < factor.paths.size(); ++i) {
        Diagnostics none;
        static_cast<void>(
            parse_yaml(level.sets.at(i).substr(factor.paths[i].size() + 1), "value", none));
        demand(none.ok());
      }
  if (!is_small(spec))
    return;
  for (const campaign::Cell& cell : campaign::cells_of(spec)) {
    demand(cell.values.size() == spec.factors.size());
    demand(campaign::sets_of(spec, cell).size() >= spec.factors.size());
  }
}

void read_search(const std::string& text) {
  const auto search = campaign::parse_search(text, "search.yaml");
  demand(search->best != nullptr);
  const campaign::Spec& spec = search->spec;
  for (const double x : {-3.7, 0.0, 0.5, 1.0, 1e9}) {
    const std::vector<double> point(spec.factors.size(), x);
    const campaign::Cell cell = campaign::cell_at(*search, point);
    demand(cell == campaign::cell_at(*search, point));
    demand(campaign::sets_of(spec, cell).size() >= spec.factors.size());
  }
  if (is_small(spec))
    demand(campaign::cells_of(campaign::probe_of(*search)).size() == 100);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  read_or_refuse([&] { read_campaign(text); });
  read_or_refuse([&] { read_search(text); });
  return 0;
}
