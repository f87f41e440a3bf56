// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where the files of a scenario come from: the disk, or the bundle inside a run file; and
/// one document of them, with what it includes and the overrides from outside.
#include <map>
#include <memory>
#include <optional>

#include "core/diagnostics.hpp"
#include "core/value.hpp"
#include "core/yaml.hpp"
#include "scenario/changes.hpp"

namespace eyrie::scenario {

/// Reads text files and remembers each one, so that a run can carry everything it was made from.
/// File names are kept as the user wrote them, with '/' between folders.
class Source {
 public:
  /// Reads from the disk; names in data/ are looked up below `home`. `allowed` are folders that
  /// includes may stand in besides those of confine_to_folder_of(). The launch zones of data/zones
  /// are taken, so none of them is flown again.
  [[nodiscard]] static Source disk(std::string home, std::vector<std::string> allowed = {});
  /// Serves only these texts: a replay must not read what has changed on the disk since.
  [[nodiscard]] static Source bundle(std::map<std::string, std::string> files);

  /// From now on only what stands below the folder of `file`, below `home` or below what is
  /// allowed is read, symbolic links resolved. A scenario is often somebody else's: it must not
  /// show what else is on the disk.
  void confine_to_folder_of(const std::string& file);
  [[nodiscard]] bool is_outside(const std::string& name) const {
    return folders_ && folders_->is_outside(name);
  }
  /// Why there is no text of a file that the file `asker` names, with the nearest name if there is
  /// no file.
  [[nodiscard]] std::string why_unread(const std::string& name, const std::string& asker) const;
  /// The name under which a file is read that the file `asker`, or the user himself (""), names: of
  /// his own in data/ of the working folder "./data/x.yaml", because "data/x.yaml" is below `home`.
  [[nodiscard]] std::string named_by(const std::string& asker, const std::string& name) const;

  /// The bytes of a file that is no text, or nothing in the same cases; of one that is larger than
  /// kLargestBytes any part. Among files() it stands in base64, so that all of them are texts.
  [[nodiscard]] std::optional<std::string> read_bytes(const std::string& name);
  /// The text of a file, or nothing when it is missing, unreadable, outside or no file. Of a file
  /// larger than kLargest only so much that a parser sees that it is too large.
  [[nodiscard]] std::optional<std::string> read(const std::string& name);
  /// The name under which `data/<kind>/<name>.yaml`, or the model of a plug-in, is read.
  [[nodiscard]] std::string data_name(std::string_view kind, std::string_view name) const;
  /// Every name in data/<kind>, sorted: for "did you mean".
  [[nodiscard]] std::vector<std::string> data_names(std::string_view kind) const;

  /// A text that is read under that name from now on, such as a scenario made by a program.
  void add(std::string name, std::string text) { files_[std::move(name)] = std::move(text); }
  /// A model that stands in no file; `origin` is the plug-in that it comes from. From then on it is
  /// the one of that kind and name.
  void add_model(std::string_view kind, std::string_view name, std::string origin,
                 std::string text);
  /// The plug-in that a model comes from, or nothing.
  [[nodiscard]] std::optional<std::string> origin(std::string_view kind,
                                                  std::string_view name) const;

  /// The file of one of Eyrie's own scenarios by its name, "sweep", or "" if there is none: from
  /// the disk "eyrie:scenarios/sweep.yaml", which stands below `home`.
  [[nodiscard]] std::string shipped(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> shipped_names() const;

  /// Kind and name of every model of a plug-in.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> added_models() const;

  /// Every file read so far: name -> text.
  [[nodiscard]] const std::map<std::string, std::string>& files() const { return files_; }
  [[nodiscard]] bool is_bundle() const { return !folders_; }

  static constexpr std::size_t kLargest = YamlLimits{}.bytes;
  static constexpr std::size_t kLargestBytes = kLargest / 4 * 3;  ///< that base64 makes kLargest

  /// Where files are looked for that were not given as texts.
  class Folders {
   public:
    virtual ~Folders() = default;
    virtual void confine_to_folder_of(const std::string& file) = 0;
    [[nodiscard]] virtual bool is_outside(const std::string& name) const = 0;
    [[nodiscard]] virtual std::optional<std::string> read(const std::string& name) const = 0;
    /// ": is a folder, not a file" or "; did you mean 'x'?", or "".
    [[nodiscard]] virtual std::string why_unread(const std::string& name,
                                                 const std::string& asker) const = 0;
    /// The names of the YAML files in a folder below home, without their ending.
    [[nodiscard]] virtual std::vector<std::string> names_in(const std::string& folder) const = 0;
  };

  /// What the names of files below `home` begin with that are no data.
  static const inline std::string kOwn = "eyrie:";

 private:
  [[nodiscard]] std::vector<std::string> names_below(const std::string& folder) const;

  std::shared_ptr<Folders> folders_;  ///< if it reads from the disk
  std::map<std::string, std::string> files_;

  struct Model {
    std::string origin, text;
  };
  std::map<std::pair<std::string, std::string>, Model> models_;  ///< of plug-ins, by kind and name
};

/// The launch zones of the missiles of data/, the files of data/zones below `home` one behind the
/// other: for model::weapon::KeptZones::take().
[[nodiscard]] std::string launch_zones(const std::string& home);

/// "folder/of/file.yaml" + "other.yaml" -> "folder/of/other.yaml"; an absolute name stays, and one
/// of Eyrie's own ("eyrie:scenarios/sweep.yaml").
[[nodiscard]] std::string relative_to(std::string_view file, std::string_view name);
/// The file that a value names: from the folder of the file that it stands in, or, typed as part of
/// an option, as it was typed.
[[nodiscard]] std::string file_named(const Value& name);

/// Whether a file is none to fly but one to include: it holds trees, data and plugins alone.
[[nodiscard]] bool is_package(const Value& document);
/// What is wrong with a scenario or campaign of a format that this program does not read.
[[nodiscard]] std::optional<Diagnostic> other_format(const Value& document);
/// What a file is that is no scenario, and what to do with it; "" for what may be one.
[[nodiscard]] std::string what_else(const Value& document, const std::string& file);

/// Reads `file` on top of the scenario that it `extends:` and with what both `include:`: the maps
/// `trees` and `data` and the list `plugins` of these files (nothing else may stand in them); then
/// makes its changes (scenario/changes.hpp). A file that is reached in two ways is read once. A
/// name that is defined twice, a file that is missing, and one that extends or includes itself are
/// mistakes. What was taken out on the way goes to `removed`.
[[nodiscard]] Value load_document(const std::string& file, Source& source, Diagnostics& diagnostics,
                                  std::vector<Removed>* removed = nullptr);

/// Applies `path.to.key=value` to the document. The value is YAML, so `[1, 2]` is a list; it stands
/// behind the key, or the name of an item, that the path (scenario/path.hpp) ends with. The last
/// key may be new, everything before it must exist. No value is null. Mistakes stand in the file
/// "--set <text>", and so do later mistakes in what was set.
void apply_overrides(Value& document, std::span<const std::string> sets, Diagnostics& diagnostics);

/// Moves the places in a value, read from the text of an override behind `offset`, into that text.
void place_in_override(Value& value, const std::string& text, std::size_t offset);

}  // namespace eyrie::scenario
