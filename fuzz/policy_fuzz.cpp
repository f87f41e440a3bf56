// SPDX-License-Identifier: MIT
/// \file  Any bytes as the file of a policy: it is read or refused with words, and what was read is
/// evaluated within its bounds and read back from its texts.
#include <array>

#include "fuzz/demand.hpp"
#include "pilot/policy/policy_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace eyrie;
  using fuzz::demand;
  Diagnostics diagnostics;
  const auto policy = pilot::PolicyFile::read(
      size ? std::string(reinterpret_cast<const char*>(data), size) : std::string(), "fuzz",
      diagnostics);
  demand(policy.has_value() == diagnostics.ok());
  if (!policy)
    return 0;
  const std::vector<float> seen(policy->observation.size(), 0.5F);
  std::vector<float> memory(policy->network.memory()), out(policy->network.outputs());
  for (int i = 0; i < 3; ++i)
    policy->network.evaluate(seen, memory, out);
  fuzz::demand_same(pilot::Observation(policy->observation.text()).text(),
                    policy->observation.text());
  if (!policy->votes)
    fuzz::demand_same(pilot::Controls(policy->controls.text()).text(), policy->controls.text());
  return 0;
}
