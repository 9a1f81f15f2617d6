#include <algorithm>

#include <fmt/format.h>

#include "lua/interpreter.h"
#include "lua/libraries.h"

namespace lapidary::lua {
namespace {

constexpr auto loaded_key = "lapidary.loaded";

/// "lib.gears" means lib/gears.lua; names with a slash or .lua are taken as they are.
std::string file_of_module(std::string_view name) {
  std::string file(name);
  if (file.ends_with(".lua")) return file;
  if (file.find('/') == std::string::npos) std::replace(file.begin(), file.end(), '.', '/');
  return file + ".lua";
}

/// Keeps `file` on the list of what is being read, also when reading it fails.
class ReadingScope {
 public:
  ReadingScope(std::vector<std::filesystem::path>& list, const std::filesystem::path& file)
      : list_(list) {
    list_.push_back(file);
  }
  ~ReadingScope() { list_.pop_back(); }
  ReadingScope(const ReadingScope&) = delete;
  ReadingScope& operator=(const ReadingScope&) = delete;

 private:
  std::vector<std::filesystem::path>& list_;
};

/// Runs a module of the scene once and returns what it returned.
int require(lua_State* L) {
  std::size_t size = 0;
  const char* name = luaL_checklstring(L, 1, &size);
  lua_settop(L, 1);
  Interpreter& interpreter = Interpreter::of(L);
  const schema::Call call{"require", interpreter.call_site(L), &interpreter.files()};
  const schema::Context context(call);
  const std::string written = file_of_module({name, size});
  const auto file = interpreter.files().resolve(written, context);

  luaL_getsubtable(L, LUA_REGISTRYINDEX, loaded_key);
  if (lua_getfield(L, 2, file.c_str()) != LUA_TNIL) return 1;
  auto& reading = interpreter.modules_being_read();
  if (std::find(reading.begin(), reading.end(), file) != reading.end()) {
    context.fail(fmt::format("goes round in a circle: '{}' is still being read", written));
  }
  const ReadingScope scope(reading, file);
  interpreter.push_chunk(L, file, interpreter.files().shown(file));
  lua_call(L, 0, 1);
  if (lua_isnil(L, -1)) {
    lua_pushboolean(L, 1);
    lua_replace(L, -2);
  }
  lua_pushvalue(L, -1);
  lua_setfield(L, 2, file.c_str());
  return 1;
}

}  // namespace

void open_require(lua_State* L) {
  lua_pushcfunction(L, guarded<require>);
  lua_setglobal(L, "require");
}

}  // namespace lapidary::lua
