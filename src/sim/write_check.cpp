// SPDX-License-Identifier: MIT
#include "sim/write_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace eyrie::sim {
namespace {

bool is_serial(Phase phase) {
  return phase == Phase::orders || phase == Phase::commit;
}

/// "only by flight in move"
std::string writers_text(const ColumnInfo& column) {
  std::string text;
  for (const WrittenBy& by : *column.writers)
    text += fmt::format("{}{} in {}", text.empty() ? "only by " : " and by ", by.system,
                        phase_name(by.phase));
  return text.empty() ? "by nobody" : text;
}

}  // namespace

void WriteCheck::note(std::optional<Difference> difference, const System& system, Phase phase,
                      const std::string& rule) {
  if (!difference || found_)
    return;
  difference->rule = fmt::format("{} in {} {}", system.name(), phase_name(phase), rule);
  found_ = std::move(difference);
}

void WriteCheck::compare_columns(const World& world, const System& system, Phase phase) {
  const Schema& schema = world.schema();
  for (std::uint32_t index = 0; index < schema.columns().size(); ++index) {
    const ColumnInfo& column = schema.column(index);
    const auto& own = schema.table(column.table).columns;
    if (phase == Phase::commit && index == own[1])
      continue;  // the marks of those who leave
    const WrittenBy here{system.name(), phase};
    const bool may = index != own[0] && index != own[1] &&
                     (!column.writers || std::find(column.writers->begin(), column.writers->end(),
                                                   here) != column.writers->end());
    if (may && (is_serial(phase) || column.table == system.table()))
      continue;
    const std::string rule =
        may ? "writes a row of another table"
            : "writes what is written " + (column.writers ? writers_text(column) : "by nobody");
    note(first_difference(before_, world, index), system, phase, rule);
  }
}

void WriteCheck::end(const World& world, const System& system, Phase phase) {
  compare_columns(world, system, phase);
}

void WriteCheck::end(const World& world, const System& system, Phase phase,
                     const std::function<void(World&, Chunk)>& again) {
  compare_columns(world, system, phase);
  const std::size_t rows = world.rows(system.table());
  const auto& columns = world.schema().table(system.table()).columns;
  for (std::size_t row = rows; row-- > 0;) {
    const bool looked_at = row == world.step() % rows;
    if (looked_at)
      last_ = before_;
    again(before_, {row, row + 1});
    if (!looked_at)
      continue;
    for (const std::uint32_t index : columns) {
      const auto mine = std::as_const(before_).bytes(ByteColumn{index}, row);
      std::memcpy(last_.bytes(ByteColumn{index}, row).data(), mine.data(), mine.size());
    }
    note(first_difference(last_, before_), system, phase,
         fmt::format("writes another row than its own, {}", row));
  }
  note(first_difference(world, before_), system, phase,
       "reads what another row writes then: it differs with the order of the rows");
}

}  // namespace eyrie::sim
