// SPDX-License-Identifier: MIT
#include "scenario/plugin_file.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

namespace eyrie::scenario {
namespace {

using ElfHeader = ElfW(Ehdr);
using ElfSegment = ElfW(Phdr);
using ElfSection = ElfW(Shdr);
using ElfDynamic = ElfW(Dyn);

#if defined(__x86_64__)
constexpr unsigned kMachine = EM_X86_64;
#elif defined(__aarch64__)
constexpr unsigned kMachine = EM_AARCH64;
#else
constexpr unsigned kMachine = EM_NONE;  // whatever it is, the dynamic linker looks at it first
#endif

/// What a shared library needs in memory is bounded, so that sums of it do not overflow.
constexpr std::uint64_t kLargestAddress = std::uint64_t{1} << 40;

/// A table that the dynamic linker reads: the tag of its address and of its size.
struct ElfTable {
  std::int64_t address, size;
};
constexpr std::array kTables{ElfTable{DT_STRTAB, DT_STRSZ},
                             ElfTable{DT_RELA, DT_RELASZ},
                             ElfTable{DT_REL, DT_RELSZ},
                             ElfTable{DT_JMPREL, DT_PLTRELSZ},
                             ElfTable{DT_INIT_ARRAY, DT_INIT_ARRAYSZ},
                             ElfTable{DT_FINI_ARRAY, DT_FINI_ARRAYSZ}};
/// Tables without a size: their first bytes are there.
constexpr std::array<std::int64_t, 6> kUnsized{DT_SYMTAB, DT_HASH,    DT_GNU_HASH,
                                               DT_VERSYM, DT_VERNEED, DT_VERDEF};
/// Places in the table of texts.
constexpr std::array<std::int64_t, 4> kTexts{DT_NEEDED, DT_SONAME, DT_RPATH, DT_RUNPATH};
/// Among the names of its symbols is that of what EYRIE_PLUGIN exports, with its end.
constexpr std::string_view kExported("eyrie_plugin", sizeof "eyrie_plugin");

/// Ends the check.
struct Refused {
  std::string why;
};
[[noreturn]] void refuse(std::string why) {
  throw Refused{std::move(why)};
}
[[noreturn]] void damaged(const char* what) {
  refuse(fmt::format("it is damaged: {}", what));
}

class ElfChecker {
 public:
  explicit ElfChecker(std::string_view file) : file_(file) {}

  void check() {
    header();
    segments();
    sections();
    dynamic();
    texts();
  }

 private:
  template <class T>
  [[nodiscard]] T read(std::uint64_t at) const {
    T value;
    std::memcpy(&value, file_.data() + at, sizeof value);
    return value;
  }
  /// Refuses a file that [offset, offset + size) is not in: it was cut.
  void demand(std::uint64_t offset, std::uint64_t size) const {
    if (offset <= file_.size() && size <= file_.size() - offset)
      return;
    if (offset > kLargestAddress || size > kLargestAddress)
      damaged("it says that it is larger than any library");
    refuse(fmt::format("it is cut short: it has {} bytes of at least {}", file_.size(),
                       offset + size));
  }
  /// The place in the file of what will stand at an address; nothing if it is not in a segment.
  [[nodiscard]] std::optional<std::uint64_t> place(std::uint64_t address,
                                                   std::uint64_t size) const {
    for (const ElfSegment& s : loaded_)
      if (address >= s.p_vaddr && address - s.p_vaddr <= s.p_filesz &&
          size <= s.p_filesz - (address - s.p_vaddr))
        return s.p_offset + (address - s.p_vaddr);
    return std::nullopt;
  }

  void header() {
    if (!file_.starts_with(std::string_view(ELFMAG, SELFMAG)))
      refuse("it is not a shared library");
    demand(0, sizeof(ElfHeader));
    header_ = read<ElfHeader>(0);
    const bool ours = header_.e_ident[EI_CLASS] == (sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32) &&
                      header_.e_ident[EI_DATA] ==
                          (std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB);
    if (!ours || (kMachine != EM_NONE && header_.e_machine != kMachine))
      refuse("it was built for another kind of machine");
    if (header_.e_ident[EI_VERSION] != EV_CURRENT || header_.e_version != EV_CURRENT)
      damaged("no such version of its format exists");
    if (header_.e_type != ET_DYN)
      refuse("it is not a shared library");
  }

