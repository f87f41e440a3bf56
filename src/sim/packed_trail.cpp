// SPDX-License-Identifier: MIT
#include "sim/packed_trail.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

#include "core/assert.hpp"

namespace eyrie::sim {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class T>
void put(std::string& out, T number) {
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  out.append(bytes, sizeof number);
}

void put_varint(std::string& out, std::uint64_t number) {
  for (; number >= 128; number >>= 7)
    out.push_back(static_cast<char>(number | 128));
  out.push_back(static_cast<char>(number));
}

constexpr char kSamePlayers = 0, kOtherPlayers = 1;

/// Steps of any run.
constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max() / 2;

bool same_players(const std::vector<Digest::Row>& a, const std::vector<Digest::Row>& b) {
  if (a.size() != b.size())
    return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].table != b[i].table || a[i].player != b[i].player)
      return false;
  return true;
}

/// What is in one of two sorted lists only.
void parted(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b,
            std::vector<std::uint32_t>& out) {
  out.clear();
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
}

}  // namespace

void TrailPacker::mark(const Mark& mark) {
  put_varint(out_, mark.step - last_.step);
  for (const std::uint16_t fold : folds_)
    put(out_, fold);
  put(out_, mark.hash);
  put(out_, mark.digest.header);
  put_fields(mark.digest.fields);
  put_rows(mark.digest.rows);
  folds_.clear();
  last_ = mark;
}

/// The first time their number and all of them. Then which of them changed: how many did now and
/// not the last time, or the other way round, and the gaps between those; and what they are now.
void TrailPacker::put_fields(const std::vector<std::uint16_t>& fields) {
  const std::vector<std::uint16_t>& last = last_.digest.fields;
  if (last.size() != fields.size()) {
    EYRIE_ASSERT(last.empty());
    put_varint(out_, fields.size());
    for (const std::uint16_t field : fields)
      put(out_, field);
    return;
  }
  now_.clear();
  for (std::uint32_t i = 0; i < fields.size(); ++i)
    if (fields[i] != last[i])
      now_.push_back(i);
  parted(changed_, now_, others_);
  put_varint(out_, others_.size());
  std::uint32_t at = 0;
  for (const std::uint32_t other : others_)
    put_varint(out_, other - std::exchange(at, other));
  for (const std::uint32_t i : now_)
    put(out_, fields[i]);
  changed_.swap(now_);
}

void TrailPacker::put_rows(const std::vector<Digest::Row>& rows) {
  if (same_players(rows, last_.digest.rows)) {
    out_.push_back(kSamePlayers);
  } else {
    out_.push_back(kOtherPlayers);
    put_varint(out_, rows.size());
    for (const Digest::Row& row : rows) {
      put_varint(out_, row.table);
      put_varint(out_, row.player.value);
    }
  }
  for (const Digest::Row& row : rows)
    put(out_, row.hash);
}

std::string TrailPacker::take() {
  return std::exchange(out_, {});
}

template <class T>
T TrailUnpacker::number() {
  T number{};
  ok_ = ok_ && left_.size() >= sizeof number;
  if (!ok_)
    return 0;
  std::memcpy(&number, left_.data(), sizeof number);
  left_.remove_prefix(sizeof number);
  return number;
}

std::uint64_t TrailUnpacker::varint() {
  std::uint64_t result = 0;
  for (unsigned shift = 0; shift < 63; shift += 7) {
    const auto byte = number<std::uint8_t>();
    result |= std::uint64_t{byte & 127U} << shift;
    if (byte < 128)
      return result;
  }
  ok_ = false;
  return 0;
}

bool TrailUnpacker::next() {
  if (left_.empty() || !ok_)
    return false;
  ok_ = read_span() && ok_;
  any_ = true;
  return ok_;
}

bool TrailUnpacker::read_span() {
  // the first span is the start, without folds; each other one has steps
  const std::uint64_t steps = varint();
  if (!ok_ || (any_ && steps == 0) || steps > kMost - mark_.step)
    return false;
  const std::uint64_t end = mark_.step + steps;
  begin_ = any_ ? mark_.step : end;
  const std::uint64_t folds = end / period_ - begin_ / period_;
  if (folds > left_.size() / sizeof(std::uint16_t))
    return false;
  folds_ = left_.substr(0, folds * sizeof(std::uint16_t));
  left_.remove_prefix(folds_.size());
  mark_.step = mark_.digest.step = end;
  mark_.hash = number<std::uint64_t>();
  mark_.digest.header = number<std::uint16_t>();
  return read_fields() && read_rows();
}

bool TrailUnpacker::read_fields() {
  std::vector<std::uint16_t>& fields = mark_.digest.fields;
  const std::uint64_t count = varint();
  if (!ok_ || count > left_.size() / (any_ ? 1 : sizeof(std::uint16_t)))
    return false;
  if (!any_) {
    fields.resize(count);
    for (std::uint16_t& field : fields)
      field = number<std::uint16_t>();
    return ok_;
  }
  others_.clear();
  std::uint64_t at = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t gap = varint();
    if (!ok_ || gap >= fields.size() - at || (gap == 0 && i > 0))
      return false;
    at += gap;
    others_.push_back(static_cast<std::uint32_t>(at));
  }
  parted(changed_, others_, now_);
  changed_.swap(now_);
  if (changed_.size() > left_.size() / sizeof(std::uint16_t))
    return false;
  for (const std::uint32_t i : changed_)
    fields[i] = number<std::uint16_t>();
  return ok_;
}

bool TrailUnpacker::read_rows() {
  std::vector<Digest::Row>& rows = mark_.digest.rows;
  const char kind = number<char>();
  if (kind != kSamePlayers && kind != kOtherPlayers)
    return false;
  if (kind == kOtherPlayers) {
    const std::uint64_t count = varint();
    if (!ok_ || count > left_.size() / 4)  // table, player, digest
      return false;
    rows.resize(count);
    for (Digest::Row& row : rows) {
      row.table = static_cast<std::uint32_t>(varint());
      row.player = PlayerId{static_cast<std::uint32_t>(varint())};
    }
  }
  for (Digest::Row& row : rows)
    row.hash = number<std::uint16_t>();
  return ok_;
}

std::uint16_t TrailUnpacker::fold(std::uint64_t step) const {
  const std::uint64_t index = step / period_ - begin_ / period_ - 1;
  std::uint16_t fold = 0;
  std::memcpy(&fold, folds_.data() + index * sizeof fold, sizeof fold);
  return fold;
}

}  // namespace eyrie::sim
