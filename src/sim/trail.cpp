// SPDX-License-Identifier: MIT
#include "sim/trail.hpp"

#include <algorithm>
#include <iterator>

namespace eyrie::sim {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr char kSamePlayers = 0, kOtherPlayers = 1;

/// Steps of any run.
constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max() / 2;

bool same_players(const std::vector<Digest::Row>& a, const std::vector<Digest::Row>& b) {
  const auto player = [](const Digest::Row& row) { return std::pair(row.table, row.player); };
  return std::ranges::equal(a, b, {}, player, player);
}

/// What is in one of two sorted lists only.
void parted(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b,
            std::vector<std::uint32_t>& out) {
  out.clear();
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(out));
}

}  // namespace

void TrailPacker::mark(const Mark& mark) {
  put_varint(out_, mark.step - last_.step);
  for (const std::uint16_t fold : folds_)
    put_number(out_, fold);
  put_number(out_, mark.hash);
  put_number(out_, mark.digest.header);
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
      put_number(out_, field);
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
    put_number(out_, fields[i]);
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
    put_number(out_, row.hash);
}

std::string TrailPacker::take() {
  return std::exchange(out_, {});
}

bool TrailUnpacker::next() {
  if (left_.at_end() || !ok_)
    return false;
  ok_ = read_span() && left_.ok();
  any_ = true;
  return ok_;
}

bool TrailUnpacker::read_span() {
  // the first span is the start, without folds; each other one has steps
  const std::uint64_t steps = left_.varint();
  if (!left_.ok() || (any_ && steps == 0) || steps > kMost - mark_.step)
    return false;
  const std::uint64_t end = mark_.step + steps;
  begin_ = any_ ? mark_.step : end;
  const std::uint64_t folds = end / period_ - begin_ / period_;
  if (!left_.has(folds, sizeof(std::uint16_t)))
    return false;
  folds_ = left_.bytes(folds * sizeof(std::uint16_t));
  mark_.step = mark_.digest.step = end;
  mark_.hash = left_.number<std::uint64_t>();
  mark_.digest.header = left_.number<std::uint16_t>();
  return read_fields() && read_rows();
}

bool TrailUnpacker::read_fields() {
  std::vector<std::uint16_t>& fields = mark_.digest.fields;
  const std::uint64_t count = left_.varint();
  if (!left_.has(count, any_ ? 1 : sizeof(std::uint16_t)))
    return false;
  if (!any_) {
    fields.resize(count);
    for (std::uint16_t& field : fields)
      field = left_.number<std::uint16_t>();
    return left_.ok();
  }
  others_.clear();
  std::uint64_t at = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t gap = left_.varint();
    if (!left_.ok() || gap >= fields.size() - at || (gap == 0 && i > 0))
      return false;
    at += gap;
    others_.push_back(static_cast<std::uint32_t>(at));
  }
  parted(changed_, others_, now_);
  changed_.swap(now_);
  if (!left_.has(changed_.size(), sizeof(std::uint16_t)))
    return false;
  for (const std::uint32_t i : changed_)
    fields[i] = left_.number<std::uint16_t>();
  return left_.ok();
}

bool TrailUnpacker::read_rows() {
  std::vector<Digest::Row>& rows = mark_.digest.rows;
  const char kind = left_.number<char>();
  if (kind != kSamePlayers && kind != kOtherPlayers)
    return false;
  if (kind == kOtherPlayers) {
    const std::uint64_t count = left_.varint();
    if (!left_.has(count, 4))  // table, player, digest
      return false;
    rows.resize(count);
    for (Digest::Row& row : rows) {
      row.table = static_cast<std::uint32_t>(left_.varint());
      row.player = PlayerId{static_cast<std::uint32_t>(left_.varint())};
    }
  }
  for (Digest::Row& row : rows)
    row.hash = left_.number<std::uint16_t>();
  return left_.ok();
}

std::uint16_t TrailUnpacker::fold(std::uint64_t step) const {
  const std::uint64_t index = step / period_ - begin_ / period_ - 1;
  std::uint16_t fold = 0;
  std::memcpy(&fold, folds_.data() + index * sizeof fold, sizeof fold);
  return fold;
}

std::optional<HashTrail> trail_of(std::string spans, std::uint32_t steps_per_second) {
  TrailUnpacker span(spans, steps_per_second);
  bool any = false;
  while (span.next())
    any = true;
  if (!any || !span.ok())
    return std::nullopt;
  return HashTrail{steps_per_second, std::move(spans), span.mark().step, span.mark().hash};
}

