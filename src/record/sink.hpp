// SPDX-License-Identifier: MIT
#pragma once
/// \file  A file that remembers whether everything was written.
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace eyrie::record {

/// Buffered output to one file. After the first failure nothing more is written and error() says
/// why; so a full disk is noticed, whoever wrote last.
class Sink {
 public:
  explicit Sink(const std::string& path);

  void write(std::string_view bytes);
  /// Flushes and closes. False if anything was lost.
  bool close();

  [[nodiscard]] const std::string& path() const { return path_; }
  /// "cannot write 'x': No space left on device", or "".
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  struct Close {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  void fail();

  std::string path_, error_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace eyrie::record
