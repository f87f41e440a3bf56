// SPDX-License-Identifier: MIT
#include "scenario/source.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

namespace eyrie::scenario {
namespace fs = std::filesystem;

Source Source::disk(std::string home) {
  Source s;
  s.home_ = std::move(home);
  s.from_disk_ = true;
  return s;
}

Source Source::bundle(std::map<std::string, std::string> files) {
  Source s;
  s.files_ = std::move(files);
  return s;
}

std::optional<std::string> Source::read(const std::string& name) {
  if (const auto known = files_.find(name); known != files_.end())
    return known->second;
  if (!from_disk_)
    return std::nullopt;
  // data/ stands below home whatever the working folder is; everything else is as the user wrote it
  std::error_code failed;
  fs::path path = name;
  if (const fs::path data = fs::path(home_) / name;
      name.starts_with("data/") && fs::is_regular_file(data, failed))
    path = data;
  if (name.find('\0') != name.npos || !fs::is_regular_file(path, failed))
    return std::nullopt;
  // one more than anybody accepts, so that what is too large is refused and not cut
  const std::uintmax_t size = fs::file_size(path, failed);
  std::ifstream in(path, std::ios::binary);
  if (failed || !in)
    return std::nullopt;
  std::string text(static_cast<std::size_t>(std::min<std::uintmax_t>(size, kLargest + 1)), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad())
    return std::nullopt;
  text.resize(static_cast<std::size_t>(in.gcount()));
  files_[name] = text;
  return text;
}

std::string Source::data_name(std::string_view kind, std::string_view name) const {
  return "data/" + std::string(kind) + "/" + std::string(name) + ".yaml";
}

std::vector<std::string> Source::data_names(std::string_view kind) const {
  std::vector<std::string> names;
  const std::string folder = "data/" + std::string(kind) + "/";
  if (from_disk_) {
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(fs::path(home_) / folder, failed))
      if (entry.path().extension() == ".yaml")
        names.push_back(entry.path().stem().string());
  } else {
    for (const auto& [name, text] : files_)
      if (name.starts_with(folder) && name.ends_with(".yaml") &&
          name.find('/', folder.size()) == name.npos)
        names.push_back(name.substr(folder.size(), name.size() - folder.size() - 5));
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string relative_to(std::string_view file, std::string_view name) {
  if (name.starts_with('/'))
    return std::string(name);
  return (fs::path(file).parent_path() / fs::path(name)).lexically_normal().generic_string();
}

}  // namespace eyrie::scenario
