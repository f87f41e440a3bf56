// SPDX-License-Identifier: MIT
/// \file  Any bytes as a run file: never a crash, an error or a run but not both, a run that was
/// accepted comes back from its own encoding, and its trail ends where it says. The mutator changes
/// a part of a run (a text, the orders, the bytes of the trail, a whole new trail) or any byte, and
/// makes the checksum fit, or nothing behind that would ever be reached.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <random>
#include <span>
#include <string>
#include <string_view>

#include "core/hash.hpp"
#include "fuzz/demand.hpp"
#include "record/run_file.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using namespace eyrie;
using fuzz::demand;
using Random = std::minstd_rand;

std::string signed_again(std::string bytes) {
  if (bytes.size() < sizeof(std::uint64_t))
    return bytes;
  const std::size_t body = bytes.size() - sizeof(std::uint64_t);
  const std::uint64_t sum = hash_bytes(std::as_bytes(std::span<const char>(bytes.data(), body)));
  std::memcpy(bytes.data() + body, &sum, sizeof sum);
  return bytes;
}

std::string mutated(std::string bytes) {
  const std::size_t size = bytes.size();
  bytes.resize(size + 64);
  bytes.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(bytes.data()), size, bytes.size()));
  return bytes;
}

/// Some seconds of a run in which players are born and lost.
std::string any_trail(Random& random) {
  sim::TrailPacker packer(50);
  sim::Mark mark;
  mark.digest.fields.resize(random() % 40);
  for (std::uint64_t left = random() % 6 + 1; left > 0; --left) {
    mark.hash = random();
    for (std::uint16_t& field : mark.digest.fields)
      if (random() % 4 == 0)
        field = static_cast<std::uint16_t>(random());
    if (random() % 2 == 0)
      mark.digest.rows.resize(random() % 5);
    for (sim::Digest::Row& row : mark.digest.rows)
      row = {.table = static_cast<std::uint32_t>(random() % 4),
             .player = PlayerId{static_cast<std::uint32_t>(random() % 300)},
             .hash = static_cast<std::uint16_t>(random())};
    packer.mark(mark);
    for (std::uint64_t steps = random() % 99 + 1; steps > 0; --steps)
      if (++mark.step; packer.is_fold(mark.step))
        packer.fold(static_cast<std::uint16_t>(random()));
  }
  return packer.take();
}

void change_a_part(record::RunFile& run, Random& random) {
  switch (random() % 9) {
    case 0:
      run.trail.spans = any_trail(random);
      break;
    case 1:
      run.trail.steps_per_second = static_cast<std::uint32_t>(random() % 2 ? random() : 50);
      break;
    case 2:
      run.orders.resize(random() % 4);
      for (sim::Order& order : run.orders)
        order.step = random();
      break;
    case 3:
      run.sets.push_back(mutated(run.sets.empty() ? "seed=1" : run.sets.back()));
      break;
    case 4:
      run.files[mutated(run.scenario)] = mutated("eyrie: 1\n");
      break;
    case 5:
      run.plugins.push_back({mutated("libmine.so"), random()});
      break;
    case 6:
      run.outcome = mutated(run.outcome);
      break;
    default:
      run.trail.spans = mutated(run.trail.spans);
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  Random random(seed);
  std::string bytes(reinterpret_cast<const char*>(data), size);
  record::Decoded decoded = record::decode(bytes);
  if (decoded.error.empty() && random() % 4 != 0) {
    change_a_part(decoded.run, random);
    bytes = record::encode(decoded.run);
  } else {
    bytes = random() % 8 == 0 ? mutated(bytes) : signed_again(mutated(bytes));
  }
  size = std::min(bytes.size(), most);
  std::memcpy(data, bytes.data(), size);
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const record::Decoded decoded = record::decode({reinterpret_cast<const char*>(data), size});
  if (!decoded.error.empty()) {
    demand(decoded.error.size() < 1000);
    return 0;
  }
  const record::Decoded again = record::decode(record::encode(decoded.run));
  demand(again.error.empty() && again.run == decoded.run);

  const sim::HashTrail& trail = decoded.run.trail;
  sim::TrailUnpacker span(trail.spans, trail.steps_per_second);
  std::uint64_t last = 0;
  unsigned folds = 0;
  while (span.next()) {
    demand(span.mark().step >= last);
    for (; last < span.mark().step && ++folds < 1000; ++last)
      if (span.has_fold(last + 1))
        static_cast<void>(span.fold(last + 1));
    last = span.mark().step;
  }
  demand(span.ok() && span.mark().step == trail.last_step && span.mark().hash == trail.last_hash);
  return 0;
}
