// SPDX-License-Identifier: MIT
#include "record/run_file.hpp"

#include "core/assert.hpp"
#include "core/bytes.hpp"

namespace eyrie::record {
namespace {

constexpr std::string_view kMagic = "EYRIERUN";
constexpr std::uint32_t kByteOrder = 0x01020304;
constexpr std::size_t kChecksum = sizeof(std::uint64_t);
constexpr std::size_t kLargest = std::size_t{1} << 30;  // a day of a hundred players is 1 % of it

void put_text(std::string& out, std::string_view text) {
  put_number<std::uint64_t>(out, text.size());
  out.append(text);
}

bool same_bytes(const std::vector<sim::Order>& a, const std::vector<sim::Order>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(sim::Order)) == 0);
}

constexpr std::size_t kChunk = 1 << 12;
constexpr std::size_t kEnds = 32;  // more than a sink holds back

}  // namespace

bool operator==(const RunFile& a, const RunFile& b) {
  return a.build == b.build && a.scenario == b.scenario && a.files == b.files && a.sets == b.sets &&
         a.seed == b.seed && a.layout_hash == b.layout_hash && a.plugins == b.plugins &&
         a.trail == b.trail && same_bytes(a.orders, b.orders) && a.outcome == b.outcome;
}

RunFile run_file_of(const scenario::Scenario& s, std::uint64_t seed, std::string build) {
  RunFile run;
  run.build = std::move(build);
  run.scenario = s.file;
  run.files = s.files;
  run.sets = s.sets;
  run.seed = seed;
  run.layout_hash = s.simulation->schema().layout_hash();
  run.plugins = s.plugins;
  return run;
}

std::string RunEncoder::head(const RunFile& run) {
  std::string out(kMagic);
  put_number(out, kRunFileVersion);
  put_number(out, kByteOrder);
  put_text(out, run.build);
  put_text(out, run.scenario);
  put_number<std::uint64_t>(out, run.files.size());
  for (const auto& [name, text] : run.files) {
    put_text(out, name);
    put_text(out, text);
  }
  put_number<std::uint64_t>(out, run.sets.size());
  for (const std::string& set : run.sets)
    put_text(out, set);
  put_number(out, run.seed);
  put_number(out, run.layout_hash);
  put_number<std::uint64_t>(out, run.plugins.size());
  for (const scenario::PluginFile& plugin : run.plugins) {
    put_text(out, plugin.path);
    put_number(out, plugin.hash);
  }
  return hashed(std::move(out));
}

std::string RunEncoder::chunk(std::string_view spans) {
  EYRIE_ASSERT(!spans.empty());
  std::string out;
  put_text(out, spans);
  return hashed(std::move(out));
}

std::string RunEncoder::tail(std::uint32_t steps_per_second, std::span<const sim::Order> orders,
                             std::string_view outcome) {
  std::string out;
  put_text(out, "");  // no more chunks
  put_number(out, steps_per_second);
  put_number<std::uint64_t>(out, orders.size());
  out.append(reinterpret_cast<const char*>(orders.data()), orders.size_bytes());
  put_text(out, outcome);
  out = hashed(std::move(out));
  put_number(out, hasher_.value());
  return out;
}

std::string RunEncoder::hashed(std::string bytes) {
  hasher_.bytes(bytes.data(), bytes.size());
  return bytes;
}

std::string encode(const RunFile& run) {
  RunEncoder encoder;
  std::string bytes = encoder.head(run);
  if (!run.trail.spans.empty())
    bytes += encoder.chunk(run.trail.spans);
  return bytes += encoder.tail(run.trail.steps_per_second, run.orders, run.outcome);
}

