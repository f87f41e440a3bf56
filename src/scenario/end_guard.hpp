// SPDX-License-Identifier: MIT
#pragma once
/// \file  A plug-in that ends the program is noticed.
#include <exception>
#include <functional>
#include <string>

namespace eyrie::scenario {

/// While it lives, whoever ends the program by exit(), quick_exit() or std::terminate() does not
/// get away in silence: `last_words` gets what was done ("libx.so called exit()") and the program
/// ends with `code`, which is not 0. Of several guards the youngest counts, and of
/// several threads the first. What ends without a word to anybody (_exit, a signal) is not noticed.
class EndGuard {
 public:
  using LastWords = std::function<void(const std::string& done)>;
  EndGuard(int code, LastWords last_words);
  ~EndGuard();
  EndGuard(const EndGuard&) = delete;
  EndGuard& operator=(const EndGuard&) = delete;

 private:
  static void enlist();
  static void ended(const std::string& done);
  static void on_exit();
  static void on_quick_exit();
  [[noreturn]] static void on_terminate();

  int code_;
  LastWords last_words_;
  EndGuard* before_;
  std::terminate_handler terminate_before_;
};

/// Notes that the code of this file is a plug-in's.
void note_plugin(const std::string& path);
/// The path of the plug-in that holds an address, such as that of a function or of a
/// std::type_info;
/// "" if none does.
[[nodiscard]] std::string plugin_at(const void* address);

}  // namespace eyrie::scenario
