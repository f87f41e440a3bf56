// SPDX-License-Identifier: MIT
/// \file  zones: flies the launch zones of missiles and keeps them, or draws them; and where the
/// zones of everybody's own missiles are kept between runs.
#include <deque>
#include <filesystem>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "command.hpp"
#include "commands.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "locate.hpp"
#include "model/weapon/kept_zones.hpp"
#include "say.hpp"
#include "scenario/data.hpp"

namespace eyrie::app {
namespace fs = std::filesystem;
namespace {

namespace weapon = model::weapon;
using weapon::EmploymentZone;

/// Of a file of zones, which has some 100 kB; nothing of what cannot be one.
std::string contents(const fs::path& path) {
  constexpr std::size_t kLargest = 1 << 20;
  disk::FileRead read = disk::read_file(path, kLargest);
  return read.problem.empty() ? std::move(read.bytes) : std::string();
}

fs::path cache_folder() {
  const fs::path own = user_folder("XDG_CACHE_HOME", ".cache");
  return own.empty() ? own : own / "zones";
}
fs::path cache_file(std::uint64_t key) {
  return cache_folder() / fmt::format("{:016x}.zone", key);
}

bool is_cache_file(const fs::directory_entry& entry) {
  const std::string stem = entry.path().stem().string();
  std::error_code failed;
  return entry.path().extension() == ".zone" && stem.size() == 16 &&
         stem.find_first_not_of("0123456789abcdef") == stem.npos &&
         entry.symlink_status(failed).type() == fs::file_type::regular;
}

/// Whole or not at all, and no word if it cannot be: the zone is flown again then. The oldest go
/// when there are many; what has no name of ours stays.
void keep_in_cache(std::uint64_t key, std::string_view file) {
  constexpr std::size_t kMost = 100;
  const fs::path folder = cache_folder();
  std::error_code failed;
  if (folder.empty() || (fs::create_directories(folder, failed), failed))
    return;
  std::vector<std::pair<fs::file_time_type, fs::path>> old;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (is_cache_file(entry))
      old.emplace_back(entry.last_write_time(failed), entry.path());
  std::ranges::sort(old);
  for (std::size_t i = 0; i + kMost <= old.size(); ++i)
    fs::remove(old[i].second, failed);
  try {
    disk::OutputFile out(cache_file(key).string(), true);
    out.sink().write(file);
    out.commit();
  } catch (const std::exception&) {  // a full disk, or somebody else's thing of that name
  }
}

/// Says on a terminal how far the zone is that is flown now.
void show_progress(const model::MissileType& type, double done) {
  static std::mutex mutex;
  static std::optional<Progress> progress;
  const std::lock_guard lock(mutex);
  if (done >= 1)
    return progress.reset();
  if (!progress)
    progress.emplace("percent of the launch zone of " + type.label, 100);
  progress->at(static_cast<std::uint64_t>(100 * done));
}

/// A missile of data/missiles/ by its name, with its zone.
model::MissileType loaded(const std::string& name, scenario::Source& source) {
  model::Library library;
  Diagnostics wrong;
  scenario::DataLoader loader(library, nullptr, source, wrong);
  const auto index = loader.load<model::MissileType>(name, {});
  if (!index || !wrong.ok())
    throw ConfigError(wrong);
  return library.missiles[*index];
}

/// The zone over the aspect, around the target, which flies up the page; the shooter is as far away
/// as the curve, on the bearing on which it is drawn, and points at the target.
std::string drawing(const model::MissileType& type, double altitude, double speed) {
  constexpr double kSize = 640, kMargin = 40;
  constexpr int kSteps = 72;
  const auto zone = [&](double aspect) {
    return type.zone.at({.shooter_altitude = altitude,
                         .target_altitude = altitude,
                         .shooter_speed = speed,
                         .target_speed = speed,
                         .aspect = aspect});
  };
  double reach = 1e3;
  for (int i = 0; i <= kSteps; ++i)
    reach = std::max(reach, zone(kPi * i / kSteps).r_max);
  const double ring = reach > 40e3 ? 20e3 : reach > 15e3 ? 10e3 : 2e3;
  reach = std::ceil(reach / ring) * ring;
  const double scale = (kSize / 2 - kMargin) / reach, middle = kSize / 2;

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {0}\" "
      "font-family=\"sans-serif\" font-size=\"12\" fill=\"none\">\n<rect width=\"{0}\" "
      "height=\"{0}\" fill=\"white\"/>\n",
      kSize);
  for (double r = ring; r <= reach; r += ring)
    svg += fmt::format(
        "<circle cx=\"{0}\" cy=\"{0}\" r=\"{1:.1f}\" stroke=\"#ddd\"/><text x=\"{2:.1f}\" "
        "y=\"{3:.1f}\" fill=\"#888\">{4:g} km</text>\n",
        middle, r * scale, middle + 3, middle + r * scale - 3, r / 1e3);
  svg += fmt::format("<path d=\"M{0} {1}l-5 14h10z\" fill=\"black\"/>\n", middle, middle - 7);
  struct Curve {
    const char *name, *color;
    double EmploymentZone::*range;
  };
  double line = 20;
  for (const auto& [name, color, range] : {Curve{"r_max", "#1f77b4", &EmploymentZone::r_max},
                                           {"r_tr", "#ff7f0e", &EmploymentZone::r_tr},
                                           {"r_ne", "#d62728", &EmploymentZone::r_ne},
                                           {"r_min", "#555", &EmploymentZone::r_min}}) {
    svg += "<path d=\"";
    for (int i = -kSteps; i < kSteps; ++i) {
      const double aspect = kPi * i / kSteps;
      const double r = zone(std::fabs(aspect)).*range * scale;
      const auto [sine, cosine] = math::sin_cos(aspect);
      svg += fmt::format("{}{:.1f} {:.1f}", i == -kSteps ? "M" : "L", middle + r * sine,
                         middle - r * cosine);
    }
    svg += fmt::format("z\" stroke=\"{}\" stroke-width=\"2\"/>", color);
    svg += fmt::format("<text x=\"12\" y=\"{}\" fill=\"{}\">{}</text>\n", line, color, name);
    line += 16;
  }
  svg += fmt::format(
      "<text x=\"12\" y=\"{}\" fill=\"black\">{}: both at {:.0f} m and {:.0f} m/s, shooter points "
      "at the target, which flies up</text>\n</svg>\n",
      kSize - 12, xml_text(type.label), altitude, speed);
  return svg;
}

/// What the zones were flown for; beyond, they are those of the nearest end.
double in_table(std::string_view option, const std::string& text, Dimension dimension, double least,
                double most) {
  const Parsed read = parse_quantity(text, dimension);
  if (!read || !(read.value >= least && read.value <= most))
    refuse("eyrie: {} {}: {}", option, quote(text),
           read ? fmt::format("must be from {} to {}, for which zones are flown",
                              exact_quantity(least, dimension), exact_quantity(most, dimension))
                : read.error);
  return read.value;
}

}  // namespace

