#include "app/ranks.h"

#include <map>
#include <new>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/different_picture.h"
#include "app/interrupt.h"
#include "app/outputs.h"
#include "app/resume.h"
#include "distributed/byte_stream.h"
#include "distributed/file_message.h"
#include "distributed/mpi_channel.h"
#include "distributed/worker.h"

namespace lapidary::app {
namespace {

using distributed::ByteReader;
using distributed::Bytes;
using distributed::ByteWriter;
using distributed::Message;
using distributed::Topic;
using render::NamedTexts;

/// What a rank has made of the scene, as far as the picture depends on it.
struct View {
  std::string host;
  NamedTexts facts;  ///< what is compared, and its name in messages
};

View view_of(const Readiness& ready) {
  const render::Origin& origin = ready.origin;
  View view{distributed::host_name(), {}};
  view.facts.emplace_back("Lapidary", origin.version);
  for (const auto& [name, text] : origin.settings) view.facts.emplace_back("setting " + name, text);
  for (const auto& [name, text] : origin.parameters) {
    view.facts.emplace_back("parameter " + name, text);
  }
  for (const FileRecord& file : origin.files) {
    view.facts.emplace_back("file " + file.name, "SHA-256 " + file.sha256);
  }
  const film::Film::Settings& film = ready.preparation.film();
  view.facts.emplace_back("layers", film.layers == film::Layers::all ? "all" : "beauty");
  view.facts.emplace_back("size of the scene", fmt::format("{}", film.scene_size));
  const render::PhotonShare share = ready.renderer.photon_share();
  view.facts.emplace_back("cost of photons", fmt::format("{}", share.cost));
  view.facts.emplace_back("error of photons", fmt::format("{}", share.error));
  return view;
}

Message message_of(const View& view) {
  ByteWriter writer;
  writer.add(std::string_view(view.host));
  writer.add(std::string_view(render::to_lines(view.facts)));
  return std::move(writer).message(Topic::ready);
}

View read_view(const Bytes& bytes) {
  ByteReader reader(bytes);
  std::string host = reader.take_text();
  return {std::move(host), render::parse_lines(reader.take_text())};
}

/// What is not the same there as here, a line each.
std::vector<std::string> differences(const NamedTexts& here, const NamedTexts& there) {
  std::map<std::string, std::pair<std::string, std::string>> both;
  for (const auto& [name, text] : here) both[name].first += text;
  for (const auto& [name, text] : there) both[name].second += text;
  std::vector<std::string> all;
  const auto shown = [](const std::string& text) { return text.empty() ? "none" : text; };
  for (const auto& [name, texts] : both) {
    if (texts.first == texts.second) continue;
    all.push_back(
        fmt::format("{}: {} there, {} on rank 0", name, shown(texts.second), shown(texts.first)));
  }
  return all;
}

/// The worst that can be said in one line, for rank 0 to tell.
std::string reason(const std::string& problem) {
  return fmt::format("on {}: {}", distributed::host_name(), problem);
}

/// What rank 0 sends of the files; nothing if it ended before that.
std::optional<FileAnswers> receive_files(distributed::Orders& orders) {
  while (!orders.are_over()) {
    const auto order = orders.poll();
    if (!order) {
      distributed::nap(orders.channel());
      continue;
    }
    if (order->topic != Topic::job) ByteReader::fail();
    orders.send_all();
    return distributed::read_file_message(*order->bytes);
  }
  return std::nullopt;
}

/// Makes of the scene what rank 0 makes of it, and works.
void work(distributed::Orders& orders, const RenderCommand& command, InputFiles& files) {
  const Outputs outputs(outputs_of(command), Outputs::Checkpoints::none);
  WarningLog warnings;  // rank 0 has the same, and tells
  ThreadPool pool(command.threads);
  const auto display = make_progress_display(ProgressStyle::none);
  Kept nothing;
  const Preparation preparation(command, outputs.layers(),
                                {warnings, files, nothing, *display, pool});
  files.forget_contents();
  const render::Origin origin = origin_of(command, preparation.description(), files);
  const render::BlockRenderer renderer(preparation.scene(), preparation.samples(),
                                       preparation.picture(), pool);
  orders.channel().send(0, message_of(view_of({origin, preparation, renderer})));
  distributed::work(orders, {renderer, preparation.film(), pool});
}

void work(distributed::Orders& orders, const RenderCommand& command) {
  if (command.has_shared_files) {
    InputFiles files;
    return work(orders, command, files);
  }
  auto answers = receive_files(orders);
  if (!answers) return orders.take_leave();
  InputFiles files(std::move(*answers));
  work(orders, command, files);
}

}  // namespace

void wait_until_ready(distributed::Crew& crew, const Readiness& ready) {
  const View here = view_of(ready);
  for (int missing = crew.ranks() - 1; missing > 0;) {
    const auto received = crew.poll();
    if (!received) {
      distributed::nap(crew.channel());
      continue;
    }
    const Bytes& bytes = *received->message.bytes;
    if (received->message.topic == Topic::failed) {
      throw Error({}, fmt::format("rank {} {}", received->from, ByteReader(bytes).take_text()));
    }
    if (received->message.topic != Topic::ready) ByteReader::fail();
    const View there = read_view(bytes);
    const auto list = differences(here.facts, there.facts);
    if (!list.empty()) {
      throw DifferentPicture(
          fmt::format("rank {} on {} would render another picture", received->from, there.host),
          list, "all ranks need the same build of Lapidary, command line and files");
    }
    --missing;
  }
}

void warn_about_binding(const RenderCommand& command, WarningLog& warnings) {
  const auto bound = distributed::processors_of_mpirun();
  if (!bound || command.threads != 0) return;
  warnings.add({},
               fmt::format("mpirun lets this rank have {} of {} processors; with --bind-to none "
                           "it has all, and --threads says how many to use",
                           bound->allowed, bound->there));
}

ExitCode work_for_rank_0(distributed::Channel& channel, const RenderCommand& command) {
  // Rank 0 says when it is over: a first signal is for that, a second one ends this rank at once.
  const InterruptGuard interrupt;
  distributed::Orders orders(channel);
  try {
    work(orders, command);
  } catch (const std::bad_alloc&) {
    distributed::fail(orders, reason("there is not enough memory"));
  } catch (const std::exception& error) {
    distributed::fail(orders, reason(error.what()));
  }
  return ExitCode::done;
}

}  // namespace lapidary::app
