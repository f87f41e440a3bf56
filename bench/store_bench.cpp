// SPDX-License-Identifier: MIT
/// \file  What it costs to keep a replicate, of some 200 ms of flying: commits once a second or
/// after a thousand included.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>

#include "campaign/store.hpp"

namespace {

using namespace eyrie::campaign;

void keep_a_replicate(benchmark::State& state) {
  const Spec spec = parse_spec(R"(eyrie: 1
name: bench
scenario: none
measures:
  end: {what: end_time}
  blue: {what: losses, who: blue}
  red: {what: losses, who: red}
  shots: {what: shots}
  exchange: {what: exchange_ratio, who: blue}
)",
                               "bench.yaml");
  const std::vector<Cell> cells = cells_of(spec);
  std::string folder = (std::filesystem::temp_directory_path() / "eyrie-bench-XXXXXX").string();
  if (!::mkdtemp(folder.data()))
    return state.SkipWithError("no temporary folder");
  Result result{.values = {1500.0, 1.0, 2.0, 9.0, 2.0, 1.0}};
  {
    Store store(folder + "/out", spec, cells, {}, false);
    for (auto _ : state) {
      store.put(result);
      ++result.replicate;
    }
    store.flush();
  }
  std::filesystem::remove_all(folder);
}
BENCHMARK(keep_a_replicate)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
