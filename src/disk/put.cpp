// SPDX-License-Identifier: MIT
#include "disk/put.hpp"

#include <fcntl.h>

#include <cerrno>
#include <cstdio>

#include "disk/temporary.hpp"

namespace eyrie::disk {
namespace {

bool not_known(int error) {
  return error == EINVAL || error == ENOSYS || error == EOPNOTSUPP;
}

Put outcome(int error) {
  const bool taken = error == EEXIST || error == ENOTEMPTY;
  return {error == 0 ? Put::done : taken ? Put::taken : Put::failed, error};
}

int move(int folder, const std::string& from, const std::string& to, unsigned flags) {
  return files().rename(folder, from.c_str(), folder, to.c_str(), flags) == 0 ? 0 : errno;
}

bool fits(int folder, const std::string& name,
          const std::function<bool(const struct stat&)>& expected) {
  struct stat found {};
  return files().status(folder, name.c_str(), found, AT_SYMLINK_NOFOLLOW) == 0 && expected(found);
}

/// An empty one of the same kind takes the name; a move over that is one that all systems know.
Put put_over_empty(int folder, const std::string& from, const std::string& to) {
  struct stat found {};
  if (files().status(folder, from.c_str(), found, AT_SYMLINK_NOFOLLOW) != 0)
    return outcome(errno);
  if (S_ISDIR(found.st_mode)) {
    if (files().make_folder(folder, to.c_str(), 0700) != 0)
      return outcome(errno);
  } else {
    const Handle empty(files().open(folder, to.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0600));
    if (!empty)
      return outcome(errno);
  }
  const Put put = outcome(move(folder, from, to, 0));
  if (put.how == Put::failed)
    files().remove(folder, to.c_str(), S_ISDIR(found.st_mode) ? AT_REMOVEDIR : 0);
  return put;
}

}  // namespace

Put put_new(int folder, const std::string& from, const std::string& to) {
  const Put put = outcome(move(folder, from, to, RENAME_NOREPLACE));
  return put.how == Put::failed && not_known(put.error) ? put_over_empty(folder, from, to) : put;
}

Put put_instead(int folder, const std::string& from, const std::string& to,
                const std::function<bool(const struct stat&)>& expected) {
  if (!fits(folder, to, expected))
    return {Put::taken};
  const int error = move(folder, from, to, RENAME_EXCHANGE);
  if (error == 0) {
    if (fits(folder, from, expected))
      return {};
    static_cast<void>(move(folder, from, to, RENAME_EXCHANGE));
    return {Put::taken};
  }
  if (!not_known(error))
    return outcome(error);

  const std::string aside = temporary_name();
  if (const int failed = move(folder, to, aside, 0))
    return outcome(failed);
  const Put put = fits(folder, aside, expected) ? put_new(folder, from, to) : Put{Put::taken};
  static_cast<void>(put.how == Put::done ? move(folder, aside, from, 0)
                                         : move(folder, aside, to, 0));
  return put;
}

}  // namespace eyrie::disk
