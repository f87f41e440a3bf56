// SPDX-License-Identifier: MIT
#pragma once
/// \file  A reader of Tacview ACMI 2.2 text that shares nothing with the writer. It is stricter
/// than Tacview: whatever the published grammar does not name is an error.
/// Grammar: https://www.tacview.net/documentation/acmi/ (as of 2024-06-20).
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace eyrie::test {

/// "f" as a double, the whole text or an error.
[[nodiscard]] inline double acmi_number(std::string_view text) {
  double value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc{} || end != text.data() + text.size())
    throw std::runtime_error("not a number: " + std::string(text));
  return value;
}

[[nodiscard]] inline std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == at)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

struct AcmiUpdate {
  double time = 0;
  std::map<std::string, std::string> properties;
};

/// What T says, with what it left out as it was before: longitude, latitude (deg), altitude (m),
/// and of six fields roll, pitch and yaw (deg).
struct AcmiSample {
  double time = 0;
  std::array<double, 9> fields{};
};

struct AcmiObject {
  std::vector<AcmiUpdate> updates;
  std::vector<AcmiSample> samples;  ///< of updates with a T
  std::optional<double> removed;    ///< s
  std::size_t place_fields = 0;     ///< of its T, the same for life

  /// The last value of a property, "" if it never had one.
  [[nodiscard]] std::string last(const std::string& key) const {
    for (auto u = updates.rbegin(); u != updates.rend(); ++u)
      if (const auto p = u->properties.find(key); p != u->properties.end())
        return p->second;
    return {};
  }
  /// On the straight line between the samples around that time; angles turn the shorter way.
  [[nodiscard]] AcmiSample at(double time) const {
    const auto behind = std::lower_bound(samples.begin(), samples.end(), time,
                                         [](const AcmiSample& s, double t) { return s.time < t; });
    if (behind == samples.end() || samples.empty())
      return samples.at(samples.size() - 1);
    if (behind == samples.begin() || behind->time == time)
      return *behind;
    const AcmiSample &a = *(behind - 1), &b = *behind;
    AcmiSample between{time, {}};
    const double part = (time - a.time) / (b.time - a.time);
    for (std::size_t i = 0; i < a.fields.size(); ++i) {
      const double way = b.fields[i] - a.fields[i];
      between.fields[i] = a.fields[i] + part * (i < 3 ? way : std::remainder(way, 360));
    }
    return between;
  }
};

struct AcmiEvent {
  double time = 0;
  std::string type;
  std::vector<std::string> parts;  ///< behind the type
};

/// A whole file; throws std::runtime_error with the line that breaks the grammar.
class Acmi {
 public:
  explicit Acmi(std::string_view text) {
    constexpr std::string_view kHead =
        "\xEF\xBB\xBF"
        "FileType=text/acmi/tacview\nFileVersion=2.2\n";
    if (!text.starts_with(kHead))
      throw std::runtime_error("not the head of an ACMI 2.2 file");
    if (!text.ends_with('\n'))
      throw std::runtime_error("the last line has no end");
    if (text.find('\r') != std::string_view::npos)
      throw std::runtime_error("a carriage return");
    text.remove_prefix(kHead.size());
    while (!text.empty()) {
      const std::string line = take_line(text);
      try {
        read(line);
      } catch (const std::runtime_error& e) {
        throw std::runtime_error(std::string(e.what()) + " in: " + line);
      }
    }
  }

  std::map<std::string, std::string> globals;
  std::map<std::uint64_t, AcmiObject> objects;
  std::vector<AcmiEvent> events;
  std::vector<double> frames;

  [[nodiscard]] const AcmiObject* by_name(const std::string& call_sign) const {
    for (const auto& [id, object] : objects)
      if (object.last("CallSign") == call_sign)
        return &object;
    return nullptr;
  }

 private:
  /// Up to a line end that no backslash escapes.
  static std::string take_line(std::string_view& text) {
    std::size_t end = 0;
    while (text[end] != '\n' || (end > 0 && text[end - 1] == '\\'))
      ++end;
    std::string line(text.substr(0, end));
    text.remove_prefix(end + 1);
    return line;
  }

