// SPDX-License-Identifier: MIT
#include "record/acmi.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "core/text.hpp"

namespace eyrie::record {
namespace {

TEST(AcmiText, EscapesAsTheFormatAsks) {
  EXPECT_EQ(acmi_text("four F-15s, on sensors"), "four F-15s\\, on sensors");
  EXPECT_EQ(acmi_text("one\ntwo\r\nthree"), "one\\\ntwo\\\nthree");
  EXPECT_EQ(acmi_text("a|b = c"), "a|b = c") << "nothing else is an escape";
}

TEST(AcmiText, HasNoBackslashThatAReaderCouldTakeForAnEscape) {
  EXPECT_EQ(acmi_text("C:\\data\\"),
            "C:\xEF\xBC\xBC"
            "data\xEF\xBC\xBC");
  EXPECT_EQ(acmi_text("\\,"), "\xEF\xBC\xBC\\,");
}

TEST(AcmiText, IsOneLineWhereItIsAName) {
  EXPECT_EQ(acmi_name("a\nb\rc\r\nd\xC2\x85"
                      "e\xE2\x80\xA8"
                      "f"),
            "a b c d e f");
  EXPECT_EQ(acmi_event_text("x\n-1"), "x -1");
}

TEST(AcmiText, IsOnePartOfAnEvent) {
  EXPECT_EQ(acmi_event_text("a|2|b"),
            "a\xEF\xBD\x9C"
            "2\xEF\xBD\x9C"
            "b");
}

TEST(AcmiText, HoldsNeitherControlCharactersNorBytesThatAreNoText) {
  EXPECT_EQ(acmi_text("a\tb\x1b[2J\xff"), "a b\xEF\xBF\xBD[2J\xEF\xBF\xBD");
}

/// Whatever a reader makes of backslashes: it looks at the character before, or takes two as one.
RC_GTEST_PROP(AcmiText, EndsNeitherItsValueNorItsLine, (const std::string& text)) {
  for (const std::string& value : {acmi_name(text), acmi_event_text(text)}) {
    RC_ASSERT(printable(value) == value);
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (value[i] == ',')
        RC_ASSERT(i > 0 && value[i - 1] == '\\' && (i < 2 || value[i - 2] != '\\'));
      if (value[i] == '\\')
        RC_ASSERT(i + 1 < value.size() && value[i + 1] == ',');
    }
  }
  RC_ASSERT(acmi_event_text(text).find('|') == std::string::npos);
}

}  // namespace

