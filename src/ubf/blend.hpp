// SPDX-License-Identifier: MIT
#pragma once
/// \file  How several opinions about one field of an action become one: the four kinds of fusion.
#include <algorithm>
#include <concepts>
#include <optional>

#include "core/angle.hpp"
#include "core/math.hpp"

namespace eyrie::ubf::blend {

/// A quantity on a line (altitude, speed): the vote-weighted mean, never outside what was asked.
struct Mean {
  static constexpr bool averages = true;

  template <std::floating_point T>
  class Sum {
   public:
    void add(T value, double vote) {
      const double x = static_cast<double>(value);
      low_ = weight_ > 0 ? std::min(low_, x) : x;
      high_ = weight_ > 0 ? std::max(high_, x) : x;
      sum_ += vote * x;
      weight_ += vote;
    }
    [[nodiscard]] std::optional<T> get() const {
      if (!(weight_ > 0))
        return std::nullopt;
      return static_cast<T>(std::clamp(sum_ / weight_, low_, high_));
    }

   private:
    double sum_ = 0, weight_ = 0, low_ = 0, high_ = 0;
  };
};

/// A direction, rad: the vote-weighted mean on the circle, in [0, 2 pi), that is the direction of
/// the sum of unit vectors (Mardia and Jupp, Directional Statistics, 2000, section 2.2.1). Opposite
/// opinions that cancel have no mean; then the strongest stands, the earlier of equals.
struct Angle {
  static constexpr bool averages = true;

  template <std::floating_point T>
  class Sum {
   public:
    void add(T value, double vote) {
      const double x = static_cast<double>(value);
      if (weight_ == 0)
        first_ = x;
      if (alone_ && x != first_) {
        alone_ = false;
        add_vector(first_, weight_);
      }
      if (!alone_)
        add_vector(x, vote);
      if (vote > strongest_vote_) {
        strongest_ = x;
        strongest_vote_ = vote;
      }
      weight_ += vote;
    }
    [[nodiscard]] std::optional<T> get() const {
      if (!(weight_ > 0))
        return std::nullopt;
      if (alone_)
        return static_cast<T>(first_);
      const bool cancels = east_ * east_ + north_ * north_ <= 1e-18 * weight_ * weight_;
      const T x = static_cast<T>(wrap_tau(cancels ? strongest_ : math::atan2(east_, north_)));
      return static_cast<double>(x) < kTau ? x : T{0};  // a float is rounded up to it
    }

   private:
    void add_vector(double x, double vote) {
      const auto [sin, cos] = math::sin_cos(x);
      east_ += vote * sin;
      north_ += vote * cos;
    }

    bool alone_ = true;  ///< all opinions so far are the first one
    double first_ = 0, strongest_ = 0, strongest_vote_ = 0;
    double east_ = 0, north_ = 0, weight_ = 0;
  };
};

/// An order (release this weapon, shoot at that track): never averaged. The strongest vote carries
/// it, the earlier of equals.
struct Strongest {
  static constexpr bool averages = false;

  template <class T>
  class Sum {
   public:
    void add(const T& value, double vote) {
      if (vote <= vote_)
        return;
      value_ = value;
      vote_ = vote;
    }
    [[nodiscard]] const std::optional<T>& get() const { return value_; }

   private:
    std::optional<T> value_;
    double vote_ = 0;
  };
};

/// A choice that makes sense only if nobody objects (an autopilot's mode): kept if all who set it
/// set it alike, dropped otherwise.
struct Agreed {
  static constexpr bool averages = false;

  template <class T>
  class Sum {
   public:
    void add(const T& value, double) {
      disputed_ |= value_ && !(*value_ == value);
      if (!value_)
        value_ = value;
    }
    [[nodiscard]] std::optional<T> get() const { return disputed_ ? std::nullopt : value_; }

   private:
    std::optional<T> value_;
    bool disputed_ = false;
  };
};

}  // namespace eyrie::ubf::blend
