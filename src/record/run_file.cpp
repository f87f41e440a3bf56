// SPDX-License-Identifier: MIT
#include "record/run_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <type_traits>

#include "core/hash.hpp"

namespace eyrie::record {
namespace {

constexpr std::string_view kMagic = "EYRIERUN";
constexpr std::uint32_t kByteOrder = 0x01020304;
constexpr std::size_t kChecksum = sizeof(std::uint64_t);

std::uint64_t checksum(std::string_view bytes) {
  return hash_bytes(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

class Writer {
 public:
  template <class T>
  void number(T x) {
    static_assert(std::is_arithmetic_v<T>);
    raw(&x, sizeof x);
  }
  void text(std::string_view s) {
    number<std::uint64_t>(s.size());
    out_.append(s);
  }
  template <class T>
  void block(const std::vector<T>& items) {
    static_assert(std::is_trivially_copyable_v<T>);
    number<std::uint64_t>(items.size());
    raw(items.data(), items.size() * sizeof(T));
  }
  void raw(const void* data, std::size_t size) {
    out_.append(static_cast<const char*>(data), size);
  }
  std::string finish() {
    number(checksum(out_));
    return std::move(out_);
  }

 private:
  std::string out_;
};

/// Reads what Writer wrote. Everything is checked against what is left; after the first failure
/// all reads give zero and ok() is false.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}

  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] bool at_end() const { return left_.empty(); }

  template <class T>
  T number() {
    T x{};
    take(&x, sizeof x);
    return x;
  }
  std::string text() {
    const auto size = number<std::uint64_t>();
    if (!has(size, 1))
      return {};
    std::string s(left_.substr(0, size));
    left_.remove_prefix(size);
    return s;
  }
  template <class T>
  std::vector<T> block() {
    const auto count = number<std::uint64_t>();
    if (!has(count, sizeof(T)))
      return {};
    std::vector<T> items(count);
    take(items.data(), count * sizeof(T));
    return items;
  }
  /// Whether `count` items of at least `size` bytes can follow.
  bool has(std::uint64_t count, std::size_t size) {
    ok_ = ok_ && count <= left_.size() / size;
    return ok_;
  }

 private:
  void take(void* to, std::size_t size) {
    if (!has(size, 1) || size == 0)
      return;
    std::memcpy(to, left_.data(), size);
    left_.remove_prefix(size);
  }

  std::string_view left_;
  bool ok_ = true;
};

void write_trail(Writer& w, const sim::HashTrail& trail) {
  w.number(trail.first_step);
  w.number(trail.steps_per_mark);
  w.block(trail.folds);
  w.number<std::uint64_t>(trail.marks.size());
  for (const sim::HashTrail::Mark& mark : trail.marks) {
    w.number(mark.step);
    w.number(mark.hash);
    w.number(mark.digest.step);
    w.number(mark.digest.header);
    w.block(mark.digest.fields);
    w.block(mark.digest.rows);
  }
}

sim::HashTrail read_trail(Reader& r) {
  sim::HashTrail trail;
  trail.first_step = r.number<std::uint64_t>();
  trail.steps_per_mark = r.number<std::uint32_t>();
  trail.folds = r.block<std::uint32_t>();
  const auto marks = r.number<std::uint64_t>();
  if (!r.has(marks, 44))  // the fixed part of a mark
    return trail;
  trail.marks.resize(marks);
  for (sim::HashTrail::Mark& mark : trail.marks) {
    mark.step = r.number<std::uint64_t>();
    mark.hash = r.number<std::uint64_t>();
    mark.digest.step = r.number<std::uint64_t>();
    mark.digest.header = r.number<std::uint32_t>();
    mark.digest.fields = r.block<std::uint32_t>();
    mark.digest.rows = r.block<sim::Digest::Row>();
  }
  return trail;
}

bool same_bytes(const std::vector<sim::Order>& a, const std::vector<sim::Order>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(sim::Order)) == 0);
}

}  // namespace

