// SPDX-License-Identifier: MIT
#include "record/acmi.hpp"

#include <fmt/format.h>

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

namespace {

constexpr double kSpeedStep = 0.5, kMachStep = 0.005, kLoadStep = 0.05,
                 kFuelStep = 5;  // m/s, -, g, kg
constexpr float kVoteStep = 0.05F;

/// Without the sign of a zero.
std::string rounded(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  return text.find_first_not_of("-0.") == text.npos ? text.substr(text[0] == '-') : text;
}

/// Whether it is far enough from what stands in the file, which then is it.
bool moved(double& written, double value, double by) {
  if (std::fabs(value - written) < by)
    return false;
  written = value;
  return true;
}

}  // namespace

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
  thin(poses, kept, kTolerance);
  for (std::size_t i = begun_ ? 1 : 0; i < samples_.size(); ++i)
    if (kept[i]) {
      lines.push_back({samples_[i].step, AcmiLine::Kind::object, {}});
      line(samples_[i], reference, lines.back().text);
    }
  begun_ = true;
  samples_.erase(samples_.begin(), samples_.end() - 1);
}

void AcmiObject::line(const AcmiSample& s, const Reference& reference, std::string& text) {
  const auto to = std::back_inserter(text);
  const Geodetic at = reference.to_geodetic(s.pose.position);
  const Geodetic& origin = reference.origin();
  const std::string place[] = {rounded(degrees(wrap_pi(at.longitude - origin.longitude)), 7),
                               rounded(degrees(at.latitude - origin.latitude), 7),
                               rounded(at.altitude, 2),
                               rounded(degrees(s.pose.roll), 1),
                               rounded(degrees(s.pose.pitch), 1),
                               rounded(degrees(wrap_tau(s.pose.heading)), 1)};
  fmt::format_to(to, "{:x},T=", id_.value);
  for (std::size_t i = 0; i < place_.size(); ++i) {
    if (i > 0)
      text += '|';
    if (place[i] != place_[i])
      text += place_[i] = place[i];
  }
  text += std::exchange(introduction_, {});
  if (s.speed >= 0 && moved(speed_, s.speed, kSpeedStep))
    fmt::format_to(to, ",TAS={:.1f}", s.speed);
  if (s.mach > 0 && moved(mach_, s.mach, kMachStep))
    fmt::format_to(to, ",Mach={:.3f}", s.mach);
  if (s.mach > 0 && moved(load_factor_, s.load_factor, kLoadStep))
    fmt::format_to(to, ",VerticalGForce={:.1f}", s.load_factor);
  if (s.fuel >= 0 && moved(fuel_, s.fuel, kFuelStep))
    fmt::format_to(to, ",FuelWeight={:.0f}", s.fuel);
  if (s.lock != std::exchange(lock_, s.lock))
    fmt::format_to(to, ",LockedTargetMode={},LockedTarget={:x}", s.lock ? 1 : 0, s.lock);
  if (!s.winner.empty() && (s.winner != winner_ || s.vote != vote_)) {
    fmt::format_to(to, ",UbfWinner={0},UbfVote={1:g},Label={0} {1:g}", s.winner, s.vote);
    winner_ = s.winner;
    vote_ = s.vote;
  }
  text += '\n';
}

namespace {

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

void thin(std::span<const Pose> poses, std::vector<bool>& kept, const Tolerance& tolerance) {
  std::size_t from = 0;
  for (std::size_t to = 1; to < poses.size(); ++to) {
    if (!fits(poses, from, to, tolerance))
      kept[to - 1] = true;
    if (kept[to - 1])
      from = to - 1;
  }
}

}  // namespace eyrie::record
