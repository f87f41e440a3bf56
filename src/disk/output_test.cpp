// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>

#include "disk/file_system.hpp"
#include "disk/output.hpp"
#include "disk/temporary.hpp"
#include "support/instead.hpp"
#include "support/program.hpp"

namespace eyrie::disk {
namespace {

using List = std::vector<std::string>;
namespace fs = std::filesystem;

constexpr std::array kNames{"sign", "more"};

FolderWish wish(const test::TempFolder& folder, const std::string& name, bool replace = false) {
  return {.path = folder / name, .names = kNames, .sign = "sign", .replace = replace};
}

void write(const OutputFolder& out, const char* name, const std::string& text) {
  Sink sink = out.file(name);
  sink.write(text);
  EXPECT_TRUE(sink.close()) << sink.error();
}

/// Makes one, and gives what commit() said.
std::string make(const FolderWish& asked, const std::string& text) {
  OutputFolder out(asked);
  write(out, "sign", text);
  return out.commit();
}

std::string refusal(const FolderWish& asked) {
  try {
    OutputFolder out(asked);
    return "";
  } catch (const Refused& e) {
    return e.what();
  }
}

/// Somebody looks for abandoned folders at the worst moments.
class Tidied final : public FileSystem {
 public:
  explicit Tidied(bool before_open) : before_open_(before_open) {}
  int make_folder(int folder, const char* name, mode_t mode) override {
    const int made = FileSystem::make_folder(folder, name, mode);
    if (before_open_ && is_temporary(name) && left_-- > 0)
      FileSystem::remove(folder, name, AT_REMOVEDIR);
    return made;
  }
  int open(int folder, const char* name, int flags, mode_t mode) override {
    const int file = FileSystem::open(folder, name, flags, mode);
    if (!before_open_ && is_temporary(name) && left_-- > 0)
      FileSystem::remove(folder, name, AT_REMOVEDIR);
    return file;
  }

