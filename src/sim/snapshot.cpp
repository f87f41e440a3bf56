// SPDX-License-Identifier: MIT
#include "sim/snapshot.hpp"

#include <istream>
#include <ostream>

#include "core/assert.hpp"
#include "core/hash.hpp"

namespace eyrie::sim {

namespace {

constexpr std::array<char, 8> kMagic{'E', 'Y', 'R', 'I', 'E', 'W', 'L', 'D'};
constexpr std::uint32_t kByteOrder = 0x01020304;
constexpr std::uint32_t kOtherByteOrder = 0x04030201;

/// What stands before the data.
struct Preamble {
  std::array<char, 8> magic;
  std::uint32_t version;
  std::uint32_t byte_order;
  std::uint64_t layout;
  std::uint64_t size;  ///< bytes of the data that follows, the checksum excluded
};
static_assert(sizeof(Preamble) == 32 && std::has_unique_object_representations_v<Preamble>);

/// Passes bytes on and hashes them on the way.
class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) {}
  void write(const void* data, std::size_t size) {
    hasher_.bytes(data, size);
    out_.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
  [[nodiscard]] bool finish() {
    const std::uint64_t checksum = hasher_.value();
    out_.write(reinterpret_cast<const char*>(&checksum), sizeof checksum);
    out_.flush();
    return out_.good();
  }

 private:
  std::ostream& out_;
  Hasher hasher_;
};

}  // namespace

/// Fills a World from a stream; the only one besides the step that may touch its header.
class WorldReader {
 public:
  WorldReader(std::shared_ptr<const Schema> schema, std::istream& in)
      : in_(in), world_(std::move(schema), 0) {}

  [[nodiscard]] Loaded load() {
    std::string error = read_preamble();
    if (error.empty())
      error = read_header();
    if (error.empty())
      error = read_columns();
    if (!error.empty())
      return {std::nullopt, std::move(error)};
    return {std::move(world_), {}};
  }

 private:
  [[nodiscard]] bool read(void* data, std::size_t size) {
    in_.read(static_cast<char*>(data), static_cast<std::streamsize>(size));
    if (static_cast<std::size_t>(in_.gcount()) != size)
      return false;
    hasher_.bytes(data, size);
    return true;
  }

  std::string read_preamble() {
    preamble_ = {};
    const bool whole = read(&preamble_, sizeof preamble_);
    if (preamble_.magic != kMagic)
      return "this is not a saved world: it does not begin with EYRIEWLD";
    if (!whole)
      return cut();
    if (preamble_.byte_order == kOtherByteOrder)
      return "the world was saved on a machine of the other byte order";
    if (preamble_.byte_order != kByteOrder)
      return "the saved world is damaged: the byte-order mark is wrong";
    if (preamble_.version != kSnapshotVersion)
      return fmt::format("the saved world has format version {}, this program reads version {}",
                         preamble_.version, kSnapshotVersion);
    if (preamble_.layout != world_.schema().layout_hash())
      return fmt::format(
          "the saved world has another layout (0x{:016x}) than this program and "
          "scenario (0x{:016x})",
          preamble_.layout, world_.schema().layout_hash());
    return {};
  }

  std::string read_header() {
    const Schema& schema = world_.schema();
    const std::size_t size = World::header_bytes(schema.tables().size());
    if (!read(world_.data(), size))
      return cut();
    std::uint64_t expected = size;
    for (std::uint32_t t = 1; t <= schema.tables().size(); ++t) {
      const TableInfo& table = schema.table(TableId{t});
      if (world_.rows(TableId{t}) > table.capacity)
        return fmt::format("table '{}' of the saved world has {} rows, there is room for {}",
                           table.name, world_.rows(TableId{t}), table.capacity);
      for (const std::uint32_t index : table.columns)
        expected += world_.column_bytes(index).size();
    }
    if (preamble_.size != expected)
      return fmt::format(
          "the saved world is damaged: it claims {} bytes of data, its tables need {}",
          preamble_.size, expected);
    return {};
  }

  std::string read_columns() {
    for (std::uint32_t i = 0; i < world_.schema().columns().size(); ++i)
      if (!read(world_.data() + world_.schema().column(i).offset, world_.column_bytes(i).size()))
        return cut();
    const std::uint64_t expected = hasher_.value();
    std::uint64_t checksum = 0;
    if (!read(&checksum, sizeof checksum))
      return cut();
    if (checksum != expected)
      return "the saved world is damaged: its checksum does not match";
    if (!world_.canonical())
      return "the saved world is damaged: its players are not in order";
    return {};
  }

  static std::string cut() { return "the saved world is cut: it ends before its data does"; }

  std::istream& in_;
  Hasher hasher_;
  Preamble preamble_{};
  World world_;
};

bool save(const World& world, std::ostream& out) {
  EYRIE_THROW_UNLESS(world.canonical(), "only a world between two steps can be saved");
  const Schema& schema = world.schema();
  const std::span<const std::byte> header = world.header_bytes();
  std::uint64_t size = header.size();
  for (std::uint32_t i = 0; i < schema.columns().size(); ++i)
    size += world.column_bytes(i).size();

  Writer writer(out);
  const Preamble preamble{.magic = kMagic,
                          .version = kSnapshotVersion,
                          .byte_order = kByteOrder,
                          .layout = schema.layout_hash(),
                          .size = size};
  writer.write(&preamble, sizeof preamble);
  writer.write(header.data(), header.size());
  for (std::uint32_t i = 0; i < schema.columns().size(); ++i)
    writer.write(world.column_bytes(i).data(), world.column_bytes(i).size());
  return writer.finish();
}

Loaded load(std::shared_ptr<const Schema> schema, std::istream& in) {
  return WorldReader(std::move(schema), in).load();
}

}  // namespace eyrie::sim
