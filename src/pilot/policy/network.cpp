// SPDX-License-Identifier: MIT
#include "pilot/policy/network.hpp"

#include <algorithm>
#include <cmath>

#include "core/assert.hpp"
#include "core/math_float.hpp"
#include "pilot/policy/layout.hpp"

namespace eyrie::pilot {
namespace {

using math::Four, math::four, math::load_four, math::store_four;

/// Gates of the largest layer, and room for whole blocks.
using Wide = std::array<float, 4 * Network::kMostUnits + Sums::kBlock>;

Four activated(Activation activation, const Four& x) {
  switch (activation) {
    case Activation::tanh:
      return math::tanh(x);
    case Activation::relu:
      return math::pick(math::less(x, four(0)), four(0), x);
    case Activation::silu:
      return x * math::sigmoid(x);
    case Activation::sigmoid:
      return math::sigmoid(x);
    case Activation::none:
      break;
  }
  return x;
}

/// Calls `of(i)` for 0, 4, 8 ... and stores what it gives at `to`, `count` numbers in all.
template <class Of>
void by_fours(std::size_t count, float* to, Of of) {
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4)
    store_four(to + i, of(i));
  if (i == count)
    return;
  const Four last = of(i);
  std::memcpy(to + i, &last, (count - i) * sizeof(float));
}

/// h = (1 - z) n + z h, of `in` and `own`, the gates r, z and n of input and memory.
void gru(std::size_t units, const float* in, const float* own, float* h) {
  const std::size_t z_at = units, n_at = 2 * units;
  by_fours(units, h, [&](std::size_t i) {
    const Four r = math::sigmoid(load_four(in + i) + load_four(own + i));
    const Four z = math::sigmoid(load_four(in + z_at + i) + load_four(own + z_at + i));
    const Four n = math::tanh(load_four(in + n_at + i) + r * load_four(own + n_at + i));
    Four before{};
    std::memcpy(&before, h + i, std::min<std::size_t>(4, units - i) * sizeof(float));
    return (1.0F - z) * n + z * before;
  });
}

/// c = f c + i g and h = o tanh(c), of `in` and `own`, the gates i, f, g and o of input and memory.
void lstm(std::size_t units, const float* in, const float* own, float* h, float* c) {
  const auto gate = [&](std::size_t number, std::size_t i) {
    return load_four(in + number * units + i) + load_four(own + number * units + i);
  };
  by_fours(units, c, [&](std::size_t i) {
    Four before{};
    std::memcpy(&before, c + i, std::min<std::size_t>(4, units - i) * sizeof(float));
    return math::sigmoid(gate(1, i)) * before + math::sigmoid(gate(0, i)) * math::tanh(gate(2, i));
  });
  by_fours(units, h, [&](std::size_t i) {
    Four now{};
    std::memcpy(&now, c + i, std::min<std::size_t>(4, units - i) * sizeof(float));
    return math::sigmoid(gate(3, i)) * math::tanh(now);
  });
}

/// The numbers of a tensor of that shape; nothing after reporting. A dimension of 0 may be any.
std::optional<std::vector<float>> numbers(const TensorFile& tensors, const std::string& name,
                                          std::vector<std::size_t> shape,
                                          Diagnostics& diagnostics) {
  const Tensor* tensor = tensors.find(name);
  const auto wrong = [&](std::string what) {
    return diagnostics.error({tensors.file()}, std::move(what));
  };
  if (!tensor)
    return wrong(
        fmt::format("there is no tensor {}{}", quote(name), did_you_mean(name, tensors.names())));
  if (tensor->type != "F32")
    return wrong(fmt::format("tensor {}: expected numbers of type F32, found {}", quote(name),
                             quote(tensor->type)));
  bool fits = tensor->shape.size() == shape.size();
  for (std::size_t i = 0; fits && i < shape.size(); ++i)
    fits = shape[i] == 0 || tensor->shape[i] == shape[i];
  if (!fits) {
    std::string expected = Tensor{.shape = shape}.shape_text();
    if (const std::size_t any = expected.find("[0,"); any != expected.npos)
      expected.replace(any, 3, "[any,");
    return wrong(fmt::format("tensor {}: expected the shape {}, found {}", quote(name), expected,
                             tensor->shape_text()));
  }
  std::vector<float> all(tensor->bytes.size() / sizeof(float));
  static_assert(std::endian::native == std::endian::little);
  std::memcpy(all.data(), tensor->bytes.data(), all.size() * sizeof(float));
  if (!std::all_of(all.begin(), all.end(), [](float x) { return std::isfinite(x); }))
    return wrong(fmt::format("tensor {} has a number that is not finite", quote(name)));
  return all;
}

}  // namespace

Sums::Sums(std::span<const float> weights, std::span<const float> bias)
    : inputs_(weights.size() / bias.size()),
      size_(bias.size()),
      bias_(bias.begin(), bias.end()),
      weights_(padded() * inputs_) {
  bias_.resize(padded());
  for (std::size_t sum = 0; sum < size_; ++sum)
    for (std::size_t i = 0; i < inputs_; ++i)
      weights_[sum / kBlock * kBlock * inputs_ + i * kBlock + sum % kBlock] =
          weights[sum * inputs_ + i];
}

