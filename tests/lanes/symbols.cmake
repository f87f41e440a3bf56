# SPDX-License-Identifier: MIT
# usage: cmake -DNM=nm "-DOBJECTS=a.o;abreast_avx2.cpp.o" -P symbols.cmake
# What is compiled for AVX2 or AVX-512 must not give the linker a copy of a function that the rest of the program has too: a
# processor without it would stop there. Only templates of lanes and what the file is for may be in it; constants may.
list(FILTER OBJECTS INCLUDE REGEX "_avx")
execute_process(COMMAND ${NM} -C --defined-only ${OBJECTS} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" symbols "${symbols}")
set(ours 0)
foreach(symbol ${symbols})
  if(symbol MATCHES " [TW] ")
    if(symbol MATCHES "flight::fly_by_avx(2|512)")
      math(EXPR ours "${ours} + 1")
    elseif(NOT symbol MATCHES "(fly_abreast|fly_full|Equations)<eyrie::math::Lanes<|Lanes<[48]ul>|math::(sin_cos|atan2)<2ul>")
      message(FATAL_ERROR "the linker may take this for all of the program: ${symbol}")
    endif()
  endif()
endforeach()
if(NOT ours EQUAL 2)
  message(FATAL_ERROR "${OBJECTS} should have fly_by_avx2 and fly_by_avx512")
endif()
