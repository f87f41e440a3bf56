// SPDX-License-Identifier: MIT
#pragma once
/// \file  The list of questions: from it come their dispatch and the TypeScript declaration.
#include <string>
#include <string_view>

#include "web/engine.hpp"

namespace eyrie::web {

/// Answers one request in JSON. `bytes` are those that came with it, and afterwards those that go
/// with the answer. Never throws but for a lack of memory.
[[nodiscard]] std::string answer(Engine& engine, std::string_view request, std::string& bytes);

/// viewer/src/engine.d.ts.
[[nodiscard]] std::string declarations();

}  // namespace eyrie::web
