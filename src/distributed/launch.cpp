#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

#include <sched.h>
#include <unistd.h>

#include "distributed/mpi_channel.h"

namespace lapidary::distributed {
namespace {

std::optional<int> number_in_environment(const char* name) {
  const char* text = std::getenv(name);
  if (text == nullptr) return std::nullopt;
  const std::string_view view(text);
  int number = 0;
  const auto [end, problem] = std::from_chars(view.data(), view.data() + view.size(), number);
  const bool is_number = problem == std::errc() && end == view.data() + view.size() && number >= 0;
  return is_number ? std::optional(number) : std::nullopt;
}

}  // namespace

Launch launch_of_environment() {
  // mpirun of Open MPI. It may itself be started by srun, and then this counts.
  if (const auto ranks = number_in_environment("OMPI_COMM_WORLD_SIZE")) {
    return {number_in_environment("OMPI_COMM_WORLD_RANK").value_or(0), *ranks};
  }
  // srun, which says how many tasks this step has; a batch script alone is no step of tasks.
  if (const auto ranks = number_in_environment("SLURM_STEP_NUM_TASKS")) {
    return {number_in_environment("SLURM_PROCID").value_or(0), *ranks};
  }
  // Other launchers that follow PMIx.
  if (const auto rank = number_in_environment("PMIX_RANK")) return {*rank, 0};
  return {};
}

std::optional<BoundProcessors> processors_of_mpirun() {
  const auto ranks_here = number_in_environment("OMPI_COMM_WORLD_LOCAL_SIZE");
  // A batch system has its own reasons.
  if (!ranks_here || std::getenv("SLURM_JOB_ID") != nullptr) return std::nullopt;
  cpu_set_t set;
  if (::sched_getaffinity(0, sizeof set, &set) != 0) return std::nullopt;
  const BoundProcessors bound{CPU_COUNT(&set), static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN))};
  const bool has_share = bound.allowed * *ranks_here >= bound.there;
  return has_share ? std::nullopt : std::optional(bound);
}

std::string host_name() {
  char name[256] = "";
  if (::gethostname(name, sizeof name - 1) != 0) return "unknown";
  return name;
}

}  // namespace lapidary::distributed
