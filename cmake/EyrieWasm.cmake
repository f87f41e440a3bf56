# SPDX-License-Identifier: MIT
# The libraries of the WebAssembly module, as tools/wasm-root lays them out, under the names that packages of the
# system have elsewhere; and what of Eyrie is left out there: files, threads and plug-ins.
enable_language(C)
set(wasm_root ${CMAKE_SOURCE_DIR}/build/wasm-root)
if(NOT EXISTS ${wasm_root}/src/.unpacked)
  message(FATAL_ERROR "run tools/wasm-root first: it lays out the libraries of the WebAssembly module")
endif()
add_library(wasm_headers INTERFACE)
target_include_directories(wasm_headers SYSTEM INTERFACE ${wasm_root}/include)
add_library(fmt_headers INTERFACE)
target_compile_definitions(fmt_headers INTERFACE FMT_HEADER_ONLY=1
                           "FMT_STATIC_THOUSANDS_SEPARATOR=','")  # no locales
target_link_libraries(fmt_headers INTERFACE wasm_headers)
add_library(fmt::fmt ALIAS fmt_headers)
add_library(Threads::Threads ALIAS wasm_headers)
add_library(nlohmann_json::nlohmann_json ALIAS wasm_headers)
add_library(ZLIB::ZLIB ALIAS wasm_headers)

file(GLOB yaml_sources ${wasm_root}/src/libyaml/src/*.c)
list(FILTER yaml_sources EXCLUDE REGEX "dumper|emitter|writer")
add_library(wasm_yaml STATIC ${yaml_sources})
target_include_directories(wasm_yaml SYSTEM PUBLIC ${wasm_root}/src/libyaml/include)
target_compile_definitions(wasm_yaml PRIVATE YAML_VERSION_MAJOR=0 YAML_VERSION_MINOR=2 YAML_VERSION_PATCH=5
                                             YAML_VERSION_STRING="0.2.5")
set(YAML_LIBRARY wasm_yaml)

set(geographic ${wasm_root}/src/geographiclib)
foreach(part AzimuthalEquidistant Geocentric Geodesic GeodesicLine Math)
  list(APPEND geographic_sources ${geographic}/src/${part}.cpp)
endforeach()
add_library(wasm_geographic STATIC ${geographic_sources})
file(WRITE ${CMAKE_BINARY_DIR}/geographic/GeographicLib/Config.h
     "#define GEOGRAPHICLIB_VERSION_STRING \"2.1.2\"\n#define GEOGRAPHICLIB_VERSION_MAJOR 2\n"
     "#define GEOGRAPHICLIB_VERSION_MINOR 1\n#define GEOGRAPHICLIB_VERSION_PATCH 2\n#define GEOGRAPHICLIB_DATA \"\"\n"
     "#define GEOGRAPHICLIB_HAVE_LONG_DOUBLE 0\n#define GEOGRAPHICLIB_WORDS_BIGENDIAN 0\n#define GEOGRAPHICLIB_PRECISION 2\n"
     "#define GEOGRAPHICLIB_SHARED_LIB 0\n")
target_include_directories(wasm_geographic SYSTEM BEFORE PUBLIC ${CMAKE_BINARY_DIR}/geographic ${geographic}/include)
set(GeographicLib_LIBRARIES wasm_geographic)
set_target_properties(wasm_yaml wasm_geographic PROPERTIES UNITY_BUILD OFF)
target_compile_options(wasm_yaml PRIVATE -w)  # others' sources are not held to what Eyrie's are
target_compile_options(wasm_geographic PRIVATE -w)

set(RANDOM123_INCLUDE_DIR ${wasm_root}/include)
set(XXHASH_INCLUDE_DIR ${wasm_root}/include)

# what is left out: web/platform.cpp stands for what of it is called
set(EYRIE_LEFT_OUT "/src/(core/executor|disk/.*|model/flight/performance|scenario/(end_guard|plugin_load|shared_object|source_disk|trust)|debrief/(health|open)|page/page)\\.cpp$")

# every step is hashed: this one file is compiled for speed, as its loops are not unrolled for size
set_source_files_properties(${CMAKE_SOURCE_DIR}/src/core/hash.cpp PROPERTIES
                            SKIP_UNITY_BUILD_INCLUSION ON COMPILE_OPTIONS -O3)
