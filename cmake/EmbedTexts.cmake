# vs_embed_texts(TARGET NAMESPACE HEADER FUNCTION PATTERN): compiles the files that match PATTERN (below the project's folder) into
# TARGET as a table of texts by file name (without extension), which FUNCTION gives; HEADER declares it in NAMESPACE. Run as a script
# (-P) it writes that table; see the end of the file.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(VS_EMBED_TEXTS_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
  function(vs_embed_texts TARGET NAMESPACE HEADER FUNCTION PATTERN)
    file(GLOB TEXTS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${PATTERN})
    set(TABLE ${PROJECT_BINARY_DIR}/generated/${FUNCTION}.cpp)
    add_custom_command(OUTPUT ${TABLE}
      COMMAND ${CMAKE_COMMAND} "-DPATTERN=${PROJECT_SOURCE_DIR}/${PATTERN}" "-DOUTPUT=${TABLE}" "-DHEADER=${HEADER}"
        "-DFUNCTION=${FUNCTION}" "-DNAMESPACE=${NAMESPACE}" -P ${VS_EMBED_TEXTS_SCRIPT}
      DEPENDS ${TEXTS} ${VS_EMBED_TEXTS_SCRIPT} VERBATIM COMMENT "Embedding ${PATTERN}")
    set_source_files_properties(${TABLE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON) # it is made, and often
    target_sources(${TARGET} PRIVATE ${TABLE})
  endfunction()
  return()
endif()

file(GLOB TEXTS ${PATTERN})
list(SORT TEXTS)
set(TABLE "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\nnamespace {\nconst EmbeddedText kTable[] = {\n")
foreach(TEXT IN LISTS TEXTS)
  file(READ ${TEXT} SOURCE)
  get_filename_component(NAME ${TEXT} NAME_WE)
  string(APPEND TABLE "    {\"${NAME}\", R\"~~~(${SOURCE})~~~\"},\n")
endforeach()
string(APPEND TABLE "};\n} // namespace\nstd::span<const EmbeddedText> ${FUNCTION}() { return kTable; }\n} // namespace ${NAMESPACE}\n")
file(WRITE ${OUTPUT} "${TABLE}")
