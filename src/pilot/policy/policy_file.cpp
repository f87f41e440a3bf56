// SPDX-License-Identifier: MIT
#include "pilot/policy/policy_file.hpp"

#include "core/hash.hpp"

namespace eyrie::pilot {
namespace {

/// The words of one file.
class Words {
 public:
  Words(const TensorFile& tensors, Diagnostics& diagnostics)
      : tensors_(tensors), diagnostics_(diagnostics) {}

  void error(std::string message) { diagnostics_.error({tensors_.file()}, std::move(message)); }
  /// Where the lines of a word stand.
  [[nodiscard]] Location inside(const std::string& name) const {
    return {fmt::format("{}: {}", tensors_.file().text(), name), 1, 1};
  }
  [[nodiscard]] std::optional<std::string> find(const std::string& name) const {
    return tensors_.word(name);
  }
  [[nodiscard]] std::string needed(const std::string& name) {
    const auto word = find(name);
    if (!word)
      error(fmt::format("its metadata has no word {}", quote(name)));
    return word.value_or("");
  }
  /// Reads a layout that the word of that name holds; its hash, if there is one, has to be right.
  template <class Layout>
  void read(const std::string& name, Layout& layout) {
    const auto text = find(name);
    if (!text)
      static_cast<void>(needed(name));
    if (!text || !layout.read(*text, inside(name), diagnostics_))
      return;
    const auto hash = find(name + "_hash");
    if (hash && *hash != hash_text(layout.hash()))
      error(fmt::format("{}_hash is {}, and the {} that stands there has {}", name, quote(*hash),
                        name, hash_text(layout.hash())));
  }

 private:
  const TensorFile& tensors_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<PolicyFile> PolicyFile::read(std::string bytes, FileName file,
                                           Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.count();
  const auto tensors = TensorFile::read(std::move(bytes), file, diagnostics);
  if (!tensors)
    return std::nullopt;
  Words words(*tensors, diagnostics);
  if (const std::string version = words.needed("eyrie_policy");
      !version.empty() && version != kVersion)
    words.error(fmt::format("it is a policy of version {}; this program reads version {}",
                            quote(version), kVersion));
  PolicyFile policy;
  words.read("observation", policy.observation);
  const auto votes = words.find("votes");
  if (!votes) {
    words.read("controls", policy.controls);
  } else {
    static constexpr auto kNames = enum_names<Votes>();
    policy.votes = enum_named<Votes>(*votes);
    if (!policy.votes)
      words.error(fmt::format("votes: expected sigmoid, softmax or linear, got {}{}", quote(*votes),
                              did_you_mean(*votes, kNames)));
    if (words.find("controls"))
      words.error("its metadata has 'controls' and 'votes': give one of them");
  }
  const std::string layers = words.needed("network");
  if (diagnostics.count() != before)
    return std::nullopt;
  auto network = Network::read(layers, words.inside("network"), policy.observation.size(), *tensors,
                               diagnostics);
  if (!network)
    return std::nullopt;
  policy.network = std::move(*network);
  if (!policy.votes && policy.network.outputs() != policy.controls.size())
    return diagnostics.error({tensors->file()}, "outputs of the network: {}, controls: {}",
                             policy.network.outputs(), policy.controls.size());
  return policy;
}

}  // namespace eyrie::pilot
