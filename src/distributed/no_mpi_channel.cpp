#include "base/error.h"
#include "distributed/mpi_channel.h"

namespace lapidary::distributed {

bool has_mpi() {
  return false;
}

std::unique_ptr<Channel> start_mpi() {
  throw Error({}, "this lapidary was built without MPI, so its processes cannot share a render",
              "install libopenmpi-dev, configure and build again; or start one process");
}

void give_up_job(int) {}

}  // namespace lapidary::distributed