HashTrail without_digests(const HashTrail& trail) {
  TrailUnpacker span(trail.spans, trail.steps_per_second);
  TrailPacker packer(trail.steps_per_second);
  std::uint64_t step = 0;
  while (span.next()) {
    for (++step; step <= span.mark().step; ++step)
      if (span.has_fold(step))
        packer.fold(span.fold(step));
    step = span.mark().step;
    packer.mark({.step = step, .hash = span.mark().hash});
  }
  return {trail.steps_per_second, packer.take(), trail.last_step, trail.last_hash};
}

void TrailRecorder::begin(const World& world, double dt) {
  steps_per_second_ = steps_in_a_second(dt);
  packer_ = TrailPacker(steps_per_second_);
  mark(world, world.hash());
}

void TrailRecorder::observe(const World& world, const StepInfo&, std::span<const Event>) {
  const bool folds = packer_.is_fold(world.step());
  const bool marks = is_mark(world.step(), steps_per_second_);
  if (!folds && !marks)
    return;
  const std::uint64_t hash = world.hash();
  if (folds)
    packer_.fold(fold(hash));
  if (marks)
    mark(world, hash);
}

void TrailRecorder::finish(const World& world) {
  if (mark_.step != world.step())
    mark(world, world.hash());
}

HashTrail TrailRecorder::trail_to(const World& world) const {
  if (mark_.step == world.step())
    return trail();
  TrailPacker packer = packer_;
  Mark end{.step = world.step(), .hash = world.hash()};
  if (digests_)
    digest(world, end.digest);
  packer.mark(end);
  return {steps_per_second_, packer.bytes(), end.step, end.hash};
}

void TrailRecorder::mark(const World& world, std::uint64_t hash) {
  mark_.step = world.step();
  mark_.hash = hash;
  if (digests_)
    digest(world, mark_.digest);
  packer_.mark(mark_);
}

TrailChecker::TrailChecker(const HashTrail& expected)
    : expected_(expected), span_(expected.spans, expected.steps_per_second) {
  more_ = span_.next();
}

void TrailChecker::begin(const World& world, double dt) {
  if (!more_ || world.step() != span_.mark().step)
    depart(world.step(), fmt::format("the replay begins at step {}, the recording at {}",
                                     world.step(), span_.mark().step));
  else if (steps_in_a_second(dt) != expected_.steps_per_second)
    depart(world.step(), fmt::format("the replay makes {} steps per second, the recording {}",
                                     steps_in_a_second(dt), expected_.steps_per_second));
  else
    return check_mark(world, world.hash());
  over_ = true;
}

void TrailChecker::observe(const World& world, const StepInfo&, std::span<const Event>) {
  if (done())
    return;
  if (more_)
    check(world);
  else if (!departure_)
    depart(world.step(),
           fmt::format("the recording ends at step {}, the replay goes on", expected_.last_step));
}

void TrailChecker::finish(const World& world) {
  over_ = true;
  if (!departure_ && more_)
    depart(world.step(), fmt::format("the replay ends at step {}, the recording goes on to {}",
                                     world.step(), expected_.last_step));
}

void TrailChecker::check(const World& world) {
  const bool marks = world.step() == span_.mark().step;
  const bool folds = !departure_ && span_.has_fold(world.step());
  if (!folds && !marks)
    return;
  const std::uint64_t hash = world.hash();
  if (folds && !marks) {
    if (span_.fold(world.step()) == fold(hash))
      last_good_ = world.step();
    else
      depart(world.step(), {});
  }
  if (marks)
    check_mark(world, hash);
}

void TrailChecker::check_mark(const World& world, std::uint64_t hash) {
  if (span_.mark().hash == hash) {
    last_good_ = world.step();
    over_ = departure_.has_value();  // only a fold was wrong
  } else {
    if (!departure_)
      depart(world.step(), {});
    if (!span_.mark().digest.fields.empty())
      departure_->where = compare(world.schema(), span_.mark().digest, digest(world));
    if (departure_->where)
      departure_->reason += "; " + departure_->where->text();
    over_ = departure_->where || span_.mark().digest.fields.empty();
  }
  more_ = span_.next();
}

void TrailChecker::depart(std::uint64_t step, std::string reason) {
  if (reason.empty())
    reason = !last_good_ ? "the worlds differ from the start"
             : step - *last_good_ == 1
                 ? fmt::format("the worlds part at step {}", step)
                 : fmt::format("the worlds part between steps {} and {}", *last_good_, step);
  departure_ = Departure{
      .step = step, .last_good = last_good_, .where = std::nullopt, .reason = std::move(reason)};
}

}  // namespace eyrie::sim
