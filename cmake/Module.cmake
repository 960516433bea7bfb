# vs_module(NAME SOURCES ... PUBLIC ... PRIVATE ...)
# One folder of src/ = one static library = one namespace. PUBLIC and PRIVATE are link libraries.
function(vs_module NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(vs_${NAME} STATIC ${ARG_SOURCES})
  add_library(vs::${NAME} ALIAS vs_${NAME})
  target_include_directories(vs_${NAME} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(vs_${NAME} PUBLIC ${ARG_PUBLIC} PRIVATE vs_warnings ${ARG_PRIVATE})
endfunction()
