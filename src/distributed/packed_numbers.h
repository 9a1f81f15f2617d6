#pragma once

#include <cstdint>
#include <span>

#include "distributed/byte_stream.h"

namespace lapidary::distributed {

/// Writes the rows of a table in as many bytes as its numbers need, without loss: of each column
/// the differences from row to row, in groups of 64 with one width each. Numbers that are all the
/// same take hardly any room, noise takes what it has. Precondition: the rows are whole.
void pack(std::span<const std::int64_t> table, std::size_t columns, ByteWriter& to);
void pack(std::span<const std::uint32_t> table, std::size_t columns, ByteWriter& to);

/// Fills a table of the same size. Throws Error for bytes that `pack` does not write.
void unpack(std::span<std::int64_t> table, std::size_t columns, ByteReader& from);
void unpack(std::span<std::uint32_t> table, std::size_t columns, ByteReader& from);

}  // namespace lapidary::distributed