void Sums::of(const float* x, float* out) const {
  const float* weights = weights_.data();
  for (std::size_t block = 0; block < bias_.size(); block += kBlock) {
    const float* bias = bias_.data() + block;
    Four a = load_four(bias), b = load_four(bias + 4), c = load_four(bias + 8),
         d = load_four(bias + 12);
    for (std::size_t i = 0; i < inputs_; ++i, weights += kBlock) {
      const Four xi = four(x[i]);
      a += load_four(weights) * xi;
      b += load_four(weights + 4) * xi;
      c += load_four(weights + 8) * xi;
      d += load_four(weights + 12) * xi;
    }
    store_four(out + block, a);
    store_four(out + block + 4, b);
    store_four(out + block + 8, c);
    store_four(out + block + 12, d);
  }
  store_four(out + bias_.size(), Four{});
}

std::optional<Network::Layer> Network::read_layer(LayoutLine& line, std::size_t inputs,
                                                  const TensorFile& tensors,
                                                  std::set<std::string>& names,
                                                  Diagnostics& diagnostics) {
  static constexpr auto kKinds = enum_names<LayerKind>();
  static constexpr auto kActivations = enum_names<Activation>();
  const std::string_view kind = line.word();
  Layer layer;
  if (const auto found = enum_named<LayerKind>(kind))
    layer.kind = *found;
  else
    return line.fail(fmt::format("expected linear, gru or lstm, got {}{}", quote(kind),
                                 did_you_mean(kind, kKinds)));
  const std::string name(line.word());
  if (name.empty())
    return line.fail("expected the name of the layer, got the end");
  if (!names.insert(name).second)  // its weights would take memory once more
    return line.fail(fmt::format("the layer {} is there already", quote(name)));
  if (layer.kind == LayerKind::linear)
    if (const std::string_view activation = line.word(); !activation.empty()) {
      const auto found = enum_named<Activation>(activation);
      if (!found)
        return line.fail(fmt::format("there is no activation {}{}", quote(activation),
                                     did_you_mean(activation, kActivations)));
      layer.activation = *found;
    }
  if (!line.end())
    return std::nullopt;

  const bool linear = layer.kind == LayerKind::linear;
  const std::size_t gates = linear ? 1 : layer.kind == LayerKind::gru ? 3 : 4;
  const std::string end = linear ? "" : "_ih_l0";
  const auto weights = numbers(tensors, name + ".weight" + end, {0, inputs}, diagnostics);
  if (!weights)
    return std::nullopt;
  const std::size_t sums = weights->size() / inputs;
  layer.out = sums / gates;
  if (layer.out == 0 || layer.out > kMostUnits || sums % gates != 0)
    return diagnostics.error({tensors.file()}, "tensor {}: {} rows make no layer of 1 to {} units",
                             quote(name + ".weight" + end), sums, kMostUnits);
  const auto bias = numbers(tensors, name + ".bias" + end, {sums}, diagnostics);
  if (!bias)
    return std::nullopt;
  layer.sums = Sums(*weights, *bias);
  if (linear)
    return layer;
  const auto own = numbers(tensors, name + ".weight_hh_l0", {sums, layer.out}, diagnostics);
  const auto own_bias = numbers(tensors, name + ".bias_hh_l0", {sums}, diagnostics);
  if (!own || !own_bias)
    return std::nullopt;
  layer.recurrent = Sums(*own, *own_bias);
  return layer;
}

std::optional<Network> Network::read(std::string_view text, const Location& where,
                                     std::size_t inputs, const TensorFile& tensors,
                                     Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.count();
  Network network;
  std::set<std::string> names;
  network.inputs_ = inputs;
  if (inputs == 0 || inputs > kMostUnits)
    diagnostics.error(where, fmt::format("a network takes 1 to {} numbers", kMostUnits));
  read_layout(text, where, diagnostics, [&](LayoutLine& line) {
    if (diagnostics.count() != before)  // the next layer depends on this one
      return;
    // before memory is taken for one more
    if (network.layers_.size() == kMostLayers) {
      line.fail(fmt::format("more than {} layers", kMostLayers));
      return;
    }
    const std::size_t fed = network.layers_.empty() ? inputs : network.outputs();
    auto layer = read_layer(line, fed, tensors, names, diagnostics);
    if (!layer)
      return;
    layer->memory = network.memory_;
    network.memory_ += layer->kind == LayerKind::linear ? 0
                       : layer->kind == LayerKind::gru  ? layer->out
                                                        : 2 * layer->out;
    network.layers_.push_back(std::move(*layer));
  });
  return diagnostics.count() == before ? std::optional(std::move(network)) : std::nullopt;
}

void Network::evaluate(std::span<const float> in, std::span<float> memory,
                       std::span<float> out) const {
  EYRIE_DEMAND(in.size() == inputs_ && memory.size() == memory_ && out.size() == outputs(),
               "a network is given what it takes");
  std::array<Wide, 2> buffers;
  Wide recurrent;
  const float* x = in.data();
  std::size_t turn = 0;
  for (const Layer& layer : layers_) {
    float* const sums = buffers[turn].data();
    turn = 1 - turn;
    layer.sums.of(x, sums);
    x = sums;
    if (layer.kind == LayerKind::linear) {
      if (layer.activation != Activation::none)
        by_fours(layer.sums.padded(), sums,
                 [&](std::size_t i) { return activated(layer.activation, load_four(sums + i)); });
      continue;
    }
    float* const h = memory.data() + layer.memory;
    layer.recurrent.of(h, recurrent.data());
    if (layer.kind == LayerKind::gru)
      gru(layer.out, sums, recurrent.data(), h);
    else
      lstm(layer.out, sums, recurrent.data(), h, h + layer.out);
    x = h;
  }
  std::copy_n(x, out.size(), out.begin());
}

}  // namespace eyrie::pilot
