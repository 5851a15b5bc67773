#include "src/app/process/version.hpp"

#include <H5public.h>
#include <fmt/format.h>
#include <mpi.h>

#include <Kokkos_Core.hpp>
#include <array>

#include <percuss_commit.hpp>
#include "kernels/core/precision.hpp"
#include "kernels/core/views.hpp"

namespace percuss {
namespace {

/// "Open MPI v4.1.4", without what the library says of its own build.
std::string name_mpi() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int length = 0;
  MPI_Get_library_version(text.data(), &length);  // may be called before MPI_Init
  const std::string all(text.data());
  return all.substr(0, all.find_first_of(",\n"));
}

}  // namespace

std::string describe_version() {
  std::string text =
      fmt::format("percuss {} (Kokkos {}.{}.{}, {} back end, {} precision)\n", PERCUSS_VERSION, KOKKOS_VERSION / 10000,
                  KOKKOS_VERSION / 100 % 100, KOKKOS_VERSION % 100, ExecSpace::name(), precision_name);
  if (*PERCUSS_COMMIT != '\0') text += fmt::format("commit    {}\n", PERCUSS_COMMIT);
  text += fmt::format("built     {}\n", PERCUSS_BUILD);
  return text + fmt::format("libraries {}, HDF5 {}.{}.{}\n", name_mpi(), H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE);
}

}  // namespace percuss
