// SPDX-License-Identifier: MIT
#include "record/sink.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace eyrie::record {

Sink::Sink(const std::string& path) : path_(path), file_(std::fopen(path.c_str(), "wb")) {
  if (!file_)
    fail();
}

void Sink::write(std::string_view bytes) {
  if (file_ && std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size())
    fail();
}

bool Sink::close() {
  if (file_ && std::fclose(file_.release()) != 0)
    fail();
  return error_.empty();
}

void Sink::fail() {
  error_ = fmt::format("cannot write '{}': {}", path_, std::strerror(errno));
  file_.reset();
}

}  // namespace eyrie::record
