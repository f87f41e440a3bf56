// SPDX-License-Identifier: MIT
#include <dirent.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>
#include <system_error>

#include "core/text.hpp"
#include "disk/sink.hpp"
#include "model/weapon/kept_zones.hpp"
#include "scenario/source.hpp"

namespace eyrie::scenario {
namespace fs = std::filesystem;
namespace {

/// Of the files there, in no order; std::filesystem's iterator ends the program where memory runs
/// out.
std::vector<std::string> names_with(std::string_view end, const fs::path& folder) {
  std::vector<std::string> names;
  const std::unique_ptr<DIR, int (*)(DIR*)> open(::opendir(folder.c_str()), ::closedir);
  while (const dirent* const entry = open ? ::readdir(open.get()) : nullptr)
    if (const std::string_view name = entry->d_name; name.ends_with(end))
      names.emplace_back(name);
  return names;
}

class Disk final : public Source::Folders {
 public:
  Disk(std::string home, std::vector<std::string> allowed)
      : home_(std::move(home)), allowed_(std::move(allowed)) {}

  void confine_to_folder_of(const std::string& file) override {
    const fs::path folder = fs::path(file).parent_path();
    std::vector<fs::path> folders{folder.empty() ? "." : folder, home_};
    folders.insert(folders.end(), allowed_.begin(), allowed_.end());
    roots_.clear();
    for (const fs::path& one : folders) {
      std::error_code failed;
      const fs::path root = fs::weakly_canonical(fs::absolute(one, failed), failed);
      if (!failed)
        roots_.push_back(root);
    }
    confined_ = true;
  }

  bool is_outside(const std::string& name) const override {
    if (!confined_)
      return false;
    std::error_code failed;
    const fs::path path = fs::weakly_canonical(fs::absolute(place_of(name), failed), failed);
    return failed || std::ranges::none_of(roots_, [&](const fs::path& root) {
             return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first ==
                    root.end();
           });
  }

  std::optional<std::string> read(const std::string& name) const override {
    std::error_code failed;
    const fs::path path = place_of(name);
    if (name.find('\0') != name.npos || !fs::is_regular_file(path, failed) || is_outside(name))
      return std::nullopt;
    // one more than anybody accepts, so that what is too large is refused and not cut
    const std::uintmax_t size = fs::file_size(path, failed);
    std::ifstream in(path, std::ios::binary);
    if (failed || !in)
      return std::nullopt;
    std::string text(static_cast<std::size_t>(std::min<std::uintmax_t>(size, Source::kLargest + 1)),
                     '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (in.bad())
      return std::nullopt;
    text.resize(static_cast<std::size_t>(in.gcount()));
    return text;
  }

  std::string why_unread(const std::string& name, const std::string& asker) const override {
    const disk::FileRead read = disk::read_file(place_of(name), Source::kLargest);
    constexpr std::string_view kAgain = "cannot be read";
    if (!read.missing && read.problem.starts_with(kAgain))
      return read.problem.substr(kAgain.size());
    if (!read.missing)
      return read.problem.empty() ? "" : ": it " + read.problem;
    if (const std::string own = same_of_ours(name, asker); !own.empty())
      return "; did you mean " + quote_path(own) + "?";
    // as the asker has to write it
    if (name.starts_with(Source::kOwn))
      return disk::nearest_file(place_of(name), asker, home_, Source::kOwn);
    const fs::path from = asker.empty() ? fs::path() : place_of(asker).parent_path();
    return disk::nearest_file(place_of(name), asker, from.empty() && !asker.empty() ? "." : from);
  }

  std::vector<std::string> names_in(const std::string& folder) const override {
    constexpr std::string_view kEnd = ".yaml";
    std::vector<std::string> names = names_with(kEnd, fs::path(home_) / folder);
    for (std::string& name : names)
      name.resize(name.size() - kEnd.size());
    return names;
  }

 private:
  /// data/ and Eyrie's own scenarios stand below home whatever the working folder is; everything
  /// else is as the user wrote it.
  [[nodiscard]] fs::path place_of(const std::string& name) const {
    if (name.starts_with(Source::kOwn))
      return fs::path(home_) / name.substr(Source::kOwn.size());
    return name.starts_with("data/") ? fs::path(home_) / name : fs::path(name);
  }

  /// What the name would mean in one of Eyrie's own scenarios, of which the file `asker` may be a
  /// copy, or "".
  [[nodiscard]] std::string same_of_ours(const std::string& name, const std::string& asker) const {
    const fs::path below = fs::path(name).lexically_relative(fs::path(asker).parent_path());
    const std::string own = Source::kOwn + "scenarios/" + below.generic_string();
    std::error_code failed;
    return !below.empty() && *below.begin() != ".." && fs::is_regular_file(place_of(own), failed)
               ? own
               : "";
  }

  std::string home_;
  std::vector<std::string> allowed_;
  bool confined_ = false;
  std::vector<fs::path> roots_;  ///< if it is confined
};

}  // namespace

Source Source::disk(std::string home, std::vector<std::string> allowed) {
  model::weapon::kept_zones().take(launch_zones(home));
  Source s;
  s.folders_ = std::make_shared<Disk>(std::move(home), std::move(allowed));
  return s;
}

std::string launch_zones(const std::string& home) {
  std::string all;
  const fs::path folder = fs::path(home) / "data" / "zones";
  std::vector<std::string> names = names_with(".zone", folder);
  std::ranges::sort(names);
  for (const std::string& name : names) {
    constexpr std::size_t kLargest = 1 << 20;  // they have some 100 kB
    if (const disk::FileRead read = disk::read_file(folder / name, kLargest); read.problem.empty())
      all += read.bytes;
  }
  return all;
}

}  // namespace eyrie::scenario
