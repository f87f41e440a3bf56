// SPDX-License-Identifier: MIT
#pragma once
/// \file  A file or folder that is not there, or is as it was, until it is complete; and a folder
/// in which one process works at a time, and a later one goes on.
#include "disk/sink.hpp"
#include "disk/temporary.hpp"

namespace eyrie::disk {

class OutputFile {
 public:
  /// `replace`: a file that is there may be replaced; never anything else than a file. Throws
  /// Refused if that place cannot be used, Failed if nothing can be written there. A new file gets
  /// `mode` as the umask allows; one that is replaced hands its mode on.
  OutputFile(const std::string& path, bool replace, mode_t mode = 0666);

  [[nodiscard]] Sink& sink() { return sink_; }
  /// For who writes by itself: the open file.
  [[nodiscard]] int handle() const { return part_.handle(); }
  /// Until everything is on the disk; then it is put in its place. Throws Failed, and then the
  /// place is as it was.
  void commit();

 private:
  Destination place_;
  bool replace_;
  mode_t mode_;
  std::optional<struct stat> before_;
  Temporary part_;
  Sink sink_;
};

// A folder of files that is not there, or is as it was, until it is complete.

/// Which folder is to be made.
struct FolderWish {
  std::string path;
  Names names;                 ///< of the files that may be in it
  const char* sign = "";       ///< the one without which it is no such folder
  const char* kind = "a run";  ///< what it is the folder of, for people
  bool replace = false;        ///< one that is there, with the sign and nothing but `names`
  const char* to_replace = "add --force";  ///< what who wants that has to do, for people
  bool numbered = false;  ///< if it is taken: path.2, path.3 ...; nothing is replaced
};

class OutputFolder {
 public:
  /// Throws Refused if that place may not be used, Failed if nothing can be written there.
  explicit OutputFolder(const FolderWish& wish);

  /// A new file in it.
  [[nodiscard]] Sink file(const char* name) const;
  /// A file that is not to be in it after all.
  void drop(const char* name) const;
  /// commit() shall replace nothing that is there: what was made is less than what was wanted.
  void spare_old() { spared_ = true; }
  /// Where it is to be, and after commit() where it is.
  [[nodiscard]] const std::string& path() const { return path_; }

  /// Puts it in its place. If somebody else has taken or changed that in the meantime: in the next
  /// free one, path.2, path.3 ...; then gives the words for it, else "". Throws Failed, and then
  /// the place is as it was.
  [[nodiscard]] std::string commit();

 private:
  /// What is replaced, as it was found and locked.
  struct Old {
    struct stat found {};
    Handle folder;
    bool empty = true;
  };
  [[nodiscard]] std::optional<Old> find_old() const;
  [[nodiscard]] std::string foreign(int folder) const;
  [[nodiscard]] bool unchanged() const;
  [[nodiscard]] Put put_in_place();
  [[nodiscard]] std::string drop_old(const std::string& name);

  FolderWish wish_;
  Destination place_;
  std::string path_;
  std::optional<Old> old_;
  bool spared_ = false;
  Temporary part_;
};

/// Makes `link` a symbolic link to `to`, at once for who looks and whoever else does so; it
/// replaces nothing but a link. Gives the words for what went wrong, or "".
[[nodiscard]] std::string point_link(const std::string& link, const std::string& to);

/// Locks the folder until the handle is closed; makes it, with its parents, if it is not there.
/// Throws Refused if something is in it and none of that `is_ours`, or it is and nobody asked to
/// `resume`, or another process works on it. `kind`: "campaign".
[[nodiscard]] Handle work_folder(const std::string& path, const char* kind,
                                 const std::function<bool(const std::string& name)>& is_ours,
                                 bool resume);

}  // namespace eyrie::disk
