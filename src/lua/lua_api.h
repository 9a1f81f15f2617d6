#pragma once

// The library to link is lua5.4-c++: Lua compiled as C++, whose errors are exceptions and run
// destructors. The one compiled as C has the same symbols and jumps over them.
#include <lauxlib.h>
#include <lua.h>
#include <lualib.h>
