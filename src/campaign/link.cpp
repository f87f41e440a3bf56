// SPDX-License-Identifier: MIT
#include "campaign/link.hpp"

#include <dlfcn.h>

#include <cstdlib>

#include "disk/file_system.hpp"

namespace eyrie::campaign {
namespace {

class Mpi final : public Link {
 public:
  explicit Mpi(const MpiCalls& calls) : calls_(calls) {}
  ~Mpi() override {
    for (int other = 1; rank() == 0 && other < size(); ++other)
      send(other, {});
    for (Nap nap; rank() != 0 && !done_;)
      nap.after(receive().has_value());
    calls_.end();
  }
  int rank() const override { return calls_.rank; }
  int size() const override { return calls_.size; }
  void send(int to, std::string_view bytes) override {
    calls_.send(to, bytes.data(), static_cast<int>(bytes.size()));
  }
  std::optional<Message> receive() override {
    Message message;
    const int count = calls_.poll(&message.from);
    if (count < 0)
      return std::nullopt;
    message.bytes.resize(static_cast<std::size_t>(count));
    calls_.receive(message.from, message.bytes.data(), count);
    done_ = count == 0;
    return message;
  }

 private:
  const MpiCalls& calls_;
  bool done_ = false;  ///< rank 0 has said so
};

}  // namespace

std::unique_ptr<Link> open_mpi(const std::string& library) {
  // Open MPI; whatever starts processes by PMIx; MPICH and its kin
  const char* started = nullptr;
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
    if (!started && std::getenv(name))
      started = name;
  if (!started)
    return nullptr;
  const auto refuse = [&](const std::string& why) {
    throw disk::Refused(
        "mpirun has started this ({} is set), but {}; docs/campaigns.md says what to install",
        started, why);
  };
  if (library.empty())
    refuse("libeyrie_mpi.so is not beside the program");
  void* opened = ::dlopen(library.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (!opened)
    refuse(::dlerror());
  using Open = const MpiCalls* (*)();
  const auto open = reinterpret_cast<Open>(::dlsym(opened, "eyrie_mpi_open"));
  const MpiCalls* calls = open ? open() : nullptr;
  if (!calls || calls->version != kMpiCalls)
    refuse(library + " belongs to another version");
  return std::make_unique<Mpi>(*calls);
}

}  // namespace eyrie::campaign
