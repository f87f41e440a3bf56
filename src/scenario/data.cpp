// SPDX-License-Identifier: MIT
#include "scenario/data.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "core/yaml.hpp"

namespace eyrie::scenario {
namespace {

/// Far above what anybody needs; a longer chain is an attempt to exhaust the stack.
constexpr std::size_t kMostBases = 20;

std::string_view singular(std::string_view folder) {
  std::string_view word;
  each_kind_of_model([&](const auto& kind) {
    if (kind.folder == folder)
      word = kind.singular;
  });
  return word;
}

/// Of one kind in one scenario. A station knows its store by one byte (model::Station).
constexpr std::size_t kMostModels = 200;

}  // namespace

std::string_view model_in(const Value& document) {
  if (document.find("eyrie") || document.find("extends"))
    return "";
  std::string_view found;
  auto most = static_cast<std::ptrdiff_t>(document.entries.size() / 2);
  each_kind_of_model([&]<class Model>(const KindOfModel<Model>& kind) {
    const auto known = std::ranges::count_if(document.entries, [](const Value::Entry& e) {
      return e.key == "base" || e.key == "source" || description_of<Model>().find(e.key);
    });
    if (known > most) {
      most = known;
      found = kind.singular;
    }
  });
  return found;
}

Location place_in_data(const Value& document, std::string_view kind, std::string_view model,
                       std::string_view parameter) {
  const Value* found = document.find("data");
  for (const std::string_view key : {kind, model})
    found = found ? found->find(key) : nullptr;
  if (!found)
    return document.where_of("rates");
  for (std::size_t begin = 0; begin < parameter.size();) {  // of a part, behind its point
    const std::size_t end = std::min(parameter.find('.', begin), parameter.size());
    const Value* next = found->find(parameter.substr(begin, end - begin));
    if (!next)
      break;
    found = next;
    begin = end + 1;
  }
  return found->where;
}

std::vector<std::string_view> DataLoader::kinds() {
  std::vector<std::string_view> all;
  each_kind_of_model([&](const auto& kind) { all.push_back(kind.folder); });
  return all;
}

DataLoader::DataLoader(model::Library& library, const Value* inline_data, Source& source,
                       Diagnostics& diagnostics)
    : library_(library), inline_(inline_data), source_(source), diagnostics_(diagnostics) {
  if (!inline_)
    return;
  if (!inline_->is_map()) {
    diagnostics_.error(inline_->where, "data: expected a map of kinds, got " + inline_->shown());
    return;
  }
  for (const Value::Entry& kind : inline_->entries)
    check_inline(kind);
  // a model that nobody flies is read, too: otherwise its mistakes wait for the day it is needed
  for (const Value::Entry& kind : inline_->entries)
    if (kind.value.entries.size() <= kMostModels)
      for (const Value::Entry& model : kind.value.entries)
        load_any(kind.key, model.key, model.where);
}

void DataLoader::check_inline(const Value::Entry& kind) {
  if (singular(kind.key).empty()) {
    diagnostics_.error(kind.where, "data has no kind {}{}", quote(kind.key),
                       did_you_mean(kind.key, kinds()));
    return;
  }
  if (!kind.value.is_map())
    diagnostics_.error(kind.value.where, "data.{}: expected a map of names, got {}", kind.key,
                       kind.value.shown());
  if (kind.value.entries.size() > kMostModels) {
    diagnostics_.error(kind.where, "data.{}: {} models; a scenario has at most {} of a kind",
                       kind.key, kind.value.entries.size(), kMostModels);
    return;
  }
  const std::vector<std::string> taken = source_.data_names(kind.key);
  for (const Value::Entry& model : kind.value.entries) {
    if (kind.key == "missiles" && model.key == "none")
      diagnostics_.error(
          model.where,
          "data.missiles: 'none' means an empty station; give the missile another name");
    if (const auto problem = identifier_problem(model.key))
      diagnostics_.error(model.where, "data.{}: {}", kind.key, *problem);
    else if (std::ranges::binary_search(taken, model.key))
      diagnostics_.error(model.where,
                         "{0} '{1}' is there already ({2}): give yours another name; 'base: {1}' "
                         "takes over what it does not say",
                         singular(kind.key), model.key, source_.data_name(kind.key, model.key));
  }
}

void DataLoader::check_plugins(Source source, Diagnostics& diagnostics) {
  model::Library scratch;
  DataLoader loader(scratch, nullptr, source, diagnostics);
  loader.only_checks_ = true;
  for (const auto& [kind, name] : source.added_models())
    loader.load_any(kind, name, {source.data_name(kind, name), 0, 0});
}

void DataLoader::load_any(std::string_view kind, const std::string& name, const Location& where) {
  each_kind_of_model([&]<class Model>(const KindOfModel<Model>& known) {
    if (kind == known.folder)
      load<Model>(name, where);
  });
}

std::optional<Value> DataLoader::document(std::string_view kind, const std::string& name,
                                          const Location& where, std::vector<std::string>& chain) {
  const Value* group = inline_ ? inline_->find(kind) : nullptr;
  if (const auto first = std::ranges::find(chain, name); first != chain.end()) {
    const std::vector<std::string> taken = source_.data_names(kind);
    if (std::any_of(first, chain.end(), [&](const std::string& link) {
          return group && group->find(link) && std::ranges::binary_search(taken, link);
        }))
      return std::nullopt;  // said by check_inline()
    std::string loop;
    for (auto link = first; link != chain.end(); ++link) {
      loop += *link + " -> ";
      failed_[{std::string(kind), *link}] = true;  // one circle, one mistake
    }
    return diagnostics_.error(where, "{} {} is based on itself: {}{}", singular(kind), quote(name),
                              loop, name);
  }
  if (chain.size() > kMostBases)
    return diagnostics_.error(where, "{} {} has more than {} bases below one another",
                              singular(kind), quote(chain.front()), kMostBases);
  chain.push_back(name);

  std::optional<Value> found;
  if (group && group->entries.size() > kMostModels)
    return std::nullopt;  // said by check_inline()
  if (const Value* there = group ? group->find(name) : nullptr) {
    found = *there;
  } else if (const auto text =
                 is_identifier(name) ? source_.read(source_.data_name(kind, name)) : std::nullopt) {
    const std::size_t before = diagnostics_.count();
    Value v = parse_yaml(*text, source_.data_name(kind, name), diagnostics_);
    if (diagnostics_.count() != before)
      return std::nullopt;
    found = std::move(v);
  }
  if (!found) {
    std::vector<std::string> names = source_.data_names(kind);
    if (group)
      for (const Value::Entry& e : group->entries)
        names.push_back(e.key);
    return diagnostics_.error(where, "unknown {} {}{}", singular(kind), quote(name),
                              nearest_or_all(name, names));
  }
  const Value* base = found->find("base");
  if (base) {
    if (!base->is_scalar())
      return diagnostics_.error(base->where, "base: expected a name, got " + base->shown());
    auto below = document(kind, base->text, base->where, chain);
    if (!below)
      return std::nullopt;
    return merged(std::move(*below), *found);
  }
  return found;
}

template <Described Model>
std::optional<std::uint16_t> DataLoader::load(const std::string& name, const Location& where) {
  constexpr const auto& kKind = std::get<KindOfModel<Model>>(kKindsOfModels);
  if (const auto known = (library_.*kKind.shelf).find(name))
    return known;
  bool& failed = failed_[{std::string(kKind.folder), name}];
  if (failed) {
    ++untold_;
    return std::nullopt;
  }
  const std::size_t before = diagnostics_.count() + untold_;
  std::vector<std::string> chain;
  const auto map = document(kKind.folder, name, where, chain);
  Model model;
  static constexpr std::array<std::string_view, 2> kAlso{"base", "source"};
  if (map && bind(model, *map, diagnostics_, kAlso))
    complete(model, *map);
  failed = !map || diagnostics_.count() + untold_ != before;
  if (failed)
    return std::nullopt;
  return (library_.*kKind.shelf).add(name, std::move(model));
}

template <Described Model>
void DataLoader::part(std::optional<std::uint16_t>& index, const std::optional<std::string>& name,
                      const Location& where) {
  if (name)
    index = load<Model>(*name, where);
}

template <Described Model>
void DataLoader::complete(Model& model, const Value& document) {
  if constexpr (std::same_as<Model, model::AircraftType>)
    if (const auto frame = load<model::Airframe>(model.airframe, document.where_of("airframe")))
      model.index.airframe = *frame;
  if constexpr (requires { model.index.radar; }) {
    part<model::Radar>(model.index.radar, model.radar, document.where_of("radar"));
    part<model::Irst>(model.index.irst, model.irst, document.where_of("irst"));
    part<model::Rwr>(model.index.rwr, model.rwr, document.where_of("rwr"));
    part<model::Iff>(model.index.iff, model.iff, document.where_of("iff"));
    part<model::Tracker>(model.index.tracker, model.tracker, document.where_of("tracker"));
    part<model::GunType>(model.index.gun, model.gun, document.where_of("gun"));
    part<model::Dispenser>(model.index.dispenser, model.dispenser, document.where_of("dispenser"));
    part<model::Jammer>(model.index.jammer, model.jammer, document.where_of("jammer"));
    if (model.rounds && !model.gun)
      diagnostics_.error(document.where_of("rounds"), "rounds: there is no gun for them");
    for (const model::StationFit& station : model.stations)
      load<model::MissileType>(station.store, document.where_of("stations"));
  }
  if constexpr (requires { model.index.visual; }) {
    part<model::Visual>(model.index.visual, model.visual, document.where_of("visual"));
    part<model::Datalink>(model.index.datalink, model.datalink, document.where_of("datalink"));
  }
  if constexpr (requires { model.prepare(); })
    if (!only_checks_)
      model.prepare();
}

template std::optional<std::uint16_t> DataLoader::load<model::AircraftType>(const std::string&,
                                                                            const Location&);
template std::optional<std::uint16_t> DataLoader::load<model::VehicleType>(const std::string&,
                                                                           const Location&);
template std::optional<std::uint16_t> DataLoader::load<model::MissileType>(const std::string&,
                                                                           const Location&);

}  // namespace eyrie::scenario
