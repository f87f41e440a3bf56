// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/field.hpp"
#include "model/command.hpp"
#include "model/fit.hpp"
#include "model/kinematics.hpp"

namespace eyrie::model {
namespace {

static_assert(fields_cover_row<Kinematics>());
static_assert(fields_cover_row<Command>());
static_assert(fields_cover_row<Request>());
static_assert(fields_cover_row<Fit>());

TEST(SharedRows, NameTheirChoices) {
  Command command;
  command.mode = AutopilotMode::follow;
  const auto bytes = reinterpret_cast<const std::byte*>(&command);
  for (const FieldInfo& field : fields_of<Command>())
    if (field.name == "mode")
      EXPECT_EQ(format_scalar(field, bytes), "follow");
  Fit fit;
  fit.side = Side::red;
  for (const FieldInfo& field : fields_of<Fit>())
    if (field.name == "side")
      EXPECT_EQ(format_scalar(field, reinterpret_cast<const std::byte*>(&fit)), "red");
}

}  // namespace
}  // namespace eyrie::model
