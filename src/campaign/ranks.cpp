// SPDX-License-Identifier: MIT
#include "campaign/ranks.hpp"

#include <stdexcept>

#include "core/bytes.hpp"

namespace eyrie::campaign {
namespace {

/// Jobs that a rank has for each of its workers, so that none waits for a message.
constexpr std::uint64_t kJobsPerWorker = 2;
/// Results for each worker that may wait for one before them.
constexpr std::uint64_t kAhead = 64;

// Messages: of one program on machines of one kind, so values are as they lie in memory. The first
// byte of one to rank 0 says what it is; one from rank 0 is a job.
enum class Kind : char { hello = 'h', result = 'r', thrown = 't', failed = 'f' };

std::string words_of(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const std::exception& e) {
    return e.what();
  } catch (...) {
    return "something was thrown that is no std::exception";
  }
}

std::string packed(const Done& done) {
  const auto& [job, result, thrown] = done;
  const Flown& flown = result.flown;
  std::string out(1, static_cast<char>(thrown ? Kind::thrown : Kind::result));
  for (const std::uint64_t number :
       {job.round, job.index, job.cell, job.replicate, flown.seed, flown.steps, flown.hash,
        static_cast<std::uint64_t>(flown.outcome)})
    put_number(out, number);
  put_number(out, flown.time);
  const std::string words = thrown ? words_of(thrown) : flown.fault;
  put_number(out, std::uint64_t{words.size()});
  out += words;
  put_number(out, std::uint64_t{result.values.size()});
  for (const double value : result.values)
    put_number(out, value);
  return out;
}

Done unpacked(const Link::Message& message) {
  ByteReader in(std::string_view(message.bytes).substr(1));
  const auto next = [&] { return in.number<std::uint64_t>(); };
  const Job job{next(), next(), next(), next()};
  Flown flown{.seed = next(),
              .steps = next(),
              .hash = next(),
              .outcome = static_cast<scenario::Outcome>(next()),
              .time = in.number<double>(),
              .fault = std::string(in.text())};
  Done done{job, {job.cell, job.replicate, std::move(flown), in.block<double>()}, {}};
  EYRIE_DEMAND(in.ok(), "a message is too short");
  if (message.bytes[0] == static_cast<char>(Kind::thrown))
    done.thrown = std::make_exception_ptr(
        std::runtime_error(fmt::format("rank {}: {}", message.from, done.result.flown.fault)));
  return done;
}

}  // namespace

Pool::Pool(unsigned workers, Work work) : work_(std::move(work)) {
  for (unsigned i = 0; i < workers; ++i)
    threads_.emplace_back([this] { help(); });
}

Pool::~Pool() {
  const std::lock_guard lock(mutex_);
  ending_ = true;
  some_.notify_all();
}

void Pool::put(const Job& job) {
  const std::lock_guard lock(mutex_);
  jobs_.push_back(job);
  some_.notify_one();
}

std::optional<Done> Pool::take() {
  const std::lock_guard lock(mutex_);
  if (done_.empty())
    return std::nullopt;
  Done done = std::move(done_.front());
  done_.pop_front();
  return done;
}

void Pool::help() {
  for (std::unique_lock lock(mutex_);;) {
    some_.wait(lock, [&] { return ending_ || !jobs_.empty(); });
    if (ending_)
      return;
    Done done{.job = jobs_.front(), .result = {}, .thrown = {}};
    jobs_.pop_front();
    lock.unlock();
    try {
      done.result = work_(done.job.cell, done.job.replicate);
    } catch (...) {
      done.thrown = std::current_exception();
    }
    lock.lock();
    done_.push_back(std::move(done));
  }
}

void serve(Link& link, Pool& pool, std::uint64_t origin) {
  std::string hello(1, static_cast<char>(Kind::hello));
  put_number(hello, std::uint64_t{pool.workers()});
  put_number(hello, origin);
  link.send(0, hello);
  for (Nap nap;;) {
    bool something = false;
    while (const auto message = link.receive()) {
      something = true;
      if (message->bytes.empty())
        return;
      Job job;
      EYRIE_DEMAND(message->bytes.size() == sizeof job, "a message is no job");
      std::memcpy(&job, message->bytes.data(), sizeof job);
      pool.put(job);
    }
    while (const auto done = pool.take()) {
      something = true;
      link.send(0, packed(*done));
    }
    nap.after(something);
  }
}

void fail(Link& link, std::string_view words) {
  link.send(0, static_cast<char>(Kind::failed) + std::string(words));
}

Ranks::Ranks(Link& link, Pool& pool, std::uint64_t origin)
    : link_(link), pool_(pool), origin_(origin), ranks_(static_cast<std::size_t>(link.size())) {
  ranks_[0].workers = pool.workers();
}

void Ranks::keep(std::size_t rank, Done&& done) {
  --ranks_[rank].given;
  if (done.job.round == round_)
    waiting_.emplace(done.job.index, std::move(done));
}

void Ranks::listen() {
  while (auto done = pool_.take())
    keep(0, std::move(*done));
  while (const auto message = link_.receive()) {
    const auto from = static_cast<std::size_t>(message->from);
    const std::string_view said = std::string_view(message->bytes).substr(1);
    if (message->bytes[0] == static_cast<char>(Kind::failed))
      throw std::runtime_error(fmt::format("rank {}: {}", from, said));
    if (message->bytes[0] != static_cast<char>(Kind::hello)) {
      keep(from, unpacked(*message));
      continue;
    }
    ByteReader in(said);
    ranks_[from].workers = in.number<std::uint64_t>();
    if (in.number<std::uint64_t>() != origin_)
      throw std::runtime_error(
          fmt::format("rank {} has another program, campaign or scenario than rank 0", from));
  }
}

void Ranks::fly(std::span<const Batch> batches, const Take& take) {
  ++round_;  // what an earlier one left in the air is not taken
  waiting_.clear();
  const Plan plan(batches);
  std::uint64_t begun = 0, taken = 0;
  for (Nap nap; taken < plan.size();) {
    std::uint64_t workers = 0;
    for (const Rank& rank : ranks_)
      workers += rank.workers;
    for (std::size_t r = 0; r < ranks_.size(); ++r)
      while (begun < std::min(plan.size(), taken + kAhead * workers) &&
             ranks_[r].given < kJobsPerWorker * ranks_[r].workers) {
        const auto [cell, replicate] = plan[begun];
        const Job job{round_, begun++, cell, replicate};
        ++ranks_[r].given;
        if (r == 0)
          pool_.put(job);
        else
          link_.send(static_cast<int>(r), {reinterpret_cast<const char*>(&job), sizeof job});
      }
    listen();
    const auto next = waiting_.find(taken);
    nap.after(next != waiting_.end());
    if (next == waiting_.end())
      continue;
    Done done = std::move(next->second);
    waiting_.erase(next);
    ++taken;
    if (done.thrown)
      std::rethrow_exception(done.thrown);
    if (!take(std::move(done.result)))
      return;
  }
}

}  // namespace eyrie::campaign
