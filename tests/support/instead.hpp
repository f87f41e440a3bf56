// SPDX-License-Identifier: MIT
#pragma once
#include "disk/file_system.hpp"

namespace eyrie::disk {

/// While this lives, `other` is the table of calls in use.
class Instead {
 public:
  explicit Instead(FileSystem& other) : before_(use_files(&other)) {}
  ~Instead() { use_files(before_); }
  Instead(const Instead&) = delete;
  Instead& operator=(const Instead&) = delete;

 private:
  FileSystem* before_;
};

}  // namespace eyrie::disk
