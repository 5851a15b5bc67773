# Warnings, instruction set and floating-point rules in one interface target; helpers that add a library or a test.

add_library(percuss_options INTERFACE)
target_include_directories(percuss_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(percuss_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  # GCC 12 takes "text" + std::string for an overlapping copy (GCC bug 105651).
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
  $<$<BOOL:${PERCUSS_WERROR}>:-Werror>
  # Contracting a * b + c differently in two places would break "same bits"; see docs/developer.md.
  -ffp-contract=off
  # sqrt and friends need no errno; no effect on values.
  -fno-math-errno -fno-trapping-math)
if(PERCUSS_BACKEND STREQUAL "CUDA")
  target_compile_options(percuss_options INTERFACE --expt-relaxed-constexpr -fmad=false)
  # nvcc 13.0 takes no format text of fmt 9 for a constant; it is then checked when it is used.
  target_compile_definitions(percuss_options INTERFACE "FMT_CONSTEVAL=")
endif()
if(PERCUSS_NATIVE)
  target_compile_options(percuss_options INTERFACE -march=native)
  # Clang compiles the packs of AVX-512 of libstdc++ 12, but not of 14. Those of AVX2 it does.
  include(CheckCXXSourceCompiles)
  set(packs "
    #include <experimental/simd>
    using Pack = std::experimental::native_simd<double>;
    int main(int count, char**) { return any_of(Pack(count) < Pack(2)) ? 0 : 1; }")
  set(CMAKE_REQUIRED_FLAGS -march=native)
  check_cxx_source_compiles("${packs}" PERCUSS_NATIVE_PACKS_COMPILE)
  if(NOT PERCUSS_NATIVE_PACKS_COMPILE)
    set(CMAKE_REQUIRED_FLAGS "-march=native -mno-avx512f")
    check_cxx_source_compiles("${packs}" PERCUSS_AVX2_PACKS_COMPILE)
  endif()
  unset(CMAKE_REQUIRED_FLAGS)
  if(NOT PERCUSS_NATIVE_PACKS_COMPILE AND PERCUSS_AVX2_PACKS_COMPILE)
    message(STATUS "Packs of AVX-512 do not compile with this compiler and its library: AVX2 is used")
    target_compile_options(percuss_options INTERFACE -mno-avx512f)
  endif()
endif()
if(PERCUSS_SANITIZE)
  target_compile_options(percuss_options INTERFACE -fsanitize=${PERCUSS_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  if(PERCUSS_NO_SANITIZE)
    target_compile_options(percuss_options INTERFACE -fno-sanitize=${PERCUSS_NO_SANITIZE})
  endif()
  # GCC takes what the sanitizers insert for reads of unset memory, in std::regex for one (as its manual warns).
  target_compile_options(percuss_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(percuss_options INTERFACE -fsanitize=${PERCUSS_SANITIZE})
  target_sources(percuss_options INTERFACE
    $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:${PROJECT_SOURCE_DIR}/cmake/keep_plugins.cpp>)
endif()
string(TOUPPER "${PERCUSS_BACKEND}" _backend)
# Only MPI's C interface is used; its C++ one was removed from the standard and would need another library.
target_compile_definitions(percuss_options INTERFACE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
target_compile_definitions(percuss_options INTERFACE PERCUSS_BACKEND_${_backend}=1 PERCUSS_VERSION="${PROJECT_VERSION}")
if(PERCUSS_SCALAR_PACKS)
  target_compile_definitions(percuss_options INTERFACE PERCUSS_SCALAR_PACKS=1)
endif()
if(PERCUSS_CONTRACTS)
  target_compile_definitions(percuss_options INTERFACE PERCUSS_CONTRACTS=1 _GLIBCXX_ASSERTIONS=1 KOKKOS_ENABLE_DEBUG_BOUNDS_CHECK=1)
endif()
if(PERCUSS_MEMORY_APART)
  target_compile_definitions(percuss_options INTERFACE PERCUSS_MEMORY_APART=1)
endif()
if(PERCUSS_PRECISION STREQUAL "single")
  target_compile_definitions(percuss_options INTERFACE PERCUSS_PRECISION_SINGLE=1)
endif()

# percuss_precompile(name LINK lib ... HEADERS <header> ...): headers of others that nearly every file reads, compiled
# once; what calls percuss_reuse_headers(target name) takes them from there. A compiler cache does better without.
function(percuss_precompile name)
  cmake_parse_arguments(arg "" "" "LINK;HEADERS" ${ARGN})
  if(CMAKE_CXX_COMPILER_LAUNCHER OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR PERCUSS_BACKEND STREQUAL "CUDA")
    return()
  endif()
  add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/headers.cpp)
  target_link_libraries(${name} PRIVATE percuss_options Kokkos::kokkos ${arg_LINK})
  target_precompile_headers(${name} PRIVATE <Kokkos_Core.hpp> <experimental/simd> <algorithm> <cmath> <string> <vector> ${arg_HEADERS})
endfunction()
function(percuss_reuse_headers target name)
  if(TARGET ${name})
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()
percuss_precompile(percuss_headers)
percuss_precompile(percuss_text_headers LINK fmt::fmt HEADERS <fmt/format.h>)
# Of code that no step calls. GCC takes precompiled headers only with the optimisation that they were made with.
set(PERCUSS_SET_UP_OPTIONS $<$<CONFIG:Release>:-O1>)
percuss_precompile(percuss_set_up_headers LINK fmt::fmt HEADERS <fmt/format.h>)
if(TARGET percuss_set_up_headers)
  target_compile_options(percuss_set_up_headers PRIVATE ${PERCUSS_SET_UP_OPTIONS})
endif()

add_library(percuss_unity_options INTERFACE)
# A name of one source may be that of another, and bases of tests in anonymous namespaces seem to come from a header.
target_compile_options(percuss_unity_options INTERFACE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
# percuss_unite(target): PERCUSS_UNITY compiles many of its sources at once: what they include takes most of the time, and
# 126 sources of src/step are parsed in twice the time of six. Names in all sources of a target differ.
function(percuss_unite target)
  if(PERCUSS_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${PERCUSS_UNITY_BATCH})
    target_link_libraries(${target} PRIVATE percuss_unity_options) # after percuss_options, whose warning this takes back
  endif()
endfunction()

# percuss_add_library(name [UNITY] [SET_UP] SOURCES a.cpp ... LINK lib ...): a static library with the project's options.
# UNITY: names in its sources differ, so that PERCUSS_UNITY may compile several at once. SET_UP: no step calls it, so that a
# release build compiles it in two thirds of the time, with little optimisation.
function(percuss_add_library name)
  cmake_parse_arguments(arg "UNITY;SET_UP" "" "SOURCES;LINK" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  target_link_libraries(${name} PUBLIC percuss_options ${arg_LINK})
  if(arg_SET_UP)
    target_compile_options(${name} PRIVATE ${PERCUSS_SET_UP_OPTIONS})
    percuss_reuse_headers(${name} percuss_set_up_headers)
  elseif("fmt::fmt" IN_LIST arg_LINK)
    percuss_reuse_headers(${name} percuss_text_headers)
  elseif(arg_LINK) # what links nothing knows nothing of Kokkos, and is compiled without its options
    percuss_reuse_headers(${name} percuss_headers)
  endif()
  if(arg_UNITY)
    percuss_unite(${name})
  endif()
endfunction()

# Programs of tests hold 16 MB each: lld and gold take about a third of the time of the default linker.
include(CheckLinkerFlag)
set(PERCUSS_TEST_LINKER "")
foreach(linker lld gold)
  check_linker_flag(CXX -fuse-ld=${linker} PERCUSS_LINKS_WITH_${linker})
  if(PERCUSS_LINKS_WITH_${linker} AND NOT PERCUSS_TEST_LINKER)
    set(PERCUSS_TEST_LINKER -fuse-ld=${linker})
  endif()
endforeach()

set(PERCUSS_KERNEL_TESTS ${PROJECT_SOURCE_DIR}/tests/kernels)
# percuss_set_test_options(target): a release build compiles tests of kernels as code that no step calls, and other tests,
# which call libraries alone, without optimisation: they take half of the time, and bits are the same.
set(PERCUSS_TEST_OPTIONS $<$<CONFIG:Release>:-O0>)
function(percuss_set_test_options target)
  target_link_options(${target} PRIVATE ${PERCUSS_TEST_LINKER})
  cmake_path(IS_PREFIX PERCUSS_KERNEL_TESTS ${CMAKE_CURRENT_SOURCE_DIR} is_of_kernels)
  if(is_of_kernels)
    target_compile_options(${target} PRIVATE ${PERCUSS_SET_UP_OPTIONS})
    percuss_reuse_headers(${target} percuss_kernel_test_headers)
  else()
    target_compile_options(${target} PRIVATE ${PERCUSS_TEST_OPTIONS})
    percuss_reuse_headers(${target} percuss_test_headers)
  endif()
endfunction()
set(PERCUSS_FILE_TESTS "${PROJECT_SOURCE_DIR}/tests/src/(deck|hdf5|mesh|output)(/|$)")
# Everything that tests of label unit run, to be built without the rest.
add_custom_target(kernel_tests)      # those of tests/kernels (label kernels)
add_custom_target(other_unit_tests)  # all others; elsewhere: add_dependencies(other_unit_tests PROGRAM)
add_custom_target(unit_tests DEPENDS kernel_tests other_unit_tests)
add_custom_target(quick_tests)   # programs of the entries of label quick
add_custom_target(file_tests)    # those of decks, meshes and results, which read what others have written (label files)

# percuss_add_test_library(name SOURCES a.cpp ... LINK lib ...): what several tests share, compiled once.
function(percuss_add_test_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  target_link_libraries(${name} PUBLIC percuss_options ${arg_LINK} Kokkos::kokkos GTest::gtest GTest::gmock)
  percuss_set_test_options(${name})
  percuss_unite(${name})
endfunction()

# percuss_mark_quick(name...): entries and programs of the short verdict, `scripts/test` (label quick).
function(percuss_mark_quick)
  foreach(name IN LISTS ARGN)
    if(TARGET ${name})
      add_dependencies(quick_tests ${name})
    endif()
    if(TEST ${name})
      set_property(TEST ${name} APPEND PROPERTY LABELS quick)
    elseif(NOT TARGET ${name})
      message(FATAL_ERROR "percuss_mark_quick: '${name}' is neither a test nor a program")
    endif()
  endforeach()
endfunction()

# Long tests start first (ctest's COST), so that none is left alone at the end while a core idles.
set(PERCUSS_COST_slow 1000)
set(PERCUSS_COST_verification 100)
set(PERCUSS_COST_mpi 10)
set(PERCUSS_COST_unit 1)

# percuss_add_executable_of_tests(name SOURCES a_test.cpp ... LINK lib ...): a GoogleTest executable. Its arguments are
# sources whose tests alone run.
function(percuss_add_executable_of_tests name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE percuss_options ${arg_LINK} percuss_test_main)
  percuss_set_test_options(${name})
  percuss_unite(${name})
endfunction()

# percuss_add_test(name LABEL unit SOURCES a_test.cpp ... LINK lib ...): a GoogleTest executable and its ctest entry. Kernels
# run on two threads; the scenes of others are so small that waking a second one costs several times what it does.
function(percuss_add_test name)
  cmake_parse_arguments(arg "" "LABEL" "SOURCES;LINK" ${ARGN})
  percuss_add_executable_of_tests(${name} SOURCES ${arg_SOURCES} LINK ${arg_LINK})
  cmake_path(IS_PREFIX PERCUSS_KERNEL_TESTS ${CMAKE_CURRENT_SOURCE_DIR} is_of_kernels)
  set(labels ${arg_LABEL})
  if(arg_LABEL STREQUAL unit)
    if(is_of_kernels)
      add_dependencies(kernel_tests ${name})
      list(APPEND labels kernels)
    else()
      add_dependencies(other_unit_tests ${name})
    endif()
    if(CMAKE_CURRENT_SOURCE_DIR MATCHES "${PERCUSS_FILE_TESTS}")
      add_dependencies(file_tests ${name})
      list(APPEND labels files)
    endif()
  endif()
  set(threads 1)
  if(is_of_kernels OR "thread" IN_LIST PERCUSS_SANITIZE)
    set(threads 2)
  endif()
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${labels}" COST ${PERCUSS_COST_${arg_LABEL}}
    ENVIRONMENT "OMP_NUM_THREADS=${threads};OMP_PROC_BIND=false;OMP_WAIT_POLICY=passive")
endfunction()

# How tests start MPI. Ranks share cores, so none is bound, and ranks and threads that wait make way for others. They share a
# machine, so no network is looked for: Open MPI 5 complains where there is none. Open MPI wants root to insist.
set(PERCUSS_MPI_FLAGS "")
set(PERCUSS_MPI_ENVIRONMENT OMP_PROC_BIND=false OMP_WAIT_POLICY=passive)
execute_process(COMMAND ${MPIEXEC_EXECUTABLE} --version OUTPUT_VARIABLE _percuss_mpiexec ERROR_QUIET)
if(_percuss_mpiexec MATCHES "Open MPI|OpenRTE")
  list(APPEND PERCUSS_MPI_FLAGS --oversubscribe --bind-to none)
  list(APPEND PERCUSS_MPI_ENVIRONMENT OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_btl=^tcp)
  execute_process(COMMAND id -u OUTPUT_VARIABLE _percuss_user OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(_percuss_user STREQUAL "0")
    list(APPEND PERCUSS_MPI_ENVIRONMENT OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1)
  endif()
endif()

# percuss_add_mpi_test(name RANKS 1 2 3 SOURCES a_test.cpp ... LINK lib ...): a GoogleTest executable that runs under
# mpirun, with one ctest entry for each number of ranks, label mpi; more than three, which wait most of their time on a
# small machine, also slow. Up to two ranks run two threads each.
function(percuss_add_mpi_test name)
  cmake_parse_arguments(arg "" "" "RANKS;SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE percuss_options ${arg_LINK} percuss_mpi_test_main)
  percuss_set_test_options(${name})
  percuss_unite(${name})
  foreach(ranks IN LISTS arg_RANKS)
    set(threads 1)
    set(labels mpi)
    if(ranks LESS_EQUAL 2)
      set(threads 2)
    elseif(ranks GREATER 3)
      list(APPEND labels slow)
    endif()
    add_test(NAME ${name}_on_${ranks}_ranks COMMAND
      ${MPIEXEC_EXECUTABLE} ${PERCUSS_MPI_FLAGS} ${MPIEXEC_NUMPROC_FLAG} ${ranks} ${MPIEXEC_PREFLAGS} $<TARGET_FILE:${name}>)
    set_tests_properties(${name}_on_${ranks}_ranks PROPERTIES LABELS "${labels}" COST ${PERCUSS_COST_mpi} TIMEOUT 120 PROCESSORS ${ranks}
      ENVIRONMENT "${PERCUSS_MPI_ENVIRONMENT};OMP_NUM_THREADS=${threads}")
  endforeach()
endfunction()
