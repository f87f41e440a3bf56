// SPDX-License-Identifier: MIT
#pragma once
/// \file  The folder of one run: written beside its final place and moved there when it is
/// complete.
#include <memory>
#include <optional>
#include <string>

#include "disk/sink.hpp"
#include "record/acmi.hpp"
#include "record/events_csv.hpp"
#include "record/run_file.hpp"

namespace eyrie::app {

/// A folder that does not exist until commit(): what is left of a failed run is removed.
class OutputFolder {
 public:
  /// `wanted` may be empty: then runs/<name>-<seed>, or that with the next free number behind it.
  /// Throws std::runtime_error with words if the place is taken (and not `force`) or unwritable.
  OutputFolder(const std::string& wanted, const std::string& name, std::uint64_t seed, bool force);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where a file goes while the run is being flown.
  [[nodiscard]] std::string file(const std::string& name) const { return staging_ + "/" + name; }
  /// Where the folder will be.
  [[nodiscard]] const std::string& path() const { return path_; }
  /// Moves everything to its place. Throws std::runtime_error if that fails.
  void commit();

 private:
  std::string path_, staging_;
  bool force_ = false, done_ = false;
};

/// A file that does not exist, or is as it was, until commit(): what is left of a failed one is
/// removed.
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  [[nodiscard]] disk::Sink& sink() { return sink_; }
  /// Closes it and moves it to its place; false after saying why not.
  [[nodiscard]] bool commit();

 private:
  std::string path_, part_;
  disk::Sink sink_;
};

/// `wanted`, or `otherwise` if it is empty; nothing after saying that `wanted` is there already and
/// may not be replaced.
[[nodiscard]] std::optional<std::string> free_or_complain(const std::string& wanted,
                                                          const std::string& otherwise, bool force);

}  // namespace eyrie::app
