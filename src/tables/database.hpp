// SPDX-License-Identifier: MIT
#pragma once
/// \file  A run as one SQLite file.
#include "tables/decision_rows.hpp"

namespace eyrie::tables {

/// Flies the run again and gives the bytes of a database with everything in it, docs/tables.md.
/// Nothing if `stop`, which is asked in every step, ended the work. The same run gives the same
/// bytes with the same version of SQLite. Text is as on a terminal, so it is UTF-8 whatever the
/// run's names are.
[[nodiscard]] std::optional<std::string> run_database(const debrief::Recorded& recorded,
                                                      const Selection& selection,
                                                      const std::function<bool()>& stop);

}  // namespace eyrie::tables
