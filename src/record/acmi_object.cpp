// SPDX-License-Identifier: MIT
#include "record/acmi.hpp"

#include <algorithm>
#include <iterator>

#include "core/text.hpp"

namespace eyrie::record {
namespace {

std::string escaped(std::string_view text, std::string_view line_end, std::string_view bar) {
  std::string out;
  while (!text.empty()) {
    const Utf8 next = first_character(text);
    const std::size_t length = text.starts_with("\r\n") ? 2 : std::max<std::size_t>(next.length, 1);
    const char32_t c = length == 2 && next.length == 1 ? U'\n' : next.point;
    if (next.length == 0)
      out += "\xEF\xBF\xBD";
    else if (c == U'\n' || c == U'\r' || c == 0x85 || c == 0x2028 || c == 0x2029)
      out += line_end;
    else if (c == U'\t')
      out += ' ';
    else if (is_control(c))
      out += "\xEF\xBF\xBD";
    else if (c == U',')
      out += "\\,";
    else if (c == U'\\')
      out += "\xEF\xBC\xBC";
    else if (c == U'|')
      out += bar;
    else
      out += text.substr(0, length);
    text.remove_prefix(length);
  }
  return out;
}

constexpr double kSpeedStep = 0.5, kMachStep = 0.005, kLoadStep = 0.05,
                 kFuelStep = 5;  // m/s, -, g, kg
constexpr float kVoteStep = 0.05F;
/// What an instrument may be away from what it is, between two samples.
constexpr double kLargeSteps = 10;

std::string rounded(double value, int decimals) {
  return without_minus_zero(fmt::format("{:.{}f}", value, decimals));
}

/// What stands in the file follows what is, by no smaller steps.
void follow(double& written, double value, double step) {
  if (std::fabs(value - written) >= step)
    written = value;
}

/// Of the line from `a` to `b` at the time of `p`, in tolerances.
double error(const Pose& a, const Pose& p, const Pose& b, const Tolerance& tolerance) {
  const double part = (p.time - a.time) / (b.time - a.time);
  const double off = norm(a.position + part * (b.position - a.position) - p.position);
  const auto turned = [&](double Pose::*angle) {
    return std::fabs(wrap_pi(a.*angle + part * wrap_pi(b.*angle - a.*angle) - p.*angle));
  };
  return std::max(off / tolerance.position,
                  std::max({turned(&Pose::roll), turned(&Pose::pitch), turned(&Pose::heading)}) /
                      tolerance.attitude);
}

/// Whether the short way round from one to the other is in doubt once both are rounded.
bool turns_round(const Pose& a, const Pose& b) {
  const auto half = [&](double Pose::*angle) {
    return std::fabs(wrap_pi(b.*angle - a.*angle)) > radians(175);
  };
  return half(&Pose::roll) || half(&Pose::pitch) || half(&Pose::heading);
}

/// Whether all between two poses lie near the line.
bool fits(std::span<const Pose> poses, std::size_t from, std::size_t to,
          const Tolerance& tolerance) {
  if (to > from + 1 && turns_round(poses[from], poses[to]))
    return false;
  for (std::size_t i = from + 1; i < to; ++i)
    if (error(poses[from], poses[i], poses[to], tolerance) > 1)
      return false;
  return true;
}

}  // namespace

std::string acmi_text(std::string_view text) {
  return escaped(text, "\\\n", "|");
}

std::string acmi_name(std::string_view text) {
  return escaped(text, " ", "|");
}

std::string acmi_event_text(std::string_view text) {
  return escaped(text, " ", "\xEF\xBD\x9C");
}

void AcmiObject::see(AcmiSample sample) {
  if (samples_.empty()) {
    sample.wanted = true;
  } else {
    const AcmiSample& before = samples_.back();
    sample.wanted |= sample.lock != before.lock || sample.winner != before.winner;
  }
  if (std::fabs(sample.vote - noted_vote_) > kVoteStep * std::fabs(noted_vote_)) {
    sample.wanted = true;
    noted_vote_ = sample.vote;
  }
  samples_.push_back(std::move(sample));
}

void AcmiObject::leave(std::uint64_t step) {
  gone_ = true;
  if (samples_.empty() || last_.time <= samples_.back().pose.time)
    return;
  AcmiSample last = samples_.back();
  last.step = step;
  last.pose = last_;
  samples_.push_back(std::move(last));
}

void AcmiObject::write(const Reference& reference, std::vector<AcmiLine>& lines) {
  if (samples_.size() <= (begun_ ? 1u : 0u))
    return;
  std::vector<Pose> poses;
  std::vector<bool> kept;
  for (const AcmiSample& sample : samples_) {
    poses.push_back(sample.pose);
    kept.push_back(sample.wanted);
  }
  kept.front() = kept.back() = true;
  thin(poses, kept, kTolerance, [&](std::size_t i, bool is_kept) {
    if (!is_kept && !moved_far(samples_[i]))
      return false;
    if (i > 0 || !begun_) {
      lines.push_back({samples_[i].step, AcmiLine::Kind::object, {}});
      line(samples_[i], reference, lines.back().text);
    }
    return true;
  });
  begun_ = true;
  samples_.erase(samples_.begin(), samples_.end() - 1);
}

/// Whether an instrument is far from what stands in the file.
bool AcmiObject::moved_far(const AcmiSample& s) const {
  const auto is_far = [](double written, double value, double step) {
    return std::fabs(value - written) > kLargeSteps * step;
  };
  return (s.speed >= 0 && is_far(told_.speed, s.speed, kSpeedStep)) ||
         (s.mach > 0 && (is_far(told_.mach, s.mach, kMachStep) ||
                         is_far(told_.load_factor, s.load_factor, kLoadStep))) ||
         (s.fuel >= 0 && is_far(told_.fuel, s.fuel, kFuelStep));
}

void AcmiObject::line(const AcmiSample& s, const Reference& reference, std::string& text) {
  const Geodetic at = reference.to_geodetic(s.pose.position);
  const Geodetic& origin = reference.origin();
  const Told before = told_;
  told_.place = {rounded(degrees(wrap_pi(at.longitude - origin.longitude)), 7),
                 rounded(degrees(at.latitude - origin.latitude), 7),
                 rounded(at.altitude, 2),
                 rounded(degrees(s.pose.roll), 1),
                 rounded(degrees(s.pose.pitch), 1),
                 rounded(heading_degrees(s.pose.heading, 10), 1)};
  if (s.speed >= 0)
    follow(told_.speed, s.speed, kSpeedStep);
  if (s.mach > 0) {
    follow(told_.mach, s.mach, kMachStep);
    follow(told_.load_factor, s.load_factor, kLoadStep);
  }
  if (s.fuel >= 0)
    follow(told_.fuel, s.fuel, kFuelStep);
  if (s.lock || told_.lock)
    told_.lock = s.lock;
  if (!s.winner.empty()) {
    told_.winner = s.winner;
    told_.vote = s.vote;
  }
  write_line(before, text);
}

void AcmiObject::write_whole(std::string& text) const {
  if (begun_)
    write_line({}, text);
}

void AcmiObject::write_line(const Told& before, std::string& text) const {
  const auto to = std::back_inserter(text);
  fmt::format_to(to, "{:x},T=", id_.value);
  for (std::size_t i = 0; i < told_.place.size(); ++i)
    fmt::format_to(to, "{}{}", i > 0 ? "|" : "",
                   told_.place[i] != before.place[i] ? told_.place[i] : "");
  if (before.place[0].empty())
    text += introduction_;
  if (told_.speed != before.speed)
    fmt::format_to(to, ",TAS={:.1f}", told_.speed);
  if (told_.mach != before.mach)
    fmt::format_to(to, ",Mach={:.3f}", told_.mach);
  if (told_.load_factor != before.load_factor)
    fmt::format_to(to, ",VerticalGForce={:.1f}", told_.load_factor);
  if (told_.fuel != before.fuel)
    fmt::format_to(to, ",FuelWeight={:.0f}", told_.fuel);
  if (told_.lock != before.lock)
    fmt::format_to(to, ",LockedTargetMode={},LockedTarget={:x}", *told_.lock ? 1 : 0, *told_.lock);
  if (told_.winner != before.winner || told_.vote != before.vote)
    fmt::format_to(to, ",UbfWinner={0},UbfVote={1:g},Label={0} {1:g}", told_.winner, told_.vote);
  text += '\n';
}

void thin(std::span<const Pose> poses, std::vector<bool>& kept, const Tolerance& tolerance,
          const std::function<bool(std::size_t, bool)>& keeps) {
  std::size_t from = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    kept[i] = keeps(i, kept[i] || (i + 1 < poses.size() && !fits(poses, from, i + 1, tolerance)));
    if (kept[i])
      from = i;
  }
}

}  // namespace eyrie::record
