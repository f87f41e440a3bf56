// SPDX-License-Identifier: MIT
#include "disk/work_folder.hpp"

#include <algorithm>
#include <cerrno>

#include "core/diagnostics.hpp"
#include "disk/temporary.hpp"

namespace eyrie::disk {

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
