// SPDX-License-Identifier: MIT
#pragma once
/// \file  The trees of a scenario document, each read for whom it serves.
#include "core/diagnostics.hpp"
#include "core/value.hpp"
#include "driver/state.hpp"
#include "pilot/trees.hpp"
#include "scenario/plan.hpp"
#include "scenario/plugin.hpp"
#include "scenario/scenario.hpp"

namespace eyrie::scenario {

class Source;

/// A tree is read as a pilot's if a pilot flies by it, as a driver's if a driver drives by it, and
/// as both if both do: navigate, follow_lead and the standard nodes are there for all. One that
/// nobody uses is read as whichever it can be. Trees for other kinds of players go to them.
class TreeBook {
 public:
  /// Reads `trees:` of a document for the players of `plans` and for `orders`, which it has, too.
  /// `source`: of the files that nodes are made of, if they may have any.
  static TreeBook read(const Value& document, const Plans& plans,
                       const std::vector<OrderSpec>& orders, const Registries& registries,
                       const std::vector<TreeChange>& changes, Diagnostics& diagnostics,
                       Source* source = nullptr,
                       std::span<const std::unique_ptr<PlayerKind>> kinds = {});

  [[nodiscard]] const std::shared_ptr<pilot::Trees>& pilots() const { return pilots_; }
  [[nodiscard]] const std::shared_ptr<driver::Trees>& drivers() const { return drivers_; }

  /// The index of a tree, or nothing after saying what is wrong, unless that was said before.
  template <class Trees>
  [[nodiscard]] std::optional<std::uint16_t> find(const Trees& trees, const std::string& name,
                                                  const Location& where,
                                                  Diagnostics& diagnostics) const {
    const auto index = trees.find(name);
    if (!index)
      missing(name, where, diagnostics);
    return index;
  }

  /// Says that there is no such tree, unless that was said before.
  void missing(const std::string& name, const Location& where, Diagnostics& diagnostics) const;

 private:
  std::shared_ptr<pilot::Trees> pilots_ = std::make_shared<pilot::Trees>();
  std::shared_ptr<driver::Trees> drivers_ = std::make_shared<driver::Trees>();
  std::vector<std::string> names_;
  std::vector<std::string> broken_;     ///< with mistakes, said already
  bool too_many_ = false;               ///< said already
  std::vector<std::string> templates_;  ///< that need arguments
};

}  // namespace eyrie::scenario
