// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where something is to be written, and what is being written and is not there yet.
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "disk/file_system.hpp"

namespace eyrie::disk {

enum class Parents { must_exist, are_made };

/// A name in an open folder, so that the place stays the same whatever is renamed around it.
class Destination {
 public:
  /// Throws Refused if the folder of `path` is not there or `path` ends in no name, such as "..".
  Destination(std::string path, Parents parents);
  Destination(const Destination&) = delete;
  Destination& operator=(const Destination&) = delete;

  /// As the user wrote it, without slashes at the end.
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] int folder() const { return folder_.get(); }
  [[nodiscard]] const std::string& name() const { return name_; }
  /// The path of another name in the same folder.
  [[nodiscard]] std::string beside(const std::string& name) const { return before_ + name; }

  /// What is there, not following a symbolic link; nothing if nothing is. Throws as cannot_make().
  [[nodiscard]] std::optional<struct stat> look() const { return look(name_); }
  [[nodiscard]] std::optional<struct stat> look(const std::string& name) const;

 private:
  /// Folders that go again if nothing is in them.
  struct Made {
    std::vector<std::string> folders;
    ~Made();
  };
  void make_parents();

  std::string path_, before_, name_;  // before_: "", or all up to the last slash and it
  Made made_;
  Handle folder_;
};

[[nodiscard]] inline bool same_inode(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

/// Names of files that Eyrie writes into a folder; the texts live as long as the program.
using Names = std::span<const char* const>;

enum class EntryKind { file, folder };

/// A new file or folder beside a place, of a name that nobody can guess or has made before, and
/// locked as long as this lives. It goes with all that Eyrie has put into it, unless it has been
/// moved to its place.
class Temporary {
 public:
  /// `names` is what may be in a folder. Throws as cannot_make().
  Temporary(const Destination& place, EntryKind kind, Names names);
  ~Temporary();
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  /// The open file or folder itself.
  [[nodiscard]] int handle() const { return handle_.get(); }
  /// From now on it belongs to the place where it was moved to.
  void moved();

 private:
  [[nodiscard]] bool make(mode_t mode);

  const Destination& place_;
  Names names_;
  EntryKind kind_;
  std::string name_;
  Handle handle_;
  int slot_ = -1;
};

/// What a new file or folder of this process may be, of `wanted`: as its umask says.
[[nodiscard]] mode_t default_mode(mode_t wanted);

/// Whether a name is that of a temporary.
[[nodiscard]] bool is_temporary(std::string_view name);
/// A new name of that kind.
[[nodiscard]] std::string temporary_name();

/// Removes what a program left in the folder of `place` that was killed: temporaries of this user
/// that nobody holds and in which nothing is but `names`. Fails silently.
void remove_abandoned(const Destination& place, Names names);

/// Removes the files with those names, and temporaries, from an open folder and then the folder
/// `name` itself from its `parent`; false if something stays.
bool remove_folder(int parent, const std::string& name, int folder, Names names);

/// For a signal handler that is about to end the program: removes the temporaries of this process.
/// Nothing while a temporary is being moved to its place, which is a moment: false.
bool remove_temporaries_now() noexcept;

/// While this lives temporaries are being moved.
struct Moving {
  Moving();
  ~Moving();
  Moving(const Moving&) = delete;
  Moving& operator=(const Moving&) = delete;
};

// A temporary comes to its place in one go: what was there before, or the new, never
// neither.

/// How a move went: `error` is that of errno if it could not be made. Nothing is moved then.
struct Put {
  enum How { done, taken, failed } how = done;
  int error = 0;
};

/// Gives `from` the name `to` in the same folder; taken if there is anything of that name.
[[nodiscard]] Put put_new(int folder, const std::string& from, const std::string& to);

/// Swaps `from` and `to`: then `from` is what was there. Only if `expected` of what came out is
/// true; taken if not. Where a file system knows no swap there is a moment in which neither has the
/// name, and both stand beside it.
[[nodiscard]] Put put_instead(int folder, const std::string& from, const std::string& to,
                              const std::function<bool(const struct stat&)>& expected);

}  // namespace eyrie::disk
