// SPDX-License-Identifier: MIT
#include "disk/output.hpp"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>

#include "core/diagnostics.hpp"
#include "disk/file_system.hpp"
#include "disk/temporary.hpp"

namespace eyrie::disk {
namespace {

/// The path of a file.
const std::string& file_path(const std::string& path) {
  if (path.ends_with('/'))
    throw Refused("{} is the name of a folder; name a file", quote_path(path));
  return path;
}

/// What stands there, if it may be replaced.
std::optional<struct stat> replaceable(const Destination& place, bool replace) {
  const auto found = place.look();
  if (found && !S_ISREG(found->st_mode))
    throw Refused("{} is {}; only files are replaced", quote_path(place.path()),
                  kind_text(found->st_mode));
  if (found && !replace)
    throw Refused("{} exists already; name another file or add --force", quote_path(place.path()));
  remove_abandoned(place, {});
  return found;
}

}  // namespace

OutputFile::OutputFile(const std::string& path, bool replace, mode_t mode)
    : place_(file_path(path), Parents::must_exist),
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
    throw Failed("{} has appeared in the meantime; nothing was written", quote_path(place_.path()));
  if (files().sync(place_.folder()) != 0 && errno != EINVAL)
    cannot_make(place_.path(), errno);
}

namespace {

/// Whether the current folder is this one or below it.
bool stand_in(const struct stat& folder) {
  struct stat here {
  }, above{};
  std::string path = ".";
  for (bool known = files().status(AT_FDCWD, path.c_str(), here, 0) == 0; known; here = above) {
    if (same_inode(here, folder))
      return true;
    path += "/..";
    known = files().status(AT_FDCWD, path.c_str(), above, 0) == 0 && !same_inode(here, above);
  }
  return false;
}

}  // namespace

OutputFolder::OutputFolder(const FolderWish& wish)
    : wish_(wish),
      place_(wish.path, Parents::are_made),
      path_(place_.path()),
      old_(wish.numbered ? std::nullopt : find_old()),
      part_(place_, EntryKind::folder, wish.names) {
  remove_abandoned(place_, wish.names);
}

/// The first file in an open folder that Eyrie has not written, or "".
std::string OutputFolder::foreign(int folder) const {
  std::vector<std::string> inside;
  if (files().list(folder, inside) != 0)
    cannot_make(path_, errno);
  std::ranges::sort(inside);
  for (const std::string& name : inside) {
    const bool ours =
        is_temporary(name) ||
        std::ranges::any_of(wish_.names, [&](const char* known) { return name == known; });
    struct stat found {};
    if (!ours || files().status(folder, name.c_str(), found, AT_SYMLINK_NOFOLLOW) != 0 ||
        !S_ISREG(found.st_mode))
      return name;
  }
  return {};
}

std::optional<OutputFolder::Old> OutputFolder::find_old() const {
  const auto found = place_.look();
  if (!found)
    return std::nullopt;
  if (!S_ISDIR(found->st_mode))
    throw Refused("{} is {}; only a folder is made or replaced", quote_path(path_),
                  kind_text(found->st_mode));
  Old old{*found, Handle(files().open(place_.folder(), place_.name().c_str(),
                                      O_RDONLY | O_DIRECTORY | O_NOFOLLOW, 0))};
  std::vector<std::string> inside;
  if (!old.folder || files().list(old.folder.get(), inside) != 0)
    cannot_make(path_, errno);
  old.empty = inside.empty();
  if (!old.empty && !wish_.replace)
    throw Refused("{} exists already; name another folder or {}", quote_path(path_),
                  wish_.to_replace);
  if (stand_in(*found))
    throw Refused("{} is where you are, or above; it is not replaced", quote_path(path_));
  if (files().mount_point(old.folder.get()))
    throw Refused("{} is the root of a disk; name a folder in it", quote_path(path_));
  if (old.empty)
    return old;
  if (std::ranges::find(inside, wish_.sign) == inside.end())
    throw Refused("{} has no {}: only the folder of {} is replaced", quote_path(path_), wish_.sign,
                  wish_.kind);
  if (!(found->st_mode & S_IWUSR))
    throw Refused("{} is read-only, and not replaced; name another folder", quote_path(path_));
  if (const std::string name = foreign(old.folder.get()); !name.empty())
    throw Refused("{} has {}, which Eyrie has not written: it is not replaced", quote_path(path_),
                  quote_path(name));
  return old;
}

Sink OutputFolder::file(const char* name) const {
  return {part_.handle(), name, fmt::format("{}/{}", path_, name)};
}

void OutputFolder::drop(const char* name) const {
  files().remove(part_.handle(), name, 0);
}

/// Whether what is to be replaced is what it was, and nobody else is about to replace it.
bool OutputFolder::unchanged() const {
  const auto now = place_.look();
  return now && same_inode(*now, old_->found) && foreign(old_->folder.get()).empty() &&
         (files().lock(old_->folder.get()) == 0 || errno != EWOULDBLOCK);
}

