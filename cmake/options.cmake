# How everything is compiled: one floating-point model, one instruction set, strict warnings.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}")

option(LAPIDARY_WERROR "Treat warnings as errors" OFF)
set(LAPIDARY_SANITIZE "" CACHE STRING "Sanitizers, as -fsanitize takes them")
set(LAPIDARY_THREADS "tbb" CACHE STRING "Backend of parallel loops: tbb | std")
set_property(CACHE LAPIDARY_THREADS PROPERTY STRINGS tbb std)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

add_library(lapidary_flags INTERFACE)
# A fixed answer (docs/architecture.md, decision 4): every x86-64-v3 machine computes the same
# bits, so no contraction behind our back and never -ffast-math. The three relaxations below
# change no result: nobody reads errno or the exception flags.
target_compile_options(lapidary_flags INTERFACE
  -march=x86-64-v3 -ffp-contract=off -fno-math-errno -fno-trapping-math
  -Wall -Wextra -Wno-missing-field-initializers -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
  # GCC 12 warns of impossible overlaps in std::string (its bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi> $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${LAPIDARY_WERROR}>:-Werror>)
target_compile_definitions(lapidary_flags INTERFACE LAPIDARY_VERSION="${PROJECT_VERSION}")

if(LAPIDARY_SANITIZE)
  # Optimised a little, or the suite takes too long to be run; still one frame per function. Lines
  # are all that a report needs of debug information, and a third of the time of a build is spent
  # on the rest.
  # GCC documents that under sanitizers it sees uninitialised variables where there are none.
  target_compile_options(lapidary_flags INTERFACE
    -O1 -g1 -fsanitize=${LAPIDARY_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(lapidary_flags INTERFACE -fsanitize=${LAPIDARY_SANITIZE})
endif()
