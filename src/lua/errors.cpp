#include "lua/errors.h"

#include <new>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "lua/interpreter.h"

namespace lapidary::lua {
namespace {

constexpr auto type_name = "lapidary.error";

using Box = std::exception_ptr;

int collect(lua_State* L) {
  static_cast<Box*>(lua_touserdata(L, 1))->~Box();
  return 0;
}

std::string message_of(const std::exception_ptr& problem) {
  try {
    std::rethrow_exception(problem);
  } catch (const std::exception& e) {
    return e.what();
  }
}

int to_text(lua_State* L) {
  const std::string message = message_of(*static_cast<Box*>(luaL_checkudata(L, 1, type_name)));
  lua_pushlstring(L, message.data(), message.size());
  return 1;
}

/// Between the box and its metatable nothing may fail, or it would never be emptied; so the
/// metatable is there from the start (open_errors).
void push_exception(lua_State* L, std::exception_ptr problem) {
  void* place = lua_newuserdatauv(L, sizeof(Box), 0);
  new (place) Box(std::move(problem));
  luaL_setmetatable(L, type_name);
}

/// `error` with the line that called the function it is in. An error may lie in what a function
/// does, or in what it was given.
Error with_caller(lua_State* L, Error error) {
  const Interpreter& interpreter = Interpreter::of(L);
  const auto is_here = [&error](const Location& place) {
    return place.file == error.where().file && place.line == error.where().line;
  };
  if (!is_here(interpreter.call_site(L).location())) return error;
  const Location caller = interpreter.caller_site(L).location();
  if (caller.line == 0 || is_here(caller)) return error;
  return Error(error.where(), fmt::format("{}, called from {}", error.problem(), to_string(caller)),
               error.hint());
}

/// What the interpreter's own messages mean for somebody who writes scenes.
Error explain(Location where, std::string_view message) {
  if (message.find("stack overflow") != std::string_view::npos) {
    return Error(std::move(where), "functions are nested too deeply (stack overflow)",
                 "does a function call itself without end?");
  }
  return Error(std::move(where), std::string(message));
}

}  // namespace

void open_errors(lua_State* L) {
  luaL_newmetatable(L, type_name);
  lua_pushcfunction(L, collect);
  lua_setfield(L, -2, "__gc");
  lua_pushcfunction(L, to_text);
  lua_setfield(L, -2, "__tostring");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 1);
}

int raise(lua_State* L, std::exception_ptr problem) {
  push_exception(L, std::move(problem));
  return lua_error(L);
}

int raise(lua_State* L, const Error& error) {
  return raise(L, std::make_exception_ptr(error));
}

int raise_with_place(lua_State* L, std::exception_ptr problem) {
  try {
    std::rethrow_exception(problem);
  } catch (const Error& error) {
    Location where = error.where();
    if (where.file.empty() && where.line == 0) {
      where = Interpreter::of(L).call_site(L).location(where.parameter);
    }
    problem = std::make_exception_ptr(
        with_caller(L, Error(std::move(where), error.problem(), error.hint())));
  } catch (const std::exception&) {
    // Anything else goes on as it is.
  }
  return raise(L, std::move(problem));
}

std::exception_ptr exception_at(lua_State* L, int index) {
  const auto* box = static_cast<const Box*>(luaL_testudata(L, index, type_name));
  return box ? *box : nullptr;
}

int error_with_place(lua_State* L) {
  if (luaL_testudata(L, 1, type_name)) return 1;
  const Interpreter& interpreter = Interpreter::of(L);
  if (lua_type(L, 1) == LUA_TSTRING) {
    std::size_t size = 0;
    const char* text = lua_tolstring(L, 1, &size);
    auto [where, message] = interpreter.sources().split_message({text, size});
    if (where.line == 0) where = interpreter.call_site(L).location();
    push_exception(L, std::make_exception_ptr(with_caller(L, explain(std::move(where), message))));
  } else {
    const std::string problem =
        std::string("error called with a ") + luaL_typename(L, 1) + " instead of a message";
    push_exception(L, std::make_exception_ptr(
                          with_caller(L, Error(interpreter.call_site(L).location(), problem))));
  }
  return 1;
}

}  // namespace lapidary::lua
