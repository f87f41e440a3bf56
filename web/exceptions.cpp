// SPDX-License-Identifier: MIT
/// \file  C++ exceptions in WebAssembly. Debian's libc++abi for wasm32-wasi is built without them,
/// though clang compiles them: this is the part of the Itanium C++ ABI ("Exception Handling", 2.4
/// and 2.5; the tables of a function as in 1.6 "Personality Routine") that one thread needs.
/// Exceptions of other languages, dependent exceptions and specifications are left out.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <typeinfo>

namespace __cxxabiv1 {

/// As in libc++abi, where every kind of type_info derives from it: the layout of its functions is
/// all that is used here.
class __shim_type_info : public std::type_info {
 public:
  virtual ~__shim_type_info();
  virtual void noop1() const;
  virtual void noop2() const;
  /// Whether a handler of this type takes what was thrown, which `object` then points into.
  virtual bool can_catch(const __shim_type_info* thrown, void*& object) const = 0;
};

}  // namespace __cxxabiv1

namespace {

using Type = __cxxabiv1::__shim_type_info;

/// Before each thrown object.
struct alignas(16) Thrown {
  const Type* type;
  void* (*destroy)(void*);  ///< in WebAssembly a destructor returns the object
  void* caught_as;          ///< the part of the object that the handler takes
  Thrown* below;            ///< caught before it and not yet ended
  std::uint32_t handlers;
  bool again;  ///< is thrown again: it outlives the handlers that it leaves

  void* object() { return this + 1; }
  static Thrown* of(void* object) { return static_cast<Thrown*>(object) - 1; }
};

Thrown* g_caught = nullptr;

/// Reads the tables that the compiler makes of the handlers of a function.
class Reader {
 public:
  explicit Reader(const std::uint8_t* at) : at_(at) {}
  std::uint8_t byte() { return *at_++; }
  std::uintptr_t unsigned_leb() {
    std::uintptr_t value = 0;
    for (unsigned shift = 0;; shift += 7) {
      const std::uint8_t next = byte();
      value |= static_cast<std::uintptr_t>(next & 0x7f) << shift;
      if (!(next & 0x80))
        return value;
    }
  }
  std::intptr_t signed_leb() {
    std::uint64_t value = 0;
    unsigned shift = 0;
    std::uint8_t next = 0;
    do {
      next = byte();
      value |= static_cast<std::uint64_t>(next & 0x7f) << shift;
      shift += 7;
    } while (next & 0x80);
    if (next & 0x40)
      value |= ~std::uint64_t{0} << shift;
    return static_cast<std::intptr_t>(value);
  }
  [[nodiscard]] const std::uint8_t* at() const { return at_; }

 private:
  const std::uint8_t* at_;
};

constexpr std::uint8_t kOmitted = 0xff;  // DW_EH_PE_omit

/// The number of the handler at call site `site` that takes what was thrown; 0 for none.
int handler(const std::uint8_t* table, std::uintptr_t site, Thrown& thrown) {
  Reader head(table);
  if (head.byte() != kOmitted)  // where landing pads count from: of no use in WebAssembly
    std::abort();
  const std::uint8_t* types = nullptr;
  if (head.byte() != kOmitted) {
    const std::uintptr_t offset = head.unsigned_leb();
    types = head.at() + offset;
  }
  head.byte();  // how call sites are written: two numbers each
  const std::uintptr_t length = head.unsigned_leb();
  const std::uint8_t* actions = head.at() + length;
  Reader sites(head.at());
  for (; site > 0; --site) {
    sites.unsigned_leb();
    sites.unsigned_leb();
  }
  sites.unsigned_leb();
  const std::uintptr_t first = sites.unsigned_leb();
  if (first == 0)
    return 0;  // only clears up
  for (const std::uint8_t* action = actions + first - 1;;) {
    Reader reader(action);
    const std::intptr_t number = reader.signed_leb();
    const std::uint8_t* link = reader.at();
    if (number > 0) {
      const Type* type = nullptr;
      std::memcpy(&type, types - static_cast<std::uintptr_t>(number) * sizeof(type), sizeof(type));
      void* object = thrown.object();
      if (type == nullptr || type->can_catch(thrown.type, object)) {
        thrown.caught_as = type ? object : thrown.object();
        return static_cast<int>(number);
      }
    }
    const std::intptr_t next = reader.signed_leb();
    if (next == 0)
      return 0;
    action = link + next;
  }
}

void drop(Thrown& thrown) {
  if (thrown.destroy)
    thrown.destroy(thrown.object());
  std::free(&thrown);
}

[[noreturn]] void raise(Thrown& thrown) {
  __builtin_wasm_throw(0, &thrown);
}

}  // namespace

extern "C" {

/// What a landing pad fills in before it asks, and where it finds the answer.
struct LandingPad {
  std::uintptr_t site;
  const std::uint8_t* table;
  std::uintptr_t handler;
};
thread_local LandingPad __wasm_lpad_context = {};

int _Unwind_CallPersonality(void* thrown) {
  LandingPad& pad = __wasm_lpad_context;
  pad.handler = static_cast<std::uintptr_t>(
      pad.table ? handler(pad.table, pad.site, *static_cast<Thrown*>(thrown)) : 0);
  return 0;
}

void* __cxa_allocate_exception(std::size_t size) noexcept {
  void* place = std::calloc(1, sizeof(Thrown) + size);
  if (place == nullptr)
    std::abort();
  return static_cast<Thrown*>(place)->object();
}

void __cxa_free_exception(void* object) noexcept {
  std::free(Thrown::of(object));
}

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
  Thrown& thrown = *Thrown::of(object);
  thrown.type = static_cast<const Type*>(type);
  thrown.destroy = destroy;
  raise(thrown);
}

void* __cxa_get_exception_ptr(void* thrown) noexcept {
  return static_cast<Thrown*>(thrown)->caught_as;
}

void* __cxa_begin_catch(void* caught) noexcept {
  Thrown& thrown = *static_cast<Thrown*>(caught);
  if (thrown.handlers++ == 0 && !thrown.again) {
    thrown.below = g_caught;
    g_caught = &thrown;
  }
  thrown.again = false;
  return thrown.caught_as;
}

void __cxa_end_catch() {
  Thrown& thrown = *g_caught;
  if (--thrown.handlers > 0)
    return;
  if (thrown.again)
    return;  // on its way to the next handler
  g_caught = thrown.below;
  drop(thrown);
}

[[noreturn]] void __cxa_rethrow() {
  if (g_caught == nullptr)
    std::terminate();
  g_caught->again = true;
  raise(*g_caught);
}

}  // extern "C"
