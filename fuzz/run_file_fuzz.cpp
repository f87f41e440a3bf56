// SPDX-License-Identifier: MIT
/// \file  Any bytes as a run file: never a crash, an error or a run but not both, and a run that
/// was accepted comes back from its own encoding. Each input is read as it is, and once more with a
/// checksum that fits, or nothing behind that would ever be reached.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "core/hash.hpp"
#include "record/run_file.hpp"

namespace {

using namespace eyrie;

void demand(bool condition) {
  if (!condition)
    std::abort();
}

void check(std::string_view bytes) {
  const record::Decoded decoded = record::decode(bytes);
  if (!decoded.error.empty()) {
    demand(decoded.error.size() < 1000);
    return;
  }
  const record::Decoded again = record::decode(record::encode(decoded.run));
  demand(again.error.empty() && again.run == decoded.run);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  check(bytes);
  if (size < sizeof(std::uint64_t))
    return 0;
  const std::size_t body = size - sizeof(std::uint64_t);
  const std::uint64_t sum = hash_bytes(std::as_bytes(std::span<const char>(bytes.data(), body)));
  std::memcpy(bytes.data() + body, &sum, sizeof sum);
  check(bytes);
  return 0;
}
