#include "app/ranks.h"

#include <map>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/different_picture.h"
#include "app/interrupt.h"
#include "app/outputs.h"
#include "app/resume.h"
#include "distributed/byte_stream.h"
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

View view_of(const render::Origin& origin, const Preparation& preparation) {
  View view{distributed::host_name(), {}};
  view.facts.emplace_back("Lapidary", origin.version);
  for (const auto& [name, text] : origin.settings) view.facts.emplace_back("setting " + name, text);
  for (const auto& [name, text] : origin.parameters) {
    view.facts.emplace_back("parameter " + name, text);
  }
  for (const FileRecord& file : origin.files) {
    view.facts.emplace_back("file " + file.name, "SHA-256 " + file.sha256);
  }
  const film::Film::Settings& film = preparation.film();
  view.facts.emplace_back("layers", film.layers == film::Layers::all ? "all" : "beauty");
  view.facts.emplace_back("size of the scene", fmt::format("{}", film.scene_size));
  const render::PhotonShare share = preparation.renderer().photon_share();
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

/// Makes of the scene what rank 0 makes of it, and works.
void work(distributed::Orders& orders, const RenderCommand& command) {
  const Outputs outputs(outputs_of(command), Outputs::Checkpoints::none);
  WarningLog warnings;  // rank 0 has the same, and tells
  InputFiles files;
  ThreadPool pool(command.threads);
  const Preparation preparation(command, outputs.layers(), warnings, &files, pool);
  const render::Origin origin = origin_of(command, preparation.description(), files);
  orders.channel().send(0, message_of(view_of(origin, preparation)));
  distributed::work(orders, {preparation.renderer(), preparation.film(), pool});
}

}  // namespace

std::string name_of_rank(int rank, const std::string& host) {
  return fmt::format("rank {} on {}", rank, host);
}

void wait_until_ready(distributed::Crew& crew, const render::Origin& origin,
                      const Preparation& preparation) {
  const View here = view_of(origin, preparation);
  for (int missing = crew.ranks() - 1; missing > 0;) {
    const auto received = crew.channel().poll();
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
          name_of_rank(received->from, there.host) + " would render another picture", list,
          "all ranks need the same build of Lapidary, command line and files");
    }
    --missing;
  }
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
