// SPDX-License-Identifier: MIT
#include "support/data_file.hpp"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <utility>
#include <vector>

namespace eyrie::test {
namespace {

class DataFile {
 public:
  static Value read(const std::string& path) {
    std::ifstream in(path);
    if (!in)
      throw std::runtime_error("cannot read " + path);
    DataFile file;
    file.split(in, path);
    std::size_t next = 0;
    return file.block(next, 0);
  }

 private:
  struct Line {
    int indent;
    std::string key, rest;
    Location where;
  };

  /// One entry per key; a flow value that is not closed goes on in the next line.
  void split(std::istream& in, const std::string& path) {
    std::string text;
    for (int number = 1; std::getline(in, text); ++number) {
      if (const auto hash = text.find('#'); hash != std::string::npos)
        text.erase(hash);
      text.erase(text.find_last_not_of(" \t\r") + 1);
      const auto start = text.find_first_not_of(' ');
      if (start == std::string::npos)
        continue;
      if (!lines_.empty() && open(lines_.back().rest)) {
        lines_.back().rest += " " + text.substr(start);
        continue;
      }
      const auto colon = text.find(':', start);
      if (colon == std::string::npos)
        throw std::runtime_error(path + ": no key in: " + text);
      const auto value = text.find_first_not_of(' ', colon + 1);
      lines_.push_back({int(start),
                        text.substr(start, colon - start),
                        value == std::string::npos ? "" : text.substr(value),
                        {path, number, int(start) + 1}});
    }
  }
  static bool open(std::string_view text) {
    int depth = 0;
    for (const char c : text)
      depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    return depth > 0;
  }

  Value block(std::size_t& next, int indent) {
    std::vector<Value::Entry> entries;
    const Location where = next < lines_.size() ? lines_[next].where : Location{};
    while (next < lines_.size() && lines_[next].indent == indent) {
      const Line line = lines_[next++];
      std::string_view rest = line.rest;
      Value value;
      if (rest.empty())
        value = next < lines_.size() && lines_[next].indent > indent
                    ? block(next, lines_[next].indent)
                    : Value::null(line.where);
      else
        value = flow(rest, line.where);
      entries.push_back({line.key, line.where, std::move(value)});
    }
    return Value::map(std::move(entries), where);
  }

  static void skip(std::string_view& text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == ','))
      text.remove_prefix(1);
  }
  static Value flow(std::string_view& text, const Location& where) {
    skip(text);
    if (text.starts_with('[')) {
      std::vector<Value> items;
      for (text.remove_prefix(1), skip(text); !text.starts_with(']'); skip(text))
        items.push_back(flow(text, where));
      text.remove_prefix(1);
      return Value::list(std::move(items), where);
    }
    if (text.starts_with('{')) {
      std::vector<Value::Entry> entries;
      for (text.remove_prefix(1), skip(text); !text.starts_with('}'); skip(text)) {
        const auto colon = text.find(':');
        std::string key(text.substr(0, colon));
        text.remove_prefix(colon + 1);
        entries.push_back({std::move(key), where, flow(text, where)});
      }
      text.remove_prefix(1);
      return Value::map(std::move(entries), where);
    }
    const auto end = std::min(text.find_first_of(",]}"), text.size());
    std::string scalar(text.substr(0, end));
    text.remove_prefix(end);
    scalar.erase(scalar.find_last_not_of(' ') + 1);
    if (scalar == "null" || scalar == "~")
      return Value::null(where);
    if (scalar.size() > 1 && scalar.front() == '"' && scalar.back() == '"')
      scalar = scalar.substr(1, scalar.size() - 2);
    return Value::scalar(std::move(scalar), where);
  }

  std::vector<Line> lines_;
};

}  // namespace

Value read_data_file(const std::string& path) {
  Value value = DataFile::read(path);
  if (!value.find("base"))
    return value;
  // a name in the same folder
  const std::string below =
      path.substr(0, path.rfind('/') + 1) + value.find("base")->text + ".yaml";
  std::erase_if(value.entries, [](const Value::Entry& e) { return e.key == "base"; });
  return merged(read_data_file(below), value);
}

}  // namespace eyrie::test
