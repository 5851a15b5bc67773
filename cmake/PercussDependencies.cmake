# Everything percuss links, found once. scripts/install_dependencies installs all of it on Debian 12.

# The Kokkos that scripts/install_dependencies built is the last resort: CMAKE_PREFIX_PATH and Kokkos_ROOT win.
if(DEFINED ENV{PERCUSS_CACHE})
  set(_percuss_cache "$ENV{PERCUSS_CACHE}")
elseif(DEFINED ENV{XDG_CACHE_HOME})
  set(_percuss_cache "$ENV{XDG_CACHE_HOME}/percuss")
else()
  set(_percuss_cache "$ENV{HOME}/.cache/percuss")
endif()
list(APPEND CMAKE_PREFIX_PATH "${_percuss_cache}/kokkos")

find_package(Kokkos 3.4.1 REQUIRED)
string(TOUPPER "${PERCUSS_BACKEND}" _percuss_backend_upper)
if(NOT _percuss_backend_upper IN_LIST Kokkos_DEVICES)
  message(FATAL_ERROR
    "PERCUSS_BACKEND is ${PERCUSS_BACKEND}, which this Kokkos (${Kokkos_DIR}) was not built for (it has ${Kokkos_DEVICES}). "
    "Choose another back end or run scripts/install_dependencies.")
endif()
find_package(KokkosKernels REQUIRED)
find_package(MPI REQUIRED COMPONENTS CXX C)
set(HDF5_PREFER_PARALLEL ON)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(yaml-cpp REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(muparser REQUIRED IMPORTED_TARGET muparser)

find_library(EXODUS_LIBRARY NAMES exodusII exodus REQUIRED)
find_path(EXODUS_INCLUDE_DIR exodusII.h REQUIRED)
add_library(percuss_exodus INTERFACE)
target_link_libraries(percuss_exodus INTERFACE ${EXODUS_LIBRARY})
target_include_directories(percuss_exodus SYSTEM INTERFACE ${EXODUS_INCLUDE_DIR})
