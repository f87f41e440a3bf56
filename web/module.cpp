// SPDX-License-Identifier: MIT
/// \file  The module's door: a request and its answer are JSON, large things come as bytes beside
/// them. `{"ask": "seek", "step": 100}` is answered by `{"step": 100, ...}` or `{"error": "...",
/// "problems": [...]}`.
#include "web/engine.hpp"

#define EYRIE_EXPORT(name) __attribute__((export_name(name)))
/// The host is told how far a long answer is, s.
__attribute__((import_module("eyrie"), import_name("progress"))) extern "C" void eyrie_progress(
    double time);

namespace {
std::string g_request, g_answer, g_bytes;
eyrie::web::Engine& engine() {
  static eyrie::web::Engine one(eyrie_progress);
  return one;
}
}  // namespace

extern "C" {
/// Room for a request, or for the bytes that go with it.
EYRIE_EXPORT("request") char* eyrie_request(std::size_t size) {
  g_request.resize(size);
  return g_request.data();
}
EYRIE_EXPORT("bytes") char* eyrie_bytes(std::size_t size) {
  g_bytes.resize(size);
  return g_bytes.data();
}
/// Answers the request; gives the length of the answer.
EYRIE_EXPORT("ask") std::size_t eyrie_ask() {
  g_answer = eyrie::web::answer(engine(), g_request, g_bytes);
  return g_answer.size();
}
EYRIE_EXPORT("answer") const char* eyrie_answer() {
  return g_answer.data();
}
EYRIE_EXPORT("bytes_at") const char* eyrie_bytes_at() {
  return g_bytes.data();
}
EYRIE_EXPORT("bytes_size") std::size_t eyrie_bytes_size() {
  return g_bytes.size();
}
}
