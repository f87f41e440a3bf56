# SPDX-License-Identifier: MIT
# WebAssembly with Debian's clang (docs/adr/ says why it and not Emscripten). tools/wasm-root lays out what
# the module needs of libraries: the headers of /usr/include are those of another system.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
foreach(language C CXX)
  set(CMAKE_${language}_COMPILER_TARGET wasm32-wasi)
endforeach()
set(CMAKE_C_COMPILER clang-19)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_AR llvm-ar-19)
set(CMAKE_RANLIB llvm-ranlib-19)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_EXECUTABLE_SUFFIX .wasm)
set(CMAKE_C_FLAGS_INIT "-mbulk-memory -fwasm-exceptions")
set(CMAKE_CXX_FLAGS_INIT "-mbulk-memory -fwasm-exceptions -D_LIBCPP_HARDENING_MODE=_LIBCPP_HARDENING_MODE_NONE")
set(EYRIE_WASM ON)
