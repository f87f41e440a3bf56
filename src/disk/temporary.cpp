// SPDX-License-Identifier: MIT
#include "disk/temporary.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>

#include "core/diagnostics.hpp"

namespace eyrie::disk {

Destination::Destination(std::string path, Parents parents) : path_(std::move(path)) {
  while (path_.size() > 1 && path_.back() == '/')
    path_.pop_back();
  const std::size_t slash = path_.rfind('/');
  before_ = slash == path_.npos ? "" : path_.substr(0, slash + 1);
  name_ = path_.substr(before_.size());
  if (name_.empty() || name_ == "." || name_ == ".." || path_ == "-")  // nor is it standard output
    throw Refused(EINVAL, fmt::format("{} is no place to write to: name something of its own",
                                      quote_path(path_)));
  if (parents == Parents::are_made)
    make_parents();
  folder_ = Handle(
      files().open(AT_FDCWD, before_.empty() ? "." : before_.c_str(), O_RDONLY | O_DIRECTORY, 0));
  if (folder_)
    return;
  const int error = errno;
  if (error == ENOENT)
    throw Refused(error, fmt::format("cannot make {}: there is no folder {}", quote_path(path_),
                                     quote_path(before_.substr(0, before_.size() - 1))));
  cannot_make(path_, error);
}

void Destination::make_parents() {
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

Destination::Made::~Made() {
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder)
    files().remove(AT_FDCWD, folder->c_str(), AT_REMOVEDIR);
}

std::optional<struct stat> Destination::look(const std::string& name) const {
  struct stat found {};
  if (files().status(folder(), name.c_str(), found, AT_SYMLINK_NOFOLLOW) == 0)
    return found;
  if (errno != ENOENT)
    cannot_make(beside(name), errno);
  return std::nullopt;
}

namespace {

constexpr std::string_view kPrefix = ".eyrie-part-";
constexpr std::size_t kDigits = 16;

/// What a signal handler needs to know of a temporary.
struct Slot {
  std::atomic<bool> used = false;
  int parent = -1, folder = -1;  // folder: below 0 for a file, or if it is not open yet
  Names names;
  std::array<char, 32> name{};
};
std::array<Slot, 4> slots;
std::atomic<int> moving = 0;

bool holds(Names names, const std::string& name) {
  return std::ranges::any_of(names, [&](const char* n) { return name == n; });
}

}  // namespace

std::string temporary_name() {
  std::uint64_t random = 0;
  if (::getrandom(&random, sizeof random, 0) != sizeof random)
    throw Failed("the system gives no random numbers");
  return fmt::format("{}{:016x}", kPrefix, random);
}

mode_t default_mode(mode_t wanted) {
  const mode_t mask = ::umask(077);
  ::umask(mask);
  return wanted & ~mask;
}

bool is_temporary(std::string_view name) {
  return name.size() == kPrefix.size() + kDigits && name.starts_with(kPrefix) &&
         name.find_first_not_of("0123456789abcdef", kPrefix.size()) == name.npos;
}

Temporary::Temporary(const Destination& place, EntryKind kind, Names names)
    : place_(place), names_(names), kind_(kind) {
  for (std::size_t i = 0; i < slots.size() && slot_ < 0; ++i)
    if (!slots[i].used) {
      slots[i].parent = place.folder();
      slots[i].folder = -1;
      slots[i].names = names;
      slot_ = static_cast<int>(i);
    }
  constexpr int kTries = 100;
  for (int i = 0; i < kTries && !make(kind == EntryKind::folder ? 0700 : 0600); ++i) {
  }
  if (handle_)
    return;
  const int error = errno;
  moved();
  cannot_make(place.path(), error);
}

/// False to try it with another name.
bool Temporary::make(mode_t mode) {
  const int folder = place_.folder();
  name_ = temporary_name();
  Slot* const slot = slot_ < 0 ? nullptr : &slots[static_cast<std::size_t>(slot_)];
  if (slot) {  // known before it is there, so that it is removed at every moment
    slot->used = false;
    std::memcpy(slot->name.data(), name_.c_str(), name_.size() + 1);
    slot->used = true;
  }
  if (kind_ == EntryKind::folder) {
    if (files().make_folder(folder, name_.c_str(), mode) != 0)
      return errno != EEXIST;
    handle_ = Handle(files().open(folder, name_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW, 0));
  } else {
    handle_ =
        Handle(files().open(folder, name_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW, mode));
    if (!handle_)
      return errno != EEXIST;
  }
  // whoever looks for abandoned ones may have been faster, than the lock or even than open()
  struct stat there {};
  const bool lost =
      handle_ ? (files().lock(handle()) != 0 && errno == EWOULDBLOCK) ||
                    (files().status(folder, name_.c_str(), there, AT_SYMLINK_NOFOLLOW) != 0 &&
                     errno == ENOENT)
              : errno == ENOENT;
  if (lost)
    handle_ = {};
  if (!handle_ && !lost) {
    const int error = errno;
    files().remove(folder, name_.c_str(), AT_REMOVEDIR);
    errno = error;
  }
  if (slot && kind_ == EntryKind::folder)
    slot->folder = handle();
  return !lost;
}

void Temporary::moved() {
  if (slot_ >= 0)
    slots[static_cast<std::size_t>(slot_)].used = false;
  slot_ = -1;
  name_.clear();
}

Temporary::~Temporary() {
  if (name_.empty())
    return;
  // what fails may have failed for a moment only
  for (int i = 0; i < 2; ++i)
    if (kind_ == EntryKind::folder ? remove_folder(place_.folder(), name_, handle(), names_)
                                   : files().remove(place_.folder(), name_.c_str(), 0) == 0)
      break;
  moved();
}

bool remove_folder(int parent, const std::string& name, int folder, Names names) {
  std::vector<std::string> inside;
  files().list(folder, inside);
  for (const std::string& file : inside)
    if (holds(names, file) || is_temporary(file))
      files().remove(folder, file.c_str(), 0);
  return files().remove(parent, name.c_str(), AT_REMOVEDIR) == 0 || errno == ENOENT;
}

void remove_abandoned(const Destination& place, Names names) {
  std::vector<std::string> all;
  files().list(place.folder(), all);
  for (const std::string& name : all) {
    if (!is_temporary(name))
      continue;
    const Handle left(
        files().open(place.folder(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK, 0));
    struct stat status {};
    if (!left || files().status(left.get(), status) != 0 || status.st_uid != ::geteuid() ||
        files().lock(left.get()) != 0)
      continue;
    std::vector<std::string> inside;
    if (S_ISREG(status.st_mode))
      files().remove(place.folder(), name.c_str(), 0);
    else if (S_ISDIR(status.st_mode) && files().list(left.get(), inside) == 0 &&
             std::ranges::all_of(inside,
                                 [&](const std::string& file) { return holds(names, file); }))
      remove_folder(place.folder(), name, left.get(), names);
  }
}

bool remove_temporaries_now() noexcept {
  if (moving > 0)
    return false;
  for (Slot& slot : slots) {
    if (!slot.used)
      continue;
    if (slot.folder >= 0)
      for (const char* name : slot.names)
        ::unlinkat(slot.folder, name, 0);
    ::unlinkat(slot.parent, slot.name.data(), 0);  // one of the two: it is a file or a folder
    ::unlinkat(slot.parent, slot.name.data(), AT_REMOVEDIR);
  }
  return true;
}

Moving::Moving() {
  ++moving;
}
Moving::~Moving() {
  --moving;
}

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
