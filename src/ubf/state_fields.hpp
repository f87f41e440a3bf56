// SPDX-License-Identifier: MIT
#pragma once
/// \file  What files may read of a state by name: the words of expressions and switches.
#include <limits>
#include <utility>
#include <vector>

#include "core/param.hpp"

namespace eyrie::ubf {

enum class FieldKind : std::uint8_t {
  number,  ///< in SI
  flag,    ///< 0 or 1
  choice,  ///< an index into the names of the choices
};

/// What a state field has to say when there is nothing to say, such as the range of no target.
/// Every comparison with it is false.
inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// A name, what it stands for, and the same for every platform.
struct StateFieldInfo {
  std::string_view name;
  FieldKind kind = FieldKind::number;
  Unit unit;  ///< numbers
  std::string_view help;
  std::span<const std::string_view> choices = {};
  Range limits = {};  ///< of numbers, in SI: a condition may not ask for others
};

/// A readable field of one platform's state. `read` must not allocate, throw or lock.
template <class State>
struct StateField {
  StateFieldInfo info;
  double (*read)(const State&) = nullptr;
};

/// "'heading' is from -180 deg to 180 deg, never 270 deg: that is -90 deg"; empty if it may be `x`.
/// Both are as the file has them.
[[nodiscard]] std::string never(const StateFieldInfo& field, std::string_view name, double x,
                                std::string_view written);

/// The fields of a platform's state; specialize it to have some. Names are words of [a-z0-9_.]
/// that start with a letter, none of them twice.
///   template <> struct StateFields<Robot> {
///     static std::span<const StateField<Robot>> all();
///   };
template <class State>
struct StateFields {
  [[nodiscard]] static std::span<const StateField<State>> all() { return {}; }
};

/// To write them in tables: `number("speed", "m/s", "own", [](const Robot& r) { return r.speed;
/// })`.
template <class State>
struct FieldsOf {
  static constexpr StateField<State> number(std::string_view name, Unit unit, std::string_view help,
                                            double (*read)(const State&)) {
    return {{.name = name, .kind = FieldKind::number, .unit = unit, .help = help}, read};
  }
  /// In (-180°, 180°], or a part of it.
  static constexpr StateField<State> angle(std::string_view name, std::string_view help,
                                           double (*read)(const State&)) {
    StateField<State> field = number(name, "rad", help, read);
    field.info.limits = {-kPi, kPi, true};
    return field;
  }
  static constexpr StateField<State> flag(std::string_view name, std::string_view help,
                                          double (*read)(const State&)) {
    return {{.name = name, .kind = FieldKind::flag, .unit = {}, .help = help}, read};
  }
};

/// Things of which a state has several, where behaviors look at one: a pilot's tracks, of which one
/// is the target.
template <class State>
struct StateList {
  std::string_view name, help;
  std::size_t (*count)(const State&) = nullptr;
  /// Makes number i (from 0) the one that behaviors look at. Must not allocate, throw or lock.
  void (*look_at)(State&, std::size_t i) = nullptr;
};

/// The lists of a platform's state; specialize it to have some.
template <class State>
struct StateLists {
  [[nodiscard]] static std::span<const StateList<State>> all() { return {}; }
};

template <class State>
[[nodiscard]] std::vector<StateFieldInfo> state_field_infos() {
  std::vector<StateFieldInfo> infos;
  for (const StateField<State>& field : StateFields<State>::all())
    infos.push_back(field.info);
  return infos;
}

/// A field under another name for one subtree, so that trees written for one platform serve on
/// another: where the tree says `from`, `to` is read.
struct FieldRename {
  std::string from, to;
  bool used = false;
};

/// What names mean at one place of a file: themselves, or what the references on the way there make
/// of them, outermost first.
class FieldNames {
 public:
  FieldNames() = default;
  /// Of fields that are no state's: what one is called, and how it is said that one is not there.
  FieldNames(std::string one, std::string none) : one_(std::move(one)), none_(std::move(none)) {}
  [[nodiscard]] const std::string& one() const { return one_; }

  /// The index of the field called `name` here, or the number of fields.
  [[nodiscard]] std::size_t find(std::span<const StateFieldInfo> fields, std::string_view name);
  /// What is said of a name that find() does not know.
  [[nodiscard]] std::string unknown(std::span<const StateFieldInfo> fields, std::string_view name);

  void push(std::vector<FieldRename> renames) { renames_.push_back(std::move(renames)); }
  /// Ends a subtree; gives back what it renamed, with what was used.
  [[nodiscard]] std::vector<FieldRename> pop();

 private:
  [[nodiscard]] std::string_view meant(std::string_view name);

  std::string one_ = "a state field", none_ = "there is no state field";
  std::vector<std::vector<FieldRename>> renames_;
};

}  // namespace eyrie::ubf
