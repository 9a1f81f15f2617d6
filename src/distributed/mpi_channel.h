#pragma once

#include <memory>
#include <optional>
#include <string>

#include "distributed/channel.h"

namespace lapidary::distributed {

/// What a launcher of MPI programs told this process through its environment, before MPI is asked,
/// which takes a second.
struct Launch {
  int rank = 0;
  int ranks = 1;  ///< that were started; 0: it did not say
};
/// A launch of 1 where there is no launcher.
Launch launch_of_environment();

/// Processors that Open MPI's mpirun has bound this rank to, where these are fewer than its share
/// of the machine's. Other launchers know what they are asked for: nothing.
struct BoundProcessors {
  int allowed = 0;
  int there = 0;
};
std::optional<BoundProcessors> processors_of_mpirun();

/// Whether this build can talk MPI.
bool has_mpi();

/// Starts MPI: one channel in the life of a process, whose destructor ends MPI once all that was
/// sent is gone. Only the calling thread may use it. Throws Error where this build has no MPI, or
/// MPI knows of fewer processes than were started.
std::unique_ptr<Channel> start_mpi();

/// The machine that this process runs on.
std::string host_name();

/// Ends all processes of the job at once, where an orderly end is not possible any more.
/// Precondition: `start_mpi`.
void give_up_job(int exit_code);

}  // namespace lapidary::distributed
