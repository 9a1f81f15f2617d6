#include "image/output_file.h"

#include <atomic>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace lapidary::image {
namespace {

namespace fs = std::filesystem;

/// Another one at every call, short, so that it fits whatever the length of the final name.
fs::path temporary_name() {
  static std::atomic<unsigned> counter{0};
  return fmt::format(".lapidary-{}-{}.part", ::getpid(), counter++);
}

/// Calls `make(name)` with names in the folder until one is free: processes of other machines and
/// containers may have the same number, and one that was killed may have left its file.
template <typename Make>
fs::path make_temporary(const fs::path& folder, const Make& make) {
  constexpr int most_tries = 10'000;
  for (int i = 0; i < most_tries; ++i) {
    const fs::path name = folder / temporary_name();
    if (make(name)) return name;
    if (errno != EEXIST) break;
  }
  return {};
}

/// Refuses what `rename` would replace although nobody can want that.
void check_target(const fs::path& path, const fs::path& target) {
  std::error_code ignored;
  const fs::file_status status = fs::status(target, ignored);
  if (fs::is_directory(status)) throw file_error(path.string(), "is a folder, not a file");
  if (!fs::exists(status)) return;
  if (!fs::is_regular_file(status)) {
    throw file_error(path.string(), "is not a regular file, so it cannot be replaced");
  }
  if (::access(target.c_str(), W_OK) != 0) {
    throw file_error(path.string(), "exists and is write-protected",
                     "choose another name or allow writing to it");
  }
}

fs::path folder_of(const fs::path& target) {
  return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

void check_folder(const fs::path& path, const fs::path& folder) {
  std::error_code ignored;
  const fs::file_status status = fs::status(folder, ignored);
  if (!fs::exists(status)) {
    throw file_error(path.string(), fmt::format("there is no folder '{}'", folder.string()),
                     "make the folder first");
  }
  if (!fs::is_directory(status)) {
    throw file_error(path.string(), fmt::format("'{}' is not a folder", folder.string()));
  }
}

/// A file without a name, which is gone if the process ends however it ends; below 0 where the
/// system or the file system has none.
int open_nameless(const fs::path& folder) {
  if (::access("/proc/self/fd", F_OK) != 0) return -1;  // where it could not be given a name later
  return ::open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
}

/// Writes the folder's new entry to the disk, where file systems can.
void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;  // it may be written and not read
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

OutputFile::OutputFile(const fs::path& path) : path_(path), target_(path) {
  std::error_code ignored;
  if (fs::is_symlink(path, ignored)) target_ = fs::weakly_canonical(path, ignored);
  if (target_.empty()) target_ = path;
  const fs::path folder = folder_of(target_);
  check_folder(path_, folder);
  check_target(path_, target_);

  int descriptor = open_nameless(folder);
  if (descriptor < 0) {
    temporary_ = make_temporary(folder, [&](const fs::path& name) {
      descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      return descriptor >= 0;
    });
  }
  if (descriptor < 0) {
    const int reason = errno;
    throw file_error(
        path_.string(),
        fmt::format("cannot write in the folder '{}': {}", folder.string(), std::strerror(reason)),
        "choose another folder");
  }
  file_.reset(::fdopen(descriptor, "wb"));
  if (!file_) {
    const int reason = errno;
    ::close(descriptor);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    fail(reason);
  }
}

OutputFile::~OutputFile() {
  file_.reset();
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::write(const void* data, std::size_t size) {
  if (std::fwrite(data, 1, size, file_.get()) != size) fail(errno);
}

std::uint64_t OutputFile::position() const {
  return static_cast<std::uint64_t>(::ftello(file_.get()));
}

void OutputFile::seek(std::uint64_t position) {
  if (::fseeko(file_.get(), static_cast<off_t>(position), SEEK_SET) != 0) fail(errno);
}

void OutputFile::commit() {
  // Without fsync a machine that loses power can keep the new name with none of the bytes.
  if (std::fflush(file_.get()) != 0 || ::fsync(::fileno(file_.get())) != 0) fail(errno);
  if (temporary_.empty()) give_name();
  if (std::fclose(file_.release()) != 0) fail(errno);
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
  sync_folder(folder_of(target_));
}

void OutputFile::give_name() {
  const std::string open_file = fmt::format("/proc/self/fd/{}", ::fileno(file_.get()));
  temporary_ = make_temporary(folder_of(target_), [&](const fs::path& name) {
    return ::linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  });
  if (temporary_.empty()) fail(errno);
}

void OutputFile::fail(int error_number) const {
  throw file_error(path_.string(),
                   fmt::format("could not be written: {}", std::strerror(error_number)),
                   error_number == ENOSPC || error_number == EDQUOT ? "free some space" : "");
}

}  // namespace lapidary::image
