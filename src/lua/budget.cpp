#include "lua/budget.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>

#include <fmt/format.h>

#include "lua/interpreter.h"

namespace lapidary::lua {
namespace {

constexpr int instructions_per_hook = 1000;
/// Bytes that are as much work as one instruction, roughly, when they are allocated and filled.
constexpr std::size_t bytes_per_step = 64;

/// Seconds of processor time of this thread.
double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

Budget::Budget(const Limits& limits)
    : limits_(limits), steps_left_(limits.steps), deadline_(thread_seconds() + limits.seconds) {}

void* Budget::allocate(void* budget, void* block, std::size_t old_size, std::size_t new_size) {
  auto& self = *static_cast<Budget*>(budget);
  // For a new block, Lua says in place of its size what it is for.
  const std::size_t held = block ? old_size : 0;
  if (new_size == 0) {
    std::free(block);
    self.memory_ -= held;
    return nullptr;
  }
  if (new_size > held) {
    const std::size_t more = new_size - held;
    self.steps_left_ -= static_cast<std::int64_t>(more / bytes_per_step);
    const bool long_string =
        !block && old_size == LUA_TSTRING && new_size > self.limits_.string_bytes + 64;
    if (self.exhausted() || long_string || self.memory_ + more > self.limits_.memory) {
      self.note_refusal();
      return nullptr;
    }
  }
  void* moved = std::realloc(block, new_size);
  if (moved) self.memory_ += new_size - held;
  return moved;
}

void Budget::note_refusal() {
  if (!main_) return;
  // Looking at the stack needs no memory, so it may be done from inside the allocator.
  lua_Debug ar{};
  refused_ = {};
  for (int level = 0; lua_getstack(main_, level, &ar) != 0; ++level) {
    if (lua_getinfo(main_, "Sl", &ar) != 0 && ar.currentline > 0) {
      refused_ = ar;
      return;
    }
  }
}

void Budget::install_hook(lua_State* L) {
  lua_sethook(L, on_count, LUA_MASKCOUNT, instructions_per_hook);
}

void Budget::on_count(lua_State* L, lua_Debug* ar) {
  Interpreter& interpreter = Interpreter::of(L);
  Budget& self = interpreter.budget();
  if (!self.exhausted()) {
    self.steps_left_ -= instructions_per_hook;
    if (thread_seconds() > self.deadline_) self.out_of_time_ = true;
    if (!self.exhausted()) return;
  }
  // From now on every instruction fails, so that no pcall can go on.
  lua_sethook(L, on_count, LUA_MASKCOUNT, 1);
  lua_getinfo(L, "Sl", ar);
  raise(L, self.exhausted_error(interpreter.sources().location(*ar)));
}

void Budget::charge(std::int64_t steps) {
  // Sums of charges must not wrap around.
  steps_left_ -= std::min(steps, std::int64_t{1} << 60);
  if (exhausted()) throw exhausted_error({});
}

void Budget::check_string(std::size_t bytes) const {
  if (bytes <= limits_.string_bytes) return;
  throw Error({}, fmt::format("a string of {} bytes is too long", bytes),
              fmt::format("the limit is {}", limits_.string_bytes));
}

bool Budget::take_memory(std::size_t bytes) {
  if (memory_ + bytes > limits_.memory) return false;
  memory_ += bytes;
  return true;
}

Error Budget::exhausted_error(Location where) const {
  if (out_of_time_ && steps_left_ >= 0) {
    return Error(std::move(where),
                 fmt::format("the scene takes more than {} s to read", limits_.seconds),
                 "does a loop never end?");
  }
  return Error(std::move(where),
               fmt::format("the scene takes more than {} steps to read", limits_.steps),
               "does a loop never end?");
}

Error Budget::memory_error(Location where) const {
  return Error(std::move(where),
               fmt::format("the scene needs more than {} MB of memory, or a string of more than {} "
                           "MB, while it is read",
                           limits_.memory >> 20, limits_.string_bytes >> 20),
               "does a loop make more than it should?");
}

}  // namespace lapidary::lua
