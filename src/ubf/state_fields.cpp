// SPDX-License-Identifier: MIT
#include "ubf/state_fields.hpp"

#include <algorithm>

namespace eyrie::ubf {

std::size_t FieldNames::find(std::span<const StateFieldInfo> fields, std::string_view name) {
  std::string_view wanted = name;
  for (auto layer = renames_.rbegin(); layer != renames_.rend(); ++layer) {
    const auto rename = std::find_if(layer->begin(), layer->end(),
                                     [&](const FieldRename& r) { return r.from == wanted; });
    if (rename == layer->end())
      continue;
    rename->used = true;
    wanted = rename->to;
  }
  const auto field = std::find_if(fields.begin(), fields.end(),
                                  [&](const StateFieldInfo& f) { return f.name == wanted; });
  return static_cast<std::size_t>(field - fields.begin());
}

std::vector<std::string> FieldNames::known(std::span<const StateFieldInfo> fields) const {
  std::vector<std::string> names;
  for (const StateFieldInfo& field : fields)
    names.emplace_back(field.name);
  for (const auto& layer : renames_)
    for (const FieldRename& rename : layer)
      names.push_back(rename.from);
  return names;
}

std::vector<FieldRename> FieldNames::pop() {
  std::vector<FieldRename> last = std::move(renames_.back());
  renames_.pop_back();
  return last;
}

}  // namespace eyrie::ubf
