// SPDX-License-Identifier: MIT
#pragma once
/// \file  Decisions as CSV, plain or compressed.
#include <memory>

#include "disk/sink.hpp"
#include "tables/decision_rows.hpp"

namespace eyrie::tables {

/// Text that goes into a file, as a gzip stream (RFC 1952) if that is wanted. The same text gives
/// the same bytes.
class TextFile {
 public:
  TextFile(disk::Sink& sink, bool compressed);
  ~TextFile();

  void write(std::string_view text);
  void finish();

 private:
  struct Stream;
  disk::Sink& sink_;
  std::unique_ptr<Stream> stream_;  ///< null: plain
};

/// A row for each decision: when, whose, by which tree, who led, and every field of the action.
/// `stop` is asked in every step; false if it ended the work.
bool write_decisions(const debrief::Recorded& recorded, const Selection& selection, TextFile& file,
                     const std::function<bool()>& stop);
/// A row for each interval of decisions in which a node answered the same.
bool write_answers(const debrief::Recorded& recorded, const Selection& selection, TextFile& file,
                   const std::function<bool()>& stop);

}  // namespace eyrie::tables
