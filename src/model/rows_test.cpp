// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "core/field.hpp"
#include "model/command.hpp"
#include "model/fit.hpp"
#include "model/kinematics.hpp"

namespace eyrie::model {
namespace {

template <class Row>
std::string shown(const Row& row, std::string_view name) {
  for (const FieldInfo& field : fields_of<Row>())
    if (field.name.view() == name)
      return format_scalar(field, reinterpret_cast<const std::byte*>(&row));
  return "no such field";
}

TEST(SharedRows, NameTheirChoices) {
  Command command;
  command.mode = AutopilotMode::follow;
  EXPECT_EQ(shown(command, "mode"), "follow");
  Fit fit;
  fit.side = Side::red;
  EXPECT_EQ(shown(fit, "side"), "red");
}

}  // namespace
}  // namespace eyrie::model
