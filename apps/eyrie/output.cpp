// SPDX-License-Identifier: MIT
#include "output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "say.hpp"

namespace eyrie::app {
namespace fs = std::filesystem;

OutputFolder::OutputFolder(const std::string& wanted, const std::string& name, std::uint64_t seed,
                           bool force)
    : path_(wanted), force_(force) {
  if (path_.empty()) {
    const std::string base = fmt::format("runs/{}-{}", name, seed);
    path_ = base;
    for (int i = 2; fs::exists(path_); ++i)
      path_ = fmt::format("{}.{}", base, i);
  } else {
    while (path_.size() > 1 && path_.back() == '/')
      path_.pop_back();
    std::error_code ignored;
    if (fs::exists(path_) && !force && !(fs::is_directory(path_) && fs::is_empty(path_, ignored)))
      throw std::invalid_argument(
          fmt::format("--out '{}' exists already; name another folder or add --force", path_));
  }
  staging_ = fmt::format("{}.part-{}", path_, ::getpid());
  std::error_code failed;
  fs::create_directories(staging_, failed);
  if (failed)
    throw std::runtime_error(fmt::format("cannot make '{}': {}", path_, failed.message()));
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!done_)
    fs::remove_all(staging_, ignored);
}

void OutputFolder::commit() {
  std::error_code failed;
  if (fs::exists(path_))
    fs::remove_all(path_, failed);
  fs::rename(staging_, path_, failed);
  if (failed)
    throw std::runtime_error(fmt::format("cannot make '{}': {}", path_, failed.message()));
  done_ = true;
}

OutputFile::OutputFile(std::string path)
    : path_(std::move(path)), part_(fmt::format("{}.part-{}", path_, ::getpid())), sink_(part_) {}

OutputFile::~OutputFile() {
  std::error_code ignored;
  fs::remove(part_, ignored);  // nothing is there after commit()
}

bool OutputFile::commit() {
  std::error_code failed;
  if (!sink_.close()) {
    complain("eyrie: {}\n", sink_.error());
    return false;
  }
  fs::rename(part_, path_, failed);
  if (failed)
    complain("eyrie: cannot make '{}': {}\n", path_, failed.message());
  return !failed;
}

std::optional<std::string> free_or_complain(const std::string& wanted, const std::string& otherwise,
                                            bool force) {
  if (wanted.empty())
    return otherwise;
  if (force || !fs::exists(wanted))
    return wanted;
  complain("eyrie: --out '{}' exists already; name another file or add --force\n", wanted);
  return std::nullopt;
}

}  // namespace eyrie::app
