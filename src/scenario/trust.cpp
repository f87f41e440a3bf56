// SPDX-License-Identifier: MIT
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <sha2.h>  // libmd
#include <system_error>

#include "core/diagnostics.hpp"
#include "core/text.hpp"
#include "disk/output.hpp"
#include "scenario/plugin_file.hpp"

namespace eyrie::scenario {
namespace {
namespace fs = std::filesystem;

constexpr std::size_t kDigits = 64;
constexpr std::string_view kBetween = "  ";

bool is_hexadecimal(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'f');
}
bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

/// What is wrong with a line; empty if nothing is.
std::string line_problem(std::string_view line) {
  if (line.size() < kDigits || !std::all_of(line.begin(), line.begin() + kDigits, is_hexadecimal) ||
      line.substr(kDigits, kBetween.size()) != kBetween)
    return "expected a SHA-256 (64 small hexadecimal digits), two spaces and a path";
  const std::string_view path = line.substr(kDigits + kBetween.size());
  if (!path.starts_with('/') || std::ranges::any_of(path, is_control))
    return fmt::format("{} is not an absolute path", quote(path));
  return {};
}

}  // namespace

disk::FileRead read_allowed(const std::string& path, const PluginPermission* permission,
                            std::string_view shown) {
  const auto refused = [&](const std::string& sha256) {
    if (!permission)
      return std::string();
    const std::string why = *permission ? (*permission)(path, sha256) : "it is not trusted";
    const std::string word = shell_word(shown);
    return why.empty() ? why
                       : fmt::format(
                             "it was not opened: {}; add '--plugin {}', or trust it with "
                             "'eyrie trust {}'",
                             why, word, word);
  };
  disk::FileRead read;
  read.problem = refused("");
  if (read.problem.empty())
    read = read_plugin_file(path);
  if (read.problem.empty() && permission)
    read.problem = refused(sha256(read.bytes));
  return read;
}

TrustList TrustList::read(const std::string& file) {
  TrustList list;
  constexpr std::size_t kLargest = 1 << 20;
  const disk::FileRead read = disk::read_file(file, kLargest);
  if (read.missing)
    return list;
  if (!read.problem.empty())
    throw ConfigError({file, 0, 0}, read.problem);
  if (read.owner != ::geteuid() && read.owner != 0)
    throw ConfigError({file, 0, 0}, "belongs to somebody else; what it trusts is not trusted");
  if ((read.mode & (S_IWGRP | S_IWOTH)) != 0)
    throw ConfigError({file, 0, 0},
                      "others may write to it; what it trusts is not trusted (chmod go-w {})",
                      shell_word(file));
  Diagnostics wrong;
  std::string_view rest = read.bytes;
  for (int line = 1; !rest.empty(); ++line) {
    const auto end = rest.find('\n');
    const std::string_view text = rest.substr(0, end);
    std::string problem = end == rest.npos ? "the line has no end" : line_problem(text);
    rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
    if (problem.empty()) {
      Entry entry{std::string(text.substr(0, kDigits)),
                  std::string(text.substr(kDigits + kBetween.size()))};
      const auto same = [&](const Entry& other) { return other.path == entry.path; };
      if (std::ranges::none_of(list.entries_, same)) {
        list.add(std::move(entry));
        continue;
      }
      problem = "this path stands there twice";
    }
    wrong.error({file, line, 1}, std::move(problem));
  }
  wrong.throw_if_any();
  return list;
}

void TrustList::write(const std::string& file) const {
  std::error_code failed;
  const fs::path folder = fs::path(file).parent_path();
  fs::create_directories(folder, failed);
  if (failed)
    throw std::runtime_error(
        fmt::format("cannot make {}: {}", shell_word(folder.string()), failed.message()));
  std::string text;
  for (const Entry& entry : entries_)
    text += fmt::format("{}{}{}\n", entry.sha256, kBetween, entry.path);

  disk::OutputFile out(file, true, 0600);
  out.sink().write(text);
  out.commit();
}

std::string TrustList::why_not(const std::string& path, const std::string& sha256) const {
  for (const Entry& entry : entries_)
    if (entry.path == path)
      return sha256.empty() || entry.sha256 == sha256
                 ? ""
                 : "it has other bytes than when it was trusted";
  return "it is not trusted";
}

void TrustList::add(Entry entry) {
  remove(entry.path);
  const auto after = std::ranges::upper_bound(
      entries_, entry, [](const Entry& a, const Entry& b) { return a.path < b.path; });
  entries_.insert(after, std::move(entry));
}

bool TrustList::remove(std::string_view path) {
  return std::erase_if(entries_, [&](const Entry& entry) { return entry.path == path; }) > 0;
}

std::string sha256(std::string_view bytes) {
  SHA2_CTX context;
  SHA256Init(&context);
  SHA256Update(&context, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  std::array<std::uint8_t, SHA256_DIGEST_LENGTH> digest;
  SHA256Final(digest.data(), &context);
  std::string text;
  for (const std::uint8_t byte : digest)
    fmt::format_to(std::back_inserter(text), "{:02x}", byte);
  return text;
}

}  // namespace eyrie::scenario
