// SPDX-License-Identifier: MIT
#pragma once
/// \file  A file that is not there, or is as it was, until it is complete.
#include <optional>
#include <string>

#include "disk/sink.hpp"
#include "disk/temporary.hpp"

namespace eyrie::disk {

class OutputFile {
 public:
  /// `replace`: a file that is there may be replaced; never anything else than a file. Throws
  /// Refused if that place cannot be used, Failed if nothing can be written there. A new file gets
  /// `mode` as the umask allows; one that is replaced hands its mode on.
  OutputFile(const std::string& path, bool replace, mode_t mode = 0666);

  [[nodiscard]] Sink& sink() { return sink_; }
  /// Until everything is on the disk; then it is put in its place. Throws Failed, and then the
  /// place is as it was.
  void commit();

 private:
  Place place_;
  bool replace_;
  mode_t mode_;
  std::optional<struct stat> before_;
  Temporary part_;
  Sink sink_;
};

}  // namespace eyrie::disk
