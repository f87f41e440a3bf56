// SPDX-License-Identifier: MIT
#pragma once
/// \file  Votes that follow the state, as a file writes them in the place of a number:
///
///   vote: {of: range, from: 40 nmi, to: 10 nmi}        nothing at 40 nmi, the full vote at 10 nmi
///   vote: {most: 70, least: 10, of: range, from: 40 nmi, to: 10 nmi, curve: logistic}
///   vote: {most: 70, product: [{of: range, from: 40 nmi, to: 10 nmi}, {of: threatened}]}
///
/// A product of considerations, each in [0, 1], is what utility AI decides by: Mark, "Architecture
/// Tricks: Managing Behaviors in Time, Space, and Depth" (GDC 2013).
#include <functional>
#include <optional>

#include "core/enum_names.hpp"
#include "core/value.hpp"
#include "ubf/state_fields.hpp"

namespace eyrie::ubf {

/// How a score rises from 0 to 1.
enum class Curve : std::uint8_t {
  linear,
  quadratic,  ///< late
  root,       ///< early
  logistic,   ///< in the middle
};
constexpr auto names_of(Curve) {
  return names_from_zero<Curve>("linear", "quadratic", "root", "logistic");
}

/// What one field of the state says: 0 at `from` and before, 1 at `to` and beyond.
struct Consideration {
  std::uint32_t field = 0;
  double from = 0, to = 1;
  Curve curve = Curve::linear;

  /// In [0, 1]; of a field without a value 0.
  [[nodiscard]] double score(double value) const;
};

/// Which share of its vote a node sends up: it rises with the product of the scores, from `least`
/// to 1.
struct VoteCurve {
  static constexpr std::size_t kMost = 6;
  using Scores = std::array<float, kMost>;

  std::vector<Consideration> product;
  double least = 0;  ///< in [0, 1]

  /// What is wrong with it, "" for nothing.
  [[nodiscard]] std::string problem() const;
  /// `read(field)` gives the value of a field of the state. Notes the scores.
  template <class Read>
  [[nodiscard]] double share(Read read, Scores& scores) const {
    double all = 1;
    for (std::size_t i = 0; i < product.size(); ++i) {
      const double score = product[i].score(read(product[i].field));
      scores[i] = static_cast<float>(score);
      all *= score;
    }
    return least + (1 - least) * all;
  }
  /// "range 0.53, threatened 1": what the scores were.
  [[nodiscard]] std::string text(const Scores& scores,
                                 std::span<const StateFieldInfo> fields) const;
};

/// Reads what considers from a vote as written, or reports what is wrong; `find` gives the index of
/// a field that is named, or nothing after reporting. `least` is still a vote.
[[nodiscard]] std::optional<VoteCurve> read_vote(
    const Value& text, std::span<const StateFieldInfo> fields,
    const std::function<std::optional<std::size_t>(const Value&)>& find, Diagnostics& diagnostics);

}  // namespace eyrie::ubf
