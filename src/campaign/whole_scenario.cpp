// SPDX-License-Identifier: MIT
#include "campaign/whole_scenario.hpp"

#include <filesystem>

#include "campaign/factor.hpp"

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

/// One path, or a list of them.
void make_absolute(Value& plugins) {
  for (Value& item : plugins.items)
    make_absolute(item);
  if (plugins.is_scalar())
    plugins.text =
        std::filesystem::absolute(scenario::relative_to(plugins.where.file.text(), plugins.text))
            .string();
}

}  // namespace

std::string whole_scenario(const std::string& file, const std::vector<std::string>& sets,
                           scenario::Source source) {
  Diagnostics diagnostics;
  Value document = scenario::load_document(file, source, diagnostics);
  if (diagnostics.ok())
    scenario::apply_overrides(document, sets, diagnostics);
  if (!diagnostics.ok())
    throw ConfigError(diagnostics);
  std::erase_if(document.entries, [](const auto& e) { return e.key == "include"; });
  std::string text;
  for (Value::Entry& e : document.entries) {
    if (e.key == "plugins")
      make_absolute(e.value);
    text += yaml_text(Value::scalar(e.key)) + ":";
    write(e.value, 2, text);
  }
  return text;
}

}  // namespace eyrie::campaign
