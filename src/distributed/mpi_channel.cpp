// The only file that includes MPI's header.
#include "distributed/mpi_channel.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <list>
#include <utility>

#include <fmt/format.h>
#include <mpi.h>

#include "base/error.h"

namespace lapidary::distributed {
namespace {

/// Tags of MPI: what is to come, and then its bytes.
enum Tag { announcement_tag = 1, bytes_tag = 2 };

/// MPI counts with int.
constexpr std::size_t largest_piece = std::size_t{1} << 30;

/// Topic and number of bytes.
using Announcement = std::array<std::uint64_t, 2>;

/// Calls `work(begin, size)` for pieces that MPI can carry.
template <typename Work>
void for_each_piece(std::size_t bytes, const Work& work) {
  for (std::size_t begin = 0; begin < bytes; begin += largest_piece) {
    work(begin, static_cast<int>(std::min(largest_piece, bytes - begin)));
  }
}

bool are_done(std::vector<MPI_Request>& requests) {
  int done = 0;
  MPI_Testall(static_cast<int>(requests.size()), requests.data(), &done, MPI_STATUSES_IGNORE);
  return done != 0;
}

using Clock = std::chrono::steady_clock;

/// Messages over MPI_COMM_WORLD. One is received at a time: the others' bytes stay where they are
/// until there is room for them here.
class MpiChannel : public Channel {
 public:
  MpiChannel() {
    int threads = MPI_THREAD_SINGLE;
    // Errors of MPI end the job, which is its default.
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &threads);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
    has_threads_ = threads >= MPI_THREAD_FUNNELED;
  }
  ~MpiChannel() override {
    while (is_busy()) {
      poll();
      nap(*this);
    }
    MPI_Finalize();
  }
  MpiChannel(const MpiChannel&) = delete;
  MpiChannel& operator=(const MpiChannel&) = delete;

  int rank() const override { return rank_; }
  int ranks() const override { return ranks_; }
  bool has_threads() const { return has_threads_; }

  void send(int to, Message message) override {
    Sending& sending = sending_.emplace_back();
    sending.bytes = message.bytes ? std::move(message.bytes) : std::make_shared<const Bytes>();
    sending.announcement = {static_cast<std::uint64_t>(message.topic), sending.bytes->size()};
    MPI_Isend(sending.announcement.data(), 2, MPI_UINT64_T, to, announcement_tag, MPI_COMM_WORLD,
              &sending.requests.emplace_back());
    for_each_piece(sending.bytes->size(), [&](std::size_t begin, int size) {
      MPI_Isend(sending.bytes->data() + begin, size, MPI_BYTE, to, bytes_tag, MPI_COMM_WORLD,
                &sending.requests.emplace_back());
    });
  }

  std::optional<Received> poll() override {
    sending_.remove_if([](Sending& sending) { return are_done(sending.requests); });
    if (!receiving_ && !begin_to_receive()) return std::nullopt;
    if (!are_done(receiving_->requests)) return std::nullopt;
    Receiving done = std::move(*receiving_);
    receiving_.reset();
    const std::chrono::duration<double> seconds = Clock::now() - done.begin;
    return Received{done.from, {done.topic, std::move(done.bytes)}, seconds.count()};
  }

  bool is_busy() const override { return receiving_ || !sending_.empty(); }

 private:
  struct Sending {
    Announcement announcement{};
    std::shared_ptr<const Bytes> bytes;
    std::vector<MPI_Request> requests;
  };
  struct Receiving {
    int from = 0;
    Topic topic = Topic::end;
    std::shared_ptr<Bytes> bytes;
    std::vector<MPI_Request> requests;
    Clock::time_point begin = Clock::now();
  };

  bool begin_to_receive() {
    int is_there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, announcement_tag, MPI_COMM_WORLD, &is_there, &status);
    if (is_there == 0) return false;
    const int from = status.MPI_SOURCE;
    Announcement announcement{};
    MPI_Recv(announcement.data(), 2, MPI_UINT64_T, from, announcement_tag, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    if (announcement[0] >= topics) {
      throw Error({}, fmt::format("rank {} talks otherwise than this one", from),
                  "do all of them run the same build of Lapidary?");
    }
    const auto bytes = static_cast<std::size_t>(announcement[1]);
    receiving_ = {from, static_cast<Topic>(announcement[0]), std::make_shared<Bytes>(bytes), {}};
    for_each_piece(bytes, [&](std::size_t begin, int size) {
      MPI_Irecv(receiving_->bytes->data() + begin, size, MPI_BYTE, from, bytes_tag, MPI_COMM_WORLD,
                &receiving_->requests.emplace_back());
    });
    return true;
  }

  int rank_ = 0;
  int ranks_ = 1;
  bool has_threads_ = false;
  std::list<Sending> sending_;  // each stays where it is until it is sent
  std::optional<Receiving> receiving_;
};

}  // namespace

bool has_mpi() {
  return true;
}

std::unique_ptr<Channel> start_mpi() {
  auto channel = std::make_unique<MpiChannel>();
  if (!channel->has_threads()) {
    throw Error({}, "this MPI does not let programs have threads",
                "build one that does, or render with one process");
  }
  const int started = launch_of_environment().ranks;
  if (channel->ranks() < started) {
    throw Error(
        {},
        fmt::format("{} processes were started, and MPI knows of {}", started, channel->ranks()),
        "start them with mpirun, or with srun --mpi=pmix");
  }
  return channel;
}

void give_up_job(int exit_code) {
  MPI_Abort(MPI_COMM_WORLD, exit_code);
}

}  // namespace lapidary::distributed
