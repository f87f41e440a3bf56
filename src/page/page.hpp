// SPDX-License-Identifier: MIT
#pragma once
/// \file  The pages that viewer/build.mjs makes, with what they are to show.
#include "record/run_file.hpp"

namespace eyrie::page {

/// Where a page takes its parts.
inline constexpr std::string_view kPlaceOfParts = "<!--%PARTS%-->";

/// Something that a page carries, as `<script type="application/x-eyrie-TYPE">`.
struct Part {
  std::string_view type;
  std::string data;  ///< packed(); empty: it was given up
};
/// A run file, which the engine in the page flies again: its hashes say whether it flies as it did,
/// not in which field it does not.
[[nodiscard]] Part run_file_part(const record::RunFile& run);
/// Bytes as a part: "zones", the launch zones of the shipped missiles (model::KeptZones), which the
/// engine then need not fly; "texts", what a playground is made of: a JSON object with `files`, the
/// texts by name, and `schema`; "live", a JSON object with the `scenario` and `seed` of a mission
/// that is told of at /live.
[[nodiscard]] Part part_of(std::string_view type, std::string_view bytes);
/// Whether a page has the engine in it.
[[nodiscard]] bool has_engine(std::string_view page);
/// A page with its parts; empty if it has no place for them.
[[nodiscard]] std::string page_with(std::string_view page, std::span<const Part> parts);

/// The same of a page that may talk to whoever gave it, and to nobody else.
[[nodiscard]] std::string live_page(std::string_view page, std::span<const Part> parts);

/// A zlib stream as Ascii85, a quarter longer than its bytes; 'v' stands for '<', which HTML may
/// take for its own.
[[nodiscard]] std::string packed(std::string_view bytes);
/// zlib (RFC 1950), as the browser's DecompressionStream('deflate') reads it.
[[nodiscard]] std::string deflated(std::string_view bytes);

}  // namespace eyrie::page
