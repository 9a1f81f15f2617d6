#include <algorithm>
#include <new>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <string.h>  // memmem

#include "lua/interpreter.h"
#include "lua/libraries.h"
#include "lua/pattern.h"

namespace lapidary::lua {
namespace {

std::string_view check_text(lua_State* L, int index) {
  std::size_t size = 0;
  const char* text = luaL_checklstring(L, index, &size);
  return {text, size};
}

void push(lua_State* L, std::string_view text) {
  lua_pushlstring(L, text.data(), text.size());
}

/// A function that charges the steps of a search.
auto payer(lua_State* L) {
  Budget& budget = Interpreter::of(L).budget();
  return [&budget](std::int64_t steps) { budget.charge(steps); };
}

/// Where a search begins, from an optional argument that counts from 1, or from the end when
/// negative. Nothing when that is behind the end.
std::optional<std::size_t> start_argument(lua_State* L, int index, std::size_t size) {
  const lua_Integer init = luaL_optinteger(L, index, 1);
  const auto length = static_cast<lua_Integer>(size);
  if (init > length + 1) return std::nullopt;
  if (init > 0) return static_cast<std::size_t>(init - 1);
  return init < -length || init == 0 ? 0 : static_cast<std::size_t>(length + init);
}

void push_capture(lua_State* L, std::string_view subject, const Capture& capture) {
  if (capture.is_position) {
    lua_pushinteger(L, static_cast<lua_Integer>(capture.begin + 1));
  } else {
    push(L, subject.substr(capture.begin, capture.end - capture.begin));
  }
}

Capture whole(const Match& match) {
  return {match.begin, match.end};
}

/// Pushes the captures, or the whole match when there are none; returns how many.
int push_captures(lua_State* L, std::string_view subject, const Match& match) {
  luaL_checkstack(L, static_cast<int>(match.captures.size()) + 1, "too many captures");
  if (match.captures.empty()) return push_capture(L, subject, whole(match)), 1;
  for (const Capture& capture : match.captures) push_capture(L, subject, capture);
  return static_cast<int>(match.captures.size());
}

/// Finds `text` itself in time proportional to the lengths.
std::optional<Match> find_plain(lua_State* L, std::string_view subject, std::string_view text,
                                std::size_t from) {
  Interpreter::of(L).budget().charge(static_cast<std::int64_t>((subject.size() - from) / 8));
  const char* found = static_cast<const char*>(
      memmem(subject.data() + from, subject.size() - from, text.data(), text.size()));
  if (!found) return std::nullopt;
  const auto begin = static_cast<std::size_t>(found - subject.data());
  return Match{begin, begin + text.size(), {}};
}

int find(lua_State* L) {
  const std::string_view subject = check_text(L, 1);
  const std::string_view text = check_text(L, 2);
  const auto from = start_argument(L, 3, subject.size());
  const bool plain =
      lua_toboolean(L, 4) != 0 || text.find_first_of("^$*+?.([%-") == std::string_view::npos;
  std::optional<Match> found;
  if (from) {
    found =
        plain ? find_plain(L, subject, text, *from) : Pattern(text).find(subject, *from, payer(L));
  }
  if (!found) return lua_pushnil(L), 1;
  lua_pushinteger(L, static_cast<lua_Integer>(found->begin + 1));
  lua_pushinteger(L, static_cast<lua_Integer>(found->end));
  return 2 + (found->captures.empty() ? 0 : push_captures(L, subject, *found));
}

int match(lua_State* L) {
  const std::string_view subject = check_text(L, 1);
  const Pattern pattern(check_text(L, 2));
  const auto from = start_argument(L, 3, subject.size());
  const auto found = from ? pattern.find(subject, *from, payer(L)) : std::nullopt;
  if (!found) return lua_pushnil(L), 1;
  return push_captures(L, subject, *found);
}

/// What an iteration over matches remembers. The subject is upvalue 2 beside it.
struct Iteration {
  Pattern pattern;
  std::size_t from;
  /// Where the last match ended: an empty one there would be the same again.
  std::optional<std::size_t> last_end;
};

/// The next match of `pattern` that does not end, empty, where the last one ended.
std::optional<Match> next_match(const Pattern& pattern, std::string_view subject, std::size_t from,
                                std::optional<std::size_t> last_end,
                                const std::function<void(std::int64_t)>& pay) {
  while (from <= subject.size()) {
    auto found = pattern.find(subject, from, pay);
    if (!found || found->end != last_end) return found;
    from = found->begin + 1;
  }
  return std::nullopt;
}

int next_in_iteration(lua_State* L) {
  auto& state = *static_cast<Iteration*>(lua_touserdata(L, lua_upvalueindex(1)));
  const std::string_view subject = check_text(L, lua_upvalueindex(2));
  const auto found = next_match(state.pattern, subject, state.from, state.last_end, payer(L));
  if (!found) {
    state.from = subject.size() + 1;
    return lua_pushnil(L), 1;
  }
  state.from = found->end;
  state.last_end = found->end;
  return push_captures(L, subject, *found);
}

int gmatch(lua_State* L) {
  const std::string_view subject = check_text(L, 1);
  Pattern pattern(check_text(L, 2), Pattern::Anchor::literal);
  const std::size_t from = start_argument(L, 3, subject.size()).value_or(subject.size() + 1);
  lua_newtable(L);
  lua_pushcfunction(L, [](lua_State* state) {
    static_cast<Iteration*>(lua_touserdata(state, 1))->~Iteration();
    return 0;
  });
  lua_setfield(L, -2, "__gc");
  // The metatable comes first: nothing may fail between making the iteration and setting it.
  void* place = lua_newuserdatauv(L, sizeof(Iteration), 0);
  new (place) Iteration{std::move(pattern), from, std::nullopt};
  lua_insert(L, -2);
  lua_setmetatable(L, -2);
  lua_pushvalue(L, 1);
  lua_pushcclosure(L, guarded<next_in_iteration>, 2);
  return 1;
}

/// Appends the string at the top of the stack and pops it.
void append_top(lua_State* L, std::string& result) {
  const std::string_view text = check_text(L, -1);
  Interpreter::of(L).budget().check_string(result.size() + text.size());
  result += text;
  lua_pop(L, 1);
}

/// Appends `text` with %0 ... %9 and %% filled in.
void append_template(lua_State* L, std::string_view text, std::string_view subject,
                     const Match& match, std::string& result) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      result += text[i];
      continue;
    }
    const char c = ++i < text.size() ? text[i] : '\0';
    if (c == '%') {
      result += '%';
    } else if (c < '0' || c > '9') {
      throw Error({}, "gsub's replacement has a % that is followed by neither a digit nor %");
    } else {
      const auto index = static_cast<std::size_t>(c - '0');
      const bool all = index == 0 || (index == 1 && match.captures.empty());
      if (!all && index > match.captures.size()) {
        throw Error({}, fmt::format("gsub's replacement uses %{}, which the pattern lacks", index));
      }
      push_capture(L, subject, all ? whole(match) : match.captures[index - 1]);
      append_top(L, result);
    }
  }
}

