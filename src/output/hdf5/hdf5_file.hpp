#pragma once
// HDF5 files whose finished parts survive a crash and a failed write, and how such a file is given up.

#include <string>

#include "comm/communicator.hpp"
#include "src/hdf5/hdf5_handle.hpp"

namespace percuss::hdf5 {

/// How the links of a file are kept: netCDF reads them in the order in which they were made.
enum class LinkOrder { by_name, by_creation };

/// Half the entries of a node of the index of chunks. Large nodes split seldom, small ones take little room.
inline constexpr unsigned most_chunk_index = 256;

/// Creates a file in place of an older one. Data go to the system when they are written, metadata when the file is
/// flushed, both without a lock, so that others may read meanwhile. What was flushed is readable whenever the process
/// ends, unless it ends within a flush that splits a node of a chunk index, which happens to every 2 k th chunk of a
/// dataset, k: chunk_index. Several ranks write the file together through MPI-IO; its metadata are rank 0's to write,
/// in the order in which one rank alone writes them. Collective. Throws Error, and SystemError on all ranks if the file
/// cannot be made.
Handle create_durable_file(const std::string& path, const Communicator& ranks, LinkOrder links = LinkOrder::by_name,
                           unsigned chunk_index = most_chunk_index);

/// Opens such a file again to continue with it. Collective. Throws Error.
Handle open_durable_file(const std::string& path, const Communicator& ranks);

/// Reports a failure while other ranks may wait in HDF5, and ends them all. Where several have failed, the lowest
/// reports it; the others wait for it.
[[noreturn]] void end_all_ranks(const Communicator& ranks, const std::string& message);

/// How several ranks write data: all of them at once.
Handle create_collective_transfer();

/// Discards what HDF5 writes to a file from now on, before the file is given up. After a failed write it must not reach
/// the disk: it would refer to data that are not there. What is open within the file is closed after this, but not the
/// file itself (Handle::release()): HDF5 1.10 cannot close one that it could not flush. Collective.
void turn_away(const Handle& file, const Communicator& ranks);

}  // namespace percuss::hdf5
