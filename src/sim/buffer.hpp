// SPDX-License-Identifier: MIT
#pragma once
/// \file  A fixed block of zeroed, cache-line aligned bytes that copies as a value.
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <utility>

namespace eyrie::sim {

/// Bytes on a 64-byte boundary. Assigning a block of the same size is one memcpy into the bytes
/// that are already there: no allocation, and pointers into it stay good.
class Buffer {
 public:
  static constexpr std::size_t kAlignment = 64;

  Buffer() = default;
  explicit Buffer(std::size_t size) : size_(size), bytes_(allocate(size)) {
    if (size_ != 0)
      std::memset(bytes_.get(), 0, size_);
  }
  Buffer(const Buffer& other) : size_(other.size_), bytes_(allocate(other.size_)) { copy(other); }
  Buffer& operator=(const Buffer& other) {
    if (this == &other)
      return *this;
    if (size_ != other.size_)
      *this = Buffer(other);
    else
      copy(other);
    return *this;
  }
  Buffer(Buffer&& other) noexcept
      : size_(std::exchange(other.size_, 0)), bytes_(std::move(other.bytes_)) {}
  Buffer& operator=(Buffer&& other) noexcept {
    size_ = std::exchange(other.size_, 0);
    bytes_ = std::move(other.bytes_);
    return *this;
  }
  ~Buffer() = default;

  [[nodiscard]] std::byte* data() { return bytes_.get(); }
  [[nodiscard]] const std::byte* data() const { return bytes_.get(); }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  struct Free {
    void operator()(std::byte* bytes) const {
      ::operator delete (bytes, std::align_val_t{kAlignment});
    }
  };
  using Bytes = std::unique_ptr<std::byte[], Free>;

  static Bytes allocate(std::size_t size) {
    if (size == 0)
      return nullptr;
    return Bytes(static_cast<std::byte*>(::operator new (size, std::align_val_t{kAlignment})));
  }
  void copy(const Buffer& other) {
    if (size_ != 0)
      std::memcpy(bytes_.get(), other.bytes_.get(), size_);
  }

  std::size_t size_ = 0;
  Bytes bytes_;
};

}  // namespace eyrie::sim
