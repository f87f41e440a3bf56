// SPDX-License-Identifier: MIT
#include "core/diagnostics.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <set>
#include <tuple>
#include <unordered_map>

#include "core/mutex.hpp"
#include "core/text.hpp"

namespace eyrie {
namespace {

constexpr std::size_t kLongestName = 64;
/// Of what somebody else wrote, in one line of ours.
constexpr std::size_t kLongestQuote = 60, kLongestPath = 200, kLongestLine = 1000;

/// Optimal string alignment distance, or something above `most` as soon as it is known to exceed
/// that; both texts are at most kLongestName long.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t most) {
  std::array<std::array<std::size_t, kLongestName + 1>, 3> rows{};
  std::iota(rows[0].begin(), rows[0].end(), 0u);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    const auto& before = rows[(i + 1) % 3];  // row i - 2
    const auto& above = rows[(i - 1) % 3];
    auto& row = rows[i % 3];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = to_small(a[i - 1]) == to_small(b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0u : 1u)});
      const bool swapped = i > 1 && j > 1 && to_small(a[i - 1]) == to_small(b[j - 2]) &&
                           to_small(a[i - 2]) == to_small(b[j - 1]);
      if (swapped)
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    // an edit that swaps two letters reaches over one row, no further
    if (const auto end = static_cast<std::ptrdiff_t>(b.size()) + 1;
        *std::min_element(row.begin(), row.begin() + end) > most &&
        *std::min_element(above.begin(), above.begin() + end) >= most)
      return most + 1;
  }
  return rows[a.size() % 3][b.size()];
}

/// How many edits may lie between a mistake and the name that was meant.
std::size_t tolerance(std::string_view wrong, std::string_view name) {
  return std::max<std::size_t>(1, std::min(wrong.size(), name.size()) / 3);
}

/// Whether `some` are words of the name: "takes_all" of "winner_takes_all".
bool are_words_of(std::string_view some, std::string_view name) {
  const std::size_t at = name.find(some);
  if (at == name.npos || some.size() < 3)
    return false;
  const std::size_t end = at + some.size();
  return (at == 0 || name[at - 1] == '_') && (end == name.size() || name[end] == '_');
}

/// How many letters two texts begin with alike.
std::ptrdiff_t alike(std::string_view a, std::string_view b) {
  return std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin();
}

/// The one copy of a name.
const std::string* kept(std::string_view name) {
  static Mutex mutex;
  static auto& names = *new std::set<std::string, std::less<>>;  // outlives whoever names a file
  const std::lock_guard lock(mutex);
  const auto known = names.find(name);
  return known != names.end() ? &*known : &*names.emplace(name).first;
}

}  // namespace

FileName::FileName(std::string_view name) : name_(name.empty() ? nullptr : kept(name)) {}

std::string Location::text() const {
  const std::string name = printable(file.text(), kLongestPath);
  if (line <= 0)
    return name;
  const std::string place = column > 0 ? fmt::format("{}:{}", line, column) : std::to_string(line);
  return name.empty() ? "line " + place : fmt::format("{}:{}", name, place);
}

std::string Diagnostic::text() const {
  const std::string place = where.text();
  // names of files and keys stand in both, and whoever wrote the file chose them
  return printable(place.empty() ? message : fmt::format("{}: {}", place, message), kLongestLine);
}

std::nullopt_t Diagnostics::error(Location where, std::string message) {
  if (!full())
    found_.push_back({where, std::move(message)});
  ++count_;
  return std::nullopt;
}

void Diagnostics::merge(const Diagnostics& other) {
  const std::size_t total = count_ + other.count_;
  const std::vector<Diagnostic> added = other.found_;  // a copy: `other` may be this
  for (const Diagnostic& one : added)
    error(one.where, one.message);
  count_ = total;
}

void Diagnostics::trace_to(std::size_t before, const Location& where, std::string_view words) {
  for (std::size_t i = before; i < found_.size(); ++i)
    if (found_[i].where.file != where.file || found_[i].where.line != where.line)
      found_[i].message += fmt::format(" ({} {})", words, where.text());
}

