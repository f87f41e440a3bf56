// SPDX-License-Identifier: MIT
#pragma once
/// \file  A campaign flown in parts, each into a folder of its own by a process that knows nothing
/// of the others, until they are joined.
#include "campaign/store.hpp"

namespace eyrie::campaign {

/// "DIR/part_3_of_16"
[[nodiscard]] std::string part_folder(const std::string& folder, const Part& part);

/// Of how many parts there are some in this folder; 0: there is none. Throws disk::Refused if they
/// are of different numbers.
[[nodiscard]] std::uint64_t parts_in(const std::string& folder);

/// The folders of all parts, for Store::join. Throws disk::Refused that names those which have not
/// flown all, or if one was begun with another origin.
[[nodiscard]] std::vector<std::string> whole_parts(const std::string& folder, const Spec& spec,
                                                   std::size_t cells, const Origin& origin);

}  // namespace eyrie::campaign
