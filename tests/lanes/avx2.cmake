# SPDX-License-Identifier: MIT
# usage: cmake -DNM=nm "-DOBJECTS=a.o;abreast_avx2.cpp.o" -P avx2.cmake
# What is compiled for AVX2 must not give the linker a copy of a function that the rest of the program has too: a processor
# without AVX2 would stop there. Only templates of lanes and what the file is for may be in it; constants may.
list(FILTER OBJECTS INCLUDE REGEX "_avx2")
execute_process(COMMAND ${NM} -C --defined-only ${OBJECTS} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" symbols "${symbols}")
set(ours FALSE)
foreach(symbol ${symbols})
  if(symbol MATCHES " [TW] ")
    if(symbol MATCHES "flight::fly_in_lanes")
      set(ours TRUE)
    elseif(NOT symbol MATCHES "(fly_abreast|Equations)<eyrie::math::Lanes<|Lanes<4ul>|math::(sin_cos|atan2)<2ul>")
      message(FATAL_ERROR "the linker may take this for all of the program: ${symbol}")
    endif()
  endif()
endforeach()
if(NOT ours)
  message(FATAL_ERROR "${OBJECTS} has no fly_in_lanes")
endif()
