// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace eyrie::scenario {

/// Why a file is no whole shared library (ELF, for this machine), in words; empty if it is one. The
/// dynamic linker believes what stands in a file and is killed by what is cut short. Checked is
/// what it believes: every segment, every section and every table of the dynamic segment lies
/// inside the file. System V ABI (gABI 4.1), chapters 4 and 5.
[[nodiscard]] std::string shared_object_problem(std::string_view file);

}  // namespace eyrie::scenario
