#include "lua/budget.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
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

/// What is counted in `total` for as long as it exists.
class Held {
 public:
  Held(std::shared_ptr<const void> data, std::shared_ptr<std::atomic<std::size_t>> total,
       std::size_t bytes)
      : data_(std::move(data)), total_(std::move(total)), bytes_(bytes) {
    total_->fetch_add(bytes_, std::memory_order_relaxed);
  }
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;
  ~Held() { total_->fetch_sub(bytes_, std::memory_order_relaxed); }

 private:
  std::shared_ptr<const void> data_;
  std::shared_ptr<std::atomic<std::size_t>> total_;
  std::size_t bytes_;
};

}  // namespace

Budget::Budget(const Limits& limits)
    : limits_(limits),
      steps_left_(limits.steps),
      node_memory_(std::make_shared<std::atomic<std::size_t>>(0)),
      deadline_(thread_seconds() + limits.seconds) {}

void* Budget::allocate(void* budget, void* block, std::size_t old_size, std::size_t new_size) {
  auto& self = *static_cast<Budget*>(budget);
  // For a new block, Lua says in place of its size what it is for.
  const bool is_string = !block && old_size == LUA_TSTRING;
  const std::size_t held = block ? old_size : 0;
  if (new_size > held && !self.admits(new_size, new_size - held, is_string)) {
    self.note_refusal();
    return nullptr;
  }
  void* moved = self.reallocate(block, held, new_size);
  if (moved || new_size == 0) self.memory_ += new_size - held;
  return moved;
}

bool Budget::admits(std::size_t size, std::size_t more, bool is_string) {
  constexpr std::size_t header = 64;  // more than what a string needs besides its text
  steps_left_ -= static_cast<std::int64_t>(more / bytes_per_step);
  refused_string_ = is_string && size > limits_.string_bytes + header;
  return !exhausted() && has_memory(more) && !refused_string_;
}

void* Budget::reallocate(void* block, std::size_t held, std::size_t size) noexcept {
  const bool was_small = held > 0 && held <= BlockPool::largest;
  const bool is_small = size > 0 && size <= BlockPool::largest;
  if (!was_small && !is_small) {
    if (size > 0) return std::realloc(block, size);
    std::free(block);
    return nullptr;
  }
  if (was_small && is_small && BlockPool::same_class(held, size)) return block;
  void* moved = size == 0 ? nullptr : is_small ? pool_.take(size) : std::malloc(size);
  // Lua counts on blocks that shrink; one kept too large is harmless in a smaller class.
  if (size > 0 && !moved) return size <= held ? block : nullptr;
  if (moved && held > 0) std::memcpy(moved, block, std::min(held, size));
  if (was_small) {
    pool_.give_back(block, held);
  } else {
    std::free(block);
  }
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
  throw Error({}, fmt::format("a string is longer than {} bytes", limits_.string_bytes),
              "does a loop make more than it should?");
}

bool Budget::has_memory(std::size_t bytes) const {
  return memory_ + node_memory_->load(std::memory_order_relaxed) + bytes <= limits_.memory;
}

std::shared_ptr<const void> Budget::hold(std::shared_ptr<const void> data,
                                         std::size_t bytes) const {
  const void* address = data.get();
  return {std::make_shared<const Held>(std::move(data), node_memory_, bytes), address};
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
  if (refused_string_) {
    return Error(std::move(where),
                 fmt::format("a string is longer than {} bytes", limits_.string_bytes),
                 "does a loop make more than it should?");
  }
  return Error(
      std::move(where),
      fmt::format("the scene needs more than {} MB of memory to read", limits_.memory >> 20),
      "does a loop make more than it should?");
}

}  // namespace lapidary::lua
