// SPDX-License-Identifier: MIT
/// \file  Instead of libFuzzer, for an ordinary test: shows the entry of a fuzzer nothing, then
/// each of its seeds. Its argument is their folder.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" __attribute__((weak)) int LLVMFuzzerInitialize(int* argc, char*** argv);
/// Called by custom mutators only, and these by nobody here.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t*, std::size_t size, std::size_t) {
  return size;
}

int main(int argc, char** argv) {
  if (argc != 2)
    return 2;
  if (LLVMFuzzerInitialize)
    LLVMFuzzerInitialize(&argc, &argv);
  std::vector<std::filesystem::path> seeds;
  for (const auto& file : std::filesystem::directory_iterator(argv[1]))
    seeds.push_back(file.path());
  std::sort(seeds.begin(), seeds.end());
  static_cast<void>(LLVMFuzzerTestOneInput(nullptr, 0));
  for (const auto& seed : seeds) {
    std::printf("%s\n", seed.c_str());
    static_cast<void>(std::fflush(stdout));
    std::ifstream file(seed, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    static_cast<void>(
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
  }
}
