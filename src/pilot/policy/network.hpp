// SPDX-License-Identifier: MIT
#pragma once
/// \file  Neural networks of learned behaviors: layers one behind the other, in single precision,
/// with the same bits on every machine.
#include <set>
#include <span>

#include "core/enum_names.hpp"
#include "pilot/policy/tensors.hpp"

namespace eyrie::pilot {

class LayoutLine;

/// What a layer makes of each of its sums.
enum class Activation : std::uint8_t { none, tanh, relu, silu, sigmoid };
constexpr auto names_of(Activation) {
  return names_from_zero<Activation>("none", "tanh", "relu", "silu", "sigmoid");
}

enum class LayerKind : std::uint8_t { linear, gru, lstm };
constexpr auto names_of(LayerKind) {
  return names_from_zero<LayerKind>("linear", "gru", "lstm");
}

/// Sums of weighted numbers, W x + b. Each sum begins with its b and adds in the order of x.
class Sums {
 public:
  static constexpr std::size_t kBlock = 16;  ///< sums that are made side by side

  Sums() = default;
  /// `weights`: a row for each sum, `bias`: one for each.
  Sums(std::span<const float> weights, std::span<const float> bias);

  /// Writes the sums to `out`, and zeros behind them up to a multiple of kBlock and four more.
  void of(const float* x, float* out) const;
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t padded() const { return (size_ + kBlock - 1) / kBlock * kBlock; }

 private:
  std::size_t inputs_ = 0, size_ = 0;
  std::vector<float> bias_;     ///< padded
  std::vector<float> weights_;  ///< [block][input][sum of the block]
};

/// Layers as PyTorch keeps them. As text a line for each, the name of the layer behind its kind, an
/// activation behind the name:
///
///   linear trunk.0 tanh      trunk.0.weight [out, in], trunk.0.bias [out]
///   gru memory               memory.weight_ih_l0 [3 out, in], weight_hh_l0 [3 out, out],
///                            bias_ih_l0 and bias_hh_l0 [3 out]; gates r, z, n
///   lstm memory              the same with 4 out; gates i, f, g, o
///   linear head
///
/// torch.nn.Linear, GRU and LSTM: https://pytorch.org/docs/stable/nn.html has the equations.
class Network {
 public:
  static constexpr std::size_t kMostLayers = 16;
  static constexpr std::size_t kMostUnits = 1024;  ///< of one layer, and inputs

  Network() = default;
  /// Nothing after reporting what is wrong: a layer that is not there, shapes that do not fit each
  /// other, numbers that are not finite. `where`: of `text`.
  [[nodiscard]] static std::optional<Network> read(std::string_view text, const Location& where,
                                                   std::size_t inputs, const TensorFile& tensors,
                                                   Diagnostics& diagnostics);

  [[nodiscard]] std::size_t inputs() const { return inputs_; }
  [[nodiscard]] std::size_t outputs() const { return layers_.empty() ? 0 : layers_.back().out; }
  /// Numbers that it remembers from one evaluation to the next; zero when fresh.
  [[nodiscard]] std::size_t memory() const { return memory_; }

  /// One evaluation. Allocates nothing.
  void evaluate(std::span<const float> in, std::span<float> memory, std::span<float> out) const;

 private:
  struct Layer {
    LayerKind kind = LayerKind::linear;
    Activation activation = Activation::none;
    std::size_t out = 0;
    std::size_t memory = 0;  ///< where its memory begins
    Sums sums, recurrent;    ///< of its inputs, of its memory
  };
  static std::optional<Layer> read_layer(LayoutLine& line, std::size_t inputs,
                                         const TensorFile& tensors, std::set<std::string>& names,
                                         Diagnostics& diagnostics);

  std::size_t inputs_ = 0, memory_ = 0;
  std::vector<Layer> layers_;
};

}  // namespace eyrie::pilot
