// SPDX-License-Identifier: MIT
#pragma once
/// \file  For tests only: small files of networks.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace eyrie::pilot::testing {

/// Weights that are exact in binary: ((k + seed) 37 mod 101 - 50) / 128.
inline std::vector<float> weights(std::size_t count, std::size_t seed) {
  std::vector<float> numbers(count);
  for (std::size_t k = 0; k < count; ++k)
    numbers[k] = (static_cast<float>((k + seed) * 37 % 101) - 50.0F) / 128.0F;
  return numbers;
}

/// A file of tensors being put together.
class Safetensors {
 public:
  Safetensors& word(const std::string& name, std::string_view text) {
    std::string json;
    for (const char c : text)
      json += c == '\n' ? std::string("\\n") : std::string(1, c);
    words_ += fmt::format("{}\"{}\":\"{}\"", words_.empty() ? "" : ",", name, json);
    return *this;
  }
  Safetensors& tensor(const std::string& name, const std::vector<std::size_t>& shape,
                      const std::vector<float>& numbers, std::string_view type = "F32") {
    const std::size_t begin = data_.size(), size = numbers.size() * sizeof(float);
    data_.resize(begin + size);
    std::memcpy(data_.data() + begin, numbers.data(), size);
    tensors_ += fmt::format(",\"{}\":{{\"dtype\":\"{}\",\"shape\":[{}],\"data_offsets\":[{},{}]}}",
                            name, type, fmt::join(shape, ","), begin, begin + size);
    return *this;
  }
  /// torch.nn.Linear with weights(..., seed).
  Safetensors& linear(const std::string& name, std::size_t in, std::size_t out, std::size_t seed) {
    return tensor(name + ".weight", {out, in}, weights(out * in, seed))
        .tensor(name + ".bias", {out}, weights(out, seed + 1));
  }
  /// torch.nn.GRU (3 gates) or LSTM (4) with weights(..., seed).
  Safetensors& recurrent(const std::string& name, std::size_t gates, std::size_t in,
                         std::size_t out, std::size_t seed) {
    const std::size_t sums = gates * out;
    return tensor(name + ".weight_ih_l0", {sums, in}, weights(sums * in, seed))
        .tensor(name + ".bias_ih_l0", {sums}, weights(sums, seed + 1))
        .tensor(name + ".weight_hh_l0", {sums, out}, weights(sums * out, seed + 2))
        .tensor(name + ".bias_hh_l0", {sums}, weights(sums, seed + 3));
  }
  [[nodiscard]] std::string bytes() const {
    return of_header(fmt::format("{{\"__metadata__\":{{{}}}{}}}", words_, tensors_), data_);
  }
  [[nodiscard]] static std::string of_header(const std::string& header, const std::string& data) {
    std::string length(8, '\0');
    for (std::size_t i = 0; i < 8; ++i)
      length[i] = static_cast<char>(header.size() >> (8 * i) & 255);
    return length + header + data;
  }

 private:
  std::string words_, tensors_, data_;
};

/// A policy that sees seven numbers and turns, climbs, and shoots.
inline Safetensors small_policy() {
  Safetensors file;
  file.word("eyrie_policy", "1")
      .word("observation",
            "range linear 0 nmi 40 nmi\ntarget_right sine\ntarget_right cosine\n"
            "target_up linear -90 deg 90 deg\nspeed linear 100 m/s 500 m/s\n"
            "altitude linear 0 m 15 km\nin_zone linear 0 1\n")
      .word("controls",
            "turn -90 deg 90 deg\nclimb -30 deg 30 deg\nspeed 150 m/s 400 m/s\nrelease\n");
  return file;
}
/// The same with a network of three layers, the one in the middle with memory.
inline std::string small_policy_file() {
  return small_policy()
      .word("network", "linear first tanh\ngru memory\nlinear head tanh\n")
      .linear("first", 7, 12, 1)
      .recurrent("memory", 3, 12, 10, 5)
      .linear("head", 10, 4, 9)
      .bytes();
}

}  // namespace eyrie::pilot::testing
