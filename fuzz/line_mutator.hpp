// SPDX-License-Identifier: MIT
#pragma once
/// \file  Mutations of YAML that mostly stay YAML: blocks of lines (a line and what is indented
/// below it) are taken out, doubled, moved and indented, keys and values are replaced by others of
/// the same text or by hard ones. Bytes alone seldom get past the parser.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace eyrie::fuzz {

class LineMutator {
 public:
  LineMutator(std::string_view text, unsigned seed) : random_(seed) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
      lines_.emplace_back(text.substr(0, end));
      text.remove_prefix(end);
    }
  }

  /// The text after one change; `other` lends its lines.
  [[nodiscard]] std::string mutated(const LineMutator& other) {
    if (lines_.empty())
      return other.joined();
    const std::size_t at = below(lines_.size()), end = end_of_block(at);
    const auto first = lines_.begin() + static_cast<std::ptrdiff_t>(at);
    const auto last = lines_.begin() + static_cast<std::ptrdiff_t>(end);
    switch (below(8)) {
      case 0:
        lines_.erase(first, last);
        break;
      case 1: {  // once more, with another key, or it would be refused as given twice
        const Lines copy(first, last);
        insert(end, copy, 0);
        replace(lines_[end], key_of(lines_[end]), "x" + std::string(key_of(lines_[end])));
        break;
      }
      case 2:
        insert(below(lines_.size() + 1), Lines(first, last), indent(lines_[at]));
        break;
      case 3:
        if (!other.lines_.empty()) {
          const std::size_t from = below(other.lines_.size());
          const auto begin = other.lines_.begin() + static_cast<std::ptrdiff_t>(from);
          const Lines block(
              begin, other.lines_.begin() + static_cast<std::ptrdiff_t>(other.end_of_block(from)));
          insert(at, block, indent(block.front()));
        }
        break;
      case 4:
        replace(lines_[at], key_of(lines_[at]), std::string(other.some_word(*this)));
        break;
      case 5:
        replace(lines_[at], word_of(lines_[at]), std::string(hard()));
        break;
      default:
        replace(lines_[at], word_of(lines_[at]), std::string(other.some_word(*this)));
    }
    return joined();
  }

 private:
  using Lines = std::vector<std::string>;

  std::size_t below(std::size_t n) { return random_() % n; }
  static std::size_t indent(std::string_view line) {
    const std::size_t spaces = line.find_first_not_of(' ');
    return spaces == line.npos ? 0 : spaces;
  }
  [[nodiscard]] std::size_t end_of_block(std::size_t at) const {
    std::size_t end = at + 1;
    while (end < lines_.size() && indent(lines_[end]) > indent(lines_[at]))
      ++end;
    return end;
  }
  /// Before a line, indented as that is.
  void insert(std::size_t before, Lines block, std::size_t had) {
    const std::size_t wanted = before < lines_.size() && had > 0 ? indent(lines_[before]) : had;
    for (std::string& line : block)
      line = std::string(wanted, ' ') + line.substr(std::min(had, indent(line)));
    lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(before), block.begin(), block.end());
  }
  static std::string_view key_of(std::string_view line) {
    line.remove_prefix(std::min(line.size(), indent(line)));
    return line.substr(0, std::min(line.find(':'), line.size()));
  }
  /// One of the words of a line: what stands between the signs of YAML.
  std::string_view word_of(std::string_view line) {
    constexpr std::string_view kSigns = " \n:,{}[]#";
    std::vector<std::string_view> words;
    for (std::size_t i = line.find_first_not_of(kSigns); i != line.npos;
         i = line.find_first_not_of(kSigns, i)) {
      const std::size_t end = std::min(line.find_first_of(kSigns, i), line.size());
      words.push_back(line.substr(i, end - i));
      i = end;
    }
    return words.empty() ? line.substr(0, 0) : words[below(words.size())];
  }
  [[nodiscard]] std::string_view some_word(LineMutator& who) const {
    return lines_.empty() ? std::string_view{} : who.word_of(lines_[who.below(lines_.size())]);
  }
  std::string_view hard() {
    constexpr std::array<std::string_view, 20> kHard{
        "null",  "~",    "[]",    "{}",     "''",         "-1",     "0",
        "1e308", ".nan", "-.inf", "yes",    "none",       "0x7",    "1e-320 s",
        "*a",    "&a 1", "[[1]]", "{a: 1}", "9999999999", "\"\\0\""};
    return kHard[below(kHard.size())];
  }
  static void replace(std::string& line, std::string_view part, const std::string& by) {
    line.replace(static_cast<std::size_t>(part.data() - line.data()), part.size(), by);
  }
  [[nodiscard]] std::string joined() const {
    std::string text;
    for (const std::string& line : lines_)
      text += line;
    return text;
  }

  std::minstd_rand random_;
  Lines lines_;
};

}  // namespace eyrie::fuzz
