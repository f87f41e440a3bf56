// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace eyrie {

/// Rows per piece of work. A constant, never rows / workers: what a chunk computes, and the order
/// in which the results of chunks are combined, must not depend on how many workers there are.
inline constexpr std::size_t kChunk = 256;

/// How many chunks so many rows make.
[[nodiscard]] constexpr std::size_t chunk_count(std::size_t rows) {
  return (rows + kChunk - 1) / kChunk;
}

/// A pool of threads that live as long as it does, spin a little for the next phase of a step and
/// sleep when there is none. The calling thread works too, so one worker means no thread at all.
class Executor {
 public:
  /// At least 1 and at most 256 workers, the calling thread included; otherwise std::logic_error.
  explicit Executor(unsigned workers = 1);
  ~Executor();
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  [[nodiscard]] unsigned workers() const;

  /// Calls fn(chunk, begin, end) once for every chunk of the rows [0, rows), in any order and on
  /// any worker, and returns when all are done; whatever the calls wrote is then visible. One
  /// chunk, or one worker, runs in the calling thread, in order. Allocates nothing. `fn` must not
  /// throw (that ends the program), and with more than one worker must not call for_chunks of the
  /// same executor.
  template <class Fn>
  void for_chunks(std::size_t rows, Fn&& fn) const {
    using Callable = std::remove_reference_t<Fn>;
    if (pool_ == nullptr || rows <= kChunk) {
      const auto run_all = [&]() noexcept {
        for (std::size_t chunk = 0, begin = 0; begin < rows; ++chunk, begin += kChunk)
          fn(chunk, begin, std::min(rows, begin + kChunk));
      };
      run_all();
      return;
    }
    run({[](void* context, std::size_t chunk, std::size_t begin, std::size_t end) noexcept {
           (*static_cast<Callable*>(context))(chunk, begin, end);
         },
         const_cast<void*>(static_cast<const void*>(std::addressof(fn))), rows});
  }

 private:
  struct Job {
    void (*call)(void* context, std::size_t chunk, std::size_t begin, std::size_t end) noexcept;
    void* context;
    std::size_t rows;
  };
  struct Pool;

  void run(const Job& job) const;

  std::unique_ptr<Pool> pool_;  ///< none with a single worker
};

}  // namespace eyrie
