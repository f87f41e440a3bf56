// SPDX-License-Identifier: MIT
#include "core/yaml.hpp"

#include <yaml.h>

#include <algorithm>
#include <array>
#include <map>
#include <new>
#include <optional>
#include <unordered_map>

#include "core/text.hpp"

namespace eyrie {
namespace {

/// Ends the parse; the message is already in the diagnostics' words.
struct Refused {
  Location where;
  std::string message;
};

/// What files may say: a reference to a tree, and the factors of a campaign.
constexpr std::array<std::string_view, 6> kTags{"!tree",    "!choice",      "!range",
                                                "!uniform", "!log_uniform", "!normal"};

/// The line and column of a byte offset.
Location place_of(std::string_view text, std::size_t offset, FileName file) {
  const std::string_view before = text.substr(0, offset);
  const auto line = std::ranges::count(before, '\n');
  const std::size_t column = characters(before.substr(before.rfind('\n') + 1));
  return {file, static_cast<int>(line) + 1, static_cast<int>(column) + 1};
}

std::string text_of(const yaml_char_t* text) {
  return text ? reinterpret_cast<const char*>(text) : "";
}

/// Turns the parser's events into a Value, so that no graph with shared nodes ever exists. Values
/// are made where they stay: a list or map does not grow while something inside it is open.
class Builder {
 public:
  Builder(FileName file, const YamlLimits& limits, Diagnostics& diagnostics)
      : file_(file), limits_(limits), diagnostics_(diagnostics) {}

  Value take() { return std::move(root_); }
  [[nodiscard]] bool has_document() const { return documents_ > 0; }

  void handle(const yaml_event_t& e) {
    switch (e.type) {
      case YAML_DOCUMENT_START_EVENT:
        if (++documents_ > 1)
          throw Refused{place(e.start_mark), "a second document in one file"};
        break;
      case YAML_SCALAR_EVENT:
        scalar(e);
        break;
      case YAML_SEQUENCE_START_EVENT:
        open(e, Value::Kind::list, e.data.sequence_start.tag, e.data.sequence_start.anchor);
        break;
      case YAML_MAPPING_START_EVENT:
        open(e, Value::Kind::map, e.data.mapping_start.tag, e.data.mapping_start.anchor);
        break;
      case YAML_MAPPING_END_EVENT:
        refuse_duplicates(*open_.back().value);
        [[fallthrough]];
      case YAML_SEQUENCE_END_EVENT:
        remember(open_.back().anchor, *open_.back().value);
        open_.pop_back();
        break;
      case YAML_ALIAS_EVENT:
        alias(text_of(e.data.alias.anchor), place(e.start_mark));
        break;
      default:
        break;
    }
  }

  Location place(const yaml_mark_t& mark) const {
    return {file_, static_cast<int>(mark.line) + 1, static_cast<int>(mark.column) + 1};
  }

 private:
  struct Open {
    Value* value = nullptr;
    std::string anchor = {};
    bool has_key = false;  ///< a map's: it waits for its value
    std::string key = {};
    Location key_where = {};
  };

  /// Where the next value goes.
  Value& slot(const Location& where) {
    count(where, 1);
    if (open_.empty())
      return root_;
    Open& parent = open_.back();
    if (parent.value->is_list())
      return parent.value->items.emplace_back();
    parent.has_key = false;
    Value::Entry& made = parent.value->entries.emplace_back();
    made.key = std::move(parent.key);
    made.where = parent.key_where;
    return made.value;
  }
  [[nodiscard]] bool wants_key() const {
    return !open_.empty() && open_.back().value->is_map() && !open_.back().has_key;
  }
  void key(std::string text, bool quoted, const Location& where) {
    if (text == "<<" && !quoted)
      throw Refused{where, "merge keys ('<<') are not supported; use include or base"};
    Open& map = open_.back();
    map.has_key = true;
    map.key = std::move(text);
    map.key_where = where;
  }
  /// The first stays, so that nobody above meets a key twice.
  void refuse_duplicates(Value& map) {
    std::unordered_map<std::string, int> first;
    std::erase_if(map.entries, [&](const Value::Entry& e) {
      const auto [earlier, fresh] = first.emplace(e.key, e.where.line);
      if (!fresh)
        diagnostics_.error(e.where, "{} is given twice (first at line {})", quote(e.key),
                           earlier->second);
      return !fresh;
    });
  }
  /// A tag as it is written, after refusing one that nobody reads.
  std::string tag_of(const yaml_char_t* written, const Location& where) {
    std::string tag = text_of(written);
    if (!written || std::ranges::find(kTags, tag) != kTags.end())
      return tag;
    if (constexpr std::string_view kOfYaml = "tag:yaml.org,2002:"; tag.starts_with(kOfYaml))
      tag.replace(0, kOfYaml.size(), "!!");
    diagnostics_.error(where, "there is no tag {}, only {}{}", quote(tag), fmt::join(kTags, ", "),
                       did_you_mean(tag, kTags));
    return {};
  }
  [[noreturn]] static void refuse_key(const Location& where, const Value& shown) {
    throw Refused{where, "a key must be a plain word, not " + shown.shown()};
  }

