// SPDX-License-Identifier: MIT
#include "campaign/whole_scenario.hpp"

#include <filesystem>

#include "campaign/factor.hpp"
#include "pilot/policy/policy_file.hpp"

namespace eyrie::campaign {
namespace {

constexpr std::size_t kLine = 120;

/// What follows "key:" or "-": on the same line if it fits, else line by line, one level deeper.
void write(const Value& value, std::size_t indent, std::string& out) {
  std::string line = yaml_text(value);
  const bool is_leaf = value.items.empty() && value.entries.empty();
  if (is_leaf || indent + line.size() < kLine) {
    out += " " + line + "\n";
    return;
  }
  out += "\n";
  for (const Value& item : value.items) {
    out += std::string(indent, ' ') + "-";
    write(item, indent + 2, out);
  }
  for (const Value::Entry& e : value.entries) {
    out += std::string(indent, ' ') + yaml_text(Value::scalar(e.key)) + ":";
    write(e.value, indent + 2, out);
  }
}

/// Of every file that is named, as far as `is_file` says so, its whole path; their folders go to
/// `folders`.
void make_absolute(Value& value, bool (*is_file)(const std::string&),
                   std::set<std::string>& folders) {
  for (Value& item : value.items)
    make_absolute(item, is_file, folders);
  for (Value::Entry& e : value.entries)
    make_absolute(e.value, is_file, folders);
  if (!value.is_scalar() || !is_file(value.text))
    return;
  value.text = scenario::file_named(value);
  if (value.text.starts_with(scenario::Source::kOwn))
    return;
  const auto path = std::filesystem::absolute(value.text).lexically_normal();
  value.text = path.string();
  folders.insert(path.parent_path().string());
}
bool is_any(const std::string&) {
  return true;
}
bool is_network(const std::string& name) {
  return name.ends_with(pilot::PolicyFile::kEnding);
}

}  // namespace

WholeScenario whole_scenario(const std::string& file, const std::vector<std::string>& sets,
                             scenario::Source source) {
  Diagnostics diagnostics;
  Value document = scenario::load_document(file, source, diagnostics);
  if (diagnostics.ok())
    scenario::apply_overrides(document, sets, diagnostics);
  diagnostics.throw_if_any();
  std::erase_if(document.entries, [](const auto& e) { return e.key == "include"; });
  WholeScenario whole;
  std::set<std::string> ignored;  // plug-ins are trusted one by one
  for (Value::Entry& e : document.entries) {
    if (e.key == "plugins")
      make_absolute(e.value, is_any, ignored);
    else if (e.key == "trees")
      make_absolute(e.value, is_network, whole.folders);
    whole.text += yaml_text(Value::scalar(e.key)) + ":";
    write(e.value, 2, whole.text);
  }
  return whole;
}

}  // namespace eyrie::campaign
