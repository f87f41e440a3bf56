// SPDX-License-Identifier: MIT
/// \file  Half of a shared library never reaches the dynamic linker, which it would kill.
#include <gtest/gtest.h>
#include <link.h>

#include "scenario/plugin_file.hpp"
#include "scenario/plugins.hpp"
#include "support/plugin.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {

using scenario::shared_object_problem;

TEST(SharedObject, IsTakenWhole) {
  for (const char* name : {"good", "broken", "taken", "throwing", "unresolved", "old"})
    EXPECT_EQ(shared_object_problem(read_text(plugin(name))), "") << name;
}

TEST(SharedObject, IsAPlugIn) {
  EXPECT_EQ(shared_object_problem(read_text(plugin("foreign"))),
            "it is not a plug-in: there is no EYRIE_PLUGIN in it");
  EXPECT_TRUE(shared_object_problem(read_text(program_path())).ends_with("not a shared library"));
}

TEST(SharedObject, IsRefusedCutAtAnyLength) {
  const std::string whole = read_text(plugin("good"));
  const std::string_view text = whole;
  const auto refused = [&](std::size_t length) {
    const std::string problem = shared_object_problem(text.substr(0, length));
    EXPECT_TRUE(problem.starts_with("it is cut short") || problem == "it is not a shared library")
        << length << ": " << problem;
  };
  for (std::size_t length = 0; length < 4096; ++length)
    refused(length);
  for (std::size_t i = 1; i <= 2000; ++i)
    refused(whole.size() - i);
  for (std::size_t i = 0; i < 1000; ++i)
    refused(i * whole.size() / 1000);
  EXPECT_EQ(shared_object_problem(whole + "x"), "");
}

/// The tables that the linker believes, byte by byte: whatever stands there, nobody reads beyond
/// the file. The sanitizers watch.
TEST(SharedObject, IsReadCarefully) {
  std::string bytes = read_text(plugin("unresolved"));
  std::size_t refused = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (const char value : {'\x00', '\x7f', '\xff'}) {
      const char was = std::exchange(bytes[at], value);
      refused += !shared_object_problem(bytes).empty();
      bytes[at] = was;
    }
  EXPECT_GT(refused, 200u);
}

/// A table of the dynamic segment that lies elsewhere kills the linker as a file that was cut does.
TEST(SharedObject, SaysWhichPartOfItsDynamicSegmentIsDamaged) {
  std::string bytes = read_text(plugin("foreign"));
  ElfW(Ehdr) header;
  std::memcpy(&header, bytes.data(), sizeof header);
  std::size_t tables = 0;
  for (unsigned i = 0; i < header.e_phnum; ++i) {
    ElfW(Phdr) segment;
    std::memcpy(&segment, &bytes[header.e_phoff + i * sizeof segment], sizeof segment);
    if (segment.p_type != PT_DYNAMIC)
      continue;
    for (std::size_t at = 0; at < segment.p_filesz; at += sizeof(ElfW(Dyn))) {
      ElfW(Dyn) entry;
      std::memcpy(&entry, &bytes[segment.p_offset + at], sizeof entry);
      const auto tag = entry.d_tag;
      if (tag != DT_STRTAB && tag != DT_SYMTAB && tag != DT_RELA && tag != DT_INIT_ARRAY)
        continue;
      ++tables;
      std::string other = bytes;
      entry.d_un.d_ptr = std::size_t{1} << 36;
      std::memcpy(&other[segment.p_offset + at], &entry, sizeof entry);
      EXPECT_EQ(shared_object_problem(other),
                "it is damaged: a table of its dynamic segment lies outside");
    }
  }
  EXPECT_EQ(tables, 4u);
}

TEST(SharedObject, IsForThisMachine) {
  std::string bytes = read_text(plugin("foreign"));
  const auto with = [&](std::size_t at, char value) {
    std::string other = bytes;
    other[at] = value;
    return shared_object_problem(other);
  };
  EXPECT_EQ(with(4, 1), "it was built for another kind of machine") << "32 bits";
  EXPECT_EQ(with(18, 8), "it was built for another kind of machine") << "MIPS";
  EXPECT_EQ(with(16, 1), "it is not a shared library") << "an object file";
  EXPECT_EQ(with(16, 2), "it is not a shared library") << "a program";
}

TEST(SharedObject, CutShortDoesNotKillTheProgram) {
  const TempFolder folder;
  const std::string whole = read_text(plugin("good"));
  for (std::size_t part = 1; part < 20; ++part) {
    folder.write("cut.so", whole.substr(0, part * whole.size() / 20));
    const Ran ran = run_program(folder, {"catalog", "--plugin", "cut.so"});
    EXPECT_EQ(ran.code, 2) << part;
    EXPECT_TRUE(ran.err.starts_with("--plugin cut.so: it is cut short: it has ")) << ran.err;
  }
}

}  // namespace
}  // namespace eyrie::test