  void scalar(const yaml_event_t& e) {
    const auto& s = e.data.scalar;
    const Location where = place(e.start_mark);
    const std::string_view text(reinterpret_cast<const char*>(s.value), s.length);
    const bool quoted = s.style != YAML_PLAIN_SCALAR_STYLE;
    const std::string tag = tag_of(s.tag, where);
    const bool is_null =
        !quoted && !s.tag &&
        (text.empty() || text == "~" || text == "null" || text == "Null" || text == "NULL");
    if (wants_key()) {
      count(where, 1);
      if (is_null)
        refuse_key(where, Value());
      if (!tag.empty())
        diagnostics_.error(where, "a key has no tag: write {} {{{}: ...}}", tag,
                           printable(text, 40));
      if (s.anchor) {
        Value anchored = Value::scalar(std::string(text), where);
        anchored.quoted = quoted;
        remember(text_of(s.anchor), anchored);
      }
      return key(std::string(text), quoted, where);
    }
    Value& v = slot(where);
    v.where = where;
    if (is_null) {
      v.text = text;
      if (!open_.empty() && open_.back().value->is_map())
        v.where = open_.back().key_where;  // what is not there stands, for the parser, further on
    } else {
      v.kind = Value::Kind::scalar;
      v.text = text;
      v.quoted = quoted;
      v.tag = tag;
    }
    if (s.anchor)
      remember(text_of(s.anchor), v);
  }

  void open(const yaml_event_t& e, Value::Kind kind, const yaml_char_t* tag,
            const yaml_char_t* anchor) {
    const Location where = place(e.start_mark);
    if (open_.size() >= limits_.depth)
      throw Refused{where, fmt::format("nested deeper than {} levels", limits_.depth)};
    if (wants_key()) {
      Value shown;
      shown.kind = kind;
      refuse_key(where, shown);
    }
    Value& v = slot(where);
    v.kind = kind;
    v.where = where;
    v.tag = tag_of(tag, where);
    Open& opened = open_.emplace_back();
    opened.value = &v;
    if (anchor)
      opened.anchor = text_of(anchor);
  }

  void alias(const std::string& name, const Location& where) {
    const bool is_open = std::ranges::find(open_, name, &Open::anchor) != open_.end();
    if (is_open)
      throw Refused{where, "this alias stands inside what it refers to"};
    const auto known = anchors_.find(name);
    if (known == anchors_.end())
      throw Refused{where, fmt::format("there is no anchor {}", quote(name))};
    const Value& v = known->second;
    if (wants_key()) {
      if (!v.is_scalar())
        refuse_key(where, v);
      count(where, 1);
      return key(v.text, v.quoted, v.where);
    }
    count(where, v.count() - 1);
    slot(where) = v;
  }

  void count(const Location& where, std::size_t more) {
    nodes_ += more;
    if (nodes_ > limits_.nodes)
      throw Refused{where, fmt::format("more than {} values, aliases expanded", limits_.nodes)};
  }

  /// Anchors inside anchors keep copies of copies, so they are counted too.
  void remember(const std::string& anchor, const Value& v) {
    if (anchor.empty())
      return;
    kept_ += v.count();
    if (kept_ > limits_.nodes)
      throw Refused{v.where, fmt::format("more than {} values below anchors", limits_.nodes)};
    anchors_[anchor] = v;
  }

