// SPDX-License-Identifier: MIT
#include "scenario/source.hpp"

#include <algorithm>
#include <filesystem>

#include "core/text.hpp"

namespace eyrie::scenario {
namespace fs = std::filesystem;
namespace {

/// The name that mistakes in the model of a plug-in carry.
std::string plugin_name(std::string_view origin, std::string_view kind, std::string_view name) {
  return fmt::format("plugin:{}/{}/{}.yaml", origin, kind, name);
}

}  // namespace

Source Source::bundle(std::map<std::string, std::string> files) {
  Source s;
  s.files_ = std::move(files);
  return s;
}

void Source::confine_to_folder_of(const std::string& file) {
  if (folders_)
    folders_->confine_to_folder_of(file);
}

std::string Source::named_by(const std::string& asker, const std::string& name) const {
  if (!name.starts_with("data/") || asker.starts_with("data/") || asker.starts_with(kOwn))
    return name;
  const std::string own = "./" + name;
  const auto text = folders_ && !files_.contains(own) ? folders_->read(own) : std::nullopt;
  return files_.contains(own) || (text && text != folders_->read(name)) ? own : name;
}

std::string Source::why_unread(const std::string& name, const std::string& asker) const {
  if (is_outside(name))
    return quote_path(name) +
           " is outside the folder of the scenario and the installation; --allow-include FOLDER "
           "(in Python include=) allows it";
  const std::string cannot = "cannot read " + quote_path(name);
  if (folders_)
    return cannot + folders_->why_unread(name, asker);
  // as the asker has to write it
  const auto from_asker = [&asker](const std::string& file) {
    const std::string way =
        fs::path(file).lexically_relative(fs::path(asker).parent_path()).generic_string();
    return way.empty() || (file.starts_with(kOwn) && way.starts_with("..")) ? file : way;
  };
  std::vector<std::string> names;
  for (const auto& [there, text] : files_)
    if (there != asker)
      names.push_back(from_asker(there));
  return cannot + did_you_mean(from_asker(name), names);
}

std::optional<std::string> Source::read(const std::string& name) {
  if (const auto known = files_.find(name); known != files_.end())
    return known->second;
  for (const auto& [key, model] : models_)
    if (name == plugin_name(model.origin, key.first, key.second))
      return files_[name] = model.text;
  auto text = folders_ ? folders_->read(name) : std::nullopt;
  if (text)
    files_[name] = *text;
  return text;
}

std::optional<std::string> Source::read_bytes(const std::string& name) {
  if (const auto known = files_.find(name); known != files_.end())
    return from_base64(known->second);
  auto bytes = folders_ ? folders_->read(name) : std::nullopt;
  if (bytes && bytes->size() <= kLargestBytes)
    files_[name] = base64(*bytes);
  return bytes;
}

std::string Source::data_name(std::string_view kind, std::string_view name) const {
  const auto from = origin(kind, name);
  return from ? plugin_name(*from, kind, name) : fmt::format("data/{}/{}.yaml", kind, name);
}

void Source::add_model(std::string_view kind, std::string_view name, std::string origin,
                       std::string text) {
  models_[{std::string(kind), std::string(name)}] = {std::move(origin), std::move(text)};
}

std::vector<std::pair<std::string, std::string>> Source::added_models() const {
  std::vector<std::pair<std::string, std::string>> models;
  for (const auto& [key, model] : models_)
    models.push_back(key);
  return models;
}

std::optional<std::string> Source::origin(std::string_view kind, std::string_view name) const {
  const auto added = models_.find({std::string(kind), std::string(name)});
  return added == models_.end() ? std::nullopt : std::optional(added->second.origin);
}

std::string Source::shipped(std::string_view name) const {
  const std::vector<std::string> names = shipped_names();
  if (std::ranges::find(names, name) == names.end())
    return {};
  const std::string file = fmt::format("scenarios/{}.yaml", name);
  return folders_ || files_.contains(kOwn + file) ? kOwn + file : file;
}

std::vector<std::string> Source::shipped_names() const {
  std::vector<std::string> names = names_below("scenarios/");
  if (!folders_)  // a recorded scenario has its own ones elsewhere
    for (std::string& name : names_below(kOwn + "scenarios/"))
      if (std::ranges::find(names, name) == names.end())
        names.push_back(std::move(name));
  return names;
}

/// The names of the YAML files in a folder, without their ending.
std::vector<std::string> Source::names_below(const std::string& folder) const {
  if (folders_)
    return folders_->names_in(folder);
  std::vector<std::string> names;
  for (const auto& [name, text] : files_)
    if (name.starts_with(folder) && name.ends_with(".yaml") &&
        name.find('/', folder.size()) == name.npos)
      names.push_back(name.substr(folder.size(), name.size() - folder.size() - 5));
  return names;
}

std::vector<std::string> Source::data_names(std::string_view kind) const {
  std::vector<std::string> names = names_below(fmt::format("data/{}/", kind));
  for (const auto& [key, model] : models_)
    if (key.first == kind)
      names.push_back(key.second);
  std::ranges::sort(names);
  return names;
}

std::string relative_to(std::string_view file, std::string_view name) {
  if (name.starts_with('/') || name.starts_with(Source::kOwn))
    return std::string(name);
  return (fs::path(file).parent_path() / fs::path(name)).lexically_normal().generic_string();
}

std::string file_named(const Value& name) {
  const std::string_view asker = name.where.file.text();
  return asker.starts_with("--") ? name.text : relative_to(asker, name.text);
}

}  // namespace eyrie::scenario
