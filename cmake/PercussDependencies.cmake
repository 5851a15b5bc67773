# Everything percuss links, found once. scripts/install_dependencies installs all of it on Debian 12 and 13.

# The Kokkos that scripts/install_dependencies built is only a hint: CMAKE_PREFIX_PATH and Kokkos_ROOT win.
set(_percuss_kind "")
if("thread" IN_LIST PERCUSS_SANITIZE) # sees what it compiled only
  set(_percuss_kind --races)
endif()
execute_process(COMMAND ${PROJECT_SOURCE_DIR}/scripts/install_dependencies --print-prefix ${_percuss_kind}
  OUTPUT_VARIABLE _percuss_kokkos OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
# No version is asked for here: Kokkos' own version file would refuse every other major version.
find_package(Kokkos QUIET HINTS "${_percuss_kokkos}")
if(NOT Kokkos_FOUND OR Kokkos_VERSION VERSION_LESS 3.4.1)
  message(FATAL_ERROR "no Kokkos 3.4.1 or newer (found '${Kokkos_VERSION}' in '${Kokkos_DIR}', after CMAKE_PREFIX_PATH and "
    "'${_percuss_kokkos}'). Run scripts/install_dependencies, or name one with -DCMAKE_PREFIX_PATH=...")
endif()
string(TOUPPER "${PERCUSS_BACKEND}" _percuss_backend_upper)
if(NOT _percuss_backend_upper IN_LIST Kokkos_DEVICES)
  message(FATAL_ERROR
    "PERCUSS_BACKEND is ${PERCUSS_BACKEND}, which this Kokkos (${Kokkos_DIR}) was not built for (it has ${Kokkos_DEVICES}). "
    "Choose another back end or run scripts/install_dependencies.")
endif()
# Kokkos Kernels comes from where that Kokkos is: those of another version would not compile with it. In an installed
# Trilinos it tells no version, and belongs to the Kokkos beside it.
find_package(KokkosKernels QUIET HINTS "${Kokkos_DIR}/../../.." "${_percuss_kokkos}")
string(REGEX MATCH "^[0-9]+\\.[0-9]+" _percuss_kokkos_minor "${Kokkos_VERSION}")
string(REGEX MATCH "^[0-9]+\\.[0-9]+" _percuss_kernels_minor "${KokkosKernels_VERSION}")
if(NOT KokkosKernels_FOUND OR (KokkosKernels_VERSION AND NOT _percuss_kokkos_minor VERSION_EQUAL _percuss_kernels_minor))
  message(FATAL_ERROR "no Kokkos Kernels ${_percuss_kokkos_minor} beside Kokkos ${Kokkos_VERSION} in '${Kokkos_DIR}' (found "
    "'${KokkosKernels_VERSION}' in '${KokkosKernels_DIR}'). Install it there, or name it with -DKokkosKernels_DIR=...")
endif()
if(NOT TARGET Kokkos::kokkoskernels) # Trilinos' name of it
  add_library(Kokkos::kokkoskernels ALIAS KokkosKernels::all_libs)
endif()
find_package(MPI REQUIRED COMPONENTS CXX C)
set(HDF5_PREFER_PARALLEL ON)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(ZLIB REQUIRED)
find_package(yaml-cpp REQUIRED)
if(NOT TARGET yaml-cpp::yaml-cpp) # before yaml-cpp 0.8
  add_library(yaml-cpp::yaml-cpp ALIAS yaml-cpp)
endif()
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(muparser REQUIRED IMPORTED_TARGET muparser)

find_library(EXODUS_LIBRARY NAMES exodusII exodus exoIIv2c REQUIRED)
find_path(EXODUS_INCLUDE_DIR exodusII.h REQUIRED)
add_library(percuss_exodus INTERFACE)
# Some of netCDF is called by itself, of the very library that Exodus brings: another one would bring another HDF5.
execute_process(COMMAND ${CMAKE_READELF} -d ${EXODUS_LIBRARY} OUTPUT_VARIABLE _percuss_needed ERROR_QUIET)
if(_percuss_needed MATCHES "\\[(libnetcdf[^]]*)\\]")
  find_library(NETCDF_LIBRARY NAMES ${CMAKE_MATCH_1} REQUIRED)
else()
  find_library(NETCDF_LIBRARY NAMES netcdf REQUIRED)
endif()
find_path(NETCDF_INCLUDE_DIR netcdf.h REQUIRED)
target_link_libraries(percuss_exodus INTERFACE ${EXODUS_LIBRARY} ${NETCDF_LIBRARY})
target_include_directories(percuss_exodus SYSTEM INTERFACE ${EXODUS_INCLUDE_DIR} ${NETCDF_INCLUDE_DIR})

find_library(METIS_LIBRARY NAMES metis REQUIRED)
find_path(METIS_INCLUDE_DIR metis.h REQUIRED)
add_library(percuss_metis INTERFACE)
target_link_libraries(percuss_metis INTERFACE ${METIS_LIBRARY})
target_include_directories(percuss_metis SYSTEM INTERFACE ${METIS_INCLUDE_DIR})
