// SPDX-License-Identifier: MIT
#pragma once
/// \file  An action described once: arbiters, traces, hashing and text all read this table.
#include <fmt/format.h>

#include <cstring>
#include <memory>
#include <utility>

#include "core/enum_names.hpp"
#include "core/lines.hpp"
#include "core/units.hpp"
#include "ubf/blend.hpp"
#include "ubf/memory.hpp"

namespace eyrie::ubf {

/// What a number may be at all. Beyond it, for NaN, and for an enumerator that there is not,
/// whoever recommends it has made a mistake.
struct Plausible {
  double least = std::numeric_limits<double>::lowest(), most = std::numeric_limits<double>::max();
  [[nodiscard]] constexpr bool holds(double value) const { return value >= least && value <= most; }
};

/// One field of an action: what it is called, where it is, its SI unit, and how opinions about it
/// are blended.
template <class Action, class T, class Blend>
struct ActionField {
  using Value = T;
  using BlendTag = Blend;
  using Sum = typename Blend::template Sum<T>;
  static constexpr bool averages = Blend::averages;  ///< a mean is taken; otherwise it is an order
  static constexpr bool is_number = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
  static constexpr bool is_real = std::is_floating_point_v<T>;
  static constexpr bool is_direction = std::is_same_v<Blend, blend::Angle>;

  std::string_view name;
  std::optional<T> Action::*member;
  Unit unit;
  Plausible plausible{};

  /// A direction in [0, 2 pi) as the field has it, which may count from -pi.
  [[nodiscard]] constexpr T as_counted(T direction) const {
    const double x = static_cast<double>(direction);
    return x > plausible.most && plausible.holds(x - kTau) ? static_cast<T>(x - kTau) : direction;
  }
  /// Whether what stands there means something. Of a value that is no number itself its own
  /// `implausible_part(value)` says that, if there is such a function.
  [[nodiscard]] constexpr bool is_plausible(const T& value) const {
    if constexpr (is_real)
      return plausible.holds(static_cast<double>(value));
    else if constexpr (requires { implausible_part(value); })
      return !implausible_part(value);
    else if constexpr (NamedEnum<T>)
      return !enum_name(value).empty();
    else
      return true;
  }
};

/// `field<blend::Angle>("heading", &Action::heading, "rad")`
template <class Blend, class Action, class T>
[[nodiscard]] consteval ActionField<Action, T, Blend> field(std::string_view name,
                                                            std::optional<T> Action::*member,
                                                            Unit unit = {},
                                                            Plausible plausible = {}) {
  return {name, member, unit, plausible};
}

/// Specialise once per action type, which is a struct of optionals, with every field once:
///   template <> struct ActionTraits<Action> {
///     static constexpr auto fields = Lines{field<blend::Angle>("heading", ...), ...};
///   };
template <class Action>
struct ActionTraits;

template <class Action>
inline constexpr auto kFieldLines = lines_of(ActionTraits<Action>::fields);
template <class Action>
inline constexpr std::size_t kFields = decltype(lines_of(ActionTraits<Action>::fields))::size();

/// Calls `fn(field, i)` for each field in order; `i` is a std::integral_constant.
template <class Action, class Fn>
constexpr void for_each_field(Fn&& fn) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (fn(line<I>(kFieldLines<Action>), std::integral_constant<std::size_t, I>{}), ...);
  }
  (std::make_index_sequence<kFields<Action>>{});
}

/// Whether the table lists the whole struct: each field once, and no member beside them. Members
/// are counted by initialising an action with a value for every field listed and one more.
template <class Action>
[[nodiscard]] consteval bool fields_cover_action() {
  return with_lines(kFieldLines<Action>, []<class... F>(const F&... f) {
    const auto times_listed = [&](const auto& wanted) {
      const auto is_it = [&]<class G>(const G& other) {
        if constexpr (std::is_same_v<decltype(wanted.member), decltype(other.member)>)
          return wanted.member == other.member;
        else
          return false;
      };
      return (std::size_t{0} + ... + (is_it(f) ? 1 : 0));
    };
    constexpr bool kEnough = requires {
      Action{std::optional<typename F::Value>{}...};
    };
    constexpr bool kMore = requires {
      Action{std::optional<typename F::Value>{}..., {}};
    };
    return kEnough && !kMore && (true && ... && (times_listed(f) == 1));
  });
}

