// SPDX-License-Identifier: MIT
#pragma once
/// \file  What of a decision stays the same for long: who was asked, what they answered, with which
/// votes, and who supplied which field. Kept once, however often it comes.
#include <cstdint>
#include <cstring>
#include <string>
#include <unordered_map>

#include "debrief/decision.hpp"
#include "page/json.hpp"
#include "page/text_book.hpp"
#include "ubf/trace.hpp"

namespace eyrie::page {

class ShapeBook {
 public:
  explicit ShapeBook(TextBook& texts) : texts_(texts) {}

  /// The number of the shape of a decision by tree number `tree`, whose nodes are `blank`.
  template <class Action>
  [[nodiscard]] std::int64_t number(std::size_t tree, const std::vector<debrief::Answer>& blank,
                                    ubf::NodeIndex leader, const ubf::Trace<Action>& trace) {
    key_.clear();
    append(tree);
    append(leader);
    for (std::size_t i = 0; i < blank.size(); ++i) {
      const auto node = static_cast<ubf::NodeIndex>(i);
      const auto& row = trace.row(node);
      append(letter(row.ticked, row.status));
      append(row.proposal.vote);
      append(trace.why(node));
      append(row.supplier);
    }
    const auto [at, is_new] = numbers_.try_emplace(key_, static_cast<std::int64_t>(json_.size()));
    if (is_new)
      json_.push_back(shape(tree, blank, leader, trace));
    return at->second;
  }
  [[nodiscard]] const Json& json() const { return json_; }

 private:
  template <class T>
  void append(const T& value) {
    key_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  [[nodiscard]] static char letter(bool asked, ubf::Status status) {
    return !asked                           ? '-'
           : status == ubf::Status::failure ? 'F'
           : status == ubf::Status::success ? 'S'
                                            : 'R';
  }
  [[nodiscard]] static int index_of(ubf::NodeIndex node) {
    return node == ubf::kNone ? -1 : static_cast<int>(node);
  }

  template <class Action>
  [[nodiscard]] Json shape(std::size_t tree, const std::vector<debrief::Answer>& blank,
                           ubf::NodeIndex leader, const ubf::Trace<Action>& trace) {
    std::string status;
    Json votes = Json::array(), why = Json::array(), supplier = Json::array();
    for (std::size_t i = 0; i < blank.size(); ++i) {
      const auto node = static_cast<ubf::NodeIndex>(i);
      const auto& row = trace.row(node);
      status.push_back(letter(row.ticked, row.status));
      votes.push_back(row.proposal.vote);
      if (row.ticked && row.status == ubf::Status::failure) {
        const char* said = trace.why(node);
        const std::string words = said ? said : blank[i].why;
        if (!words.empty())
          why.push_back({i, texts_.number(words)});
      }
      if (ubf::is_empty(row.proposal.action))
        continue;
      Json fields = Json::array({i});
      for (const ubf::NodeIndex from : row.supplier)
        fields.push_back(index_of(from));
      supplier.push_back(std::move(fields));
    }
    return {{"tree", tree}, {"leader", index_of(leader)}, {"status", status}, {"vote", votes},
            {"why", why},   {"supplier", supplier}};
  }

  TextBook& texts_;
  std::string key_;
  std::unordered_map<std::string, std::int64_t> numbers_;
  Json json_ = Json::array();
};

}  // namespace eyrie::page