/// Pushes what a table or function at index 3 says instead of the match.
void push_replacement(lua_State* L, std::string_view subject, const Match& match) {
  if (lua_type(L, 3) == LUA_TFUNCTION) {
    lua_pushvalue(L, 3);
    lua_call(L, push_captures(L, subject, match), 1);
    return;
  }
  push_capture(L, subject, match.captures.empty() ? whole(match) : match.captures.front());
  lua_gettable(L, 3);
}

void append_replacement(lua_State* L, std::string_view subject, const Match& match,
                        std::string& result) {
  const int type = lua_type(L, 3);
  if (type == LUA_TNUMBER || type == LUA_TSTRING) {
    append_template(L, check_text(L, 3), subject, match, result);
    return;
  }
  push_replacement(L, subject, match);
  if (!lua_toboolean(L, -1)) {
    lua_pop(L, 1);
    push_capture(L, subject, whole(match));
  } else if (!lua_isstring(L, -1)) {
    throw Error({}, fmt::format("gsub cannot put a {} into a string", luaL_typename(L, -1)));
  }
  append_top(L, result);
}

int gsub(lua_State* L) {
  const std::string_view subject = check_text(L, 1);
  const Pattern pattern(check_text(L, 2));
  const int type = lua_type(L, 3);
  luaL_argexpected(
      L, type == LUA_TNUMBER || type == LUA_TSTRING || type == LUA_TTABLE || type == LUA_TFUNCTION,
      3, "string/function/table");
  const lua_Integer most = luaL_optinteger(L, 4, static_cast<lua_Integer>(subject.size()) + 1);
  Budget& budget = Interpreter::of(L).budget();
  const auto pay = payer(L);
  std::string result;
  std::size_t copied = 0;
  lua_Integer count = 0;
  std::optional<std::size_t> last_end;
  while (count < most) {
    const auto found = next_match(pattern, subject, copied, last_end, pay);
    if (!found) break;
    ++count;
    result += subject.substr(copied, found->begin - copied);
    append_replacement(L, subject, *found, result);
    budget.check_string(result.size());
    copied = found->end;
    last_end = found->end;
    if (pattern.anchored()) break;
  }
  result += subject.substr(copied);
  budget.charge(static_cast<std::int64_t>(result.size() / 16));
  budget.check_string(result.size());
  push(L, result);
  lua_pushinteger(L, count);
  return 2;
}

