// SPDX-License-Identifier: MIT
#include "disk/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>

#include "disk/failure.hpp"
#include "disk/put.hpp"

namespace eyrie::disk {
namespace {

/// What stands there, if it may be replaced.
std::optional<struct stat> replaceable(const Place& place, bool replace) {
  const auto found = place.look();
  if (found && !S_ISREG(found->st_mode))
    throw Refused(fmt::format("{} is {}; only files are replaced", quoted(place.path()),
                              kind_text(found->st_mode)));
  if (found && !replace)
    throw Refused(
        fmt::format("{} exists already; name another file or add --force", quoted(place.path())));
  remove_abandoned(place, {});
  return found;
}

}  // namespace

OutputFile::OutputFile(const std::string& path, bool replace, mode_t mode)
    : place_(path, Parents::must_exist),
      replace_(replace),
      mode_(mode),
      before_(replaceable(place_, replace)),
      part_(place_, EntryKind::file, {}),
      sink_(part_.handle(), place_.path()) {}

void OutputFile::commit() {
  if (!sink_.close())
    throw Failed(sink_.error());
  const mode_t mode = before_ ? before_->st_mode & 0777U : default_mode(mode_);
  if (files().set_mode(part_.handle(), mode) != 0)
    cannot_make(place_.path(), errno);
  Put put;
  {
    const Moving moving;
    put = put_new(place_.folder(), part_.name(), place_.name());
    if (put.how == Put::done)
      part_.moved();
    else if (put.how == Put::taken && replace_)
      put = put_instead(place_.folder(), part_.name(), place_.name(),
                        [](const struct stat& found) { return S_ISREG(found.st_mode); });
  }
  if (put.how == Put::failed)
    cannot_make(place_.path(), put.error);
  if (put.how == Put::taken)
    throw Failed(
        fmt::format("{} has appeared in the meantime; nothing was written", quoted(place_.path())));
  if (files().sync(place_.folder()) != 0 && errno != EINVAL)
    cannot_make(place_.path(), errno);
}

}  // namespace eyrie::disk
