// SPDX-License-Identifier: MIT
#pragma once
/// \file  An open file or folder that is closed when nobody needs it any more.
#include <utility>

#include "disk/file_system.hpp"

namespace eyrie::disk {

class Handle {
 public:
  Handle() = default;
  explicit Handle(int file) : file_(file) {}
  ~Handle() {
    if (file_ >= 0)
      files().close(file_);
  }
  Handle(Handle&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }

  [[nodiscard]] int get() const { return file_; }
  explicit operator bool() const { return file_ >= 0; }

 private:
  int file_ = -1;
};

}  // namespace eyrie::disk