/// Upvalue 1: Lua's rep.
int rep(lua_State* L) {
  const std::string_view text = check_text(L, 1);
  const lua_Integer count = luaL_checkinteger(L, 2);
  const std::size_t separator = lua_isnoneornil(L, 3) ? 0 : check_text(L, 3).size();
  if (count > 0) {
    Budget& budget = Interpreter::of(L).budget();
    const double bytes = static_cast<double>(count) * static_cast<double>(text.size() + separator);
    budget.check_string(static_cast<std::size_t>(std::min(bytes, 0x1p60)));
    budget.charge(static_cast<std::int64_t>(bytes / 16) + count / 16);
  }
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, 1);
  return 1;
}

/// Upvalue 1: Lua's format. Values go in as their text without addresses; %p would be one.
int format(lua_State* L) {
  const std::string_view layout = check_text(L, 1);
  for (std::size_t i = layout.find('%'); i != std::string_view::npos; i = layout.find('%', i)) {
    i = layout.find_first_not_of("-+ #0123456789.", i + 1);
    if (i == std::string_view::npos) break;
    if (layout[i] == 'p') throw Error({}, "format has no %p in scenes");
    ++i;
  }
  for (int i = 2; i <= lua_gettop(L); ++i) {
    const int type = lua_type(L, i);
    if (type != LUA_TTABLE && type != LUA_TFUNCTION && type != LUA_TUSERDATA &&
        type != LUA_TTHREAD && type != LUA_TLIGHTUSERDATA) {
      continue;
    }
    push_text(L, i);
    lua_replace(L, i);
  }
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, 1);
  return 1;
}

void set_function(lua_State* L, const char* name, lua_CFunction function) {
  lua_pushcfunction(L, function);
  lua_setfield(L, -2, name);
}

void wrap(lua_State* L, const char* name, lua_CFunction function) {
  lua_getfield(L, -1, name);
  lua_pushcclosure(L, function, 1);
  lua_setfield(L, -2, name);
}

}  // namespace

void open_string(lua_State* L) {
  luaL_requiref(L, LUA_STRLIBNAME, luaopen_string, 1);
  lua_pushnil(L);
  lua_setfield(L, -2, "dump");
  set_function(L, "find", guarded<find>);
  set_function(L, "match", guarded<match>);
  set_function(L, "gmatch", guarded<gmatch>);
  set_function(L, "gsub", guarded<gsub>);
  wrap(L, "rep", guarded<rep>);
  wrap(L, "format", guarded<format>);
  lua_pop(L, 1);
}

}  // namespace lapidary::lua