void keep_zones() {
  auto& zones = model::weapon::kept_zones();
  zones.take(launch_zones());
  zones.use({.load = [](std::uint64_t key) { return contents(cache_file(key)); },
             .save = keep_in_cache,
             .progress = show_progress,
             .workers = std::clamp(std::thread::hardware_concurrency(), 1U, 64U)});
}

int zones(const ZonesOptions& options) {
  scenario::Source source = scenario::Source::disk(home());
  const double altitude = in_table("--altitude", options.altitude, Dimension::length,
                                   weapon::kLowestZone, weapon::kHighestZone);
  const double speed = in_table("--speed", options.speed, Dimension::speed, weapon::kSlowestZone,
                                weapon::kFastestZone);
  listen_for_interrupts();
  // whatever is a mistake is found before anything is written
  std::map<std::string, model::MissileType> types;
  for (const std::string& name :
       options.missiles.empty() ? source.data_names("missiles") : options.missiles)
    if (!types.contains(name) && !interrupted())
      types.emplace(name, loaded(name, source));
  if (options.draw) {
    std::deque<disk::OutputFile> files;
    for (const auto& [name, type] : types)
      files.emplace_back(fs::path(options.out) / (name + ".svg"), options.force)
          .sink()
          .write(drawing(type, altitude, speed));
    for (disk::OutputFile& file : files)
      finish(file);
    return 0;
  }
  int stale = 0;
  for (const auto& [name, type] : types) {
    const fs::path path = fs::path(home()) / "data" / "zones" / (name + ".zone");
    const std::string bytes = model::weapon::kept_zones().encode(std::span(&type, 1));
    if (contents(path) == bytes) {
      say("{}: up to date\n", path.string());
    } else if (options.check) {
      say("{}: stale, 'eyrie zones {}' makes it anew\n", path.string(), name);
      ++stale;
    } else {
      std::error_code failed;
      fs::create_directories(path.parent_path(), failed);
      disk::OutputFile file(path.string(), true);
      file.sink().write(bytes);
      finish(file);
    }
    if (interrupted())
      break;
  }
  return stale > 0 ? 1 : 0;
}

}  // namespace eyrie::app