Decoded decode(std::string_view bytes) {
  if (!bytes.starts_with(kMagic.substr(0, std::min(bytes.size(), kMagic.size()))) || bytes.empty())
    return {{}, "this is not a run file"};
  const std::size_t head = kMagic.size() + 2 * sizeof(std::uint32_t);
  if (bytes.size() < head + kChecksum)
    return {{}, "the run file is cut"};
  ByteReader r(bytes.substr(kMagic.size(), bytes.size() - kMagic.size() - kChecksum));
  const auto version = r.number<std::uint32_t>();
  if (r.number<std::uint32_t>() != kByteOrder)
    return {{}, "the run file comes from a machine of another byte order"};
  if (version != kRunFileVersion)
    return {{},
            fmt::format("the run file has format version {}, and this Eyrie reads version {}: open "
                        "it with the one that recorded it",
                        version, kRunFileVersion)};
  const auto sum = ByteReader(bytes.substr(bytes.size() - kChecksum)).number<std::uint64_t>();
  if (sum != scenario::hash_of(bytes.substr(0, bytes.size() - kChecksum)))
    return {{}, "the run file is cut or corrupt: its checksum does not fit"};

  Decoded result;
  RunFile& run = result.run;
  run.build = r.text();
  run.scenario = r.text();
  const auto files = r.number<std::uint64_t>();
  for (std::uint64_t i = 0; r.has(files - i, 16) && i < files; ++i) {
    std::string name(r.text());
    run.files[std::move(name)] = r.text();
  }
  const auto sets = r.number<std::uint64_t>();
  for (std::uint64_t i = 0; r.has(sets - i, 8) && i < sets; ++i)
    run.sets.emplace_back(r.text());
  run.seed = r.number<std::uint64_t>();
  run.layout_hash = r.number<std::uint64_t>();
  const auto plugins = r.number<std::uint64_t>();
  for (std::uint64_t i = 0; r.has(plugins - i, 16) && i < plugins; ++i) {
    std::string path(r.text());
    run.plugins.push_back({std::move(path), r.number<std::uint64_t>()});
  }
  std::string spans;
  for (auto size = r.number<std::uint64_t>(); size > 0; size = r.number<std::uint64_t>())
    spans += r.bytes(size);
  const auto steps_per_second = r.number<std::uint32_t>();
  run.orders = r.block<sim::Order>();
  run.outcome = r.text();
  if (!r.ok() || !r.at_end())
    return {{}, "the run file is corrupt: its sections do not fit"};
  if (spans.empty())
    return {{}, "the run file has no hashes that a replay could be compared with"};
  auto trail = sim::trail_of(std::move(spans), steps_per_second);
  if (!trail)
    return {{}, "the run file is corrupt: its hashes do not fit"};
  run.trail = std::move(*trail);
  return result;
}

Decoded read_run_file(const std::string& path) {
  const disk::FileRead read = disk::read_file(path, kLargest);
  return read.problem.empty() ? decode(read.bytes) : Decoded{{}, read.problem};
}

RunFileWriter::RunFileWriter(disk::Sink& sink, const RunFile& run) : sink_(sink) {
  sink_.write(encoder_.head(run));
}

void RunFileWriter::observe(const sim::World& world, const sim::StepInfo& info,
                            std::span<const sim::Event> events) {
  trail_.observe(world, info, events);
  if (trail_.spans().size() >= kChunk)
    write_chunk();
}

std::string RunFileWriter::close(std::span<const sim::Order> orders, std::string_view outcome) {
  write_chunk();
  sink_.write(encoder_.tail(trail_.steps_per_second(), orders, outcome));
  std::string lost;
  for (; !sink_.flush() && !ends_.empty(); ends_.pop_back()) {
    End& end = ends_.back();
    const std::string error = sink_.error();
    if (!sink_.cut(end.size))
      continue;
    const auto later =
        std::ranges::find_if(orders, [&](const sim::Order& o) { return o.step >= end.step; });
    sink_.write(end.encoder.tail(trail_.steps_per_second(), {orders.begin(), later}, outcome));
    kept_until_ = static_cast<double>(end.step) / trail_.steps_per_second();
    lost =
        fmt::format("{}; the run is kept up to {} s", error, end.step / trail_.steps_per_second());
  }
  return sink_.error().empty() ? lost : "";
}

void RunFileWriter::write_chunk() {
  const std::string spans = trail_.take();
  if (spans.empty())
    return;
  sink_.write(encoder_.chunk(spans));
  if (!sink_.error().empty())
    return;
  ends_.push_back({sink_.size(), encoder_, trail_.last_step()});
  if (ends_.size() > kEnds)
    ends_.pop_front();
}

}  // namespace eyrie::record
