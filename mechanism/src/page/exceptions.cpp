// C++ exceptions as exceptions of WebAssembly, and the search for their handlers.
//
// Debian's C++ library for WebAssembly is built without exceptions, so the functions of the Itanium
// ABI that the compiler calls for them are defined here. They suffice for classes with at most one
// base, at the same address, as all errors of the project, of the standard library and of the JSON
// library are.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <typeinfo>

extern "C" const char _ZTVN10__cxxabiv120__si_class_type_infoE[];

namespace {

/// The header of a thrown object.
struct Thrown {
  const std::type_info* type;
  void* (*destroy)(void*);  ///< in WebAssembly destructors return their argument
  Thrown* outer;            ///< the exception that was caught before and is still being handled
  int handlers;             ///< number of handlers at work on it; negative if it is thrown again
  alignas(std::max_align_t) std::byte object[1];
};

/// The exception that was caught last.
Thrown* caught = nullptr;

Thrown* head_of(void* object) {
  return reinterpret_cast<Thrown*>(static_cast<std::byte*>(object) - offsetof(Thrown, object));
}

/// The layout of the type information of a class with one base.
struct ClassWithOneBase {
  const char* functions;
  const char* name;
  const std::type_info* base;
};

bool is_a(const std::type_info* type, const std::type_info& wanted) {
  while (*type != wanted) {
    const auto* shape = reinterpret_cast<const ClassWithOneBase*>(type);
    if (shape->functions != _ZTVN10__cxxabiv120__si_class_type_infoE + 2 * sizeof(void*)) {
      return false;
    }
    type = shape->base;
  }
  return true;
}

/// A number in groups of seven bits, the low ones first (LEB128).
std::uint32_t unsigned_at(const std::uint8_t*& at) {
  std::uint32_t value = 0;
  for (unsigned shift = 0;; shift += 7) {
    const std::uint8_t byte = *at++;
    value |= static_cast<std::uint32_t>(byte & 0x7FU) << shift;
    if (byte < 0x80) {
      return value;
    }
  }
}

/// A signed number, in the same groups of bits.
std::int32_t signed_at(const std::uint8_t*& at) {
  const std::uint8_t* const begin = at;
  const std::uint32_t value = unsigned_at(at);
  const auto bits = static_cast<unsigned>(7 * (at - begin));
  const bool is_negative = bits < 32 && (value >> (bits - 1) & 1U) != 0;
  return static_cast<std::int32_t>(is_negative ? value | ~0U << bits : value);
}

}  // namespace

extern "C" {

/// The record in which a function that may catch stores the throwing call site, and from which it
/// reads the number of the handler to run: 0 for none.
struct LandingPad {
  std::uint32_t place;
  const std::uint8_t* table;
  std::int32_t handler;
};
LandingPad __wasm_lpad_context;

void* __cxa_allocate_exception(std::size_t size) {
  auto* thrown = static_cast<Thrown*>(std::calloc(1, sizeof(Thrown) + size));
  if (thrown == nullptr) {
    std::abort();
  }
  return thrown->object;
}

void __cxa_free_exception(void* object) { std::free(head_of(object)); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
  head_of(object)->type = type;
  head_of(object)->destroy = destroy;
  __builtin_wasm_throw(0, object);
}

void* __cxa_begin_catch(void* object) {
  Thrown* thrown = head_of(object);
  thrown->handlers = std::abs(thrown->handlers) + 1;
  if (caught != thrown) {
    thrown->outer = caught;
    caught = thrown;
  }
  return object;
}

void __cxa_end_catch() {
  Thrown* thrown = caught;
  const bool goes_on = thrown->handlers < 0;
  thrown->handlers += goes_on ? 1 : -1;
  if (thrown->handlers != 0) {
    return;
  }
  caught = thrown->outer;
  if (!goes_on) {
    if (thrown->destroy != nullptr) {
      thrown->destroy(thrown->object);
    }
    std::free(thrown);
  }
}

[[noreturn]] void __cxa_rethrow() {
  caught->handlers = -caught->handlers;
  __builtin_wasm_throw(0, caught->object);
}

/// Finds the handler of an exception in the table of the calling function. The table holds the
/// encoding of its types, the first of a chain of actions for each call site, the actions, and the
/// types.
int _Unwind_CallPersonality(void* object) {
  constexpr std::uint8_t left_out = 0xFF;
  __wasm_lpad_context.handler = 0;
  const std::uint8_t* at = __wasm_lpad_context.table;
  if (at == nullptr) {
    return 0;
  }
  ++at;  // skips the start of the function, from which call sites are counted
  const std::uint8_t encoding = *at++;
  const std::type_info* const* types = nullptr;
  if (encoding != left_out) {
    const std::uint32_t away = unsigned_at(at);
    types = reinterpret_cast<const std::type_info* const*>(at + away);
  }
  ++at;  // skips the encoding of the call sites, which is always as below
  const std::uint32_t length = unsigned_at(at);
  const std::uint8_t* const actions = at + length;
  std::uint32_t action = 0;
  for (std::uint32_t place = 0; place <= __wasm_lpad_context.place; ++place) {
    (void)unsigned_at(at);
    action = unsigned_at(at);
  }
  if (action == 0) {
    return 0;
  }
  at = actions + action - 1;
  while (true) {
    const std::int32_t handler = signed_at(at);
    if (handler > 0) {
      const std::type_info* wanted = types[-handler];
      if (wanted == nullptr || is_a(head_of(object)->type, *wanted)) {
        __wasm_lpad_context.handler = handler;
        return 0;
      }
    }
    const std::uint8_t* const here = at;
    const std::int32_t step = signed_at(at);
    if (step == 0) {
      return 0;
    }
    at = here + step;
  }
}
}

/// The only exception tag of WebAssembly that C++ throws; it carries the object's address.
__asm__(".globl __cpp_exception\n.tagtype __cpp_exception i32\n__cpp_exception:\n");
