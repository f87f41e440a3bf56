# SPDX-License-Identifier: MIT
# cmake -D SOURCE=DIR -D LAYERS=a,b -D OUT=FILE -P: a header with a fingerprint of the text of all headers of these layers,
# written anew only if it is another.
string(REPLACE "," ";" LAYERS "${LAYERS}")
set(texts "")
foreach(layer ${LAYERS})
  file(GLOB_RECURSE headers LIST_DIRECTORIES false RELATIVE ${SOURCE} ${SOURCE}/${layer}/*.hpp)
  list(FILTER headers EXCLUDE REGEX "_test\\.hpp$")  # not installed
  list(SORT headers)
  foreach(header ${headers})
    file(SHA256 ${SOURCE}/${header} hash)
    string(APPEND texts "${header} ${hash}\n")
  endforeach()
endforeach()
string(SHA256 hash "${texts}")
string(SUBSTRING ${hash} 0 16 hash)
file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT [[// Made by cmake/header_print.cmake.
#pragma once
#include <cstdint>

namespace eyrie::scenario {
inline constexpr std::uint64_t kHeaderPrint = 0x@hash@;  ///< of the text of all that a plug-in includes
}  // namespace eyrie::scenario
]])
