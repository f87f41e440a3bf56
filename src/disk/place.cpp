// SPDX-License-Identifier: MIT
#include "disk/place.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <utility>

#include "disk/failure.hpp"

namespace eyrie::disk {

Place::Place(std::string path, Parents parents) : path_(std::move(path)) {
  while (path_.size() > 1 && path_.back() == '/')
    path_.pop_back();
  const std::size_t slash = path_.rfind('/');
  before_ = slash == path_.npos ? "" : path_.substr(0, slash + 1);
  name_ = path_.substr(before_.size());
  if (name_.empty() || name_ == "." || name_ == "..")
    throw Refused(
        fmt::format("{} is no place to write to: name something of its own", quoted(path_)));
  if (parents == Parents::are_made)
    make_parents();
  folder_ = Handle(
      files().open(AT_FDCWD, before_.empty() ? "." : before_.c_str(), O_RDONLY | O_DIRECTORY, 0));
  if (folder_)
    return;
  const int error = errno;
  if (error == ENOENT)
    throw Refused(fmt::format("cannot make {}: there is no folder {}", quoted(path_),
                              quoted(before_.substr(0, before_.size() - 1))));
  cannot_make(path_, error);
}

void Place::make_parents() {
  for (std::size_t at = before_.find('/', 1); at != before_.npos; at = before_.find('/', at + 1)) {
    // noted first: there may be no memory for it afterwards
    made_.folders.push_back(before_.substr(0, at));
    if (files().make_folder(AT_FDCWD, made_.folders.back().c_str(), 0777) == 0)
      continue;
    const int error = errno;
    made_.folders.pop_back();
    if (error != EEXIST)
      cannot_make(path_, error);
  }
}

Place::Made::~Made() {
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder)
    files().remove(AT_FDCWD, folder->c_str(), AT_REMOVEDIR);
}

std::optional<struct stat> Place::look(const std::string& name) const {
  struct stat found {};
  if (files().status(folder(), name.c_str(), found, AT_SYMLINK_NOFOLLOW) == 0)
    return found;
  if (errno != ENOENT)
    cannot_make(beside(name), errno);
  return std::nullopt;
}

}  // namespace eyrie::disk