bool operator==(const RunFile& a, const RunFile& b) {
  return a.build == b.build && a.scenario == b.scenario && a.files == b.files && a.sets == b.sets &&
         a.seed == b.seed &&
         std::bit_cast<std::uint64_t>(a.until) == std::bit_cast<std::uint64_t>(b.until) &&
         a.layout_hash == b.layout_hash && same_bytes(a.orders, b.orders) && a.trail == b.trail &&
         a.outcome == b.outcome && a.plugins == b.plugins;
}

std::string encode(const RunFile& run) {
  Writer w;
  w.raw(kMagic.data(), kMagic.size());
  w.number(run.plugins.empty() ? kRunFileVersion : kRunFileWithPlugins);
  w.number(kByteOrder);
  w.text(run.build);
  w.text(run.scenario);
  w.number<std::uint64_t>(run.files.size());
  for (const auto& [name, text] : run.files) {
    w.text(name);
    w.text(text);
  }
  w.number<std::uint64_t>(run.sets.size());
  for (const std::string& set : run.sets)
    w.text(set);
  w.number(run.seed);
  w.number(run.until);
  w.number(run.layout_hash);
  w.block(run.orders);
  write_trail(w, run.trail);
  w.text(run.outcome);
  if (!run.plugins.empty()) {
    w.number<std::uint64_t>(run.plugins.size());
    for (const scenario::PluginFile& plugin : run.plugins) {
      w.text(plugin.path);
      w.number(plugin.hash);
    }
  }
  return w.finish();
}

Decoded decode(std::string_view bytes) {
  if (!bytes.starts_with(kMagic.substr(0, std::min(bytes.size(), kMagic.size()))) || bytes.empty())
    return {{}, "this is not a run file"};
  const std::size_t head = kMagic.size() + 2 * sizeof(std::uint32_t);
  if (bytes.size() < head + kChecksum)
    return {{}, "the run file is cut"};
  Reader r(bytes.substr(0, bytes.size() - kChecksum));
  for (std::size_t i = 0; i < kMagic.size(); ++i)
    static_cast<void>(r.number<char>());
  const auto version = r.number<std::uint32_t>();
  if (r.number<std::uint32_t>() != kByteOrder)
    return {{}, "the run file comes from a machine of another byte order"};
  if (version != kRunFileVersion && version != kRunFileWithPlugins)
    return {{},
            fmt::format("the run file has format version {}; this program reads versions {} and {}",
                        version, kRunFileVersion, kRunFileWithPlugins)};
  std::uint64_t sum = 0;
  std::memcpy(&sum, bytes.data() + bytes.size() - kChecksum, kChecksum);
  if (sum != checksum(bytes.substr(0, bytes.size() - kChecksum)))
    return {{}, "the run file is cut or corrupt: its checksum does not fit"};

  Decoded result;
  RunFile& run = result.run;
  run.build = r.text();
  run.scenario = r.text();
  const auto files = r.number<std::uint64_t>();
  for (std::uint64_t i = 0; r.has(files - i, 16) && i < files; ++i) {
    std::string name = r.text();
    run.files[std::move(name)] = r.text();
  }
  const auto sets = r.number<std::uint64_t>();
  for (std::uint64_t i = 0; r.has(sets - i, 8) && i < sets; ++i)
    run.sets.push_back(r.text());
  run.seed = r.number<std::uint64_t>();
  run.until = r.number<double>();
  run.layout_hash = r.number<std::uint64_t>();
  run.orders = r.block<sim::Order>();
  run.trail = read_trail(r);
  run.outcome = r.text();
  if (version == kRunFileWithPlugins) {
    const auto plugins = r.number<std::uint64_t>();
    for (std::uint64_t i = 0; r.has(plugins - i, 16) && i < plugins; ++i) {
      std::string path = r.text();
      run.plugins.push_back({std::move(path), r.number<std::uint64_t>()});
    }
  }
  if (!r.ok() || !r.at_end())
    return {{}, "the run file is corrupt: its sections do not fit"};
  return result;
}

Decoded read_run_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in)
    return {{}, "cannot read the file"};
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (in.bad())
    return {{}, "cannot read the file"};
  return decode(bytes);
}

}  // namespace eyrie::record
