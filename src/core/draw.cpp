// SPDX-License-Identifier: MIT
#include "core/draw.hpp"

#include <Random123/philox.h>

#include "core/angle.hpp"
#include "core/assert.hpp"
#include "core/math.hpp"

namespace eyrie {
namespace {

constexpr std::uint32_t low32(std::uint64_t word) {
  return static_cast<std::uint32_t>(word);
}
constexpr std::uint32_t high32(std::uint64_t word) {
  return static_cast<std::uint32_t>(word >> 32);
}

constexpr std::uint32_t kNextBlock = 1u << 16;  // the top 16 bits of the last word count blocks

}  // namespace

Draw::Draw(std::uint64_t seed, PlayerId who, Stream stream, std::uint64_t step, std::uint32_t index)
    : counter_{who.value, static_cast<std::uint32_t>(stream) << 24 | index, low32(step),
               high32(step)},
      key_{low32(seed), high32(seed)} {
  EYRIE_ASSERT(index < 1u << 24);
  EYRIE_ASSERT(step < std::uint64_t{1} << 48);
}

std::uint64_t Draw::bits() {
  if (left_ == 0) {
    EYRIE_ASSERT(!used_up_);
    const philox4x32_ctr_t counter{{counter_[0], counter_[1], counter_[2], counter_[3]}};
    const philox4x32_key_t key{{key_[0], key_[1]}};
    const philox4x32_ctr_t out = philox4x32(counter, key);
    block_ = {out.v[2] | std::uint64_t{out.v[3]} << 32, out.v[0] | std::uint64_t{out.v[1]} << 32};
    left_ = 2;
    counter_[3] += kNextBlock;
    used_up_ = counter_[3] < kNextBlock;
  }
  return block_[--left_];
}

double Draw::uniform() {
  return static_cast<double>(bits() >> 11) * 0x1p-53;
}

double Draw::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(-2 * math::log(1 - uniform()));
  const auto [sin, cos] = math::sin_cos(kTau * uniform());
  spare_ = radius * sin;
  has_spare_ = true;
  return radius * cos;
}

}  // namespace eyrie
