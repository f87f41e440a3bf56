// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a text from outside may hold: names that machines use, and text that people read.
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace eyrie {

/// An identifier is what trees, models, flights and folders are called by: ASCII letters, digits
/// and '_', and inside '-' and '.'; it begins with a letter or a digit, or with '_'.
[[nodiscard]] bool is_identifier(std::string_view text);
inline constexpr std::size_t kLongestIdentifier = 64;
/// What is wrong with an identifier, in words, the text quoted; nothing if it is one.
[[nodiscard]] std::optional<std::string> identifier_problem(std::string_view text);

/// What keeps a text from being shown to people, in words: what printable() would escape. Nothing
/// if there is none.
[[nodiscard]] std::optional<std::string> text_problem(std::string_view text);
/// Of UTF-8; bytes that are none count one each.
[[nodiscard]] std::size_t characters(std::string_view text);

/// A name for a file or folder, made from any text: letters, digits, '.', '_' and '-' stay, any
/// others in a row become one '-'. It begins with a letter, a digit or '_', has at most
/// kLongestIdentifier bytes, and is never empty.
[[nodiscard]] std::string file_name_from(std::string_view text);

}  // namespace eyrie
