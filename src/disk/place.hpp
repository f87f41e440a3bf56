// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where something is to be written: a name in an open folder, so that the place stays the
/// same whatever is renamed around it.
#include <optional>
#include <string>
#include <vector>

#include "disk/file_system.hpp"

namespace eyrie::disk {

enum class Parents { must_exist, are_made };

class Place {
 public:
  /// Throws Refused if the folder of `path` is not there or `path` ends in no name, such as "..".
  Place(std::string path, Parents parents);
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

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

}  // namespace eyrie::disk
