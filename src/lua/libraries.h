#pragma once

#include "lua/lua_api.h"

namespace lapidary::lua {

/// The standard library as scenes have it: what computes stays (math, string, table, utf8,
/// coroutine), what reaches outside is gone (io, os, debug, package, dofile, loadfile,
/// collectgarbage), what depends on addresses, seeds or clocks is replaced by something fixed, and
/// what can work long without the interpreter noticing pays for it.
void open_libraries(lua_State* L);

// The parts of it, each in a file of its own. All may throw.
void open_base(lua_State* L);
void open_string(lua_State* L);
void open_table(lua_State* L);
void open_ordered_pairs(lua_State* L);
void open_require(lua_State* L);

/// Pushes what `tostring` gives for the value at `index`: without addresses, which differ from run
/// to run.
void push_text(lua_State* L, int index);

}  // namespace lapidary::lua
