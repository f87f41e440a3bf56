// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a campaign was begun with, against what it would go on with.
#include <map>

#include "campaign/spec.hpp"
#include "sql/database.hpp"

namespace eyrie::campaign {

using sql::Database, sql::Statement, sql::sql_name;

/// What a campaign is flown with: every file by its name, with its text or what stands for it.
using Origin = std::map<std::string, std::string>;
inline constexpr const char* kCampaignText = "the campaign";  ///< name of its file in there
inline constexpr const char* kProgramText = "the program";    ///< and of its version

/// That of a part of a campaign.
[[nodiscard]] Origin origin_of(Origin whole, const Part& part);

/// Whether a database has results; who was killed before it was begun has left no tables.
[[nodiscard]] bool begun(Database& database);

/// Throws disk::Refused with the differences if the campaign in `folder` was begun with another
/// origin: one of which what was flown is not the beginning. More replicates of each cell, or a
/// larger budget, are no difference.
void demand_the_same(Database& database, const Origin& origin, const std::string& folder);

}  // namespace eyrie::campaign
