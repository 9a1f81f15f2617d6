#pragma once

#include <exception>

#include "base/error.h"
#include "lua/lua_api.h"

namespace lapidary::lua {

// Exceptions travel through Lua as error values, so that a scene's pcall sees them like any other
// error (tostring gives the message), and come out unchanged.

/// To be called before anything else here.
void open_errors(lua_State* L);

/// Raises `problem` as a Lua error; does not return, whatever its type says, as lua_error.
int raise(lua_State* L, std::exception_ptr problem);
int raise(lua_State* L, const Error& error);
/// As `raise`; an Error without a place gets that of the line that called.
int raise_with_place(lua_State* L, std::exception_ptr problem);

/// The exception that travels as the value at `index`; null when it is another value.
std::exception_ptr exception_at(lua_State* L, int index);

/// A message handler for lua_pcall: turns any error value into an Error with its place.
int error_with_place(lua_State* L);

/// A function for Lua: `F`, which may throw what derives from std::exception.
template <int (*F)(lua_State*)>
int guarded(lua_State* L) {
  std::exception_ptr problem;
  try {
    return F(L);
  } catch (const std::exception&) {  // Lua's own errors are of another type and pass
    problem = std::current_exception();
  }
  return raise_with_place(L, std::move(problem));
}

}  // namespace lapidary::lua
