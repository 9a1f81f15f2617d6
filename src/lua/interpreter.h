#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/input_files.h"
#include "base/log.h"
#include "lua/budget.h"
#include "lua/errors.h"
#include "lua/folder_guard.h"
#include "lua/limits.h"
#include "lua/lua_api.h"
#include "lua/source_files.h"
#include "schema/call_site.h"
#include "schema/value.h"

namespace lapidary::lua {

/// A sandboxed Lua with the limits and files of one scene. The library functions that scenes call
/// find it through their lua_State.
class Interpreter {
 public:
  /// `read` notes the files that are read as Lua; it may be null.
  Interpreter(const Limits& limits, FolderGuard files, std::function<void(std::string_view)> print,
              InputFiles* read);
  ~Interpreter();
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;

  static Interpreter& of(lua_State* L) {
    return **static_cast<Interpreter**>(lua_getextraspace(L));
  }

  lua_State* state() { return L_; }
  Budget& budget() { return budget_; }
  SourceFiles& sources() { return sources_; }
  const SourceFiles& sources() const { return sources_; }
  const FolderGuard& files() const { return files_; }
  schema::ValueArena& arena() { return arena_; }
  void print(std::string_view line) const {
    if (print_) print_(line);
  }

  /// Runs `work` with the stack of this Lua; whatever Lua error comes out is thrown as an Error.
  void run(const std::function<void(lua_State*)>& work);

  /// Pushes the compiled text of `file`, shown to users as `shown`. Raises Lua errors.
  void push_chunk(lua_State* L, const std::filesystem::path& file, const std::string& shown);

  /// The line of the innermost function of the scene.
  schema::CallSite call_site(lua_State* L) const;

  /// The line that called the innermost function of the scene; unknown where that is the file
  /// itself, or where Lua no longer remembers.
  schema::CallSite caller_site(lua_State* L) const;

  /// Modules whose chunk runs at this moment, the innermost last.
  std::vector<std::filesystem::path>& modules_being_read() { return modules_being_read_; }

  /// Files that were read as Lua, in order.
  const std::vector<std::filesystem::path>& chunk_files() const { return chunk_files_; }

 private:
  [[noreturn]] void rethrow(int status);
  /// The line where the innermost function of the scene stands, not counting those of a lower
  /// `level` of the stack; `ar` tells about that function and `level` is its own.
  schema::CallSite site_from(lua_State* L, int& level, lua_Debug& ar) const;

  Budget budget_;
  SourceFiles sources_;
  FolderGuard files_;
  std::function<void(std::string_view)> print_;
  InputFiles* read_;
  schema::ValueArena arena_;
  std::vector<std::filesystem::path> chunk_files_;
  std::vector<std::filesystem::path> modules_being_read_;
  lua_State* L_ = nullptr;
};

}  // namespace lapidary::lua