  FileName file_;
  YamlLimits limits_;
  Diagnostics& diagnostics_;
  Value root_;
  std::vector<Open> open_;
  std::map<std::string, Value> anchors_;
  std::size_t nodes_ = 0, kept_ = 0, documents_ = 0;
};

/// libyaml's parser over a text.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {
    if (!yaml_parser_initialize(&parser_))
      throw std::bad_alloc();
    yaml_parser_set_input_string(&parser_, reinterpret_cast<const unsigned char*>(text.data()),
                                 text.size());
    yaml_parser_set_encoding(&parser_, YAML_UTF8_ENCODING);
  }
  ~Parser() { yaml_parser_delete(&parser_); }
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  /// Everything that the text holds goes to the builder.
  void feed(Builder& builder) {
    for (bool done = false; !done;) {
      yaml_event_t event;
      if (!yaml_parser_parse(&parser_, &event))
        throw Refused{place(builder), problem()};
      const Delete deleted{event};
      builder.handle(event);
      done = event.type == YAML_STREAM_END_EVENT;
    }
  }

 private:
  struct Delete {
    yaml_event_t& event;
    ~Delete() { yaml_event_delete(&event); }
  };

  /// Where it was noticed, but a key without a colon where it stands, which is a line before. Bytes
  /// that are no text have an offset only.
  [[nodiscard]] const yaml_mark_t& noticed() const {
    const bool is_key =
        parser_.context && std::string_view(parser_.context) == "while scanning a simple key";
    return is_key ? parser_.context_mark : parser_.problem_mark;
  }
  [[nodiscard]] Location place(const Builder& builder) const {
    const Location mark = builder.place(noticed());
    return parser_.error == YAML_READER_ERROR ? place_of(text_, parser_.problem_offset, mark.file)
                                              : mark;
  }

  /// "not YAML: while parsing a flow sequence from line 3: did not find expected ',' or ']'"
  [[nodiscard]] std::string problem() const {
    if (parser_.error != YAML_READER_ERROR && is_tab(parser_.problem_mark))
      return "a tab; YAML is indented with spaces";
    std::string context;
    if (parser_.context) {
      context = parser_.context;
      if (parser_.context_mark.line != noticed().line)
        context += fmt::format(" from line {}", parser_.context_mark.line + 1);
      context += ": ";
    }
    return fmt::format("not YAML: {}{}", context, parser_.problem ? parser_.problem : "?");
  }

  /// Whether a tab stands there with nothing but blanks before it.
  [[nodiscard]] bool is_tab(const yaml_mark_t& mark) const {
    std::size_t line = 0;
    for (std::size_t i = 0; i < mark.line && line != text_.npos; ++i) {
      line = text_.find('\n', line);
      line += line != text_.npos;
    }
    const std::size_t begin = line == text_.npos ? line : text_.find_first_not_of(" \r", line);
    return begin != text_.npos && text_[begin] == '\t';
  }

  std::string_view text_;
  yaml_parser_t parser_;
};

}  // namespace

Value parse_yaml(std::string_view text, std::string_view name, Diagnostics& diagnostics,
                 const YamlLimits& limits) {
  const FileName file(name);
  const Location top{file, 1, 1};
  if (text.size() > limits.bytes) {
    diagnostics.error(top, "the file is larger than {} bytes", limits.bytes);
    return {};
  }
  if (text.starts_with("\xEF\xBB\xBF"))  // a byte order mark, as Windows writes it
    text.remove_prefix(3);
  if (const auto nul = text.find('\0'); nul != std::string_view::npos) {
    diagnostics.error(place_of(text, nul, file), "a NUL byte: this is not a text file");
    return {};
  }
  try {
    Builder builder(file, limits, diagnostics);
    Parser(text).feed(builder);
    if (!builder.has_document())
      throw Refused{top, "the file is empty"};
    return builder.take();
  } catch (const Refused& refused) {
    diagnostics.error(refused.where, refused.message);
  }
  return {};
}

}  // namespace eyrie
