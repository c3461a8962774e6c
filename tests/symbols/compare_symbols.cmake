# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
#
# Compares what LIBRARY exports with the names in api/functions.inc, egl/entry_points.inc and gl/functions.inc under
# SOURCES. NM: the program nm.
execute_process(COMMAND ${NM} -D --defined-only ${LIBRARY} OUTPUT_VARIABLE output RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${NM} cannot read ${LIBRARY}")
endif()
string(REGEX MATCHALL "[^ \n]+\n" exported "${output}")
list(TRANSFORM exported STRIP)
list(TRANSFORM exported REPLACE "@.*" "")

set(expected "")
file(STRINGS ${SOURCES}/egl/entry_points.inc lines REGEX "^RC_ENTRY")
list(TRANSFORM lines REPLACE "^RC_ENTRY.([A-Za-z0-9_]+).*" "\\1")
list(APPEND expected ${lines})
foreach(layer api gl)
  file(STRINGS ${SOURCES}/${layer}/functions.inc text)
  string(REGEX MATCHALL "_FUNCTION[(][^,;]+, ((rc|gl)[A-Za-z0-9_]+)," rows "${text}")
  list(TRANSFORM rows REPLACE ".*, ((rc|gl)[A-Za-z0-9_]+),$" "\\1")
  list(APPEND expected ${rows})
endforeach()

set(missing ${expected})
set(surplus ${exported})
list(REMOVE_ITEM missing ${exported})
list(REMOVE_ITEM surplus ${expected})
list(LENGTH expected count)
if(count LESS 300 OR missing OR surplus)
  message(FATAL_ERROR "${count} names expected; missing: ${missing}; surplus: ${surplus}")
endif()
message(STATUS "${count} symbols, as they should be")