  static std::uint64_t id_of(std::string_view text) {
    std::uint64_t id = 0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), id, 16);
    if (failed != std::errc{} || end != text.data() + text.size() ||
        (text.size() > 1 && text.front() == '0'))
      throw std::runtime_error("not an id: " + std::string(text));
    for (const char c : text)
      if (c >= 'A' && c <= 'F')
        throw std::runtime_error("an id in capitals");
    return id;
  }

  /// key=value pairs between commas; a comma or line end inside a value has a backslash before it,
  /// and nothing else has: the grammar says no word about what else a backslash could mean.
  static std::map<std::string, std::string> properties_of(std::string_view text) {
    std::map<std::string, std::string> found;
    std::string pair;
    const auto put = [&] {
      const auto equals = pair.find('=');
      if (equals == std::string::npos || equals == 0)
        throw std::runtime_error("not key=value: '" + pair + "'");
      if (!found.emplace(pair.substr(0, equals), pair.substr(equals + 1)).second)
        throw std::runtime_error("given twice: " + pair);
      pair.clear();
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == ',' || text[i + 1] == '\n'))
        pair += text[++i];
      else if (text[i] == '\\' || static_cast<unsigned char>(text[i]) < 0x20)
        throw std::runtime_error("a backslash or a control character that means nothing");
      else if (text[i] == ',')
        put();
      else
        pair += text[i];
    }
    put();
    return found;
  }

  void read(const std::string& line) {
    if (line.starts_with("//"))
      return;
    if (line.starts_with('#')) {
      const double time = acmi_number(std::string_view(line).substr(1));
      if (!frames.empty() && time <= frames.back())
        throw std::runtime_error("time does not go forward");
      frames.push_back(time);
      return;
    }
    if (line.starts_with('-')) {
      AcmiObject& gone = live(id_of(std::string_view(line).substr(1)));
      gone.removed = frames.back();
      return;
    }
    const auto comma = line.find(',');
    if (comma == std::string::npos)
      throw std::runtime_error("neither a frame, a removal nor an object");
    const std::uint64_t id = id_of(std::string_view(line).substr(0, comma));
    const auto properties = properties_of(std::string_view(line).substr(comma + 1));
    if (id == 0)
      return global(properties);
    if (frames.empty())
      throw std::runtime_error("an object before the first frame");
    AcmiObject& object = objects[id];
    if (object.removed)
      throw std::runtime_error("an object that was removed");
    if (const auto place = properties.find("T"); place != properties.end())
      read_place(object, place->second);
    object.updates.push_back({frames.back(), properties});
  }

  void global(const std::map<std::string, std::string>& properties) {
    for (const auto& [key, value] : properties) {
      if (key != "Event") {
        globals[key] = value;
        continue;
      }
      static const std::set<std::string> kTypes{"Message",   "Bookmark", "Debug",  "LeftArea",
                                                "Destroyed", "TakenOff", "Landed", "Timeout"};
      auto parts = split(value, '|');
      AcmiEvent event{frames.empty() ? 0 : frames.back(), parts.front(), {}};
      if (!kTypes.contains(event.type))
        throw std::runtime_error("no such event: " + event.type);
      event.parts.assign(parts.begin() + 1, parts.end());
      if (event.type == "Message" || event.type == "Bookmark")  // ids, then the text
        for (std::size_t i = 0; i + 1 < event.parts.size(); ++i)
          static_cast<void>(id_of(event.parts[i]));
      events.push_back(std::move(event));
    }
  }

  AcmiObject& live(std::uint64_t id) {
    const auto found = objects.find(id);
    if (found == objects.end() || found->second.removed)
      throw std::runtime_error("removes what is not there");
    return found->second;
  }

  void read_place(AcmiObject& object, const std::string& value) const {
    const auto fields = split(value, '|');
    const std::size_t n = fields.size();
    if (n != 3 && n != 5 && n != 6 && n != 9)
      throw std::runtime_error("no form of T has so many fields");
    if (object.place_fields && object.place_fields != n)
      throw std::runtime_error("the form of T changes");
    object.place_fields = n;
    AcmiSample sample = object.samples.empty() ? AcmiSample{} : object.samples.back();
    sample.time = frames.back();
    for (std::size_t i = 0; i < n; ++i)
      if (!fields[i].empty())
        sample.fields[i] = acmi_number(fields[i]);
      else if (object.samples.empty())
        throw std::runtime_error("a first T that leaves something out");
    object.samples.push_back(sample);
  }
};

}  // namespace eyrie::test