/// Empties every field. Writes the flags alone, which is cheaper than assigning a fresh Action.
template <class Action>
constexpr void clear(Action& action) noexcept {
  for_each_field<Action>([&](const auto& f, auto) { std::construct_at(&(action.*f.member)); });
}

/// Copies an action field by field. Assigning the whole struct reads in blocks of 16 bytes what was
/// just written in pieces, and waits until those have reached the cache: measured at 30 ns of a
/// 46 ns tick of 13 nodes.
template <class Action>
constexpr void copy(const Action& from, Action& to) noexcept {
  for_each_field<Action>([&](const auto& f, auto) {
    const auto& value = from.*f.member;
    if (value)
      std::construct_at(&(to.*f.member), *value);
    else
      std::construct_at(&(to.*f.member));
  });
}

/// A field of an action at run time.
struct ActionFieldInfo {
  std::string_view name;
  Unit unit;
  bool is_number, is_real, is_direction, is_mean;
  bool is_words;  ///< neither a number, a flag nor an id
  /// A number as it is; of anything else 1, but 0 for a flag that says no. Nothing if it is not
  /// set.
  std::optional<double> (*get)(const void* action);
  /// Sets or empties a real number.
  void (*set)(void* action, std::optional<double>);
};

namespace detail {
template <class Action, std::size_t I>
constexpr auto& member_of(Action& action) {
  return action.*line<I>(kFieldLines<std::remove_const_t<Action>>).member;
}
template <class Action, std::size_t I>
constexpr ActionFieldInfo action_field() {
  constexpr auto kField = line<I>(kFieldLines<Action>);
  using Field = std::remove_cvref_t<decltype(kField)>;
  using T = typename Field::Value;
  return {.name = kField.name,
          .unit = kField.unit,
          .is_number = Field::is_number,
          .is_real = Field::is_real,
          .is_direction = Field::is_direction,
          .is_mean = std::is_same_v<typename Field::BlendTag, blend::Mean>,
          .is_words = NamedEnum<T> || requires(const T& value){to_text(value);
}
,
    .get = [](const void* action) -> std::optional<double> {
      const auto& value = member_of<const Action, I>(*static_cast<const Action*>(action));
      if (!value)
        return std::nullopt;
      if constexpr (std::is_arithmetic_v<T>)
        return static_cast<double>(*value);
      else
        return 1;
    },
    .set = [](void* action, std::optional<double> value) {
      if constexpr (Field::is_real) {
        auto& member = member_of<Action, I>(*static_cast<Action*>(action));
        member = value ? std::optional(static_cast<T>(*value)) : std::nullopt;
        if constexpr (Field::is_direction)
          if (member)
            member = line<I>(kFieldLines<Action>).as_counted(*member);
      }
    }
};  // namespace detail
}  // namespace eyrie::ubf
template <class Action>
inline constexpr auto kActionFields = []<std::size_t... I>(std::index_sequence<I...>) {
  return std::array<ActionFieldInfo, sizeof...(I)>{action_field<Action, I>()...};
}
(std::make_index_sequence<kFields<Action>>{});
}  // namespace detail

/// The fields of an action, in order.
template <class Action>
[[nodiscard]] constexpr std::span<const ActionFieldInfo> action_fields() {
  return detail::kActionFields<Action>;
}

