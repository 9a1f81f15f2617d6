#include "lua/interpreter.h"

#include <fstream>
#include <new>
#include <span>
#include <sstream>

#include <fmt/format.h>

#include "lua/libraries.h"

namespace lapidary::lua {
namespace {

std::string read_text(const std::filesystem::path& file, const std::string& shown,
                      const InputFiles* files) {
  if (const auto content = file_content(files, file)) return std::string(*content);
  constexpr std::uintmax_t largest = std::uintmax_t{256} << 20;
  std::error_code problem;
  const auto size = std::filesystem::file_size(file, problem);
  if (problem) throw file_error(shown, "cannot be read", problem.message());
  if (size > largest) throw file_error(shown, "is too large for a scene", "the limit is 256 MB");
  std::ifstream stream(file, std::ios::binary);
  std::string text(static_cast<std::size_t>(size), '\0');
  if (!stream.read(text.data(), static_cast<std::streamsize>(size))) {
    throw file_error(shown, "cannot be read");
  }
  return text;
}

/// Without a byte order mark; a first line for a shell becomes a comment.
void clean_start(std::string& text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  if (text.starts_with('#')) text.insert(0, "--");
}

/// Trampoline: runs the std::function at index 1 inside a protected call.
int call_work(lua_State* L) {
  const auto& work = *static_cast<const std::function<void(lua_State*)>*>(lua_touserdata(L, 1));
  lua_settop(L, 0);
  work(L);
  return 0;
}

int on_panic(lua_State*) {
  throw std::bad_alloc();  // only reached outside protected calls, when there is no memory to start
}

}  // namespace

Interpreter::Interpreter(const Limits& limits, FolderGuard files,
                         std::function<void(std::string_view)> print, InputFiles* read)
    : budget_(limits), files_(std::move(files)), print_(std::move(print)), read_(read) {
  L_ = lua_newstate(Budget::allocate, &budget_);
  if (!L_) throw std::bad_alloc();
  lua_atpanic(L_, on_panic);
  *static_cast<Interpreter**>(lua_getextraspace(L_)) = this;
  budget_.watch(L_);
  try {
    run([](lua_State* L) { open_libraries(L); });
  } catch (...) {
    lua_close(L_);
    throw;
  }
  Budget::install_hook(L_);
}

Interpreter::~Interpreter() {
  lua_close(L_);
}

void Interpreter::run(const std::function<void(lua_State*)>& work) {
  const int top = lua_gettop(L_);
  lua_pushcfunction(L_, error_with_place);
  lua_pushcfunction(L_, guarded<call_work>);
  lua_pushlightuserdata(L_, const_cast<std::function<void(lua_State*)>*>(&work));
  const int status = lua_pcall(L_, 1, 0, top + 1);
  if (status != LUA_OK) rethrow(status);
  lua_settop(L_, top);
}

void Interpreter::rethrow(int status) {
  const std::exception_ptr problem = exception_at(L_, -1);
  lua_settop(L_, 0);
  if (problem) std::rethrow_exception(problem);
  Location where;
  if (budget_.refused_line() > 0) {
    const auto file = sources_.find(budget_.refused_chunk());
    where = {.file = file ? *file : "", .line = budget_.refused_line()};
  }
  if (budget_.exhausted()) throw budget_.exhausted_error(std::move(where));
  if (status == LUA_ERRMEM) throw budget_.memory_error(std::move(where));
  throw Error(std::move(where), "an error came up while another was being reported");
}

void Interpreter::push_chunk(lua_State* L, const std::filesystem::path& file,
                             const std::string& shown) {
  std::string text = read_text(file, shown, read_);
  if (read_) read_->add(file, std::as_bytes(std::span(text)));
  clean_start(text);
  chunk_files_.push_back(file);
  const std::string chunk = sources_.add(shown);
  if (text.starts_with(LUA_SIGNATURE[0])) {
    throw file_error(shown, "is no text", "compiled Lua is not run");
  }
  if (luaL_loadbufferx(L, text.data(), text.size(), chunk.c_str(), "t") == LUA_OK) return;
  if (lua_type(L, -1) != LUA_TSTRING) lua_error(L);
  std::size_t size = 0;
  const char* message = lua_tolstring(L, -1, &size);
  auto [where, problem] = sources_.split_message({message, size});
  if (where.file.empty()) where.file = shown;
  throw Error(std::move(where), std::string(problem));
}

schema::CallSite Interpreter::site_from(lua_State* L, int& level, lua_Debug& ar) const {
  for (; lua_getstack(L, level, &ar) != 0; ++level) {
    if (lua_getinfo(L, "Sl", &ar) == 0 || ar.currentline <= 0) continue;
    if (auto file = sources_.find(ar.source)) return {std::move(file), ar.currentline};
  }
  return {};
}

schema::CallSite Interpreter::call_site(lua_State* L) const {
  int level = 0;
  lua_Debug ar{};
  return site_from(L, level, ar);
}

schema::CallSite Interpreter::caller_site(lua_State* L) const {
  int level = 0;
  lua_Debug ar{};
  const schema::CallSite innermost = site_from(L, level, ar);
  // What called a file is `require` or the program: nothing to look for there.
  const bool is_function = innermost.location().line > 0 && std::string_view(ar.what) == "Lua";
  return is_function ? site_from(L, ++level, ar) : schema::CallSite();
}

}  // namespace lapidary::lua
