// SPDX-License-Identifier: MIT
/// \file  viewer/src/engine/questions.ts is what the messages and questions are.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "web/questions.hpp"

namespace eyrie::web {
namespace {

/// How TypeScript calls the type; interfaces that it needs are added to `declared` by name.
template <class T>
std::string typescript(std::map<std::string, std::string>& declared) {
  if constexpr (Described<T>) {
    const std::string name(described<T>.name);
    if (declared.contains(name))
      return name;
    declared[name];  // it may hold itself
    std::string text = fmt::format("/** {} */\nexport interface {} {{\n", described<T>.help, name);
    std::apply(
        [&](const auto&... member) {
          [[maybe_unused]] const auto declare = [&](const auto& one) {
            using V = std::remove_cvref_t<decltype(std::declval<T>().*one.at)>;
            if constexpr (detail::is_optional<V>)
              text += fmt::format("  {}?: {};  // {}\n", one.name,
                                  typescript<typename V::value_type>(declared), one.help);
            else
              text +=
                  fmt::format("  {}: {};  // {}\n", one.name, typescript<V>(declared), one.help);
          };
          (declare(member), ...);
        },
        described<T>.members);
    declared[name] = text + "}\n";
    return name;
  } else if constexpr (detail::is_list<T>) {
    return fmt::format("Array<{}>", typescript<typename T::value_type>(declared));
  } else if constexpr (detail::is_map<T>) {
    return fmt::format("Record<string, {}>", typescript<typename T::mapped_type>(declared));
  } else if constexpr (std::same_as<T, bool>) {
    return "boolean";
  } else if constexpr (std::floating_point<T>) {
    return "number | null";
  } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
    return "number";
  } else if constexpr (std::same_as<T, std::pair<double, double>>) {
    return "[number, number]";
  } else if constexpr (std::same_as<T, Json>) {
    return "object";
  } else {
    return "string";
  }
}

/// How TypeScript calls what a question takes and gives.
template <class Asked>
std::string type_of(std::map<std::string, std::string>& declared) {
  std::string parameter;
  if constexpr (Asked::kBytes == Bytes::asked)
    parameter = "file: Uint8Array";
  else if constexpr (!std::same_as<typename Asked::Request, Nothing>)
    parameter = "request: " + typescript<typename Asked::Request>(declared);
  return fmt::format("({}): Promise<{}{}>", parameter, typescript<typename Asked::Answer>(declared),
                     Asked::kBytes == Bytes::answered ? " & { bytes: Uint8Array }" : "");
}

/// questions.ts, made of the list of questions that is asked by.
std::string declarations() {
  std::map<std::string, std::string> declared;
  std::string questions;
  const auto add = [&]<class Asked>(const Asked& question) {
    questions += fmt::format("  /** {} */\n  {}{};\n", question.help, question.name,
                             type_of<Asked>(declared));
  };
  std::apply([&](const auto&... question) { (add(question), ...); }, kQuestions);
  std::string text =
      "// SPDX-License-Identifier: MIT\n"
      "// Made from web/messages.hpp and web/questions.hpp: a test writes what has changed.\n\n";
  for (const auto& [name, declaration] : declared)
    text += declaration + "\n";
  return text +
         "/** Numbers are SI, times s of simulated time. A question that cannot be answered is "
         "rejected with an EngineError. */\nexport interface Engine {\n" +
         questions + "}\n";
}

TEST(WebQuestions, AreDeclaredInTypeScript) {
  const std::string file = "viewer/src/engine/questions.ts";
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}}, now = declarations();
  if (text != now)
    std::ofstream("questions.ts.new", std::ios::binary) << now;
  EXPECT_TRUE(text == now) << file << " is not current: put questions.ts.new in its place";
}

}  // namespace
}  // namespace eyrie::web
