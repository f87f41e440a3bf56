// SPDX-License-Identifier: MIT
#include "campaign/ranks.hpp"

#include <gtest/gtest.h>

namespace eyrie::campaign {
namespace {

/// The links of several threads of this process, in the place of processes.
struct Mail {
  std::mutex mutex;
  std::vector<std::deque<Link::Message>> boxes;
};
class InMemory final : public Link {
 public:
  InMemory(Mail& mail, int rank) : mail_(mail), rank_(rank) {}
  ~InMemory() override {
    for (int other = 1; rank_ == 0 && other < size(); ++other)
      send(other, {});
  }
  int rank() const override { return rank_; }
  int size() const override { return static_cast<int>(mail_.boxes.size()); }
  void send(int to, std::string_view bytes) override {
    const std::lock_guard lock(mail_.mutex);
    mail_.boxes[static_cast<std::size_t>(to)].push_back({rank_, std::string(bytes)});
  }
  std::optional<Message> receive() override {
    const std::lock_guard lock(mail_.mutex);
    auto& box = mail_.boxes[static_cast<std::size_t>(rank_)];
    if (box.empty())
      return std::nullopt;
    Message message = std::move(box.front());
    box.pop_front();
    return message;
  }

 private:
  Mail& mail_;
  int rank_;
};

/// What is flown here: everything in it follows from cell and replicate.
Result fly_here(std::uint64_t cell, std::uint64_t replicate) {
  if (replicate % 5 == 1)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));  // others are ahead
  Result result{.cell = cell, .replicate = replicate, .flown = {}};
  result.flown = {.seed = 100 * cell + replicate,
                  .steps = replicate,
                  .hash = replicate * 0x9e3779b97f4a7c15,
                  .outcome = scenario::Outcome::blue_home,
                  .time = 0.1 * static_cast<double>(replicate),
                  .fault = replicate == 3 ? "no fuel" : ""};
  result.values = {std::numeric_limits<double>::quiet_NaN(), 1.0 / 3};
  return result;
}
std::string text(const Result& r) {
  return fmt::format("{} {} {} {} {} {} {} {} {}\n", r.cell, r.replicate, r.flown.seed,
                     r.flown.steps, r.flown.hash, enum_name(r.flown.outcome), r.flown.time,
                     r.flown.fault, r.values.size() == 2 ? r.values[1] : 0);
}

/// Calls `use(crew)` at rank 0; `work` is that of every rank, and each has its origin.
void over_ranks(int ranks, unsigned workers, const Pool::Work& work,
                const std::function<void(Crew&)>& use, std::uint64_t other_origin = 7) {
  Mail mail;
  mail.boxes.resize(static_cast<std::size_t>(ranks));
  std::vector<std::jthread> others;
  for (int rank = 1; rank < ranks; ++rank)
    others.emplace_back([&, rank] {
      InMemory link(mail, rank);
      Pool pool(workers, work);
      serve(link, pool, other_origin);
    });
  InMemory link(mail, 0);
  Pool pool(workers, work);
  Ranks crew(link, pool, 7);
  use(crew);
}

const std::vector<Batch> kBatches{{0, 0, 40}, {2, 10, 25}, {1, 0, 40}};

TEST(Ranks, GiveTheSameInTheSameOrderHoweverManyThereAre) {
  const auto all = [](int ranks, unsigned workers) {
    std::string taken;
    over_ranks(ranks, workers, fly_here, [&](Crew& crew) {
      for (int round = 0; round < 2; ++round)
        crew.fly(kBatches, [&](Result&& result) {
          taken += text(result);
          return true;
        });
    });
    return taken;
  };
  std::string expected;
  for (int round = 0; round < 2; ++round)
    for (const auto& [cell, first, count, step] : kBatches)
      for (std::uint64_t i = 0; i < count; ++i)
        expected += text(fly_here(cell, first + i));
  for (const int ranks : {1, 2, 5})
    for (const unsigned workers : {1u, 3u})
      EXPECT_EQ(all(ranks, workers), expected) << ranks << " ranks, " << workers << " workers";
}

TEST(Ranks, DropWhatWasInTheAirWhenItWasEnough) {
  over_ranks(3, 2, fly_here, [](Crew& crew) {
    int taken = 0;
    crew.fly(kBatches, [&](Result&&) { return ++taken < 5; });
    EXPECT_EQ(taken, 5);
    const Batch other{1, 7, 2};
    std::string words;
    crew.fly({&other, 1}, [&](Result&& result) {
      words += text(result);
      return true;
    });
    EXPECT_EQ(words, text(fly_here(1, 7)) + text(fly_here(1, 8)));
  });
}

TEST(Ranks, LetEveryRankFly) {
  std::mutex mutex;
  std::set<std::thread::id> who;
  const auto work = [&](std::uint64_t cell, std::uint64_t replicate) {
    const std::lock_guard lock(mutex);
    who.insert(std::this_thread::get_id());
    return fly_here(cell, replicate);
  };
  over_ranks(4, 1, work, [&](Crew& crew) {
    while (who.size() < 4)
      crew.fly(kBatches, [](Result&&) { return true; });
  });
  EXPECT_EQ(who.size(), 4U);
}

TEST(Ranks, ThrowWhatAnyOfThemThrowsInItsPlace) {
  const auto work = [](std::uint64_t cell, std::uint64_t replicate) {
    if (cell == 2)
      throw std::runtime_error("no room");
    return fly_here(cell, replicate);
  };
  for (const int ranks : {1, 4}) {
    int taken = 0;
    std::string words;
    over_ranks(ranks, 1, work, [&](Crew& crew) {
      try {
        crew.fly(kBatches, [&](Result&&) { return ++taken > 0; });
      } catch (const std::runtime_error& e) {
        words = e.what();
      }
    });
    EXPECT_EQ(taken, 40);
    EXPECT_NE(words.find("no room"), std::string::npos) << words;
  }
}

TEST(Ranks, RefuseOneThatFliesSomethingElse) {
  over_ranks(
      2, 1, fly_here,
      [](Crew& crew) {
        const auto forever = [&] {
          for (;;)
            crew.fly(kBatches, [](Result&&) { return true; });
        };
        EXPECT_THROW(forever(), std::runtime_error);
      },
      8);
}

}  // namespace
}  // namespace eyrie::campaign