/// A part of a value that is not plausible.
struct ImplausiblePart {
  std::string_view name;
  double value = 0;
};
/// The first field that is set to what means nothing, kFields if there is none.
template <class Action>
[[nodiscard]] constexpr std::size_t implausible_field(const Action& action) {
  std::size_t first = kFields<Action>;
  for_each_field<Action>([&](const auto& f, auto i) {
    const auto& value = action.*f.member;
    if (value && !f.is_plausible(*value) && first == kFields<Action>) [[unlikely]]
      first = i;
  });
  return first;
}
/// "heading is nan rad", "follow.position is inf", "mode is 99, which has no name"
template <class Action>
[[nodiscard]] std::string implausible_text(const Action& action, std::size_t field) {
  std::string text;
  for_each_field<Action>([&](const auto& f, auto i) {
    using Field = std::remove_cvref_t<decltype(f)>;
    if (i != field || !(action.*f.member))
      return;
    if constexpr (Field::is_real)
      text = fmt::format("{} is {}{}{}", f.name, *(action.*f.member),
                         f.unit.si_symbol.empty() ? "" : " ", f.unit.si_symbol);
    else if constexpr (NamedEnum<typename Field::Value>)
      text =
          fmt::format("{} is {}, which has no name", f.name, fmt::underlying(*(action.*f.member)));
    else if constexpr (requires { implausible_part(*(action.*f.member)); })
      if (const auto part = implausible_part(*(action.*f.member)))
        text = fmt::format("{}.{} is {}", f.name, part->name, part->value);
  });
  return text;
}

/// "heading is no plausible number", "mode is none of its names", in words that stay.
template <class Action>
[[nodiscard]] const char* implausible_reason(std::size_t field) {
  static const auto kReasons = [] {
    std::array<std::string, kFields<Action>> reasons;
    for_each_field<Action>([&](const auto& f, auto i) {
      using Field = std::remove_cvref_t<decltype(f)>;
      reasons[i] = fmt::format(
          "{} is {}", f.name,
          NamedEnum<typename Field::Value> ? "none of its names" : "no plausible number");
    });
    return reasons;
  }();
  return kReasons[field].c_str();
}

/// No field is set: no opinion.
template <class Action>
[[nodiscard]] constexpr bool is_empty(const Action& action) noexcept {
  bool any = false;
  for_each_field<Action>([&](const auto& f, auto) { any |= (action.*f.member).has_value(); });
  return !any;
}

template <class Action>
[[nodiscard]] constexpr bool equal(const Action& a, const Action& b) {
  bool same = true;
  for_each_field<Action>([&](const auto& f, auto) { same &= a.*f.member == b.*f.member; });
  return same;
}

/// An action as bytes without padding, zero when empty: for the slab, for files and for hashing.
template <class Action>
class PackedAction {
 public:
  PackedAction() = default;
  explicit PackedAction(const Action& action) { assign(action); }

  void assign(const Action& action) {
    *this = {};
    std::size_t at = 0;
    for_each_field<Action>([&](const auto& f, auto i) {
      const auto& value = action.*f.member;
      if (value) {
        set_ |= std::uint64_t{1} << i;
        std::memcpy(&values_[at], &*value, sizeof(*value));
      }
      at += sizeof(*value);
    });
  }
  void unpack(Action& action) const {
    clear(action);
    std::size_t at = 0;
    for_each_field<Action>([&](const auto& f, auto i) {
      using T = typename std::remove_cvref_t<decltype(f)>::Value;
      if (set_ >> i & 1) {
        T value;
        std::memcpy(&value, &values_[at], sizeof(T));
        action.*f.member = value;
      }
      at += sizeof(T);
    });
  }

 private:
  static consteval std::size_t value_bytes() {
    std::size_t bytes = 0;
    for_each_field<Action>([&](const auto& f, auto) {
      using T = typename std::remove_cvref_t<decltype(f)>::Value;
      static_assert(NoPadding<T>, "a field of an action must have no padding bytes");
      bytes += sizeof(T);
    });
    return slab_bytes(bytes);
  }
  static_assert(kFields<Action> <= 64);

  std::uint64_t set_ = 0;  ///< bit i: field i has a value
  std::array<std::byte, value_bytes()> values_{};
};

}  // namespace eyrie::ubf
