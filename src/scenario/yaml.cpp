// SPDX-License-Identifier: MIT
#include "scenario/yaml.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace eyrie::scenario {
namespace {

/// Ends the parse; the message is already in the diagnostics' words.
struct Refused {
  Location where;
  std::string message;
};

/// Turns the parser's events into a Value, so that no graph with shared nodes ever exists.
class Builder final : public YAML::EventHandler {
 public:
  Builder(std::string_view file, const YamlLimits& limits) : file_(file), limits_(limits) {}

  Value take() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    put(Value::null(place(mark)), anchor);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& text) override {
    const bool quoted = tag == "!";
    Value v = quoted ? Value::quoted_scalar(text, place(mark)) : Value::scalar(text, place(mark));
    if (tag != "!" && tag != "?")
      v.tag = tag;
    put(std::move(v), anchor);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(Value::list({}, place(mark)), tag, anchor);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(Value::map({}, place(mark)), tag, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto known = anchors_.find(anchor);
    if (known == anchors_.end())
      throw Refused{place(mark), "this alias stands inside what it refers to"};
    count(place(mark), nodes_of(known->second));
    --nodes_;  // put counts the alias itself once more
    put(Value(known->second), 0);
  }

 private:
  struct Open {
    Value value;
    YAML::anchor_t anchor;
    std::optional<Value> key;  ///< of a map: the key that waits for its value
  };

  Location place(const YAML::Mark& mark) const { return {file_, mark.line + 1, mark.column + 1}; }

  static std::size_t nodes_of(const Value& v) {
    std::size_t n = 1;
    for (const Value& item : v.items)
      n += nodes_of(item);
    for (const Value::Entry& e : v.entries)
      n += nodes_of(e.value);
    return n;
  }

  void count(const Location& where, std::size_t more) {
    nodes_ += more;
    if (nodes_ > limits_.nodes)
      throw Refused{where, fmt::format("more than {} values, aliases expanded", limits_.nodes)};
  }

  /// Anchors inside anchors keep copies of copies, so they are counted too.
  void remember(YAML::anchor_t anchor, const Value& v) {
    kept_ += nodes_of(v);
    if (kept_ > limits_.nodes)
      throw Refused{v.where, fmt::format("more than {} values below anchors", limits_.nodes)};
    anchors_[anchor] = v;
  }

  void open(Value v, const std::string& tag, YAML::anchor_t anchor) {
    if (open_.size() >= limits_.depth)
      throw Refused{v.where, fmt::format("nested deeper than {} levels", limits_.depth)};
    if (tag != "!" && tag != "?")
      v.tag = tag;
    open_.push_back({std::move(v), anchor, std::nullopt});
  }

  void close() {
    Open done = std::move(open_.back());
    open_.pop_back();
    put(std::move(done.value), done.anchor);
  }

  void put(Value v, YAML::anchor_t anchor) {
    count(v.where, 1);
    if (anchor)
      remember(anchor, v);
    if (open_.empty()) {
      root_ = std::move(v);
      return;
    }
    Open& parent = open_.back();
    if (parent.value.is_list()) {
      parent.value.items.push_back(std::move(v));
    } else if (!parent.key) {
      if (!v.is_scalar())
        throw Refused{v.where, "a key must be a plain word, not " + v.shown()};
      if (v.text == "<<" && !v.quoted)
        throw Refused{v.where, "merge keys ('<<') are not supported; use include or base"};
      parent.key = std::move(v);
    } else {
      if (v.is_null())
        v.where = parent.key->where;  // what is not there stands, for the parser, on a later line
      parent.value.entries.push_back({parent.key->text, parent.key->where, std::move(v)});
      parent.key.reset();
    }
  }

  std::string file_;
  YamlLimits limits_;
  Value root_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, Value> anchors_;
  std::size_t nodes_ = 0, kept_ = 0;
};

/// The line and column of a byte offset.
Location place_of(std::string_view text, std::size_t offset, std::string_view file) {
  const std::string_view before = text.substr(0, offset);
  const auto line = std::count(before.begin(), before.end(), '\n');
  const auto start = before.rfind('\n');
  const std::size_t column = start == std::string_view::npos ? offset : offset - start - 1;
  return {std::string(file), static_cast<int>(line) + 1, static_cast<int>(column) + 1};
}

}  // namespace

Value parse_yaml(std::string_view text, std::string_view file, Diagnostics& diagnostics,
                 const YamlLimits& limits) {
  const Location top{std::string(file), 1, 1};
  if (text.size() > limits.bytes) {
    diagnostics.error(top, fmt::format("the file is larger than {} bytes", limits.bytes));
    return {};
  }
  if (const auto nul = text.find('\0'); nul != std::string_view::npos) {
    diagnostics.error(place_of(text, nul, file), "a NUL byte: this is not a text file");
    return {};
  }
  try {
    std::istringstream stream{std::string(text)};
    YAML::Parser parser(stream);
    Builder builder(file, limits);
    if (!parser.HandleNextDocument(builder)) {
      diagnostics.error(top, "the file is empty");
      return {};
    }
    Value document = builder.take();
    if (Builder rest(file, limits); parser.HandleNextDocument(rest)) {
      diagnostics.error(rest.take().where, "a second document in one file");
      return {};
    }
    return document;
  } catch (const Refused& refused) {
    diagnostics.error(refused.where, refused.message);
  } catch (const YAML::Exception& e) {
    const Location where =
        e.mark.is_null() ? top : Location{std::string(file), e.mark.line + 1, e.mark.column + 1};
    diagnostics.error(where, "not YAML: " + e.msg);
  }
  return {};
}

}  // namespace eyrie::scenario
