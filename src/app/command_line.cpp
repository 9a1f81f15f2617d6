#include "app/command_line.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/ranges.h>

#include "app/ray_text.h"
#include "schema/suggest.h"

namespace lapidary::app {
namespace {

using Strings = std::vector<std::string>;

/// The whole of `text` as a number, or nothing.
template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

template <typename Number>
Number number_in(std::string_view flag, std::string_view text, Number least, Number most) {
  const auto value = parse_number<Number>(text);
  if (!value || !(*value >= least && *value <= most)) {
    throw UsageError(
        fmt::format("{} takes a number from {} to {}, not '{}'", flag, least, most, text));
  }
  return *value;
}

Assignment parse_assignment(std::string_view flag, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError(fmt::format("{} takes NAME=VALUE, not '{}'", flag, text));
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

image::Crop parse_crop(std::string_view text) {
  std::array<int, 4> numbers{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t comma = rest.find(',');
    const auto number = parse_number<int>(rest.substr(0, comma));
    const bool is_last = i + 1 == numbers.size();
    if (!number || is_last != (comma == std::string_view::npos)) {
      throw UsageError(fmt::format("--crop takes X,Y,WIDTH,HEIGHT, not '{}'", text));
    }
    numbers[i] = *number;
    if (!is_last) rest.remove_prefix(comma + 1);
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

BlockNumbers parse_blocks(std::string_view text) {
  constexpr std::uint32_t most = 1 << 22;
  const std::size_t dash = text.find('-');
  const auto first = parse_number<std::uint32_t>(text.substr(0, dash));
  const auto last =
      dash == std::string_view::npos ? first : parse_number<std::uint32_t>(text.substr(dash + 1));
  if (!first || !last || *first < 1 || *last < *first || *last > most) {
    throw UsageError(fmt::format("--blocks takes A-B with 1 <= A <= B <= {}, not '{}'", most, text),
                     "both are rendered: 1-4 is four blocks");
  }
  return {*first, *last};
}

FrameNumbers parse_frames(std::string_view text) {
  constexpr int most = 9'999'999;
  const std::size_t dash = text.find('-');
  const auto first = parse_number<int>(text.substr(0, dash));
  const auto last =
      dash == std::string_view::npos ? first : parse_number<int>(text.substr(dash + 1));
  if (!first || !last || *first < 0 || *last < *first || *last > most) {
    throw UsageError(fmt::format("--frames takes A-B with 0 <= A <= B <= {}, not '{}'", most, text),
                     "both are rendered: 1-240 is ten seconds at 24 frames a second");
  }
  return {*first, *last};
}

/// An option whose text goes to `take`; given twice, the last one counts.
CLI::Option* add_text(CLI::App& verb, const std::string& flag, const std::string& type,
                      const std::string& help, std::function<void(const std::string&)> take) {
  return verb.add_option_function<std::string>(flag, std::move(take), help)
      ->type_name(type)
      ->take_last();
}

/// An option that may be given many times, each time with one text, which goes to `take`.
void add_texts(CLI::App& verb, const std::string& flag, const std::string& type,
               const std::string& help, std::function<void(const std::string&)> take) {
  verb.add_option_function<Strings>(
          flag, [take](const Strings& texts) { std::ranges::for_each(texts, take); }, help)
      ->type_name(type)
      ->allow_extra_args(false);
}

/// An option that takes one of a few words.
template <typename Value>
void add_choice(CLI::App& verb, const std::string& flag, Value& value,
                const std::vector<std::pair<std::string, Value>>& choices,
                const std::string& help) {
  Strings words;
  for (const auto& [word, meaning] : choices) words.push_back(word);
  const auto take = [flag, words, choices, &value](const std::string& text) {
    const auto found = std::ranges::find(words, text);
    if (found == words.end()) {
      throw UsageError(
          fmt::format("{} takes one of {}, not '{}'", flag, fmt::join(words, ", "), text));
    }
    value = choices[static_cast<std::size_t>(found - words.begin())].second;
  };
  add_text(verb, flag, fmt::format("{}", fmt::join(words, "|")), help, take);
}

void add_scene(CLI::App& verb, SceneArguments& scene) {
  verb.add_option("SCENE", scene.file, "a scene (.lua) or a mesh (.obj)")
      ->required()
      ->type_name("");
  add_texts(verb, "--set", "NAME=VALUE", "what param(\"NAME\") is in the scene",
            [&](const std::string& text) {
              scene.parameters.push_back(parse_assignment("--set", text));
            });
  add_texts(verb, "--allow", "DIR", "a folder the scene may read beside its own",
            [&](const std::string& text) { scene.allowed_folders.push_back(text); });
  const std::vector<std::pair<std::string, std::optional<import::UpAxis>>> axes = {
      {"y", import::UpAxis::y}, {"z", import::UpAxis::z}};
  add_choice(verb, "--up", scene.up, axes, "the axis of a bare mesh that points up (y for .obj)");
  add_text(
      verb, "--frame", "N", "a frame of an animation: `frame` in the scene, #### in names",
      [&](const std::string& text) { scene.frame = number_in("--frame", text, 0, 9'999'999); });
  add_text(verb, "--fps", "R", "frames a second: `time` is (frame - 1) / R (24)",
           [&](const std::string& text) { scene.fps = number_in("--fps", text, 1e-3, 1e6); });
}

/// `--FLAG VALUE` as another way to say `--render KEY=VALUE`; values are checked where those are.
struct Setting {
  std::string flag, key, type, help;
};
void add_setting(CLI::App& verb, std::vector<Assignment>& settings, const Setting& setting) {
  const auto take = [&settings, key = setting.key](const std::string& text) {
    settings.push_back({key, text});
  };
  add_text(verb, "--" + setting.flag, setting.type, setting.help, take);
}
void add_setting(CLI::App& verb, const std::string& key, std::vector<Assignment>& settings,
                 const std::string& type, const std::string& help) {
  add_setting(verb, settings, {key, key, type, help});
}

void add_settings(CLI::App& verb, std::vector<Assignment>& settings) {
  add_texts(
      verb, "--render", "KEY=VALUE", "any key of the scene's tables: see help render, help film",
      [&](const std::string& text) { settings.push_back(parse_assignment("--render", text)); });
  add_setting(verb, "size", settings, "WxH", "pixels of the picture");
  add_setting(verb, "samples", settings, "N",
              "stop after N samples per pixel; noisy ones take more");
  add_setting(verb, "time", settings, "SECONDS", "stop after so much wall time");
  add_setting(verb, "noise", settings, "E", "stop at this relative error");
  add_setting(verb, "integrator", settings, "path|direct|illumination",
              "everything, direct light only, or the rest from maps");
  add_setting(verb, "seed", settings, "N", "another seed gives another noise");
}

void declare(CLI::App& verb, RenderCommand& command) {
  add_scene(verb, command.scene);
  add_texts(verb, "-o", "FILE",
            "a picture to write: .png, .exr, .jpg, .hdr; may be repeated (SCENE.png)",
            [&](const std::string& text) { command.outputs.push_back(text); });
  add_settings(verb, command.settings);
  add_text(verb, "--threads", "N", "threads to render with (all)", [&](const std::string& text) {
    command.threads = number_in("--threads", text, 1, 1024);
  });
  add_text(verb, "--stats", "FILE", "write what was done and what it took, as JSON",
           [&](const std::string& text) { command.stats_file = text; });
  add_text(verb, "--checkpoint", "SECONDS",
           "write a checkpoint so often; 0: never (60, or 50 times what one takes)",
           [&](const std::string& text) {
             command.checkpoint_seconds = number_in("--checkpoint", text, 0.0, 1e9);
           });
  verb.add_flag_callback(
      "--resume", [&] { command.resumes = true; },
      "go on from the checkpoint of the picture, if there is one");
  add_text(verb, "--frames", "A-B", "these frames one after the other: -o NAME_####.png",
           [&](const std::string& text) { command.frames = parse_frames(text); });
  add_text(verb, "--blocks", "A-B", "only these blocks of passes, from 1; `merge` adds them",
           [&](const std::string& text) { command.blocks = parse_blocks(text); });
  add_text(verb, "--plan", "FILE",
           "the picture with the checkpoint whose adaptive sampling --blocks follow",
           [&](const std::string& text) { command.plan_file = text; });
  verb.add_flag_callback(
      "--shared-files", [&] { command.has_shared_files = true; },
      "under mpirun: each rank reads the scene itself, not the first for all");
  const std::vector<std::pair<std::string, ProgressStyle>> styles = {
      {"bar", ProgressStyle::bar}, {"lines", ProgressStyle::lines}, {"json", ProgressStyle::json}};
  add_choice(verb, "--progress", command.progress, styles,
             "how to show progress (bar on a terminal); json: all messages, too");
  add_text(verb, "--preview", "FILE", "a picture of what there is, each few seconds (.png, ...)",
           [&](const std::string& text) { command.preview_file = text; });
  verb.add_flag_callback(
      "--quiet", [&] { command.progress = ProgressStyle::none; }, "warnings and errors only");
}

void declare(CLI::App& verb, MergeCommand& command) {
  verb.add_option("PART", command.parts, "pictures with checkpoints, of --blocks or whole (.exr)")
      ->required()
      ->type_name("");
  add_texts(verb, "-o", "FILE", "the picture of all: .png, .exr, .jpg, .hdr; may be repeated",
            [&](const std::string& text) { command.outputs.push_back(text); });
}

void declare(CLI::App& verb, BakeCommand& command) {
  using Light = BakeCommand::Light;
  using Format = BakeCommand::Format;
  add_scene(verb, command.scene);
  add_text(verb, "-o", "DIR",
           "the folder for the maps and index.json (the scene's name with _maps)",
           [&](const std::string& text) { command.folder = text; });
  const std::vector<std::pair<std::string, Light>> lights = {
      {"all", Light::all}, {"indirect", Light::indirect}, {"caustics", Light::caustics}};
  add_choice(verb, "--light", command.light, lights,
             "which light: all, what was scattered, or focused light alone (all)");
  const std::vector<std::pair<std::string, Format>> formats = {
      {"exr", Format::exr}, {"png", Format::png}, {"hdr", Format::hdr}};
  add_choice(verb, "--format", command.format, formats,
             "linear .exr or .hdr, or .png as a display shows it (exr)");
  add_setting(verb, command.settings, {"photons", "map_photons", "N", "photons to send"});
  add_setting(verb, command.settings,
              {"radius", "map_radius", "R", "how far to blur, in scene units"});
  add_setting(verb, command.settings,
              {"filter", "map_filter", "gaussian|box", "blurs to circles, or crosses"});
  add_setting(verb, command.settings,
              {"resolution", "map_resolution", "N", "texels per scene unit"});
  add_setting(verb, "seed", command.settings, "N", "another seed gives another noise");
  add_texts(verb, "--render", "KEY=VALUE", "any other key of the scene's tables",
            [&](const std::string& text) {
              command.settings.push_back(parse_assignment("--render", text));
            });
  add_text(verb, "--threads", "N", "threads to work with (all)", [&](const std::string& text) {
    command.threads = number_in("--threads", text, 1, 1024);
  });
  verb.add_flag_callback(
      "--quiet", [&] { command.is_quiet = true; }, "warnings and errors only");
}

void declare(CLI::App& verb, CheckCommand& command) {
  add_scene(verb, command.scene);
}

void declare(CLI::App& verb, ProbeCommand& command) {
  add_scene(verb, command.scene);
  add_text(verb, "--ray", "OX,OY,OZ,DX,DY,DZ", "a ray: where it starts, and its direction",
           [&](const std::string& text) {
             try {
               command.ray = parse_ray(text);
             } catch (const std::invalid_argument& problem) {
               throw UsageError(fmt::format("--ray {}, not '{}'", problem.what(), text));
             }
           });
  add_text(verb, "--rays", "FILE", "the same for many rays, one a line",
           [&](const std::string& text) { command.rays_file = text; });
}

void declare(CLI::App& verb, CompareCommand& command) {
  verb.add_option("IMAGE", command.image, "the picture to judge")->required()->type_name("");
  verb.add_option("REFERENCE", command.reference, "what it should be")->required()->type_name("");
  using image::Metric;
  const std::vector<std::pair<std::string, Metric>> metrics = {{"relmse", Metric::relmse},
                                                               {"mse", Metric::mse},
                                                               {"mae", Metric::mae},
                                                               {"energy", Metric::energy},
                                                               {"flip", Metric::flip}};
  image::CompareOptions& options = command.options;
  add_choice(verb, "--metric", options.metric, metrics, "which difference (relmse)");
  add_text(verb, "--trim", "SHARE", "leave out this share of the worst pixels",
           [&](const std::string& text) { options.trim = number_in("--trim", text, 0.0, 0.999); });
  add_text(verb, "--crop", "X,Y,W,H", "compare this rectangle only",
           [&](const std::string& text) { options.crop = parse_crop(text); });
}

void declare(CLI::App& verb, HelpCommand& command) {
  verb.add_option("NODE", command.topic, "a node of the scene language, or a verb")->type_name("");
}

UsageError unexpected_argument(const std::string& argument, const CLI::App& verb,
                               const std::string& hint) {
  if (argument[0] != '-')
    return UsageError(fmt::format("unexpected argument '{}'", argument), hint);
  Strings names;
  for (const CLI::Option* option : verb.get_options()) names.push_back(option->get_name());
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const std::string suggestion = schema::did_you_mean(argument, candidates);
  return UsageError(fmt::format("unknown option '{}'", argument),
                    suggestion.empty() ? hint : suggestion);
}

/// CLI11's complaints in our words.
UsageError usage_error(const CLI::ParseError& error, const CLI::App& verb) {
  const std::string hint = fmt::format("{} --help lists what there is", verb.get_name());
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    const Strings extras = verb.remaining();
    return unexpected_argument(extras.empty() ? "" : extras.front(), verb, hint);
  }
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    std::string what = error.what();
    what.resize(what.find(' '));
    return UsageError(fmt::format("{} is missing", what), hint);
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    const std::string_view what = error.what();
    return UsageError(fmt::format("{} needs a value", what.substr(0, what.find(':'))), hint);
  }
  return UsageError(error.what(), hint);
}

/// Of most commands any options go together.
template <typename Kind>
void check_together(const Kind&) {}

void check_together(const ProbeCommand& command) {
  if (command.ray.has_value() == command.rays_file.empty()) return;
  throw UsageError(command.ray ? "--ray and --rays do not go together" : "a ray is missing",
                   "--ray 0,0,5,0,0,-1 goes down the z axis; --rays FILE reads one from each line");
}

/// Frames must not overwrite one another.
void check_frames(const RenderCommand& command) {
  if (!command.frames) return;
  if (command.scene.frame) {
    throw UsageError("--frame and --frames do not go together",
                     "--frame is one of them, --frames A-B are several");
  }
  const auto check = [](const char* option, const std::string& name) {
    if (name.find('#') != std::string::npos) return;
    throw UsageError(fmt::format("{} {} would be written for each frame", option, name),
                     "put #### where the number of the frame goes: frame_####.png");
  };
  if (command.outputs.empty()) {
    throw UsageError("--frames needs names for the pictures", "-o frame_####.png, for example");
  }
  for (const std::string& output : command.outputs) check("-o", output);
  if (!command.stats_file.empty()) check("--stats", command.stats_file);
}

void check_together(const RenderCommand& command) {
  check_frames(command);
  if (!command.plan_file.empty() && !command.blocks) {
    throw UsageError("--plan is for --blocks",
                     "--resume goes on with a picture; --blocks A-B renders a part");
  }
  if (command.checkpoint_seconds == 0.0 && (command.resumes || command.blocks)) {
    throw UsageError(fmt::format("{} and --checkpoint 0 do not go together",
                                 command.blocks ? "--blocks" : "--resume"),
                     "it lives on checkpoints");
  }
  if (!command.blocks) return;
  for (const Assignment& setting : command.settings) {
    if (setting.name == "samples" || setting.name == "time" || setting.name == "noise") {
      throw UsageError(fmt::format("--blocks and --{} do not go together", setting.name),
                       "the last block says when to stop");
    }
  }
}

void check_together(const MergeCommand& command) {
  if (command.outputs.empty()) {
    throw UsageError("-o is missing", "-o whole.exr names the picture to write");
  }
}

struct Verb {
  std::string name;
  std::string summary;
  Command (*parse)(const Verb& verb, Strings arguments);
};

template <typename Kind>
Command parse_as(const Verb& verb, Strings arguments) {
  CLI::App app{verb.summary, "lapidary " + verb.name};
  app.set_help_flag("-h,--help", "print this");
  app.get_formatter()->label("REQUIRED", "");
  app.get_formatter()->label("Positionals", "Arguments");
  Kind command;
  declare(app, command);
  std::ranges::reverse(arguments);  // CLI11 reads a vector from its end
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::CallForHelp&) {
    return ShowText{app.help()};
  } catch (const CLI::ParseError& error) {
    throw usage_error(error, app);
  }
  check_together(command);
  return command;
}

const std::array<Verb, 7>& verbs() {
  static const std::array<Verb, 7> all = {{
      {"render", "make a picture of a scene or a mesh", parse_as<RenderCommand>},
      {"merge", "add parts that --blocks rendered to one picture", parse_as<MergeCommand>},
      {"bake", "write the light on every surface as images", parse_as<BakeCommand>},
      {"check", "say what a scene holds and what is wrong with it", parse_as<CheckCommand>},
      {"probe", "list every surface along a ray, as JSON", parse_as<ProbeCommand>},
      {"compare", "print how far a picture is from a reference", parse_as<CompareCommand>},
      {"help", "explain the nodes of the scene language", parse_as<HelpCommand>},
  }};
  return all;
}

const Verb* find_verb(std::string_view name) {
  const auto found = std::ranges::find(verbs(), name, &Verb::name);
  return found == verbs().end() ? nullptr : &*found;
}

UsageError unknown_verb(const std::string& name) {
  if (name.starts_with('-')) {
    return UsageError(fmt::format("unknown option '{}'", name),
                      "without a verb there are --help and --version");
  }
  if (name.find('.') != std::string::npos) {
    return UsageError(fmt::format("unknown verb '{}'", name),
                      fmt::format("did you mean: lapidary render {}", name));
  }
  std::vector<std::string_view> names;
  for (const Verb& verb : verbs()) names.push_back(verb.name);
  const std::string suggestion = schema::did_you_mean(name, names);
  return UsageError(fmt::format("unknown verb '{}'", name),
                    suggestion.empty()
                        ? "the verbs are render, merge, bake, check, probe, compare and help"
                        : suggestion);
}

}  // namespace

Command parse_command_line(std::vector<std::string> arguments) {
  if (arguments.empty()) throw UsageError("a verb is missing", "try: lapidary help");
  const std::string name = arguments.front();
  arguments.erase(arguments.begin());
  if (name == "--version") return ShowText{"lapidary " LAPIDARY_VERSION "\n"};
  if (name == "--help" || name == "-h") return HelpCommand{};
  const Verb* verb = find_verb(name);
  if (verb == nullptr) throw unknown_verb(name);
  return verb->parse(*verb, std::move(arguments));
}

std::optional<std::string> help_of_verb(const std::string& name) {
  const Verb* verb = find_verb(name);
  if (verb == nullptr) return std::nullopt;
  return std::get<ShowText>(verb->parse(*verb, {"--help"})).text;
}

std::string usage() {
  std::string text =
      "Lapidary renders solids and light: scenes in Lua, or bare meshes.\n\n"
      "usage: lapidary VERB ...\n\n";
  for (const Verb& verb : verbs()) text += fmt::format("  {:<10}{}\n", verb.name, verb.summary);
  text +=
      "\n`lapidary help VERB` lists the options of a verb.\n"
      "Exit codes: 0 done, 1 internal error, 2 wrong usage, 3 the scene or a file is\n"
      "wrong, 4 interrupted, with the picture so far written, 5 checkpoints are of\n"
      "another picture than what is to go on or be merged.\n";
  return text;
}

}  // namespace lapidary::app