namespace {

constexpr Tolerance kTolerance{.position = 2, .attitude = radians(1)};

std::ptrdiff_t count(const std::vector<bool>& kept) {
  return std::count(kept.begin(), kept.end(), true);
}

std::vector<bool> kept_of(const std::vector<Pose>& poses, std::vector<std::size_t> wanted = {}) {
  std::vector<bool> kept(poses.size());
  kept.front() = kept.back() = true;
  for (const std::size_t i : wanted)
    kept[i] = true;
  thin(poses, kept, kTolerance);
  return kept;
}

TEST(Thinning, FitsTheShorterLinesOfWhatIsKeptForOtherReasons) {
  // rolls to and fro by what one line from end to end allows, and two lines do not
  std::vector<Pose> poses;
  for (int i = 0; i <= 40; ++i)
    poses.push_back({.time = 0.1 * i, .roll = radians(0.95) * std::sin(kTau * i / 40)});
  std::vector<bool> kept(poses.size());
  kept.front() = kept.back() = true;
  thin(poses, kept, kTolerance, [](std::size_t i, bool is) { return is || i == 30; });
  std::size_t from = 0;
  for (std::size_t to = 1; to < poses.size(); ++to) {
    if (!kept[to])
      continue;
    for (std::size_t i = from; i < to; ++i) {
      const double part = (poses[i].time - poses[from].time) / (poses[to].time - poses[from].time);
      EXPECT_LT(
          std::fabs(poses[from].roll + part * (poses[to].roll - poses[from].roll) - poses[i].roll),
          kTolerance.attitude * (1 + 1e-9))
          << i;
    }
    from = to;
  }
}

/// Straight on, with a pull that is over before the path shows it.
TEST(AcmiObject, WritesASampleWhereAnInstrumentHasMovedFar) {
  AcmiObject object(PlayerId{1}, "");
  for (int i = 0; i < 20; ++i)
    object.see({.step = static_cast<std::uint64_t>(10 * i),
                .pose = {.time = 0.2 * i, .position = {50.0 * i, 0, 0}},
                .speed = 250,
                .mach = 0.8,
                .load_factor = i == 7   ? 4
                               : i > 10 ? 1.3
                                        : 1,
                .fuel = 4000});
  std::vector<AcmiLine> lines;
  object.write(Reference(Geodetic{}), lines);
  std::vector<std::uint64_t> steps;
  for (const AcmiLine& line : lines)
    steps.push_back(line.step);
  EXPECT_EQ(steps, (std::vector<std::uint64_t>{0, 70, 80, 190}));
  EXPECT_NE(lines[1].text.find("VerticalGForce=4.0"), std::string::npos) << lines[1].text;
}

/// Of what stands in the file, not of the last time that it had moved far.
TEST(AcmiObject, WritesASampleWhereAnInstrumentIsFarFromWhatWasTold) {
  AcmiObject object(PlayerId{1}, "");
  const auto load = [](int i) { return i < 3 ? 1.0 : i < 8 ? 1.6 : i == 8 ? 1.2 : 1.68; };
  for (int i = 0; i < 20; ++i)
    object.see({.step = static_cast<std::uint64_t>(10 * i),
                .pose = {.time = 0.2 * i, .position = {50.0 * i, i == 8 ? 40.0 : 0, 0}},
                .speed = 250,
                .mach = 0.8,
                .load_factor = load(i),
                .fuel = 4000});
  std::vector<AcmiLine> lines;
  object.write(Reference(Geodetic{}), lines);
  double told = 0;
  std::size_t next = 0;
  for (int i = 0; i < 20; ++i) {
    if (next < lines.size() && lines[next].step == static_cast<std::uint64_t>(10 * i)) {
      const std::size_t at = lines[next].text.find("VerticalGForce=");
      told = at == std::string::npos ? told : std::stod(lines[next].text.substr(at + 15));
      ++next;
    }
    EXPECT_NEAR(load(i), told, 0.5) << i;
    EXPECT_TRUE(i != 8 || told < 1.3) << "a corner of the way tells it by the way";
  }
}

TEST(Thin, LeavesOutWhatLiesOnALine) {
  std::vector<Pose> poses;
  for (int i = 0; i < 20; ++i)
    poses.push_back({.time = 0.2 * i, .position = {50.0 * i, 1.9 * (i % 2), 0}});
  EXPECT_EQ(count(kept_of(poses)), 2);
  const auto kept = kept_of(poses, {7});
  EXPECT_TRUE(kept[7]) << "what is wanted stays";
  EXPECT_EQ(count(kept), 3);
}

TEST(Thin, KeepsACorner) {
  std::vector<Pose> poses;
  for (int i = 0; i <= 20; ++i)
    poses.push_back(
        {.time = 0.2 * i, .position = {50.0 * std::min(i, 8), 50.0 * std::max(i - 8, 0), 0}});
  EXPECT_TRUE(kept_of(poses)[8]);
}

TEST(Thin, TurnsTheShorterWay) {
  std::vector<Pose> poses;
  for (int i = 0; i <= 10; ++i)
    poses.push_back({.time = 0.2 * i, .heading = wrap_pi(radians(175.0 + i))});
  EXPECT_EQ(count(kept_of(poses)), 2);
}

/// Half a roll reads as one to the left or to the right, as its ends happen to be rounded.
TEST(Thin, NeverLeavesAHalfRollInDoubt) {
  std::vector<Pose> poses;
  for (int i = 0; i <= 20; ++i)
    poses.push_back({.time = 0.2 * i, .roll = wrap_pi(radians(9.0 * i))});
  const auto kept = kept_of(poses);
  std::size_t from = 0;
  for (std::size_t i = 1; i < poses.size(); ++i)
    if (kept[i]) {
      EXPECT_LE(std::fabs(wrap_pi(poses[i].roll - poses[from].roll)), radians(175)) << i;
      from = i;
    }
  EXPECT_EQ(count(kept), 3);
}

RC_GTEST_PROP(Thin, LeavesNothingOutThatIsFarFromItsLine, (const std::vector<int>& steps)) {
  RC_PRE(steps.size() > 1);
  std::vector<Pose> poses;
  double y = 0, roll = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    y += steps[i] % 5;
    roll += radians(steps[i] % 3);
    poses.push_back({.time = 0.2 * static_cast<double>(i),
                     .position = {50.0 * static_cast<double>(i), y, 0},
                     .roll = wrap_pi(roll)});
  }
  const auto kept = kept_of(poses);
  std::size_t before = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (!kept[i])
      continue;
    for (std::size_t j = before + 1; j < i; ++j) {
      const double part = static_cast<double>(j - before) / static_cast<double>(i - before);
      const Pose &a = poses[before], &b = poses[i];
      RC_ASSERT(std::fabs(a.position.y + part * (b.position.y - a.position.y) -
                          poses[j].position.y) <= 2 + 1e-9);
      RC_ASSERT(std::fabs(wrap_pi(a.roll + part * wrap_pi(b.roll - a.roll) - poses[j].roll)) <=
                radians(1) + 1e-9);
    }
    before = i;
  }
}

}  // namespace

}  // namespace eyrie::record
