// SPDX-License-Identifier: MIT
#pragma once
/// \file  Messages between the processes of a campaign. MPI stands behind it in a library of its
/// own (apps/mpi), which is opened only when mpirun has started the program: Eyrie builds and runs
/// where no MPI is installed.
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

namespace eyrie::campaign {

/// Several processes of one program, in ranks 0 to size() - 1. From one to another, messages come
/// in the order in which they were sent. When that of rank 0 is gone, the others have got an empty
/// message, and theirs have waited for it. For one thread.
class Link {
 public:
  struct Message {
    int from = 0;
    std::string bytes;
  };
  virtual ~Link() = default;
  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int size() const = 0;
  virtual void send(int to, std::string_view bytes) = 0;
  /// What has come, if anything has; does not wait.
  [[nodiscard]] virtual std::optional<Message> receive() = 0;
};

/// Between two looks at whether something has come: an eighth of the time for which nothing has.
class Nap {
 public:
  void after(bool something) {
    constexpr std::chrono::microseconds kShortest(50), kLongest(2000);
    length_ = something ? kShortest : std::min(length_ + length_ / 8, kLongest);
    if (!something)
      std::this_thread::sleep_for(length_);
  }

 private:
  std::chrono::microseconds length_{50};
};

/// What libeyrie_mpi.so has, in C: it may be built by another compiler than the program.
struct MpiCalls {
  int version;  ///< kMpiCalls
  int rank, size;
  void (*send)(int to, const char* bytes, int count);
  int (*poll)(int* from);  ///< the bytes of the next message, -1 if there is none
  void (*receive)(int from, char* bytes, int count);
  void (*end)();  ///< waits for the others
};
inline constexpr int kMpiCalls = 1;

/// The processes that mpirun has started. Null if it was not mpirun that started this one. Throws
/// disk::Refused if it was and `library` is not there or cannot be opened.
[[nodiscard]] std::unique_ptr<Link> open_mpi(const std::string& library);

}  // namespace eyrie::campaign