Put OutputFolder::put_in_place() {
  const int folder = place_.folder();
  if (!old_ || !place_.look())
    return put_new(folder, part_.name(), place_.name());
  if (!unchanged() || (spared_ && !old_->empty))
    return {Put::taken};
  if (!old_->empty)
    return put_instead(folder, part_.name(), place_.name(),
                       [&](const struct stat& found) { return same_inode(found, old_->found); });
  // the system moves a folder over an empty one, and over no other
  const int moved = files().rename(folder, part_.name().c_str(), folder, place_.name().c_str(), 0);
  return moved == 0 ? Put{} : Put{Put::taken, errno};
}

std::string OutputFolder::commit() {
  // whoever makes it writes its page into it, too
  const mode_t mode = S_IRWXU | (old_ ? old_->found.st_mode & 0777U : default_mode(0777));
  if (files().set_mode(part_.handle(), mode) != 0 ||
      (files().sync(part_.handle()) != 0 && errno != EINVAL))
    cannot_make(path_, errno);
  const std::string part = part_.name();
  std::string words;
  bool replaced = false;
  {
    const Moving moving;
    Put put = put_in_place();
    replaced = put.how == Put::done && old_ && !old_->empty;
    if (put.how != Put::done && !wish_.numbered)
      words = put.how == Put::failed
                  ? fmt::format("cannot make {}: {}", quote_path(path_), words_of(put.error))
              : spared_
                  ? fmt::format("{} is as it was", quote_path(path_))
                  : fmt::format("{} has been taken or changed in the meantime", quote_path(path_));
    for (int i = 2; put.how != Put::done; ++i) {
      const std::string name = fmt::format("{}.{}", place_.name(), i);
      std::string there = place_.beside(name);
      put = put_new(place_.folder(), part, name);
      if (put.how == Put::failed)
        cannot_make(path_, put.error);
      path_ = std::move(there);
    }
    part_.moved();
  }
  if (!words.empty())
    words += fmt::format("; the new one is {}", quote_path(path_));
  if (files().sync(place_.folder()) != 0 && errno != EINVAL && words.empty())
    words =
        fmt::format("{} is lost if the power fails now: {}", quote_path(path_), words_of(errno));
  const std::string left = replaced ? drop_old(part) : "";
  return words.empty() ? left : words;
}

/// Removes what was replaced; words if it has something of somebody else by now.
std::string OutputFolder::drop_old(const std::string& name) {
  const int folder = place_.folder();
  for (int i = 0; i < 2; ++i)  // what fails may have failed for a moment only
    if (remove_folder(folder, name, old_->folder.get(), wish_.names))
      return {};
  std::string kept = place_.name() + ".old";
  for (int i = 2; put_new(folder, name, kept).how == Put::taken; ++i)
    kept = fmt::format("{}.old.{}", place_.name(), i);
  return fmt::format("what {} was could not be removed; it is {}", quote_path(path_),
                     quote_path(place_.beside(kept)));
}

std::string point_link(const std::string& link, const std::string& to) {
  struct stat found {};
  if (files().status(AT_FDCWD, link.c_str(), found, AT_SYMLINK_NOFOLLOW) == 0 &&
      !S_ISLNK(found.st_mode))
    return fmt::format("'{}' is {}, and not made a link to '{}'", link, kind_text(found.st_mode),
                       to);
  const std::string part = link.substr(0, link.rfind('/') + 1) + temporary_name();
  const Moving moving;
  if (files().link(to.c_str(), AT_FDCWD, part.c_str()) == 0 &&
      files().rename(AT_FDCWD, part.c_str(), AT_FDCWD, link.c_str(), 0) == 0)
    return "";
  const int error = errno;
  files().remove(AT_FDCWD, part.c_str(), 0);
  return fmt::format("'{}' cannot be made a link to '{}': {}", link, to, words_of(error));
}

Handle work_folder(const std::string& path, const char* kind,
                   const std::function<bool(const std::string&)>& is_ours, bool resume) {
  const Destination place(path, Parents::are_made);
  const bool made = files().make_folder(place.folder(), place.name().c_str(), 0777) == 0;
  if (!made && errno != EEXIST)
    cannot_make(place.path(), errno);
  Handle folder(files().open(place.folder(), place.name().c_str(), O_RDONLY | O_DIRECTORY, 0));
  if (!folder)
    cannot_make(place.path(), errno);
  const std::string named = quote_path(place.path());
  std::vector<std::string> names;
  if (!made && files().list(folder.get(), names) == 0 && !names.empty()) {
    if (std::ranges::none_of(names, is_ours))
      throw Refused("{} is there already, and is no {}", named, kind);
    if (!resume)
      throw Refused("{} is there already: --resume goes on with it, --out names another folder",
                    named);
  }
  if (files().lock(folder.get()) != 0)
    throw Refused(
        "another process is working on the {} in {}; wait until it has ended, or interrupt it",
        kind, named);
  return folder;
}

}  // namespace eyrie::disk