  void segments() {
    if (header_.e_phentsize != sizeof(ElfSegment) || header_.e_phnum == 0 ||
        header_.e_phnum == PN_XNUM)
      damaged("its list of segments makes no sense");
    demand(header_.e_phoff, std::uint64_t{header_.e_phnum} * sizeof(ElfSegment));
    std::uint64_t end = 0;
    for (unsigned i = 0; i < header_.e_phnum; ++i) {
      const auto s = read<ElfSegment>(header_.e_phoff + i * sizeof(ElfSegment));
      if (s.p_type == PT_NULL)
        continue;
      demand(s.p_offset, s.p_filesz);
      if (s.p_vaddr > kLargestAddress || s.p_memsz > kLargestAddress)
        damaged("a segment is larger than any library");
      if (s.p_type == PT_DYNAMIC)
        dynamic_ = s;
      if (s.p_type != PT_LOAD)
        continue;
      if (s.p_filesz > s.p_memsz || (s.p_align & (s.p_align - 1)) != 0 ||
          (s.p_align > 1 && (s.p_vaddr - s.p_offset) % s.p_align != 0))
        damaged("a segment does not fit into memory");
      if (s.p_vaddr < end)
        damaged("its segments overlap");
      end = s.p_vaddr + s.p_memsz;
      loaded_.push_back(s);
    }
    if (loaded_.empty() || !dynamic_)
      refuse("it is not a shared library");
  }

  void sections() const {
    if (header_.e_shoff == 0)
      return;
    if (header_.e_shentsize != sizeof(ElfSection))
      damaged("its list of sections makes no sense");
    demand(header_.e_shoff, sizeof(ElfSection));
    // more of them than fit into the header are counted in the first
    const std::uint64_t count =
        header_.e_shnum ? header_.e_shnum : read<ElfSection>(header_.e_shoff).sh_size;
    if (count > file_.size())
      damaged("its list of sections makes no sense");
    demand(header_.e_shoff, count * sizeof(ElfSection));
    for (std::uint64_t i = 1; i < count; ++i) {
      const auto s = read<ElfSection>(header_.e_shoff + i * sizeof(ElfSection));
      if (s.sh_type != SHT_NOBITS && s.sh_type != SHT_NULL)
        demand(s.sh_offset, s.sh_size);
    }
  }

  /// What the dynamic segment says of a tag, if it says anything.
  [[nodiscard]] std::optional<std::uint64_t> said(std::int64_t tag) const {
    for (const ElfDynamic& d : entries_)
      if (d.d_tag == tag)
        return d.d_un.d_val;
    return std::nullopt;
  }

  void dynamic() {
    const auto at = place(dynamic_->p_vaddr, dynamic_->p_filesz);
    if (!at || *at != dynamic_->p_offset)
      damaged("its dynamic segment is not part of what is loaded");
    bool ended = false;
    for (std::uint64_t i = 0; !ended && (i + 1) * sizeof(ElfDynamic) <= dynamic_->p_filesz; ++i) {
      entries_.push_back(read<ElfDynamic>(*at + i * sizeof(ElfDynamic)));
      ended = entries_.back().d_tag == DT_NULL;
    }
    if (!ended)
      damaged("its dynamic segment has no end");
    if (said(DT_FLAGS_1).value_or(0) & DF_1_PIE)
      refuse("it is a program, not a shared library");
    for (const ElfTable& table : kTables)
      if (const auto address = said(table.address))
        if (!place(*address, said(table.size).value_or(0)))
          damaged("a table of its dynamic segment lies outside");
    for (const std::int64_t tag : kUnsized)
      if (const auto address = said(tag); address && !place(*address, 1))
        damaged("a table of its dynamic segment lies outside");
  }

  void texts() const {
    const std::uint64_t size = said(DT_STRSZ).value_or(0);
    const auto begin = said(DT_STRTAB);
    const auto at = begin ? place(*begin, size) : std::nullopt;
    if (!at || size == 0 || !said(DT_SYMTAB))
      damaged("it has no names");
    if (file_[*at + size - 1] != '\0')
      damaged("its names have no end");
    for (const ElfDynamic& d : entries_)
      if (std::ranges::find(kTexts, d.d_tag) != kTexts.end() && d.d_un.d_val >= size)
        damaged("one of its names lies outside");
    if (file_.substr(*at, size).find(kExported) == file_.npos)
      refuse("it is not a plug-in: there is no EYRIE_PLUGIN in it");
  }

  std::string_view file_;
  ElfHeader header_{};
  std::vector<ElfSegment> loaded_;
  std::optional<ElfSegment> dynamic_;
  std::vector<ElfDynamic> entries_;
};

}  // namespace

std::string shared_object_problem(std::string_view file) {
  try {
    ElfChecker(file).check();
  } catch (const Refused& refused) {
    return refused.why;
  }
  return {};
}

}  // namespace eyrie::scenario
