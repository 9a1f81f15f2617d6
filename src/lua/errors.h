#pragma once

#include <exception>

#include "base/error.h"
#include "lua/lua_api.h"

namespace lapidary::lua {

// Exceptions travel through Lua as error values, so that a scene's pcall sees them like any other
// error (tostring gives the message), and come out unchanged.

/// Raises `problem` as a Lua error.
[[noreturn]] void raise(lua_State* L, std::exception_ptr problem);
[[noreturn]] void raise(lua_State* L, const Error& error);

/// The exception that travels as the value at `index`; null when it is another value.
std::exception_ptr exception_at(lua_State* L, int index);

/// A message handler for lua_pcall: turns any error value into an Error with its place.
int error_with_place(lua_State* L);

/// A function for Lua: `F`, which may throw what derives from std::exception. An Error without a
/// place gets that of the line that called.
template <int (*F)(lua_State*)>
int guarded(lua_State* L);

[[noreturn]] void raise_current(lua_State* L, std::exception_ptr problem);

template <int (*F)(lua_State*)>
int guarded(lua_State* L) {
  std::exception_ptr problem;
  try {
    return F(L);
  } catch (const std::exception&) {  // Lua's own errors are of another type and pass
    problem = std::current_exception();
  }
  raise_current(L, std::move(problem));
}

}  // namespace lapidary::lua
