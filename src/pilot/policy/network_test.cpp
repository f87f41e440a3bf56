// SPDX-License-Identifier: MIT
// Reference numbers: the equations of torch.nn in double precision, written down in a script.
#include "pilot/policy/network.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/hash.hpp"
#include "support/no_allocation.hpp"
#include "support/pilot/networks.hpp"

namespace eyrie::pilot {
namespace {

using pilot::testing::Safetensors;

const std::vector<float> kInput{0.5F, -1.0F, 0.25F};

std::optional<Network> read(std::string_view text, const Safetensors& file,
                            Diagnostics& diagnostics, std::size_t inputs = 3) {
  const auto tensors = TensorFile::read(file.bytes(), "net.safetensors", diagnostics);
  return tensors ? Network::read(text, {"net", 1, 1}, inputs, *tensors, diagnostics) : std::nullopt;
}
Network network(std::string_view text, const Safetensors& file) {
  Diagnostics diagnostics;
  auto read = eyrie::pilot::read(text, file, diagnostics);
  EXPECT_TRUE(read) << diagnostics.text();
  return read.value_or(Network());
}
std::string mistakes(std::string_view text, const Safetensors& file) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read(text, file, diagnostics));
  return diagnostics.text();
}

void expect_near(std::span<const float> numbers, std::initializer_list<double> wanted) {
  ASSERT_EQ(numbers.size(), wanted.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    EXPECT_NEAR(numbers[i], wanted.begin()[i], 1e-6) << i;
}

TEST(Network, OfLinearLayersGivesWhatTheEquationsSay) {
  struct Case {
    std::string_view activation;
    std::initializer_list<double> wanted;
  };
  for (const Case& c :
       {Case{"tanh", {-0.195999189, 0.0331401131}}, Case{"relu", {-0.173980713, 0.00354003906}},
        Case{"silu", {-0.141270687, 0.0868413957}}, Case{"sigmoid", {-0.195748849, 0.140889232}},
        Case{"none", {-0.219146729, 0.0102233887}}}) {
    SCOPED_TRACE(c.activation);
    const Network n = network(fmt::format("linear a.0 {}\nlinear a.2\n", c.activation),
                              Safetensors().linear("a.0", 3, 5, 1).linear("a.2", 5, 2, 3));
    std::vector<float> out(n.outputs());
    n.evaluate(kInput, {}, out);
    expect_near(out, c.wanted);
  }
}

TEST(Network, WithMemoryGivesWhatTheEquationsSay) {
  const Network gru = network("gru m", Safetensors().recurrent("m", 3, 3, 5, 1));
  std::vector<float> out(5), memory(gru.memory());
  ASSERT_EQ(memory.size(), 5u);
  gru.evaluate(kInput, memory, out);
  expect_near(out, {-0.208431999, -0.0371225867, -0.316767477, 0.134989582, 0.352331328});
  gru.evaluate(kInput, memory, out);
  gru.evaluate(kInput, memory, out);
  expect_near(out, {-0.332585134, -0.0900998993, -0.487287519, 0.13441564, 0.548836244});
  EXPECT_EQ(out, memory);

  const Network lstm = network("lstm m", Safetensors().recurrent("m", 4, 3, 5, 1));
  memory.assign(lstm.memory(), 0);
  ASSERT_EQ(memory.size(), 10u);
  lstm.evaluate(kInput, memory, out);
  expect_near(out, {-0.16835105, -0.0285244627, -0.0729585972, 0.049608916, 0.190950362});
  lstm.evaluate(kInput, memory, out);
  lstm.evaluate(kInput, memory, out);
  expect_near(out, {-0.273119802, -0.0477571721, -0.0901844893, 0.0446009969, 0.259118742});
}

TEST(Network, GivesTheSameBitsEverywhere) {
  const Network n =
      network("linear a silu\nlstm b\ngru c\nlinear d tanh", Safetensors()
                                                                 .linear("a", 3, 33, 1)
                                                                 .recurrent("b", 4, 33, 19, 2)
                                                                 .recurrent("c", 3, 19, 21, 3)
                                                                 .linear("d", 21, 6, 4));
  std::vector<float> memory(n.memory()), out(n.outputs());
  Hasher hasher;
  for (int i = 0; i < 100; ++i) {
    const NoAllocation guard;
    n.evaluate(kInput, memory, out);
    hasher.bytes(out.data(), out.size() * sizeof(float));
  }
  EXPECT_EQ(hasher.value(), 8624552086559286187U);
}

TEST(Network, SaysWhatDoesNotFit) {
  std::string many;
  Safetensors layers;
  for (int i = 0; i < 20; ++i) {
    many += fmt::format("linear a{}\n", i);
    layers.linear(fmt::format("a{}", i), 3, 3, 1);
  }
  EXPECT_NE(mistakes(many, layers).find("net:17:"), std::string::npos)
      << "none is read beyond the sixteenth";
  const Safetensors file = Safetensors().linear("a.0", 3, 5, 1).recurrent("m", 3, 3, 5, 1);
  EXPECT_EQ(mistakes("linear a.1", file),
            "net.safetensors: there is no tensor 'a.1.weight'; did you mean 'a.0.weight'?");
  EXPECT_EQ(mistakes("linear a.0\nlinear a.0", file), "net:2:8: the layer 'a.0' is there already");
  EXPECT_EQ(mistakes("linear a.0\nlinear b", Safetensors(file).linear("b", 3, 5, 1)),
            "net.safetensors: tensor 'b.weight': expected the shape [any, 5], found [5, 3]");
  EXPECT_EQ(mistakes("lstm m", file),
            "net.safetensors: tensor 'm.weight_ih_l0': 15 rows make no layer of 1 to 1024 units");
  EXPECT_EQ(mistakes("liner a.0", file),
            "net:1:1: expected linear, gru or lstm, got 'liner'; did you mean 'linear'?");
  EXPECT_EQ(mistakes("linear a.0 tanhh", file),
            "net:1:12: there is no activation 'tanhh'; did you mean 'tanh'?");
  EXPECT_EQ(mistakes("gru m tanh", file), "net:1:7: expected the end of the line, got 'tanh'");
  EXPECT_EQ(mistakes("gru", file), "net:1:4: expected the name of the layer, got the end");
  EXPECT_EQ(mistakes("linear b", Safetensors().tensor("b.weight", {1, 3}, {1, 2, 3}, "I32")),
            "net.safetensors: tensor 'b.weight': expected numbers of type F32, found 'I32'");
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_EQ(mistakes("linear b", Safetensors().tensor("b.weight", {1, 3}, {1, 2, infinite})),
            "net.safetensors: tensor 'b.weight' has a number that is not finite");
  EXPECT_EQ(
      mistakes("linear b",
               Safetensors().tensor("b.weight", {1, 3}, {1, 2, 3}).tensor("b.bias", {2}, {1, 2})),
      "net.safetensors: tensor 'b.bias': expected the shape [1], found [2]");
}

TEST(TensorFile, RefusesWhatIsCutOrLies) {
  const auto mistakes = [](std::string bytes) {
    Diagnostics diagnostics;
    EXPECT_FALSE(TensorFile::read(std::move(bytes), "t", diagnostics));
    return diagnostics.text();
  };
  const auto headed = [&](const std::string& header) {
    return mistakes(Safetensors::of_header(header, std::string(16, 'x')));
  };
  constexpr const char* kCut = "t: no file of tensors (.safetensors), or one that is cut";
  EXPECT_EQ(mistakes(""), kCut);
  EXPECT_EQ(mistakes("\x10"), kCut);
  EXPECT_EQ(mistakes(std::string(8, '\xff')), kCut);
  const std::string good = Safetensors().linear("a", 3, 5, 1).bytes();
  EXPECT_EQ(mistakes(good.substr(0, good.size() - 1)),
            "t: tensor 'a.bias' is at 60 to 80 of 79 bytes");
  EXPECT_EQ(mistakes(good + "1234"), "t: 4 bytes behind the last tensor");
  EXPECT_EQ(headed(R"({"a":{"dtype":"F32","shape":[2],"data_offsets":[0,8]},)"
                   R"("b":{"dtype":"F32","shape":[3],"data_offsets":[4,16]}})"),
            "t: tensor 'b' does not begin where the one before it ends");
  EXPECT_EQ(headed("[1]"), "t: the header is no JSON object");
  EXPECT_TRUE(headed("{").starts_with("t:2:1: the header is not JSON: ")) << headed("{");
  EXPECT_EQ(headed(R"({"a":{"dtype":"F32","shape":[2]}})"),
            "t: tensor 'a' needs dtype, shape and data_offsets");
  EXPECT_EQ(headed(R"({"a":{"dtype":"F32","shape":[5],"data_offsets":[0,16]}})"),
            "t: tensor 'a' of shape [5] and type F32 does not fit into 16 bytes");
  EXPECT_EQ(
      headed(R"({"a":{"dtype":"F32","shape":[4294967296,4294967296,4],"data_offsets":[0,16]}})"),
      "t: tensor 'a' of shape [4294967296, 4294967296, 4] and type F32 does not fit into 16 bytes");
  EXPECT_EQ(headed(R"({"a":{"dtype":"F32","shape":[-4],"data_offsets":[0,16]}})"),
            "t: tensor 'a' needs dtype, shape and data_offsets");
}

}  // namespace
}  // namespace eyrie::pilot
