// SPDX-License-Identifier: MIT
#include "driver/catalog.hpp"

#include "driver/behavior/scatter.hpp"
#include "driver/behavior/ways.hpp"
#include "ubf/standard_nodes.hpp"

namespace eyrie::driver {

Registry make_registry() {
  Registry registry;
  ubf::add_standard_nodes(registry);
  registry.add<Navigate>();
  registry.add<FollowLead>();
  registry.add<Scatter>();
  registry.add<IsLead>();
  registry.add<RouteDone>();
  return registry;
}

}  // namespace eyrie::driver
