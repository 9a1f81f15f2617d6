#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "base/error.h"
#include "lua/block_pool.h"
#include "lua/limits.h"
#include "lua/lua_api.h"

namespace lapidary::lua {

/// Counts what a scene uses against its limits.
///
/// Instructions are counted by a hook, library functions say what they are about to do, and memory
/// is counted in the allocator, where it costs steps, too: so work that a hook cannot see (one
/// concatenation of long strings) is paid for.
class Budget {
 public:
  explicit Budget(const Limits& limits);

  /// Lua's allocator; `budget` is a Budget.
  static void* allocate(void* budget, void* block, std::size_t old_size, std::size_t new_size);

  /// Counts instructions of `L`, and of coroutines it will make.
  static void install_hook(lua_State* L);

  /// Pays for work about to be done; throws Error when the steps are used up.
  void charge(std::int64_t steps);
  /// Throws Error for a string that long.
  void check_string(std::size_t bytes) const;

  /// Nodes live outside Lua's own memory. Whether `bytes` more fit.
  bool has_memory(std::size_t bytes) const;
  /// `data` of that size, which is paid for until the last who holds it lets go: Lua may collect a
  /// solid that others are made of.
  std::shared_ptr<const void> hold(std::shared_ptr<const void> data, std::size_t bytes) const;

  /// Whether steps or time are used up: then nothing runs any more.
  bool exhausted() const { return steps_left_ < 0 || out_of_time_; }
  Error exhausted_error(Location where) const;
  Error memory_error(Location where) const;

  /// Whose stack tells where memory ran out.
  void watch(lua_State* main) { main_ = main; }
  /// The chunk, as Lua shows it, and the line where memory was last refused; 0: unknown.
  const char* refused_chunk() const { return refused_.short_src; }
  int refused_line() const { return refused_.currentline; }

 private:
  static void on_count(lua_State* L, lua_Debug* ar);
  /// Pays for `more` bytes of a block of `size`; whether they fit.
  bool admits(std::size_t size, std::size_t more, bool is_string);
  /// As std::realloc, with 0 to free; `held` is the size of `block`, 0 for none.
  void* reallocate(void* block, std::size_t held, std::size_t size) noexcept;
  void note_refusal();

  BlockPool pool_;
  Limits limits_;
  std::int64_t steps_left_;
  std::size_t memory_ = 0;  ///< of Lua
  /// Of nodes, some of which outlive the interpreter and may be let go on any thread.
  std::shared_ptr<std::atomic<std::size_t>> node_memory_;
  double deadline_;
  bool out_of_time_ = false;
  lua_State* main_ = nullptr;
  lua_Debug refused_{};
  bool refused_string_ = false;  ///< the last refusal was of a string, whatever memory is left
};

}  // namespace lapidary::lua
