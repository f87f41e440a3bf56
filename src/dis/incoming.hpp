// SPDX-License-Identifier: MIT
#pragma once
/// \file  Who we are in an exercise, and what comes in from the network: which of it is for us and
/// new, and when it was so.
#include <map>
#include <optional>
#include <string_view>

#include "dis/dead_reckoning.hpp"

namespace eyrie::dis {

/// Who we are in an exercise of several simulations.
struct Station {
  std::uint8_t exercise = 1;
  std::uint16_t site = 1, application = 1;
  Thresholds thresholds;

  /// One of its entities; 0: the application itself.
  [[nodiscard]] EntityId entity(std::uint16_t number) const { return {site, application, number}; }
};

/// "1.1.1": exercise (1 to 255), site and application (1 to 65534). Nothing if it is another text.
[[nodiscard]] std::optional<Station> station_of(std::string_view text);

/// The words behind a number of what is not used: "of another exercise".
[[nodiscard]] std::string_view words_of(Unused why);

/// Many numbers in short.
struct Spread {
  std::uint64_t count = 0;
  double sum = 0, max = 0;
  void add(double x) {
    ++count;
    sum += x;
    max = std::max(max, x);
  }
  [[nodiscard]] double mean() const { return count ? sum / static_cast<double>(count) : 0; }
};

struct HeardCounts {
  std::uint64_t datagrams = 0, states = 0, shots = 0, ends = 0, emissions = 0, management = 0,
                words = 0;
  std::array<std::uint64_t, 11> unused{};  ///< by Unused
  std::uint64_t entities = 0, vanished = 0;
  Spread latency;  ///< s, of those whose clock is that of the world
  Spread error;    ///< m, of dead reckoning, when a new state came

  std::uint64_t& operator[](Unused why) { return unused[static_cast<std::size_t>(why)]; }
  [[nodiscard]] std::uint64_t operator[](Unused why) const {
    return unused[static_cast<std::size_t>(why)];
  }
};

/// A PDU that is for us and new.
struct Received {
  Pdu pdu;
  double valid = 0;  ///< s since 1970, when it was so, by our clock
};

/// s: what comes so much later under a name that was used is another thing, of a program that began
/// anew or has counted around.
inline constexpr double kLongAgo = 10;

/// From datagrams to PDUs. Keeps no more than kMost entities and applications, whatever comes;
/// where they are too many it forgets those that were not heard of for a minute.
class Incoming {
 public:
  static constexpr std::size_t kMost = 4096;

  /// `rate`: seconds of the mission in one of the clock; stamps of it are those of the mission.
  explicit Incoming(const Station& station, double rate = 1) : station_(station), rate_(rate) {}

  /// A datagram that came at `came` (s since 1970).
  void hear(std::span<const std::byte> datagram, double came);
  /// What was heard since the last time, in its order.
  [[nodiscard]] std::vector<Received> take() { return std::exchange(received_, {}); }

  /// Whether there is room for one more by name. Where there is none those go that may, looked for
  /// once a second; `tidied` is when that was (`now` and it in s since 1970).
  template <class All, class MayGo>
  [[nodiscard]] static bool has_room(All& all, double& tidied, double now, MayGo may_go) {
    if (all.size() >= kMost && now - tidied > 1) {
      tidied = now;
      std::erase_if(all, [&](const auto& one) { return may_go(one.second); });
    }
    return all.size() < kMost;
  }

  HeardCounts counts;

 private:
  /// Whose timestamps say which of its states, and of its emissions, is the newest.
  struct Stamps {
    std::map<std::uint8_t, std::uint32_t> last;  ///< by type of PDU
    double heard = 0;                            ///< s since 1970
  };
  struct Application {
    double nearest = 0;  ///< s of its clock, the least that its stamps are behind ours
    bool known = false;
    double heard = 0;  ///< s since 1970
    /// When it came (s since 1970), by type and number of what is told once.
    std::map<std::pair<std::uint8_t, std::uint32_t>, double> told;
    std::vector<std::pair<std::uint8_t, std::uint32_t>> order;  ///< of these
    std::size_t next = 0;
  };

  [[nodiscard]] std::optional<Unused> check(const Packet& packet, double came);
  [[nodiscard]] std::optional<Unused> newest(const EntityId& who, std::uint8_t type,
                                             std::uint32_t stamp, double came);
  [[nodiscard]] static std::optional<Unused> once(Application& application, std::uint8_t type,
                                                  std::uint32_t number, double came);
  [[nodiscard]] double valid_at(Application& application, std::uint32_t stamp, double came);

  Station station_;
  double rate_;
  std::map<EntityId, Stamps> entities_;
  std::map<std::pair<std::uint16_t, std::uint16_t>, Application> applications_;
  std::vector<Received> received_;
  double entities_tidied_ = 0, applications_tidied_ = 0;
};

}  // namespace eyrie::dis
