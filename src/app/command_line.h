#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "image/compare.h"
#include "import/mesh_file.h"
#include "math/vec.h"

namespace lapidary::app {

/// NAME=VALUE as written on the command line; the value is not interpreted here.
struct Assignment {
  std::string name;
  std::string value;

  bool operator==(const Assignment&) const = default;
};

/// Where a scene comes from, and what the command line says about it.
struct SceneArguments {
  std::string file;
  std::vector<Assignment> parameters;        ///< --set: for param() in the scene
  std::vector<std::string> allowed_folders;  ///< --allow
  std::optional<import::UpAxis> up;          ///< --up, of a bare mesh; none: the format's own
  std::optional<int> frame;                  ///< --frame, or one of --frames; none: no animation
  double fps = 24;                           ///< --fps: frames for each second of scene time
};

enum class ProgressStyle { automatic, bar, lines, json, none };

/// --blocks A-B: both are rendered; the first block is 1.
struct BlockNumbers {
  std::uint32_t first = 1;
  std::uint32_t last = 1;
};

/// --frames A-B: both are rendered.
struct FrameNumbers {
  int first = 1;
  int last = 1;
};

/// lapidary render
struct RenderCommand {
  SceneArguments scene;
  std::vector<Assignment> settings;  ///< --render and its short forms, in the order written
  std::vector<std::string> outputs;  ///< empty: the scene's name with .png
  int threads = 0;                   ///< 0: all
  std::string stats_file;            ///< empty: none
  std::string preview_file;          ///< --preview; empty: none
  ProgressStyle progress = ProgressStyle::automatic;
  /// --checkpoint; 0: never; none: each minute, or more seldom where that costs too much.
  std::optional<double> checkpoint_seconds;
  bool resumes = false;                ///< --resume
  std::optional<BlockNumbers> blocks;  ///< --blocks
  std::string plan_file;               ///< --plan, with --blocks; empty: none
  std::optional<FrameNumbers> frames;  ///< --frames
  /// --shared-files: of several ranks each reads the scene's files, not the first one for all.
  bool has_shared_files = false;
};

/// lapidary merge
struct MergeCommand {
  std::vector<std::string> parts;
  std::vector<std::string> outputs;
};

/// lapidary bake
struct BakeCommand {
  enum class Light { all, indirect, caustics };
  enum class Format { exr, png, hdr };

  SceneArguments scene;
  std::vector<Assignment> settings;  ///< as RenderCommand's
  std::string folder;                ///< empty: the scene's name with _maps
  Light light = Light::all;
  Format format = Format::exr;
  int threads = 0;  ///< 0: all
  bool is_quiet = false;
};

/// lapidary check
struct CheckCommand {
  SceneArguments scene;
};

/// lapidary probe
struct ProbeCommand {
  /// Six numbers as the user wrote them: origin and direction.
  struct Ray {
    Vec3d origin, direction;
  };
  SceneArguments scene;
  std::optional<Ray> ray;  ///< --ray
  std::string rays_file;   ///< --rays; either the one or the other is given
};

/// lapidary compare
struct CompareCommand {
  std::string image;
  std::string reference;
  image::CompareOptions options;
};

/// lapidary help
struct HelpCommand {
  std::string topic;  ///< a node or a verb; empty: all of them in short
};

/// The answer is a text: VERB --help, --version.
struct ShowText {
  std::string text;
};

using Command = std::variant<RenderCommand, MergeCommand, BakeCommand, CheckCommand, ProbeCommand,
                             CompareCommand, HelpCommand, ShowText>;

/// The command line makes no sense.
class UsageError : public std::runtime_error {
 public:
  explicit UsageError(const std::string& problem, std::string hint = "")
      : std::runtime_error(problem), hint_(std::move(hint)) {}

  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// Reads the arguments that follow the program's name. Throws UsageError.
Command parse_command_line(std::vector<std::string> arguments);

/// What `lapidary VERB --help` shows; nothing where there is no such verb.
std::optional<std::string> help_of_verb(const std::string& verb);

/// The program in a few lines: its verbs and exit codes.
std::string usage();

}  // namespace lapidary::app
