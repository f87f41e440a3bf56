// SPDX-License-Identifier: MIT
#include "ubf/state_fields.hpp"

#include <algorithm>

#include "core/angle.hpp"
#include "core/diagnostics.hpp"

namespace eyrie::ubf {

std::string never(const StateFieldInfo& field, std::string_view name, double x,
                  std::string_view written) {
  const auto& [min, max, _] = field.limits;
  if (x >= min && x <= max)
    return {};
  return fmt::format(
      "{} is from {} to {}, never {}{}", quote(name), exact_quantity(min, field.unit.dimension),
      exact_quantity(max, field.unit.dimension), written,
      field.unit.dimension == Dimension::angle
          ? fmt::format(": that is {:.9g} deg", degrees(wrap_pi(x)))  // as people count turns
          : "");
}

/// The name of the platform's field, there or not.
std::string_view FieldNames::meant(std::string_view name) {
  std::string_view wanted = name;
  for (auto layer = renames_.rbegin(); layer != renames_.rend(); ++layer) {
    const auto rename = std::ranges::find(*layer, wanted, &FieldRename::from);
    if (rename == layer->end())
      continue;
    rename->used = true;
    wanted = rename->to;
  }
  return wanted;
}

std::size_t FieldNames::find(std::span<const StateFieldInfo> fields, std::string_view name) {
  const auto field = std::ranges::find(fields, meant(name), &StateFieldInfo::name);
  return static_cast<std::size_t>(field - fields.begin());
}

std::string FieldNames::unknown(std::span<const StateFieldInfo> fields, std::string_view name) {
  std::vector<std::string> names = listed(fields, &StateFieldInfo::name);
  if (const std::string wanted(meant(name)); wanted != name)
    return fmt::format("{} means {} here, and {} {}{}", quote(name), quote(wanted), none_,
                       quote(wanted), nearest_or_all(wanted, names));
  for (const auto& layer : renames_)
    for (const FieldRename& rename : layer)
      names.push_back(rename.from);
  return fmt::format("{} {}{}", none_, quote(name), nearest_or_all(name, names));
}

std::vector<FieldRename> FieldNames::pop() {
  std::vector<FieldRename> last = std::move(renames_.back());
  renames_.pop_back();
  return last;
}

}  // namespace eyrie::ubf
