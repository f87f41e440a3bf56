// SPDX-License-Identifier: MIT
#include "model/entity_type.hpp"

#include "core/text.hpp"

namespace eyrie::model {

std::optional<EntityType> entity_type_of(std::string_view text) {
  EntityType type;
  const char *at = text.data(), *const end = at + text.size();
  bool good = true;
  int read = 0;
  const auto take = [&](auto& part) {
    if (!good || (at == end && read > 1))
      return;
    const auto [next, failed] = std::from_chars(at, end, part);
    at = next;
    ++read;
    good = failed == std::errc{} && (at == end || (*at == '.' && ++at != end));
  };
  std::apply([&](auto... parts) { (take(type.*parts), ...); }, EntityType::parts());
  return good && at == end ? std::optional(type) : std::nullopt;
}

std::optional<std::uint16_t> emitter_of(std::string_view text) {
  return number_from<std::uint16_t>(text);
}

}  // namespace eyrie::model
