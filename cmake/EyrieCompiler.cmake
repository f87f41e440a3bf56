# SPDX-License-Identifier: MIT
# How every target is compiled. The floating-point flags are part of the determinism contract:
# no contraction, no fast-math, no -march beyond the x86-64 baseline, and no folding of libm calls
# at compile time (the compiler folds with MPFR, whose last bit differs from the run-time library).
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT EYRIE_WASM)
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
endif()

add_library(eyrie_options INTERFACE)
target_include_directories(eyrie_options INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                                   $<INSTALL_INTERFACE:include/eyrie>)
# headers are compiled by whoever includes them: the contract goes with them
target_compile_features(eyrie_options INTERFACE cxx_std_20)
target_compile_options(eyrie_options INTERFACE -ffp-contract=off -fno-fast-math)
foreach(function sin cos tan asin acos atan atan2 sinh cosh tanh exp exp2 log log2 log10 pow cbrt)
  target_compile_options(eyrie_options INTERFACE -fno-builtin-${function})
endforeach()

# what only Eyrie itself is held to; what it says of a file does not depend on where it was built, so that checkouts share
# the compiler cache and builds are the same. Nobody asks for the errno of a root.
set(own_options -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/= -fno-math-errno -Wall -Wextra -Wpedantic -Wshadow -Wno-missing-field-initializers -Wconversion -Wno-sign-conversion)
if(EYRIE_WERROR)
  list(APPEND own_options -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # false positives of GCC 12 in std::string and std::vector at -O2 and above, and of several
  # sources compiled as one; ccache needs to see the macros of a precompiled header
  list(APPEND own_options -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds -Wno-maybe-uninitialized
                          -Wno-subobject-linkage -fpch-preprocess)
  # code for a shared library, which the Python module is, in which nobody replaces a function: what a file defines may be
  # inlined in it
  list(APPEND own_options -fno-semantic-interposition)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    # rows are cleared and copied by vectors: `rep stos`, which GCC takes else, needs dozens of cycles to begin
    foreach(of memset memcpy)
      list(APPEND own_options -m${of}-strategy=vector_loop:1024:noalign,libcall:-1:noalign)
    endforeach()
  endif()
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  # std::stable_sort of libstdc++ 12 warns of itself
  list(APPEND own_options -Wno-deprecated-declarations)
endif()
if(EYRIE_SANITIZE)
  list(APPEND own_options -fsanitize=${EYRIE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(eyrie_options INTERFACE $<BUILD_INTERFACE:-fsanitize=${EYRIE_SANITIZE}>)
  target_compile_definitions(eyrie_options INTERFACE $<BUILD_INTERFACE:EYRIE_SANITIZED=1>)
endif()
add_compile_options(${own_options})  # of this folder and those below: not of who adds Eyrie to his project

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # precompiled headers: GCC keeps their macros, and their time stamps say nothing
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE_PROGRAM})
endif()

# a file that is compiled for some processors and called where there is one (src/model/flight/abreast.hpp); the bits are the same
function(eyrie_lanes source)
  set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "${ARGN}")
  endif()
endfunction()