std::vector<Diagnostic> Diagnostics::sorted() const {
  // the place of each mistake: its file by first appearance, line, column, and order of reporting
  using Place = std::tuple<std::size_t, int, int, std::size_t>;
  std::unordered_map<std::string_view, std::size_t> files;
  std::vector<Place> places;
  for (const Diagnostic& d : found_) {
    const std::size_t rank = files.emplace(d.where.file.text(), files.size()).first->second;
    places.emplace_back(rank, d.where.line, d.where.column, places.size());
  }
  std::ranges::sort(places);

  // equal mistakes share a place, but others of that place may stand between them
  std::vector<Diagnostic> unique;
  for (const Place& place : places) {
    const Diagnostic& d = found_[std::get<3>(place)];
    const auto elsewhere = std::find_if(unique.rbegin(), unique.rend(),
                                        [&](const Diagnostic& u) { return u.where != d.where; });
    if (std::find(unique.rbegin(), elsewhere, d) == elsewhere)
      unique.push_back(d);
  }
  return unique;
}

std::string Diagnostics::text(std::size_t limit) const {
  const std::vector<Diagnostic> all = sorted();
  const std::size_t printed = std::min(limit, all.size());
  std::string result;
  for (std::size_t i = 0; i < printed; ++i)
    result += (i == 0 ? "" : "\n") + all[i].text();
  const std::size_t rest = all.size() - printed;
  // those that were not kept may repeat others
  const bool dropped = count_ > found_.size();
  if (rest > 0 || dropped)
    result += fmt::format("{}... and {} more", printed == 0 ? "" : "\n",
                          rest == 0 ? "perhaps" : fmt::format("{}{}", rest, dropped ? " or" : ""));
  return result;
}

void Diagnostics::throw_if_any() const {
  if (!ok())
    throw ConfigError(*this);
}

ConfigError::ConfigError(Diagnostics diagnostics)
    : std::runtime_error(diagnostics.text()), diagnostics_(std::move(diagnostics)) {}

ConfigError::ConfigError(Location where, std::string message)
    : ConfigError([&] {
        Diagnostics one;
        one.error(where, std::move(message));
        return one;
      }()) {}

std::string did_you_mean(std::string_view wrong, const NameList& names) {
  if (wrong.empty() || wrong.size() > kLongestName)
    return {};
  std::optional<std::string_view> best;
  std::size_t best_distance = kLongestName;
  for (const std::string_view name : names) {
    if (name == wrong)
      return fmt::format("; did you mean '{}'?", name);
    if (best_distance == 0 || name.empty() || name.size() > kLongestName)
      continue;  // only the same name is nearer than one that differs in letter case alone
    // as many edits as one is longer than the other it takes at least
    const std::size_t longer = std::max(wrong.size(), name.size());
    const std::size_t most = std::min(tolerance(wrong, name), best_distance);
    if (longer - std::min(wrong.size(), name.size()) > most)
      continue;
    const std::size_t distance = edit_distance(wrong, name, most);
    // one edit in a name of one letter leaves nothing of it; of two the one that begins alike
    if (distance <= most && distance < name.size() &&
        (distance < best_distance || alike(wrong, name) > alike(wrong, *best))) {
      best = name;
      best_distance = distance;
    }
  }
  if (!best) {
    // half a name, if it is of no other
    const auto has = [wrong](std::string_view name) { return are_words_of(wrong, name); };
    const auto one = std::ranges::find_if(names, has);
    if (one != names.end() && std::none_of(one + 1, names.end(), has))
      best = *one;
  }
  return best ? fmt::format("; did you mean '{}'?", *best) : std::string{};
}

std::string nearest_or_all(std::string_view wrong, const NameList& names) {
  constexpr std::size_t kGlance = 250;  // characters
  std::string hint = did_you_mean(wrong, names);
  if (!hint.empty() || names.empty())
    return hint;
  std::vector<std::string_view> once;
  for (const std::string_view name : names)
    if (once.size() < kGlance && std::ranges::find(once, name) == once.end())
      once.push_back(name);
  const std::string all = printable(fmt::format(", only {}", fmt::join(once, ", ")));
  return all.size() <= kGlance ? all : "";
}

std::string quote(std::string_view text) {
  const std::string quoted = "'" + printable(text, kLongestQuote) + "'";
  const auto odd = look_alike(text);
  return odd ? fmt::format("{} (with the character U+{:04X})", quoted,
                           static_cast<std::uint32_t>(*odd))
             : quoted;
}

std::string quote_path(std::string_view path) {
  return "'" + printable(path, kLongestPath) + "'";
}

}  // namespace eyrie
