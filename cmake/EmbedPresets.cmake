# vs_embed_presets(TARGET): compiles data/transfer_functions/*.json into TARGET as one table of texts, found at run time by
# file name. Run as a script (-P) it writes that table; see the end of the file.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(VS_EMBED_PRESETS_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
  function(vs_embed_presets TARGET)
    file(GLOB PRESETS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/data/transfer_functions/*.json)
    set(TABLE ${PROJECT_BINARY_DIR}/generated/embedded_presets.cpp)
    add_custom_command(OUTPUT ${TABLE}
      COMMAND ${CMAKE_COMMAND} "-DROOT=${PROJECT_SOURCE_DIR}/data/transfer_functions" "-DOUTPUT=${TABLE}"
        -P ${VS_EMBED_PRESETS_SCRIPT}
      DEPENDS ${PRESETS} ${VS_EMBED_PRESETS_SCRIPT} VERBATIM COMMENT "Embedding transfer functions")
    set_source_files_properties(${TABLE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON) # it is made, and often
    target_sources(${TARGET} PRIVATE ${TABLE})
  endfunction()
  return()
endif()

file(GLOB PRESETS RELATIVE ${ROOT} ${ROOT}/*.json)
list(SORT PRESETS)
set(TEXT "#include \"render/colours/embedded_presets.h\"\n\nnamespace vs::render {\nnamespace {\nconst EmbeddedPreset kTable[] = {\n")
foreach(PRESET IN LISTS PRESETS)
  file(READ ${ROOT}/${PRESET} SOURCE)
  get_filename_component(NAME ${PRESET} NAME_WE)
  string(APPEND TEXT "    {\"${NAME}\", R\"~~~(${SOURCE})~~~\"},\n")
endforeach()
string(APPEND TEXT "};\n} // namespace\nstd::span<const EmbeddedPreset> embeddedPresets() { return kTable; }\n} // namespace vs::render\n")
file(WRITE ${OUTPUT} "${TEXT}")
