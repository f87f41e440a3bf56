// SPDX-License-Identifier: MIT
#include "page/decisions.hpp"

namespace eyrie::page {
namespace {

int numbered(ubf::NodeIndex node) {
  return node == ubf::kNone ? -1 : static_cast<int>(node);
}

char letter(const debrief::Answer& answer) {
  return !answer.asked                           ? '-'
         : answer.status == ubf::Status::failure ? 'F'
         : answer.status == ubf::Status::success ? 'S'
                                                 : 'R';
}

std::size_t number_of(std::span<const ubf::ActionFieldInfo> fields, const debrief::Value& value) {
  return static_cast<std::size_t>(
      std::ranges::find(fields, value.name, &ubf::ActionFieldInfo::name) - fields.begin());
}

}  // namespace

Json ShapeBook::shape(std::size_t tree, ubf::NodeIndex leader,
                      const std::vector<debrief::Answer>& nodes,
                      std::span<const ubf::ActionFieldInfo> fields) {
  std::string status;
  Json votes = Json::array(), why = Json::array(), suppliers = Json::array(), won = Json::array();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const debrief::Answer& answer = nodes[i];
    status.push_back(letter(answer));
    votes.push_back(answer.vote);
    if (status.back() == 'F' && !answer.why.empty())
      why.push_back({i, texts_.number(answer.why)});
    if (answer.action.empty())
      continue;
    std::vector<int> row(1 + fields.size(), -1);  // held ones below -1
    row[0] = static_cast<int>(i);
    for (const debrief::Value& value : answer.action)
      row[1 + number_of(fields, value)] =
          value.held ? -2 - numbered(value.supplier) : numbered(value.supplier);
    suppliers.push_back(row);
  }
  for (const team::Won& field : team::contest(nodes)) {
    Json rivals = Json::array();
    for (const team::Rival& rival : field.rivals)
      rivals.push_back({numbered(rival.node), rival.vote});
    won.push_back({number_of(fields, field.value), numbered(field.winner),
                   texts_.number(debrief::reason(field)), std::move(rivals)});
  }
  return {{"tree", tree}, {"leader", numbered(leader)}, {"status", status}, {"vote", votes},
          {"why", why},   {"supplier", suppliers},      {"won", won}};
}

}  // namespace eyrie::page