 private:
  bool before_open_;
  int left_ = 3;
};

TEST(OutputFolder, IsMadeThoughItsPartIsTakenForAbandoned) {
  for (const bool before_open : {true, false}) {
    const test::TempFolder folder;
    Tidied tidied(before_open);
    const Instead instead(tidied);
    EXPECT_EQ(make(wish(folder, "run"), "x"), "");
    EXPECT_EQ(test::read_text(folder / "run/sign"), "x");
  }
}

TEST(OutputFolder, IsRefusedWhereNobodyMayWrite) {
  struct Forbidden final : FileSystem {
    int make_folder(int, const char*, mode_t) override {
      errno = error;
      return -1;
    }
    int error = 0;
  } forbidden;
  const test::TempFolder folder;
  const Instead instead(forbidden);
  for (const int error : {EACCES, EPERM, EROFS}) {
    forbidden.error = error;
    EXPECT_EQ(refusal(wish(folder, "run")),
              "cannot make '" + (folder / "run") + "': " + words_of(error));
  }
}

TEST(OutputFolder, IsNotThereUntilItIsComplete) {
  const test::TempFolder folder;
  {
    OutputFolder out(wish(folder, "deep/er/run"));
    write(out, "sign", "x");
    EXPECT_FALSE(fs::exists(folder / "deep/er/run"));
  }
  EXPECT_EQ(folder.everything(), List{}) << "nothing is left of one that was given up";
  OutputFolder out(wish(folder, "deep/er/run"));
  write(out, "sign", "x");
  write(out, "more", "y");
  out.drop("more");
  EXPECT_EQ(out.commit(), "");
  EXPECT_EQ(out.path(), folder / "deep/er/run");
  EXPECT_EQ(folder.everything(), (List{"deep", "deep/er", "deep/er/run", "deep/er/run/sign"}));
  struct stat made {};
  ASSERT_EQ(::stat((folder / "deep/er/run").c_str(), &made), 0);
  EXPECT_EQ(made.st_mode & 0777U, default_mode(0777));
}

TEST(OutputFolder, ReplacesAnOldOneAndKeepsWhoMayReadIt) {
  const test::TempFolder folder;
  EXPECT_EQ(make(wish(folder, "run"), "old"), "");
  folder.write("run/more", "old");
  ::chmod((folder / "run").c_str(), 0710);
  EXPECT_EQ(refusal(wish(folder, "run")),
            "'" + (folder / "run") + "' exists already; name another folder or add --force");
  EXPECT_EQ(make(wish(folder, "run/", true), "new"), "");
  EXPECT_EQ(test::read_text(folder / "run/sign"), "new");
  EXPECT_EQ(folder.everything(), (List{"run", "run/sign"}));
  struct stat made {};
  ASSERT_EQ(::stat((folder / "run").c_str(), &made), 0);
  EXPECT_EQ(made.st_mode & 0777U, 0710U);
  ::chmod((folder / "run").c_str(), 0510);
  EXPECT_EQ(refusal(wish(folder, "run", true)),
            "'" + (folder / "run") + "' is read-only, and not replaced; name another folder");
}

TEST(OutputFolder, TakesAnEmptyFolder) {
  const test::TempFolder folder;
  fs::create_directory(folder / "run");
  ::chmod((folder / "run").c_str(), 0555);
  EXPECT_EQ(make(wish(folder, "run"), "new"), "");
  EXPECT_EQ(folder.everything(), (List{"run", "run/sign"}));
  struct stat made {};
  ASSERT_EQ(::stat((folder / "run").c_str(), &made), 0);
  EXPECT_EQ(made.st_mode & 0777U, 0755U) << "whoever makes it writes into it";
}

/// Whatever is no folder of ours stays as it is, and is named.
TEST(OutputFolder, ReplacesNothingThatIsNotItsOwn) {
  const test::TempFolder folder;
  folder.write("file", "kept");
  folder.write("work/important", "kept");
  folder.write("mixed/sign", "kept");
  folder.write("mixed/thesis.tex", "kept");
  folder.write("nested/sign", "kept");
  folder.write("nested/more/deep", "kept");
  folder.write("run/sign", "kept");
  fs::create_directory_symlink("run", folder / "link");
  fs::create_symlink("elsewhere", folder / "dangling");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const List before = folder.everything();
  for (const auto& [name, words] :
       {std::pair("file", "is a file"), std::pair("work", "has no sign"),
        std::pair("mixed", "has 'thesis.tex', which Eyrie has not written"),
        std::pair("nested", "has 'more', which"), std::pair("link", "is a symbolic link"),
        std::pair("dangling", "is a symbolic link"), std::pair("pipe", "is a pipe"),
        std::pair(".", "is no place to write to"), std::pair("run/..", "is no place to write to"),
        std::pair("file/below", "Not a directory"), std::pair("link/", "is a symbolic link")})
    EXPECT_NE(refusal(wish(folder, name, true)).find(words), std::string::npos)
        << name << ": " << refusal(wish(folder, name, true));
  for (const char* path : {"/", ".", "..", "./.", "", "-"})
    EXPECT_NE(refusal({.path = path, .names = kNames, .sign = "sign", .replace = true})
                  .find("is no place to write to"),
              std::string::npos)
        << path;
  EXPECT_NE(refusal({.path = "/proc", .names = kNames, .sign = "sign", .replace = true}), "");
  EXPECT_EQ(folder.everything(), before);
  EXPECT_EQ(test::read_text(folder / "mixed/thesis.tex"), "kept");
}

TEST(OutputFolder, DoesNotReplaceTheGroundUnderOnesFeet) {
  const test::TempFolder folder;
  folder.write("run/sign", "kept");
  fs::create_directory(folder / "run/more");
  const fs::path here = fs::current_path();
  for (const char* inside : {"run", "run/more"}) {
    fs::current_path(folder / inside);
    EXPECT_NE(refusal(wish(folder, "run", true)).find("is where you are"), std::string::npos);
    fs::current_path(here);
  }
}

TEST(OutputFolder, GivesWayToWhoeverWasFaster) {
  const test::TempFolder folder;
  OutputFolder one(wish(folder, "run")), two(wish(folder, "run")), three(wish(folder, "run"));
  for (const OutputFolder* out : {&one, &two, &three})
    write(*out, "sign", out->path());
  EXPECT_EQ(two.commit(), "");
  EXPECT_EQ(one.commit(), "'" + (folder / "run") +
                              "' has been taken or changed in the meantime; the new one is '" +
                              (folder / "run.2") + "'");
  EXPECT_NE(three.commit(), "");
  EXPECT_EQ(three.path(), folder / "run.3");
  EXPECT_EQ(folder.everything(),
            (List{"run", "run.2", "run.2/sign", "run.3", "run.3/sign", "run/sign"}));
}

TEST(OutputFolder, GivesEachWhoAsksForANumberItsOwn) {
  const test::TempFolder folder;
  FolderWish numbered = wish(folder, "run");
  numbered.numbered = true;
  OutputFolder one(numbered), two(numbered);
  EXPECT_EQ(two.commit(), "");
  EXPECT_EQ(one.commit(), "");
  EXPECT_EQ(two.path(), folder / "run");
  EXPECT_EQ(one.path(), folder / "run.2");
}

/// What happened to the old one while the new one was made is not lost.
TEST(OutputFolder, KeepsAnOldOneThatChangedInTheMeantime) {
  const test::TempFolder folder;
  folder.write("a/sign", "old");
  folder.write("b/sign", "old");
  folder.write("c/sign", "old");
  fs::create_directory(folder / "d");
  {
    OutputFolder more(wish(folder, "a", true)), other(wish(folder, "b", true)),
        gone(wish(folder, "c", true)), full(wish(folder, "d"));
    folder.write("a/thesis.tex", "kept");
    fs::rename(folder / "b", folder / "b-kept");
    folder.write("b/sign", "of another");
    fs::remove_all(folder / "c");
    folder.write("d/thesis.tex", "kept");
    EXPECT_NE(more.commit(), "");
    EXPECT_NE(other.commit(), "");
    EXPECT_EQ(gone.commit(), "");
    EXPECT_NE(full.commit(), "");
  }
  EXPECT_EQ(folder.everything(),
            (List{"a", "a.2", "a/sign", "a/thesis.tex", "b", "b-kept", "b-kept/sign", "b.2",
                  "b/sign", "c", "d", "d.2", "d/thesis.tex"}));
  EXPECT_EQ(test::read_text(folder / "b/sign"), "of another");
}

TEST(OutputFolder, IsReplacedByOneAtATime) {
  const test::TempFolder folder;
  folder.write("run/sign", "old");
  OutputFolder one(wish(folder, "run", true)), two(wish(folder, "run", true));
  write(one, "sign", "one");
  write(two, "sign", "two");
  EXPECT_EQ(one.commit(), "");
  EXPECT_NE(two.commit(), "");
  EXPECT_EQ(test::read_text(folder / "run/sign") + test::read_text(folder / "run.2/sign"),
            "onetwo");
}

/// A file system that knows neither a swap nor a move that replaces nothing.
struct Plain final : FileSystem {
  int rename(int from_folder, const char* from, int to_folder, const char* to,
             unsigned flags) override {
    if (flags) {
      errno = EINVAL;
      return -1;
    }
    return FileSystem::rename(from_folder, from, to_folder, to, 0);
  }
};

TEST(OutputFolder, ReplacesWhereNoSwapIsKnown) {
  const test::TempFolder folder;
  Plain plain;
  const Instead instead(plain);
  EXPECT_EQ(make(wish(folder, "run"), "old"), "");
  EXPECT_EQ(make(wish(folder, "run", true), "new"), "");
  EXPECT_EQ(test::read_text(folder / "run/sign"), "new");
  OutputFolder late(wish(folder, "next"));
  folder.write("next/sign", "of another");
  EXPECT_NE(late.commit(), "");
  EXPECT_EQ(folder.everything(), (List{"next", "next.2", "next/sign", "run", "run/sign"}));
}

/// Of a process that was killed the next one removes what it left, and nothing of a living one.
TEST(OutputFolder, CleansUpAfterAKilledProcess) {
  const test::TempFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    OutputFolder out(wish(folder, "killed"));
    write(out, "sign", "x");
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(folder.everything().size(), 2U);
  folder.write(".eyrie-part-0123456789abcdef/foreign", "kept");
  folder.write(".eyrie-part-mine", "kept");
  OutputFolder living(wish(folder, "living"));
  write(living, "sign", "x");
  EXPECT_EQ(make(wish(folder, "run"), "new"), "");
  EXPECT_EQ(living.commit(), "");
  EXPECT_EQ(folder.everything(),
            (List{".eyrie-part-0123456789abcdef", ".eyrie-part-0123456789abcdef/foreign",
                  ".eyrie-part-mine", "living", "living/sign", "run", "run/sign"}));
}

TEST(OutputFolder, IsRemovedByASignalHandlerUnlessItIsMoving) {
  const test::TempFolder folder;
  OutputFolder out(wish(folder, "run"));
  write(out, "sign", "x");
  {
    const Moving moving;
    EXPECT_FALSE(remove_temporaries_now());
  }
  EXPECT_EQ(folder.everything().size(), 2U);
  EXPECT_TRUE(remove_temporaries_now());
  EXPECT_EQ(folder.everything(), List{});
}

}  // namespace

namespace {

using List = std::vector<std::string>;

std::string refusal(const std::string& path, bool replace) {
  try {
    OutputFile out(path, replace);
    return "";
  } catch (const Refused& e) {
    return e.what();
  }
}

TEST(OutputFile, IsAsItWasUntilTheNewOneIsComplete) {
  const test::TempFolder folder;
  const std::string path = folder.write("file", "old");
  ::chmod(path.c_str(), 0640);
  { OutputFile(path, true).sink().write("new"); }
  EXPECT_EQ(test::read_text(path), "old");
  OutputFile out(path, true);
  out.sink().write("new");
  EXPECT_EQ(test::read_text(path), "old");
  out.commit();
  EXPECT_EQ(test::read_text(path), "new");
  struct stat made {};
  ASSERT_EQ(::stat(path.c_str(), &made), 0);
  EXPECT_EQ(made.st_mode & 0777U, 0640U);
}

TEST(OutputFile, ReplacesFilesOnlyAndOnlyWhenTold) {
  const test::TempFolder folder;
  folder.write("file", "kept");
  folder.write("folder/inside", "kept");
  std::filesystem::create_symlink("file", folder / "link");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const List before = folder.everything();
  EXPECT_EQ(refusal(folder / "file", false),
            "'" + (folder / "file") + "' exists already; name another file or add --force");
  for (const auto& [name, words] :
       {std::pair("folder", "is a folder; only files are replaced"),
        std::pair("link", "is a symbolic link; only"), std::pair("pipe", "is a pipe; only"),
        std::pair("none/file", "there is no folder"), std::pair("file/x", "Not a directory"),
        std::pair("..", "is no place"), std::pair("none/", "is the name of a folder")})
    EXPECT_NE(refusal(folder / name, true).find(words), std::string::npos)
        << refusal(folder / name, true);
  EXPECT_NE(refusal("/dev/null", true).find("is a device; only"), std::string::npos);
  EXPECT_NE(refusal("", true), "");
  EXPECT_EQ(folder.everything(), before);
}

TEST(OutputFile, GivesWayToWhatHasAppearedInTheMeantime) {
  const test::TempFolder folder;
  for (const bool replace : {false, true}) {
    OutputFile out(folder / "file", replace);
    folder.write("file", "of another");
    if (replace)
      out.commit();
    else
      EXPECT_THROW(out.commit(), Failed);
    EXPECT_EQ(test::read_text(folder / "file"), replace ? "" : "of another");
    std::filesystem::remove(folder / "file");
  }
  OutputFile out(folder / "file", true);
  ASSERT_EQ(::mkfifo((folder / "file").c_str(), 0600), 0);
  EXPECT_THROW(out.commit(), Failed);
  EXPECT_TRUE(std::filesystem::is_fifo(folder / "file"));
}

}  // namespace

}  // namespace eyrie::disk
