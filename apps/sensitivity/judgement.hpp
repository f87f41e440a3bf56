// SPDX-License-Identifier: MIT
#pragma once
/// \file  The values of data/ that nobody has published, and what a fifth more or less of them is.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <tuple>
#include <vector>

namespace eyrie::sensitivity {

/// A line of a file of data/ with a number that nobody has published.
struct Judgement {
  std::string file;                ///< data/guns/m61.yaml
  std::string name;                ///< m61: aim_error
  std::string now;                 ///< 2 mrad
  std::string text;                ///< of the whole file
  std::size_t begin = 0, end = 0;  ///< of the value in it
  int line = 1;                    ///< of the file
};

/// A number; not the 2 of m/s2.
inline const std::regex kNumber(R"((^|[^\w.])([-+]?\d+\.?\d*(?:[eE][-+]?\d+)?))");

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// All of them, by file and place.
inline std::vector<Judgement> judgements(const std::string& home) {
  std::vector<Judgement> all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(home + "/data")) {
    if (entry.path().extension() != ".yaml")
      continue;
    const std::string text = text_of(entry.path());
    std::vector<std::pair<std::size_t, std::string>> above;  // indentation, key
    int number = 1;
    for (std::size_t at = 0; at < text.size(); ++number) {
      const std::size_t stop = std::min(text.find('\n', at), text.size());
      const std::string line = text.substr(at, stop - at);
      const std::size_t indent = line.find_first_not_of(' '), colon = line.find(": ");
      const std::size_t hash = line.find(" #");
      if (indent != std::string::npos && line[indent] != '#' && line.find(':') < hash) {
        while (!above.empty() && above.back().first >= indent)
          above.pop_back();
        above.emplace_back(indent, line.substr(indent, line.find(':') - indent));
        if (colon < hash && hash != std::string::npos &&
            line.find("[judgement]", hash) != std::string::npos &&
            std::regex_search(line.substr(colon, hash - colon), kNumber)) {
          std::string name = entry.path().stem().string() + ":";
          for (const auto& [_, key] : above)
            name += (name.back() == ':' ? " " : ".") + key;
          std::size_t last = line.find_last_not_of(' ', hash) + 1;
          all.push_back({std::filesystem::relative(entry.path(), home).string(), name,
                         line.substr(colon + 2, last - colon - 2), text, at + colon + 2, at + last,
                         number});
        }
      }
      at = stop + 1;
    }
  }
  std::ranges::sort(all, [](const auto& a, const auto& b) {
    return std::tie(a.file, a.line) < std::tie(b.file, b.line);
  });
  return all;
}

/// Every number of it times a factor. Whole numbers without a unit stay whole and change by one at
/// least; 0, a share of which there is none, becomes 0 and a fifth; rates become such that fit the
/// step (50 Hz).
inline std::string scaled(const std::string& value, double factor) {
  const bool rate = value.ends_with(" Hz");
  if (value == "0")
    return factor < 1 ? "0" : fmt::format("{:.10g}", factor - 1);
  const bool counts = value.find_first_not_of("0123456789") == std::string::npos;
  const auto rounded = [&](double number) {  // away from what it is
    const double whole = std::round(number * factor);
    return whole != number ? whole : number + (factor < 1 ? -1 : 1);
  };
  std::string result;
  auto from = value.begin();
  for (std::sregex_iterator i(value.begin(), value.end(), kNumber), end; i != end; ++i) {
    result.append(from, value.begin() + i->position(2));
    const double number = std::stod((*i)[2].str());
    double wanted = number * factor;
    if (counts)
      wanted = rounded(number);
    else if (rate)
      wanted = std::round(50 / wanted) != std::round(50 / number)
                   ? 50 / std::round(50 / wanted)
                   : 50 / (std::round(50 / number) + (factor < 1 ? 1 : -1));
    result += fmt::format("{:.10g}", wanted);
    from = value.begin() + i->position(2) + i->length(2);
  }
  return result.append(from, value.end());
}

}  // namespace eyrie::sensitivity
